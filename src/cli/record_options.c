#include "cli/options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"

static enum thud_status read_short_word(const struct thud_args *args, const char *option, char *to, size_t size,
                                        struct thud_error *err)
{
    const char *text = thud_args_value(args, option);
    if (!text)
        return THUD_OK;
    if (!text[0] || strlen(text) >= size)
        return thud_args_refuse(option, text, "a short word", err);
    memcpy(to, text, strlen(text) + 1);
    return THUD_OK;
}

static enum thud_status read_column(const struct thud_args *args, struct thud_record_choice *choice,
                                    struct thud_error *err)
{
    const char *column = thud_args_value(args, "column");
    enum thud_status status = thud_args_integer(args, "skip", 0, 1000000, -1, &choice->skip, err);
    if (!status && column && strcmp(column, "all") == 0)
        choice->column = -1;
    else if (!status)
        status = thud_args_integer(args, "column", 1, 10000, 0, &choice->column, err);
    return status;
}

static enum thud_status read_sign_and_baseline(const struct thud_args *args, struct thud_record_treatment *treatment,
                                               struct thud_error *err)
{
    const char *baseline = thud_args_value(args, "baseline");
    int minus = 0;
    enum thud_status status = thud_args_choice(args, "sign", &minus, err);
    treatment->choice.sign = minus ? -1 : 1;
    if (status != THUD_OK || !baseline)
        return status;
    if (strcmp(baseline, "mean") == 0)
        treatment->baseline = THUD_BASELINE_MEAN;
    else if (strcmp(baseline, "linear") == 0)
        treatment->baseline = THUD_BASELINE_LINEAR;
    else if (thud_args_integer(args, "baseline", 0, THUD_BASELINE_MAX, THUD_BASELINE_NONE, &treatment->baseline, NULL))
        return thud_args_refuse("baseline", baseline, "mean, linear, or the degree of a polynomial, 0 to 8", err);
    return THUD_OK;
}

/* "0.1 Hz" from `text` on, up to `end`. */
static bool scan_frequency(const char *text, const char *end, double *hz)
{
    const char *after;
    if (thud_number_parse(text, &after, hz) != 0)
        return false;
    after += strspn(after, " ");
    return end - after == 2 && strncmp(after, "Hz", 2) == 0;
}

static enum thud_status read_filter(const struct thud_args *args, struct thud_record_filter *out,
                                    struct thud_error *err)
{
    const char *high = thud_args_value(args, "high-pass"), *band = thud_args_value(args, "band-pass");
    const char *colon = band ? strchr(band, ':') : NULL;
    if (high && band)
        return thud_args_refuse("high-pass", high, "--high-pass or --band-pass", err);
    if (high && !scan_frequency(high, high + strlen(high), &out->low_hz))
        return thud_args_refuse("high-pass", high, "a frequency such as 0.1Hz", err);
    if (band && (!colon || !scan_frequency(band, colon, &out->low_hz) ||
                 !scan_frequency(colon + 1, band + strlen(band), &out->high_hz)))
        return thud_args_refuse("band-pass", band, "two frequencies such as 0.1Hz:25Hz", err);
    if (thud_args_has(args, "order") && !high && !band)
        return thud_args_refuse("order", thud_args_value(args, "order"), "beside --high-pass or --band-pass", err);
    return thud_args_integer(args, "order", 1, THUD_FILTER_ORDER_MAX, out->order, &out->order, err);
}

enum thud_status thud_record_options_read(const struct thud_args *args, struct thud_record_treatment *treatment,
                                          struct thud_error *err)
{
    thud_record_treatment_init(treatment);
    struct thud_record_choice *choice = &treatment->choice;
    const struct {
        const char *option;
        enum thud_dimension dimension;
        double *to;
    } quantities[] = {{"dt", THUD_TIME, &choice->dt_s},
                      {"peak", THUD_ACCELERATION, &choice->peak_mps2},
                      {"sa", THUD_ACCELERATION, &choice->sa_mps2},
                      {"period", THUD_TIME, &choice->period_s},
                      {"factor", THUD_NUMBER, &choice->factor},
                      {"from", THUD_TIME, &treatment->from_s},
                      {"to", THUD_TIME, &treatment->to_s},
                      {"resample", THUD_TIME, &treatment->resample_s},
                      {"taper", THUD_TIME, &treatment->taper_s}};
    enum thud_status status = THUD_OK;
    for (size_t i = 0; i < sizeof quantities / sizeof *quantities && !status; i++)
        status = thud_args_quantity(args, quantities[i].option, quantities[i].dimension, quantities[i].to, err);
    if (!status && !isnan(choice->peak_mps2) && !(choice->peak_mps2 > 0))
        return thud_args_refuse("peak", thud_args_value(args, "peak"), "more than 0; --sign - reverses the polarity",
                                err);
    if (!status && !isnan(choice->sa_mps2) && !(choice->sa_mps2 > 0))
        return thud_args_refuse("sa", thud_args_value(args, "sa"), "more than 0; --sign - reverses the polarity", err);
    if (!status && !isnan(choice->period_s) && !(choice->period_s > 0))
        return thud_args_refuse("period", thud_args_value(args, "period"), "more than 0", err);
    if (!status)
        status = read_short_word(args, "unit", choice->unit, sizeof choice->unit, err);
    if (!status)
        status = read_short_word(args, "channel", choice->channel, sizeof choice->channel, err);
    if (!status)
        status = read_short_word(args, "component", choice->component, sizeof choice->component, err);
    if (!status)
        status = read_column(args, choice, err);
    if (!status)
        status = read_filter(args, &treatment->filter, err);
    return status ? status : read_sign_and_baseline(args, treatment, err);
}

