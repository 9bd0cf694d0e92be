/* A model out of its input, in one block of memory: the arrays of the whole, and room for those of its parts, which is
 * reckoned first (part_bytes) and from which they are taken in the same order.
 *
 * The order of filling is that of what needs what:
 *
 *     structures   each by itself: modes on rigid ground, less the weight, and on soil those of the whole
 *     systems      neighbours that linear links tie get common modes in place of their own (tie.c); from here on a
 *                  structure's phi, modes and damping are those of its system
 *     bounds       the largest shapes and drifts of the modes as they are in the end
 *     sums         rows of storey shears, of buildings by their matrix: they are read from these modes
 *     contacts     pairs of floors first, then one-sided links, so that a pair's index is that of the input
 *     moments      behind the links, whose forces on a building's floors have a part in them
 *     storeys      rows behind the contacts: those that yield, then links of friction; and with them what struck
 *                  columns take of a storey's yielding
 *     delassus     g_a . g_b of all rows */
#include "core/model/model.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/largest.h"
#include "base/quantity.h"
#include "core/model/element.h"
#include "core/model/foundation.h"
#include "core/model/modes.h"
#include "core/model/tie.h"
#include "core/numerics/vec.h"

/* Modes of a structure, and of those that it may be tied to. */
static int modes_of(const struct thud_model_input *in, int structure)
{
    int modes = 0;
    for (int s = 0; s < in->nstructures; s++)
        modes += s == structure || in->nlinks > 0 ? thud_input_modes(&in->structure[s], in->modes) : 0;
    return modes;
}

/* Of the structure whose columns are struck. */
static int struck_modes(const struct thud_model_input *in, const struct thud_contact_input *contact)
{
    return modes_of(in, contact->struck.side < 0 ? contact->left_structure : contact->right_structure);
}

/* Whether storey i of a structure yields: one whose stiffness stays the same beyond its yield drift is elastic. */
static bool yields(const struct thud_structure_input *in, int i)
{
    return in->stiffness_npm && in->yield_m && isfinite(in->yield_m[i]) && in->hardening[i] < 1;
}

/* Room for the arrays of single structures and contacts. */
static size_t part_bytes(const struct thud_model_input *in)
{
    size_t bytes = 0;
    for (int c = 0; c < in->ncontacts; c++)
        bytes += in->contact[c].struck.side
                     ? 2 * thud_arena_room((size_t)struck_modes(in, &in->contact[c]), sizeof(double))
                     : 0;
    for (int s = 0; s < in->nstructures; s++) {
        size_t n = (size_t)thud_input_dofs(&in->structure[s]),
               kept = (size_t)thud_input_modes(&in->structure[s], in->modes);
        bytes += thud_arena_room(n * kept, sizeof(double)) + thud_arena_room(kept * kept, sizeof(double)) +
                 4 * thud_arena_room(n, sizeof(double));
        if (in->structure[s].foundation)
            bytes += thud_arena_room(n, sizeof(double)) +
                     n * thud_arena_room((size_t)modes_of(in, s), sizeof(double)); /* rows of storeys that yield */
        if (in->structure[s].foundation || in->structure[s].collapse_m)
            bytes += thud_arena_room(n * (size_t)modes_of(in, s), sizeof(double));
        if (in->structure[s].matrix_npm)
            bytes += thud_arena_room(n * n, sizeof(double)) +
                     thud_arena_room(n * (n + (size_t)modes_of(in, s)), sizeof(double));
        if (in->structure[s].level_m)
            bytes += thud_arena_room(n + 2 * (size_t)modes_of(in, s), sizeof(double));
    }
    return bytes;
}

/* The first `kept` of a row's n values, row after row. */
static void keep_columns(const double *from, int rows, int n, int kept, double *to)
{
    for (int i = 0; i < rows; i++)
        memcpy(to + i * kept, from + i * n, (size_t)kept * sizeof *to);
}

/* D (n x n) of all modes among those that stay: one that is left out slows no other. */
static void keep_damping(struct thud_arena *arena, struct thud_model_structure *to, const double *all, int n)
{
    double *damping = thud_arena_take(arena, (size_t)to->modes * (size_t)to->modes, sizeof *damping);
    keep_columns(all, to->modes, n, to->modes, damping);
    to->damping = damping;
}

/* What the weight takes off the stiffness: net, storeys of k - W/h, or K - K_G. */
static void fill_weight(struct thud_arena *arena, struct thud_model_structure *to,
                        const struct thud_structure_input *in, double *net)
{
    const size_t n = (size_t)in->n;
    memcpy(net, in->matrix_npm ? in->matrix_npm : in->stiffness_npm, (in->matrix_npm ? n * n : n) * sizeof *net);
    if (!in->geometric_npm)
        return;
    double *geometric = thud_arena_take(arena, n, sizeof(double)),
           *collapse = thud_arena_take(arena, n, sizeof(double));
    memcpy(geometric, in->geometric_npm, n * sizeof *geometric);
    memcpy(collapse, in->collapse_m, n * sizeof *collapse);
    for (size_t i = 0; i < n && !in->matrix_npm; i++)
        net[i] -= geometric[i];
    for (int i = 0; i < in->n && in->matrix_npm; i++)
        thud_foundation_add_storey(-geometric[i], in->n, i, i - 1, net);
    to->collapse_least_m = collapse[0];
    for (size_t i = 1; i < n; i++)
        to->collapse_least_m = fmin(to->collapse_least_m, collapse[i]);
    to->geometric_npm = geometric;
    to->collapse_m = collapse;
}

