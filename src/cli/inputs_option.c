#include "cli/options.h"

#include <string.h>

enum { SAMPLES_MAX = 1000000, SEED_MAX = 2147483647 };

static enum thud_status read_sampling(const struct thud_args *args, enum thud_sampling *out, struct thud_error *err)
{
    const char *word = thud_args_value(args, "sampling");
    *out = THUD_SAMPLING_LATIN_HYPERCUBE;
    for (int i = 0; word && i < THUD_SAMPLINGS; i++)
        if (strcmp(word, thud_sampling_name((enum thud_sampling)i)) == 0) {
            *out = (enum thud_sampling)i;
            return THUD_OK;
        }
    if (!word)
        return THUD_OK;
    return thud_error_refuse(err, THUD_USAGE, "--sampling", "latin-hypercube, sobol",
                             "\"%.40s\" is not a way of sampling", word);
}

enum thud_status thud_inputs_option_read(const struct thud_args *args, int samples, struct thud_inputs_choice *out,
                                         struct thud_error *err)
{
    int seed = 1;
    const char *text;
    enum thud_status status = thud_args_integer(args, "samples", 0, SAMPLES_MAX, samples, &samples, err);
    if (status == THUD_OK)
        status = thud_args_integer(args, "seed", 0, SEED_MAX, 1, &seed, err);
    if (status == THUD_OK)
        status = read_sampling(args, &out->sampling, err);
    thud_inputs_init(&out->inputs);
    for (int i = 0; status == THUD_OK && (text = thud_args_repeated(args, "uncertain", i)) != NULL; i++)
        status = thud_inputs_set(&out->inputs, text, err);
    out->samples = (size_t)samples;
    out->seed = (unsigned long long)seed;
    return status;
}
