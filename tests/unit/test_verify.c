/* Expectations: which numbers a result has, when two methods confirm one, what holds and what moved; files of them
 * read back, and what is wrong in one is named with its place. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "io/result/expectation_file.h"
#include "study/methods/verify.h"

static struct thud_floor_result left_floor[2], right_floor[1], body_floor[1];
static double left_period[2] = {0.5, 0.2}, right_period[1] = {0.3}, body_period[1];

/* Two storeys, one storey, a free body, a wall; one contact between floors, one with the wall. */
static struct thud_result solution(struct thud_scene *scene, double factor)
{
    static struct thud_structure_result structure[4];
    static struct thud_contact_result contact[2];
    static const char *const names[] = {"A", "B, new", "body", "moat"};
    memset(scene, 0, sizeof *scene);
    for (int i = 0; i < 4; i++)
        snprintf(scene->structure[i].name, sizeof scene->structure[i].name, "%s", names[i]);
    left_floor[0].acceleration.value = 2 * factor;
    left_floor[1].acceleration.value = 3 * factor;
    left_floor[1].drift.value = 0.01 * factor;
    right_floor[0].displacement.value = 0.5 * factor;
    body_period[0] = INFINITY;
    structure[0] = (struct thud_structure_result){
        .floors = 2, .floor = left_floor, .base_shear = {7e6, 1}, .period_s = left_period};
    structure[1] = (struct thud_structure_result){
        .floors = 1, .floor = right_floor, .base_shear = {8e6, 1}, .period_s = right_period};
    structure[2] = (struct thud_structure_result){.floors = 1, .floor = body_floor, .period_s = body_period};
    structure[3] = (struct thud_structure_result){0};
    contact[0] = (struct thud_contact_result){.interface = 1, .left_floor = 2, .right_floor = 1, .impacts = 4};
    contact[1] = (struct thud_contact_result){.interface = 3, .left_floor = 1, .right_floor = 0, .impacts = 1};
    return (struct thud_result){.nstructures = 4, .ncontacts = 2, .structure = structure, .contact = contact};
}

static double value_of(const struct thud_checked_values *m, enum thud_case which, const char *name)
{
    const struct thud_checked_value *found = thud_checked_values_find(m, which, name);
    return found ? found->value : NAN;
}

START_TEST(names_every_number_of_an_answer)
{
    static struct thud_scene scene;
    struct thud_checked_values m = {0};
    struct thud_result result = solution(&scene, 1);
    ck_assert_int_eq(thud_checked_values_add(&m, &scene, THUD_CASE_NONE, &result, NULL), THUD_OK);
    /* 3 floors of 4, 2 base shears, 3 of the free body, 2 contacts of 4, 3 energies; nothing of the wall */
    ck_assert_uint_eq(m.n, 3 * 4 + 2 + 3 + 2 * 4 + 3);
    ck_assert(value_of(&m, THUD_CASE_NONE, "A.2.acceleration_mps2") == 3);
    ck_assert(value_of(&m, THUD_CASE_NONE, "B, new.1.displacement_m") == 0.5);
    ck_assert(value_of(&m, THUD_CASE_NONE, "A.base_shear_n") == 7e6);
    ck_assert(value_of(&m, THUD_CASE_NONE, "contact.1.2-1.impacts") == 4);
    ck_assert(value_of(&m, THUD_CASE_NONE, "contact.3.1-wall.impacts") == 1);
    ck_assert(isnan(value_of(&m, THUD_CASE_NONE, "body.1.drift_m")));
    ck_assert(isnan(value_of(&m, THUD_CASE_BUMPER, "A.2.acceleration_mps2")));
    thud_checked_values_clear(&m);
}
END_TEST

