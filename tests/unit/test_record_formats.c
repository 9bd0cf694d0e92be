/* Small hand-made files of every format, whole and damaged in every way: what is right reads, what is wrong names line
 * and reason, what is not said is asked for. */
#include "record_text.h"

#include <unistd.h>

static const double three[] = {0.1, -0.2, 0.3};

START_TEST(csv_in_its_spellings)
{
    reads("time_s,acceleration_mps2\n0,0.1\n0.01,-0.2\n0.02,0.3\n", "CSV", 0.01, 3, three);
    reads("t;acc (m/s^2)\r\n0;.1\r\n.01;-.2\r\n.02;.3\r\n", "CSV", 0.01, 3, three);
    reads("\xef\xbb\xbf"
          "time,acc [cm/s2]\n0,10\n0.5,-20\n1,30\n",
          "CSV", 0.5, 3, three);
    reads("# acceleration in cm/s/s, dt = 0.02 s\n10,\n-20,\n30,\n", "CSV", 0.02, 3, three);
    reads("time (ms), acc (gal)\n0, 10\n5, -20\n10, 30\n", "CSV", 0.005, 3, three);
    reads("\"time, s\",\"acc, m/s2\"\n\"0\",\"0.1\"\n0.01,\"-0.2\"\n0.02,0.3\n", "CSV", 0.01, 3, three);
    reads("time_s,velocity_mps,acceleration_mps2\n0,9,0.1\n0.01,9,-0.2\n\n% between\n0.02,9,0.3\n", "CSV", 0.01, 3,
          three);
    reads("0,1e-1\n0.01,-2D-1\n0.02,3.0E-001\n#unit: m/s2, acceleration in m/s2", "CSV", 0.01, 3, three);
}
END_TEST

/* As spreadsheets of most of Europe write numbers, also where all but the last are whole. */
START_TEST(decimal_commas_between_semicolons)
{
    const double a[] = {0.5, -0.1, 2, 0.6};
    reads("\xef\xbb\xbfZeit (s);NS (m/s\xb2)\r\n0,00;0,5\r\n0,01;-,1\r\n0,02;2\r\n0,03;6,0e-1\r\n", "CSV", 0.01, 4, a);
    char late[2000] = "t;a (m/s2)\n"; /* whole numbers up to the last one */
    double value[80];
    for (int i = 0; i < 80; i++) {
        value[i] = i < 79 ? 1 : 1.5;
        snprintf(late + strlen(late), sizeof late - strlen(late), i < 79 ? "%d;1\n" : "%d;1,5\n", i);
    }
    reads(late, "CSV", 1, 80, value);
}
END_TEST

/* What stands for the same times and accelerations, and each is read as what it says. */
START_TEST(headers_with_units)
{
    static const struct {
        const char *name;
        double dt_s;
    } times[] = {{"Time(msec)", 0.005},  {"t [msec]", 0.005},        {"Time (MS)", 0.005},
                 {"timestamp_us", 5e-6}, {"t [min]", 300},           {"time", 5},
                 {"TIME (SEC)", 5},      {"timestamp (s)", 5},       {"t, s", 5},
                 {"time in ms", 0.005},  {"Time (\xc2\xb5s)", 5e-6}, {"Time since start (milliseconds)", 0.005}};
    static const struct {
        const char *name;
        double factor;
    } units[] = {{"(g)", THUD_GRAVITY},
                 {"[G]", THUD_GRAVITY},
                 {"in g", THUD_GRAVITY},
                 {"_g", THUD_GRAVITY},
                 {"[mg]", THUD_GRAVITY / 1000},
                 {"(m/s2)", 1},
                 {"_mps2", 1},
                 {"m/(s^2)", 1},
                 {"(N-S) (GAL)", 0.01},
                 {"[units: cm/s/s]", 0.01},
                 {"(m/s\xc2\xb2)", 1}};
    char text[200];
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        snprintf(text, sizeof text, "%s;acc (m/s2)\n0;0.1\n5;-0.2\n10;0.3\n", times[i].name);
        reads(text, "CSV", times[i].dt_s, 3, three);
    }
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        const double a[] = {units[i].factor * 0.1, units[i].factor * -0.2, units[i].factor * 0.3};
        snprintf(text, sizeof text, "t;acc%s%s\n0;0.1\n5;-0.2\n10;0.3\n", units[i].name[0] == '_' ? "" : " ",
                 units[i].name);
        reads(text, "CSV", 5, 3, a);
    }
    const double b[] = {G(1), G(2)};
    reads("PEER\nA\nUNITS OF G\nNPTS= 2, DT= 10 MSEC\n1 2\n", "PEER AT2", 0.01, 2, b);
    reads("# dt = 10 msec, acceleration in m/s2\n0.1\n-0.2\n0.3\n", "plain columns", 0.01, 3, three);
}
END_TEST