static void fill_leans(struct thud_model *m, struct thud_arena *arena, struct thud_model_structure *to)
{
    double *lean = thud_arena_take(arena, (size_t)to->n * (size_t)to->modes, sizeof *lean);
    for (int i = 0; i < to->n; i++)
        for (int j = 0; j < to->modes; j++)
            lean[i * to->modes + j] = thud_model_lean(to, to->phi + j, to->modes, i);
    to->lean = lean;
    m->sums = m->sums || to->rise;
}

/* Rows of the storey shears of a building by its matrix, by the modes that it has in the end. */
static void fill_shears(struct thud_model *m, struct thud_arena *arena, struct thud_model_structure *to)
{
    const int n = to->n, modes = to->modes;
    const double *k = to->matrix_npm;
    double *shear = thud_arena_take(arena, (size_t)n * (size_t)(modes + n), sizeof *shear),
           *by_drift = shear + n * modes;
    for (int i = n - 1; i >= 0; i--) {
        for (int j = 0; j < modes; j++) {
            double force = 0, shape = 0;
            for (int l = 0; l < n; l++) {
                shape = to->rise ? shape + thud_model_drift(to, to->phi + j, modes, l) : to->phi[l * modes + j];
                force += k[i * n + l] * shape;
            }
            shear[i * modes + j] = force + (i + 1 < n ? shear[(i + 1) * modes + j] : 0);
        }
        double sum = 0; /* of the rest of row i of K */
        for (int l = n - 1; l >= 0; l--) {
            sum += k[i * n + l];
            by_drift[i * n + l] = sum + (i + 1 < n ? by_drift[(i + 1) * n + l] : 0);
        }
    }
    to->shear = shear;
    m->sums = true;
}

/* On soil: the modes and the damping of the whole out of those on rigid ground. */
static enum thud_status fill_soil(struct thud_arena *arena, struct thud_model_structure *to,
                                  const struct thud_structure_input *in, const double *fixed_omega, const double *fixed,
                                  const double *fixed_damping, double *omega, double *phi, struct thud_error *err)
{
    const size_t dofs = (size_t)to->dofs;
    double *block = malloc(2 * dofs * dofs * sizeof *block),
           *rise = thud_arena_take(arena, (size_t)to->n, sizeof *rise);
    if (!block)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    double *all = block, *all_damping = block + dofs * dofs;
    to->rigid_period_s = 2 * THUD_PI / fixed_omega[0];
    to->arm_m = thud_foundation_arm(in);
    to->sway_npm = in->foundation->sway_npm;
    to->rocking_npm = in->foundation->rocking_nmprad / (to->arm_m * to->arm_m);
    for (int i = 0; i < to->n; i++)
        rise[i] = in->rise_m[i] / to->arm_m;
    to->rise = rise;
    enum thud_status status =
        thud_foundation_modes(in, fixed_omega, fixed, fixed_damping, omega, all, all_damping, err);
    if (status == THUD_OK)
        keep_columns(all, to->dofs, to->dofs, to->modes, phi);
    to->soil_damping = 0.5 * all_damping[0] / omega[0];
    if (status == THUD_OK && thud_largest_size(all_damping, (int)(dofs * dofs)) > 0)
        keep_damping(arena, to, all_damping, to->dofs);
    free(block);
    return status;
}

/* Modes and damping of a building: those of its storeys or its matrix less what the weight takes off, on rigid ground; and
 * on soil those of the whole. */
static enum thud_status fill_building(struct thud_arena *arena, struct thud_model_structure *to,
                                      const struct thud_structure_input *in, struct thud_error *err)
{
    size_t n = (size_t)in->n, square = n * n;
    double *phi = thud_arena_take(arena, (size_t)to->dofs * (size_t)to->modes, sizeof(double)),
           *k = thud_arena_take(arena, in->matrix_npm ? square : n, sizeof(double)),
           *omega = thud_arena_take(arena, (size_t)to->dofs, sizeof(double));
    to->phi = phi;
    if (in->matrix_npm)
        to->matrix_npm = memcpy(k, in->matrix_npm, square * sizeof(double));
    else
        to->stiffness_npm = memcpy(k, in->stiffness_npm, n * sizeof(double));
    to->omega = omega;
    to->drifts = true;
    double *all = malloc((3 * n + 4 * square) * sizeof *all);
    if (!all)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    double *net = all, *modes = net + square, *damping = modes + square, *work = damping + square;
    fill_weight(arena, to, in, net);
    enum thud_status status =
        (in->matrix_npm ? thud_modes_matrix : thud_modes_shear)(in->n, in->mass_kg, net, omega, modes, work, err);
    const bool isolated = in->isolated && (in->damping > 0 || in->isolation_damping > 0);
    if (status == THUD_OK && isolated) /* the isolators' dashpot couples the modes */
        status = thud_modes_isolated_damping(in->n, in->mass_kg, net, in->damping, in->isolation_damping, modes,
                                             damping, err);
    if (status == THUD_OK && in->foundation) {
        memcpy(work, omega, n * sizeof *work);
        status = fill_soil(arena, to, in, work, modes, isolated ? damping : NULL, omega, phi, err);
    } else if (status == THUD_OK) {
        keep_columns(modes, in->n, in->n, to->modes, phi);
        if (isolated)
            keep_damping(arena, to, damping, in->n);
    }
    free(all);
    return status;
}

