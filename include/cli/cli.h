/* The command line. */
#ifndef THUD_CLI_CLI_H
#define THUD_CLI_CLI_H

#include "cli/args.h"

/* What `thud [PRESET]` opens; the caller's, because the command line knows no terminal interface. */
typedef enum thud_status thud_screen_function(const struct thud_args *args, struct thud_error *err);

/* Runs what the words ask for; returns the exit status. */
int thud_cli_main(int argc, char **argv, thud_screen_function *screen);

#endif
