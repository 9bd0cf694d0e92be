#include "tui/loop/loop.h"

#define THUD_SCREEN(name, object) extern const struct thud_view thud_view_##object;
#include "tui/document/screen_list.h"
#undef THUD_SCREEN

const struct thud_view *const thud_views[THUD_SCREENS] = {
#define THUD_SCREEN(name, object) [THUD_SCREEN_##name] = &thud_view_##object,
#include "tui/document/screen_list.h"
#undef THUD_SCREEN
};
