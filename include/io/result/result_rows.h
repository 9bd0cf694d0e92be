/* Results of a run as rows: the tables of their fields, and the functions that fill them from a report. */
#pragma once

#include "io/file/schema.h"
#include "io/result/result_file.h"
#include "study/sweep/remark.h"

extern const struct thud_schema thud_record_schema, thud_method_schema, thud_floor_schema, thud_storey_schema,
    thud_contact_schema, thud_column_schema, thud_link_schema, thud_impact_schema, thud_event_schema,
    thud_energy_schema, thud_truncation_schema, thud_history_schema, thud_floor_spectrum_schema, thud_remark_schema;

/* Flags of rows with more fields. */
enum {
    THUD_ROW_YIELDS = 1,  /* storeys of the scene yield */
    THUD_ROW_COLUMNS = 2, /* a slab strikes columns */
    THUD_ROW_CONTACT = 4, /* an event of a contact */
    THUD_ROW_STOREY = 8,  /* an event of a storey */
    THUD_ROW_CAPACITY = 16,
    THUD_ROW_WEIGHS = 32, /* P-Delta */
    THUD_ROW_LINK = 64,   /* an event of a link */
    THUD_ROW_CASE = 128   /* several cases below each other */
};

struct thud_floor_row {
    const char *structure, *which;
    int floor;
    struct thud_floor_result peak;
    double stability;
    struct thud_storey_result storey; /* without values where it stays elastic */
    bool yields;
    const char *note;  /* of a table: "base", or NULL */
    const char *label; /* of its storey in a table: "base", or its number as presets and remarks count them */
    char label_text[8];
};
/* Rows of the floors of all structures of a report (`of`), or of one from the top down. */
struct thud_floors {
    const struct thud_report *report;
    int structure; /* -1: all of them, upwards */
};
struct thud_rows thud_floor_rows(const struct thud_floors *floors);
struct thud_rows thud_storey_rows(const struct thud_floors *floors); /* only of structures that yield */
struct thud_rows thud_contact_rows(const struct thud_report *report);
struct thud_rows thud_column_rows(const struct thud_report *report);
struct thud_rows thud_column_end_rows(const struct thud_report *report); /* for a table: the lower and the upper end */
struct thud_rows thud_link_rows(const struct thud_report *report);
struct thud_rows thud_impact_rows(const struct thud_report *report);
struct thud_rows thud_event_rows(const struct thud_report *report);
/* Writes the method and its work as an object. */
void thud_method_json(const struct thud_report *report, struct thud_text *out);
/* Writes the remarks of a set of enum thud_remark_about as the member "remarks", after others. */
void thud_remarks_json(const struct thud_remark_scope *scope, unsigned about, struct thud_text *out);
/* Returns the flags of the i-th event. */
unsigned thud_event_marks(const struct thud_report *report, int i);
