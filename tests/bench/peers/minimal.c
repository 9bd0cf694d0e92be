/* The methods that `thud bench` charts as somebody who writes nothing else would write them: one scene, two impact
 * laws, modal coordinates, nothing allocated in a step, peaks at the ends of steps (located methods: also inside), no
 * energy ledger, no histories. Nothing of thud's solver is used: only the model's numbers (modes, contact rows,
 * record). They are the measure for thud's speed: rows named minimal-METHOD.
 *
 *     q'' + 2 zeta omega q' + omega^2 q = -gamma a_g(t) - sum_c g_c F_c,   d_c = g_c . q - clearance_c
 *
 *   central-difference   the dashpots of the contacts by the central difference too, which is a linear system of the
 *                        closed contacts alone
 *   central-near         the same with a long step wherever nothing can touch within it
 *   newmark              average acceleration, Newton's method on the forces of the closed contacts
 *   rk4                  classical, steps end at the record's kinks and at every switch of a contact
 *   dormand-prince       5(4) with its dense output, switches located on it, steps end there and at the kinks
 *
 * Laws: kelvin-voigt-no-tension with residual = keep, rubber as in the paper; others are refused.
 * Prints method, setting (step in s, tolerance), seconds of processor time, error, steps; beside the minimal codes thud's
 * exact method, and thud's own central difference and Newmark with nothing located: rows exact and thud-METHOD.
 * usage: minimal PRESET CASE KEY=VALUE... */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../scene.h"
#include "core/numerics/vec.h"

enum { MODES = 64, CONTACTS = 16, SHAPES = MODES * (MODES + 4) };
enum mode { OPEN, APPROACH, RESTITUTION, STICKING };

struct contact {
    bool rubber;
    double k, c;                      /* concrete: N/m, N s/m */
    double n, knee, knee_n, post, cv; /* rubber: exponent, delta_u, force there, slope past it; C v_imp^0.9755 */
    double floor_mps;                 /* least v_imp */
    double clearance, residual;
    enum mode mode;
    bool past;   /* delta_u */
    double damp; /* C of this impact */
};

struct scene {
    int n, nc, nf;
    double w2[MODES], c[MODES], gamma[MODES]; /* omega^2, 2 zeta omega */
    double g[CONTACTS][MODES], w[CONTACTS][CONTACTS];
    double rows[MODES][CONTACTS]; /* g by mode: all indentations are summed side by side */
    struct contact contact[CONTACTS];
    struct building {
        int first, floors, first_mode;
        double *shape; /* (floors x STRIDE_OF(floors)) by mode, the floors side by side */
    } building[THUD_STRUCTURES_MAX];
    double shapes[SHAPES];
    int nb;
    const double *a; /* ground, (samples) */
    size_t samples;
    double dt, end;
    double peak[MODES]; /* total acceleration of each floor */
    long steps;
    /* of one fixed step */
    double h, wh[CONTACTS][CONTACTS];
};

/* ---- the scene */

/* out = start + sum of x[j] times column j, four rows at a time; columns are STRIDE_OF(rows) long. */
#define STRIDE_OF(rows) (((rows) + 3) / 4 * 4)
static inline void sum_columns(int rows, int n, const double *column, int stride, const double *x, double start,
                               double *out)
{
    for (int i = 0; i < rows; i += 4) {
        const double *a = column + i;
        thud_vec2 low = {start, start}, high = low;
        for (int j = 0; j < n; j++, a += stride) {
            low += thud_vec2_at(a) * x[j];
            high += thud_vec2_at(a + 2) * x[j];
        }
        thud_vec2_put(low, out + i);
        thud_vec2_put(high, out + i + 2);
    }
}

static double value_of(const struct thud_model_contact *k, const char *name)
{
    return k->setup.value[thud_law_param(k->law, name)];
}

static bool read_contact(const struct thud_model_contact *k, struct contact *c)
{
    *c = (struct contact){.clearance = k->clearance_m};
    double e = value_of(k, "restitution");
    if (strcmp(k->law->name, "kelvin-voigt-no-tension") == 0) {
        double xi = -log(e) / sqrt(acos(-1) * acos(-1) + log(e) * log(e)); /* eq. (3) */
        c->k = value_of(k, "stiffness");
        c->c = 2 * xi * sqrt(c->k * k->setup.mass_kg);
        return value_of(k, "residual") == 0 && value_of(k, "damping") == 0;
    }
    if (strcmp(k->law->name, "rubber") != 0)
        return false;
    c->rubber = true;
    c->k = value_of(k, "stiffness");
    c->n = value_of(k, "exponent");
    c->knee = value_of(k, "max-strain") * k->setup.thickness_m;
    c->knee_n = c->k * pow(c->knee, c->n);
    c->post = value_of(k, "post-yield");
    c->cv = 1.55 * (1 - e * e) / (pow(e, 0.7076) * pow(k->setup.mass_kg, 0.0025)); /* eq. (7) */
    c->floor_mps = value_of(k, "speed-floor");
    return value_of(k, "damping") == 0 && value_of(k, "unloading") == 0 && value_of(k, "impact-speed") == 0 &&
           isfinite(c->k);
}

