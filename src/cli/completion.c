/* Shells ask the program what may be completed: `thud help --complete LINE`. The words of the line are separated by
 * tabs, and the last one is not finished. The answer has a line for each word that is allowed there, and behind a tab
 * what it is. A line that begins with a colon names the files that are allowed. The scripts of the shells hand both
 * on. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/help.h"
#include "core/methods/method.h"
#include "io/file/file.h"
#include "io/file/paths.h"
#include "study/scene/scene.h"

/* ---- the lists ---- */

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
            word += strspn(word, "\t=");
            snprintf(name, sizeof name, "%.*s", (int)strcspn(word, "\t,"), word);
            if (thud_law_find(name))
                thud_law_choice_init(of[i].choice, thud_law_find(name));
        }
}

/* What a key may be where it is one of several words: the last part of KEY=... names it. */
static void add_values(const char *key, const char *line, struct thud_text *out)
{
    struct thud_interface interface;
    set_laws(&interface, line);
    const size_t whole = strcspn(key, "=");
    size_t n = 0; /* of the last part */
    while (n < whole && key[whole - n - 1] != '.')
        n++;
    const char *name = key + whole - n;
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

void thud_word_list(enum thud_word word, const char *line, struct thud_text *out)
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

/* ---- the end of a line ---- */

enum { WORDS_MAX = 256 };

struct typed {
    const char *line;
    const char *word[WORDS_MAX];
    int n;
    const char *last; /* which is not finished */
};

/* Every line of `list` between what stands before and behind it. */
static void put_each(struct thud_text *out, struct thud_text *list, const char *before, int length, const char *behind)
{
    char *rest = list->data, *word;
    while (rest && (word = thud_text_line(&rest)) != NULL)
        thud_text_append(out, "%.*s%s%s\n", length, before, word, behind);
    out->failed |= list->failed;
    thud_text_clear(list);
}

/* What an operand or an option's argument may be. */
static void put_words(struct thud_text *out, enum thud_word word, const struct typed *typed)
{
    struct thud_text list = {0};
    const char *equal = word == THUD_WORD_KEY ? strchr(typed->last, '=') : NULL;
    if (equal)
        add_values(typed->last, typed->line, &list);
    else
        thud_word_list(word, typed->line, &list);
    put_each(out, &list, typed->last, equal ? (int)(equal + 1 - typed->last) : 0,
             word == THUD_WORD_KEY && !equal ? "=" : "");
    thud_text_append(out, "%s",
                     word == THUD_WORD_PRESET   ? ":presets\n"
                     : word == THUD_WORD_FILE   ? ":files\n"
                     : word == THUD_WORD_FOLDER ? ":folders\n"
                                                : "");
}

/* The option of a word that begins with dashes, and may have its value behind it. */
static const struct thud_option *option_of(enum thud_command_id id, const char *word)
{
    char name[32];
    const char *from = word + strspn(word, "-");
    snprintf(name, sizeof name, "%.*s", (int)strcspn(from, "="), from);
    return *word == '-' ? thud_option_find(id, name) : NULL;
}

static void put_argument(struct thud_text *out, const struct thud_option *option, const struct typed *typed)
{
    const char *choice;
    const int before = *typed->last == '-' ? (int)strcspn(typed->last, "=") + 1 : 0;
    for (int i = 0; option->word == THUD_WORD_CHOICE && (choice = thud_option_choice(option, i)) != NULL; i++)
        thud_text_append(out, "%.*s%s\n", before, typed->last, choice);
    if (option->word != THUD_WORD_CHOICE && before == 0)
        put_words(out, option->word, typed);
}

static void put_options(struct thud_text *out, enum thud_command_id id)
{
    for (int i = 0; i < thud_option_count(); i++) {
        const struct thud_option *option = thud_option_at(i);
        if (thud_option_belongs(option, id))
            thud_text_append(out, "%s%s\t%s\n", option->name[1] ? "--" : "-", option->name, option->help);
    }
}

static void put_end(struct thud_text *out, const struct typed *typed)
{
    const enum thud_command_id found = typed->n > 2 ? thud_command_find(typed->word[1]) : THUD_COMMANDS,
                               id = found == THUD_COMMANDS ? THUD_COMMAND_SCREEN : found;
    const struct thud_command *command = thud_command_at(id);
    const struct thud_option *option = NULL;
    int operands = 0;
    for (int i = id == THUD_COMMAND_SCREEN ? 1 : 2; i + 1 < typed->n; i++) {
        const bool argument = option != NULL;
        option = argument ? NULL : option_of(id, typed->word[i]);
        operands += !argument && *typed->word[i] != '-';
        if (option && (thud_option_stands_alone(option) || strchr(typed->word[i], '=')))
            option = NULL;
    }
    if (option)
        put_argument(out, option, typed);
    else if (*typed->last == '-' && strchr(typed->last, '=') && (option = option_of(id, typed->last)) != NULL)
        put_argument(out, option, typed);
    else if (*typed->last == '-')
        put_options(out, id);
    else
        put_words(out, operands > 0 && command->rest != THUD_WORD_NONE ? command->rest : command->word, typed);
    for (int i = 1; typed->n <= 2 && *typed->last != '-' && i < THUD_COMMANDS; i++)
        thud_text_append(out, "%s\t%s\n", thud_command_at((enum thud_command_id)i)->name,
                         thud_command_at((enum thud_command_id)i)->summary);
}

void thud_complete(struct thud_text *out, const char *line)
{
    struct typed typed = {.line = line, .last = ""};
    char *words = strdup(line), *to = words, *rest = words;
    if (!words) {
        out->failed = true;
        return;
    }
    for (const char *at = line; *at; at++)
        if (strncmp(at, "\t=", 2) == 0 && (!at[2] || at[2] == '\t')) { /* bash parts KEY=WORD in three */
            *to++ = '=';
            at += at[2] ? 2 : 1;
        } else {
            *to++ = *at;
        }
    *to = '\0';
    while (rest && typed.n < WORDS_MAX) {
        typed.word[typed.n++] = typed.last = rest;
        rest = strchr(rest, '\t');
        if (rest)
            *rest++ = '\0';
    }
    put_end(out, &typed);
    free(words);
}

/* ---- the scripts ---- */

static const char bash[] = "# bash completion for thud\n"
                           "_thud()\n{\n"
                           "    local IFS=$'\\t' cur=$2 part= line found\n"
                           "    COMPREPLY=()\n"
                           "    [[ ${COMP_WORDS[COMP_CWORD]} == = ]] && cur= part=1 # KEY=WORD, which bash parts\n"
                           "    [[ $3 == = ]] && part=1\n"
                           "    while IFS= read -r line; do\n"
                           "        found=\n"
                           "        case $line in\n"
                           "        :files) found=$(compgen -f -- \"$cur\") ;;\n"
                           "        :folders) found=$(compgen -d -- \"$cur\") ;;\n"
                           "        :presets) found=$(compgen -d -- \"$cur\"; compgen -f -X '!*.yaml' -- \"$cur\") ;;\n"
                           "        *)\n"
                           "            line=${line%%$'\\t'*}\n"
                           "            [[ $part ]] && line=${line#*=}\n"
                           "            [[ $line == \"$cur\"* ]] && COMPREPLY+=(\"$line\")\n"
                           "            continue ;;\n"
                           "        esac\n"
                           "        compopt -o filenames 2>/dev/null\n"
                           "        [[ $found ]] && mapfile -t -O ${#COMPREPLY[@]} COMPREPLY <<<\"$found\"\n"
                           "    done < <(\"$1\" help --complete \"${COMP_WORDS[*]:0:COMP_CWORD+1}\" 2>/dev/null)\n"
                           "    [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null\n"
                           "}\n"
                           "complete -F _thud thud\n";

static const char zsh[] = "#compdef thud\n"
                          "_thud() {\n"
                          "    local -a found keys\n"
                          "    local line typed=\"${(pj:\\t:)words[1,CURRENT]}\" tab=$'\\t'\n"
                          "    for line in ${(f)\"$(_call_program words $words[1] help --complete ${(q)typed} "
                          "2>/dev/null)\"}; do\n"
                          "        case $line in\n"
                          "        :files) _files ;;\n"
                          "        :folders) _files -/ ;;\n"
                          "        :presets) _files -g '*.yaml' ;;\n"
                          "        *=) keys+=(${line//:/\\\\:}) ;;\n"
                          "        *$tab*) found+=(${${line%%$tab*}//:/\\\\:}:${line#*$tab}) ;;\n"
                          "        *) found+=(${line//:/\\\\:}) ;;\n"
                          "        esac\n"
                          "    done\n"
                          "    _describe thud found -- keys -S ''\n"
                          "}\n"
                          "_thud \"$@\"\n";

static const char fish[] =
    "# fish completion for thud\n"
    "function __thud_complete\n"
    "    set -l last (commandline -ct)\n"
    "    for line in (thud help --complete (string join \\t -- (commandline -opc) \"$last\") 2>/dev/null)\n"
    "        switch $line\n"
    "            case :files\n"
    "                __fish_complete_path $last\n"
    "            case :folders\n"
    "                __fish_complete_directories $last ''\n"
    "            case :presets\n"
    "                __fish_complete_suffix .yaml\n"
    "            case '*'\n"
    "                printf '%s\\n' $line\n"
    "        end\n"
    "    end\n"
    "end\n"
    "complete -c thud -f -a '(__thud_complete)'\n";

bool thud_completion(struct thud_text *out, const char *shell)
{
    const char *script = strcmp(shell, "bash") == 0   ? bash
                         : strcmp(shell, "zsh") == 0  ? zsh
                         : strcmp(shell, "fish") == 0 ? fish
                                                      : NULL;
    thud_text_append(out, "%s", script ? script : "");
    return script != NULL;
}
