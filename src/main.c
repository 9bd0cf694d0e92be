#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/status.h"
#include "cli/cli.h"
#include "tui/tui.h"

/* Whether no option says anything of a scene. */
static bool only_looks(const struct thud_args *args)
{
    int looks = thud_args_has(args, "o") + thud_args_has(args, "ascii") + thud_args_has(args, "no-color");
    return args->ngiven <= looks;
}

static enum thud_status screen(const struct thud_args *args, const struct thud_session *session, struct thud_error *err)
{
    const char *no_color = getenv("NO_COLOR"), *gnuplot = getenv("THUD_GNUPLOT");
    struct thud_tui_options options = {.preset = session->preset_path,
                                       .fresh = args->noperands == 0 && only_looks(args),
                                       .scene = &session->scene,
                                       .paths = &session->paths,
                                       .output = thud_args_value(args, "o"),
                                       .play = thud_args_value(args, "play"),
                                       .gnuplot = gnuplot && *gnuplot ? gnuplot : NULL,
                                       .ascii = thud_args_has(args, "ascii"),
                                       .color = !thud_args_has(args, "no-color") && !(no_color && no_color[0])};
    return thud_tui_main(&options, err);
}

/* A standard descriptor that is closed would go to the next file that is opened, and what is printed into that file.
 * Standard output and error are opened for reading alone, so that writing to them is the error that it was. */
static void fill_descriptors(void)
{
    for (int fd = 0; fd <= 2; fd++)
        if (fcntl(fd, F_GETFD) < 0 && errno == EBADF && open("/dev/null", O_RDONLY) != fd)
            _exit(THUD_OUTPUT); /* nothing can be said, and nothing is to be written */
}

int main(int argc, char **argv)
{
    fill_descriptors();
    return thud_cli_main(argc, argv, screen);
}
