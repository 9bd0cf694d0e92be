/* What a study keeps of a point: the numbers of the point's own rows, in no more room than its floors and cases need.
 */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "app/sweep/sweep_collector.h"
#include "sweep_rows.h"
#include "towers.h"

enum { CASES = 3, FLOORS = 13, CONTACTS = 2, ROWS = 15 }; /* rows: a mean for each building */
static const int floors[] = {4, 0, 9};                    /* a wall between two buildings */

static struct thud_scene *scene;
static struct thud_sweep_plan *plan;
static struct thud_sweep_point point;
static struct thud_sweep_floor floor_numbers[THUD_SWEEP_VARIANTS * (CASES + 1) * FLOORS];
static struct thud_sweep_contact contact_numbers[THUD_SWEEP_VARIANTS * CASES * CONTACTS];
static struct thud_gap_level levels[CONTACTS];

/* The same numbers every time, all different. */
static double number(void)
{
    static uint32_t state = 1;
    state = state * 1664525u + 1013904223u;
    return 1 + state / 4294967296.0;
}

static void set_up(void)
{
    static const struct thud_record *const none[2] = {NULL, NULL};
    scene = malloc(sizeof *scene);
    plan = malloc(sizeof *plan);
    thud_test_towers(scene);
    thud_sweep_plan_init(plan, scene);
    plan->record = none;
    plan->nrecords = 2;
    ck_assert_int_eq(thud_sweep_vary(plan, "gap=5 cm,6 cm,7 cm", NULL), THUD_OK);
    ck_assert_int_eq(thud_sweep_vary(plan, "structures.2.damping=2 %,5 %", NULL), THUD_OK);
    ck_assert_int_eq(thud_sweep_cases(plan, "bumper,none,cavity", NULL), THUD_OK);
    for (size_t i = 0; i < sizeof floor_numbers / sizeof *floor_numbers; i++)
        floor_numbers[i] = (struct thud_sweep_floor){
            number(), number(), number(), i % 3 ? number() : (double)NAN, i % 2 ? number() : -number(), 1, 1, number()};
    for (size_t i = 0; i < sizeof contact_numbers / sizeof *contact_numbers; i++)
        contact_numbers[i] = (struct thud_sweep_contact){(int)(10 * number()), .force_n = number(),
                                                         .shear_lower_n = i % 3 ? number() : (double)NAN,
                                                         .shear_upper_n = number(), .capacity_ratio = NAN};
    for (int c = 0; c < CONTACTS; c++)
        levels[c] = (struct thud_gap_level){.interface = 1,
                                            .left_floor = c + 1,
                                            .right_floor = c + 1,
                                            .aligned = true,
                                            .left_m = number(),
                                            .right_m = number(),
                                            .relative_displacement_m = number(),
                                            .correlation = 0.5};
    point = (struct thud_sweep_point){.index = 11, /* second record, second damping, third gap */
                                      .gap_m = 0.07,
                                      .nstructures = 3,
                                      .nfloors = FLOORS,
                                      .ncontacts = CONTACTS,
                                      .ncases = CASES,
                                      .which = {THUD_CASE_BUMPER, THUD_CASE_NONE, THUD_CASE_CAVITY},
                                      .nvariants = 1,
                                      .floors = {floors[0], floors[1], floors[2]},
                                      .floor = floor_numbers,
                                      .contact = contact_numbers,
                                      .level = levels};
}

static void tear_down(void)
{
    thud_sweep_plan_clear(plan);
    free(plan);
    free(scene);
}

static const struct thud_sweep_row *row_of(const struct thud_sweep_row *row, int n, enum thud_case which, int structure,
                                           int floor)
{
    for (int i = 0; i < n; i++)
        if (row[i].which == which && row[i].structure == structure && row[i].floor == floor)
            return &row[i];
    return NULL;
}

static void same(const struct thud_sweep_ratio *x, double acceleration, double drift)
{
    ck_assert_ptr_nonnull(x);
    ck_assert(x->acceleration == acceleration && x->drift == drift);
}

/* Of the floors' rows, not of the means. */
static void check_storeys(const struct thud_sweep_summary *d, const struct thud_sweep_row *row, int n)
{
    for (int k = 0; k < d->nruns; k++)
        for (int s = 0; s < 3; s++) {
            double ductility = -1, permanent = -1;
            for (int i = 0; i < n; i++)
                if (row[i].which == d->which[k] && row[i].structure == s && row[i].floor > 0) {
                    ductility =
                        row[i].of[THUD_MEASURE_DUCTILITY] > ductility ? row[i].of[THUD_MEASURE_DUCTILITY] : ductility;
                    permanent = fmax(permanent, fabs(row[i].of[THUD_MEASURE_PERMANENT]));
                }
            const double own = *thud_sweep_summary_measure(d, k, THUD_MEASURE_DUCTILITY, s, THUD_SWEEP_VALUE),
                         left = *thud_sweep_summary_measure(d, k, THUD_MEASURE_PERMANENT, s, THUD_SWEEP_VALUE);
            ck_assert(ductility < 0 ? isnan(own) : own == ductility);
            ck_assert(permanent < 0 ? isnan(left) : left == permanent);
            if (d->spread)
                ck_assert(isnan(*thud_sweep_summary_measure(d, k, THUD_MEASURE_DUCTILITY, s, THUD_SWEEP_HIGH)));
        }
}

