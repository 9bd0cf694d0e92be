/* What main.c of the tests offers to every test file. */
#pragma once

#include <check.h>
#include <stdbool.h>
#include <stddef.h>

Suite *thud_suite(void); /* each test file has one */

/* Called by thud_suite in place of adding tests that cannot run here: says so, and tests/tools/run.sh counts it. */
void thud_suite_skips(const char *tests, const char *why);

/* The path of a file of the folder with real ground motions and their reference results, which is not part of the
 * sources: THUD_SHARED, or `shared` beside the checkout or its parent. False where there is none. */
bool thud_suite_shared(const char *name, char *path, size_t size);