static void read_shapes(const struct thud_model *m, struct scene *s)
{
    double *next = s->shapes;
    for (int k = 0; k < m->nstructures; k++) {
        const struct thud_model_structure *from = &m->structure[k];
        int n = from->n, stride = STRIDE_OF(n);
        if (n == 0)
            continue;
        s->building[s->nb++] = (struct building){from->first, n, from->first_mode, next};
        for (int j = 0; j < n; j++, next += stride)
            for (int i = 0; i < n; i++)
                next[i] = from->phi[i * n + j];
    }
}

static bool read_scene(const struct bench_scene *from, struct scene *s)
{
    const struct thud_model *m = from->model;
    if (m->nmodes > MODES || m->ncontacts > CONTACTS || !from->record || m->couples || m->left_out)
        return false;
    s->n = m->nmodes;
    s->nc = m->ncontacts;
    s->nf = m->ndof;
    s->nb = 0;
    for (int j = 0; j < s->n; j++) {
        s->w2[j] = m->omega[j] * m->omega[j];
        s->c[j] = 2 * m->zeta[j] * m->omega[j];
        s->gamma[j] = m->gamma[j];
    }
    for (int c = 0; c < s->nc; c++) {
        if (!read_contact(&m->contact[c], &s->contact[c]))
            return false;
        memcpy(s->g[c], m->jacobian + c * s->n, (size_t)s->n * sizeof(double));
        for (int j = 0; j < s->n; j++)
            s->rows[j][c] = s->g[c][j];
    }
    for (int c = 0; c < s->nc; c++)
        for (int k = 0; k < s->nc; k++) {
            s->w[c][k] = 0;
            for (int j = 0; j < s->n; j++)
                s->w[c][k] += s->g[c][j] * s->g[k][j];
        }
    read_shapes(m, s);
    s->a = from->record->a_mps2;
    s->samples = from->record->samples;
    s->dt = from->record->dt_s;
    s->end = from->options.tail_s + (double)(s->samples - 1) * s->dt;
    return true;
}

static double ground(const struct scene *s, double t)
{
    double at = t / s->dt;
    size_t i = (size_t)at;
    if (i + 1 >= s->samples)
        return 0;
    return s->a[i] + (at - (double)i) * (s->a[i + 1] - s->a[i]);
}