/* A body: one mode without stiffness; a wall: none. */
static void fill_rigid(struct thud_arena *arena, struct thud_model_structure *to, const struct thud_structure_input *in)
{
    assert(in->n <= 1);
    if (in->n == 0)
        return;
    double *phi = thud_arena_take(arena, 1, sizeof(double)), *omega = thud_arena_take(arena, 1, sizeof(double));
    phi[0] = 1 / sqrt(in->mass_kg[0]);
    omega[0] = 0;
    to->phi = phi;
    to->omega = omega;
}

/* What a mode alone decides: gamma_j = phi_j^T M 1, the part of the ground's motion and of the initial velocity in it. */
static void fill_mode(struct thud_model *m, const struct thud_model_structure *p, const struct thud_structure_input *in,
                      int j)
{
    int at = p->first_mode + j;
    double gamma = 0;
    for (int i = 0; i < p->dofs && i <= p->n; i++)
        gamma += p->phi[i * p->modes + j] * (i < p->n ? in->mass_kg[i] : in->foundation->mass_kg);
    m->gamma[at] = gamma;
    m->omega[at] = p->omega[j];
    m->zeta[at] = p->damping ? 0 : in->damping;
    m->q0[at] = 0;
    m->qd0[at] = gamma * in->velocity_mps; /* Phi^T M v */
    m->spring[at] = m->omega[at] * m->omega[at];
    m->dashpot[at] = 2 * m->zeta[at] * m->omega[at];
}

/* Floors follow the ground only as far as the modes that stay carry them. */
static void fill_floor(struct thud_model *m, int s, const struct thud_structure_input *in, int i)
{
    const struct thud_model_structure *p = &m->structure[s];
    double share = p->modes < p->dofs || i > p->n ? 0 : 1; /* a rotation has no part in the ground's motion */
    for (int j = 0; j < p->modes && p->modes < p->dofs; j++)
        share += p->phi[i * p->modes + j] * m->gamma[p->first_mode + j];
    m->ground_influence[p->first + i] = share;
    m->mass_kg[p->first + i] = i < p->n    ? in->mass_kg[i]
                               : i == p->n ? in->foundation->mass_kg
                                           : in->foundation->inertia_kgm2 / (p->arm_m * p->arm_m);
    m->dof_structure[p->first + i] = s;
}

/* A bound of the rates r of free motion q'' + D q' + Omega^2 q = 0. Of a mode x of length 1, r^2 + (x.D x) r + x.Omega^2 x
 * = 0: its two rates are complex, of size Omega at most, or real and at most x.D x, and so the norm of D, which is at most
 * the fourth root of the sum of the squares of D^2. A dashpot on a light mass makes it far larger than any omega. Modes
 * that D does not couple have |rates| of omega (zeta < 1). */
double thud_model_fastest(const struct thud_model *m, int structure)
{
    const struct thud_model_structure *p = &m->structure[structure];
    double omega = p->modes > 0 ? m->omega[p->first_mode + p->modes - 1] : 0, squares = 0;
    for (int i = 0; p->damping && i < p->modes; i++)
        for (int j = 0; j < p->modes; j++) {
            double x = thud_dot(p->modes, p->damping + i * p->modes, p->damping + j * p->modes);
            squares += x * x;
        }
    return fmax(omega, sqrt(sqrt(squares)));
}

/* m->structure[s] has its slices. */
static enum thud_status fill_structure(struct thud_model *m, struct thud_arena *arena, int s,
                                       const struct thud_structure_input *in, struct thud_error *err)
{
    struct thud_model_structure *to = &m->structure[s];
    enum thud_status status = THUD_OK;
    if ((in->stiffness_npm || in->matrix_npm) && in->n > 0)
        status = fill_building(arena, to, in, err);
    else
        fill_rigid(arena, to, in);
    if (status == THUD_INPUT && in->foundation)
        thud_error_key(err, "structures.%d.foundation", s + 1);
    for (int j = 0; j < to->modes && status == THUD_OK; j++)
        fill_mode(m, to, in, j);
    for (int i = 0; i < to->dofs && status == THUD_OK; i++)
        fill_floor(m, s, in, i);
    m->collapses = m->collapses || to->collapse_m;
    m->left_out += to->dofs - to->modes;
    return status;
}

static int contact_dof(const struct thud_model *m, int structure, int floor)
{
    return floor == 0 ? -1 : m->structure[structure].first + floor - 1;
}

static const double *floor_row(const struct thud_model *m, int dof)
{
    const struct thud_model_structure *s = &m->structure[m->dof_structure[dof]];
    return s->phi + (dof - s->first) * s->modes;
}

static struct thud_model_side floor_side(const struct thud_model *m, int dof)
{
    if (dof < 0)
        return (struct thud_model_side){.structure = -1, .dof = -1, .below = -1, .share = 1, .tilt = -1};
    int s = m->dof_structure[dof];
    return (struct thud_model_side){
        floor_row(m, dof), s, m->structure[s].first_mode, m->structure[s].modes, dof, -1, 1, -1, 0};
}

/* The dof under a floor: the floor below, the foundation on soil, or -1, the ground. */
static int dof_below(const struct thud_model_structure *p, int dof)
{
    return dof > p->first ? dof - 1 : p->rise ? p->first + p->n : -1;
}

