/* Modes of structures that linear links tie. In the structures' own modal coordinates, one after the other, with the
 * row g of a link and its d = g . q,
 *
 *     q'' + (D + sum c g g^T) q' + (Omega^2 + sum k g g^T) q = ...
 *
 * where D is what the structures' own damping is there. The eigenvectors V of the stiffness give the common modes
 * Phi V, orthonormal as the own ones are, and V^T (D + sum c g g^T) V couples them. Where a structure's highest modes
 * are left out, the common modes are those that the others allow. */
#include "core/model/tie.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/largest.h"
#include "core/numerics/vec.h"

static bool is_linear(const struct thud_link_input *link)
{
    return !link->law && (link->stiffness_npm != 0 || link->damping_nspm != 0);
}

int thud_tie_systems(const struct thud_model_input *in, int *system, bool *tied)
{
    for (int s = 0; s < in->nstructures; s++) {
        system[s] = s;
        tied[s] = false;
    }
    for (int i = 0; i < in->nlinks; i++) {
        const struct thud_link_input *link = &in->link[i];
        if (!is_linear(link))
            continue;
        bool both = link->left_floor > 0 && link->right_floor > 0;
        int a = link->left_floor > 0 ? link->left_structure : link->right_structure,
            b = both ? link->right_structure : a, first = a < b ? a : b, last = a < b ? b : a;
        tied[first] = tied[last] = true;
        for (int s = first + 1; s <= last; s++) /* neighbours, so that what stands between them is nothing */
            system[s] = -1;
    }
    int count = 0;
    for (int s = 0; s < in->nstructures; s++)
        system[s] = system[s] < 0 ? count - 1 : count++;
    for (int s = 1; s < in->nstructures; s++)
        tied[s] = tied[s] || (system[s] == system[s - 1] && tied[s - 1]);
    return count;
}

size_t thud_tie_bytes(const struct thud_model_input *in, const int *system, const bool *tied)
{
    size_t bytes = 0, all = 0;
    for (int s = 0; s < in->nstructures; s++)
        all += (size_t)thud_input_modes(&in->structure[s], in->modes);
    for (int s = 0, last; s < in->nstructures; s = last) {
        size_t modes = 0, floors = 0;
        for (last = s; last < in->nstructures && system[last] == system[s]; last++) {
            modes += (size_t)thud_input_modes(&in->structure[last], in->modes);
            floors += (size_t)thud_input_dofs(&in->structure[last]);
        }
        if (tied[s])
            bytes += thud_arena_room(floors * modes, sizeof(double)) + thud_arena_room(modes * modes, sizeof(double));
    }
    return bytes + (size_t)in->nlinks * thud_arena_room(all, sizeof(double));
}

/* A link's row in the own modes of the structures from `first_mode` on. */
static void link_row(const struct thud_model *m, const struct thud_link_input *link, int first_mode, int modes,
                     double *g)
{
    const int structure[] = {link->left_structure, link->right_structure},
              floor[] = {link->left_floor, link->right_floor};
    memset(g, 0, (size_t)modes * sizeof *g);
    for (int side = 0; side < 2; side++) {
        const struct thud_model_structure *p = &m->structure[structure[side]];
        for (int j = 0; floor[side] > 0 && j < p->modes; j++)
            g[p->first_mode - first_mode + j] += (side == 0 ? 1 : -1) * p->phi[(floor[side] - 1) * p->modes + j];
    }
}

struct tie {
    int first, last, modes, floors; /* structures from first on, before last */
    int first_mode;
    double *stiffness; /* (modes x modes) and in its place the eigenvectors, column by column */
    double *damping, *temp;
    double *square; /* (modes) eigenvalues */
    double *row;    /* (modes) */
    double *work;
    int work_size;
};

/* The work space of a system, all of it 0. LAPACK's dsyev asks for 3 n - 1 doubles and is quickest with 34 n. */
static enum thud_status prepare(struct tie *t, const struct thud_model *m, int system, struct thud_error *err)
{
    *t = (struct tie){.first = m->system[system]};
    t->first_mode = m->structure[t->first].first_mode;
    for (t->last = t->first; t->last < m->nstructures && m->structure[t->last].system == system; t->last++) {
        t->modes += m->structure[t->last].modes;
        t->floors += m->structure[t->last].dofs;
    }
    const size_t n = (size_t)t->modes;
    t->work_size = 34 * t->modes;
    return THUD_LAY(err, THUD_PIECE(t->stiffness, n * n), THUD_PIECE(t->damping, n * n), THUD_PIECE(t->temp, n * n),
                    THUD_PIECE(t->square, n), THUD_PIECE(t->row, n), THUD_PIECE(t->work, t->work_size));
}

