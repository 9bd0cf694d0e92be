/* thud help: the commands, the options of one; for shells the words that are allowed where, for the manual the parts
 * that come from tables. */
#include <stdio.h>
#include <string.h>

#include "cli/commands.h"
#include "cli/help.h"

static enum thud_status words(const char *list, struct thud_text *out, struct thud_error *err)
{
    char names[120] = "";
    for (int i = 0; i < THUD_WORDS; i++) {
        const char *name = thud_word_list_name((enum thud_word)i);
        if (name && strcmp(name, list) == 0) {
            thud_word_list((enum thud_word)i, "", out);
            return THUD_OK;
        }
        if (name)
            thud_append(names, sizeof names, "%s%s", *names ? ", " : "", name);
    }
    return thud_error_refuse(err, THUD_USAGE, NULL, names, "there is no list of \"%.40s\"", list);
}

/* "list" of "record list": the options are those of the command. */
static bool is_verb(enum thud_command_id id, const char *word)
{
    struct thud_text verbs = {0};
    const enum thud_word first = thud_command_at(id)->word;
    const size_t n = strlen(word);
    bool found = false;
    if (first == THUD_WORD_RECORD_VERB || first == THUD_WORD_BUILDING_VERB || first == THUD_WORD_PROGRAM)
        thud_word_list(first, "", &verbs);
    for (const char *at = verbs.data; at && *at && !found; at += strcspn(at, "\n") + 1)
        found = n > 0 && strncmp(at, word, n) == 0 && at[n] == '\n';
    thud_text_clear(&verbs);
    return found;
}

/* What is no command is a question. */
static enum thud_status search(const struct thud_args *args, struct thud_text *out, struct thud_error *err)
{
    struct thud_text question = {0};
    for (int i = 0; i < args->noperands; i++)
        thud_text_append(&question, "%s%s", i ? " " : "", args->operand[i]);
    const bool found = question.data && thud_help_search(out, question.data);
    thud_text_clear(&question);
    return found ? THUD_OK
                 : thud_error_set(
                       err, THUD_USAGE,
                       "thud has no command \"%.40s\" (`thud help` lists them), and no paragraph of the manual "
                       "pages has these words",
                       args->operand[0]);
}

enum thud_status thud_command_help(const struct thud_args *args, struct thud_error *err)
{
    struct thud_text text = {0};
    enum thud_status status = THUD_OK;
    const char *list = thud_args_value(args, "words"), *shell = thud_args_value(args, "completion");
    const char *part = thud_args_value(args, "mdoc"), *typed = thud_args_value(args, "complete");
    enum thud_command_id id = args->noperands > 0 ? thud_command_find(args->operand[0]) : THUD_COMMAND_SCREEN;
    const bool known = id != THUD_COMMANDS;
    if (known && args->noperands == 2 && !is_verb(id, args->operand[1])) {
        status = thud_error_set(err, THUD_USAGE, "thud help takes one command, or one and its verb");
    } else if (list) {
        status = words(list, &text, err);
    } else if (typed) {
        thud_complete(&text, typed);
    } else if (shell) {
        if (!thud_completion(&text, shell))
            status = thud_error_set(err, THUD_USAGE, "no completion for \"%.40s\" (bash, zsh, fish)", shell);
    } else if (part) {
        if (!thud_manual_part(&text, part))
            status = thud_error_set(err, THUD_USAGE, "the manual has no part \"%.40s\"", part);
    } else if (!known || args->noperands > 2) {
        status = search(args, &text, err);
    } else if (args->noperands == 0) {
        thud_help_all(&text);
    } else {
        thud_help_command(&text, id);
    }
    if (status == THUD_OK)
        return thud_cli_print(&text, err);
    thud_text_clear(&text);
    return status;
}
