#include "plot/figures/figures_case.h"

int thud_case_color(enum thud_case which)
{
    static const int color[] = {
        [THUD_CASE_NONE] = 0, [THUD_CASE_BUMPER] = 1, [THUD_CASE_CAVITY] = 2, [THUD_CASE_LINK] = 5};
    return which == THUD_CASE_FREE ? THUD_COLOR_GREY : which == THUD_CASE_AS_WRITTEN ? 3 : color[which];
}
