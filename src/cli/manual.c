#include "cli/help.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/ascii.h"
#include "base/param.h"
#include "core/laws/law.h"
#include "io/record/record_file.h"
#include "io/result/schemas.h"
#include "study/scene/gap_rule.h"
#include "study/scene/scene.h"
#include "study/suite/fragility.h"

enum { COLUMNS = 76 };

/* Text filled to lines, a new one for each sentence, so that none is taken for a request. */
static void fill(struct thud_text *out, const char *text)
{
    size_t column = 0;
    for (const char *word = text; *word;) {
        size_t length = strcspn(word, " ");
        bool dots = length > 1 && word[length - 2] == '.';
        bool sentence_ends = !dots && length > 0 && word[length - 1] == '.' && word[length] != '\0';
        if (column > 0 && column + 1 + length > COLUMNS) {
            thud_text_append(out, "\n");
            column = 0;
        }
        thud_text_append(out, "%s%s", column > 0 ? " " : "", column == 0 && strchr(".'", word[0]) ? "\\&" : "");
        for (size_t i = 0; i < length; i++)
            thud_text_append(out, word[i] == '\\' ? "\\e" : "%c", word[i]);
        column += length + 1;
        word += length + strspn(word + length, " ");
        if (sentence_ends) {
            thud_text_append(out, "\n");
            column = 0;
        }
    }
    if (column > 0)
        thud_text_append(out, "\n");
}

/* Takes `text` (cleared then). */
static void fill_made(struct thud_text *out, struct thud_text *text)
{
    if (text->failed)
        out->failed = 1;
    else
        fill(out, text->data);
    thud_text_clear(text);
}

static void put_value(struct thud_text *out, const struct thud_param *param, double value)
{
    char text[64];
    if (value == 0)
        strcpy(text, "0");
    else
        thud_quantity_format(value, param->unit, text, sizeof text);
    thud_text_append(out, "%s", text);
}

static void put_bounds(struct thud_text *out, const struct thud_param *param)
{
    char allowed[256];
    thud_param_allowed(param, allowed, sizeof allowed);
    if (param->unit && param->unit[0])
        thud_text_append(out, "Unit %s. ", param->unit);
    if (allowed[0])
        thud_text_append(out, "Allowed: %s. ", allowed);
    if (isnan(param->soft_least) && isnan(param->soft_most))
        return;
    thud_text_append(out, isnan(param->soft_least) ? "Usual: up to " : "Usual: from ");
    if (!isnan(param->soft_least))
        put_value(out, param, param->soft_least);
    if (!isnan(param->soft_least) && !isnan(param->soft_most))
        thud_text_append(out, " to ");
    if (!isnan(param->soft_most))
        put_value(out, param, param->soft_most);
    thud_text_append(out, ". ");
}

static void put_default(struct thud_text *out, const struct thud_param *param)
{
    if (isnan(param->fallback))
        return;
    thud_text_append(out, "Default ");
    if (param->kind == THUD_PARAM_CHOICE)
        thud_text_append(out, "%s", param->choices[(int)param->fallback]);
    else
        put_value(out, param, param->fallback);
    thud_text_append(out, ".");
}

/* The kinds of structure that have a parameter, where not all of them do. */
static void put_kinds(struct thud_text *out, int param)
{
    int have = 0;
    for (int k = 0; k < THUD_KINDS; k++)
        have += thud_structure_has((enum thud_structure_kind)k, param);
    if (have == THUD_KINDS)
        return;
    thud_text_append(out, " Pq ");
    for (int k = 0, n = 0; k < THUD_KINDS; k++)
        if (thud_structure_has((enum thud_structure_kind)k, param))
            thud_text_append(out, "%s%s", n++ ? ", " : "", thud_kind_name((enum thud_structure_kind)k));
}

