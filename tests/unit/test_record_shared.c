/* Real files of every network, where they are at hand (THUD_SHARED, or ../shared/records): each opens with no more said
 * than it keeps to itself, and gives the samples, the step, the peak and the velocity that stand in the README beside
 * them. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/intensity.h"
#include "io/record/record_file.h"
#include "suite.h"

static const struct {
    const char *file, *format;
    double dt_s;         /* given; 0: the file says it */
    const char *unit;    /* given; NULL: the file says it */
    const char *channel; /* given */
    int column, skip;    /* given */
    size_t samples;
    double step_s, pga_g, pgv_cmps;
} real[] = {
    {"kobe-1995-kjma-000.AT2", "PEER AT2", 0, NULL, NULL, 0, 0, 7500, 0.02, 0.8342, 91.1},
    {"kobe-1995-kjma-090.AT2", "PEER AT2", 0, NULL, NULL, 0, 0, 7500, 0.02, 0.6297, 76.1},
    {"kobe-1995-jma-ns-gal.txt", "plain columns", 0, NULL, NULL, 0, 3, 2567, 0.02, 0.8342, 91.9},
    {"northridge-1994-sylmar-converter-142-noheader.AT2", "PEER AT2 without header", 0.005, "g", NULL, 0, 0, 8000,
     0.005, 0.8972, 102.2},
    {"northridge-1994-sylmar-converter-052-noheader.AT2", "PEER AT2 without header", 0.005, "g", NULL, 0, 0, 8000,
     0.005, 0.6125, 117.4},
    {"san-fernando-1971-pacoima-dam-164.AT2", "PEER AT2", 0, NULL, NULL, 0, 0, 4172, 0.01, 1.2190, 114.4},
    {"san-fernando-1971-pacoima-dam-254.AT2", "PEER AT2", 0, NULL, NULL, 0, 0, 4172, 0.01, 1.2383, 57.3},
    {"imperial-valley-1940-el-centro-180-ngawest2.AT2", "PEER AT2", 0, NULL, NULL, 0, 0, 5372, 0.01, 0.2808, 30.9},
    {"imperial-valley-1940-el-centro-180-peer1999.AT2", "PEER AT2", 0, NULL, NULL, 0, 0, 4000, 0.01, 0.3129, 29.7},
    {"imperial-valley-1940-el-centro-ns-peknold.AT2", "PEER AT2", 0, NULL, NULL, 0, 0, 1559, 0.02, 0.3188, 36.1},
    {"imperial-valley-1940-el-centro-ns-chopra.csv", "CSV", 0, NULL, NULL, 0, 0, 1560, 0.02, 0.3188, 36.1},
    {"loma-prieta-1989-corralitos-000.AT2", "PEER AT2", 0, NULL, NULL, 0, 0, 7997, 0.005, 0.6447, 55.9},
    {"chi-chi-1999-tcu052-n.AT2", "PEER AT2", 0, NULL, NULL, 0, 0, 18000, 0.005, 0.4190, 118.5},
    {"tabas-1978-tabas-fn.txt", "plain columns", 0.02, "g", NULL, 0, 0, 2500, 0.02, 0.9000, 110.0},
    {"erzincan-1992-ns-ew-gal.txt", "plain columns", 0, NULL, NULL, 1, 0, 4260, 0.005, 0.5154, 84.0},
    {"erzincan-1992-ns-ew-gal.txt", "plain columns", 0, NULL, NULL, 2, 0, 4260, 0.005, 0.4957, 64.7},
    {"northridge-1994-rinaldi-fn-fp-gal.txt", "plain columns", 0, NULL, NULL, 1, 0, 6000, 0.005, 0.8402, 159.6},
    {"northridge-1994-rinaldi-fn-fp-gal.txt", "plain columns", 0, NULL, NULL, 2, 0, 6000, 0.005, 0.4762, 75.1},
    {"mexico-1985-sct-3comp.txt", "plain columns", 0, "g", NULL, 2, 0, 8171, 0.02, 0.0995, 38.0},
    {"mexico-1985-sct-3comp.txt", "plain columns", 0, "g", NULL, 3, 0, 8171, 0.02, 0.1712, 60.1},
    {"mexico-1985-sct-3comp.txt", "plain columns", 0, "g", NULL, 4, 0, 8171, 0.02, 0.0373, 8.6},
    {"kaikoura-2016-wtmc-geonet.V2A", "GeoNet V2A", 0, NULL, "N28W", 0, 0, 8192, 0.02, 0.9925, 100.8},
    {"kaikoura-2016-wtmc-geonet.V2A", "GeoNet V2A", 0, NULL, "2", 0, 0, 8192, 0.02, 0.8124, 68.4},
    {"kaikoura-2016-wtmc-geonet.V2A", "GeoNet V2A", 0, NULL, "up", 0, 0, 8192, 0.02, 1.8377, 37.5},
    {"coalinga-1983-parkfield-fz14-csmip.V2", "CSMIP V2", 0, NULL, "90", 0, 0, 3251, 0.02, 0.2732, 28.2},
    {"coalinga-1983-parkfield-fz14-csmip.V2", "CSMIP V2", 0, NULL, "up", 0, 0, 3250, 0.02, 0.0967, 11.5},
    {"coalinga-1983-parkfield-fz14-csmip.V2", "CSMIP V2", 0, NULL, "3", 0, 0, 3250, 0.02, 0.2613, 34.0},
    {"anchorage-2018-akbmr-cosmos.V2c", "COSMOS V2", 0, NULL, NULL, 0, 0, 42000, 0.005, 0.0070, 0.8},
    {"loma-prieta-1989-sf-shafter-360.smc", "USGS SMC", 0, NULL, NULL, 0, 0, 6001, 0.005, 0.1065, 8.1},
    {"greece-2019-ars1-hne-esm.ASC", "ESM", 0, NULL, NULL, 0, 0, 19128, 0.005, 0.0003, 0.02},
    {"aomori-2018-aom001-knet.EW", "K-NET", 0, NULL, NULL, 0, 0, 10200, 0.01, 0.0042, 0.4},
    {"tottori-2000-aich04-kiknet.NS2", "KiK-net", 0, NULL, NULL, 0, 0, 28600, 0.005, 0.0057, 2.2},
};

