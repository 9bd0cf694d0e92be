#include "core/motion/complex_modes.h"

#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/numerics/vec.h"

/* Part of the largest root below which one is that of a free body; and |u^H v| of unit vectors below which a root is as
 * good as double. */
static const double least_root = 1e-9, least_product = 1e-7;

struct roots {
    int size;                     /* 2 n */
    double *a, *real, *imaginary; /* A, column by column; roots */
    double *left, *right, *work;  /* eigenvectors, column by column, a pair's real and imaginary part */
    double *block;
};

static bool find(struct roots *r, const struct thud_model *m, const struct thud_model_structure *p)
{
    const int n = p->modes, size = 2 * n;
    const size_t square = (size_t)size * (size_t)size;
    r->size = size;
    r->block = calloc(3 * square + 10 * (size_t)size, sizeof *r->block);
    if (!r->block)
        return false;
    r->a = r->block;
    r->left = r->a + square;
    r->right = r->left + square;
    r->real = r->right + square;
    r->imaginary = r->real + size;
    r->work = r->imaginary + size;
    for (int j = 0; j < n; j++) {
        r->a[(n + j) * size + j] = 1;
        r->a[j * size + n + j] = -m->spring[p->first_mode + j];
        for (int i = 0; i < n; i++)
            r->a[(n + j) * size + n + i] = -p->damping[i * n + j];
    }
    if (LAPACKE_dgeev_work(LAPACK_COL_MAJOR, 'V', 'V', size, r->a, size, r->real, r->imaginary, r->left, size, r->right,
                           size, r->work, 8 * size) != 0)
        r->real[0] = NAN;
    return true;
}

static double complex element(const double *vectors, const struct roots *r, int k, int i)
{
    return vectors[k * r->size + i] + (r->imaginary[k] > 0 ? I * vectors[(k + 1) * r->size + i] : 0);
}

/* Root k: its row of w and its shares; whether it is of use. */
static bool fill_root(struct thud_complex_modes *c, const struct thud_model *m, const struct thud_model_structure *p,
                      const struct roots *r, int k, double dt_s)
{
    const int n = c->n, at = c->roots;
    const double complex lambda = r->real[k] + I * r->imaginary[k];
    const double times = r->imaginary[k] > 0 ? 2 : 1;
    double *re = c->part + 2 * at * c->size, *im = re + c->size;
    double complex product = 0, ground = 0;
    for (int i = 0; i < 2 * n; i++)
        product += conj(element(r->left, r, k, i)) * element(r->right, r, k, i);
    if (!(cabs(product) > least_product))
        return false;
    for (int i = 0; i < 2 * n; i++) {
        const double complex w = conj(element(r->left, r, k, i)) / product;
        ground -= i < n ? 0 : w * m->gamma[p->first_mode + i - n];
        re[i] = creal(w);
        im[i] = cimag(w);
    }
    re[2 * n] = creal(ground / lambda);
    im[2 * n] = cimag(ground / lambda);
    re[2 * n + 1] = creal(ground / (lambda * lambda)) / dt_s;
    im[2 * n + 1] = cimag(ground / (lambda * lambda)) / dt_s;
    for (int j = 0; j < n; j++) {
        double share = times * cabs(element(r->right, r, k, j));
        for (int order = 0; order < THUD_COMPLEX_ORDERS; order++, share *= cabs(lambda))
            c->share[(order * n + j) * 2 * n + at] = share;
    }
    c->roots++;
    return true;
}

enum thud_status thud_complex_modes_init(struct thud_complex_modes *c, const struct thud_model *m, int system,
                                         double dt_s, struct thud_error *err)
{
    const struct thud_model_structure *p = &m->structure[m->system[system]];
    const size_t n = (size_t)p->modes, size = 2 * n + 2;
    struct roots r = {0};
    *c = (struct thud_complex_modes){.n = p->modes, .size = (int)size};
    c->block = calloc(4 * n * size + THUD_COMPLEX_ORDERS * 2 * n * n + 2 * n + size, sizeof *c->block);
    if (!c->block || !find(&r, m, p)) {
        thud_complex_modes_clear(c);
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    c->part = c->block;
    c->share = c->part + 4 * n * size;
    c->most = c->share + THUD_COMPLEX_ORDERS * 2 * n * n;
    c->now = c->most + 2 * n;
    double largest = 0;
    bool fine = isfinite(r.real[0]);
    for (int k = 0; k < r.size; k++)
        largest = fmax(largest, hypot(r.real[k], r.imaginary[k]));
    for (int k = 0; k < r.size && fine; k++)
        if (r.imaginary[k] >= 0)
            fine = hypot(r.real[k], r.imaginary[k]) > least_root * largest && fill_root(c, m, p, &r, k, dt_s);
    free(r.block);
    if (!fine)
        thud_complex_modes_clear(c);
    return THUD_OK;
}

void thud_complex_modes_clear(struct thud_complex_modes *modes)
{
    free(modes->block);
    *modes = (struct thud_complex_modes){0};
}

void thud_complex_modes_bounds(struct thud_complex_modes *c, const double *q, const double *qd, int apart,
                               const double *s, const double *ground, const double *after, int intervals, double *out,
                               int stride)
{
    const int n = c->n;
    memset(c->most, 0, (size_t)c->roots * sizeof *c->most);
    for (int t = 0; t < intervals; t++) {
        for (int j = 0; j < n; j++) {
            c->now[j] = q[j * apart + t] - s[j];
            c->now[n + j] = qd[j * apart + t];
        }
        c->now[2 * n] = ground[t];
        c->now[2 * n + 1] = after[t] - ground[t];
        for (int k = 0; k < c->roots; k++) {
            const double *row = c->part + 2 * k * c->size, re = thud_dot(c->size, row, c->now),
                         im = thud_dot(c->size, row + c->size, c->now), square = re * re + im * im;
            c->most[k] = square > c->most[k] ? square : c->most[k];
        }
    }
    for (int k = 0; k < c->roots; k++)
        c->most[k] = sqrt(c->most[k]);
    for (int order = THUD_COMPLEX_LEAST; order < THUD_COMPLEX_ORDERS; order++)
        for (int j = 0; j < n; j++)
            out[order * stride + j] = thud_dot(c->roots, c->share + (order * n + j) * 2 * n, c->most);
}
