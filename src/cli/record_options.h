/* The options of `thud record`. */
#ifndef THUD_CLI_RECORD_OPTIONS_H
#define THUD_CLI_RECORD_OPTIONS_H

#include "app/run/record_verbs.h"
#include "cli/args.h"
#include "ground/synthesize.h"

enum { THUD_PERIODS_MAX = 10000 };

/* How a file is read and what is done to it. Errors: THUD_USAGE, with the option as key. */
enum thud_status thud_record_options_read(const struct thud_args *args, struct thud_record_treatment *treatment,
                                          struct thud_error *err);

/* The ratio in the option `damping`, and --periods; what is not given stays. Errors: THUD_USAGE. */
struct thud_spectrum_choice {
    double damping, from_s, to_s;
    int count;
};
enum thud_status thud_spectrum_options_read(const struct thud_args *args, const char *damping,
                                            struct thud_spectrum_choice *choice, struct thud_error *err);

/* The values of a surrogate from --set KEY=VALUE (the parameters' names, and `event`, a text), --peak and --dt. *event
 * stays NULL when it is not given. Errors: THUD_USAGE. */
enum thud_status thud_synthesis_options_read(const struct thud_args *args, struct thud_synthesis *synthesis,
                                             const char **event, struct thud_error *err);

#endif