/* Omega^2 and D of the structures by themselves, which are blocks along the diagonal. */
static void fill_own(struct tie *t, const struct thud_model *m)
{
    const int n = t->modes;
    for (int s = t->first; s < t->last; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        const int at = p->first_mode - t->first_mode;
        for (int i = 0; i < p->modes; i++) {
            t->stiffness[(at + i) * n + at + i] = m->spring[p->first_mode + i];
            t->damping[(at + i) * n + at + i] = m->dashpot[p->first_mode + i];
            for (int j = 0; p->damping && j < p->modes; j++)
                t->damping[(at + i) * n + at + j] = p->damping[i * p->modes + j];
        }
    }
}

/* + sum k g g^T, + sum c g g^T over the links of the system. */
static void add_links(struct tie *t, const struct thud_model *m, const struct thud_model_input *in)
{
    const int n = t->modes;
    for (int l = 0; l < in->nlinks; l++) {
        const struct thud_link_input *link = &in->link[l];
        const int s = link->left_floor > 0 ? link->left_structure : link->right_structure;
        if (!is_linear(link) || s < t->first || s >= t->last)
            continue;
        link_row(m, link, t->first_mode, n, t->row);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                t->stiffness[i * n + j] += link->stiffness_npm * t->row[i] * t->row[j];
                t->damping[i * n + j] += link->damping_nspm * t->row[i] * t->row[j];
            }
    }
}

/* V^T D V, in place; V is in t->stiffness, column by column. */
static void turn_damping(struct tie *t)
{
    const int n = t->modes;
    const double *v = t->stiffness;
    memset(t->temp, 0, (size_t)(n * n) * sizeof *t->temp);
    for (int a = 0; a < n; a++)
        thud_add_rows(n, n, 1, v + a * n, t->damping, t->temp + a * n);
    for (int a = 0; a < n; a++)
        for (int b = 0; b <= a; b++)
            t->damping[a * n + b] = t->damping[b * n + a] = thud_dot(n, t->temp + a * n, v + b * n);
}

/* Modal values of the whole, of the ground's influence and of the initial motion: V^T x. */
static void turn_values(const struct tie *t, double *x)
{
    memcpy(t->row, x + t->first_mode, (size_t)t->modes * sizeof *x);
    for (int a = 0; a < t->modes; a++)
        x[t->first_mode + a] = thud_dot(t->modes, t->stiffness + a * t->modes, t->row);
}

/* Phi V of each structure's floors, row by row into phi. */
static void turn_shapes(const struct tie *t, struct thud_model *m, double *phi)
{
    const int n = t->modes;
    for (int s = t->first; s < t->last; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        const int at = p->first_mode - t->first_mode;
        for (int i = 0; i < p->dofs; i++, phi += n)
            for (int a = 0; a < n; a++)
                phi[a] = thud_dot(p->modes, p->phi + i * p->modes, t->stiffness + a * n + at);
    }
}

/* omega of the common modes. An eigenvalue of rounding's size is a motion that
 * strains nothing. All damping is in the dense block. */
static void fill_modes(const struct tie *t, struct thud_model *m)
{
    const double largest = t->square[t->modes - 1], least = 8 * t->modes * 2.2e-16 * fmax(largest, 0);
    for (int a = 0; a < t->modes; a++) {
        const int at = t->first_mode + a;
        m->spring[at] = t->square[a] > least ? t->square[a] : 0; /* bodies that are free together */
        m->omega[at] = sqrt(m->spring[at]);
        m->zeta[at] = m->dashpot[at] = 0;
    }
}

/* The structures' rows of the common modes, and their damping where there is any. */
static void hand_out(const struct tie *t, struct thud_model *m, const double *phi, const double *damping)
{
    for (int s = t->first; s < t->last; s++) {
        struct thud_model_structure *p = &m->structure[s];
        p->phi = phi;
        p->first_mode = t->first_mode;
        p->modes = t->modes;
        p->damping = damping;
        phi += p->dofs * t->modes;
    }
}

enum thud_status thud_tie_system(struct thud_model *m, struct thud_arena *arena, const struct thud_model_input *in,
                                 int system, struct thud_error *err)
{
    struct tie t;
    const enum thud_status status = prepare(&t, m, system, err);
    if (status != THUD_OK)
        return status;
    const size_t n = (size_t)t.modes;
    fill_own(&t, m);
    add_links(&t, m, in);
    if (LAPACKE_dsyev_work(LAPACK_COL_MAJOR, 'V', 'U', t.modes, t.stiffness, t.modes, t.square, t.work, t.work_size) !=
        0) {
        free(t.stiffness);
        return thud_error_refuse(err, THUD_INPUT, "links", "less stiff links",
                                 "the modes of linked structures were not found");
    }
    double *phi = thud_arena_take(arena, (size_t)t.floors * n, sizeof *phi),
           *damping = thud_arena_take(arena, n * n, sizeof *damping);
    turn_damping(&t);
    memcpy(damping, t.damping, n * n * sizeof *damping);
    turn_values(&t, m->gamma);
    turn_values(&t, m->qd0);
    turn_shapes(&t, m, phi);
    hand_out(&t, m, phi, thud_largest_size(damping, (int)(n * n)) > 0 ? damping : NULL);
    fill_modes(&t, m);
    free(t.stiffness);
    return THUD_OK;
}