/* The rotation of the foundation moves the side too, by so much. */
static void tilt_side(const struct thud_model *m, struct thud_model_side *side, double by_tilt, double *row)
{
    const struct thud_model_structure *p = &m->structure[side->structure];
    side->tilt = p->first + p->n + 1;
    side->by_tilt = by_tilt; /* of r = H t */
    for (int j = 0; j < side->modes; j++)
        row[j] += by_tilt * floor_row(m, side->tilt)[j];
}

/* The place that is struck, eta of the length over the lower floor, moves with the floors above and below, h of the one
 * and 1 - h of the other. A turn t of the foundation alone moves these by z_lower t and (z_lower + h_i) t, h_i from level
 * to level, and the place, a over the lower floor, by (z_lower + a) t: the difference is (a - h h_i) t. */
static struct thud_model_side column_side(const struct thud_model *m, struct thud_arena *arena, int dof,
                                          const struct thud_struck_input *struck, double h)
{
    struct thud_model_side side = floor_side(m, dof);
    double *row = thud_arena_take(arena, (size_t)side.modes, sizeof *row);
    side.below = dof_below(&m->structure[side.structure], dof);
    side.share = h;
    for (int j = 0; j < side.modes; j++)
        row[j] = h * side.row[j] + (side.below < 0 ? 0 : (1 - h) * floor_row(m, side.below)[j]);
    const struct thud_model_structure *of = &m->structure[side.structure];
    if (of->rise)
        tilt_side(m, &side, struck->a_m / of->arm_m - h * of->rise[dof - of->first], row);
    for (int j = 0; j < side.modes; j++) /* with a turn, it may move more than any floor */
        m->mode_max[side.first_mode + j] = fmax(m->mode_max[side.first_mode + j], fabs(row[j]));
    side.row = row;
    return side;
}

/* 1/m of one side, 0 for a wall. */
static double inverse_mass(const struct thud_model *m, const struct thud_model_side *side)
{
    double inverse = side->dof < 0 ? 0 : side->share * side->share / m->mass_kg[side->dof];
    inverse += side->below < 0 ? 0 : (1 - side->share) * (1 - side->share) / m->mass_kg[side->below];
    return inverse + (side->tilt < 0 ? 0 : side->by_tilt * side->by_tilt / m->mass_kg[side->tilt]);
}

/* Adds a side's values by modes, by 1 or -1, to those of a row that begins at a mode. */
static void add_side(const struct thud_model_side *side, int sign, int first_mode, double *row)
{
    for (int j = 0; j < side->modes; j++)
        row[side->first_mode - first_mode + j] += sign * side->row[j];
}

/* The mass of a row whose two sides stand, and its row of the Jacobian, which is 0 before. */
static void fill_row(struct thud_model *m, int row)
{
    struct thud_model_contact *to = &m->contact[row];
    const double inverse = inverse_mass(m, &to->left) + inverse_mass(m, &to->right);
    double *g = m->jacobian + (size_t)row * (size_t)m->nmodes;
    assert(inverse > 0);
    to->setup.mass_kg = 1 / inverse;
    add_side(&to->left, 1, 0, g);
    add_side(&to->right, -1, 0, g);
}

/* Index of the columns between the floors `dof` and `below` that this interface's contacts strike; a new one where
 * there was none. */
static int column_of(struct thud_model *m, struct thud_arena *arena, const struct thud_contact_input *in,
                     const struct thud_model_side *side)
{
    const struct thud_struck_input *struck = &in->struck;
    double length = struck->a_m + struck->b_m;
    for (int i = 0; i < m->ncolumns; i++)
        if (m->column[i].interface == in->interface && m->column[i].dof == side->dof)
            return i;
    const struct thud_model_structure *of = &m->structure[side->structure];
    struct thud_model_column *to = &m->column[m->ncolumns];
    double *row = thud_arena_take(arena, (size_t)side->modes, sizeof *row);
    for (int j = 0; j < side->modes; j++)
        row[j] = thud_model_drift(of, of->phi + j, side->modes, side->dof - of->first);
    *to = (struct thud_model_column){.interface = in->interface,
                                     .structure = side->structure,
                                     .storey = side->dof - m->structure[side->structure].first + 1,
                                     .dof = side->dof,
                                     .below = side->below,
                                     .row = row,
                                     .first_mode = side->first_mode,
                                     .modes = side->modes,
                                     .yielding = -1,
                                     .height_m = length,
                                     .capacity_n = struck->capacity_n};
    if (!isnan(struck->ei_nm2)) {
        double k = 12 * struck->ei_nm2 / (length * length * length);
        to->per_drift[THUD_COLUMN_SHEAR_LOWER] = to->per_drift[THUD_COLUMN_SHEAR_UPPER] = k;
        to->per_drift[THUD_COLUMN_MOMENT_LOWER] = 0.5 * k * length;
        to->per_drift[THUD_COLUMN_MOMENT_UPPER] = -0.5 * k * length;
    }
    return m->ncolumns++;
}

/* A load on a member between two floors: end shears (1 - h) and h of it, which are b^2 (3a + b)/L^3 and
 * a^2 (a + 3b)/L^3 where it is clamped, b/L and a/L where it is hinged; end moments a b^2/L^2 and a^2 b/L^2, or none;
 * and what the member gives under it. */
