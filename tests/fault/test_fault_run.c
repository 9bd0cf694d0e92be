/* A model and its run while one allocation after the other fails: out of memory is said and nothing is left behind,
 * whichever it was. */
#include <check.h>
#include <math.h>

#include "core/run/run.h"
#include "fault.h"

enum { FLOORS = 3, SAMPLES = 200 };
static double ground[SAMPLES];
static const double mass[FLOORS] = {320e3, 320e3, 250e3};
static const double soft[FLOORS] = {300e6, 300e6, 300e6}, stiff[FLOORS] = {600e6, 600e6, 600e6};

static void shake(void)
{
    for (int i = 0; i < SAMPLES; i++)
        ground[i] = 6.0 * sin(0.02 * i * 9.0);
}

struct pair {
    struct thud_structure_input structure[2];
    struct thud_contact_input contact[FLOORS];
    struct thud_model_input input;
};

static void two_buildings(struct pair *pair, const char *law_name, double thickness_m)
{
    const struct thud_law *law = thud_law_find(law_name);
    ck_assert_ptr_nonnull(law);
    *pair = (struct pair){0};
    for (int s = 0; s < 2; s++)
        pair->structure[s] = (struct thud_structure_input){
            .n = FLOORS, .mass_kg = mass, .stiffness_npm = s == 0 ? stiff : soft, .damping = 0.05};
    for (int c = 0; c < FLOORS; c++) {
        struct thud_contact_input *contact = &pair->contact[c];
        *contact = (struct thud_contact_input){.interface = 1,
                                               .left_floor = c + 1,
                                               .right_floor = c + 1,
                                               .left_structure = 0,
                                               .right_structure = 1,
                                               .clearance_m = 0.005,
                                               .law = law};
        thud_law_defaults(law, &contact->setup);
        contact->setup.thickness_m = thickness_m;
        int stiffness = thud_law_param(law, "stiffness");
        if (stiffness >= 0 && isnan(contact->setup.value[stiffness]))
            contact->setup.value[stiffness] = 0.36e3 * pow(1000, 2.65);
    }
    pair->input = (struct thud_model_input){
        .nstructures = 2, .structure = pair->structure, .ncontacts = FLOORS, .contact = pair->contact};
}

/* Runs once with the n-th allocation failing (0: none); the impacts counted in *impacts. */
static enum thud_status run_once(const struct pair *pair, const char *method, long n, int *impacts, bool *fired,
                                 long *lost)
{
    struct thud_record *record = NULL;
    struct thud_model *model = NULL;
    struct thud_run *run = NULL;
    struct thud_run_options options;
    thud_run_options_init(&options);
    options.method = thud_method_find(method);
    options.keep_impacts = options.keep_history = true;
    options.tail_s = 0.5;
    *impacts = 0;
    *lost = thud_fault_live();
    thud_fault_arm(THUD_FAULT_MEMORY, n);
    enum thud_status status = thud_record_create(ground, SAMPLES, 0.02, &record, NULL);
    if (status == THUD_OK)
        status = thud_model_create(&pair->input, &model, NULL);
    if (status == THUD_OK)
        status = thud_run_create(model, record, &options, &run, NULL);
    for (bool done = false; status == THUD_OK && !done;)
        status = thud_run_advance(run, 100, &done, NULL);
    *fired = thud_fault_end();
    if (run)
        thud_run_impacts(run, impacts);
    thud_run_free(run);
    thud_model_free(model);
    thud_record_free(record);
    *lost -= thud_fault_live();
    return status;
}

static void survives(const char *law, double thickness_m, const char *method)
{
    struct pair pair;
    two_buildings(&pair, law, thickness_m);
    bool fired;
    long n = 0, lost;
    int impacts;
    do {
        enum thud_status status = run_once(&pair, method, ++n, &impacts, &fired, &lost);
        ck_assert_msg(lost == 0, "%s: allocation %ld leaves %ld blocks", law, n, -lost);
        ck_assert_msg(status == (fired ? THUD_MEMORY : THUD_OK), "%s: allocation %ld gives status %d", law, n,
                      (int)status);
    } while (fired);
    ck_assert_int_gt(n, 5);
    ck_assert_int_gt(impacts, 3); /* lists of impacts and histories had to grow */
}

START_TEST(a_run_through_linear_contact)
{
    survives("kelvin-voigt-no-tension", 0, "exact");
}
END_TEST

START_TEST(a_run_through_the_bumper)
{
    survives("rubber", 0.05, "exact");
}
END_TEST

START_TEST(a_run_of_impulses)
{
    survives("stereomechanical", 0, "exact");
}
END_TEST

START_TEST(every_method)
{
    for (int i = 0; i < thud_method_count(); i++)
        survives("rubber", 0.05, thud_method_at(i)->name);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("fault_run");
    TCase *tcase = tcase_create("fault_run");
    tcase_add_checked_fixture(tcase, shake, NULL);
    tcase_add_test(tcase, a_run_through_linear_contact);
    tcase_add_test(tcase, a_run_through_the_bumper);
    tcase_add_test(tcase, a_run_of_impulses);
    tcase_add_test(tcase, every_method);
    suite_add_tcase(suite, tcase);
    return suite;
}
