/* Runs the suite of one test file; TAP on standard output (tests/tools/run.sh counts it). */
#include <check.h>
#include <locale.h>
#include <stdlib.h>

Suite *thud_suite(void); /* one per test file */

int main(void)
{
    setlocale(LC_NUMERIC, "C");
    SRunner *runner = srunner_create(thud_suite());
    srunner_set_tap(runner, "-");
    srunner_run_all(runner, CK_SILENT);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
