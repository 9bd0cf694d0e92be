#include "io/record/record_write.h"

#include <stdio.h>
#include <string.h>

static void comment_lines(const char *comment, struct thud_text *text)
{
    while (comment && *comment) {
        size_t n = strcspn(comment, "\n");
        thud_text_append(text, "# %.*s\n", (int)n, comment);
        comment += n + (comment[n] == '\n');
    }
}

static void known(const char *name, const char *value, struct thud_text *text)
{
    if (value[0])
        thud_text_comment(text, name, value);
}

/* Rounded: the reader takes the step from the line `# dt:` when the times agree with it. */
static void time_text(double t, struct thud_text *text)
{
    char number[40];
    snprintf(number, sizeof number, "%.9f", t);
    size_t n = strlen(number);
    while (number[n - 1] == '0')
        number[--n] = '\0';
    if (number[n - 1] == '.')
        number[n - 1] = '\0';
    thud_text_append(text, "%s", number);
}

void thud_record_csv(const struct thud_record *record, const char *comment, struct thud_text *text)
{
    comment_lines(comment, text);
    if (record->synthetic && (!comment || !strstr(comment, THUD_RECORD_COMPUTED)))
        comment_lines(THUD_RECORD_COMPUTED, text);
    known("event", record->event, text);
    known("station", record->station, text);
    known("component", record->component, text);
    if (!comment || !strstr(comment, "\ndt: ")) {
        thud_text_append(text, "# dt: ");
        thud_text_number(text, record->dt_s);
        thud_text_append(text, " s\n");
    }
    thud_text_append(text, "time_s,acceleration_mps2\n");
    for (size_t i = 0; i < record->samples; i++) {
        time_text((double)i * record->dt_s, text);
        thud_text_append(text, ",");
        thud_text_number(text, record->a_mps2[i]);
        thud_text_append(text, "\n");
    }
}

enum thud_status thud_surrogate_csv(const struct thud_synthesis *synthesis, const char *title, struct thud_text *text,
                                    struct thud_error *err)
{
    struct thud_record *record;
    enum thud_status status = thud_synthesis_run(synthesis, &record, err);
    if (status)
        return status;
    snprintf(record->event, sizeof record->event, "%s", title);
    struct thud_text comment = {0};
    thud_text_append(&comment, "A surrogate made by `thud record synthesize`: " THUD_RECORD_COMPUTED ".\n");
    thud_synthesis_describe(synthesis, "", &comment);
    if (comment.failed)
        text->failed = 1;
    else
        thud_record_csv(record, comment.data, text);
    thud_text_clear(&comment);
    thud_record_free(record);
    return text->failed ? thud_error_set(err, THUD_MEMORY, "out of memory") : THUD_OK;
}