/* of_structures: the index of a parameter of THUD_GROUP_STRUCTURE; -1: another's. */
static void put_param(struct thud_text *out, const struct thud_param *param, int of_structures)
{
    struct thud_text item = {0};
    thud_text_append(&item, "%s ", param->help);
    put_bounds(&item, param);
    put_default(&item, param);
    thud_text_append(out, ".It Cm %s", param->name);
    if (of_structures >= 0)
        put_kinds(out, of_structures);
    thud_text_append(out, "\n");
    fill_made(out, &item);
}

static void units(struct thud_text *out)
{
    thud_text_append(out, ".Bl -tag -width Ds -compact\n");
    for (int d = THUD_RATIO; d < THUD_DIMENSIONS; d++) {
        const char *name = thud_dimension_name((enum thud_dimension)d); /* "a length" */
        const char *blank = strchr(name, ' ');
        thud_text_append(out, ".It %s\n", blank ? blank + 1 : name);
        fill(out, thud_dimension_units((enum thud_dimension)d));
    }
    thud_text_append(out, ".El\n");
}

static void keys(struct thud_text *out)
{
    for (int g = 0; g < THUD_GROUPS; g++) {
        const char *key = thud_group_key((enum thud_group)g);
        if (key[0])
            thud_text_append(out, ".Ss %s\n", key);
        thud_text_append(out, ".Bl -tag -width Ds\n");
        for (int i = 0; thud_group_param((enum thud_group)g, i); i++)
            put_param(out, thud_group_param((enum thud_group)g, i), g == THUD_GROUP_STRUCTURE ? i : -1);
        thud_text_append(out, ".El\n");
    }
}

static void laws(struct thud_text *out)
{
    for (int i = 0; i < thud_law_count(); i++) {
        const struct thud_law *law = thud_law_at(i);
        thud_text_append(out, ".Ss Law %s\n", law->name);
        struct thud_text about = {0};
        thud_text_append(&about, "%s: %s", law->title, law->summary);
        fill_made(out, &about);
        thud_text_append(out, "%s", law->nparams ? ".Bl -tag -width Ds\n" : "");
        for (int k = 0; k < law->nparams; k++)
            put_param(out, &law->params[k], -1);
        thud_text_append(out, "%s", law->nparams ? ".El\n" : "");
    }
}

static void put_events(const char *before, enum thud_event_form form, const char *after, struct thud_text *out)
{
    struct thud_text text = {0};
    thud_text_append(&text, "%s", before);
    thud_events_list(form, &text);
    thud_text_append(&text, "%s", after);
    fill_made(out, &text);
}

static void events(struct thud_text *out)
{
    put_events("One of ", THUD_FORM_EVENT, ": there is contact, or a measure is above its limit.", out);
}

static void criteria(struct thud_text *out)
{
    put_events("The criterion: one of ", THUD_FORM_CRITERION, ", with a limit of your own.", out);
}

static void formats(struct thud_text *out)
{
    struct thud_text text = {0};
    thud_text_append(&text, "Formats are recognized by content: ");
    thud_record_formats(&text);
    thud_text_append(&text, ".");
    fill_made(out, &text);
}

static void gap_rules(struct thud_text *out)
{
    thud_text_append(out, ".Bl -tag -width Ds\n");
    for (int i = 0; i < THUD_GAP_RULES; i++) {
        const struct thud_gap_rule *rule = thud_gap_rule_at(i);
        struct thud_text text = {0};
        thud_text_append(&text, "%s%s%s%s%s: %s.", rule->edition, *rule->edition ? ", " : "", rule->clause,
                         *rule->clause ? ", " : "", rule->title, rule->formula);
        if (text.data)
            text.data[0] = thud_ascii_upper(text.data[0]);
        if (*rule->lacks)
            thud_text_append(&text, " It has no value if %s.", rule->lacks);
        if (*rule->source)
            thud_text_append(&text, " Implemented %s.", rule->source);
        thud_text_append(out, ".It %s\n", rule->name);
        fill_made(out, &text);
    }
    thud_text_append(out, ".El\n");
}

