/* Design spectra of codes, a row of `codes` each: a new one is a row, its words and its Sa.
 *
 * EN 1998-1:2004, 3.2.2.2(1), horizontal, eta = sqrt(10/(5 + xi)) >= 0.55 with the damping xi in per cent:
 *
 *     0  <= T <= TB   Se = a_g S (1 + T/TB (2.5 eta - 1))
 *     TB <= T <= TC   Se = 2.5 a_g S eta
 *     TC <= T <= TD   Se = 2.5 a_g S eta TC/T
 *     TD <= T         Se = 2.5 a_g S eta TC TD/T^2            (the code: up to 4 s)
 *
 * ASCE 7-16, 11.4.6, T0 = 0.2 S_D1/S_DS, TS = S_D1/S_DS, damping 5 %:
 *
 *     T <= T0         Sa = S_DS (0.4 + 0.6 T/T0)
 *     T0 <= T <= TS   Sa = S_DS
 *     TS <= T <= TL   Sa = S_D1/T
 *     TL <= T         Sa = S_D1 TL/T^2
 *
 * ASCE 7-22, 11.4.5.1 (multi-period): straight lines between the given periods; beyond the last, T_n, Sa(T_n) T_n/T up
 * to TL and Sa(T_n) T_n TL/T^2 from there on.
 *
 * GB 50011-2010, 5.1.5, with the damping z, g = 0.9 + (0.05 - z)/(0.3 + 6 z), n1 = 0.02 + (0.05 - z)/(4 + 32 z) >= 0
 * and n2 = 1 + (0.05 - z)/(0.08 + 1.6 z) >= 0.55, up to 6 s, in units of gravity:
 *
 *     T <= 0.1 s      a = a_max (0.45 + (n2 - 0.45) T/0.1)
 *     0.1 s <= T <= Tg      a = a_max n2
 *     Tg <= T <= 5 Tg       a = a_max n2 (Tg/T)^g
 *     5 Tg <= T             a = a_max (n2 0.2^g - n1 (T - 5 Tg))
 *
 * NZS 1170.5:2004, 3.1.1 and the equations of C3.1.2, 5 %: Sa = g C_h(T) Z R, with near-fault factor N(T,D) = 1 (20 km
 * or more from the major faults of table 3.6). C_h rises from C_h(0) to a plateau from 0.1 s to T_p, falls as T^-0.75
 * up to 1.5 s, as 1/T up to 3 s, and as 1/T^2 from there on. */
#include "ground/target.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "ground/spectrum.h"

/* EN 1998-1, tables 3.2 (type 1) and 3.3 (type 2): ground A to E. */
static const struct {
    double s, tb_s, tc_s, td_s;
} ground[2][5] = {
    {{1, 0.15, 0.4, 2}, {1.2, 0.15, 0.5, 2}, {1.15, 0.2, 0.6, 2}, {1.35, 0.2, 0.8, 2}, {1.4, 0.15, 0.5, 2}},
    {{1, 0.05, 0.25, 1.2},
     {1.35, 0.05, 0.25, 1.2},
     {1.5, 0.1, 0.25, 1.2},
     {1.8, 0.1, 0.3, 1.2},
     {1.6, 0.05, 0.25, 1.2}}};

static double eta_of(const struct thud_target *t)
{
    return fmax(0.55, sqrt(10 / (5 + 100 * t->damping)));
}

static double en1998_at(const struct thud_target *t, double period_s)
{
    const double plateau = t->ag_mps2 * ground[t->type][t->ground].s, tb = ground[t->type][t->ground].tb_s,
                 tc = ground[t->type][t->ground].tc_s, td = ground[t->type][t->ground].td_s, eta = eta_of(t),
                 top = 2.5 * eta * plateau;
    if (period_s < tb)
        return plateau * (1 + period_s / tb * (2.5 * eta - 1));
    if (period_s <= tc)
        return top;
    return period_s <= td ? top * tc / period_s : top * tc * td / (period_s * period_s);
}