static void start(struct scene *s)
{
    memset(s->peak, 0, sizeof s->peak);
    s->steps = 0;
    for (int c = 0; c < s->nc; c++) {
        s->contact[c].mode = OPEN;
        s->contact[c].past = false;
        s->contact[c].residual = 0;
    }
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* Total accelerations of all floors, out (MODES + 4): the rest of one building's last four is written over by the next. */
static void accelerations(const struct scene *s, const double *qdd, double a_g, double *out)
{
    for (int b = 0; b < s->nb; b++) {
        const struct building *k = &s->building[b];
        sum_columns(k->floors, k->floors, k->shape, STRIDE_OF(k->floors), qdd + k->first_mode, a_g, out + k->first);
    }
}

static void look(struct scene *s, const double *qdd, double a_g)
{
    double a[MODES + 4];
    accelerations(s, qdd, a_g, a);
    for (int i = 0; i < s->nf; i++)
        s->peak[i] = larger(s->peak[i], fabs(a[i]));
}

static double dot(const double *a, const double *b, int n)
{
    double sum = 0;
    for (int j = 0; j < n; j++)
        sum += a[j] * b[j];
    return sum;
}

static double indentation(const struct scene *s, int c, const double *q)
{
    return dot(s->g[c], q, s->n) - s->contact[c].clearance - s->contact[c].residual;
}

/* Of all contacts, out (CONTACTS). */
static void indentations(const struct scene *s, const double *q, double *out)
{
    sum_columns(s->nc, s->n, s->rows[0], CONTACTS, q, 0, out);
    for (int c = 0; c < s->nc; c++)
        out[c] -= s->contact[c].clearance + s->contact[c].residual;
}

/* ---- the laws: F = elastic(d) + damping(d) v on the present branch */

static double elastic(const struct contact *c, double d)
{
    if (!c->rubber)
        return c->k * d;
    if (c->mode == APPROACH && d > c->knee)
        return c->knee_n + c->post * (d - c->knee);
    return d > 0 ? c->k * pow(d, c->n) : 0;
}

static double slope(const struct contact *c, double d, double elastic_n) /* of elastic */
{
    if (!c->rubber)
        return c->k;
    if (c->mode == APPROACH && d > c->knee)
        return c->post;
    return d > 0 ? c->n * elastic_n / d : 0;
}

static double dashpot(const struct contact *c, double elastic_n)
{
    return !c->rubber ? c->c : c->mode == RESTITUTION ? elastic_n * c->damp : 0;
}

static void onset(struct contact *c, double v)
{
    c->mode = APPROACH;
    c->past = false;
    if (c->rubber)
        c->damp = c->cv / pow(fmax(v, c->floor_mps), 0.9755);
}

static void separate(struct contact *c, double d)
{
    c->mode = OPEN;
    if (!c->rubber && d > 0)
        c->residual += d;
}

/* Unlocated methods: the mode at a step's end, from what stands there. */
static void update(struct contact *c, double d, double v)
{
    if (c->mode == OPEN && d > 0)
        onset(c, v);
    else if (c->mode != OPEN && d <= 0)
        separate(c, d);
    if (c->mode != OPEN && c->rubber)
        c->mode = v < 0 ? RESTITUTION : APPROACH;
}

/* Solves a x = b of n unknowns in place; x into b. */
static void solve(double a[CONTACTS][CONTACTS], double *b, int n)
{
    for (int i = 0; i < n; i++) {
        int p = i;
        for (int k = i + 1; k < n; k++)
            if (fabs(a[k][i]) > fabs(a[p][i]))
                p = k;
        for (int j = 0; p != i && j < n; j++) {
            double t = a[i][j];
            a[i][j] = a[p][j];
            a[p][j] = t;
        }
        double t = b[i];
        b[i] = b[p];
        b[p] = t;
        for (int k = i + 1; k < n; k++) {
            double f = a[k][i] / a[i][i];
            for (int j = i + 1; j < n; j++)
                a[k][j] -= f * a[i][j];
            b[k] -= f * b[i];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++)
            b[i] -= a[i][j] * b[j];
        b[i] /= a[i][i];
    }
}

/* ---- central difference:  q+ (1 + c h/2) = 2 q - q- (1 - c h/2) - h^2 (omega^2 q + gamma a + g F) */

struct central {
    double p0[MODES], p1[MODES], pa[MODES]; /* q+ = p0 q - p1 q- - pa a - pf (g F) */
    double pf[MODES];
};

static void central_prepare(struct scene *s, double h, struct central *m)
{
    s->h = h;
    for (int j = 0; j < s->n; j++) {
        double d = 1 + 0.5 * s->c[j] * h;
        m->p0[j] = (2 - h * h * s->w2[j]) / d;
        m->p1[j] = (1 - 0.5 * s->c[j] * h) / d;
        m->pf[j] = h * h / d;
        m->pa[j] = m->pf[j] * s->gamma[j];
    }
    for (int c = 0; c < s->nc; c++)
        for (int k = 0; k < s->nc; k++) {
            s->wh[c][k] = 0;
            for (int j = 0; j < s->n; j++)
                s->wh[c][k] += s->g[c][j] * m->pf[j] * s->g[k][j];
        }
}

/* Forces of the closed contacts, whose rates depend on them:  F = e + D (d+ - d-)/(2 h),  d+ = d+free - W F. */
static void central_forces(struct scene *s, const double *before, double *after, const struct central *m,
                           const double *d)
{
    double a[CONTACTS][CONTACTS], f[CONTACTS];
    int set[CONTACTS], n = 0;
    for (int c = 0; c < s->nc; c++)
        if (s->contact[c].mode != OPEN)
            set[n++] = c;
    for (int i = 0; i < n; i++) {
        struct contact *c = &s->contact[set[i]];
        double e = elastic(c, d[set[i]]), damp = dashpot(c, e) / (2 * s->h);
        double d_before = indentation(s, set[i], before), d_after = indentation(s, set[i], after);
        f[i] = e + damp * (d_after - d_before);
        for (int k = 0; k < n; k++)
            a[i][k] = (i == k) + damp * s->wh[set[i]][set[k]];
    }
    solve(a, f, n);
    for (int i = 0; i < n; i++) {
        struct contact *c = &s->contact[set[i]];
        if (f[i] <= 0 && !c->rubber)
            separate(c, d[set[i]]);
        if (f[i] > 0)
            for (int j = 0; j < s->n; j++)
                after[j] -= m->pf[j] * s->g[set[i]][j] * f[i];
    }
}

/* One step from (before, q) to after; whether a contact is closed. */
static bool central_step(struct scene *s, const double *before, const double *q, double *after, const struct central *m,
                         double a_g)
{
    double d[CONTACTS], qdd[MODES], over = 1 / (s->h * s->h);
    bool closed = false;
    for (int j = 0; j < s->n; j++)
        after[j] = m->p0[j] * q[j] - m->p1[j] * before[j] - m->pa[j] * a_g;
    indentations(s, q, d);
    for (int c = 0; c < s->nc; c++) {
        if (d[c] > 0 || s->contact[c].mode != OPEN)
            update(&s->contact[c], d[c], (d[c] - indentation(s, c, before)) / s->h);
        closed = closed || s->contact[c].mode != OPEN;
    }
    if (closed)
        central_forces(s, before, after, m, d);
    for (int j = 0; j < s->n; j++)
        qdd[j] = (after[j] - 2 * q[j] + before[j]) * over;
    look(s, qdd, a_g);
    s->steps++;
    return closed;
}

static void central_difference(struct scene *s, double h)
{
    double x[3][MODES] = {{0}}, *before = x[0], *q = x[1], *after = x[2];
    struct central m;
    long n = lround(s->end / h);
    start(s);
    central_prepare(s, h, &m);
    for (long i = 0; i < n; i++) {
        central_step(s, before, q, after, &m, ground(s, (double)i * h));
        double *t = before;
        before = q;
        q = after;
        after = t;
    }
}

/* The same with steps `ratio` times as long while no contact can close within one. */
static void central_near(struct scene *s, double h, int ratio)
{
    double x[3][MODES] = {{0}}, *before = x[0], *q = x[1], *after = x[2];
    struct central fine, coarse;
    double wh[2][CONTACTS][CONTACTS], gap = INFINITY, d_before[CONTACTS];
    long n = lround(s->end / h), i = 0;
    bool is_long = false;
    start(s);
    central_prepare(s, ratio * h, &coarse);
    memcpy(wh[1], s->wh, sizeof wh[1]);
    central_prepare(s, h, &fine);
    memcpy(wh[0], s->wh, sizeof wh[0]);
    indentations(s, q, d_before);
    while (i < n) {
        double step = is_long ? ratio * h : h, a = ground(s, (double)i * h);
        bool closed = central_step(s, before, q, after, is_long ? &coarse : &fine, a);
        if (closed) /* what was kept is of another residual */
            indentations(s, q, d_before);
        double reach = 0, d[CONTACTS];
        gap = INFINITY;
        indentations(s, after, d);
        for (int c = 0; c < s->nc; c++) {
            double rate = (d[c] - d_before[c]) / step;
            gap = -d[c] < gap ? -d[c] : gap;
            reach = larger(reach, rate);
            d_before[c] = d[c];
        }
        double *t = before;
        before = q;
        q = after;
        after = t;
        i += is_long ? ratio : 1;
        bool next = !closed && gap > 2.5 * ratio * h * reach + 2e-4 && i % ratio == 0;
        if (next != is_long) { /* the state before the present one, a new step away: q - h v + h^2/2 q'' */
            double old = step, now = next ? ratio * h : h, ground_now = ground(s, (double)i * h);
            for (int j = 0; j < s->n; j++) {
                double slope_back = (q[j] - before[j]) / old; /* at -old/2 */
                double a0 = -s->w2[j] * q[j] - s->gamma[j] * ground_now;
                double v = (slope_back + 0.5 * old * a0) / (1 + 0.5 * old * s->c[j]);
                double acc = a0 - s->c[j] * v;
                before[j] = q[j] - now * v + 0.5 * now * now * acc;
            }
            s->h = now;
            memcpy(s->wh, wh[next], sizeof s->wh);
            is_long = next;
        }
    }
}

/* ---- Newmark, 1/2 and 1/4 */

static void newmark(struct scene *s, double h)
{
    double q[MODES] = {0}, v[MODES] = {0}, acc[MODES] = {0}, m[MODES], qp[MODES], vp[MODES];
    double wv[CONTACTS][CONTACTS], f[CONTACTS] = {0};
    long n = lround(s->end / h);
    start(s);
    for (int j = 0; j < s->n; j++)
        m[j] = 1 / (1 + 0.5 * h * s->c[j] + 0.25 * h * h * s->w2[j]);
    for (int c = 0; c < s->nc; c++)
        for (int k = 0; k < s->nc; k++) {
            double sum = 0;
            for (int j = 0; j < s->n; j++)
                sum += s->g[c][j] * m[j] * s->g[k][j];
            s->wh[c][k] = 0.25 * h * h * sum;
            wv[c][k] = 0.5 * h * sum;
        }
    for (int j = 0; j < s->n; j++)
        acc[j] = -s->gamma[j] * s->a[0];
    for (long i = 1; i <= n; i++) {
        double a_g = ground(s, (double)i * h), d0[CONTACTS], v0[CONTACTS];
        int set[CONTACTS], ns = 0;
        for (int j = 0; j < s->n; j++) {
            qp[j] = q[j] + h * v[j] + 0.25 * h * h * acc[j];
            vp[j] = v[j] + 0.5 * h * acc[j];
            acc[j] = m[j] * (-s->gamma[j] * a_g - s->c[j] * vp[j] - s->w2[j] * qp[j]);
            q[j] = qp[j] + 0.25 * h * h * acc[j];
            v[j] = vp[j] + 0.5 * h * acc[j];
        }
        indentations(s, q, d0);
        for (int c = 0; c < s->nc; c++) {
            if (d0[c] > 0 || s->contact[c].mode != OPEN) {
                v0[c] = dot(s->g[c], v, s->n);
                if (s->contact[c].mode == OPEN)
                    onset(&s->contact[c], v0[c]), f[c] = 0;
                set[ns++] = c;
            }
        }
        for (int round = 0; ns > 0 && round < 20; round++) { /* Newton: r = F - law(d0 - W F, v0 - V F) */
            double a[CONTACTS][CONTACTS], r[CONTACTS], largest = 0, change = 0;
            for (int x = 0; x < ns; x++) {
                int c = set[x];
                struct contact *k = &s->contact[c];
                double d = d0[c], rate = v0[c];
                for (int y = 0; y < ns; y++) {
                    d -= s->wh[c][set[y]] * f[set[y]];
                    rate -= wv[c][set[y]] * f[set[y]];
                }
                double e = elastic(k, d), damp = dashpot(k, e), fd = slope(k, d, e);
                double law = e + damp * rate;
                if (k->rubber && k->mode == RESTITUTION)
                    fd *= 1 + k->damp * rate;
                if (law <= 0 || (k->rubber && d <= 0))
                    law = fd = damp = 0;
                r[x] = law - f[c];
                for (int y = 0; y < ns; y++)
                    a[x][y] = (x == y) + fd * s->wh[c][set[y]] + damp * wv[c][set[y]];
                largest = fmax(largest, law);
            }
            solve(a, r, ns);
            for (int x = 0; x < ns; x++) {
                f[set[x]] += r[x];
                change = fmax(change, fabs(r[x]));
            }
            if (change <= 1e-9 * (largest + 1))
                break;
        }
        for (int x = 0; x < ns; x++) {
            int c = set[x];
            double push = fmax(0, f[c]);
            for (int j = 0; push > 0 && j < s->n; j++) {
                double change = -m[j] * s->g[c][j] * push;
                acc[j] += change;
                q[j] += 0.25 * h * h * change;
                v[j] += 0.5 * h * change;
            }
        }
        for (int x = 0; x < ns; x++) {
            struct contact *k = &s->contact[set[x]];
            double d = indentation(s, set[x], q);
            if (d <= 0 || (!k->rubber && f[set[x]] <= 0))
                separate(k, d);
            else
                update(k, d, dot(s->g[set[x]], v, s->n));
        }
        look(s, acc, a_g);
        s->steps++;
    }
}

/* ---- located methods: y = (q, q') */

static double force_at(const struct scene *s, int c, const double *y, double *d, double *v)
{
    const struct contact *k = &s->contact[c];
    *d = indentation(s, c, y);
    *v = dot(s->g[c], y + s->n, s->n);
    double e = elastic(k, *d);
    return e + dashpot(k, e) * *v;
}

/* The forces that keep sticking contacts at d'' = 0. */
static void sticking_forces(const struct scene *s, const double *free, double *f)
{
    double a[CONTACTS][CONTACTS], b[CONTACTS];
    int set[CONTACTS], n = 0;
    for (int c = 0; c < s->nc; c++)
        if (s->contact[c].mode == STICKING)
            set[n++] = c;
    for (int i = 0; i < n; i++) {
        b[i] = dot(s->g[set[i]], free, s->n);
        for (int k = 0; k < n; k++)
            a[i][k] = s->w[set[i]][set[k]];
    }
    solve(a, b, n);
    for (int i = 0; i < n; i++)
        f[set[i]] = b[i];
}

static void derivative(const struct scene *s, const double *y, double a_g, double *out, double *f)
{
    int n = s->n;
    bool sticks = false;
    for (int j = 0; j < n; j++) {
        out[j] = y[n + j];
        out[n + j] = -s->c[j] * y[n + j] - s->w2[j] * y[j] - s->gamma[j] * a_g;
    }
    for (int c = 0; c < s->nc; c++) {
        double d, v;
        f[c] = 0;
        sticks = sticks || s->contact[c].mode == STICKING;
        if (s->contact[c].mode != APPROACH && s->contact[c].mode != RESTITUTION)
            continue;
        f[c] = fmax(0, force_at(s, c, y, &d, &v));
        for (int j = 0; j < n; j++)
            out[n + j] -= s->g[c][j] * f[c];
    }
    if (sticks) {
        sticking_forces(s, out + n, f);
        for (int c = 0; c < s->nc; c++)
            for (int j = 0; s->contact[c].mode == STICKING && j < n; j++)
                out[n + j] -= s->g[c][j] * f[c];
    }
}

/* The function each contact watches; it switches where that rises through 0 (one for each way out of its mode). */
enum { WATCHES = 3 };
static void watch(const struct scene *s, int c, const double *y, const double *f, double *out)
{
    const struct contact *k = &s->contact[c];
    double d = indentation(s, c, y), v, e;
    out[0] = out[1] = out[2] = -1;
    switch (k->mode) {
    case OPEN:
        out[0] = d;
        break;
    case APPROACH:
    case RESTITUTION:
        v = dot(s->g[c], y + s->n, s->n);
        if (!k->rubber) {
            out[0] = -(k->k * d + k->c * v);
            break;
        }
        out[0] = -d;
        out[1] = k->mode == APPROACH ? -v : v;
        out[2] = k->mode == APPROACH ? (k->past ? k->knee - d : d - k->knee) : -1;
        break;
    case STICKING:
        e = k->k * pow(d, k->n);
        out[0] = e - f[c];
        out[1] = f[c] - (k->knee_n + k->post * (d - k->knee));
        break;
    }
}

/* Acts on watch `which` of contact c at state y. */
static void act(struct scene *s, int c, int which, const double *y)
{
    struct contact *k = &s->contact[c];
    double d = indentation(s, c, y), v = dot(s->g[c], y + s->n, s->n), out[2 * MODES], f[CONTACTS];
    if (k->mode == OPEN) {
        onset(k, v);
    } else if (k->mode == STICKING) {
        k->mode = which == 0 ? RESTITUTION : APPROACH;
        k->past = k->mode == APPROACH;
    } else if (which == 0) {
        separate(k, d);
    } else if (which == 2) {
        k->past = !k->past;
    } else { /* a turn: where both branches call for the other, it sticks */
        enum mode from = k->mode;
        k->mode = from == APPROACH ? RESTITUTION : APPROACH;
        k->past = d > k->knee;
        derivative(s, y, 0, out, f); /* the ground moves both sides alike */
        double rise = dot(s->g[c], out + s->n, s->n);
        if (d > k->knee && (from == APPROACH ? rise > 0 : rise < 0))
            k->mode = STICKING;
    }
}

/* The largest of three values at equal steps, or of the parabola through them. */
static double vertex(double a, double b, double c)
{
    double bend = a - 2 * b + c, rise = 0.5 * (c - a), most = fmax(fabs(a), fmax(fabs(b), fabs(c)));
    return fabs(rise) < fabs(bend) ? fmax(most, fabs(b - 0.5 * rise * rise / bend)) : most;
}

/* Dormand and Prince's coefficients, and those of the dense output (Hairer, Norsett and Wanner, Solving ordinary
 * differential equations I, II.5 and II.6). */
static const double A[7][6] = {{0},
                               {1.0 / 5},
                               {3.0 / 40, 9.0 / 40},
                               {44.0 / 45, -56.0 / 15, 32.0 / 9},
                               {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                               {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                               {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
static const double C[7] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};
static const double E[7] = {71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
static const double D[7] = {-12715105075.0 / 11282082432,  0,
                            87487479700.0 / 32700410799,   -10690763975.0 / 1880347072,
                            701980252875.0 / 199316789632, -1453857185.0 / 822651844,
                            69997945.0 / 29380423};

/* A step as it was taken: its two ends and, for reading inside, the quartic (rk4: the cubic) through them. */
struct step {
    double h, t;
    double y0[2 * MODES], y1[2 * MODES], k[7][2 * MODES], f0[CONTACTS], f1[CONTACTS];
    bool quartic;
};

static void inside(const struct scene *s, const struct step *p, double x, double *y)
{
    for (int i = 0; i < 2 * s->n; i++) {
        double rise = p->y1[i] - p->y0[i], b = p->h * p->k[0][i] - rise, last = 0;
        double c = rise - p->h * p->k[6][i] - b;
        if (p->quartic)
            for (int m = 0; m < 7; m++)
                last += D[m] * p->k[m][i];
        y[i] = p->y0[i] + x * (rise + (1 - x) * (b + x * (c + (1 - x) * p->h * last)));
    }
}

static double dp_step(const struct scene *s, struct step *p, double tolerance, const double *scale)
{
    double y[2 * MODES], worst = 0;
    int n = 2 * s->n;
    for (int i = 1; i < 7; i++) {
        for (int j = 0; j < n; j++) {
            double sum = 0;
            for (int m = 0; m < i; m++)
                sum += A[i][m] * p->k[m][j];
            y[j] = p->y0[j] + p->h * sum;
        }
        derivative(s, y, ground(s, p->t + C[i] * p->h * (1 - 1e-13)), p->k[i], p->f1);
    }
    memcpy(p->y1, y, (size_t)n * sizeof *y);
    for (int j = 0; j < n; j++) {
        double sum = 0;
        for (int m = 0; m < 7; m++)
            sum += E[m] * p->k[m][j];
        worst = fmax(worst, fabs(p->h * sum) / (tolerance * (fabs(y[j]) + scale[j])));
    }
    return worst;
}

static void rk4_step(const struct scene *s, struct step *p)
{
    double y[2 * MODES], a[3] = {ground(s, p->t), ground(s, p->t + 0.5 * p->h), ground(s, p->t + p->h * (1 - 1e-13))};
    int n = 2 * s->n;
    for (int i = 1; i < 4; i++) {
        double part = i < 3 ? 0.5 * p->h : p->h;
        for (int j = 0; j < n; j++)
            y[j] = p->y0[j] + part * p->k[i - 1][j];
        derivative(s, y, a[i < 3 ? 1 : 2], p->k[i], p->f1);
    }
    for (int j = 0; j < n; j++)
        p->y1[j] = p->y0[j] + p->h / 6 * (p->k[0][j] + 2 * (p->k[1][j] + p->k[2][j]) + p->k[3][j]);
    derivative(s, p->y1, a[2], p->k[6], p->f1);
}

/* The first switch inside the step: its place in (0, 1], or 2. Watches that start above 0 are not waited for. */
static double first_switch(const struct scene *s, const struct step *p, int *contact, int *which)
{
    double place = 2, y[2 * MODES], from[WATCHES], to[WATCHES], now[WATCHES], out[2 * MODES], f[CONTACTS];
    for (int c = 0; c < s->nc; c++) {
        watch(s, c, p->y0, p->f0, from);
        watch(s, c, p->y1, p->f1, to);
        for (int w = 0; w < WATCHES; w++) {
            if (to[w] <= 0 || (s->contact[c].mode == OPEN && to[w] < 1e-15) ||
                (from[w] > 0 && s->contact[c].mode != STICKING))
                continue;
            double a = 0, b = 1, fa = fmin(from[w], 0), fb = to[w], x = 0;
            for (int i = 0, side = 0; i < 60 && b - a > 1e-13; i++) { /* Illinois */
                x = fb > fa ? (a * fb - b * fa) / (fb - fa) : 0.5 * (a + b);
                if (x <= a || x >= b)
                    x = 0.5 * (a + b);
                inside(s, p, x, y);
                memcpy(f, p->f1, sizeof f);
                if (s->contact[c].mode == STICKING)
                    derivative(s, y, ground(s, p->t + x * p->h), out, f);
                watch(s, c, y, f, now);
                if (now[w] > 0) {
                    b = x;
                    fb = now[w];
                    if (side == 1)
                        fa *= 0.5;
                    side = 1;
                } else {
                    a = x;
                    fa = now[w];
                    if (side == -1)
                        fb *= 0.5;
                    side = -1;
                }
                if (fabs(now[w]) < 1e-15)
                    break;
            }
            if (b < place) {
                place = b;
                *contact = c;
                *which = w;
            }
        }
    }
    return place;
}

/* Peaks: both ends, and inside where an end comes near the largest yet. */
static void look_inside(struct scene *s, const struct step *p)
{
    enum { INSIDE = 6 };
    double a[INSIDE + 1][MODES + 4], y[2 * MODES], out[2 * MODES], f[CONTACTS];
    bool near = false;
    accelerations(s, p->k[0] + s->n, ground(s, p->t), a[0]);
    accelerations(s, p->k[6] + s->n, ground(s, p->t + p->h), a[INSIDE]);
    for (int i = 0; i < s->nf; i++) {
        double end = fmax(fabs(a[0][i]), fabs(a[INSIDE][i]));
        near = near || end > 0.7 * s->peak[i];
        s->peak[i] = fmax(s->peak[i], end);
    }
    if (!near)
        return;
    for (int k = 1; k < INSIDE; k++) {
        double x = (double)k / INSIDE, a_g = ground(s, p->t + x * p->h);
        inside(s, p, x, y);
        derivative(s, y, a_g, out, f);
        accelerations(s, out + s->n, a_g, a[k]);
    }
    for (int k = 1; k < INSIDE; k++)
        for (int i = 0; i < s->nf; i++)
            s->peak[i] = fmax(s->peak[i], vertex(a[k - 1][i], a[k][i], a[k + 1][i]));
}

/* rk4 with a step (tolerance 0), dormand-prince with a tolerance. */
static bool located(struct scene *s, double step, double tolerance)
{
    static struct step p;
    double scale[2 * MODES], t = 0, h = step > 0 ? step : 1e-3, floor_s = 1e-12;
    long kink = 1, switches = 0;
    start(s);
    for (int j = 0; j < s->n; j++) { /* a centimetre, gamma being the root of a modal mass */
        scale[j] = 0.01 * sqrt(1e5);
        scale[s->n + j] = scale[j] * sqrt(s->w2[j]);
    }
    p = (struct step){.quartic = tolerance > 0};
    derivative(s, p.y0, ground(s, 0), p.k[0], p.f0);
    while (s->end - t > 1e-9 && switches < 2000000) {
        double to_kink = fmin((double)kink * s->dt, s->end) - t;
        if (to_kink < 1e-9) {
            kink++;
            continue;
        }
        p.t = t;
        bool to_the_kink = h >= to_kink * (1 - 1e-9);
        p.h = to_the_kink ? to_kink : h;
        double error = 0;
        if (tolerance > 0)
            error = dp_step(s, &p, tolerance, scale);
        else
            rk4_step(s, &p);
        if (error > 1 && p.h > 1e-9) {
            h = p.h * fmax(0.2, 0.9 * pow(error, -0.2));
            continue;
        }
        int c = -1, which = 0;
        double place = first_switch(s, &p, &c, &which);
        for (int again = 0; place <= 1 && again < 3 && place < 1 - 1e-9; again++) { /* once more, to end there */
            double shorter = p.h * place;
            if (shorter < floor_s)
                break;
            p.h = shorter;
            if (tolerance > 0)
                dp_step(s, &p, tolerance, scale);
            else
                rk4_step(s, &p);
            double w[WATCHES];
            watch(s, c, p.y1, p.f1, w);
            int c2 = -1, which2 = 0;
            double inside_it = first_switch(s, &p, &c2, &which2);
            if (inside_it > 1) { /* just short of it: as near as the method's own accuracy */
                place = 1;
                break;
            }
            place = inside_it;
            c = c2;
            which = which2;
        }
        look_inside(s, &p);
        s->steps++;
        t = to_the_kink && place > 1 ? t + to_kink : t + p.h;
        memcpy(p.y0, p.y1, sizeof p.y0);
        if (place <= 1) {
            switches++;
            act(s, c, which, p.y0);
        }
        derivative(s, p.y0, ground(s, t), p.k[0], p.f0); /* the ground's slope may change here */
        if (place <= 1)
            look(s, p.k[0] + s->n, ground(s, t));
        if (tolerance > 0 && !(place <= 1))
            h = fmax(p.h * fmin(5, error > 0 ? 0.9 * pow(error, -0.2) : 5), to_the_kink ? h : 0);
        if (tolerance > 0)
            h = fmin(fmax(h, 1e-7), s->dt);
    }
    return s->end - t <= 1e-9;
}

/* ---- the table */

static struct bench_scene opened;
static struct bench_solution reference, other;

enum kind { CENTRAL, NEAR, NEWMARK, RK4, DORMAND_PRINCE, EXACT, OWN };
enum { ROWS_MAX = 96, ROUNDS = 9 };

struct row {
    enum kind kind;
    const char *name; /* of thud's methods, theirs */
    double setting;
    int ratio; /* NEAR: the long step by the short one */
    double seconds, spent, error;
    long steps;
    int runs;
};

static void run_minimal(struct scene *s, struct row *row)
{
    if (row->kind == CENTRAL)
        central_difference(s, row->setting);
    else if (row->kind == NEAR)
        central_near(s, row->setting, row->ratio);
    else if (row->kind == NEWMARK)
        newmark(s, row->setting);
    else
        located(s, row->kind == RK4 ? row->setting : 0, row->kind == RK4 ? 0 : row->setting);
    row->steps = s->steps;
    row->error = bench_scene_error(&opened, s->peak, &reference);
}

/* thud's own: the exact method with a tolerance, the others with a step and nothing located. */
static double run_thud(struct row *row)
{
    static struct bench_solution solution;
    struct thud_run_options options = opened.options;
    options.method = thud_method_find(row->name);
    options.locate = false;
    *(row->kind == EXACT ? &options.tolerance : &options.step_s) = row->setting;
    double seconds = bench_scene_once(&opened, &options, &solution);
    row->steps = solution.work.steps;
    row->error = bench_scene_error(&opened, solution.acceleration_mps2, row->kind == EXACT ? &other : &reference);
    return seconds;
}

static void run_row(struct scene *s, struct row *row)
{
    double from = bench_processor_s(), took;
    if (row->kind >= EXACT) {
        took = run_thud(row);
    } else {
        run_minimal(s, row);
        took = bench_processor_s() - from;
    }
    row->seconds = row->runs == 0 || took < row->seconds ? took : row->seconds;
    row->spent += took;
    row->runs++;
}

/* The least of several runs of each row. All rows take turns, so that what the machine does besides meets them alike. */
static void time_rows(struct scene *s, struct row *row, int rows)
{
    static const double enough_s = 1, short_s = 5e-3;
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < rows; i++) {
            if (round >= 3 && row[i].spent > enough_s)
                continue;
            run_row(s, &row[i]);
            for (int again = 1; again < 4 && row[i].seconds < short_s; again++)
                run_row(s, &row[i]);
        }
}

static int list_rows(struct row *row)
{
    static const double steps[] = {5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5};
    static const char *const own[] = {"central-difference", "newmark"};
    int n = 0;
    for (double tolerance = 1e-2; tolerance > 5e-11; tolerance /= 10)
        row[n++] = (struct row){.kind = EXACT, .name = "exact", .setting = tolerance};
    for (int i = 0; i < 9; i++)
        row[n++] = (struct row){.kind = CENTRAL, .name = "central-difference", .setting = steps[i]};
    for (int i = 3; i < 9; i++)
        for (int ratio = 5; ratio <= 40 && ratio * steps[i] < 3e-3; ratio *= 2)
            row[n++] = (struct row){.kind = NEAR, .name = "central-near", .setting = steps[i], .ratio = ratio};
    for (int i = 0; i < 8; i++)
        row[n++] = (struct row){.kind = NEWMARK, .name = "newmark", .setting = steps[i]};
    for (int i = 0; i < 6; i++)
        row[n++] = (struct row){.kind = RK4, .name = "rk4", .setting = steps[i]};
    for (double tolerance = 1e-2; tolerance > 5e-11; tolerance /= 10)
        row[n++] = (struct row){.kind = DORMAND_PRINCE, .name = "dormand-prince", .setting = tolerance};
    for (int i = 0; i < 2; i++)
        for (int k = 4; k < 6; k++)
            row[n++] = (struct row){.kind = OWN, .name = own[i], .setting = steps[k]};
    return n;
}

int main(int argc, char **argv)
{
    static struct scene s;
    static struct row row[ROWS_MAX];
    double least = INFINITY;
    bench_scene_open(&opened, argc, argv);
    if (!read_scene(&opened, &s)) {
        fprintf(stderr, "minimal: shear buildings under a ground motion, the paper's two laws, at most %d floors\n",
                MODES);
        return 1;
    }
    bench_scene_reference(&opened, &reference, &other);
    int rows = list_rows(row);
    time_rows(&s, row, rows);
    for (int i = 0; i < rows; i++) {
        const struct row *r = &row[i];
        if (r->kind == DORMAND_PRINCE)
            least = fmin(least, r->error);
        if (isfinite(r->error) && r->error < 10)
            printf("%s%s,%.3g,%.6g,%.3e,%ld\n",
                   r->kind < EXACT  ? "minimal-"
                   : r->kind == OWN ? "thud-"
                                    : "",
                   r->name, r->setting, r->seconds, r->error, r->steps);
    }
    bench_scene_close(&opened);
    if (least < 1e-5)
        return 0;
    fprintf(stderr, "minimal: dormand-prince and thud differ by %.1e at best: this is another scene\n", least);
    return 1;
}
