#include <stddef.h>

#include "cli/cli.h"

/* The terminal interface is not there yet. */
static enum thud_status screen(const struct thud_args *args, struct thud_error *err)
{
    (void)args;
    return thud_error_set(err, THUD_USAGE, "the terminal interface is not there yet; see `thud help`");
}

int main(int argc, char **argv)
{
    return thud_cli_main(argc, argv, screen);
}
