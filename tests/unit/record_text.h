/* What the tests of record readers share: parse a text, hold it against samples or against a refusal. */
#pragma once

#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "io/record/record_file.h"

static struct thud_record_choice choice;
static struct thud_record *record;
static struct thud_error err;

static void setup(void)
{
    thud_record_choice_init(&choice);
    memset(&err, 0, sizeof err);
    record = NULL;
}

static void teardown(void)
{
    thud_record_free(record);
}

static enum thud_status parse(const char *text)
{
    return thud_record_parse(text, strlen(text), "file", &choice, &record, &err);
}

static void reads(const char *text, const char *format, double dt, size_t samples, const double *a)
{
    enum thud_status status = parse(text);
    char message[1500];
    ck_assert_msg(status == THUD_OK, "%s\n%s", thud_error_text(&err, message, sizeof message), text);
    ck_assert_str_eq(record->format, format);
    ck_assert_double_eq_tol(record->dt_s, dt, 1e-15);
    ck_assert_uint_eq(record->samples, samples);
    for (size_t i = 0; i < samples; i++)
        ck_assert_double_eq_tol(record->a_mps2[i], a[i], 1e-12 * (1 + fabs(a[i])));
    thud_record_free(record);
    record = NULL;
}

static void refuses(const char *text, int line, const char *key, const char *part)
{
    ck_assert_msg(parse(text) == THUD_INPUT, "taken: %s", text);
    ck_assert_ptr_null(record);
    ck_assert_msg(strstr(err.what, part) || strstr(err.allowed, part), "`%s` (%s) does not tell `%s`", err.what,
                  err.allowed, part);
    ck_assert_msg(err.line == line, "line %d, not %d: %s", err.line, line, err.what);
    ck_assert_str_eq(err.key, key);
}

#define G(x) ((x)*THUD_GRAVITY)

static const char esm[] =
    "EVENT_NAME: X\nSTATION_CODE: ARS1\nSAMPLING_INTERVAL_S: 0.01\nNDATA: 3\nSTREAM: HNE\nUNITS: cm/s^2\n"
    "DATA_TYPE: ACCELERATION\nUSER5: \n10.0\n-20\n+30.\n";
