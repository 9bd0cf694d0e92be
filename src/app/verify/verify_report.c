/* Verifications as text and rows. */
#include <math.h>
#include <string.h>

#include "app/verify/verify_preset.h"
#include "io/result/list_rows.h"

static bool is_old(const struct thud_verification *v, const struct thud_expectation *fresh)
{
    for (size_t i = 0; i < v->expected.n; i++)
        if (v->expected.item[i].which == fresh->which && strcmp(v->expected.item[i].name, fresh->name) == 0)
            return true;
    return false;
}

/* Widths of the first two columns. */
struct widths {
    int which, name;
};

static void widen(struct widths *w, const struct thud_expectations *of)
{
    for (size_t i = 0; i < of->n; i++) {
        w->which = thud_text_wider(w->which, thud_case_name(of->item[i].which));
        w->name = thud_text_wider(w->name, of->item[i].name);
    }
}

static struct widths widths_of(const struct thud_verification *v)
{
    struct widths w = {4, 8};
    widen(&w, &v->expected);
    widen(&w, &v->fresh);
    widen(&w, &v->disputed);
    return w;
}

static void add_name(const struct widths *w, const struct thud_expectation *e, struct thud_text *out)
{
    thud_text_append(out, " %-*s ", w->which, thud_case_name(e->which));
    thud_text_padded(out, e->name, w->name);
}

static void add_row(const struct widths *w, const struct thud_expectation *e, const struct thud_check *check,
                    struct thud_text *out)
{
    add_name(w, e, out);
    if (check->verdict == THUD_GONE)
        thud_text_append(out, " %11.6g %11s %8s %5.1g gone\n", e->value, "-", "-", e->tolerance);
    else
        thud_text_append(out, " %11.6g %11.6g %+8.2g %5.1g %s\n", e->value, check->got, check->change, e->tolerance,
                         thud_check_verdict_name(check->verdict));
}

static void add_checks(const struct thud_verification *v, bool holding, struct thud_text *out)
{
    const struct widths w = widths_of(v);
    thud_text_append(out, " %-*s %-*s %11s %11s %8s %5s\n", w.which, "case", w.name, "quantity", "expected", "now",
                     "change", "limit");
    for (size_t i = 0; i < v->expected.n; i++)
        if (holding || v->check[i].verdict != THUD_HOLDS)
            add_row(&w, &v->expected.item[i], &v->check[i], out);
}

/* What the new file says beside the old one: what comes in, what is left out. */
static void add_update(const struct thud_verification *v, struct thud_text *out)
{
    const struct widths w = widths_of(v);
    size_t added = 0;
    for (size_t i = 0; i < v->fresh.n; i++) {
        const struct thud_expectation *e = &v->fresh.item[i];
        if (is_old(v, e))
            continue;
        added++;
        if (v->expected.n == 0)
            continue;
        add_name(&w, e, out);
        thud_text_append(out, " %11s %11.6g %8s %5.1g new\n", "-", e->value, "-", e->tolerance);
    }
    for (size_t i = 0; i < v->disputed.n; i++) {
        const struct thud_expectation *e = &v->disputed.item[i];
        add_name(&w, e, out);
        thud_text_append(out, " left out: %.7g; independent: %.7g\n", e->value, e->other);
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

/* The rows of a verification. */
static void make_check(const void *of, int i, void *out)
{
    const struct thud_verification *v = of;
    const struct thud_expectation *e = &v->expected.item[i];
    const struct thud_check *check = &v->check[i];
    *(struct thud_check_row *)out = (struct thud_check_row){thud_case_name(e->which),
                                                            e->name,
                                                            e->value,
                                                            e->tolerance,
                                                            check->got,
                                                            check->change,
                                                            thud_check_verdict_name(check->verdict)};
}

static void make_fresh(const void *of, int i, void *out)
{
    const struct thud_expectation *e = &((const struct thud_expectations *)of)->item[i];
    *(struct thud_fresh_row *)out = (struct thud_fresh_row){thud_case_name(e->which), e->name, e->value, e->tolerance,
                                                            isnan(e->other) ? e->value : e->other};
}

void thud_verify_add(const struct thud_verification *v, struct thud_list *list)
{
    const struct thud_verified_row row = {
        v->name, v->path, v->cases, v->count[THUD_HOLDS], v->count[THUD_MOVED], v->count[THUD_GONE]};
    const struct thud_nested nested[] = {
        {"checks", {&thud_check_schema, 0, (int)v->expected.n, make_check, v}},
        {"new", {&thud_fresh_schema, 0, (int)v->fresh.n, make_fresh, &v->fresh}},
        {"left_out", {&thud_fresh_schema, 0, (int)v->disputed.n, make_fresh, &v->disputed}}};
    thud_list_add(list, &row, nested, v->update ? 3 : 1);
}
