/* Removes frequencies from a ground motion on request: Butterworth filters in two passes, forwards and backwards,
 * without phase shift. */
#pragma once

#include "ground/record.h"

enum { THUD_FILTER_ORDER_MAX = 10 };

/* Corner frequencies at which two passes leave half of the amplitude. `high_hz` NaN: a high-pass filter; both given: a
 * band-pass filter; `low_hz` NaN: no filter. `order` is that of one pass. */
struct thud_record_filter {
    double low_hz, high_hz;
    int order;
};

/* Returns the duration of the zeros added at each end, s. */
double thud_record_filter_pad(const struct thud_record_filter *filter, double dt_s);

/* Creates a filtered record, longer by that at each end. Errors: THUD_INPUT (corners that are not in order
 * between 0 and half the rate of samples, an order that is not 1 to THUD_FILTER_ORDER_MAX), THUD_MEMORY. */
enum thud_status thud_record_filter_apply(const struct thud_record *record, const struct thud_record_filter *filter,
                                          struct thud_record **out, struct thud_error *err);