START_TEST(ratios_are_over_the_case_without_bumper)
{
    static struct thud_scene scene;
    struct thud_checked_values m = {0};
    struct thud_result result = solution(&scene, 1.25); /* the other case first: the order does not matter */
    ck_assert_int_eq(thud_checked_values_add(&m, &scene, THUD_CASE_BUMPER, &result, NULL), THUD_OK);
    result = solution(&scene, 1);
    ck_assert_int_eq(thud_checked_values_add(&m, &scene, THUD_CASE_NONE, &result, NULL), THUD_OK);
    size_t before = m.n;
    ck_assert_int_eq(thud_checked_values_add_ratios(&m, NULL), THUD_OK);
    ck_assert_uint_eq(m.n, before + 4); /* of what is not 0: three peaks of A, one of B */
    ck_assert(value_of(&m, THUD_CASE_BUMPER, "ratio.A.2.acceleration") == 1.25);
    ck_assert(value_of(&m, THUD_CASE_BUMPER, "ratio.A.2.drift") == 1.25);
    ck_assert(value_of(&m, THUD_CASE_BUMPER, "ratio.B, new.1.displacement") == 1.25);
    ck_assert(isnan(value_of(&m, THUD_CASE_NONE, "ratio.A.2.acceleration")));
    ck_assert(isnan(value_of(&m, THUD_CASE_BUMPER, "ratio.A.1.drift"))); /* 0 / 0 */
    thud_checked_values_clear(&m);
}
END_TEST

START_TEST(a_tolerance_is_ten_times_the_difference)
{
    ck_assert_double_eq_tol(thud_verify_tolerance(100, 100, false), 1e-6, 1e-18);
    ck_assert_double_eq_tol(thud_verify_tolerance(100 + 1e-9, 100, false), 1e-6, 1e-18);
    ck_assert_double_eq_tol(thud_verify_tolerance(100 + 2.1e-4, 100, false), 3e-5, 1e-12);
    ck_assert_double_eq_tol(thud_verify_tolerance(-100 - 2.1e-4, -100, false), 3e-5, 1e-12);
    for (double d = 1.3e-7; d < 1e-4; d *= 1.7) {
        double tolerance = thud_verify_tolerance(5 * (1 - d), 5, false);
        ck_assert(tolerance >= 10 * d * (1 - 1e-9) && tolerance < 20.1 * d);
    }
    ck_assert(isnan(thud_verify_tolerance(100.02, 100, false)));
    ck_assert(isnan(thud_verify_tolerance(NAN, 100, false)));
    ck_assert(isnan(thud_verify_tolerance(1, NAN, false)));
    ck_assert(isnan(thud_verify_tolerance(10, 11, true)));
    ck_assert(isnan(thud_verify_tolerance(10, NAN, true)));
    ck_assert(thud_verify_tolerance(10, 10, true) == 0);
    ck_assert_double_eq_tol(thud_verify_tolerance(0, 0, false), 1e-6, 1e-18);
}
END_TEST

START_TEST(tells_what_holds_what_moved_and_what_is_gone)
{
    static struct thud_scene scene;
    struct thud_checked_values m = {0};
    struct thud_result result = solution(&scene, 1);
    ck_assert_int_eq(thud_checked_values_add(&m, &scene, THUD_CASE_NONE, &result, NULL), THUD_OK);
    struct thud_expectation e = {THUD_CASE_NONE, "A.2.acceleration_mps2", 4, 0.25, NAN};
    struct thud_check check = thud_verify_check(&e, &m);
    ck_assert_int_eq(check.verdict, THUD_HOLDS); /* just */
    ck_assert(check.got == 3 && check.change == -0.25);
    e.tolerance = 0.249;
    ck_assert_int_eq(thud_verify_check(&e, &m).verdict, THUD_MOVED);
    e.which = THUD_CASE_CAVITY;
    ck_assert_int_eq(thud_verify_check(&e, &m).verdict, THUD_GONE);
    struct thud_expectation zero = {THUD_CASE_NONE, "energy.input_j", 0, 0, NAN};
    ck_assert_int_eq(thud_verify_check(&zero, &m).verdict, THUD_HOLDS);
    m.item[0].value = NAN; /* never holds, however wide the tolerance */
    struct thud_expectation lost = {THUD_CASE_NONE, "A.1.acceleration_mps2", 2, 1e9, NAN};
    ck_assert_int_eq(thud_verify_check(&lost, &m).verdict, THUD_MOVED);
    thud_checked_values_clear(&m);
}
END_TEST