START_TEST(columns_in_their_spellings)
{
    reads("% Acc. in m/s2 and dt=0.01 sec.\r\n 0.1 \r\n-.2\r\n 3.0e-001\r\n", "plain columns", 0.01, 3, three);
    reads("; acc in gal\nTime (s)\tAcc (gal)\n0\t10\n0.01\t\t-20\n0.02\t30\n", "plain columns", 0.01, 3, three);
    reads("time acc (m/s/s)\n 0 0.1\r 0.01-0.2\r 0.02 0.3\r", "plain columns", 0.01, 3, three); /* CR alone; touching */
    choice.dt_s = 0.01;
    strcpy(choice.unit, "m/s2");
    reads("0.1\n-0.2\n0.3", "plain columns", 0.01, 3, three);
    const double touching[] = {0.01, -0.036, 1e-100, -1.5e-99, 2, 3};
    choice.column = -1;
    reads("1.0E-02-3.6E-02\n1.000-100-1.5D-099\n2 3\n", "plain columns", 0.01, 6, touching);
    choice.column = 2;
    reads("9 0.1\n9 -0.2\n9 0.3\n", "plain columns", 0.01, 3, three);
    choice.column = 0;
    const double list[] = {1, 2, 3, 4, 5, 6, 7, 8};
    reads("1 2 3\n4 5 6\n7 8\n", "plain columns", 0.01, 8, list); /* the short last line tells */
    choice.skip = 2;
    reads("3 0.01\n1 2\n0.1\n-0.2\n0.3\n", "plain columns", 0.01, 3, three);
}
END_TEST

START_TEST(at2_in_its_spellings)
{
    const double a[] = {G(0.1), G(-0.2), G(0.3), G(-0.4), G(0.5), G(-0.6)};
    const char *body = "   .1000000E+00  -.2000000E+00   .3000000E+00  -.4000000E+00   .5000000E+00\n  -.6000000E+00\n";
    static const char *const counts[] = {"NPTS=      6, DT=   .0100 SEC,   ",
                                         "NPTS =   6 , DT =   .010 SEC ,",
                                         "NPTS= 6, DT= .01000 SEC",
                                         "6   0.0100   NPTS, DT",
                                         "  6    .01   NPTS, DT(SEC)",
                                         "npts=6 dt=0.01",
                                         "NPTS=6,DT=.01SEC",
                                         "NPTS:  6, DT: .01 SEC"};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        char text[600];
        snprintf(text, sizeof text,
                 "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/2/2003, A Station, 90\n%s\n%s\n%s",
                 i % 2 ? "ACCELERATION TIME SERIES IN UNITS OF G"
                       : "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.2 Hz",
                 counts[i], body);
        reads(text, "PEER AT2", 0.01, 6, a);
    }
    choice.dt_s = 0.01;
    strcpy(choice.unit, "g");
    reads(body, "PEER AT2 without header", 0.01, 6, a);
}
END_TEST

START_TEST(at2_with_touching_fields)
{
    const double a[] = {G(0.1), G(-0.036), G(-0.0003), G(0.33)};
    reads("PEER\nA, B, C\nIN UNITS OF G\nNPTS= 4, DT= .01 SEC\n .1000000E+00-3.6000000E-02-.3000000E-003+3.3D-01\n",
          "PEER AT2", 0.01, 4, a);
}
END_TEST