/* Of each row of the point, and of nothing else. */
static void check_rows(const struct thud_sweep_summary *d)
{
    struct thud_sweep_row row[CASES * ROWS];
    int n = sweep_rows(&point, row);
    bool spread = point.nvariants > 1;
    ck_assert_int_eq(d->nruns * d->nrows, n);
    check_storeys(d, row, n);
    for (int k = 0; k < d->nruns; k++)
        for (int s = 0; s < 3; s++)
            for (int f = 0; f <= 10; f++) {
                const struct thud_sweep_row *r = row_of(row, n, d->which[k], s, f);
                ck_assert_int_eq(r != NULL, thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_VALUE) != NULL);
                ck_assert_int_eq(r && spread, thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_HIGH) != NULL);
                if (!r)
                    continue;
                same(thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_VALUE), r->of[THUD_MEASURE_ACCELERATION_RATIO],
                     r->of[THUD_MEASURE_DRIFT_RATIO]);
                if (!spread)
                    continue;
                same(thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_LOW), r->low[THUD_MEASURE_ACCELERATION_RATIO],
                     r->low[THUD_MEASURE_DRIFT_RATIO]);
                same(thud_sweep_summary_ratio(d, k, s, f, THUD_SWEEP_HIGH), r->high[THUD_MEASURE_ACCELERATION_RATIO],
                     r->high[THUD_MEASURE_DRIFT_RATIO]);
            }
}

START_TEST(its_numbers_are_those_of_the_rows)
{
    for (int variants = 1; variants <= THUD_SWEEP_VARIANTS; variants += THUD_SWEEP_VARIANTS - 1) {
        struct thud_sweep_summary *d;
        point.nvariants = variants;
        ck_assert_int_eq(thud_sweep_summary_make(plan, &point, &d, NULL), THUD_OK);
        ck_assert_int_eq(d->record, 1);
        ck_assert_str_eq(plan->axis[0].key, "structures.2.damping");
        ck_assert(d->at[0] == 1 && d->at[1] == 2 && d->gap_m == 0.07 && d->has_contact);
        ck_assert(thud_sweep_summary_floors(d, 0) == 4 && thud_sweep_summary_floors(d, 1) == 0 &&
                  thud_sweep_summary_floors(d, 2) == 9);
        ck_assert_int_eq(thud_sweep_summary_find(d, THUD_CASE_AS_WRITTEN), -1);
        check_rows(d);
        for (int k = 0; k < CASES; k++) {
            const struct thud_sweep_contact *c = &contact_numbers[k * CONTACTS];
            ck_assert_int_eq(thud_sweep_summary_find(d, point.which[k]), k);
            ck_assert(*thud_sweep_summary_measure(d, k, THUD_MEASURE_IMPACTS, 0, THUD_SWEEP_VALUE) ==
                      c[0].impacts + c[1].impacts);
            ck_assert(*thud_sweep_summary_measure(d, k, THUD_MEASURE_FORCE, 0, THUD_SWEEP_VALUE) ==
                      fmax(c[0].force_n, c[1].force_n));
            ck_assert(*thud_sweep_summary_measure(d, k, THUD_MEASURE_SHEAR, 0, THUD_SWEEP_VALUE) ==
                      fmax(fmax(c[0].shear_lower_n, c[0].shear_upper_n), fmax(c[1].shear_lower_n, c[1].shear_upper_n)));
            ck_assert(isnan(thud_sweep_summary_value(d, k, THUD_MEASURE_COLUMNS, -1, THUD_SWEEP_VALUE)));
        }
        free(d);
    }
}
END_TEST

START_TEST(cases_without_an_answer_take_no_room)
{
    struct thud_sweep_summary *d;
    point.effort[0].status = THUD_DIVERGED;
    point.effort[2].reference = true;
    ck_assert_int_eq(thud_sweep_summary_make(plan, &point, &d, NULL), THUD_OK);
    ck_assert_int_eq(d->nruns, 1);
    check_rows(d);
    /* the contacts of the one that is left, not of the first */
    ck_assert(*thud_sweep_summary_measure(d, 0, THUD_MEASURE_IMPACTS, 0, THUD_SWEEP_VALUE) ==
              contact_numbers[CONTACTS].impacts + contact_numbers[CONTACTS + 1].impacts);
    free(d);
    point.effort[1].status = THUD_INPUT;
    ck_assert_int_eq(thud_sweep_summary_make(plan, &point, &d, NULL), THUD_OK);
    ck_assert_ptr_null(d);
}
END_TEST

