/* The shipped ground motions. The surrogates are what their own comment lines say: made again from those lines they
 * give the same bytes. Their peaks are those of the motions they stand in for, and they read without an option. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/intensity.h"
#include "io/file/file.h"
#include "io/record/record_file.h"
#include "io/record/record_write.h"

static const struct {
    const char *path;
    double peak_g, amplitude, period, cycles, phase;
} shipped[] = {{"records/kobe-surrogate.csv", 0.821, 0.85, 0.95, 1.8, 0},
               {"records/northridge-surrogate.csv", 0.897, 1.05, 3.0, 2.0, 0},
               {"records/san-fernando-surrogate.csv", 1.170, 1.15, 1.47, 1.6, 180}};

/* The text behind `# name: ` in the file's comments, cut at the line's end. */
static void said(const char *text, const char *name, char *to, size_t size)
{
    char key[80];
    snprintf(key, sizeof key, "\n# %s: ", name);
    const char *at = strstr(text, key);
    ck_assert_msg(at != NULL, "%s is not said", name);
    at += strlen(key);
    snprintf(to, size, "%.*s", (int)strcspn(at, "\n"), at);
}

START_TEST(made_again_from_its_comments)
{
    struct thud_error err = {0};
    char *text, value[128];
    size_t size;
    ck_assert_int_eq(thud_file_read(shipped[_i].path, 1 << 20, &text, &size, &err), THUD_OK);
    struct thud_synthesis synthesis;
    thud_synthesis_init(&synthesis);
    for (size_t i = 0; i < thud_synthesis_param_count; i++) {
        const struct thud_synthesis_param *param = &thud_synthesis_params[i];
        said(text, param->name, value, sizeof value);
        *thud_synthesis_field(&synthesis, param) = strtod(value, NULL) * param->scale;
    }
    ck_assert_double_eq(synthesis.pulse_amplitude_mps, shipped[_i].amplitude);
    ck_assert_double_eq(synthesis.pulse_period_s, shipped[_i].period);
    ck_assert_double_eq(synthesis.pulse_cycles, shipped[_i].cycles);
    ck_assert_double_eq(synthesis.pulse_phase_deg, shipped[_i].phase);
    said(text, "event", value, sizeof value);
    struct thud_text again = {0};
    ck_assert_int_eq(thud_surrogate_csv(&synthesis, value, &again, &err), THUD_OK);
    ck_assert_uint_eq(again.size, size);
    ck_assert_int_eq(memcmp(again.data, text, size), 0);
    thud_text_clear(&again);
    free(text);
}
END_TEST

START_TEST(reads_without_an_option)
{
    struct thud_record_choice choice;
    thud_record_choice_init(&choice);
    struct thud_record *record;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_record_file_read(shipped[_i].path, &choice, &record, &err), THUD_OK);
    ck_assert_double_eq(record->dt_s, 0.01);
    ck_assert_uint_eq(record->samples, 4001);
    ck_assert_double_eq_tol(thud_record_peak(record), shipped[_i].peak_g * THUD_GRAVITY, 1e-8);
    thud_record_free(record);
}
END_TEST

/* The recorded motion: peaks of the file it was cut from, as GeoNet's own header has them (its velocity and
 * displacement are GeoNet's integrals of the whole record), and attribution, licence and changes in the file itself. */
START_TEST(the_recorded_one_is_geonets)
{
    static const char path[] = "records/kaikoura-wtmc.csv";
    struct thud_record_choice choice;
    thud_record_choice_init(&choice);
    struct thud_record *record;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_record_file_read(path, &choice, &record, &err), THUD_OK);
    ck_assert_double_eq_tol(thud_record_peak(record), 9.7331, 1e-9);
    ck_assert_double_eq(record->dt_s, 0.02);
    ck_assert_uint_eq(record->samples, 2501);
    ck_assert_str_eq(record->station, "WTMC");
    ck_assert_str_eq(record->component, "N28W");
    ck_assert_str_eq(record->event, "Kaikoura, New Zealand, 2016-11-13");
    ck_assert_str_eq(record->licence, "CC BY 3.0 NZ (GeoNet)");
    struct thud_intensity intensity = thud_intensity_of(record);
    ck_assert_double_eq_tol(intensity.pgv_mps, 1.01655, 0.01 * 1.01655);
    ck_assert_double_eq_tol(intensity.pgd_m, 0.234852, 0.01 * 0.234852);
    thud_record_free(record);
    char *text;
    size_t size;
    ck_assert_int_eq(thud_file_read(path, 1 << 20, &text, &size, &err), THUD_OK);
    ck_assert(strstr(text, "GeoNet") && strstr(text, "CC BY 3.0 NZ") && strstr(text, "Changed:") && size < 40000);
    free(text);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("record surrogates");
    TCase *all = tcase_create("all");
    tcase_add_loop_test(all, made_again_from_its_comments, 0, 3);
    tcase_add_loop_test(all, reads_without_an_option, 0, 3);
    tcase_add_test(all, the_recorded_one_is_geonets);
    suite_add_tcase(suite, all);
    return suite;
}
