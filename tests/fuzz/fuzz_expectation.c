/* Any bytes as a file of expectations: what is taken is written and read back as the same rows; what is refused says
 * where and why. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/result/expectation_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void must(int holds)
{
    if (!holds)
        abort();
}

static void same(const struct thud_expectation *a, const struct thud_expectation *b)
{
    must(a->which == b->which && strcmp(a->name, b->name) == 0);
    must(fabs(a->value - b->value) <= 1e-9 * fabs(a->value) + 1e-300);
    /* which is written with one digit */
    must(fabs(a->tolerance - b->tolerance) <= 0.5 * a->tolerance + 1e-300);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const struct thud_expectation_origin origin = {"fuzz", "exact", "dormand-prince", "tolerance 1e-6", 1e-10};
    struct thud_expectations read, again, none = {0};
    struct thud_error err = {0};
    char message[2048], *own = malloc(size); /* its own allocation, so that one byte too far is found */
    must(own != NULL || size == 0);
    if (size)
        memcpy(own, data, size);
    enum thud_status status = thud_expectation_parse(own ? own : "", size, "fuzz.csv", &read, &err);
    free(own);
    if (status != THUD_OK) {
        must(status == THUD_INPUT && read.n == 0 && !read.item);
        must(err.what[0] && strncmp(thud_error_text(&err, message, sizeof message), "fuzz.csv", 8) == 0);
        return 0;
    }
    struct thud_text text = {0};
    thud_expectation_text(&origin, &read, &none, &text);
    must(thud_expectation_parse(text.data, text.size, "again.csv", &again, &err) == THUD_OK && again.n == read.n);
    for (size_t i = 0; i < read.n; i++)
        same(&read.item[i], &again.item[i]);
    thud_text_clear(&text);
    thud_expectations_clear(&again);
    thud_expectations_clear(&read);
    return 0;
}