static void load_columns(struct thud_model *m, struct thud_arena *arena, struct thud_model_contact *to,
                         const struct thud_contact_input *in)
{
    const struct thud_struck_input *struck = &in->struck;
    const struct thud_model_side *side = struck->side < 0 ? &to->left : &to->right;
    double a = struck->a_m, b = struck->b_m, length = a + b, h = side->share;
    double sign = struck->side < 0 ? -1 : 1; /* the force pushes the left one to the left, the right one to the right */
    to->struck = struck->side;
    to->column = column_of(m, arena, in, side);
    to->per_force[THUD_COLUMN_SHEAR_LOWER] = sign * (1 - h);
    to->per_force[THUD_COLUMN_SHEAR_UPPER] = -sign * h;
    to->per_force[THUD_COLUMN_MOMENT_LOWER] = struck->hinged ? 0 : sign * a * b * b / (length * length);
    to->per_force[THUD_COLUMN_MOMENT_UPPER] = struck->hinged ? 0 : sign * a * a * b / (length * length);
    if (!isnan(struck->ei_nm2))
        to->setup.column_npm = struck->hinged ? 3 * struck->ei_nm2 * length / (a * a * b * b)
                                              : 3 * struck->ei_nm2 * length * length * length / (a * a * a * b * b * b);
}

static enum thud_status fill_contact(struct thud_model *m, struct thud_arena *arena, int c,
                                     const struct thud_contact_input *in, struct thud_error *err)
{
    struct thud_model_contact *to = &m->contact[c];
    *to = (struct thud_model_contact){.interface = in->interface,
                                      .left_floor = in->left_floor,
                                      .right_floor = in->right_floor,
                                      .left_dof = contact_dof(m, in->left_structure, in->left_floor),
                                      .right_dof = contact_dof(m, in->right_structure, in->right_floor),
                                      .clearance_m = in->clearance_m,
                                      .law = in->law,
                                      .setup = in->setup};
    double eta = in->struck.side != 0 ? in->struck.a_m / (in->struck.a_m + in->struck.b_m) : 1;
    double h = in->struck.hinged ? eta : eta * eta * (3 - 2 * eta);
    to->column = -1;
    to->eta = eta;
    to->setup.column_npm = 0;
    to->left = in->struck.side < 0 ? column_side(m, arena, to->left_dof, &in->struck, h) : floor_side(m, to->left_dof);
    to->right =
        in->struck.side > 0 ? column_side(m, arena, to->right_dof, &in->struck, h) : floor_side(m, to->right_dof);
    fill_row(m, c);
    if (in->struck.side != 0)
        load_columns(m, arena, to, in);
    return thud_law_prepare(in->law, &to->setup, err);
}

/* The sides of the row of storey k; it has no law. On soil the lower one is the place right below the floor, as the
 * foundation's rotation carries it. */
static void fill_storey(struct thud_model *m, struct thud_arena *arena, int k)
{
    const struct thud_model_storey *storey = &m->storey[k];
    struct thud_model_contact *to = &m->contact[m->ncontacts + k];
    int dof = m->structure[storey->structure].first + storey->floor;
    *to = (struct thud_model_contact){
        .left_floor = storey->floor + 1, .right_floor = storey->floor, .left_dof = dof, .right_dof = -1};
    if (storey->link >= 0) {
        to->left_dof = m->link[storey->link].left_dof;
        to->right_dof = m->link[storey->link].right_dof;
    } else {
        to->right_dof = dof_below(&m->structure[storey->structure], dof);
    }
    to->column = -1;
    to->eta = 1;
    to->left = floor_side(m, to->left_dof);
    to->right = floor_side(m, to->right_dof);
    if (storey->link < 0 && m->structure[storey->structure].rise) {
        double *row = thud_arena_take(arena, (size_t)to->right.modes, sizeof *row);
        memcpy(row, to->right.row, (size_t)to->right.modes * sizeof *row);
        tilt_side(m, &to->right, m->structure[storey->structure].rise[storey->floor], row);
        to->right.row = row;
    }
    fill_row(m, m->ncontacts + k);
}

static void fill_storeys(struct thud_model *m, struct thud_arena *arena, const struct thud_model_input *input)
{
    int k = 0;
    for (int s = 0; s < input->nstructures; s++)
        for (int i = 0; i < input->structure[s].n; i++) {
            const struct thud_structure_input *in = &input->structure[s];
            if (!yields(in, i))
                continue;
            m->storey[k] = (struct thud_model_storey){.structure = s,
                                                      .floor = i,
                                                      .link = -1,
                                                      .stiffness_npm = in->stiffness_npm[i],
                                                      .yield_m = in->yield_m[i],
                                                      .hardening = in->hardening[i],
                                                      .geometric_npm = in->geometric_npm ? in->geometric_npm[i] : 0};
            fill_storey(m, arena, k++);
        }
    for (int i = 0; i < input->nlinks; i++)
        if (input->link[i].slip_n > 0) {
            const struct thud_link_input *in = &input->link[i];
            m->link[i].storey = k;
            m->storey[k] = (struct thud_model_storey){.structure = m->link[i].structure,
                                                      .floor = -1,
                                                      .link = i,
                                                      .stiffness_npm = in->stiffness_npm,
                                                      .yield_m = in->slip_n / in->stiffness_npm};
            fill_storey(m, arena, k++);
        }
    for (int i = 0; i < m->ncolumns; i++)
        for (k = 0; k < m->nstoreys; k++) {
            struct thud_model_column *p = &m->column[i];
            if (m->storey[k].structure != p->structure || m->storey[k].floor != p->storey - 1)
                continue;
            p->yielding = m->ncontacts + k;
            for (int q = 0; q < THUD_COLUMN_QUANTITIES; q++)
                p->per_yield[q] = p->per_drift[q] / m->storey[k].stiffness_npm;
        }
}

