/* The command line. */
#pragma once

#include "app/run/session.h"
#include "cli/args.h"

/* What `thud [PRESET]` opens; the caller's, because the command line knows no terminal interface. The session holds
 * the preset and the scene that the options made of it. */
typedef enum thud_status thud_screen_function(const struct thud_args *args, const struct thud_session *session,
                                              struct thud_error *err);

/* Runs what the words ask for; returns the exit status. */
int thud_cli_main(int argc, char **argv, thud_screen_function *screen);
