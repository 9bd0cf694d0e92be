#include <stdlib.h>

#include "cli/cli.h"
#include "tui/tui.h"

static enum thud_status screen(const struct thud_args *args, struct thud_error *err)
{
    struct thud_paths paths;
    const char *no_color = getenv("NO_COLOR");
    if (args->noperands > 1)
        return thud_error_set(err, THUD_USAGE, "the terminal interface opens one preset");
    thud_paths_find(&paths);
    struct thud_tui_options options = {.preset = args->noperands > 0 ? args->operand[0] : NULL,
                                       .paths = &paths,
                                       .output = thud_args_value(args, "o"),
                                       .ascii = thud_args_has(args, "ascii"),
                                       .color = !thud_args_has(args, "no-color") && !(no_color && no_color[0])};
    return thud_tui_main(&options, err);
}

int main(int argc, char **argv)
{
    return thud_cli_main(argc, argv, screen);
}
