#include "cli/options.h"

#include <string.h>

enum { SAMPLES_MAX = 1000000, SEED_MAX = 2147483647 };

enum thud_status thud_inputs_option_read(const struct thud_args *args, int samples, struct thud_inputs_choice *out,
                                         struct thud_error *err)
{
    int seed = 1, sampling = THUD_SAMPLING_LATIN_HYPERCUBE;
    const char *text;
    enum thud_status status = thud_args_integer(args, "samples", 0, SAMPLES_MAX, samples, &samples, err);
    if (status == THUD_OK)
        status = thud_args_integer(args, "seed", 0, SEED_MAX, 1, &seed, err);
    if (status == THUD_OK)
        status = thud_args_choice(args, "sampling", &sampling, err);
    thud_inputs_init(&out->inputs);
    for (int i = 0; status == THUD_OK && (text = thud_args_repeated(args, "uncertain", i)) != NULL; i++)
        status = thud_inputs_set(&out->inputs, text, err);
    out->samples = (size_t)samples;
    out->sampling = (enum thud_sampling)sampling;
    out->seed = (unsigned long long)seed;
    return status;
}
