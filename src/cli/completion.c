/* Completion scripts. What a shell completes is looked up in the tables when the script is made, and asked of the
 * program itself
 * (`thud help --words LIST`) where it depends on the presets found. */
#include <string.h>

#include "cli/help.h"

static const char *dashes(const struct thud_option *option)
{
    return option->name[1] ? "--" : "-";
}

/* Whether names of files are allowed there. */
static bool has_files(enum thud_word word)
{
    return word == THUD_WORD_PRESET || word == THUD_WORD_FILE || word == THUD_WORD_FOLDER;
}

static void put_choices(struct thud_text *out, const struct thud_option *option, const char *before,
                        const char *between, const char *after)
{
    const char *choice;
    for (int i = 0; (choice = thud_option_choice(option, i)) != NULL; i++)
        thud_text_append(out, "%s%s", i ? between : before, choice);
    thud_text_append(out, "%s", after);
}

/* ---- bash: words are parted by the ends of lines, so that names may have blanks */

/* A command that prints what is allowed there. */
static void bash_words(struct thud_text *out, enum thud_word word)
{
    const char *list = thud_word_list_name(word);
    if (list)
        thud_text_append(out, "compgen -W \"$(\"$1\" help --words %s \"$COMP_LINE\" 2>/dev/null)\"%s -- \"$cur\"", list,
                         word == THUD_WORD_KEY ? " -S =" : "");
    if (word == THUD_WORD_PRESET)
        thud_text_append(out, "; compgen -d -- \"$cur\"; compgen -f -X '!*.yaml' -- \"$cur\"");
    else if (word == THUD_WORD_FILE)
        thud_text_append(out, "compgen -f -- \"$cur\"");
    else if (word == THUD_WORD_FOLDER)
        thud_text_append(out, "compgen -d -- \"$cur\"");
    else if (!list)
        thud_text_append(out, ":");
}

static void bash_option(struct thud_text *out, const struct thud_option *option)
{
    if (thud_option_stands_alone(option))
        return;
    thud_text_append(out, "    %s%s)%s COMPREPLY=($(", dashes(option), option->name,
                     option->word == THUD_WORD_KEY ? " compopt -o nospace 2>/dev/null;"
                     : has_files(option->word)     ? " compopt -o filenames 2>/dev/null;"
                                                   : "");
    if (option->word == THUD_WORD_CHOICE)
        put_choices(out, option, "compgen -W $'", "\\n", "' -- \"$cur\"");
    else
        bash_words(out, option->word);
    thud_text_append(out, ")); return ;;\n");
}

static void bash_operands(struct thud_text *out, enum thud_word word, const char *indent)
{
    thud_text_append(out, "%s%sCOMPREPLY=($(", indent, has_files(word) ? "compopt -o filenames 2>/dev/null; " : "");
    bash_words(out, word);
    thud_text_append(out, "))\n");
}

static void bash_command(struct thud_text *out, enum thud_command_id id)
{
    const struct thud_command *command = thud_command_at(id);
    bool any = false;
    thud_text_append(out, "    %s)\n        options=$'", command->name[0] ? command->name : "*");
    for (int i = 0; i < thud_option_count(); i++)
        if (thud_option_belongs(thud_option_at(i), id)) {
            thud_text_append(out, "%s%s%s", any ? "\\n" : "", dashes(thud_option_at(i)), thud_option_at(i)->name);
            any = true;
        }
    thud_text_append(out, "'\n");
    bash_operands(out, command->word, "        ");
    if (command->rest != THUD_WORD_NONE) {
        thud_text_append(out, "        if [[ $COMP_CWORD -gt 2 ]]; then\n");
        bash_operands(out, command->rest, "            ");
        thud_text_append(out, "        fi\n");
    }
    thud_text_append(out, "        ;;\n");
}