START_TEST(knet_counts_scale_and_lose_their_mean)
{
    const double scale = 3920.0 / 6182761 * 0.01;
    const double a[] = {scale * -5, scale * 5, scale * 0, scale * 0};
    char text[900];
    for (int kik = 0; kik < 2; kik++) {
        snprintf(
            text, sizeof text,
            "Origin Time       2018/01/24 19:51:00\nStation Code      AOM001\nRecord Time       2018/01/24 19:51:43\n"
            "Sampling Freq(Hz) 100Hz\nDuration Time(s)  0\nDir.              %s\nScale Factor      3920(gal)/6182761\n"
            "Max. Acc. (gal)   4.078\nMemo.             \n  -12085  -12075  -12080\n  -12080 \n",
            kik ? "4" : "E-W");
        reads(text, kik ? "KiK-net" : "K-NET", 0.01, 4, a);
    }
}
END_TEST

static const char csmip[] =
    "CORRECTED ACCELEROGRAM   36456       CHAN  1:  90 DEG     FROM\nx\nSOME EARTHQUAKE\n"
    "    3 POINTS OF ACCEL DATA EQUALLY SPACED AT  .010 SEC.  (UNITS: CM/SEC/SEC)\n    10.000   -20.000    30.000\n"
    "    3 POINTS OF VELOC DATA EQUALLY SPACED AT  .010 SEC.  (UNITS: CM/SEC)\n    1.000   -2.000    3.000\n"
    "/&  ----------  END OF DATA FOR CHANNEL  1  ----------\n"
    "CHAN  2: UP\n"
    "    3 POINTS OF ACCEL DATA EQUALLY SPACED AT  .010 SEC.  (UNITS: CM/SEC/SEC)\n-12345.678-12345.67812345.678\n";

START_TEST(esm_and_csmip)
{
    reads(esm, "ESM", 0.01, 3, three);
    strcpy(choice.channel, "90 deg");
    reads(csmip, "CSMIP V2", 0.01, 3, three);
    strcpy(choice.channel, "1");
    reads(csmip, "CSMIP V2", 0.01, 3, three);
    const double wide[] = {-123.45678, -123.45678, 123.45678}; /* F10.3, filled to the last column */
    strcpy(choice.channel, "UP");
    reads(csmip, "CSMIP V2", 0.01, 3, wide);
    choice.channel[0] = '\0';
    refuses(csmip, 0, "channel", "1 90 DEG, 2 UP");
    strcpy(choice.channel, "N13E");
    refuses(csmip, 0, "channel", "N13E");
}
END_TEST

/* The name follows the line with the station's number, whatever lines a header lacks; samples are no name. */
START_TEST(station_of_a_cut_csmip_header)
{
    char text[1200];
    for (int named = 0; named < 2; named++) {
        snprintf(text, sizeof text, "%s%s", named ? "STATION NO. 36456   35.908N\nPARKFIELD  FAULT ZONE 14\n" : "",
                 csmip);
        strcpy(choice.channel, "1");
        ck_assert_int_eq(parse(text), THUD_OK);
        ck_assert_str_eq(record->station, named ? "PARKFIELD FAULT ZONE 14" : "");
        teardown();
        record = NULL;
    }
}
END_TEST

static void geonet(char *text, size_t size, const char *samples)
{
    snprintf(text, size,
             "Corrected accelerogram 1\nSite WTMC      42 37\nTe Mara\nInstrument\nResolution\nAcc\n5 km\n2016 "
             "November 13\nEpicentre\n"
             "Number of points  3    Duration 0.02 sec\nInstrument corrected data at 0.010 sec intervals\nBand-pass\n"
             "Component N28W  Longitudinal\nAcceleration:  peak  -9733.1 mm/s/s at  44.88 sec\nVelocity: peak 1 mm/s\n"
             "Displacement: peak 1 mm\n1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n%s",
             samples);
}

START_TEST(geonet_by_columns)
{
    char text[1200];
    const double close[] = {-111.0247, -111.0247, 0.3};
    geonet(text, sizeof text, "   100.0  -200.0   300.0\n1\n");
    reads(text, "GeoNet V2A", 0.01, 3, three);
    geonet(text, sizeof text, "-11102.5-11102.5   300.0\n");
    const double rounded[] = {-11.1025, -11.1025, 0.3};
    reads(text, "GeoNet V2A", 0.01, 3, rounded);
    geonet(text, sizeof text, "-111024.7-111024.7 300\n"); /* an editor was here: no longer fields of eight */
    reads(text, "GeoNet V2A", 0.01, 3, close);
    geonet(text, sizeof text, "   100.0  -200.0\n");
    refuses(text, 27, "", "cut off");
}
END_TEST

