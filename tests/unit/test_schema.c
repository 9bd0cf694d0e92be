/* Tables of columns: what one line of a table says comes out in every form, and no number runs into the one before it. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "io/file/schema.h"

struct row {
    const char *name;
    double ratio, force_n;
    int count;
};
static const struct thud_column columns[] = {
    {THUD_COLUMN(struct row, name, "name", "Its name."), .shown = {"name", NULL, 0, -6, 0, THUD_DIGITS_WORD}},
    {THUD_COLUMN(struct row, ratio, "ratio", "A ratio."), .shown = {"ratio", NULL, 1, 7, 4, THUD_DIGITS_FIXED}},
    {THUD_COLUMN(struct row, force_n, "force_n", "A force, N."),
     .shown = {"force", "MN", 1e-6, 8, 5, THUD_DIGITS_PLACES}},
    {THUD_COLUMN(struct row, count, "count", "How many."), .shown = {"count", NULL, 0, 6, 0, THUD_DIGITS_WORD}}};
static const struct thud_schema schema = THUD_SCHEMA("rows", "", columns);

static const struct row rows[] = {
    {"a", 0.5496, 1.5e6, 3}, {"b", 3757, -2e6, THUD_NO_COUNT}, {"c", 12345678, 0, 0}, {"d", -0.7, NAN, 1}};
enum { ROWS = sizeof rows / sizeof *rows };

static void make(const void *of, int i, void *row)
{
    *(struct row *)row = ((const struct row *)of)[i];
}
static const struct thud_rows all = {&schema, 0, ROWS, make, rows};

/* Every line has as many words as there are columns, however large a number is, and they read back to 1 %. */
START_TEST(no_number_runs_into_another)
{
    struct thud_text out = {0};
    thud_rows_table(&all, &out);
    char *rest = out.data, *line = strtok_r(rest, "\n", &rest), name[8], force[16], count[8];
    ck_assert_str_eq(line, "name    ratio   force count");
    strtok_r(rest, "\n", &rest);
    for (int i = 0; i < ROWS; i++) {
        double ratio;
        line = strtok_r(rest, "\n", &rest);
        ck_assert_int_eq(sscanf(line, "%7s %lf %15s %7s", name, &ratio, force, count), 4);
        ck_assert_str_eq(name, rows[i].name);
        ck_assert_double_le(fabs(ratio - rows[i].ratio), 0.03 * fabs(rows[i].ratio));
    }
    ck_assert_ptr_null(strtok_r(rest, "\n", &rest));
    thud_text_clear(&out);
}
END_TEST

/* The names of a table, and no others, head the CSV and name the members of each object; no value is an empty cell, and
 * null. */
START_TEST(one_line_of_a_table_is_in_every_form)
{
    struct thud_text csv = {0}, json = {0};
    thud_rows_csv(&all, &csv);
    thud_rows_json(&all, &json);
    ck_assert_str_eq(csv.data,
                     "name,ratio,force_n,count\na,0.5496,1500000,3\nb,3757,-2000000,\nc,12345678,0,0\nd,-0.7,,1\n");
    ck_assert_str_eq(json.data, "[\n    {\"name\": \"a\", \"ratio\": 0.5496, \"force_n\": 1500000, \"count\": 3},"
                                "\n    {\"name\": \"b\", \"ratio\": 3757, \"force_n\": -2000000, \"count\": null},"
                                "\n    {\"name\": \"c\", \"ratio\": 12345678, \"force_n\": 0, \"count\": 0},"
                                "\n    {\"name\": \"d\", \"ratio\": -0.7, \"force_n\": null, \"count\": 1}]");
    thud_text_clear(&csv);
    thud_text_clear(&json);
}
END_TEST

struct wide {
    const char *name;
    double value[12];
};

static void make_wide(const void *of, int i, void *out)
{
    static const char *const name[] = {"short", "a name that would push all numbers of its row out of the terminal"};
    struct wide *row = out;
    (void)of;
    row->name = name[i];
    for (int k = 0; k < 12; k++)
        row->value[k] = 100 * (i + 1) + k;
}

/* A table of twelve numbers is in blocks of 80 columns, each behind the name: every number is there once. */
START_TEST(what_is_wider_than_a_line_follows)
{
    enum { N = 12 };
    struct thud_column column[N + 1] = {
        {THUD_COLUMN(struct wide, name, "", ""), .shown = {"name", NULL, 0, -5, 0, THUD_DIGITS_WORD}}};
    struct thud_schema broad = {"", "", column, N + 1};
    struct thud_text out = {0};
    for (int k = 0; k < N; k++)
        column[k + 1] = (struct thud_column){THUD_COLUMN(struct wide, value[k], "", ""),
                                             .shown = {"a head", NULL, 1, 20, 4, THUD_DIGITS_FREE}};
    thud_rows_table(&(struct thud_rows){&broad, 0, 2, make_wide, NULL}, &out);
    int blocks = 0;
    for (const char *at = out.data; (at = strstr(at, "name ")) != NULL; at++)
        blocks += at == out.data || at[-1] == '\n';
    ck_assert_int_gt(blocks, 1);
    for (int i = 0; i < 2 * N; i++) {
        char number[8];
        snprintf(number, sizeof number, " %d", 100 * (i / N + 1) + i % N);
        const char *first = strstr(out.data, number);
        ck_assert_msg(first && !strstr(first + 1, number), "%s", number);
    }
    for (char *rest = out.data, *line; (line = strtok_r(rest, "\n", &rest)) != NULL;)
        ck_assert_msg(strlen(line) <= 80, "%s", line);
    thud_text_clear(&out);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("schema");
    TCase *tcase = tcase_create("schema");
    tcase_add_test(tcase, no_number_runs_into_another);
    tcase_add_test(tcase, one_line_of_a_table_is_in_every_form);
    tcase_add_test(tcase, what_is_wider_than_a_line_follows);
    suite_add_tcase(suite, tcase);
    return suite;
}
