#include "app/run/event_list.h"

#include <stdio.h>

#include "io/file/json.h"

/* Where an event is: two floors of an interface, or a storey of a structure. */
struct place {
    int interface, left, right, storey; /* from 1; 0: not that */
    const char *structure;
};

/* The storeys that yield have the rows behind the contacts, in the order of the structures and their floors. */
static struct place place_of(const struct thud_report *report, int row)
{
    const struct thud_result *r = report->result;
    if (row < r->ncontacts)
        return (struct place){r->contact[row].interface, r->contact[row].left_floor, r->contact[row].right_floor, 0,
                              ""};
    row -= r->ncontacts;
    for (int s = 0; s < r->nstructures; s++)
        for (int i = 0; r->structure[s].storey && i < r->structure[s].floors; i++)
            if (r->structure[s].storey[i].yields && row-- == 0)
                return (struct place){0, 0, 0, i + 1, report->scene->structure[s].name};
    return (struct place){0};
}

static void text_row(const struct thud_event_entry *e, const struct place *p, struct thud_text *out)
{
    char where[80];
    if (p->interface > 0)
        snprintf(where, sizeof where, "%d: %d-%d", p->interface, p->left, p->right);
    else
        snprintf(where, sizeof where, "%.40s, storey %d", p->structure, p->storey);
    thud_text_append(out, "%14.9f  %-16s %-16s %-19s %5d %11.4f  %s\n", e->time_s, where, e->event, e->guard, e->order,
                     1e-3 * e->force_n + 0.0, e->then);
}

static void csv_row(const struct thud_event_entry *e, const struct place *p, struct thud_text *out)
{
    thud_text_number(out, e->time_s);
    if (p->interface > 0)
        thud_text_append(out, ",%d,%d,%d,,,", p->interface, p->left, p->right);
    else {
        thud_text_append(out, ",,,,");
        thud_text_csv(out, p->structure);
        thud_text_append(out, ",%d,", p->storey);
    }
    thud_text_append(out, "%s,%s,%d,", e->event, e->guard, e->order);
    thud_text_number(out, e->force_n);
    thud_text_append(out, ",");
    thud_text_csv(out, e->then);
    thud_text_append(out, "\n");
}

static void json_row(const struct thud_event_entry *e, const struct place *p, struct thud_text *out)
{
    thud_text_append(out, "{\"time_s\": ");
    thud_json_number(out, e->time_s);
    if (p->interface > 0) {
        thud_text_append(out, ", \"interface\": %d, \"left_floor\": %d, \"right_floor\": %d", p->interface, p->left,
                         p->right);
    } else {
        thud_text_append(out, ", \"structure\": ");
        thud_json_string(out, p->structure);
        thud_text_append(out, ", \"storey\": %d", p->storey);
    }
    thud_text_append(out, ", \"event\": \"%s\", \"guard\": \"%s\", \"order\": %d, \"force_n\": ", e->event, e->guard,
                     e->order);
    thud_json_number(out, e->force_n);
    thud_text_append(out, ", \"then\": \"%s\"}", e->then);
}

void thud_event_list(const struct thud_report *report, enum thud_event_format format, struct thud_text *out)
{
    static const char *const head[] = {
        [THUD_EVENTS_TEXT] =
            "time (s)        where            event            guard               order  force (kN)  then\n",
        [THUD_EVENTS_CSV] = "time_s,interface,left_floor,right_floor,structure,storey,event,guard,order,force_n,then\n",
        [THUD_EVENTS_JSON] = "{\"events\": [\n"};
    static void (*const row[])(const struct thud_event_entry *, const struct place *, struct thud_text *) = {
        [THUD_EVENTS_TEXT] = text_row, [THUD_EVENTS_CSV] = csv_row, [THUD_EVENTS_JSON] = json_row};
    thud_text_append(out, "%s", head[format]);
    for (int i = 0; i < report->nevents; i++) {
        const struct place p = place_of(report, report->event[i].row);
        row[format](&report->event[i], &p, out);
        if (format == THUD_EVENTS_JSON)
            thud_text_append(out, "%s\n", i + 1 < report->nevents ? "," : "");
    }
    if (format == THUD_EVENTS_JSON)
        thud_text_append(out, "]}\n");
}