static double asce7_at(const struct thud_target *t, double period_s)
{
    double ts = t->sd1_mps2 / t->sds_mps2 /* of accelerations at 1 s */, t0 = 0.2 * ts;
    if (period_s < t0)
        return t->sds_mps2 * (0.4 + 0.6 * period_s / t0);
    if (period_s <= ts)
        return t->sds_mps2;
    return period_s <= t->tl_s ? t->sd1_mps2 / period_s : t->sd1_mps2 * t->tl_s / (period_s * period_s);
}

/* Between the points of a table, straight on logarithmic axes or on linear ones; NaN outside. */
static double between_points(const struct thud_target *t, double period_s, bool linear)
{
    for (int i = 0; i < t->n; i++)
        if (t->period_s[i] == period_s)
            return t->sa_mps2[i];
    for (int i = 0; i + 1 < t->n; i++)
        if (period_s > t->period_s[i] && period_s < t->period_s[i + 1]) {
            const double *p = t->period_s + i, *a = t->sa_mps2 + i;
            if (linear || !(p[0] > 0))
                return a[0] + (a[1] - a[0]) * (period_s - p[0]) / (p[1] - p[0]);
            return a[0] * pow(a[1] / a[0], log(period_s / p[0]) / log(p[1] / p[0]));
        }
    return NAN;
}

static double points_at(const struct thud_target *t, double period_s)
{
    return between_points(t, period_s, false);
}

static double asce7_22_at(const struct thud_target *t, double period_s)
{
    const double last = t->n > 0 ? t->period_s[t->n - 1] : INFINITY;
    if (!(period_s > last && t->tl_s > 0))
        return between_points(t, period_s, true);
    return t->sa_mps2[t->n - 1] * last / period_s * fmin(1, t->tl_s / period_s);
}

static double gb50011_at(const struct thud_target *t, double period_s)
{
    const double z = t->damping, tg = t->tg_s, gamma = 0.9 + (0.05 - z) / (0.3 + 6 * z),
                 n1 = fmax(0, 0.02 + (0.05 - z) / (4 + 32 * z)), n2 = fmax(0.55, 1 + (0.05 - z) / (0.08 + 1.6 * z));
    const double a = period_s < 0.1       ? 0.45 + (n2 - 0.45) * period_s / 0.1
                     : period_s <= tg     ? n2
                     : period_s <= 5 * tg ? n2 * pow(tg / period_s, gamma)
                                          : n2 * pow(0.2, gamma) - n1 * (period_s - 5 * tg);
    return THUD_GRAVITY * t->alpha_max * a;
}

static double nzs1170_at(const struct thud_target *t, double period_s)
{
    static const struct {
        double zero, plateau, tp_s, power, power_s, inverse, square; /* power (power_s/T)^0.75, inverse/T, square/T^2 */
    } shape[5] = {{1, 2.35, 0.3, 1.6, 0.5, 1.05, 3.15},
                  {1, 2.35, 0.3, 1.6, 0.5, 1.05, 3.15},
                  {1.33, 2.93, 0.3, 2, 0.5, 1.32, 3.96},
                  {1.12, 3, 0.56, 2.4, 0.75, 2.14, 6.42},
                  {1.12, 3, 1, 3, 1, 3.32, 9.96}};
    const double x = period_s,
                 c = x < 0.1 ? shape[t->ground].zero + (shape[t->ground].plateau - shape[t->ground].zero) * x / 0.1
                     : x <= shape[t->ground].tp_s ? shape[t->ground].plateau
                     : x <= 1.5                   ? shape[t->ground].power * pow(shape[t->ground].power_s / x, 0.75)
                     : x <= 3                     ? shape[t->ground].inverse / x
                                                  : shape[t->ground].square / (x * x);
    return THUD_GRAVITY * t->z * t->r * c;
}

