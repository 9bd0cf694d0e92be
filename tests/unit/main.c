/* Runs the suite of one test file; TAP on standard output (tests/tools/run.sh counts it).
 * A test that passes without having made an assertion fails here. */
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "suite.h"

/* Whether a line of a source file begins a test. Every assertion of Check notes its own place, so that the last place
 * noted of a test that made none is its START_TEST. */
static bool begins_a_test(const char *path, int line)
{
    FILE *file = path ? fopen(path, "r") : NULL;
    char text[512] = "";
    for (int i = 0; file && i < line && fgets(text, sizeof text, file);)
        i += strchr(text, '\n') != NULL;
    if (file)
        fclose(file);
    return strncmp(text, "START_TEST(", strlen("START_TEST(")) == 0;
}

/* How many tests passed without an assertion; names them. */
static int empty_tests(SRunner *runner)
{
    int n = srunner_ntests_run(runner), empty = 0;
    TestResult **results = srunner_results(runner);
    for (int i = 0; i < n; i++) {
        TestResult *r = results[i];
        if (tr_rtype(r) == CK_PASS && begins_a_test(tr_lfile(r), tr_lno(r))) {
            printf("# %s:%d: passed without an assertion\n", tr_lfile(r), tr_lno(r));
            empty++;
        }
    }
    free(results);
    return empty;
}

int main(void)
{
    setlocale(LC_NUMERIC, "C");
    setenv("CK_DEFAULT_TIMEOUT", "60", 0); /* by hand too: Check's own 4 s are too few on a busy machine */
    SRunner *runner = srunner_create(thud_suite());
    srunner_set_tap(runner, "-");
    srunner_run_all(runner, CK_SILENT);
    int failed = srunner_ntests_failed(runner) + empty_tests(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
