#include "cli/cli.h"

#include <errno.h>
#include <locale.h>
#include <stdio.h>
#include <string.h>

#include "app/exit_status.h"
#include "base/version.h"
#include "cli/commands.h"
#include "cli/help.h"
#include "cli/interrupt.h"

typedef enum thud_status command_function(const struct thud_args *args, struct thud_error *err);

static command_function *const commands[THUD_COMMANDS] = {
#define THUD_COMMAND(ID, name) [THUD_COMMAND_##ID] = thud_command_##name,
#include "cli/command_words.h"
#undef THUD_COMMAND
};

enum thud_status thud_cli_print(struct thud_text *text, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    if (text->failed)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    else if (text->size > 0 && (fwrite(text->data, 1, text->size, stdout) != text->size || fflush(stdout) != 0))
        status = thud_error_set(err, THUD_OUTPUT, "standard output: %s", strerror(errno));
    thud_text_clear(text);
    return status;
}

static enum thud_status help(enum thud_command_id command, struct thud_error *err)
{
    struct thud_text text = {0};
    if (command == THUD_COMMAND_SCREEN)
        thud_help_all(&text);
    else
        thud_help_command(&text, command);
    return thud_cli_print(&text, err);
}

static enum thud_status version(struct thud_error *err)
{
    struct thud_text text = {0};
    thud_version_text(&text);
    return thud_cli_print(&text, err);
}

static enum thud_status dispatch(int argc, char **argv, thud_screen_function *screen, struct thud_error *err)
{
    struct thud_args args;
    enum thud_status status = thud_args_parse(argc, argv, &args, err);
    if (status != THUD_OK)
        return status;
    if (thud_args_has(&args, "help"))
        return help(args.command, err);
    if (thud_args_has(&args, "version"))
        return version(err);
    if (args.command == THUD_COMMAND_SCREEN)
        return screen(&args, err);
    if (!commands[args.command])
        return thud_error_set(err, THUD_USAGE, "thud %s is not there yet", thud_command_at(args.command)->name);
    return commands[args.command](&args, err);
}

/* A message about a file begins with the file, as compilers' do; any other with the program's name. */
void thud_cli_complain(const struct thud_error *err)
{
    char text[1600];
    fprintf(stderr, "%s%s\n", err->file[0] ? "" : "thud: ", thud_error_text(err, text, sizeof text));
}

int thud_cli_main(int argc, char **argv, thud_screen_function *screen)
{
    struct thud_error err = {0};
    setlocale(LC_ALL, "");
    setlocale(LC_NUMERIC, "C");
    enum thud_status status = dispatch(argc, argv, screen, &err);
    if (status != THUD_OK && err.what[0])
        thud_cli_complain(&err);
    if (fclose(stdout) != 0 && status == THUD_OK) {
        fprintf(stderr, "thud: standard output: %s\n", strerror(errno));
        status = THUD_OUTPUT;
    }
    int number = status == THUD_CANCELLED ? thud_interrupt_signal() : 0;
    return number ? 128 + number : thud_exit_status(status);
}
