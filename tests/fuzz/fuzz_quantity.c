/* Any text as a quantity of any dimension: what is taken is finite and reads back the same when written; what is
 * refused says why. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void must(int holds)
{
    if (!holds)
        abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0)
        return 0;
    char *text = malloc(size);
    memcpy(text, data + 1, size - 1);
    text[size - 1] = '\0';
    enum thud_dimension dimension = data[0] % THUD_DIMENSIONS;
    struct thud_quantity read = {0};
    struct thud_error err = {0};
    if (thud_quantity_parse(text, dimension, NULL, &read, &err) == THUD_OK) {
        must(isfinite(read.value));
        if (dimension == THUD_NUMBER) {
            char written[64];
            struct thud_quantity again = {0};
            thud_quantity_format(read.value, "", written, sizeof written);
            must(thud_quantity_parse(written, dimension, NULL, &again, NULL) == THUD_OK);
            must(again.value == read.value);
        }
    } else {
        char message[2048];
        must(err.status == THUD_INPUT && err.what[0] != '\0');
        must(strlen(thud_error_text(&err, message, sizeof message)) < sizeof message);
    }
    thud_unit_factor(text, NULL, NULL);
    free(text);
    return 0;
}