/* The table of measures: what each is, of what, and where it appears. */
static void measures(struct thud_text *out)
{
    static const char *const documents[THUD_MEASURE_DOCUMENTS] = {
        [THUD_TOLD_BY_SUITE] = "suite.csv",
        [THUD_TOLD_BY_LOWERED] = "what lowers a response",
        [THUD_TOLD_BY_UNCERTAINTY] = "uncertainty.csv",
        [THUD_TOLD_BY_SWEEP] = "figures of sweep",
        [THUD_TOLD_BY_FLOORS] = "sweep.csv (each floor)",
    };
    static const char *const needs[] = {"storeys that yield",           "isolators",
                                        "columns that slabs strike",    "a capacity of columns",
                                        "case none to compare with",    "links (soil behind walls is none)",
                                        "isolators that yield or slide"}; /* by the bits of THUD_HAS_... */
    thud_text_append(out, ".Ss measures\nResults that studies give of a run, each by its one name.\nAn event occurs "
                          "where its measure is above the limit.\n.Bl -tag -width Ds -compact\n");
    for (enum thud_measure m = 0; m < THUD_MEASURES; m++) {
        const struct thud_measure_info *info = thud_measure_info(m);
        struct thud_text item = {0};
        thud_text_append(&item, "%c%s, of %s", info->words[0] - 'a' + 'A', info->words + 1,
                         info->of_structure ? "each structure" : "the run");
        for (size_t i = 0; i < sizeof needs / sizeof *needs; i++)
            if (info->needs & 1u << i)
                thud_text_append(&item, "; only with %s", needs[i]);
        const char *before = ". In ";
        for (int d = 0; d < THUD_MEASURE_DOCUMENTS; d++) {
            if (info->place[d] == 0)
                continue;
            thud_text_append(&item, "%s%s", before, documents[d]);
            before = ", ";
        }
        if (info->event.word)
            thud_text_append(&item, ". Event %s%s%s", info->event.word, info->event.example ? ":" : "",
                             info->event.example ? info->event.example : "");
        thud_text_append(&item, ".");
        if (item.failed)
            out->failed = 1;
        else if (strstr(item.data, ". ")) /* told somewhere, or an event */
            thud_text_append(out, ".It Va %s\n", info->column), fill(out, item.data);
        thud_text_clear(&item);
    }
    thud_text_append(out, ".El\n");
}

/* A part of thud-output(5). */
static void put_schema(struct thud_text *out, const struct thud_schema *schema)
{
    thud_text_append(out, ".Ss %s\n%s.Bl -tag -width Ds -compact\n", schema->name, schema->about);
    for (int i = 0; i < schema->n; i++) {
        if (!schema->column[i].name[0])
            continue;
        thud_text_append(out, ".It Va %s\n", schema->column[i].name);
        fill(out, schema->column[i].help);
    }
    thud_text_append(out, ".El\n");
}

static const struct {
    const char *name;
    void (*write)(struct thud_text *out);
} parts[] = {{"units", units},   {"keys", keys},         {"laws", laws},       {"measures", measures},
             {"events", events}, {"criteria", criteria}, {"formats", formats}, {"gap rules", gap_rules}};
enum { PARTS = sizeof parts / sizeof *parts };

bool thud_manual_part(struct thud_text *out, const char *name)
{
    for (int i = 0; i < PARTS; i++) {
        if (strcmp(parts[i].name, name) == 0) {
            parts[i].write(out);
            return true;
        }
    }
    const struct thud_schema *schema;
    for (int i = 0; (schema = thud_schema_at(i)) != NULL; i++)
        if (strcmp(schema->name, name) == 0) {
            put_schema(out, schema);
            return true;
        }
    return false;
}

const char *thud_manual_part_name(int index)
{
    const struct thud_schema *schema = index < PARTS ? NULL : thud_schema_at(index - PARTS);
    return index < PARTS ? parts[index].name : schema ? schema->name : NULL;
}
