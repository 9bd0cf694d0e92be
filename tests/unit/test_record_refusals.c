/* Files that are damaged or say too little: each refusal names line and reason, or the option to give. */
#include "record_text.h"

START_TEST(no_record_at_all)
{
    refuses("", 0, "", "empty");
    refuses("\n\n\n", 0, "", "no accelerogram");
    refuses("words alone\n", 0, "", "no accelerogram");
    refuses("<!DOCTYPE html>\n<p>1 2 3\n", 1, "", "web page");
    refuses("PK\x03\x04 rest", 0, "", "compressed");
    refuses("BZh91AY", 0, "", "compressed");
    refuses("\xff\xfe"
            "1",
            1, "", "UTF-16");
    refuses("time_s,acceleration_mps2\n0,1\n", 0, "", "too few");
    ck_assert_str_eq(err.allowed, "2 or more");
    ck_assert_int_eq(thud_record_parse("1\n2\n\0\1\2\n", 9, "file", &choice, &record, &err), THUD_INPUT);
    ck_assert_int_eq(err.line, 3);
    ck_assert_ptr_nonnull(strstr(err.what, "a NUL byte"));
    ck_assert_int_eq(thud_record_file_read("/", &choice, &record, &err), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.what, "folder"));
    ck_assert_int_eq(thud_record_file_read("/dev/zero", &choice, &record, &err), THUD_INPUT);
    ck_assert_int_eq(thud_record_file_read("no/such/file", &choice, &record, &err), THUD_INPUT);
    ck_assert_str_eq(err.file, "no/such/file");
}
END_TEST

START_TEST(numbers_that_are_none)
{
    refuses("time_s,acceleration_mps2\n0,0.1\n0.01,NaN\n0.02,0.3\n", 3, "", "\"NaN\" is not a number");
    refuses("time_s,acceleration_mps2\n0,nan\n0.01,1\n0.02,0.3\n", 2, "", "\"nan\" is not a number");
    refuses("time_s,acceleration_mps2\n0,inf\n0.01,1\n", 2, "", "not a number");
    refuses("0 inf\n0.01 1\n", 1, "", "not a number");
    refuses("time_s,acceleration_mps2\n0,1e999\n0.01,1\n", 2, "", "too large");
    refuses("time_s,acceleration_mps2\n0,1\n0.01,\n0.02,2\n", 3, "", "1 value");
    refuses("time_s,a (g),b\n0,1,2\n0.01,,3\n0.02,2,1\n", 3, "", "empty field");
    refuses("1\n2\n3x\n4\n", 3, "", "\"3x\" is not a number");
    refuses("1\n2\n0x10\n", 3, "", "is not a number");
    refuses("1.5\n2.5\n1.2.3\n", 3, "", "separator");
    refuses("1.5\n2.5\n1E-021.5\n", 3, "", "separator"); /* 1E-02 and 1.5, or 1E-021 and .5 */
    refuses("1.5\n2.5\n********\n", 3, "", "is not a number");
    refuses("PEER\nA\nUNITS OF G\nNPTS= 3, DT= .01 SEC\n1 2\n*******\n", 6, "", "is not a number");
    refuses("time_s,acceleration_mps2\n0,1\n0.01,\"2\n0.02,3\n", 3, "", "quotation mark");
    refuses("time_s,acceleration_mps2\n0,1\n0.01,2\"3\n0.02,3\n", 3, "", "quotation mark");
}
END_TEST

START_TEST(commas_for_points)
{
    refuses("t;a (g)\n0.00;0,5\n0.01;0,6\n0.02;0,7\n", 2, "", "0.5, not 0,5"); /* or 5 and 6 */
    refuses("t;a (g)\n0,00;1.234,5\n0,01;0,6\n", 2, "", "a comma");
    refuses("t;a (g)\n0,00;0,6\n0,01;1,234,5\n", 3, "", "\"1,234,5\" is not a number");
    refuses("0,01 0,5\n0,02 0,6\n", 1, "", "a comma");
    refuses("0,01\t0,5\n0,02\t0,6\n", 1, "", "a comma");
    refuses("0,0123\n0,0456\n-0,0789\n", 1, "", "a comma");
    refuses("time,acc (g)\n0,00,0,0123\n0,02,0,0456\n", 2, "", "a comma");
    choice.column = 2; /* the user knows that it separates */
    choice.dt_s = 1;
    strcpy(choice.unit, "m/s2");
    const double whole[] = {5, 7, 6};
    reads("1,5\n4,7\n9,6\n", "CSV", 1, 3, whole);
}
END_TEST