/* g_a . g_b: only where two rows move the modes of the same structure do both have parts; the other entries stay 0. */
static double shared_part(const struct thud_model *m, int a, int b)
{
    const double *ga = m->jacobian + (size_t)a * (size_t)m->nmodes, *gb = m->jacobian + (size_t)b * (size_t)m->nmodes;
    int of_a[2], of_b[2], na = thud_model_row_structures(m, a, of_a), nb = thud_model_row_structures(m, b, of_b);
    double sum = 0;
    for (int i = 0; i < na; i++) {
        const struct thud_model_structure *s = &m->structure[of_a[i]];
        bool both = false;
        for (int k = 0; k < nb; k++)
            both = both || m->structure[of_b[k]].system == s->system;
        sum += both ? thud_dot(s->modes, ga + s->first_mode, gb + s->first_mode) : 0;
    }
    return sum;
}

static void fill_delassus(struct thud_model *m)
{
    for (int a = 0; a < m->nrows; a++)
        for (int b = 0; b <= a; b++)
            m->delassus[a * m->nrows + b] = m->delassus[b * m->nrows + a] = shared_part(m, a, b);
}

/* The block with the arrays of the whole and room for those of its parts, the arena; and each structure's slices. */
static struct thud_model *lay_out(const struct thud_model_input *input, const int *system, const bool *tied,
                                  struct thud_arena *arena)
{
    int ndof = 0, nmodes = 0, nslips = 0, nstoreys = 0, ncontacts = input->ncontacts;
    for (int s = 0; s < input->nstructures; s++) {
        ndof += thud_input_dofs(&input->structure[s]);
        nmodes += thud_input_modes(&input->structure[s], input->modes);
        for (int i = 0; i < input->structure[s].n; i++)
            nstoreys += yields(&input->structure[s], i);
    }
    for (int i = 0; i < input->nlinks; i++) {
        ncontacts += input->link[i].law != NULL; /* one-sided */
        nslips += input->link[i].slip_n > 0;     /* of friction */
    }
    nstoreys += nslips;
    const size_t nc = (size_t)(ncontacts + nstoreys), bytes = part_bytes(input) + thud_tie_bytes(input, system, tied);
    struct thud_model *m, to = {.nstructures = input->nstructures,
                                .ndof = ndof,
                                .nmodes = nmodes,
                                .npairs = input->ncontacts,
                                .ncontacts = ncontacts,
                                .nlinks = input->nlinks,
                                .nstoreys = nstoreys,
                                .nslips = nslips,
                                .nrows = (int)nc};
    char *rest;
    if (THUD_LAY(NULL, THUD_PIECE(m, 1), THUD_PIECE(to.structure, to.nstructures),
                 THUD_PIECE(to.system, to.nstructures), THUD_PIECE(to.link, to.nlinks), THUD_PIECE(to.contact, nc),
                 THUD_PIECE(to.storey, nstoreys), THUD_PIECE(to.column, nc), THUD_PIECE(to.dof_structure, ndof),
                 THUD_PIECE(to.mass_kg, ndof), THUD_PIECE(to.ground_influence, ndof), THUD_PIECE(to.omega, nmodes),
                 THUD_PIECE(to.zeta, nmodes), THUD_PIECE(to.gamma, nmodes), THUD_PIECE(to.spring, nmodes),
                 THUD_PIECE(to.dashpot, nmodes), THUD_PIECE(to.q0, nmodes), THUD_PIECE(to.qd0, nmodes),
                 THUD_PIECE(to.mode_max, 2 * nmodes), THUD_PIECE(to.jacobian, nc * (size_t)nmodes),
                 THUD_PIECE(to.delassus, nc * nc), THUD_PIECE(rest, bytes)) != THUD_OK)
        return NULL;
    *arena = (struct thud_arena){rest, rest + bytes};
    *m = to;
    struct thud_model_structure next = {0};
    for (int s = 0; s < m->nstructures; s++) {
        next.n = input->structure[s].n;
        next.dofs = thud_input_dofs(&input->structure[s]);
        next.modes = thud_input_modes(&input->structure[s], input->modes);
        next.system = system[s];
        m->structure[s] = next;
        next.first += next.dofs;
        next.first_mode += next.modes;
        if (s == 0 || system[s] != system[s - 1])
            m->system[m->nsystems++] = s;
    }
    return m;
}

/* d of a link by modal values: those of its ends' systems, which are one where it always acts. */
static void fill_link_row(struct thud_model *m, struct thud_arena *arena, struct thud_model_link *to)
{
    const struct thud_model_side left = floor_side(m, to->left_dof), right = floor_side(m, to->right_dof);
    const struct thud_model_side *first = left.dof >= 0 ? &left : &right, *last = right.dof >= 0 ? &right : &left;
    if (last->first_mode < first->first_mode) {
        const struct thud_model_side *swap = first;
        first = last;
        last = swap;
    }
    to->structure = first->structure;
    to->first_mode = first->first_mode;
    to->modes = last->first_mode + last->modes - first->first_mode;
    double *row = thud_arena_take(arena, (size_t)to->modes, sizeof *row);
    to->row = row;
    add_side(&left, 1, to->first_mode, row);
    add_side(&right, -1, to->first_mode, row);
}

