#include "tui/document/state.h"

#define THUD_SCREEN(name, object) extern const struct thud_view thud_view_##object;
#include "tui/loop/screen_list.h"
#undef THUD_SCREEN

const struct thud_view *thud_view_of(enum thud_screen screen)
{
    static const struct thud_view *const view[] = {
#define THUD_SCREEN(name, object) [THUD_SCREEN_##name] = &thud_view_##object,
#include "tui/loop/screen_list.h"
#undef THUD_SCREEN
    };
    return view[screen];
}
