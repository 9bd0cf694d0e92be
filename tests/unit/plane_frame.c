#include "plane_frame.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Four frames of four columns, 50 by 50 cm, and beams of 30 by 60 cm, cracked (half), E = 30 GPa. */
const struct plane_frame plane_frame_shipped = {
    6, 4, 3.5, 6, 4 * 0.5 * 30e9 * 0.5 * 0.5 * 0.5 * 0.5 / 12, 4 * 0.5 * 30e9 * 0.3 * 0.6 * 0.6 * 0.6 / 12};
/* Two walls of 5 m by 30 cm, cracked (half). */
const struct plane_frame plane_wall_shipped = {6, 1, 3.5, 0, 2 * 0.5 * 30e9 * 0.3 * 5 * 5 * 5 / 12, 0};

/* Adds a member's 4 x 4 stiffness at these unknowns; -1: held. */
static void add(double *k, int n, const int at[4], const double member[4][4])
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            if (at[i] >= 0 && at[j] >= 0)
                k[at[i] * n + at[j]] += member[i][j];
}

/* A column by the sways and rotations (along the column, from below) of its lower and upper end. */
static void add_column(double *k, int n, const int at[4], double ei, double h)
{
    const double a = 12 * ei / (h * h * h), b = 6 * ei / (h * h), c = 4 * ei / h, d = 2 * ei / h;
    const double member[4][4] = {{a, b, -a, b}, {b, c, -b, d}, {-a, -b, a, -b}, {b, d, -b, c}};
    add(k, n, at, member);
}

static void add_beam(double *k, int n, int left, int right, double ei, double length)
{
    const double c = 4 * ei / length, d = 2 * ei / length;
    const double member[4][4] = {{c, d}, {d, c}};
    add(k, n, (const int[]){left, right, -1, -1}, member);
}

void plane_frame_stiffness(const struct plane_frame *f, double *out)
{
    const int sways = f->storeys, n = sways * (1 + f->lines);
    double *k = calloc((size_t)(n * n), sizeof *k);
    assert(k);
    for (int i = 0; i < sways; i++)
        for (int c = 0; c < f->lines; c++) {
            const int joint = sways + i * f->lines + c, below = i > 0 ? joint - f->lines : -1;
            add_column(k, n, (const int[]){i - 1, below, i, joint}, f->column_nm2, f->height_m);
            if (c > 0)
                add_beam(k, n, joint - 1, joint, f->beam_nm2, f->bay_m);
        }
    for (int r = n - 1; r >= sways; r--) /* one rotation after the other */
        for (int i = 0; i < r; i++)
            for (int j = 0; j < r; j++)
                k[i * n + j] -= k[i * n + r] * k[r * n + j] / k[r * n + r];
    for (int i = 0; i < sways; i++)
        memcpy(out + i * sways, k + i * n, (size_t)sways * sizeof *out);
    free(k);
}
