/* --uncertain, --samples, --sampling, --seed: the inputs that are not known, and how often they are drawn. */
#ifndef THUD_CLI_INPUTS_OPTION_H
#define THUD_CLI_INPUTS_OPTION_H

#include "app/sweep/uncertainty_study.h"
#include "cli/args.h"

struct thud_inputs_choice {
    struct thud_inputs inputs;
    size_t samples;
    enum thud_sampling sampling;
    unsigned long long seed;
};
/* `samples`: where it is not said. Errors: THUD_USAGE. */
enum thud_status thud_inputs_option_read(const struct thud_args *args, int samples, struct thud_inputs_choice *out,
                                         struct thud_error *err);

#endif
