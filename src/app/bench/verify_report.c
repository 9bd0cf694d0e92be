/* Verifications as text and JSON. */
#include <math.h>
#include <string.h>

#include "app/bench/verify_preset.h"
#include "io/file/json.h"

static bool is_old(const struct thud_verification *v, const struct thud_expectation *fresh)
{
    for (size_t i = 0; i < v->expected.n; i++)
        if (v->expected.item[i].which == fresh->which && strcmp(v->expected.item[i].name, fresh->name) == 0)
            return true;
    return false;
}

static void add_row(const struct thud_expectation *e, const struct thud_check *check, struct thud_text *out)
{
    thud_text_append(out, "  %-10s %-34s %14.7g ", thud_case_name(e->which), e->name, e->value);
    if (check->verdict == THUD_GONE)
        thud_text_append(out, "%14s %10s %8.1g  gone\n", "-", "-", e->tolerance);
    else
        thud_text_append(out, "%14.7g %+10.2g %8.1g  %s\n", check->got, check->change, e->tolerance,
                         thud_check_verdict_name(check->verdict));
}

static void add_checks(const struct thud_verification *v, bool holding, struct thud_text *out)
{
    thud_text_append(out, "  %-10s %-34s %14s %14s %10s %8s\n", "case", "quantity", "expected", "now", "change",
                     "allowed");
    for (size_t i = 0; i < v->expected.n; i++)
        if (holding || v->check[i].verdict != THUD_HOLDS)
            add_row(&v->expected.item[i], &v->check[i], out);
}

/* What the new file says beside the old one: what comes in, what is left out. */
static void add_update(const struct thud_verification *v, struct thud_text *out)
{
    size_t added = 0;
    for (size_t i = 0; i < v->fresh.n; i++) {
        const struct thud_expectation *e = &v->fresh.item[i];
        if (is_old(v, e))
            continue;
        added++;
        if (v->expected.n > 0)
            thud_text_append(out, "  %-10s %-34s %14s %14.7g %10s %8.1g  new\n", thud_case_name(e->which), e->name, "-",
                             e->value, "-", e->tolerance);
    }
    for (size_t i = 0; i < v->disputed.n; i++) {
        const struct thud_expectation *e = &v->disputed.item[i];
        thud_text_append(out, "  %-10s %-34s left out: %.7g, by the independent method %.7g\n",
                         thud_case_name(e->which), e->name, e->value, e->other);
    }
    thud_text_append(out, "  new file: %zu expectations, %zu of them new, %zu left out\n", v->fresh.n, added,
                     v->disputed.n);
}

void thud_verify_table(const struct thud_verification *v, bool all, struct thud_text *out)
{
    int moved = v->count[THUD_MOVED], gone = v->count[THUD_GONE];
    if (v->expected.n > 0) {
        thud_text_append(out, "%s: %d hold, %d moved", v->name, v->count[THUD_HOLDS], moved);
        if (gone > 0)
            thud_text_append(out, ", %d gone", gone);
        thud_text_append(out, " (%d case%s)\n", v->cases, v->cases == 1 ? "" : "s");
        if (moved + gone > 0 || all)
            add_checks(v, moved + gone == 0, out);
    } else {
        thud_text_append(out, "%s: no expectations yet (%d case%s)\n", v->name, v->cases, v->cases == 1 ? "" : "s");
    }
    if (v->update)
        add_update(v, out);
}

static void json_list(const char *key, const struct thud_expectations *list, struct thud_text *out)
{
    thud_text_append(out, ", \"%s\": [", key);
    for (size_t i = 0; i < list->n; i++) {
        const struct thud_expectation *e = &list->item[i];
        thud_text_append(out, "%s\n    {\"case\": \"%s\", \"quantity\": ", i > 0 ? "," : "", thud_case_name(e->which));
        thud_json_string(out, e->name);
        thud_text_append(out, ", ");
        thud_json_field(out, "value", e->value);
        thud_text_append(out, ", ");
        thud_json_field(out, "tolerance", e->tolerance);
        thud_text_append(out, ", ");
        thud_json_field(out, "independent", isnan(e->other) ? e->value : e->other);
        thud_text_append(out, "}");
    }
    thud_text_append(out, "]");
}

void thud_verify_json(const struct thud_verification *v, struct thud_text *out)
{
    thud_text_append(out, "{\"preset\": ");
    thud_json_string(out, v->name);
    thud_text_append(out, ", \"expectations\": ");
    thud_json_string(out, v->path);
    thud_text_append(out, ", \"cases\": %d, \"holds\": %d, \"moved\": %d, \"gone\": %d, \"checks\": [", v->cases,
                     v->count[THUD_HOLDS], v->count[THUD_MOVED], v->count[THUD_GONE]);
    for (size_t i = 0; i < v->expected.n; i++) {
        const struct thud_expectation *e = &v->expected.item[i];
        thud_text_append(out, "%s\n    {\"case\": \"%s\", \"quantity\": ", i > 0 ? "," : "", thud_case_name(e->which));
        thud_json_string(out, e->name);
        const struct {
            const char *key;
            double value;
        } field[] = {{"expected", e->value},
                     {"tolerance", e->tolerance},
                     {"now", v->check[i].got},
                     {"change", v->check[i].change}};
        for (size_t k = 0; k < sizeof field / sizeof *field; k++) {
            thud_text_append(out, ", ");
            thud_json_field(out, field[k].key, field[k].value);
        }
        thud_text_append(out, ", \"verdict\": \"%s\"}", thud_check_verdict_name(v->check[i].verdict));
    }
    thud_text_append(out, "]");
    if (v->update) {
        json_list("new", &v->fresh, out);
        json_list("left_out", &v->disputed, out);
    }
    thud_text_append(out, "}");
}
