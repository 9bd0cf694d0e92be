#include "cli/sweep_output.h"

#include <stdio.h>
#include <string.h>

#include "app/sweep/fragility_report.h"
#include "base/version.h"
#include "cli/commands.h"
#include "io/file/json.h"
#include "io/result/sweep_csv.h"

/* Next field of a line of CSV, with its end replaced; quotes taken off in place. *quoted: it had some, and may go over
 * several lines. After the last one *line is NULL and *after what comes behind the line. */
static char *next_field(char **line, bool *quoted, char **after)
{
    char *from = *line, *to = from, *in = from;
    *quoted = *in == '"';
    if (*quoted) {
        for (in++; *in && !(*in == '"' && in[1] != '"'); in++) {
            in += *in == '"';
            *to++ = *in;
        }
        in += *in == '"';
    } else {
        in += strcspn(in, ",\n");
        to = in;
    }
    *line = *in == ',' ? in + 1 : NULL;
    *after = *in ? in + 1 : in;
    *to = '\0';
    return from;
}

static bool is_number(const char *text)
{
    const char *end;
    double value;
    return thud_number_parse(text, &end, &value) == 0 && *end == '\0';
}

/* Lines of CSV as JSON objects under the names of the header. Record, case and structure are texts whatever they look
 * like. */
static void put_objects(struct thud_sweep_output *o, char *lines, struct thud_text *out)
{
    static const char *const texts[] = {"record", "case", "structure"};
    while (*lines) {
        struct thud_text head = {0};
        thud_sweep_csv_header(o->plan, THUD_SWEEP_CSV_FLOORS, &head);
        if (head.failed) {
            out->failed = 1;
            return;
        }
        char *names = head.data, *line = lines, *unused;
        thud_text_append(out, o->row ? ",\n  {" : "\n  {");
        o->row = true;
        for (bool first = true; line && names; first = false) {
            bool quoted, ignored, text = false;
            const char *name = next_field(&names, &ignored, &unused), *field = next_field(&line, &quoted, &lines);
            for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
                text |= strcmp(name, texts[i]) == 0;
            thud_text_append(out, first ? "" : ", ");
            thud_json_string(out, name);
            thud_text_append(out, ": ");
            if (quoted || text || (*field && !is_number(field)))
                thud_json_string(out, thud_text_csv_plain(field));
            else
                thud_text_append(out, "%s", *field ? field : "null");
        }
        thud_text_append(out, "}");
        thud_text_clear(&head);
    }
}

static void begin(struct thud_sweep_output *o)
{
    if (o->begun)
        return;
    o->begun = true;
    if (o->format == THUD_SWEEP_OUTPUT_CSV) {
        thud_sweep_csv_header(o->plan, THUD_SWEEP_CSV_FLOORS, &o->text);
    } else {
        thud_text_append(&o->text, "{\"preset\": ");
        thud_json_string(&o->text, o->plan->scene.name);
        thud_text_append(&o->text, ", \"version\": \"%s\", \"rows\": [", THUD_VERSION);
    }
}

enum thud_status thud_sweep_output_point(void *context, const struct thud_sweep_point *point, struct thud_error *err)
{
    struct thud_sweep_output *o = context;
    struct thud_text rows = {0};
    if (o->format == THUD_SWEEP_OUTPUT_TABLE)
        return THUD_OK;
    begin(o);
    struct thud_text *to = o->format == THUD_SWEEP_OUTPUT_CSV ? &o->text : &rows;
    enum thud_status status = thud_sweep_csv_rows(o->plan, THUD_SWEEP_CSV_FLOORS, point, to, err);
    if (rows.data && !rows.failed)
        put_objects(o, rows.data, &o->text);
    o->text.failed |= rows.failed;
    thud_text_clear(&rows);
    return status == THUD_OK ? thud_cli_print_data(&o->text, err) : status;
}

enum thud_status thud_sweep_output_end(struct thud_sweep_output *output, struct thud_error *err)
{
    if (output->format == THUD_SWEEP_OUTPUT_TABLE)
        return THUD_OK;
    begin(output);
    if (output->format == THUD_SWEEP_OUTPUT_JSON) {
        enum thud_status status = THUD_OK;
        thud_text_append(&output->text, "\n]");
        if (output->suite) {
            thud_text_append(&output->text, ", \"statistics\": ");
            status = thud_suite_json(output->suite, &output->text, err);
        }
        thud_text_append(&output->text, "}\n");
        if (status != THUD_OK)
            return status;
    }
    return thud_cli_print_data(&output->text, err);
}