START_TEST(only_what_both_methods_give_is_expected)
{
    static struct thud_scene scene;
    struct thud_checked_values own = {0}, other = {0};
    struct thud_expectations agreed = {0}, disputed = {0}, read;
    struct thud_text text = {0};
    struct thud_result result = solution(&scene, 1);
    ck_assert_int_eq(thud_checked_values_add(&own, &scene, THUD_CASE_NONE, &result, NULL), THUD_OK);
    result.contact[0].impacts = 5;
    left_floor[0].acceleration.value = 2.0002;
    left_floor[1].acceleration.value = 3.00001;
    ck_assert_int_eq(thud_checked_values_add(&other, &scene, THUD_CASE_NONE, &result, NULL), THUD_OK);
    other.n--; /* energy.contact_j is not there */
    ck_assert_int_eq(thud_verify_confirm(&own, &other, &agreed, &disputed, NULL), THUD_OK);
    ck_assert_uint_eq(agreed.n + disputed.n, own.n);
    ck_assert_uint_eq(disputed.n, 2);
    ck_assert_str_eq(disputed.item[0].name, "contact.1.2-1.impacts");
    ck_assert(disputed.item[0].value == 4 && disputed.item[0].other == 5);
    ck_assert(agreed.item[0].value == 2.0002); /* of the independent one, and what it stands for holds with room */
    for (size_t i = 0; i < agreed.n; i++)
        ck_assert_int_eq(thud_verify_check(&agreed.item[i], &own).verdict, THUD_HOLDS);
    struct thud_expectation_origin origin = {"p", "exact", "dormand-prince", "tolerance 1e-6", 1e-12};
    thud_expectation_text(&origin, &agreed, &disputed, &text);
    ck_assert_ptr_nonnull(strstr(text.data, "\n# none contact.1.2-1.impacts: exact 4, dormand-prince 5\n"));
    ck_assert_int_eq(thud_expectation_parse(text.data, text.size, "x", &read, NULL), THUD_OK);
    ck_assert_uint_eq(read.n, agreed.n); /* and reads back, a comma in a name with it */
    for (size_t i = 0; i < read.n; i++) {
        ck_assert_str_eq(read.item[i].name, agreed.item[i].name);
        ck_assert_double_eq_tol(read.item[i].value, agreed.item[i].value, 1e-9 * fabs(agreed.item[i].value) + 1e-300);
        ck_assert_double_eq_tol(read.item[i].tolerance, agreed.item[i].tolerance,
                                1e-9 * agreed.item[i].tolerance + 1e-300);
    }
    thud_expectations_clear(&read);
    thud_expectations_clear(&agreed);
    thud_expectations_clear(&disputed);
    thud_checked_values_clear(&own);
    thud_checked_values_clear(&other);
    thud_text_clear(&text);
}
END_TEST

START_TEST(the_confirming_method_is_another_one)
{
    ck_assert_str_eq(thud_verify_independent("exact"), "dormand-prince");
    ck_assert_str_eq(thud_verify_independent("rk4"), "dormand-prince");
    ck_assert_str_eq(thud_verify_independent("dormand-prince"), "exact");
    ck_assert_str_eq(thud_verify_independent("dormand-prince-unlocated"), "exact");
}
END_TEST

START_TEST(reads_what_editors_make_of_a_file)
{
    static const char *const texts[] = {
        "bumper,A.4.acceleration_mps2,77.93,1e-5\nnone,contact.1.4-4.impacts,10,0\n",
        "# by hand\r\ncase,quantity,value,tolerance\r\nbumper,A.4.acceleration_mps2,77.93,1e-5\r\n\r\n"
        "none,contact.1.4-4.impacts,10,0",
        "\xEF\xBB\xBF"
        "case,quantity,value,tolerance\nbumper,\"A.4.acceleration_mps2\", 77.93 ,1e-5\n"
        "none,contact.1.4-4.impacts,10,0\n"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct thud_expectations list;
        struct thud_error err = {0};
        ck_assert_msg(thud_expectation_parse(texts[i], strlen(texts[i]), "x", &list, &err) == THUD_OK, "%zu: %s", i,
                      err.what);
        ck_assert_uint_eq(list.n, 2);
        ck_assert_int_eq(list.item[0].which, THUD_CASE_BUMPER);
        ck_assert(list.item[0].value == 77.93 && list.item[0].tolerance == 1e-5);
        ck_assert_str_eq(list.item[1].name, "contact.1.4-4.impacts");
        ck_assert(list.item[1].value == 10 && list.item[1].tolerance == 0);
        thud_expectations_clear(&list);
    }
}
END_TEST

