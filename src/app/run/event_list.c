#include "app/run/event_list.h"

#include "io/result/result_rows.h"

void thud_event_list(const struct thud_report *report, enum thud_event_format format, struct thud_text *out)
{
    const struct thud_rows rows = thud_event_rows(report);
    if (format == THUD_EVENTS_TEXT)
        thud_rows_table(&rows, out);
    else if (format == THUD_EVENTS_CSV)
        thud_rows_csv(&rows, out);
    else
        thud_text_append(out, "{\"events\": [\n");
    for (int i = 0; i < rows.n && format == THUD_EVENTS_JSON; i++) {
        struct thud_row_room row;
        rows.make(report, i, row.bytes);
        thud_text_append(out, "{");
        thud_json_members(rows.schema, thud_event_marks(report, i), row.bytes, out);
        thud_text_append(out, i + 1 < rows.n ? "},\n" : "}\n");
    }
    if (format == THUD_EVENTS_JSON)
        thud_text_append(out, "]}\n");
}
