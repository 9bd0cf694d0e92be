#include "core/places.h"

void thud_places_set(struct thud_places *places, int count, const double *s, double scale, int terms)
{
    for (int i = 0; i < THUD_PLACES; i++) {
        places->power[0][i] = 1;
        places->power[1][i] = i < count ? scale * s[i] : 0;
    }
    for (int k = 2; k < terms; k++)
        for (int i = 0; i < THUD_PLACES; i++)
            places->power[k][i] = places->power[k - 1][i] * places->power[1][i];
}

void thud_places_read(const struct thud_places *places, const double *c, int stride, int n, double *value)
{
    struct thud_lanes v = {0};
    for (int k = n - 1; k >= 0; k--)
        thud_lanes_add(&v, c[k * stride], places->power[k]);
    thud_lanes_put(&v, value);
}

void thud_places_slope(const struct thud_places *places, const double *c, int stride, int n, double h, double *slope)
{
    struct thud_lanes d = {0};
    double rate = 1 / h;
    for (int k = n - 1; k >= 1; k--)
        thud_lanes_add(&d, k * rate * c[k * stride], places->power[k - 1]);
    thud_lanes_put(&d, slope);
}
