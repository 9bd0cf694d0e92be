/* The words of the command line: one table of commands and one of options feed parsing, help, completions and the tests
 * of the manual. */
#pragma once

#include <stdbool.h>

#include "base/status.h"

enum thud_command_id {
    THUD_COMMAND_SCREEN, /* no word: the terminal interface */
    THUD_COMMAND_RUN,
    THUD_COMMAND_NEW,
    THUD_COMMAND_SWEEP,
    THUD_COMMAND_GAP,
    THUD_COMMAND_SOLVE,
    THUD_COMMAND_SIMPLIFY,
    THUD_COMMAND_FRAGILITY,
    THUD_COMMAND_UNCERTAINTY,
    THUD_COMMAND_FIGURES,
    THUD_COMMAND_BENCH,
    THUD_COMMAND_STABILITY,
    THUD_COMMAND_VERIFY,
    THUD_COMMAND_RECORD,
    THUD_COMMAND_SUITE,
    THUD_COMMAND_REPORT,
    THUD_COMMAND_EXPORT,
    THUD_COMMAND_STIFFNESS,
    THUD_COMMAND_BUILDING,
    THUD_COMMAND_LAWS,
    THUD_COMMAND_METHODS,
    THUD_COMMAND_HELP,
    THUD_COMMANDS
};

/* What an operand or an option's argument is, so that a shell can complete it. */
enum thud_word {
    THUD_WORD_NONE,
    THUD_WORD_TEXT, /* free */
    THUD_WORD_FILE,
    THUD_WORD_FOLDER,
    THUD_WORD_PRESET, /* a name or a file */
    THUD_WORD_KEY,    /* and `=` after it */
    THUD_WORD_VARIED, /* a key alone */
    THUD_WORD_CASE,
    THUD_WORD_METHOD,
    THUD_WORD_FIGURE,
    THUD_WORD_RECORD_VERB,
    THUD_WORD_BUILDING_VERB,
    THUD_WORD_PROGRAM, /* that a scene is exported to */
    THUD_WORD_COMMAND,
    THUD_WORD_CHOICE, /* thud_option_choice */
    THUD_WORDS
};

struct thud_command {
    const char *name;     /* "" for the terminal interface */
    const char *operands; /* as in the usage line, e.g. "PRESET" */
    const char *summary;  /* one line */
    enum thud_word word;  /* of its operands */
    enum thud_word rest;  /* of those after the first, where they are others; else THUD_WORD_NONE */
};

struct thud_option {
    const char *name;     /* without dashes; one letter: a single dash */
    const char *argument; /* as in the usage line; NULL: a switch; "[=VALUE]": may be left out */
    const char *help;     /* one line */
    enum thud_word word;  /* of its argument */
    bool repeatable;
    unsigned commands; /* bit set of 1 << enum thud_command_id */
};

const struct thud_command *thud_command_at(enum thud_command_id id);
/* THUD_COMMANDS when no command has this name. */
enum thud_command_id thud_command_find(const char *name);

/* What the options of a command are about, as headings of its help: that of an option, by its index. */
const char *thud_option_part(int index);
int thud_option_count(void);
const struct thud_option *thud_option_at(int index);
/* The option of this name (without dashes) that the command knows; NULL when there is none. */
const struct thud_option *thud_option_find(enum thud_command_id command, const char *name);
static inline bool thud_option_belongs(const struct thud_option *option, enum thud_command_id command)
{
    return (option->commands & 1u << command) != 0;
}

/* Whether the option can stand alone: then only `--name=value` gives it a value. */
static inline bool thud_option_stands_alone(const struct thud_option *option)
{
    return !option->argument || option->argument[0] == '[';
}

/* The i-th value that an option of THUD_WORD_CHOICE takes; NULL past the last. */
const char *thud_option_choice(const struct thud_option *option, int i);

/* The word of a kind as it stands in `thud help --words`: "presets", "keys", ...; NULL for those with no list. */
const char *thud_word_list_name(enum thud_word word);

/* ---- What the shell is told ---- */

/* 0 done, 1 a check did not hold, 2 wrong usage, 3 bad input, 4 the integration failed, 5 gnuplot, 6 output or memory,
 * 130 cancelled. */
int thud_exit_status(enum thud_status status);