/* A one-sided link is a contact; in tension its ends are swapped. */
static struct thud_contact_input link_contact(const struct thud_link_input *in)
{
    return (struct thud_contact_input){.left_floor = in->tension ? in->right_floor : in->left_floor,
                                       .right_floor = in->tension ? in->left_floor : in->right_floor,
                                       .left_structure = in->tension ? in->right_structure : in->left_structure,
                                       .right_structure = in->tension ? in->left_structure : in->right_structure,
                                       .clearance_m = in->clearance_m,
                                       .law = in->law,
                                       .setup = in->setup};
}

static enum thud_status fill_links(struct thud_model *m, struct thud_arena *arena, const struct thud_model_input *input,
                                   struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    int contact = m->npairs;
    for (int i = 0; i < m->nlinks && status == THUD_OK; i++) {
        const struct thud_link_input *in = &input->link[i];
        struct thud_model_link *to = &m->link[i];
        const struct thud_contact_input one_sided = link_contact(in);
        *to = (struct thud_model_link){.left_dof = contact_dof(m, in->left_structure, in->left_floor),
                                       .right_dof = contact_dof(m, in->right_structure, in->right_floor),
                                       .contact = in->law ? contact : -1,
                                       .sign = in->tension ? -1 : 1,
                                       .stiffness_npm = in->stiffness_npm,
                                       .damping_nspm = in->damping_nspm,
                                       .storey = -1};
        fill_link_row(m, arena, to);
        if (in->law)
            status = fill_contact(m, arena, contact++, &one_sided, err);
    }
    return status;
}

/* Largest shape and drift of each mode over all floors that it moves, by which bounds are made. */
static void fill_mode_bounds(struct thud_model *m)
{
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *p = &m->structure[s];
        double *most = m->mode_max + p->first_mode, *drift = most + m->nmodes;
        for (int i = 0; i < p->dofs; i++)
            for (int j = 0; j < p->modes; j++) {
                most[j] = fmax(most[j], fabs(p->phi[i * p->modes + j]));
                drift[j] = fmax(drift[j], fabs(thud_model_drift(p, p->phi + j, p->modes, i)));
            }
    }
}

/* Where links tie structures, the common modes in place of their own. */
static enum thud_status tie_structures(struct thud_model *m, struct thud_arena *arena,
                                       const struct thud_model_input *input, const bool *tied, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < m->nsystems && status == THUD_OK; i++)
        if (tied[m->system[i]])
            status = thud_tie_system(m, arena, input, i, err);
    for (int s = 0, shapes = 0; s < m->nstructures && status == THUD_OK; shapes += m->structure[s++].modes) {
        m->structure[s].first_shape = shapes;
        m->nshapes = shapes + m->structure[s].modes;
        m->couples = m->couples || m->structure[s].damping;
        m->fastest_radps = fmax(m->fastest_radps, thud_model_fastest(m, s));
    }
    return status;
}

/* Adds what a link that always acts holds at one of its ends: side 1 the left one, -1 the right one. */
static void add_held(const struct thud_model_structure *p, const struct thud_model_link *link, int dof, int side,
                     double *row, double *rate)
{
    if (link->contact >= 0 || dof < p->first || dof >= p->first + p->n)
        return;
    const double arm = side * p->level_m[dof - p->first];
    for (int j = 0; j < p->modes; j++) {
        row[j] += arm * link->stiffness_npm * link->row[j];
        rate[j] += arm * link->damping_nspm * link->row[j];
    }
}

static void fill_moment(struct thud_model *m, struct thud_arena *arena, struct thud_model_structure *to,
                        const struct thud_structure_input *in)
{
    const int modes = to->modes;
    double *level = thud_arena_take(arena, (size_t)to->n + 2 * (size_t)modes, sizeof *level), *row = level + to->n,
           *rate = row + modes;
    memcpy(level, in->level_m, (size_t)to->n * sizeof *level);
    for (int j = 0; j < modes; j++) {
        double carried = 0; /* W */
        for (int i = 0; i < to->n; i++)
            carried += level[i] * in->mass_kg[i] * to->phi[i * modes + j];
        row[j] = -carried * m->spring[to->first_mode + j];
        for (int k = 0; k < modes; k++)
            rate[k] -= carried * (to->damping ? to->damping[j * modes + k]
                                  : k == j    ? m->dashpot[to->first_mode + j]
                                              : 0);
    }
    to->level_m = level;
    to->moment = row;
    m->sums = true;
    for (int l = 0; l < m->nlinks; l++) {
        add_held(to, &m->link[l], m->link[l].left_dof, 1, row, rate);
        add_held(to, &m->link[l], m->link[l].right_dof, -1, row, rate);
    }
}

/* Those that a caller gives, and those of what is in the model. */
static unsigned traits_of(const struct thud_model *m, const struct thud_model_input *input)
{
    struct thud_element_sum sum = {.traits = input->traits};
    thud_element_add(&sum, THUD_ELEMENT_YIELDING_STOREY, m->nstoreys - m->nslips);
    thud_element_add(&sum, THUD_ELEMENT_FRICTION, m->nslips);
    thud_element_add(&sum, THUD_ELEMENT_STRUT, m->ncontacts - m->npairs);
    thud_element_add(&sum, THUD_ELEMENT_P_DELTA, m->collapses);
    return sum.traits;
}