/* ---- words ---- */

/* A value of a code's spectrum: `key` (KEY=VALUE) or, without, the first word. Needed unless `optional`. */
struct word {
    const char *key;
    enum thud_dimension dimension;
    size_t to;
    bool optional;
};
enum { WORDS = 4 };
#define TO(member) offsetof(struct thud_target, member)

static const struct code {
    struct thud_target_code shown;
    double (*at)(const struct thud_target *target, double period_s);
    double longest_s; /* 0: no end */
    bool grounds, types, damped, table;
    struct word word[WORDS]; /* up to the first that goes nowhere */
} codes[] = {
    [THUD_TARGET_EN1998] = {{"en1998",
                             "en1998:A_G,GROUND[,type2][,DAMPING], such as en1998:0.3g,B or en1998:0.2g,C,type2,8%", 3,
                             7, "EN 1998-1 4.3.3.4.3(3)", NULL},
                            en1998_at,
                            0,
                            true,
                            true,
                            true,
                            false,
                            {{NULL, THUD_ACCELERATION, TO(ag_mps2), false}}},
    [THUD_TARGET_ASCE7] = {{"asce7",
                            "asce7:SDS=ACCELERATION,SD1=ACCELERATION,TL=TIME, such as asce7:SDS=1.0g,SD1=0.6g,TL=8s",
                            11, 11, "ASCE 7-16 16.2.2",
                            "chapter 16 scales motions to the MCE_R spectrum, 1.5 times the design spectrum (11.4.7)"},
                           asce7_at,
                           0,
                           false,
                           false,
                           false,
                           false,
                           {{"SDS", THUD_ACCELERATION, TO(sds_mps2), false},
                            {"SD1", THUD_ACCELERATION, TO(sd1_mps2), false},
                            {"TL", THUD_TIME, TO(tl_s), false}}},
    [THUD_TARGET_ASCE7_22] =
        {{"asce7-22", "asce7-22:TABLE.csv[,TL=TIME], the multi-period spectrum as a CSV of period and acceleration", 11,
          11, "ASCE 7-22 16.2.2",
          "chapter 16 scales motions to the MCE_R spectrum: the table has to be that, not two thirds of it"},
         asce7_22_at,
         0,
         false,
         false,
         false,
         true,
         {{"TL", THUD_TIME, TO(tl_s), true}}},
    [THUD_TARGET_GB50011] =
        {{"gb50011",
          "gb50011:AMAX=RATIO,TG=TIME[,DAMPING], such as gb50011:AMAX=0.9,TG=0.45s or gb50011:AMAX=0.16,TG=0.35s,4%", 3,
          7, "GB 50011-2010 5.1.2", NULL},
         gb50011_at,
         6,
         false,
         false,
         true,
         false,
         {{"AMAX", THUD_RATIO, TO(alpha_max), false}, {"TG", THUD_TIME, TO(tg_s), false}}},
    [THUD_TARGET_NZS1170] = {{"nzs1170",
                              "nzs1170:Z=FACTOR,CLASS[,R=FACTOR], such as nzs1170:Z=0.4,C or nzs1170:Z=0.13,D,R=1.8", 3,
                              0, "NZS 1170.5 5.5.1", NULL},
                             nzs1170_at,
                             0,
                             true,
                             false,
                             false,
                             false,
                             {{"Z", THUD_RATIO, TO(z), false}, {"R", THUD_RATIO, TO(r), true}}},
    [THUD_TARGET_POINTS] = {{"", "", 3, 7, "EN 1998-1 4.3.3.4.3(3)", NULL}, .at = points_at},
    [THUD_TARGET_NONE] = {{"", "", 3, 7, "EN 1998-1 4.3.3.4.3(3)", NULL}, .at = NULL},
};