/* FROM:TO:COUNT */
static enum thud_status read_periods(const char *text, struct thud_spectrum_choice *choice, struct thud_error *err)
{
    static const char allowed[] = "FROM:TO:COUNT such as 0.02s:10s:200, above 0, 2 to 10000 of them";
    static const enum thud_dimension dimension[] = {THUD_TIME, THUD_TIME, THUD_NUMBER};
    double x[3];
    enum thud_status status = thud_args_quantities("periods", text, ':', dimension, 3, x, allowed, err);
    if (status != THUD_OK)
        return status;
    if (!(x[0] > 0) || !(x[1] > x[0]) || x[2] < 2 || x[2] > THUD_PERIODS_MAX || x[2] != floor(x[2]))
        return thud_args_refuse("periods", text, allowed, err);
    choice->from_s = x[0];
    choice->to_s = x[1];
    choice->count = (int)x[2];
    return THUD_OK;
}

enum thud_status thud_spectrum_options_read(const struct thud_args *args, const char *damping,
                                            struct thud_spectrum_choice *choice, struct thud_error *err)
{
    const char *text = thud_args_value(args, "periods");
    enum thud_status status = thud_args_quantity(args, damping, THUD_RATIO, &choice->damping, err);
    if (!status && !(choice->damping >= 0 && choice->damping < 1))
        return thud_args_refuse(damping, thud_args_value(args, damping), "from 0 up to, not including, 1", err);
    return !status && text ? read_periods(text, choice, err) : status;
}

/* Hz, deg and 1/s are no units of structures: they are dropped here when they are the parameter's own. */
static enum thud_status read_synthesis_value(const struct thud_synthesis_param *param, const char *text, double *to,
                                             struct thud_error *err)
{
    const char *end;
    struct thud_quantity value;
    if (param->dimension == THUD_NUMBER && param->unit[0] && thud_number_parse(text, &end, &value.value) == 0) {
        end += strspn(end, " ");
        if (!*end || strcmp(end, param->unit) == 0) {
            *to = value.value;
            return THUD_OK;
        }
    }
    if (thud_quantity_parse(text, param->dimension, NULL, &value, err) != THUD_OK) {
        thud_error_key(err, "%s", param->name);
        return THUD_INPUT;
    }
    *to = value.value;
    return THUD_OK;
}

/* `length` bytes of an assignment. Input, as an unknown key of a preset; wrong usage where it assigns nothing. */
static enum thud_status refuse_unknown_value(const char *key, size_t length, struct thud_error *err)
{
    char list[400] = "event";
    for (size_t i = 0; i < thud_synthesis_param_count; i++)
        thud_append(list, sizeof list, ", %s", thud_synthesis_params[i].name);
    enum thud_status status = key[length] == '=' ? THUD_INPUT : THUD_USAGE;
    return thud_error_refuse(err, status, "--set", list, "a surrogate has no value \"%.*s\"",
                             (int)(length < 40 ? length : 40), key);
}

static enum thud_status assign_value(const char *assignment, struct thud_synthesis *synthesis, const char **event,
                                     struct thud_error *err)
{
    const char *sign = strchr(assignment, '=');
    size_t length = sign ? (size_t)(sign - assignment) : strlen(assignment);
    if (sign && length == 5 && strncmp(assignment, "event", length) == 0) {
        *event = sign + 1;
        return THUD_OK;
    }
    for (size_t i = 0; sign && i < thud_synthesis_param_count; i++) {
        const struct thud_synthesis_param *param = &thud_synthesis_params[i];
        if (strlen(param->name) == length && strncmp(param->name, assignment, length) == 0)
            return read_synthesis_value(param, sign + 1, thud_synthesis_field(synthesis, param), err);
    }
    return refuse_unknown_value(assignment, length, err);
}

enum thud_status thud_synthesis_options_read(const struct thud_args *args, struct thud_synthesis *synthesis,
                                             const char **event, struct thud_error *err)
{
    thud_synthesis_init(synthesis);
    *event = NULL;
    enum thud_status status = thud_args_quantity(args, "peak", THUD_ACCELERATION, &synthesis->peak_mps2, err);
    if (!status)
        status = thud_args_quantity(args, "dt", THUD_TIME, &synthesis->dt_s, err);
    const char *assignment;
    for (int i = 0; !status && (assignment = thud_args_repeated(args, "set", i)); i++)
        status = assign_value(assignment, synthesis, event, err);
    return status;
}
