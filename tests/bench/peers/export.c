/* A scene with linear contacts for integrators outside: matrices, record, contacts and the confirmed result, as JSON.
 * usage: export PRESET CASE KEY=VALUE... */
#include <stdio.h>

#include "../scene.h"

static void list(const char *name, const double *value, size_t n)
{
    printf("\"%s\": [", name);
    for (size_t i = 0; i < n; i++)
        printf("%s%.17g", i ? ", " : "", value[i]);
    printf("],\n");
}

/* M Phi diag(d) Phi^T M of a structure: its damping matrix for d = 2 zeta omega, its stiffness for d = omega^2. */
static double entry(const struct thud_model *m, const struct thud_model_structure *s, int i, int j, bool damping)
{
    double sum = 0;
    for (int k = 0; k < s->n; k++) {
        double w = m->omega[s->first + k], d = damping ? 2 * m->zeta[s->first + k] * w : w * w;
        sum += s->phi[i * s->n + k] * d * s->phi[j * s->n + k];
    }
    return m->mass_kg[s->first + i] * sum * m->mass_kg[s->first + j];
}

static void matrix(const struct thud_model *m, const char *name, bool damping)
{
    printf("\"%s\": [", name);
    for (int i = 0; i < m->ndof; i++) {
        printf("%s[", i ? ",\n" : "");
        for (int j = 0; j < m->ndof; j++) {
            int a = m->dof_structure[i], first = m->structure[a].first;
            bool same = a == m->dof_structure[j];
            printf("%s%.17g", j ? ", " : "", same ? entry(m, &m->structure[a], i - first, j - first, damping) : 0.0);
        }
        printf("]");
    }
    printf("],\n");
}

static void structures(const struct thud_model *m)
{
    printf("\"structures\": [");
    for (int s = 0; s < m->nstructures; s++) {
        const struct thud_model_structure *k = &m->structure[s];
        printf("%s{\"first\": %d, \"floors\": %d, \"damping\": %.17g, \"stiffness_npm\": [", s ? ", " : "", k->first,
               k->n, m->zeta[k->first]);
        for (int i = 0; i < k->n; i++)
            printf("%s%.17g", i ? ", " : "", k->stiffness_npm[i]);
        printf("]}");
    }
    printf("],\n");
}

static bool contacts(const struct thud_model *m)
{
    printf("\"contacts\": [");
    for (int c = 0; c < m->ncontacts; c++) {
        const struct thud_model_contact *k = &m->contact[c];
        struct thud_law_memory memory = {0};
        struct thud_branch b = k->law->branch(&k->setup, &memory, THUD_APPROACH, false);
        bool residual = k->law->keeps_residual && k->law->keeps_residual(&k->setup);
        if (!(k->law->flags & THUD_LAW_LINEAR) || k->law->flags & THUD_LAW_REVERSES || residual || b.f0_n != 0)
            return false;
        printf("%s{\"left\": %d, \"right\": %d, \"clearance_m\": %.17g, \"k_npm\": %.17g, \"c_nspm\": %.17g}",
               c ? ",\n" : "", k->left_dof, k->right_dof, k->clearance_m, b.k_npm, b.c_nspm);
    }
    printf("],\n");
    return true;
}

int main(int argc, char **argv)
{
    static struct bench_scene scene;
    static struct bench_solution reference, other;
    bench_scene_open(&scene, argc, argv);
    const struct thud_model *m = scene.model;
    double trust = bench_scene_reference(&scene, &reference, &other);
    printf("{\n\"trust\": %.3e, \"end_s\": %.17g, \"dt_s\": %.17g,\n", trust, reference.end_s, scene.record->dt_s);
    list("ground_mps2", scene.record->a_mps2, scene.record->samples);
    list("mass_kg", m->mass_kg, (size_t)m->ndof);
    matrix(m, "stiffness_npm", false);
    matrix(m, "damping_nspm", true);
    structures(m);
    if (!contacts(m)) {
        fprintf(stderr, "export: only for contacts that are linear and keep no residual\n");
        return 1;
    }
    list("acceleration_mps2", reference.acceleration_mps2, (size_t)m->ndof);
    printf("\"preset\": \"%s\"\n}\n", argc > 1 ? argv[1] : "towers");
    bench_scene_close(&scene);
    return 0;
}