/* The code whose name and colon a text begins with; THUD_TARGET_NONE: none. */
static enum thud_target_kind kind_of(const char *text)
{
    const size_t n = strcspn(text, ":");
    for (size_t k = 0; k < sizeof codes / sizeof *codes && text[n] == ':'; k++)
        if (n > 0 && strlen(codes[k].shown.name) == n && strncmp(text, codes[k].shown.name, n) == 0)
            return (enum thud_target_kind)k;
    return THUD_TARGET_NONE;
}

bool thud_target_is_code(const char *text)
{
    return kind_of(text) != THUD_TARGET_NONE;
}

const struct thud_target_code *thud_target_code(const struct thud_target *target)
{
    return &codes[target ? target->kind : THUD_TARGET_NONE].shown;
}

void thud_target_words(const struct thud_target *t, char *text, size_t size)
{
    if (t->kind == THUD_TARGET_EN1998)
        snprintf(text, size, "%s (a_g = %.4g g, S = %g, T_B = %g s, T_C = %g s, T_D = %g s, eta = %.4g)", t->text,
                 t->ag_mps2 / THUD_GRAVITY, ground[t->type][t->ground].s, ground[t->type][t->ground].tb_s,
                 ground[t->type][t->ground].tc_s, ground[t->type][t->ground].td_s, eta_of(t));
    else
        snprintf(text, size, "%s", t->text);
}

void thud_target_range(const struct thud_target *t, double *from_s, double *to_s)
{
    *from_s = t->n > 0 ? t->period_s[0] : 0;
    *to_s = codes[t->kind].longest_s > 0 ? codes[t->kind].longest_s : INFINITY;
    if (t->n > 0 && !(t->tl_s > 0))
        *to_s = t->period_s[t->n - 1];
}

static enum thud_status refuse(struct thud_error *err, const char *allowed)
{
    thud_error_allow(err, "%s", allowed);
    if (err)
        err->status = THUD_INPUT;
    return THUD_INPUT;
}

/* The next of the words between commas, without blanks around it; false at the end. */
static bool next_word(const char **text, char *word, size_t size)
{
    size_t n = strcspn(*text, ",");
    if (!**text)
        return false;
    while (n > 0 && **text == ' ')
        ++*text, n--;
    size_t length = n;
    while (length > 0 && (*text)[length - 1] == ' ')
        length--;
    snprintf(word, size, "%.*s", (int)length, *text);
    *text += n + ((*text)[n] == ',');
    return true;
}

static enum thud_status positive(const char *text, enum thud_dimension dimension, double *out, struct thud_error *err)
{
    struct thud_quantity q;
    enum thud_status status = thud_quantity_parse(text, dimension, NULL, &q, err);
    if (status == THUD_OK && !(q.value > 0))
        status = thud_error_set(err, THUD_INPUT, "\"%.40s\" is not above 0", text);
    if (status == THUD_OK)
        *out = q.value;
    return status;
}

/* Whether a word stands where a ground type or site class may. */
static bool is_letter(const struct code *code, const char *text)
{
    return code->grounds && text[0] && !text[1];
}

/* One word of a code's spectrum, the first at place 0. */
static enum thud_status take_word(const struct code *code, const char *text, int place, struct thud_target *out,
                                  struct thud_error *err)
{
    const size_t n = strcspn(text, "=");
    for (const struct word *w = code->word; w < code->word + WORDS && w->to; w++)
        if (w->key ? text[n] == '=' && strlen(w->key) == n && strncmp(text, w->key, n) == 0 : place == 0)
            return positive(text + (w->key ? n + 1 : 0), w->dimension, (double *)((char *)out + w->to), err);
    if (code->table && place == 0 && text[n] != '=') {
        snprintf(out->file, sizeof out->file, "%s", text);
        return THUD_OK;
    }
    if (code->grounds && text[0] >= 'A' && text[0] <= 'E' && !text[1]) {
        out->ground = text[0] - 'A';
        return THUD_OK;
    }
    if (code->types && (strcmp(text, "type1") == 0 || strcmp(text, "type2") == 0)) {
        out->type = text[4] == '2';
        return THUD_OK;
    }
    if (code->damped && strchr(text, '%'))
        return positive(text, THUD_RATIO, &out->damping, err);
    return thud_error_set(err, THUD_INPUT, "\"%.40s\" is no %s", text,
                          is_letter(code, text) ? "ground type" : "part of the spectrum");
}