static const char *path_of(const char *file)
{
    static char path[600];
    char name[200];
    snprintf(name, sizeof name, "records/%s", file);
    return thud_suite_shared(name, path, sizeof path) ? path : NULL;
}

START_TEST(matches_the_readme)
{
    const char *path = path_of(real[_i].file);
    ck_assert_ptr_nonnull(path);
    struct thud_record_choice choice;
    thud_record_choice_init(&choice);
    if (real[_i].dt_s > 0)
        choice.dt_s = real[_i].dt_s;
    snprintf(choice.unit, sizeof choice.unit, "%s", real[_i].unit ? real[_i].unit : "");
    snprintf(choice.channel, sizeof choice.channel, "%s", real[_i].channel ? real[_i].channel : "");
    choice.column = real[_i].column;
    choice.skip = real[_i].skip ? real[_i].skip : -1;
    struct thud_record *record;
    struct thud_error err = {0};
    enum thud_status status = thud_record_file_read(path, &choice, &record, &err);
    ck_assert_msg(status == THUD_OK, "%s: %s", real[_i].file, err.what);
    ck_assert_str_eq(record->format, real[_i].format);
    ck_assert_uint_eq(record->samples, real[_i].samples);
    ck_assert_double_eq_tol(record->dt_s, real[_i].step_s, 1e-15);
    /* the README rounds, and twice to the wrong side (Tabas 0.89995 g, Kaikoura S62W 0.81235 g) */
    ck_assert_double_eq_tol(thud_record_peak(record) / THUD_GRAVITY, real[_i].pga_g, 0.8e-4);
    struct thud_intensity intensity = thud_intensity_of(record);
    /* the README takes it at the samples; between them it is at most 1 % larger */
    double *velocity = calloc(record->samples, sizeof *velocity), sampled = 0;
    ck_assert_ptr_nonnull(velocity);
    thud_record_integrate(record, velocity, NULL);
    for (size_t i = 0; i < record->samples; i++)
        sampled = fmax(sampled, fabs(velocity[i]));
    free(velocity);
    ck_assert_double_eq_tol(100 * sampled, real[_i].pgv_cmps, real[_i].pgv_cmps < 0.1 ? 0.006 : 0.06);
    ck_assert(intensity.pgv_mps >= sampled && intensity.pgv_mps < 1.012 * sampled);
    thud_record_free(record);
}
END_TEST

/* What a file does not say is asked for by the option's name. */
static const struct {
    const char *file, *key;
} silent[] = {{"northridge-1994-sylmar-converter-142-noheader.AT2", "dt"},
              {"tabas-1978-tabas-fn.txt", "dt"},
              {"mexico-1985-sct-3comp.txt", "column"},
              {"erzincan-1992-ns-ew-gal.txt", "column"},
              {"kaikoura-2016-wtmc-geonet.V2A", "channel"},
              {"coalinga-1983-parkfield-fz14-csmip.V2", "channel"}};

START_TEST(asks_by_name)
{
    char option[40];
    const char *path = path_of(silent[_i].file);
    ck_assert_ptr_nonnull(path);
    struct thud_record_choice choice;
    thud_record_choice_init(&choice);
    struct thud_record *record;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_record_file_read(path, &choice, &record, &err), THUD_INPUT);
    ck_assert_ptr_null(record);
    ck_assert_str_eq(err.key, silent[_i].key);
    snprintf(option, sizeof option, "`record.%s", silent[_i].key);
    ck_assert_msg(strstr(err.what, option) || strstr(err.allowed, option), "%s", err.what);
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("shared records");
    TCase *all = tcase_create("all");
    if (path_of(real[0].file)) {
        tcase_add_loop_test(all, matches_the_readme, 0, (int)(sizeof real / sizeof *real));
        tcase_add_loop_test(all, asks_by_name, 0, (int)(sizeof silent / sizeof *silent));
    } else {
        thud_suite_skips("real files match their README", "no folder ../shared/records (THUD_SHARED names another)");
    }
    suite_add_tcase(suite, all);
    return suite;
}