static void smc(char *text, size_t size, const char *count, const char *samples)
{
    size_t n = 0;
    n += (size_t)snprintf(text + n, size - n, "2 CORRECTED ACCELEROGRAM\n");
    for (int i = 0; i < 10; i++)
        n += (size_t)snprintf(text + n, size - n, i == 4 ? "station = A, B component= 360\n" : "*\n");
    for (int i = 0; i < 48; i++)
        n += (size_t)snprintf(text + n, size - n, "%10s%s",
                              i == 16   ? count
                              : i == 15 ? "1"
                                        : "-32768",
                              i % 8 == 7 ? "\r\n" : "");
    for (int i = 0; i < 50; i++)
        n += (size_t)snprintf(text + n, size - n, "%15s%s", i == 1 ? "0.1000000E+03" : "0.1700000E+39",
                              i % 5 == 4 ? "\r\n" : "");
    snprintf(text + n, size - n, "|a comment\r\n%s", samples);
}

START_TEST(smc_by_columns)
{
    char text[3000];
    smc(text, sizeof text, "3", " 1.0000E+1-2.0000E+1 3.0000E+1\r\n");
    reads(text, "USGS SMC", 0.01, 3, three);
    smc(text, sizeof text, "4", " 1.0000E+1-2.0000E+1 3.0000E+1\r\n");
    refuses(text, 29, "", "cut off");
    smc(text, sizeof text, "2000000000", " 1.0000E+1-2.0000E+1 3.0000E+1\r\n");
    refuses(text, 14, "", "2000000000 samples");
    smc(text, sizeof text, "-32768", " 1.0000E+1\r\n");
    refuses(text, 14, "", "-32768 samples");
}
END_TEST

static void cosmos(char *text, size_t size, const char *interval, const char *block)
{
    size_t n = 0;
    n += (size_t)snprintf(
        text + n, size - n,
        "Corrected acceleration    (Format v01.20 with 4 text lines)\nRecord of X\nStatn No: 1 Code:AK-BMR\n"
        "Sta Chan   1: 360 deg (x)\n   10 Integer-header values follow on  1 lines, Format= (10I8)\n");
    for (int i = 0; i < 10; i++)
        n += (size_t)snprintf(text + n, size - n, "%8d", -999);
    n += (size_t)snprintf(text + n, size - n, "\n  100 Real-header values follow on  20 lines, Format= (5F15.6)\n");
    for (int i = 0; i < 100; i++)
        n += (size_t)snprintf(text + n, size - n, "%15s%s",
                              i == 61   ? interval
                              : i == 33 ? "0.020000"
                                        : "-999.000000",
                              i % 5 == 4 ? "\n" : "");
    snprintf(text + n, size - n, "   0 Comment line(s) follow\n%s", block);
}

START_TEST(cosmos_by_columns)
{
    char text[4000];
    cosmos(text, sizeof text, "10.000000",
           "   3 acceleration pts, approx  0 secs, units=cm/sec2(04),Format=(8F10.3)\n    10.000   -20.000    "
           "30.000\nEnd-of-data\n"
           "   3 velocity pts, approx  0 secs, units=cm/sec(05),Format=(8F10.3)\n     1.000     2.000     3.000\n");
    reads(text, "COSMOS V2", 0.01, 3, three);
    cosmos(text, sizeof text, "-999.000000",
           "   3 acceleration pts, approx 0 secs, units=cm/sec2(04),Format=(1E15.6)\n   10\n  -20\n   30\n");
    refuses(text, 0, "dt", "`record.dt");
    choice.dt_s = 0.01;
    reads(text, "COSMOS V2", 0.01, 3, three);
    cosmos(text, sizeof text, "10.0",
           "   3 velocity pts, approx 0 secs, units=cm/sec(05),Format=(1E15.6)\n   10\n  -20\n   30\n");
    refuses(text, 0, "", "no accelerations");
}
END_TEST