enum thud_status thud_target_parse(const char *text, struct thud_target *out, struct thud_error *err)
{
    char word[THUD_TARGET_TEXT];
    *out = (struct thud_target){.damping = 0.05, .ground = -1, .r = 1};
    if (strlen(text) >= sizeof out->text) {
        thud_error_set(err, THUD_INPUT, "the target's text is too long");
        return refuse(err, "a spectrum such as en1998:0.3g,B");
    }
    snprintf(out->text, sizeof out->text, "%s", text);
    out->kind = kind_of(text);
    const struct code *code = &codes[out->kind];
    if (out->kind == THUD_TARGET_NONE) {
        thud_error_set(err, THUD_INPUT, "\"%.60s\" is not a spectrum", text);
        return refuse(err, THUD_TARGET_ALLOWED);
    }
    const char *at = text + strlen(code->shown.name) + 1;
    for (int place = 0; next_word(&at, word, sizeof word); place++)
        if (take_word(code, word, place, out, err) != THUD_OK)
            return refuse(err, is_letter(code, word) ? "A, B, C, D or E" : code->shown.allowed);
    const char *missing = code->grounds && out->ground < 0 ? "ground" : code->table && !out->file[0] ? "table" : NULL;
    for (const struct word *w = code->word; w < code->word + WORDS && w->to && !missing; w++)
        if (!w->optional && !(*(double *)((char *)out + w->to) > 0))
            missing = w->key ? w->key : "acceleration";
    if (missing) {
        thud_error_set(err, THUD_INPUT, "the %s is missing", missing);
        return refuse(err, code->shown.allowed);
    }
    if (out->kind == THUD_TARGET_ASCE7 && out->tl_s < out->sd1_mps2 / out->sds_mps2) {
        thud_error_set(err, THUD_INPUT, "TL, %.4g s, is below TS = SD1/SDS, %.4g s", out->tl_s,
                       out->sd1_mps2 / out->sds_mps2);
        return refuse(err, "TL of TS or more");
    }
    return THUD_OK;
}

double thud_target_sa(const struct thud_target *target, double period_s)
{
    const struct code *code = &codes[target->kind];
    return !code->at || (code->longest_s > 0 && period_s > code->longest_s) ? NAN : code->at(target, period_s);
}

void thud_target_periods(double from_s, double to_s, size_t count, double *period_s)
{
    for (size_t i = 0; i < count; i++)
        period_s[i] = i + 1 == count ? to_s : from_s * pow(to_s / from_s, (double)i / (double)(count - 1));
}

void thud_target_motion(const struct thud_record *record, double damping, const double *period_s, size_t count,
                        double *sa_mps2)
{
    const double pi = 3.14159265358979323846;
    for (size_t i = 0; i < count; i++) {
        double omega = 2 * pi / period_s[i];
        sa_mps2[i] = period_s[i] > 0 ? omega * omega * thud_spectrum_at(record, period_s[i], damping).displacement_m
                                     : thud_record_peak(record);
    }
}

double thud_target_factor(const double *target_mps2, const double *sa_mps2, size_t count, double *misfit)
{
    double mean = 0, rest = 0;
    for (size_t i = 0; i < count; i++)
        mean += log(target_mps2[i] / sa_mps2[i]) / (double)count;
    for (size_t i = 0; i < count; i++) {
        double off = log(target_mps2[i] / sa_mps2[i]) - mean;
        rest += off * off / (double)count;
    }
    *misfit = sqrt(rest);
    return exp(mean);
}
