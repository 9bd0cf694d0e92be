/* One collision of two free bodies, integrated from the printed equations (Runge-Kutta of order 4, events by
 * bisection): the independent side of the tests of the laws. Nothing of thud computes a force in this file. */
#pragma once

#include <check.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "core/laws/law.h"

static const double mass = 320e3; /* of each body unless said otherwise */

/* The equations as printed; `c` in the sense of each. */
enum printed { DASHPOT, HERTZ_DAMP, JANKOWSKI, RUBBER };
struct equation {
    enum printed form;
    double k, n, c;          /* c: dashpot c; s/v0; 2 xi sqrt(k m); C */
    bool pulls;              /* dashpot: contact ends at d = 0 */
    double knee, post_yield; /* rubber; knee INFINITY elsewhere */
    bool continuous;
};

static double force(const struct equation *q, double d, double v, bool approach, bool past)
{
    double dn = d > 0 ? pow(d, q->n) : 0;
    switch (q->form) {
    case DASHPOT:
        return q->k * d + q->c * v;
    case HERTZ_DAMP:
        return q->k * dn * (1 + q->c * v);
    case JANKOWSKI:
        return q->k * dn + (approach && d > 0 ? q->c * pow(d, (q->n - 1) / 2) * v : 0);
    default:
        break;
    }
    double f = q->k * dn;
    if (past && (approach || q->continuous))
        f = q->k * pow(q->knee, q->n) + q->post_yield * (d - q->knee);
    return approach ? f : f * (1 + q->c * v);
}

struct outcome {
    double force, indentation, duration, e, residual, dissipated, momentum;
};

/* x1, x2, v1, v2, work done on the contact */
enum { X1, X2, V1, V2, WORK, STATE };
struct bodies {
    double m1, m2;
};

static void slope(const struct equation *q, const struct bodies *b, const double *y, bool approach, bool past,
                  double *dy)
{
    double v = y[V1] - y[V2], f = force(q, y[X1] - y[X2], v, approach, past);
    dy[X1] = y[V1];
    dy[X2] = y[V2];
    dy[V1] = -f / b->m1;
    dy[V2] = f / b->m2;
    dy[WORK] = f * v;
}

static void rk4(const struct equation *q, const struct bodies *b, const double *y, bool approach, bool past, double h,
                double *out)
{
    double k[4][STATE], z[STATE];
    slope(q, b, y, approach, past, k[0]);
    for (int s = 1; s < 4; s++) {
        for (int i = 0; i < STATE; i++)
            z[i] = y[i] + h * (s == 3 ? 1 : 0.5) * k[s - 1][i];
        slope(q, b, z, approach, past, k[s]);
    }
    for (int i = 0; i < STATE; i++)
        out[i] = y[i] + h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
}

/* > 0 until the event: 0 turn, 1 knee, 2 release. */
static double event(const struct equation *q, const double *y, bool approach, bool past, int which)
{
    double d = y[X1] - y[X2], v = y[V1] - y[V2];
    if (which == 0)
        return approach ? v : 1;
    if (which == 1) {
        if (approach)
            return past ? 1 : q->knee - d;
        return past ? d - q->knee : 1;
    }
    if (approach && (q->form != DASHPOT || q->pulls))
        return 1;
    return q->form == DASHPOT && !q->pulls ? force(q, d, v, approach, past) : d;
}

static struct outcome collide(const struct equation *q, double m1, double m2, double v0, double h)
{
    struct bodies b = {m1, m2};
    struct outcome out = {0};
    double y[STATE] = {0, 0, v0, 0, 0}, next[STATE], t = 0;
    bool approach = true, past = false;
    for (long steps = 0; steps < 4000000; steps++) {
        out.force = fmax(out.force, force(q, y[X1] - y[X2], y[V1] - y[V2], approach, past));
        out.indentation = fmax(out.indentation, y[X1] - y[X2]);
        /* small steps first: a power of d below 1 has no slope at contact onset */
        double step = steps < 200 ? h * pow((double)(steps + 1) / 200, 4) : h;
        rk4(q, &b, y, approach, past, step, next);
        int hit = -1;
        for (int which = 0; which < 3; which++) {
            if (event(q, next, approach, past, which) > 0)
                continue;
            double lo = 0, hi = step;
            for (int i = 0; i < 60; i++) {
                double mid = 0.5 * (lo + hi), z[STATE];
                rk4(q, &b, y, approach, past, mid, z);
                if (event(q, z, approach, past, which) > 0)
                    lo = mid;
                else
                    hi = mid;
            }
            step = hi;
            hit = which;
            rk4(q, &b, y, approach, past, step, next);
        }
        memcpy(y, next, sizeof y);
        t += step;
        if (hit == 0) {
            out.force = fmax(out.force, force(q, y[X1] - y[X2], 0, true, past));
            out.indentation = fmax(out.indentation, y[X1] - y[X2]);
            approach = false;
        } else if (hit == 1) {
            past = approach;
        } else if (hit == 2) {
            break;
        }
    }
    out.duration = t;
    out.e = (y[V2] - y[V1]) / v0;
    out.residual = y[X1] - y[X2];
    /* what the contact took and did not give back; a spring still compressed at release is lost too */
    out.dissipated = y[WORK];
    out.momentum = (m1 * y[V1] + m2 * y[V2]) / (m1 * v0);
    return out;
}

/* Setting a law up. */
static struct thud_law_setup setup_of(const char *name, double m)
{
    struct thud_law_setup setup = {.mass_kg = m, .thickness_m = 0.05};
    thud_law_defaults(thud_law_find(name), &setup);
    return setup;
}

static void set(const char *name, struct thud_law_setup *setup, const char *param, double value)
{
    setup->value[thud_law_param(thud_law_find(name), param)] = value;
}

static double restitution(const char *name, struct thud_law_setup *setup, double v)
{
    const struct thud_law *law = thud_law_find(name);
    ck_assert_int_eq(thud_law_prepare(law, setup, NULL), THUD_OK);
    return thud_law_restitution(law, setup, v);
}

#define CLOSE(actual, expected, tolerance) ck_assert_double_eq_tol((actual) / (expected), 1, tolerance)

/* Every collision must hold these, whatever the law. */
static void check_balance(const struct outcome *out, double m1, double m2, double v0)
{
    double m = m1 * m2 / (m1 + m2);
    ck_assert_double_eq_tol(out->momentum, 1, 1e-9);
    CLOSE(out->dissipated, 0.5 * m * v0 * v0 * (1 - out->e * out->e), 1e-6);
}

/* The reference figures of the paper's Table 1 for two bodies of 320 t: kN, mm, ms. */
struct figure {
    double v, force, indentation, duration, e, residual;
};

static void check_figure(const struct outcome *out, const struct figure *f)
{
    ck_assert_double_eq_tol(out->force / 1e3, f->force, 0.051);
    ck_assert_double_eq_tol(out->indentation * 1e3, f->indentation, 0.00051 + (f->indentation < 10 ? 0 : 0.0005));
    ck_assert_double_eq_tol(out->duration * 1e3, f->duration, f->duration < 100 ? 0.00051 : 0.0051);
    ck_assert_double_eq_tol(out->e, f->e, 5.1e-6);
    ck_assert_double_eq_tol(out->residual * 1e3, f->residual, 5.1e-5);
}