/* Straight lines between samples whose times are not equally apart; only where it is asked for. */
START_TEST(unequal_steps_are_resampled)
{
    const char *text = "time (ms),a (m/s2)\n10,0\n20,1\n40,-1\n45,4\n110,-9\n";
    const double even[] = {0, 1, 0, -1, 3.8, 1.8, -0.2, -2.2, -4.2, -6.2, -8.2}; /* 4 to -9 in 65 ms: -2 in 10 ms */
    choice.resample_s = 0.01;
    ck_assert_int_eq(parse(text), THUD_OK);
    ck_assert_uint_eq(record->samples, 11);
    ck_assert_double_eq(record->dt_s, 0.01);
    for (int i = 0; i < 4; i++)
        ck_assert_double_eq_tol(record->a_mps2[i], even[i], 1e-12);
    for (int i = 4; i < 11; i++)
        ck_assert_double_eq_tol(record->a_mps2[i], 4 - 13 * (10.0 * i - 35) / 65, 1e-12);
    ck_assert_ptr_nonnull(strstr(record->note, "5 samples in unequal steps"));
    thud_record_free(record);
    record = NULL;
    choice.resample_s = 0.2;
    refuses(text, 0, "resample", "at most 0.1 s");
    choice.resample_s = 0.01;
    refuses("time,a (g)\n0,1\n0.3,2\n0.3,2\n0.5,1\n", 4, "", "are not increasing");
    reads("time_s,acceleration_mps2\n0,0.1\n0.02,-0.2\n0.04,0.3\n", "CSV", 0.02, 3, three); /* left to who asked */
}
END_TEST

/* gzip -n of "1\n2\n3\n", and what may have become of it. */
static const unsigned char packed[] = {0x1f, 0x8b, 0x08, 0,    0, 0,    0,    0,    0,    0x03, 0x33, 0xe4, 0x32,
                                       0xe2, 0x32, 0xe6, 0x02, 0, 0xd8, 0x54, 0x5f, 0x77, 6,    0,    0,    0};

static enum thud_status read_packed(const unsigned char *bytes, size_t size)
{
    char path[] = "/tmp/thud-gzip-XXXXXX";
    int fd = mkstemp(path);
    ck_assert_int_ge(fd, 0);
    ck_assert_int_eq(write(fd, bytes, size), (ssize_t)size);
    close(fd);
    enum thud_status status = thud_record_file_read(path, &choice, &record, &err);
    unlink(path);
    return status;
}

START_TEST(compressed_by_gzip)
{
    unsigned char other[2 * sizeof packed];
    choice.dt_s = 0.01;
    strcpy(choice.unit, "m/s2");
    ck_assert_msg(read_packed(packed, sizeof packed) == THUD_OK, "%s", err.what);
    ck_assert_uint_eq(record->samples, 3);
    ck_assert_double_eq(record->a_mps2[2], 3);
    thud_record_free(record);
    memcpy(other, packed, sizeof packed); /* two members one after the other, as cat makes them */
    memcpy(other + sizeof packed, packed, sizeof packed);
    ck_assert_int_eq(read_packed(other, sizeof other), THUD_OK);
    ck_assert_uint_eq(record->samples, 6);
    thud_record_free(record);
    record = NULL;
    for (size_t size = 2; size < sizeof packed; size++) {
        ck_assert_int_eq(read_packed(packed, size), THUD_INPUT);
        ck_assert_msg(strstr(err.what, "cut off"), "%zu bytes: %s", size, err.what);
    }
    memcpy(other, packed, sizeof packed);
    other[19] ^= 1; /* of the check sum */
    ck_assert_int_eq(read_packed(other, sizeof packed), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.what, "damaged"));
}
END_TEST

START_TEST(texts_are_kept)
{
    ck_assert_int_eq(parse("PEER NGA\nImperial Valley-02, 5/19/1940, El Centro Array #9, 180\nIN UNITS OF G\nNPTS= 2, "
                           "DT= .01 SEC\n1 2\n"),
                     THUD_OK);
    ck_assert_str_eq(record->event, "Imperial Valley-02, 5/19/1940");
    ck_assert_str_eq(record->station, "El Centro Array #9");
    ck_assert_str_eq(record->component, "180");
    teardown();
    ck_assert_int_eq(parse("# station: A\x1b[31mB\n# dt: 0.01 s\n# component: N\nacc (g)\n1,\n2,\n"), THUD_OK);
    ck_assert_str_eq(record->station, "A?[31mB"); /* a terminal is not to obey a file */
    ck_assert_str_eq(record->component, "N");
}
END_TEST

