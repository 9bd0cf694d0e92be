/* Reading a ground motion while memory and reads fail one after the other: nothing is left allocated, and the status
 * says which it was. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "fault.h"
#include "io/record/record_file.h"

static struct thud_record_choice choice;

static void choose(void)
{
    choice = (struct thud_record_choice){
        .peak_mps2 = NAN, .factor = 1.0, .sign = 1, .from_s = NAN, .to_s = NAN, .dt_s = NAN, .skip = -1};
}

START_TEST(a_record_that_cannot_be_read_leaves_nothing_behind)
{
    for (enum thud_fault kind = THUD_FAULT_MEMORY; kind <= THUD_FAULT_READ; kind++) {
        long n = 0;
        for (bool fired = true; fired;) {
            struct thud_record *record = NULL;
            struct thud_error err = {0};
            long live = thud_fault_live();
            thud_fault_arm(kind, ++n);
            enum thud_status status = thud_record_file_read("records/kobe-surrogate.csv", &choice, &record, &err);
            fired = thud_fault_end();
            bool given = record != NULL;
            thud_record_free(record);
            live -= thud_fault_live();
            ck_assert_msg(live == 0, "call %ld of kind %d leaves %ld blocks", n, (int)kind, -live);
            ck_assert_int_eq(given, status == THUD_OK);
            if (fired)
                ck_assert_int_eq(status, kind == THUD_FAULT_MEMORY ? THUD_MEMORY : THUD_INPUT);
            else
                ck_assert_int_eq(status, THUD_OK);
        }
        ck_assert_int_gt(n, 1);
    }
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("fault_record");
    TCase *tcase = tcase_create("fault_record");
    tcase_add_checked_fixture(tcase, choose, NULL);
    tcase_add_test(tcase, a_record_that_cannot_be_read_leaves_nothing_behind);
    suite_add_tcase(suite, tcase);
    return suite;
}