static void bash(struct thud_text *out)
{
    thud_text_append(
        out, "# bash completion for thud\n"
             "_thud()\n{\n"
             "    local IFS=$'\\n' cur=$2 prev=$3 options\n"
             "    if [[ ( $cur == = || $prev == = ) && $COMP_CWORD -gt 2 ]]; then # KEY=WORD, which bash parts\n"
             "        local at=$((COMP_CWORD - 2)); [[ $cur == = ]] && at=$((COMP_CWORD - 1)) cur=\n"
             "        COMPREPLY=($(compgen -W \"$(\"$1\" help --words \"${COMP_WORDS[at]}=\" \"$COMP_LINE\" "
             "2>/dev/null)\" -- \"$cur\")); return\n"
             "    fi\n"
             "    case $prev in\n");
    for (int i = 0; i < thud_option_count(); i++)
        bash_option(out, thud_option_at(i));
    thud_text_append(out, "    esac\n    case ${COMP_WORDS[1]} in\n");
    for (int c = THUD_COMMANDS - 1; c >= 0; c--) /* the terminal interface has no word and comes last */
        bash_command(out, (enum thud_command_id)c);
    thud_text_append(out, "    esac\n"
                          "    if [[ $cur == -* ]]; then\n"
                          "        COMPREPLY=($(compgen -W \"$options\" -- \"$cur\"))\n"
                          "    elif [[ $COMP_CWORD == 1 ]]; then\n"
                          "        compopt -o filenames 2>/dev/null; COMPREPLY=($(");
    bash_words(out, THUD_WORD_COMMAND);
    thud_text_append(out, "; ");
    bash_words(out, THUD_WORD_PRESET);
    thud_text_append(out, "))\n    fi\n}\ncomplete -F _thud thud\n");
}

/* ---- zsh */

/* Text inside single quotes in a zsh specification. */
static void zsh_text(struct thud_text *out, const char *text)
{
    for (const char *c = text; *c; c++) {
        if (strchr("[]:\\", *c))
            thud_text_append(out, "\\");
        thud_text_append(out, *c == '\'' ? "%c\\''" : "%c", *c);
    }
}

static void zsh_words(struct thud_text *out, enum thud_word word)
{
    const char *list = thud_word_list_name(word);
    if (word == THUD_WORD_FILE)
        thud_text_append(out, "_files");
    else if (word == THUD_WORD_FOLDER)
        thud_text_append(out, "_files -/");
    else if (list)
        thud_text_append(out, " _thud_words %s", list); /* the blank keeps _arguments from putting words between */
}

static void zsh_operands(struct thud_text *out, const char *place, const char *what, enum thud_word word)
{
    thud_text_append(out, " \\\n            '%s:", place);
    zsh_text(out, what);
    thud_text_append(out, ":");
    zsh_words(out, word);
    thud_text_append(out, "'");
}

static void zsh_option(struct thud_text *out, const struct thud_option *option)
{
    bool maybe = option->argument && thud_option_stands_alone(option);
    thud_text_append(out, " \\\n            '%s%s%s%s[", option->repeatable ? "*" : "", dashes(option), option->name,
                     maybe ? "=-" : "");
    zsh_text(out, option->help);
    thud_text_append(out, "]");
    if (option->argument) {
        thud_text_append(out, maybe ? "::" : ":");
        zsh_text(out, option->argument);
        thud_text_append(out, ":");
        if (option->word == THUD_WORD_CHOICE)
            put_choices(out, option, "(", " ", ")");
        else
            zsh_words(out, option->word);
    }
    thud_text_append(out, "'");
}

static void zsh(struct thud_text *out)
{
    thud_text_append(out, "#compdef thud\n"
                          "_thud_words() {\n"
                          "    local -a found\n"
                          "    local list=$1 line=\"$words\"\n"
                          "    if [[ $1 == (keys|varied) && $PREFIX == *=* ]]; then # KEY=WORD\n"
                          "        list=${PREFIX%%%%=*}=\n"
                          "        compset -P '*='\n"
                          "    fi\n"
                          "    found=(${(f)\"$(_call_program words $words[1] help --words ${(q)list} ${(q)line} "
                          "2>/dev/null)\"})\n"
                          "    case $list in\n"
                          "    keys) compadd -S = -a found ;;\n"
                          "    presets) compadd -a found; _files -g '*.yaml' ;;\n"
                          "    *) compadd -a found ;;\n"
                          "    esac\n"
                          "}\n"
                          "_thud() {\n"
                          "    if ((CURRENT == 2)) && [[ $words[2] != -* ]]; then\n"
                          "        _thud_words commands\n"
                          "        _thud_words presets\n"
                          "        return\n"
                          "    fi\n"
                          "    case $words[2] in\n");
    for (int c = THUD_COMMANDS - 1; c >= 0; c--) {
        const struct thud_command *command = thud_command_at((enum thud_command_id)c);
        thud_text_append(out, "    %s)\n        _arguments%s", command->name[0] ? command->name : "*",
                         command->name[0] ? " '1:command:'" : "");
        for (int i = 0; i < thud_option_count(); i++)
            if (thud_option_belongs(thud_option_at(i), (enum thud_command_id)c))
                zsh_option(out, thud_option_at(i));
        if (command->word != THUD_WORD_NONE)
            zsh_operands(out, command->rest == THUD_WORD_NONE ? "*" : "2", command->operands, command->word);
        if (command->rest != THUD_WORD_NONE)
            zsh_operands(out, "*", command->operands, command->rest);
        thud_text_append(out, "\n        ;;\n");
    }
    thud_text_append(out, "    esac\n}\n_thud \"$@\"\n");
}

