#include "core/model.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/modes.h"
#include "core/pair.h"
#include "core/run_private.h"

/* Hands out pieces of one block. */
struct arena {
    char *next;
};

static void *take(struct arena *arena, size_t bytes)
{
    void *p = arena->next;
    arena->next += (bytes + 15) / 16 * 16;
    return p;
}

static size_t room(size_t count, size_t size)
{
    return (count * size + 15) / 16 * 16;
}

static size_t model_bytes(const struct thud_model_input *in, size_t ndof)
{
    size_t nc = (size_t)in->ncontacts, bytes = room(1, sizeof(struct thud_model));
    bytes += room((size_t)in->nstructures, sizeof(struct thud_model_structure));
    bytes += room(nc, sizeof(struct thud_model_contact)) + room(ndof, sizeof(int));
    bytes += 9 * room(ndof, sizeof(double)) + room(nc * ndof, sizeof(double)) + room(nc * nc, sizeof(double));
    for (int s = 0; s < in->nstructures; s++) {
        size_t n = (size_t)in->structure[s].n;
        bytes += 2 * room(n * n, sizeof(double)) + room(n, sizeof(double));
    }
    return bytes;
}

/* Modes that stay of n where `modes` are asked for. */
static int kept_of(int n, int modes)
{
    return modes > 0 && modes < n ? modes : n;
}

static enum thud_status fill_shear(struct thud_model *m, struct arena *arena, struct thud_model_structure *to,
                                   const struct thud_structure_input *in, int modes, struct thud_error *err)
{
    size_t n = (size_t)in->n;
    double *phi = take(arena, n * n * sizeof(double)), *k = take(arena, n * sizeof(double));
    memcpy(k, in->stiffness_npm, n * sizeof(double));
    to->phi = phi;
    to->stiffness_npm = k;
    double *work = malloc((4 * n + n * n) * sizeof *work);
    if (!work)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = thud_modes_shear(in->n, in->mass_kg, k, m->omega + to->first, phi, work, err);
    free(work);
    if (status == THUD_OK && in->isolated && (in->damping > 0 || in->isolation_damping > 0)) {
        double *damping = take(arena, n * n * sizeof(double));
        to->damping = damping;
        status =
            thud_modes_isolated_damping(in->n, in->mass_kg, k, in->damping, in->isolation_damping, phi, damping, err);
        int kept = kept_of(in->n, modes);
        for (int i = 0; i < in->n; i++) /* a mode that is left out slows no other */
            for (int j = i < kept ? kept : 0; j < in->n; j++)
                damping[i * in->n + j] = 0;
    }
    return status;
}

static void fill_rigid(struct thud_model *m, struct arena *arena, struct thud_model_structure *to,
                       const struct thud_structure_input *in)
{
    assert(in->n <= 1);
    if (in->n == 0)
        return;
    double *phi = take(arena, sizeof(double));
    phi[0] = 1 / sqrt(in->mass_kg[0]);
    to->phi = phi;
    m->omega[to->first] = 0;
}

static enum thud_status fill_structure(struct thud_model *m, struct arena *arena, int s,
                                       const struct thud_structure_input *in, int first, int modes,
                                       struct thud_error *err)
{
    struct thud_model_structure *to = &m->structure[s];
    *to = (struct thud_model_structure){.first = first, .n = in->n};
    for (int i = 0; i < in->n; i++) {
        m->mass_kg[first + i] = in->mass_kg[i];
        m->dof_structure[first + i] = s;
    }
    enum thud_status status = THUD_OK;
    if (in->stiffness_npm && in->n > 0)
        status = fill_shear(m, arena, to, in, modes, err);
    else
        fill_rigid(m, arena, to, in);
    for (int j = 0; j < in->n && status == THUD_OK; j++) {
        double gamma = 0;
        for (int i = 0; i < in->n; i++)
            gamma += to->phi[i * in->n + j] * in->mass_kg[i];
        m->gamma[first + j] = gamma;
        m->zeta[first + j] = to->damping ? 0 : in->damping;
        m->couples = m->couples || to->damping;
        m->q0[first + j] = 0;
        m->spring[first + j] = m->omega[first + j] * m->omega[first + j];
        m->dashpot[first + j] = 2 * m->zeta[first + j] * m->omega[first + j];
        m->qd0[first + j] = gamma * in->velocity_mps; /* Phi^T M v */
    }
    return status;
}

/* The highest modes are not driven; floors follow the ground only as far as the others carry them. */
static void leave_out(struct thud_model *m, const struct thud_model_structure *s, int modes)
{
    int kept = kept_of(s->n, modes);
    for (int i = 0; i < s->n; i++) {
        m->share[s->first + i] = kept < s->n ? 0 : 1;
        for (int j = 0; j < kept && kept < s->n; j++)
            m->share[s->first + i] += s->phi[i * s->n + j] * m->gamma[s->first + j];
    }
    for (int j = kept; j < s->n; j++)
        m->gamma[s->first + j] = m->qd0[s->first + j] = 0;
    m->left_out += s->n - kept;
}

