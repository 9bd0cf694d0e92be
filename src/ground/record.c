#include "ground/record.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/largest.h"

enum thud_status thud_record_create(const double *a_mps2, size_t samples, double dt_s, struct thud_record **out,
                                    struct thud_error *err)
{
    *out = NULL;
    if (!(dt_s > 0) || !isfinite(dt_s))
        return thud_error_set(err, THUD_INPUT, "the time step of a record must be positive, not %g s", dt_s);
    for (size_t i = 0; i < samples; i++)
        if (!isfinite(a_mps2[i]))
            return thud_error_set(err, THUD_INPUT, "sample %zu is not a finite number", i + 1);
    struct thud_record *record = NULL;
    if (samples <= (SIZE_MAX - sizeof *record) / sizeof *a_mps2)
        record = malloc(sizeof *record + samples * sizeof *a_mps2);
    if (!record)
        return thud_error_set(err, THUD_MEMORY, "out of memory for a record of %zu samples", samples);
    memset(record, 0, sizeof *record);
    record->dt_s = dt_s;
    record->samples = samples;
    record->scale = 1;
    record->a_mps2 = (double *)(record + 1); /* the struct ends in a pointer, so doubles are aligned behind it */
    if (samples)
        memcpy(record->a_mps2, a_mps2, samples * sizeof *a_mps2);
    *out = record;
    return THUD_OK;
}

void thud_record_free(struct thud_record *record)
{
    free(record);
}

double thud_record_peak(const struct thud_record *record)
{
    double peak = 0;
    for (size_t i = 0; i < record->samples; i++)
        peak = thud_larger(peak, fabs(record->a_mps2[i]));
    return peak;
}

double thud_record_speed(const struct thud_record *r)
{
    double v = 0, most = 0;
    for (size_t i = 0; r && i + 1 < r->samples; i++) {
        double a = r->a_mps2[i], b = r->a_mps2[i + 1];
        if (a * b < 0)
            most = thud_larger(most, fabs(v + 0.5 * r->dt_s * a * (a / (a - b))));
        v += 0.5 * r->dt_s * (a + b);
        most = thud_larger(most, fabs(v));
    }
    return most;
}

void thud_record_scale(struct thud_record *record, double factor)
{
    for (size_t i = 0; i < record->samples; i++)
        record->a_mps2[i] *= factor;
    record->scale *= factor;
}

enum thud_status thud_record_scaled(const struct thud_record *record, double factor, struct thud_record **out,
                                    struct thud_error *err)
{
    enum thud_status status = thud_record_create(record->a_mps2, record->samples, record->dt_s, out, err);
    if (status != THUD_OK)
        return status;
    double *const samples = (*out)->a_mps2;
    **out = *record; /* all that is known of it */
    (*out)->a_mps2 = samples;
    if (factor != 1)
        thud_record_scale(*out, factor);
    return THUD_OK;
}
