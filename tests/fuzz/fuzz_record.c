/* Any bytes at all as a record file: a record whose samples are finite, or a refusal with a message. The first byte
 * says which options the user gave. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/record/record_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void hold(int condition)
{
    if (!condition)
        abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0)
        return 0;
    unsigned options = data[0]; /* '@' (0x40): none */
    struct thud_record_choice choice;
    thud_record_choice_init(&choice);
    if (options & 1)
        choice.dt_s = 0.01;
    if (options & 2)
        strcpy(choice.unit, "g");
    if (options & 4)
        choice.column = options & 8 ? -1 : 2;
    else if (options & 8)
        strcpy(choice.channel, "2");
    if (options & 16)
        choice.skip = 2;
    if (options & 32)
        choice.peak_mps2 = 1;
    char *text = malloc(size); /* its own allocation, so that one byte too far is found */
    hold(text != NULL);
    memcpy(text, data + 1, size - 1);
    struct thud_record *record;
    struct thud_error err = {0};
    char message[2048];
    enum thud_status status = thud_record_parse(text, size - 1, "fuzz", &choice, &record, &err);
    if (status == THUD_OK) {
        hold(record->samples >= 2 && record->samples <= size && record->dt_s > 0);
        for (size_t i = 0; i < record->samples; i++)
            hold(isfinite(record->a_mps2[i]));
    } else {
        hold(status == THUD_INPUT && record == NULL && err.what[0]);
        hold(thud_error_text(&err, message, sizeof message)[0]);
    }
    thud_record_free(record);
    free(text);
    return 0;
}