START_TEST(names_the_place_of_what_is_wrong)
{
    static const struct {
        const char *text;
        int line, column;
    } wrong[] = {{"none,a,nan,0\n", 1, 8},
                 {"# x\nnone,a,inf,0\n", 2, 8},
                 {"none,a,1e999,0\n", 1, 8},
                 {"none,a,0x10,0\n", 1, 8},
                 {"none,a,1,2,\n", 1, 1},
                 {"none,a,1\n", 1, 1},
                 {"none,\"a,b\",1,-1\n", 1, 14},
                 {"none,a,1,\n", 1, 10},
                 {"none,a,1 m,0\n", 1, 8},
                 {"none,a,1,0\nnope,a,1,0\n", 2, 1},
                 {"none,,1,0\n", 1, 6},
                 {"none,a\001b,1,0\n", 1, 6},
                 {"none,\"a,1,0\n", 1, 0},
                 {"# nothing\n", 0, 0},
                 {"", 0, 0},
                 {"case,quantity,value,tolerance\n", 0, 0}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct thud_expectations list;
        struct thud_error err = {0};
        ck_assert_int_eq(thud_expectation_parse(wrong[i].text, strlen(wrong[i].text), "x", &list, &err), THUD_INPUT);
        ck_assert_ptr_null(list.item);
        ck_assert_str_eq(err.file, "x");
        ck_assert_msg(err.line == wrong[i].line && err.column == wrong[i].column, "%zu: %d:%d %s", i, err.line,
                      err.column, err.what);
    }
}
END_TEST

START_TEST(a_byte_0_is_refused_where_it_stands)
{
    static const char text[] = "none,a,1,0\nnone,b\0c,1,0\n";
    struct thud_expectations list;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_expectation_parse(text, sizeof text - 1, "x", &list, &err), THUD_INPUT);
    ck_assert_int_eq(err.line, 2);
    ck_assert_int_eq(err.column, 7);
}
END_TEST

/* A reader of CSV takes blanks off fields that no quotation marks hold. */
START_TEST(blanks_at_the_ends_of_a_name_are_kept)
{
    static const char text[] = "none,\" a \",1,0\n";
    struct thud_expectation_origin origin = {"p", "exact", "dormand-prince", "tolerance 1e-6", 1e-12};
    struct thud_expectations list, again, none = {0};
    struct thud_text written = {0};
    ck_assert_int_eq(thud_expectation_parse(text, sizeof text - 1, "x", &list, NULL), THUD_OK);
    ck_assert_str_eq(list.item[0].name, " a ");
    thud_expectation_text(&origin, &list, &none, &written);
    ck_assert_int_eq(thud_expectation_parse(written.data, written.size, "x", &again, NULL), THUD_OK);
    ck_assert_str_eq(again.item[0].name, " a ");
    thud_expectations_clear(&list);
    thud_expectations_clear(&again);
    thud_text_clear(&written);
}
END_TEST

START_TEST(stands_beside_its_preset)
{
    char path[64];
    ck_assert_int_eq(thud_expectation_path("a.b/towers.yaml", path, sizeof path, NULL), THUD_OK);
    ck_assert_str_eq(path, "a.b/towers.expected.csv");
    ck_assert_int_eq(thud_expectation_path("mine", path, sizeof path, NULL), THUD_OK);
    ck_assert_str_eq(path, "mine.expected.csv");
    ck_assert_int_eq(thud_expectation_path("mine", path, 10, NULL), THUD_INPUT);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("verify");
    TCase *tcase = tcase_create("verify");
    tcase_add_test(tcase, names_every_number_of_an_answer);
    tcase_add_test(tcase, ratios_are_over_the_case_without_bumper);
    tcase_add_test(tcase, a_tolerance_is_ten_times_the_difference);
    tcase_add_test(tcase, tells_what_holds_what_moved_and_what_is_gone);
    tcase_add_test(tcase, only_what_both_methods_give_is_expected);
    tcase_add_test(tcase, the_confirming_method_is_another_one);
    tcase_add_test(tcase, reads_what_editors_make_of_a_file);
    tcase_add_test(tcase, names_the_place_of_what_is_wrong);
    tcase_add_test(tcase, a_byte_0_is_refused_where_it_stands);
    tcase_add_test(tcase, blanks_at_the_ends_of_a_name_are_kept);
    tcase_add_test(tcase, stands_beside_its_preset);
    suite_add_tcase(suite, tcase);
    return suite;
}
