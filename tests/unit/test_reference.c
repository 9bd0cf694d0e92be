/* Peaks of the towers under the shipped surrogates, against those of an independent solver (Runge-Kutta of order 4 at
 * 1e-5 s with bisected events, good to 1e-5): tests/data/reference-surrogates.csv. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "io/record/record_file.h"
#include "study/scene/solution.h"
#include "suite.h"
#include "towers.h"

static const char reference[] = "tests/data/reference-surrogates.csv";

static const struct {
    const char *name;
    double peak_g;
} motions[] = {{"kobe-surrogate", 0.821}, {"northridge-surrogate", 0.897}, {"san-fernando-surrogate", 1.170}};

enum { GAPS = 4, CASES = 3, FLOORS = 10 };

struct row {
    char record[40], which[16];
    char structure;
    int floor;
    double gap_m, acceleration_mps2, drift_m, force_n, residual_m;
};

/* The next row of the table, or false at its end. */
static bool next_row(FILE *file, struct row *row)
{
    char line[256];
    while (fgets(line, sizeof line, file)) {
        if (*line == '#' || strncmp(line, "record,", strlen("record,")) == 0)
            continue;
        /* there is no contact at the upper two floors of the taller tower */
        row->force_n = row->residual_m = 0;
        int n = sscanf(line, "%39[^,],%lf,%15[^,],%c,%d,%lf,%lf,%lf,%lf", row->record, &row->gap_m, row->which,
                       &row->structure, &row->floor, &row->acceleration_mps2, &row->drift_m, &row->force_n,
                       &row->residual_m);
        ck_assert_msg(n >= 7, "%s", line);
        return true;
    }
    return false;
}

static void solution(const struct row *row, const struct thud_record *record, struct thud_solution *out)
{
    static struct thud_scene scene, one;
    struct thud_error err = {0};
    enum thud_case which;
    thud_test_towers(&scene);
    scene.interface[0].gap_m = row->gap_m;
    ck_assert_int_eq(thud_case_find(row->which, &which, &err), THUD_OK);
    ck_assert_int_eq(thud_scene_case(&scene, which, &one, &err), THUD_OK);
    ck_assert_msg(thud_scene_solve(&one, record, NULL, out, &err) == THUD_OK, "%s", err.what);
}

static void near(double value, double expected, const char *what, const struct row *row)
{
    double apart = expected == 0 ? fabs(value) : fabs(value / expected - 1);
    ck_assert_msg(apart < 1e-5, "%s, gap %g m, %s, %c %d: %s %.9g, not %.9g (%.1e)", row->record, row->gap_m,
                  row->which, row->structure, row->floor, what, value, expected, apart);
}

START_TEST(peaks_of_the_towers)
{
    struct thud_record_choice choice;
    struct thud_record *record;
    struct thud_error err = {0};
    struct row row, of = {0};
    struct thud_solution out = {0};
    char path[80];
    int rows = 0, runs = 0;
    thud_record_choice_init(&choice);
    snprintf(path, sizeof path, "records/%s.csv", motions[_i].name);
    ck_assert_msg(thud_record_file_read(path, &choice, &record, &err) == THUD_OK, "%s", err.what);
    thud_record_scale(record, motions[_i].peak_g * THUD_GRAVITY / thud_record_peak(record));
    FILE *file = fopen(reference, "r");
    ck_assert_ptr_nonnull(file);
    while (next_row(file, &row)) {
        if (strcmp(row.record, motions[_i].name) != 0)
            continue;
        if (runs == 0 || row.gap_m != of.gap_m || strcmp(row.which, of.which) != 0) {
            thud_solution_clear(&out);
            solution(&row, record, &out);
            of = row;
            runs++;
        }
        const struct thud_result *r = thud_run_result(out.run);
        const struct thud_floor_result *f = &r->structure[row.structure - 'A'].floor[row.floor - 1];
        near(f->acceleration.value, row.acceleration_mps2, "acceleration", &row);
        near(f->drift.value, row.drift_m, "drift", &row);
        if (row.structure == 'A') {
            near(r->contact[row.floor - 1].force.value, row.force_n, "force", &row);
            near(r->contact[row.floor - 1].residual_m, row.residual_m, "residual", &row);
        }
        rows++;
    }
    fclose(file);
    ck_assert_int_eq(runs, GAPS * CASES);
    ck_assert_int_eq(rows, GAPS * CASES * FLOORS);
    thud_solution_clear(&out);
    thud_record_free(record);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("reference");
    TCase *towers = tcase_create("towers");
    tcase_add_loop_test(towers, peaks_of_the_towers, 0, (int)(sizeof motions / sizeof *motions));
    suite_add_tcase(suite, towers);
    return suite;
}
