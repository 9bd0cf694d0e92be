/* What makes the exact method fast: each shortcut against the plain way. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/numerics/poly.h"
#include "core/run/run_private.h"
#include "march.h"

static const int towers[] = {4, 6};

static struct march_law rubber(void)
{
    return march_law("rubber", "stiffness", 0.36e3 * pow(1000, 2.65), "thickness", 0.05, NULL);
}

static double random_part(void)
{
    return 2.0 * rand() / RAND_MAX - 1;
}

/* Peaks so far of one quantity of one floor, all others out of reach. */
static void set_peaks(struct thud_run *run, int floor, int quantity, double value)
{
    for (int i = 0; i < towers[1]; i++)
        for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++)
            thud_floor_peak(&run->result, 1, i, x)->value = i == floor && x == quantity ? value : INFINITY;
}

/* The state of energy 1/2 in which one floor's value is largest reaches the bound of it, and no other state passes it.
 */
START_TEST(no_state_passes_what_its_energy_allows)
{
    struct march_law law = rubber();
    struct thud_model *model = march_row(2, towers, false, 0.1, &law);
    struct march m = march_run(model, NULL, "exact", 0, 0, true, 0.01);
    const struct thud_model_structure *p = &model->structure[1];
    srand(2);
    for (int floor = 0; floor < towers[1]; floor++)
        for (int x = 0; x < THUD_FLOOR_QUANTITIES; x++) {
            double part[MARCH_FLOORS_MAX], best = 0, norm = 0;
            for (int j = 0; j < p->modes; j++) { /* value = sum part[j] e[j], e the modal speeds, sum e^2 = 1 */
                double w = model->omega[p->first_mode + j], z = model->zeta[p->first_mode + j],
                       a = p->phi[floor * p->modes + j];
                double below = floor > 0 ? p->phi[(floor - 1) * p->modes + j] : 0;
                part[j] = x == THUD_FLOOR_DISPLACEMENT   ? a / w
                          : x == THUD_FLOOR_VELOCITY     ? a
                          : x == THUD_FLOOR_ACCELERATION ? a * w * sqrt(1 + 4 * z * z)
                                                         : (a - below) / w;
                norm += part[j] * part[j];
            }
            for (int trial = 0; trial < 200; trial++) {
                double e[MARCH_FLOORS_MAX], size = 0, value = 0;
                for (int j = 0; j < p->modes; j++) {
                    e[j] = trial == 0 ? part[j] : random_part();
                    size += e[j] * e[j];
                    value += part[j] * e[j];
                }
                best = fmax(best, fabs(value) / sqrt(size));
            }
            ck_assert_double_eq_tol(best / sqrt(norm), 1, 1e-12);
            set_peaks(m.run, floor, x, best * (1 + 1e-9));
            ck_assert(!thud_response_bound_structure(&m.run->peaks, m.run->state.model, 1, 1));
            m.run->peaks.quiet[1] = 0; /* else a peak never falls */
            set_peaks(m.run, floor, x, best * (1 - 1e-9));
            ck_assert(thud_response_bound_structure(&m.run->peaks, m.run->state.model, 1, 1));
            m.run->peaks.quiet[1] = 0;
        }
    march_free(&m);
    thud_model_free(model);
}
END_TEST

static struct thud_result *sliced(const struct thud_model *model, const struct thud_record *record, long budget,
                                  struct thud_run **run)
{
    struct thud_run_options options;
    bool done = false;
    thud_run_options_init(&options);
    ck_assert_int_eq(thud_run_create(model, record, &options, run, NULL), THUD_OK);
    while (!done)
        ck_assert_int_eq(thud_run_advance(*run, budget, &done, NULL), THUD_OK);
    return &(*run)->result;
}