/* ---- fish */

/* Text inside single quotes. */
static void fish_text(struct thud_text *out, const char *text)
{
    for (const char *c = text; *c; c++)
        thud_text_append(out, strchr("'\\", *c) ? "\\%c" : "%c", *c);
}

static void fish_words(struct thud_text *out, enum thud_word word)
{
    const char *list = thud_word_list_name(word);
    if (word == THUD_WORD_FOLDER)
        thud_text_append(out, " -x -a '(__fish_complete_directories)'");
    else if (list && word != THUD_WORD_PRESET)
        thud_text_append(out, " -x -a '(__thud_words %s)'", list);
    else if (list)
        thud_text_append(out, " -x -a '(thud help --words %s 2>/dev/null; __fish_complete_suffix .yaml)'", list);
    else if (word == THUD_WORD_TEXT)
        thud_text_append(out, " -x");
    else if (word == THUD_WORD_FILE)
        thud_text_append(out, " -r -F");
}

/* Where a command's words and options hold; `first`: -1 before the first of its own words is there, 1 after it. */
static void fish_place(struct thud_text *out, const struct thud_command *command, int first)
{
    if (command->name[0]) {
        thud_text_append(out, "complete -c thud -n '__fish_seen_subcommand_from %s", command->name);
        if (first)
            thud_text_append(out, "; and %s__fish_seen_subcommand_from (thud help --words %s)", first < 0 ? "not " : "",
                             thud_word_list_name(command->word));
        thud_text_append(out, "'");
    } else {
        thud_text_append(out, "complete -c thud -n __fish_use_subcommand");
    }
}

static void fish(struct thud_text *out)
{
    thud_text_append(out, "# fish completion for thud\n"
                          "function __thud_words\n"
                          "    set -l line (commandline -cp | string collect)\n"
                          "    set -l key (commandline -ct | string match -r '^[^=]+=')\n"
                          "    if set -q key[1] # KEY=WORD\n"
                          "        string replace -r '^' -- $key (thud help --words $key $line 2>/dev/null)\n"
                          "    else if test $argv[1] = keys\n"
                          "        string replace -r '$' = (thud help --words keys $line 2>/dev/null)\n"
                          "    else\n"
                          "        thud help --words $argv[1] $line 2>/dev/null\n"
                          "    end\n"
                          "end\n"
                          "complete -c thud -f\n");
    for (int c = 0; c < THUD_COMMANDS; c++) {
        const struct thud_command *command = thud_command_at((enum thud_command_id)c);
        if (command->name[0]) {
            thud_text_append(out, "complete -c thud -n __fish_use_subcommand -a %s -d '", command->name);
            fish_text(out, command->summary);
            thud_text_append(out, "'\n");
        }
        if (command->word != THUD_WORD_NONE) {
            fish_place(out, command, command->rest != THUD_WORD_NONE ? -1 : 0);
            fish_words(out, command->word);
            thud_text_append(out, "\n");
        }
        if (command->rest != THUD_WORD_NONE) {
            fish_place(out, command, 1);
            fish_words(out, command->rest);
            thud_text_append(out, "\n");
        }
        for (int i = 0; i < thud_option_count(); i++) {
            const struct thud_option *option = thud_option_at(i);
            if (!thud_option_belongs(option, (enum thud_command_id)c))
                continue;
            fish_place(out, command, 0);
            thud_text_append(out, " %s %s", option->name[1] ? "-l" : "-s", option->name);
            if (option->word == THUD_WORD_CHOICE)
                put_choices(out, option, " -x -a '", " ", "'");
            else
                fish_words(out, option->word);
            thud_text_append(out, " -d '");
            fish_text(out, option->help);
            thud_text_append(out, "'\n");
        }
    }
}

bool thud_completion(struct thud_text *out, const char *shell)
{
    static const struct {
        const char *name;
        void (*write)(struct thud_text *out);
    } shells[] = {{"bash", bash}, {"zsh", zsh}, {"fish", fish}};
    for (size_t i = 0; i < sizeof shells / sizeof *shells; i++) {
        if (strcmp(shells[i].name, shell) == 0) {
            shells[i].write(out);
            return true;
        }
    }
    return false;
}
