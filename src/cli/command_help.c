/* thud help: the commands, the options of one; for shells the words that are allowed where, for the manual the parts that come from tables. */
#include <stdio.h>
#include <string.h>

#include "cli/commands.h"
#include "cli/help.h"
#include "core/methods/method.h"
#include "io/file/paths.h"
#include "study/scene/scene.h"

static void add_presets(struct thud_text *out)
{
    struct thud_paths paths;
    struct thud_file_names names;
    thud_paths_find(&paths);
    thud_paths_presets(&paths, &names);
    for (int i = 0; i < names.n; i++)
        thud_text_append(out, "%s\n", names.list[i]);
}

/* A group's keys; of a structure those of a shear building, and of one by its matrix or modes. */
static void add_group(enum thud_group group, const char *prefix, struct thud_text *out)
{
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(group, i)); i++)
        if (group != THUD_GROUP_STRUCTURE || thud_structure_has(THUD_SHEAR, i) || thud_structure_has(THUD_MATRIX, i) ||
            thud_structure_has(THUD_MODES, i) || thud_structure_has(THUD_ESTIMATED, i))
            thud_text_append(out, "%s%s\n", prefix, param->name);
}

static void add_law(enum thud_group group, const char *prefix, const struct thud_law *law, struct thud_text *out)
{
    add_group(group, prefix, out);
    for (int i = 0; i < law->nparams; i++)
        thud_text_append(out, "%s%s\n", prefix, law->params[i].name);
}

/* A scene like the paper's, with the laws that a command line sets: "... contact.law=hertz ...". */
static void set_laws(struct thud_interface *interface, const char *line)
{
    const struct {
        const char *key;
        struct thud_law_choice *choice;
    } of[] = {{"contact.law", &interface->contact}, {"bumper.law", &interface->bumper}};
    thud_interface_init(interface);
    thud_interface_add_bumper(interface);
    for (size_t i = 0; i < sizeof of / sizeof *of; i++)
        for (const char *at = line; (at = strstr(at, of[i].key)) != NULL; at++) {
            char name[THUD_NAME_MAX];
            const char *word = at + strlen(of[i].key);
            word += strspn(word, " =");
            snprintf(name, sizeof name, "%.*s", (int)strcspn(word, " ,"), word);
            if (thud_law_find(name))
                thud_law_choice_init(of[i].choice, thud_law_find(name));
        }
}

/* What a key may be where it is one of several words: the last part of KEY= names it. */
static void add_values(const char *key, const char *line, struct thud_text *out)
{
    struct thud_interface interface;
    set_laws(&interface, line);
    const char *dot = strrchr(key, '.'), *name = dot ? dot + 1 : key;
    const size_t n = strcspn(name, "=");
    const bool bumper = strncmp(key, "bumper.", 7) == 0 || strstr(key, ".bumper.");
    const struct thud_law *law = bumper ? interface.bumper.law : interface.contact.law;
    if (n == 3 && strncmp(name, "law", n) == 0)
        for (int i = 0; i < thud_law_count(); i++)
            thud_text_append(out, "%s\n", thud_law_at(i)->name);
    for (int i = 0; i < law->nparams; i++)
        if (strlen(law->params[i].name) == n && strncmp(law->params[i].name, name, n) == 0)
            for (int k = 0; law->params[i].choices && law->params[i].choices[k]; k++)
                thud_text_append(out, "%s\n", law->params[i].choices[k]);
}

/* Keys as they are named in a scene like the paper's. */
static void add_keys(const char *line, struct thud_text *out)
{
    struct thud_interface interface;
    set_laws(&interface, line);
    add_group(THUD_GROUP_INTERFACE, "", out);
    add_law(THUD_GROUP_CONTACT, "contact.", interface.contact.law, out);
    add_law(THUD_GROUP_BUMPER, "bumper.", interface.bumper.law, out);
    add_group(THUD_GROUP_STRUCTURE, "structures.1.", out);
    add_group(THUD_GROUP_COLUMN, "structures.1.column.", out);
    add_group(THUD_GROUP_FOUNDATION, "structures.1.foundation.", out);
    add_group(THUD_GROUP_STRUCTURE, "structures.2.", out);
    add_group(THUD_GROUP_COLUMN, "structures.2.column.", out);
    add_group(THUD_GROUP_FOUNDATION, "structures.2.foundation.", out);
    add_group(THUD_GROUP_LINK, "links.1.", out);
    add_group(THUD_GROUP_RECORD, "record.", out);
    add_group(THUD_GROUP_ANALYSIS, "analysis.", out);
    add_group(THUD_GROUP_STUDY, "study.", out);
    add_group(THUD_GROUP_DOCUMENT, "document.", out);
    add_group(THUD_GROUP_SCENE, "", out);
}

static void add_words(enum thud_word word, const char *line, struct thud_text *out)
{
    if (word == THUD_WORD_PRESET)
        add_presets(out);
    else if (word == THUD_WORD_KEY || word == THUD_WORD_VARIED)
        add_keys(line, out);
    else if (word == THUD_WORD_FIGURE)
        thud_text_append(out, "fig3\nfig4\nfig5\nfig7\nfig8\nfig10\nall\n");
    else if (word == THUD_WORD_RECORD_VERB)
        thud_text_append(out, "info\nimport\nconvert\nlist\nsynthesize\nspectrum\n");
    else if (word == THUD_WORD_BUILDING_VERB) {
        thud_text_append(out, "import\n");
        add_presets(out);
    } else if (word == THUD_WORD_PROGRAM)
        thud_text_append(out, "opensees\n");
    for (int i = 0; word == THUD_WORD_CASE && i < THUD_CASES; i++)
        thud_text_append(out, "%s\n", thud_case_name((enum thud_case)i));
    for (int i = -1; word == THUD_WORD_METHOD && i < thud_method_count(); i++)
        thud_text_append(out, "%s\n", i < 0 ? "auto" : thud_method_at(i)->name);
    for (int i = 1; word == THUD_WORD_COMMAND && i < THUD_COMMANDS; i++)
        thud_text_append(out, "%s\n", thud_command_at((enum thud_command_id)i)->name);
}

/* `line`: what has been typed so far. */
static enum thud_status words(const char *list, const char *line, struct thud_text *out, struct thud_error *err)
{
    char names[120] = "";
    if (strchr(list, '=')) {
        add_values(list, line, out);
        return THUD_OK;
    }
    for (int i = 0; i < THUD_WORDS; i++) {
        const char *name = thud_word_list_name((enum thud_word)i);
        if (name && strcmp(name, list) == 0) {
            add_words((enum thud_word)i, line, out);
            return THUD_OK;
        }
        size_t n = strlen(names);
        if (name)
            snprintf(names + n, sizeof names - n, "%s%s", n ? ", " : "", name);
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
        add_words(first, "", &verbs);
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
    const char *part = thud_args_value(args, "mdoc");
    enum thud_command_id id = args->noperands > 0 ? thud_command_find(args->operand[0]) : THUD_COMMAND_SCREEN;
    const bool known = id != THUD_COMMANDS;
    if (known && args->noperands == 2 && !list && !is_verb(id, args->operand[1])) {
        status = thud_error_set(err, THUD_USAGE, "thud help takes one command, or one and its verb");
    } else if (list) {
        status = words(list, args->noperands > 0 ? args->operand[0] : "", &text, err);
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
