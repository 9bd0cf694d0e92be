#include <stdlib.h>

#include "cli/cli.h"
#include "tui/tui.h"

static enum thud_status screen(const struct thud_args *args, const struct thud_session *session, struct thud_error *err)
{
    const char *no_color = getenv("NO_COLOR"), *gnuplot = getenv("THUD_GNUPLOT");
    struct thud_tui_options options = {.preset = session->preset_path,
                                       .scene = &session->scene,
                                       .paths = &session->paths,
                                       .output = thud_args_value(args, "o"),
                                       .gnuplot = gnuplot && *gnuplot ? gnuplot : NULL,
                                       .ascii = thud_args_has(args, "ascii"),
                                       .color = !thud_args_has(args, "no-color") && !(no_color && no_color[0])};
    return thud_tui_main(&options, err);
}

int main(int argc, char **argv)
{
    return thud_cli_main(argc, argv, screen);
}