static enum thud_status fill(struct thud_model *m, struct thud_arena *arena, const struct thud_model_input *input,
                             const bool *tied, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int s = 0; s < input->nstructures && status == THUD_OK; s++)
        status = fill_structure(m, arena, s, &input->structure[s], err);
    if (status == THUD_OK)
        status = tie_structures(m, arena, input, tied, err);
    if (status == THUD_OK)
        fill_mode_bounds(m);
    for (int s = 0; s < input->nstructures && status == THUD_OK; s++) {
        struct thud_model_structure *to = &m->structure[s];
        if (to->rise || to->collapse_m)
            fill_leans(m, arena, to);
        if (to->matrix_npm)
            fill_shears(m, arena, to);
    }
    for (int c = 0; c < input->ncontacts && status == THUD_OK; c++)
        status = fill_contact(m, arena, c, &input->contact[c], err);
    if (status == THUD_OK)
        status = fill_links(m, arena, input, err);
    if (status != THUD_OK)
        return status;
    for (int s = 0; s < input->nstructures; s++)
        if (input->structure[s].level_m)
            fill_moment(m, arena, &m->structure[s], &input->structure[s]);
    fill_storeys(m, arena, input);
    fill_delassus(m);
    m->traits = traits_of(m, input);
    return THUD_OK;
}

enum thud_status thud_model_create(const struct thud_model_input *input, struct thud_model **out,
                                   struct thud_error *err)
{
    struct thud_arena arena = {0};
    int *system;
    bool *tied;
    *out = NULL;
    enum thud_status status =
        THUD_LAY(err, THUD_PIECE(system, input->nstructures), THUD_PIECE(tied, input->nstructures));
    if (status != THUD_OK)
        return status;
    thud_tie_systems(input, system, tied);
    struct thud_model *m = lay_out(input, system, tied, &arena);
    status = m ? fill(m, &arena, input, tied, err) : thud_error_set(err, THUD_MEMORY, "out of memory");
    free(system);
    if (status != THUD_OK)
        free(m);
    else
        *out = m;
    return status;
}

double thud_model_mass_of_system(const struct thud_model *model, int structure)
{
    double total = 0;
    for (int k = 0; k < model->nstructures; k++) {
        const struct thud_model_structure *p = &model->structure[k];
        for (int i = 0; p->system == model->structure[structure].system && i < p->n + (p->rise ? 1 : 0); i++)
            total += model->mass_kg[p->first + i];
    }
    return total;
}

void thud_model_free(struct thud_model *model)
{
    free(model);
}

int thud_model_yielding(const struct thud_model *model, int dof)
{
    for (int i = 0; i < model->nstoreys - model->nslips; i++)
        if (model->structure[model->storey[i].structure].first + model->storey[i].floor == dof)
            return i;
    return -1;
}

double thud_model_floor(const struct thud_model *model, int dof, const double *modal)
{
    const struct thud_model_structure *s = &model->structure[model->dof_structure[dof]];
    return thud_dot(s->modes, s->phi + (dof - s->first) * s->modes, modal + s->first_mode);
}

void thud_model_sides(const struct thud_model *model, int c, const double *modal, double *left, double *right)
{
    const struct thud_model_contact *p = &model->contact[c];
    *left = thud_dot(p->left.modes, p->left.row, modal + p->left.first_mode);
    *right = thud_dot(p->right.modes, p->right.row, modal + p->right.first_mode);
}

/* Relative motion of contact c by so many rows of modal values that stand `apart`, at most two, out (count). The sums of
 * its sides are made apart, so that neighbours moving alike have exactly none. */
static inline void gap_sums(const struct thud_model *model, int c, const double *modal, int apart, const int count,
                            double *out)
{
    const struct thud_model_side *l = &model->contact[c].left, *r = &model->contact[c].right;
    thud_vec2 left[2] = {0}, right[2] = {0};
    thud_add_dots(l->modes, l->row, modal + l->first_mode, apart, count, left);
    thud_add_dots(r->modes, r->row, modal + r->first_mode, apart, count, right);
    for (int i = 0; i < count; i++)
        out[i] = thud_vec2_sum(left[i]) - thud_vec2_sum(right[i]);
}

double thud_model_gap_sum(const struct thud_model *model, int c, const double *modal)
{
    double sum;
    gap_sums(model, c, modal, 0, 1, &sum);
    return sum;
}

void thud_model_gap_pair(const struct thud_model *model, int c, const double *modal, int apart, double *out)
{
    gap_sums(model, c, modal, apart, 2, out);
}

double thud_model_link(const struct thud_model *model, int link, const double *modal)
{
    const struct thud_model_link *p = &model->link[link];
    return thud_dot(p->modes, p->row, modal + p->first_mode);
}

double thud_model_contact_period(const struct thud_model_contact *p)
{
    double v = 1, energy = 0.5 * p->setup.mass_kg * v * v, low = 0, high = 1e-9;
    const struct thud_law_memory untouched = {0};
    if (!p->law->elastic_energy)
        return INFINITY;
    while (high < 1e3 && thud_law_energy(p->law, &p->setup, &untouched, THUD_APPROACH, high) < energy)
        high *= 2;
    for (int i = 0; i < 60; i++) {
        double d = 0.5 * (low + high);
        if (thud_law_energy(p->law, &p->setup, &untouched, THUD_APPROACH, d) < energy)
            low = d;
        else
            high = d;
    }
    return 2 * THUD_PI * high / v;
}
