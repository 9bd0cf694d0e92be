/* Elastic response spectra of EN 1998-1 and ASCE 7-16.
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
 *     TL <= T         Sa = S_D1 TL/T^2 */
#include "ground/target.h"

#include <math.h>
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
static const char en1998[] = "en1998:", asce7[] = "asce7:";

bool thud_target_is_code(const char *text)
{
    return strncmp(text, en1998, sizeof en1998 - 1) == 0 || strncmp(text, asce7, sizeof asce7 - 1) == 0;
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

static enum thud_status parse_en1998(const char *text, struct thud_target *out, struct thud_error *err)
{
    static const char allowed[] =
        "en1998:A_G,GROUND[,type2][,DAMPING], such as en1998:0.3g,B or en1998:0.2g,C,type2,8%";
    char word[THUD_TARGET_TEXT];
    int place = 0, type = 0, letter = -1;
    double ag = 0;
    for (; next_word(&text, word, sizeof word); place++) {
        if (place == 0) {
            if (positive(word, THUD_ACCELERATION, &ag, err) != THUD_OK)
                return refuse(err, allowed);
        } else if (place == 1 && word[0] >= 'A' && word[0] <= 'E' && !word[1]) {
            letter = word[0] - 'A';
        } else if (place > 1 && (strcmp(word, "type1") == 0 || strcmp(word, "type2") == 0)) {
            type = word[4] == '2';
        } else if (place > 1 && strchr(word, '%')) {
            if (positive(word, THUD_RATIO, &out->damping, err) != THUD_OK)
                return refuse(err, allowed);
        } else {
            thud_error_set(err, THUD_INPUT, "\"%.40s\" is no %s", word,
                           place == 1 ? "ground type" : "part of the spectrum");
            return refuse(err, place == 1 ? "A, B, C, D or E" : allowed);
        }
    }
    if (letter < 0) {
        thud_error_set(err, THUD_INPUT, "the ground type is missing");
        return refuse(err, allowed);
    }
    out->plateau_mps2 = ag * ground[type][letter].s;
    out->tb_s = ground[type][letter].tb_s;
    out->tc_s = ground[type][letter].tc_s;
    out->td_s = ground[type][letter].td_s;
    out->eta = fmax(0.55, sqrt(10 / (5 + 100 * out->damping)));
    return THUD_OK;
}

static enum thud_status parse_asce7(const char *text, struct thud_target *out, struct thud_error *err)
{
    static const char allowed[] =
        "asce7:SDS=ACCELERATION,SD1=ACCELERATION,TL=TIME, such as asce7:SDS=1.0g,SD1=0.6g,TL=8s";
    char word[THUD_TARGET_TEXT];
    while (next_word(&text, word, sizeof word)) {
        char *value = strchr(word, '=');
        if (value)
            *value++ = '\0';
        double *to = strcmp(word, "SDS") == 0   ? &out->sds_mps2
                     : strcmp(word, "SD1") == 0 ? &out->sd1_mps2
                     : strcmp(word, "TL") == 0  ? &out->tl_s
                                                : NULL;
        if (!to || !value) {
            thud_error_set(err, THUD_INPUT, "\"%.40s\" is no part of the spectrum", word);
            return refuse(err, allowed);
        }
        if (positive(value, to == &out->tl_s ? THUD_TIME : THUD_ACCELERATION, to, err) != THUD_OK)
            return refuse(err, allowed);
    }
    if (out->sds_mps2 > 0 && out->sd1_mps2 > 0 && out->tl_s > 0)
        return THUD_OK;
    thud_error_set(err, THUD_INPUT, "SDS, SD1 or TL is missing");
    return refuse(err, allowed);
}

enum thud_status thud_target_parse(const char *text, struct thud_target *out, struct thud_error *err)
{
    *out = (struct thud_target){.damping = 0.05};
    if (strlen(text) >= sizeof out->text) {
        thud_error_set(err, THUD_INPUT, "the target's text is too long");
        return refuse(err, "a spectrum such as en1998:0.3g,B");
    }
    snprintf(out->text, sizeof out->text, "%s", text);
    out->kind = strncmp(text, asce7, sizeof asce7 - 1) == 0 ? THUD_TARGET_ASCE7 : THUD_TARGET_EN1998;
    if (!thud_target_is_code(text)) {
        thud_error_set(err, THUD_INPUT, "\"%.60s\" is no spectrum", text);
        return refuse(err, "en1998:0.3g,B, asce7:SDS=1.0g,SD1=0.6g,TL=8s, or a CSV of period and acceleration");
    }
    return out->kind == THUD_TARGET_ASCE7 ? parse_asce7(text + sizeof asce7 - 1, out, err)
                                          : parse_en1998(text + sizeof en1998 - 1, out, err);
}

static double en1998_at(const struct thud_target *t, double period_s)
{
    double top = 2.5 * t->eta * t->plateau_mps2;
    if (period_s < t->tb_s)
        return t->plateau_mps2 * (1 + period_s / t->tb_s * (2.5 * t->eta - 1));
    if (period_s <= t->tc_s)
        return top;
    return period_s <= t->td_s ? top * t->tc_s / period_s : top * t->tc_s * t->td_s / (period_s * period_s);
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

static double points_at(const struct thud_target *t, double period_s)
{
    for (int i = 0; i < t->n; i++)
        if (t->period_s[i] == period_s)
            return t->sa_mps2[i];
    for (int i = 0; i + 1 < t->n; i++)
        if (period_s > t->period_s[i] && period_s < t->period_s[i + 1]) {
            const double *p = t->period_s + i, *a = t->sa_mps2 + i;
            double x = p[0] > 0 ? log(period_s / p[0]) / log(p[1] / p[0]) : period_s / p[1];
            return p[0] > 0 ? a[0] * pow(a[1] / a[0], x) : a[0] + x * (a[1] - a[0]);
        }
    return NAN;
}

double thud_target_sa(const struct thud_target *target, double period_s)
{
    switch (target->kind) {
    case THUD_TARGET_EN1998:
        return en1998_at(target, period_s);
    case THUD_TARGET_ASCE7:
        return asce7_at(target, period_s);
    case THUD_TARGET_POINTS:
        return points_at(target, period_s);
    case THUD_TARGET_NONE:
        break;
    }
    return NAN;
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