START_TEST(asked_for_by_name)
{
    refuses("0.1\n0.2\n0.3\n", 0, "dt", "`record.dt");
    choice.dt_s = 0.01;
    refuses("0.1\n0.2\n0.3\n", 0, "unit", "`record.unit");
    strcpy(choice.unit, "furlong");
    refuses("0.1\n0.2\n0.3\n", 0, "unit", "cm/s2");
    strcpy(choice.unit, "g");
    refuses("0.1 0.2\n0.3 0.2\n", 1, "column", "`record.column");
    refuses("0.1 0.2 0.5\n0.3 0.2 0.5\n", 1, "column", "`record.column: all`");
    refuses("time_s,x (g),y (g)\n0,1,2\n0.01,2,3\n0.02,3,4\n", 2, "column", "2 x (g), 3 y (g)");
    strcpy(choice.channel, "z");
    refuses("time_s,x (g),y (g)\n0,1,2\n0.01,2,3\n0.02,3,4\n", 2, "channel", "y (g)");
    choice.channel[0] = '\0';
    choice.column = 1;
    refuses("time_s,x (g),y (g)\n0,1,2\n0.01,2,3\n0.02,3,4\n", 2, "column", "is the time");
    choice.column = 4;
    refuses("time_s,x (g),y (g)\n0,1,2\n0.01,2,3\n0.02,3,4\n", 2, "column", "no column 4");
    choice.column = 0;
    refuses("0.02 0.5\n1 2 3 4 5\n6 7 8 9 1\n", 2, "skip", "`record.skip: 1`");
    refuses("4 0.02\n1\n2\n3\n4\n", 2, "skip", "`record.skip: 1` and `record.dt: 0.02 s` if line 1 states 4 samples");
    refuses("0.02 4\n1\n2\n3\n4\n", 2, "skip", "`record.skip: 1` and `record.dt: 0.02 s` if line 1 states 4 samples");
    refuses("5 0.02\n1 2 3\n4 5\n", 2, "skip", "`record.skip: 1` and `record.dt: 0.02 s`");
    refuses("1 2 3\n4 5 6\n7 8", 1, "column", "`record.column"); /* cut off: no line end */
    choice.column = 1;
    refuses("1 2 3\n4 5 6\n7 8\n", 3, "", "2 values in the last line");
    choice.column = 0;
    refuses("1\n2\n3 4\n5\n", 3, "skip", "2 values");
    refuses("1 2\n3 4\n5\n6 7\n", 3, "", "1 value");
}
END_TEST

/* A unit that is not known in full is asked for, also where a comment tells of another. */
START_TEST(units_that_are_not_known)
{
    static const char *const units[] = {"[ug]",      "[\xc2\xb5g]", "[10^-3 g]",    "[g*100]",
                                        "[V/g]",     "[counts/g]",  "[10^-3 m/s2]", "(g/Hz)",
                                        "(V per g)", "(counts)",    "[m/s2 * 100]"};
    static const char *const times[] = {"Time (ks)", "t [h]", "time_h", "timestamp_ticks"};
    char text[200];
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        snprintf(text, sizeof text, "# units: g\ntime;acc %s\n0;0.1\n5;-0.2\n10;0.3\n", units[i]);
        refuses(text, 2, "unit", "`record.unit");
        ck_assert_ptr_nonnull(strstr(err.what, "is not known"));
    }
    refuses("time;acc milli g\n0;0.1\n5;-0.2\n10;0.3\n", 0, "unit", "`record.unit");
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        snprintf(text, sizeof text, "%s;acc (g)\n0;0.1\n5;-0.2\n10;0.3\n", times[i]);
        refuses(text, 1, "dt", "is not known");
    }
    refuses("PEER\nA\nUNITS OF G\nNPTS= 2, DT= .01 HOURS\n1 2\n", 4, "", "DT in another unit");
    strcpy(choice.unit, "g");
    choice.dt_s = 0.01;
    const double a[] = {G(0.1), G(-0.2)};
    reads("time (ks);acc [V/g]\n0;0.1\n5;-0.2\n", "CSV", 0.01, 2, a);
}
END_TEST