/* A floor takes four numbers, with a spread twelve, a run four and five for each structure, with a spread three times
 * as many; whatever the most is that a scene may have. */
START_TEST(the_room_is_what_the_scene_needs)
{
    const size_t number = sizeof(double);
    for (int spread = 0; spread < 2; spread++) {
        size_t each = (spread ? 12 : 4) * number, one = thud_sweep_summary_size(1, 1, 2, spread);
        ck_assert_uint_eq(thud_sweep_summary_size(1, 1, 3, spread) - one, each);
        ck_assert_uint_le(thud_sweep_summary_size(2, 1, 2, spread) - one, 5 * each);
        ck_assert_uint_le(thud_sweep_summary_size(1, 2, 2, spread) - one, each * 5 / 4 + number);
        ck_assert_uint_le(one, 4 * each + 21 * number);
    }
    /* the towers, 4 and 6 floors: 10 floors and 2 means */
    ck_assert_uint_le(thud_sweep_summary_size(2, 2, 12, false) / 2, 552);
}
END_TEST

START_TEST(it_ends_where_its_size_says)
{
    for (int runs = 1; runs <= 3; runs++)
        for (int spread = 0; spread < 2; spread++) {
            struct thud_sweep_summary *d = thud_sweep_summary_create(runs, 3, floors, spread);
            size_t size = thud_sweep_summary_size(runs, 3, ROWS, spread);
            ck_assert_ptr_nonnull(d);
            ck_assert_uint_eq((size_t)((char *)(d->first + 4) - (char *)d), size);
            ck_assert_int_eq(d->first[3], ROWS);
            ck_assert_ptr_eq(d->ratio + runs * ROWS * (spread ? 3 : 1), (void *)d->measure);
            ck_assert_ptr_eq(d->measure + runs * d->nmeasures * (spread ? 3 : 1), (void *)d->which);
            ck_assert_ptr_eq(d->which + runs, (void *)d->first);
            for (enum thud_measure m = 0; m < THUD_MEASURES; m++)
                if (thud_measure_info(m)->place[THUD_TOLD_BY_SWEEP])
                    ck_assert(
                        thud_sweep_summary_measure(d, runs - 1, m, 2, spread ? THUD_SWEEP_HIGH : THUD_SWEEP_VALUE) <
                        (double *)(void *)d->which);
            free(d);
        }
}
END_TEST

/* Points in their order, rows counted, and of the gaps needed the widest of each record. */
START_TEST(a_collector_keeps_points_and_the_widest_need)
{
    const char *const names[] = {"one", "two"};
    struct thud_sweep_collector c;
    double widest[2] = {0, 0};
    thud_sweep_collector_init(&c, plan, names);
    for (point.index = 0; point.index < 12; point.index++) {
        if (point.index % 3 == 0) /* another motion without pounding */
            for (int i = 0; i < CONTACTS; i++) {
                levels[i].relative_displacement_m = number();
                widest[point.index / 6] = fmax(widest[point.index / 6], levels[i].relative_displacement_m);
            }
        ck_assert_int_eq(thud_sweep_collector_add(&c, plan, &point, NULL), THUD_OK);
    }
    ck_assert_uint_eq(c.table.npoints, 12);
    ck_assert_uint_eq(c.table.nrows, 12 * CASES * ROWS);
    for (size_t i = 0; i < 12; i++) {
        const struct thud_sweep_summary *d = c.table.point[i];
        ck_assert_uint_eq((size_t)((d->record * 2 + d->at[0]) * 3 + d->at[1]), i);
    }
    for (int r = 0; r < 2; r++) {
        ck_assert_int_eq(c.table.need[r].record, r);
        ck_assert(c.table.need[r].level.interface == 1 && c.table.need[r].level.relative_displacement_m == widest[r]);
    }
    thud_sweep_collector_clear(&c);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("sweep_table");
    TCase *tcase = tcase_create("sweep_table");
    tcase_add_checked_fixture(tcase, set_up, tear_down);
    tcase_add_test(tcase, its_numbers_are_those_of_the_rows);
    tcase_add_test(tcase, cases_without_an_answer_take_no_room);
    tcase_add_test(tcase, the_room_is_what_the_scene_needs);
    tcase_add_test(tcase, it_ends_where_its_size_says);
    tcase_add_test(tcase, a_collector_keeps_points_and_the_widest_need);
    suite_add_tcase(suite, tcase);
    return suite;
}