START_TEST(scaled_as_asked)
{
    const char *text = "time_s,acceleration_mps2\n0,0.1\n0.01,-0.2\n0.02,0.3\n";
    const double factor[] = {-0.3, 0.6, -0.9}, peak[] = {2, -4, 6};
    choice.factor = 3;
    choice.sign = -1;
    reads(text, "CSV", 0.01, 3, factor);
    choice.sign = 1;
    choice.factor = 1;
    choice.peak_mps2 = 6;
    reads(text, "CSV", 0.01, 3, peak);
    refuses("dt=1s\nacc in g\n0\n0\n", 0, "peak", "zeros");
}
END_TEST

/* The part first: its own peak is what is scaled. */
START_TEST(a_part_of_the_motion)
{
    const char *text = "time_s,acceleration_mps2\n0,0.9\n0.01,-0.2\n0.02,0.3\n0.03,0.1\n";
    const double late[] = {-0.2, 0.3, 0.1}, early[] = {0.9, -0.2}, middle[] = {-4, 6};
    choice.from_s = 0.01;
    reads(text, "CSV", 0.01, 3, late);
    choice.from_s = 0.005; /* between two samples: from the next one on */
    reads(text, "CSV", 0.01, 3, late);
    choice.from_s = NAN;
    choice.to_s = 0.01;
    reads(text, "CSV", 0.01, 2, early);
    choice.from_s = 0.01;
    choice.to_s = 0.02;
    choice.peak_mps2 = 6;
    reads(text, "CSV", 0.01, 2, middle);
    choice.from_s = 0.02;
    refuses(text, 0, "from", "two samples");
}
END_TEST

/* Every file cut at every byte: refused or read, never a crash, and never more samples than the whole has. */
START_TEST(cut_anywhere)
{
    char smc_text[3000], cosmos_text[4000], geonet_text[1200];
    smc(smc_text, sizeof smc_text, "3", " 1.0000E+1-2.0000E+1 3.0000E+1\r\n");
    cosmos(cosmos_text, sizeof cosmos_text, "10.0",
           "   3 acceleration pts, approx 0 secs, units=cm/sec2(04),Format=(1E15.6)\n   10\n  -20\n   30\n");
    geonet(geonet_text, sizeof geonet_text, "   100.0  -200.0   300.0\n");
    const char *whole[] = {smc_text, cosmos_text, geonet_text, esm, csmip};
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++)
        for (size_t n = 0; n < strlen(whole[i]); n++) {
            enum thud_status status = thud_record_parse(whole[i], n, "file", &choice, &record, &err);
            ck_assert(status == THUD_OK || status == THUD_INPUT);
            ck_assert((status == THUD_OK) == (record != NULL));
            if (record)
                ck_assert_uint_le(record->samples, 3);
            else
                ck_assert_int_ne(err.what[0], '\0');
            thud_record_free(record);
            record = NULL;
        }
}
END_TEST

Suite *thud_suite(void)
{
    Suite *suite = suite_create("record formats");
    TCase *all = tcase_create("all");
    tcase_add_checked_fixture(all, setup, teardown);
    tcase_add_test(all, csv_in_its_spellings);
    tcase_add_test(all, decimal_commas_between_semicolons);
    tcase_add_test(all, headers_with_units);
    tcase_add_test(all, columns_in_their_spellings);
    tcase_add_test(all, at2_in_its_spellings);
    tcase_add_test(all, at2_with_touching_fields);
    tcase_add_test(all, knet_counts_scale_and_lose_their_mean);
    tcase_add_test(all, esm_and_csmip);
    tcase_add_test(all, station_of_a_cut_csmip_header);
    tcase_add_test(all, geonet_by_columns);
    tcase_add_test(all, smc_by_columns);
    tcase_add_test(all, cosmos_by_columns);
    tcase_add_test(all, unequal_steps_are_resampled);
    tcase_add_test(all, compressed_by_gzip);
    tcase_add_test(all, texts_are_kept);
    tcase_add_test(all, scaled_as_asked);
    tcase_add_test(all, a_part_of_the_motion);
    tcase_add_test(all, cut_anywhere);
    suite_add_tcase(suite, all);
    return suite;
}