START_TEST(what_the_file_says_stands)
{
    const char *at2 = "PEER\nA\nUNITS OF G\nNPTS= 2, DT= .01 SEC\n1 2\n";
    choice.dt_s = 0.02;
    refuses(at2, 4, "", "0.01 s, `record.dt` says 0.02 s");
    choice.dt_s = 0.01;
    strcpy(choice.unit, "m/s2");
    refuses(at2, 3, "", "another unit");
    strcpy(choice.unit, "g");
    const double a[] = {G(1), G(2)};
    reads(at2, "PEER AT2", 0.01, 2, a);
    choice.unit[0] = '\0';
    const double b[] = {1, 2};
    choice.dt_s = 0.02; /* prose may be about something else: the option decides */
    reads("# dt=0.01 for the other file; Acc. in m/s2\n1\n2\n", "plain columns", 0.02, 2, b);
    choice.dt_s = NAN;
    refuses("# dt=0.01\ntime_s,acceleration_mps2\n0,1\n0.02,2\n0.04,3\n", 1, "dt", "0.01 s, the time column 0.02 s");
    refuses("# Acc. in m/s2\n# acc. in cm/s2, dt = 1 s\n1\n2\n", 0, "unit", "`record.unit");
    refuses("time_s,acceleration_mps2\n0,1\n0.01,2\n0.02,2\n0.05,3\n0.06,1\n", 5, "resample",
            "`record.resample: 0.01 s`");
}
END_TEST

static void overwrite(char *text, const char *what, const char *with)
{
    char *at = strstr(text, what);
    ck_assert_ptr_nonnull(at);
    for (size_t i = 0; with[i]; i++)
        at[i] = with[i];
}

START_TEST(counts_that_differ)
{
    refuses("PEER\nA\nUNITS OF G\nNPTS= 4, DT= .01 SEC\n1 2 3\n", 4, "",
            "4 samples, but the file contains 3 (cut off?)");
    refuses("PEER\nA\nUNITS OF G\nNPTS= 2, DT= .01 SEC\n1 2 3\n", 4, "", "`record.skip: 4`");
    refuses("PEER\nA\nUNITS OF G\nNPTS= 99999999999, DT= .01 SEC\n1 2 3\n", 4, "", "has only");
    refuses("PEER\nA\nUNITS OF G\nNPTS= -3, DT= .01 SEC\n1 2 3\n", 4, "", "-3 samples");
    refuses("PEER\nA\nUNITS OF G\nNPTS= 2.5, DT= .01 SEC\n1 2 3\n", 4, "", "2.5 samples");
    refuses("PEER\nA\nUNITS OF G\nNPTS= 3, DT= 0 SEC\n1 2 3\n", 4, "", "time step of 0 s");
    refuses("PEER\nA\nUNITS OF G\nNPTS= 3, DT= -1 SEC\n1 2 3\n", 4, "", "time step of -1 s");
    refuses("PEER\nA\nUNITS OF G\nNPTS=, DT= SEC\n1 2 3\n", 4, "", "no numbers");
    refuses("PEER\nA\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 3, DT= .01 SEC\n1 2 3\n", 3, "", "velocities");
    refuses("PEER\nA\nno unit\nNPTS= 3, DT= .01 SEC\n1 2 3\n", 0, "unit", "`record.unit");
    choice.skip = 4;
    const double a[] = {G(1), G(2), G(3)}; /* the skipped lines still tell unit and step */
    reads("PEER\nA\nUNITS OF G\nNPTS= 4, DT= .01 SEC\n1\n2\n3\n", "plain columns", 0.01, 3, a);
    choice.skip = 99;
    refuses("1\n2\n", 0, "", "no accelerogram");
    choice.skip = -1;
    char text[400];
    memcpy(text, esm, sizeof esm);
    overwrite(text, "NDATA: 3", "NDATA: 4");
    refuses(text, 11, "", "4 samples, but the file contains 3");
    memcpy(text, esm, sizeof esm);
    overwrite(text, "cm/s^2", "cm/s  ");
    refuses(text, 6, "", "not a unit of acceleration");
    memcpy(text, esm, sizeof esm);
    overwrite(text, "ACCELERATION", "VELOCITY    ");
    refuses(text, 7, "", "VELOCITY");
    refuses("Origin Time x\nScale Factor      3920(gal)/0\nMemo.\n1 2 3\n", 2, "", "scale factor");
    refuses("Origin Time x\nSampling Freq(Hz) 100Hz\nScale Factor      3920(gal)/10\n1 2 3\n", 4, "", "Memo.");
    refuses(
        "Origin Time x\nSampling Freq(Hz) 100Hz\nDuration Time(s)  50\nScale Factor      3920(gal)/10\nMemo.\n1 2 3\n",
        6, "", "cut off");
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("record refusals");
    TCase *all = tcase_create("all");
    tcase_add_checked_fixture(all, setup, teardown);
    tcase_add_test(all, no_record_at_all);
    tcase_add_test(all, numbers_that_are_none);
    tcase_add_test(all, commas_for_points);
    tcase_add_test(all, asked_for_by_name);
    tcase_add_test(all, units_that_are_not_known);
    tcase_add_test(all, what_the_file_says_stands);
    tcase_add_test(all, counts_that_differ);
    suite_add_tcase(suite, all);
    return suite;
}
