/* thud-model(7) against the program: the restitutions it prints are those that two bodies part with in a run. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/scene/two_body.h"

static char page[256 * 1024];

static void read_page(void)
{
    FILE *file = fopen("man/thud-model.7", "r");
    ck_assert_ptr_nonnull(file);
    page[fread(page, 1, sizeof page - 1, file)] = '\0';
    fclose(file);
}

static double parted(const char *law, const char *choice, int index, double e, double approach_mps)
{
    struct thud_two_body pair;
    struct thud_solution solution;
    thud_two_body_rubber(&pair);
    if (strcmp(law, "rubber") != 0) {
        pair.law = thud_law_find(law);
        thud_law_defaults(pair.law, &pair.setup);
    }
    if (choice)
        thud_two_body_set(&pair, choice, index);
    thud_two_body_set(&pair, "restitution", e);
    pair.approach_mps = approach_mps;
    pair.duration_s = fmax(2, 0.05 / approach_mps);
    ck_assert_int_eq(thud_two_body_run(&pair, pair.duration_s, &solution, NULL), THUD_OK);
    double found = thud_two_body_separation(&solution) / approach_mps;
    thud_solution_clear(&solution);
    return found;
}

/* Whether `found` is what a number printed as `text` stands for: half a unit of its last digit on either side. */
static void check_printed(const char *what, const char *text, double found)
{
    const char *point = strchr(text, '.');
    ck_assert_ptr_nonnull(point);
    int digits = (int)strspn(point + 1, "0123456789");
    double half = 0.5 * pow(10, -digits);
    ck_assert_msg(fabs(found - strtod(text, NULL)) <= half * (1 + 1e-9), "%s: printed %.*s, obtained %.6f", what,
                  digits + 2, text, found);
}

/* The rows `.It e Ta ...`, in the order of the heading's columns. */
START_TEST(table_of_restitutions)
{
    static const struct {
        const char *heading, *law, *choice;
        int index;
    } column[] = {{"\"no tension\"", "kelvin-voigt-no-tension", NULL, 0},
                  {"\"Hunt-Cr.\"", "hertz-damp", "formula", 1},
                  {"\"hertz-damp\"", "hertz-damp", "formula", 0},
                  {"\"Ye, Flores\"", "hertz-damp", "formula", 2},
                  {"jankowski", "jankowski", NULL, 0}};
    enum { COLUMNS = sizeof column / sizeof *column };
    int rows = 0;
    read_page();
    const char *at = strstr(page, ".It nominal Ta");
    ck_assert_ptr_nonnull(at);
    for (int i = 0; i < COLUMNS; i++) {
        at = strstr(at, "Ta ");
        ck_assert_ptr_nonnull(at);
        ck_assert_msg(strncmp(at += 3, column[i].heading, strlen(column[i].heading)) == 0, "column %d: %.20s", i, at);
    }
    while ((at = strchr(at, '\n')) != NULL && strncmp(at, "\n.It ", 5) == 0) {
        double e = strtod(at + 5, NULL);
        for (int i = 0; i < COLUMNS; i++) {
            at = strstr(at, "Ta ");
            ck_assert_ptr_nonnull(at);
            check_printed(column[i].heading, at += 3, parted(column[i].law, column[i].choice, column[i].index, e, 0.5));
        }
        rows++;
    }
    ck_assert_int_eq(rows, 4);
}
END_TEST

/* "e = 0.5 gives 0.5018 at 1 m/s, ... and 0.563 at 1 mm/s", the speeds as people write them. */
START_TEST(bumper_by_its_printed_damping)
{
    read_page();
    const char *at = strstr(page, "with the printed damping and e = 0.5 gives"),
               *end = at ? strstr(at, " between") : NULL;
    int found = 0;
    ck_assert_ptr_nonnull(end);
    while ((at = strstr(at + 1, " at ")) != NULL && at < end) {
        const char *number = at;
        while (strchr("0123456789.", number[-1]))
            number--;
        char *unit;
        double speed = strtod(at + 4, &unit);
        speed *= strncmp(unit, " mm/s", 5) == 0 ? 1e-3 : strncmp(unit, " cm/s", 5) == 0 ? 1e-2 : 1;
        check_printed("rubber", number, parted("rubber", NULL, 0, 0.5, speed));
        found++;
    }
    ck_assert_int_eq(found, 4);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("manual of the model");
    TCase *tests = tcase_create("numbers");
    tcase_add_test(tests, table_of_restitutions);
    tcase_add_test(tests, bumper_by_its_printed_damping);
    suite_add_tcase(suite, tests);
    return suite;
}
