/* The words after `thud`, sorted by the table of options. */
#pragma once

#include "app/run/command.h"
#include "base/quantity.h"

enum { THUD_OPERANDS_MAX = 64, THUD_GIVEN_MAX = 256, THUD_JOBS_MAX = 256 };

struct thud_args {
    enum thud_command_id command;
    int noperands, ngiven;
    const char *operand[THUD_OPERANDS_MAX];
    struct {
        const struct thud_option *option;
        const char *value; /* NULL for a switch, and where it was left out */
    } given[THUD_GIVEN_MAX];
};

/* Errors: THUD_USAGE naming the option and the nearest one there is. */
enum thud_status thud_args_parse(int argc, char **argv, struct thud_args *args, struct thud_error *err);

/* The last value given for an option; NULL when it was not. */
const char *thud_args_value(const struct thud_args *args, const char *name);
bool thud_args_has(const struct thud_args *args, const char *name);
/* The i-th value of a repeatable option; NULL past the last. */
const char *thud_args_repeated(const struct thud_args *args, const char *name, int i);

/* The message is about an option: its name becomes the key. */
void thud_args_key(const char *option, struct thud_error *err);

/* What was typed is wrong usage, and the message begins with the option. */
enum thud_status thud_args_wrong(const char *option, struct thud_error *err);
/* A quantity with its unit; *out stays unchanged where the option is not given. Errors: THUD_USAGE. */
enum thud_status thud_args_quantity(const struct thud_args *args, const char *option, enum thud_dimension dimension,
                                    double *out, struct thud_error *err);
/* "4 m2, 15 m, 30 GPa": one for each dimension, parted by `separator`. Errors: THUD_USAGE. */
enum thud_status thud_args_quantities(const char *option, const char *text, char separator,
                                      const enum thud_dimension *dimension, int n, double *value, const char *allowed,
                                      struct thud_error *err);
/* The index of the value among those of thud_option_choice; *out stays unchanged if the option is not given. Errors:
 * THUD_USAGE. */
enum thud_status thud_args_choice(const struct thud_args *args, const char *name, int *out, struct thud_error *err);
/* What was typed is wrong, and what is allowed. */
enum thud_status thud_args_refuse(const char *option, const char *text, const char *allowed, struct thud_error *err);
/* A whole number in an option. Errors: THUD_USAGE. */
enum thud_status thud_args_integer(const struct thud_args *args, const char *name, int least, int most, int fallback,
                                   int *out, struct thud_error *err);