/* 1/m of one side, 0 for a wall. */
static double inverse_mass(const struct thud_model *m, int dof)
{
    return dof < 0 ? 0 : 1 / m->mass_kg[dof];
}

static int contact_dof(const struct thud_model *m, int structure, int floor)
{
    return floor == 0 ? -1 : m->structure[structure].first + floor - 1;
}

static void add_row(const struct thud_model *m, int dof, double sign, int modes, double *g)
{
    if (dof < 0)
        return;
    const struct thud_model_structure *s = &m->structure[m->dof_structure[dof]];
    const double *row = s->phi + (dof - s->first) * s->n;
    for (int j = 0; j < kept_of(s->n, modes); j++)
        g[s->first + j] += sign * row[j];
}

static enum thud_status fill_contact(struct thud_model *m, int c, const struct thud_contact_input *in, int modes,
                                     struct thud_error *err)
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
    double inverse = inverse_mass(m, to->left_dof) + inverse_mass(m, to->right_dof);
    assert(inverse > 0);
    to->setup.mass_kg = 1 / inverse;
    double *g = m->g + (size_t)c * (size_t)m->ndof;
    memset(g, 0, (size_t)m->ndof * sizeof *g);
    add_row(m, to->left_dof, 1, modes, g);
    add_row(m, to->right_dof, -1, modes, g);
    return in->law->prepare ? in->law->prepare(&to->setup, err) : THUD_OK;
}

static void fill_w(struct thud_model *m)
{
    for (int a = 0; a < m->ncontacts; a++)
        for (int b = 0; b < m->ncontacts; b++) {
            double sum = 0;
            for (int j = 0; j < m->ndof; j++)
                sum += m->g[a * m->ndof + j] * m->g[b * m->ndof + j];
            m->w[a * m->ncontacts + b] = sum;
        }
}

enum thud_status thud_model_create(const struct thud_model_input *input, struct thud_model **out,
                                   struct thud_error *err)
{
    *out = NULL;
    int ndof = 0;
    for (int s = 0; s < input->nstructures; s++)
        ndof += input->structure[s].n;
    size_t n = (size_t)ndof, nc = (size_t)input->ncontacts;
    struct arena arena = {calloc(1, model_bytes(input, n))};
    struct thud_model *m = take(&arena, 0);
    if (!m)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    take(&arena, sizeof *m);
    m->nstructures = input->nstructures;
    m->ndof = ndof;
    m->ncontacts = input->ncontacts;
    m->structure = take(&arena, (size_t)input->nstructures * sizeof *m->structure);
    m->contact = take(&arena, nc * sizeof *m->contact);
    m->dof_structure = take(&arena, n * sizeof(int));
    double **vectors[] = {&m->mass_kg, &m->omega, &m->zeta, &m->gamma, &m->spring,
                          &m->dashpot, &m->q0,    &m->qd0,  &m->share};
    for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++)
        *vectors[i] = take(&arena, n * sizeof(double));
    m->g = take(&arena, nc * n * sizeof(double));
    m->w = take(&arena, nc * nc * sizeof(double));

    enum thud_status status = THUD_OK;
    for (int s = 0, first = 0; s < input->nstructures && status == THUD_OK; first += input->structure[s].n, s++)
        status = fill_structure(m, &arena, s, &input->structure[s], first, input->modes, err);
    for (int s = 0; s < input->nstructures && status == THUD_OK; s++)
        leave_out(m, &m->structure[s], input->modes);
    for (int c = 0; c < input->ncontacts && status == THUD_OK; c++)
        status = fill_contact(m, c, &input->contact[c], input->modes, err);
    if (status != THUD_OK) {
        free(m);
        return status;
    }
    fill_w(m);
    *out = m;
    return THUD_OK;
}

void thud_model_free(struct thud_model *model)
{
    free(model);
}

/* A floor's value from modal values: one dot product over its structure's modes. */
double thud_model_floor(const struct thud_model *model, int dof, const double *modal)
{
    const struct thud_model_structure *s = &model->structure[model->dof_structure[dof]];
    return thud_dot(s->n, s->phi + (dof - s->first) * s->n, modal + s->first);
}

/* The two sums are made apart, so that neighbours moving alike have exactly no relative motion. */
double thud_model_gap_sum(const struct thud_model *model, int c, const double *modal)
{
    const struct thud_model_contact *p = &model->contact[c];
    double left = p->left_dof < 0 ? 0 : thud_model_floor(model, p->left_dof, modal);
    double right = p->right_dof < 0 ? 0 : thud_model_floor(model, p->right_dof, modal);
    return left - right;
}