/* Peaks are read late; to ask for them in between changes nothing. */
START_TEST(slices_change_no_bit)
{
    struct thud_record *record = march_motion(1.5);
    struct march_law law = rubber();
    struct thud_model *model = march_row(2, towers, false, 0.03, &law);
    struct thud_run *whole, *by_one;
    const struct thud_result *a = sliced(model, record, 1L << 40, &whole), *b = sliced(model, record, 1, &by_one);
    ck_assert_int_gt(a->contact[3].impacts, 0);
    for (int s = 0; s < 2; s++)
        ck_assert_mem_eq(a->structure[s].floor, b->structure[s].floor,
                         (size_t)towers[s] * sizeof *a->structure[s].floor);
    ck_assert_mem_eq(whole->state.q, by_one->state.q, (size_t)model->nmodes * sizeof(double));
    thud_run_free(whole);
    thud_run_free(by_one);
    thud_model_free(model);
    thud_record_free(record);
}
END_TEST

/* An isolated building whose base slab alone meets the wall of its moat: damping couples the modes, and there is one
 * contact. */
START_TEST(coupled_modes_and_one_contact)
{
    const double mass[] = {320e3, 320e3, 250e3}, stiffness[] = {890e3 * 9.87, 6e8, 6e8};
    struct march_law law = rubber();
    struct thud_structure_input s[2] = {{.n = 3,
                                         .mass_kg = mass,
                                         .stiffness_npm = stiffness,
                                         .damping = 0.05,
                                         .isolated = true,
                                         .isolation_damping = 0.1},
                                        {.n = 0}};
    struct thud_contact_input contact = {.interface = 1,
                                         .left_floor = 1,
                                         .left_structure = 0,
                                         .right_structure = 1,
                                         .clearance_m = 0.05,
                                         .law = law.law,
                                         .setup = law.setup};
    struct thud_model *model;
    ck_assert_int_eq(
        thud_model_create(
            &(struct thud_model_input){.nstructures = 2, .structure = s, .ncontacts = 1, .contact = &contact}, &model,
            NULL),
        THUD_OK);
    struct thud_record *record = march_motion(1.5);
    struct march a = march_run(model, record, "exact", 0, 1e-9, true, 2);
    struct march b = march_run(model, record, "dormand-prince", 0, 1e-11, true, 2);
    ck_assert_int_eq(a.status, THUD_OK);
    ck_assert_int_gt(a.result->contact[0].impacts, 0);
    ck_assert_double_lt(march_peaks_apart(a.result, b.result, 0.01), 1e-7);
    march_free(&a);
    march_free(&b);
    thud_record_free(record);
    thud_model_free(model);
}
END_TEST

/* The start of an indentation as the segment reads it and as the state does: were they apart by rounding, a contact at rest
 * could be open by one and closed by the other, and would switch without end. */
START_TEST(an_indentation_starts_with_the_same_bits_both_ways)
{
    const int storeys[] = {_i + 1, 9 - _i};
    struct march_law law = rubber();
    struct thud_model *model = march_row(2, storeys, false, 0.1, &law);
    struct march m = march_run(model, NULL, "exact", 0, 0, true, 0.01);
    struct thud_state *state = &m.run->state;
    struct thud_segment seg;
    double d[THUD_SEGMENT_TERMS];
    ck_assert_int_eq(thud_segment_init(&seg, state, NULL), THUD_OK);
    srand(11);
    for (int trial = 0; trial < 200; trial++) {
        for (int j = 0; j < model->nmodes; j++)
            state->q[j] = 30 * random_part();
        thud_segment_begin(state, &seg, 1e-3, thud_segment_all_terms(state, 1e-3));
        thud_taylor_given(model, &seg, state->q, state->qd);
        for (int c = 0; c < model->ncontacts; c++) {
            ck_assert_int_eq(thud_segment_indentation(state, &seg, c, d), 0);
            ck_assert(d[0] == thud_contact_indentation(state, c));
        }
    }
    march_free(&m);
    thud_model_free(model);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("exact parts");
    TCase *tc = tcase_create("shortcuts");
    tcase_add_loop_test(tc, an_indentation_starts_with_the_same_bits_both_ways, 0, 9);
    tcase_add_test(tc, no_state_passes_what_its_energy_allows);
    tcase_add_test(tc, slices_change_no_bit);
    tcase_add_test(tc, coupled_modes_and_one_contact);
    suite_add_tcase(suite, tc);
    return suite;
}
