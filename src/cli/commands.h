/* The commands. Each is one file command_NAME.c and one line in command_words.h; its error is printed by cli.c, which
 * makes the exit status of it. */
#ifndef THUD_CLI_COMMANDS_H
#define THUD_CLI_COMMANDS_H

#include "base/text.h"
#include "cli/args.h"

#define THUD_COMMAND(ID, name)                                                                                         \
    enum thud_status thud_command_##name(const struct thud_args *args, struct thud_error *err);
#include "cli/command_words.h"
#undef THUD_COMMAND

/* Writes the text to standard output and clears it: without what a terminal would obey in place of showing it. Errors:
 * THUD_OUTPUT, THUD_MEMORY. */
enum thud_status thud_cli_print(struct thud_text *text, struct thud_error *err);
/* Rows and objects for another program: byte for byte, but on a terminal as above. */
enum thud_status thud_cli_print_data(struct thud_text *text, struct thud_error *err);

/* The names of files that were written, one a line; with --json an object with a list. Clears the text. */
enum thud_status thud_cli_print_files(const struct thud_args *args, struct thud_text *lines, struct thud_error *err);

/* Writes the message to standard error. */
void thud_cli_complain(const struct thud_error *err);

/* The works that a law or method is from, parted by "; ": a line each. */
void thud_cli_references(const char *reference, struct thud_text *out);

#endif
