/* What OpenSees 3.7 has, by its sources (SRC/material/uniaxial): each is a spring that acts while its strain
 * u_right - u_left is below -gap.
 *     ViscoelasticGap K C gap           F = K d + C v                            linear, kelvin-voigt
 *     Hertzdamp K x gap n               F = (K + x K v/v_imp) d^n                hertz, hertz-damp
 *     JankowskiImpact K xi m gap n      F = K d^n + 2 xi sqrt(K d^(n-1) m) v     jankowski (approach; then K d^n)
 *     ImpactMaterial K1 K2 -d_y -gap    bilinear flag                            impact-material
 *     Steel01 V_y k r                   bilinear, kinematic hardening            storeys that yield, V_y = k d_y
 *     Elastic -W/h                      beside the storey's spring               P-Delta, as a leaning column's
 *     HyperbolicGapMaterial K_max K_max R_f -F_ult -gap                          backfill
 *     Elastic K; Elastic 0 C            between i and j, K = -K_ij, C = -C_ij    buildings by a matrix; damping above
 *                                                                                isolators; buildings on soil
 * A struck place of columns and the place under a storey on soil are no floors. Each is a node without mass that stiff
 * springs hold to u = sum w_i u_i. They are the springs of the matrix K w w^T with w = (1, -w_i).
 * No contact separates when the force reaches 0 while there is indentation, none has the rubber's two curves, and a
 * step has no impulse. The constants are read from the law's own branch. */
#include "io/result/opensees.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/version.h"
#include "io/file/json.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"

/* Hertzdamp and JankowskiImpact take no gap of 0, m. */
static const double least_gap_m = 1e-12;
/* Steps to what thud_model_contact_period gives, four times what it takes from touch to the turn. */
static const double steps_per_contact = 500, steps_per_period = 200;

static enum thud_status refuse(struct thud_error *err, const char *key, const char *what, const char *instead)
{
    return thud_error_refuse(err, THUD_INPUT, key, instead, "OpenSees %s", what);
}

static bool is_law(const struct thud_model_contact *c, const char *name)
{
    return strcmp(c->law->name, name) == 0;
}

static bool has_contact(const struct thud_model_contact *c)
{
    return !(c->law->flags & THUD_LAW_NO_FORCE);
}

bool thud_opensees_has_law(const struct thud_law *law)
{
    static const char *const known[] = {"none",       "linear",    "kelvin-voigt",   "hertz",
                                        "hertz-damp", "jankowski", "impact-material"};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strcmp(law->name, known[i]) == 0)
            return true;
    return false;
}

static enum thud_status check_contact(const struct thud_model_contact *c, struct thud_error *err)
{
    char key[64], allowed[120] = "none, linear, kelvin-voigt, hertz, hertz-damp, jankowski, impact-material";
    const bool bumper = is_law(c, "rubber");
    if (c->struck != 0) {
        snprintf(key, sizeof key, "interfaces.%d", c->interface);
        return refuse(err, key,
                      "has springs between two nodes, and a slab that strikes columns pushes the floors above and "
                      "below by shares",
                      "floors at the same elevations (heights, base), or levels: aligned");
    }
    if (thud_opensees_has_law(c->law))
        return THUD_OK;
    snprintf(key, sizeof key, "interfaces.%d.%s.law", c->interface, bumper ? "bumper" : "contact");
    if (bumper)
        snprintf(allowed, sizeof allowed, "--case none, --set interfaces.%d.contact.law=kelvin-voigt", c->interface);
    return refuse(err, key,
                  bumper ? "has no material whose curves of approach and restitution differ as the rubber's do"
                  : c->law->flags & THUD_LAW_IMPULSIVE ? "knows no impulse: its time steps need a force"
                  : is_law(c, "kelvin-voigt-no-tension")
                      ? "has no linear dashpot that separates when the force reaches 0 (its ViscoelasticGap pulls on)"
                      : "has no such law",
                  allowed);
}

enum thud_status thud_opensees_check(const struct thud_scene *scene, const struct thud_model *model,
                                     struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    char key[64];
    for (int s = 0; s < scene->nstructures; s++) {
        snprintf(key, sizeof key, "structures.%d.foundation", s + 1);
        if (thud_structure_on_soil(&scene->structure[s]))
            return refuse(err, key,
                          "has modal damping of whole models alone, not of the building above a damped foundation",
                          "buildings on rigid ground");
    }
    if (model->left_out > 0)
        return refuse(err, "analysis.modes", "integrates every mode", "all modes");
    for (int c = 0; c < model->npairs && status == THUD_OK; c++)
        status = check_contact(&model->contact[c], err);
    return status;
}

/* "NAME = [a, b, ...]", broken into lines. */
static void list(struct thud_text *out, const char *name, const double *value, size_t n)
{
    enum { TO_A_LINE = 8 };
    thud_text_append(out, "%s = [", name);
    for (size_t i = 0; i < n; i++) {
        thud_text_append(out, "%s", i == 0 ? "" : i % TO_A_LINE ? ", " : ",\n    ");
        thud_text_number(out, value[i]);
    }
    thud_text_append(out, "]\n");
}

static void head(struct thud_text *out, const struct thud_scene *scene, const struct thud_model *model,
                 const struct thud_record *record, const struct thud_result *result)
{
    double step_s = INFINITY;
    for (int m = 0; m < model->nmodes; m++)
        if (model->omega[m] > 0)
            step_s = fmin(step_s, 2 * THUD_PI / model->omega[m] / steps_per_period);
    for (int c = 0; c < model->ncontacts; c++)
        if (has_contact(&model->contact[c]))
            step_s = fmin(step_s, thud_model_contact_period(&model->contact[c]) / steps_per_contact);
    double part = record ? record->dt_s : result->end_s;
    thud_text_append(out, "# A scene of thud %s for OpenSeesPy: python3 THIS_FILE [STEP]\n", THUD_VERSION);
    thud_text_append(
        out,
        "# SI units: m, s, kg, N. Displacements are relative to the ground, positive to the right.\n"
        "import os\nimport sys\nimport tempfile\n\nDIFFERS, DIVERGED, MISSING = %d, %d, %d  # exit status\n"
        "try:\n    import openseespy.opensees as ops\nexcept Exception as problem:\n"
        "    print(\"OpenSeesPy cannot be loaded:\", problem, file=sys.stderr)\n    sys.exit(MISSING)\n"
        "ops.logFile(os.devnull, \"-noEcho\")\n\nTITLE = ",
        THUD_OPENSEES_DIFFERS, THUD_OPENSEES_DIVERGED, THUD_OPENSEES_MISSING);
    thud_json_string(out, scene->title[0] ? scene->title : scene->name);
    thud_text_append(out, "\nEND = ");
    thud_text_number(out, result->end_s);
    thud_text_append(out, "  # s\nSTEP = float(sys.argv[1]) if len(sys.argv) > 1 else ");
    thud_text_number(out, part / ceil(part / step_s));
    thud_text_append(out, "  # s\n");
    if (record) {
        thud_text_append(out, "\n# ground acceleration, m/s2, every DT seconds: ");
        thud_json_string(out, record->file);
        thud_text_append(out, "\nDT = ");
        thud_text_number(out, record->dt_s);
        thud_text_append(out, "\n");
        list(out, "GROUND", record->a_mps2, record->samples);
    }
}

/* Nodes: a floor's is its number from 1 over all structures, a structure's ground is 1001, 1002, ... A weight's element
 * has the number of the floor above it and 100000. */
enum { GROUND = 1000, WEIGHT = 100000 };
/* The springs of matrices are numbered from here on, and the nodes that are no floors: two a row of the model. */
enum { SPRINGS = 200001, PLACES = 300001 };
/* Of a matrix's element over its diagonal; and of the springs that hold a place, over that of what acts on it. */
static const double rounding = 1e-12, stiff = 1e5;

/* A material by its numbers, and the element of it between two nodes, both of one number. */
static void element(struct thud_text *out, const char *material, int tag, const double *value, int n, int from, int to)
{
    thud_text_append(out, "ops.uniaxialMaterial(\"%s\", %d", material, tag);
    for (int i = 0; i < n; i++) {
        thud_text_append(out, ", ");
        thud_text_number(out, value[i]);
    }
    thud_text_append(out, ")\nops.element(\"zeroLength\", %d, %d, %d, \"-mat\", %d, \"-dir\", 1)\n", tag, from, to,
                     tag);
}

/* A storey's spring, with the number of the floor above it; `storey`: it yields. */
static void spring(struct thud_text *out, double stiffness_npm, const struct thud_model_storey *storey, int node,
                   int below)
{
    if (storey)
        element(out, "Steel01", node, (double[]){stiffness_npm * storey->yield_m, stiffness_npm, storey->hardening}, 3,
                below, node);
    else
        element(out, "Elastic", node, &stiffness_npm, 1, below, node);
}

/* P-Delta: a leaning column of so much weight on a storey of so much height, beside its spring. */
static void weight(struct thud_text *out, double geometric_npm, int node, int below)
{
    thud_text_append(out, "# P-Delta: -W/h\n");
    element(out, "Elastic", WEIGHT + node, &(double){-geometric_npm}, 1, below, node);
}

/* A matrix (n x n) of stiffness or damping as springs or dashpots: -K_ij between nodes i and j, the sum of row i to the
 * ground. Values up to `least` times the diagonal of row i are left out. */
static void springs(struct thud_text *out, int n, const int *node, const double *matrix, bool dashpots, double least,
                    int ground, int *tag)
{
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int j = 0; j < n; j++)
            sum += matrix[i * n + j];
        for (int j = -1; j < i; j++) {
            const double k = j < 0 ? sum : -matrix[i * n + j];
            if (fabs(k) <= least * matrix[i * n + i])
                continue;
            element(out, "Elastic", (*tag)++, dashpots ? (double[]){0, k} : &k, 1 + dashpots, j < 0 ? ground : node[j],
                    node[i]);
        }
    }
}

static bool is_floor(const struct thud_model_side *side)
{
    return side->tilt < 0 && side->share == 1;
}

/* The node of one side of a row: a floor's, the ground's, or one of its own. */
static int node_of(const struct thud_model *model, int row, bool right)
{
    const struct thud_model_contact *c = &model->contact[row];
    const struct thud_model_side *side = right ? &c->right : &c->left;
    return !is_floor(side)  ? PLACES + 2 * row + right
           : side->dof >= 0 ? side->dof + 1
                            : GROUND + c->interface + (right ? 1 : 0);
}

/* The node of a side that is no floor, held by springs of this stiffness. */
static void place(struct thud_text *out, const struct thud_model *model, int row, bool right, double stiffness_npm,
                  int *tag)
{
    const struct thud_model_side *side = right ? &model->contact[row].right : &model->contact[row].left;
    const int of[] = {side->dof, side->below, side->tilt};
    const double part[] = {side->share, 1 - side->share, side->by_tilt};
    int node[4] = {node_of(model, row, right)}, n = 1;
    double w[4] = {1}, matrix[16];
    for (int i = 0; i < 3; i++)
        if (of[i] >= 0 && part[i] != 0) {
            node[n] = of[i] + 1;
            w[n++] = -part[i];
        }
    for (int i = 0; i < n * n; i++)
        matrix[i] = stiffness_npm * w[i / n] * w[i % n];
    thud_text_append(out, "ops.node(%d, 0.0)\n", node[0]);
    springs(out, n, node, matrix, false, rounding, GROUND + side->structure + 1, tag);
}

/* out (n x n) = M Phi X Phi^T M of modal X, all modes; work of the same size. */
static void physical(const struct thud_model *model, const double *modal, double *work, double *out)
{
    const struct thud_model_structure *m = &model->structure[0];
    const int n = m->dofs;
    memset(work, 0, (size_t)n * (size_t)n * sizeof *work);
    memset(out, 0, (size_t)n * (size_t)n * sizeof *out);
    for (int a = 0; a < n; a++)
        for (int b = 0; b < n; b++)
            for (int j = 0; j < n; j++)
                work[a * n + j] += modal[a * n + b] * m->phi[j * n + b] * model->mass_kg[j];
    for (int i = 0; i < n; i++)
        for (int a = 0; a < n; a++)
            for (int j = 0; j < n; j++)
                out[i * n + j] += model->mass_kg[i] * m->phi[i * n + a] * work[a * n + j];
}

/* The stiffness of a building on soil, less that of its storeys that yield, which have springs of their own. */
static void soil_springs(struct thud_text *out, const struct thud_model *model, int s, const struct thud_model *alone,
                         double *modal, double *work, double *k, const int *node, int *tag)
{
    const struct thud_model_structure *m = &model->structure[s];
    const int n = m->dofs;
    memset(modal, 0, (size_t)n * (size_t)n * sizeof *modal);
    for (int j = 0; j < n; j++)
        modal[j * n + j] = m->omega[j] * m->omega[j];
    physical(alone, modal, work, k);
    for (int i = 0; i < model->nstoreys; i++) {
        const struct thud_model_storey *storey = &model->storey[i];
        if (storey->link >= 0 || storey->structure != s)
            continue;
        const int row = model->ncontacts + i, above = storey->floor, below = above > 0 ? above - 1 : m->n;
        const int of[] = {above, below, m->n + 1};
        const double w[] = {1, -1, -m->rise[above]};
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                k[of[a] * n + of[b]] -= storey->stiffness_npm * w[a] * w[b];
        place(out, model, row, true, stiff * storey->stiffness_npm, tag);
        spring(out, storey->stiffness_npm, storey, m->first + above + 1, node_of(model, row, true));
    }
    springs(out, n, node, k, false, rounding, GROUND + s + 1, tag);
}

/* Damping as dashpots between floors: of an isolated building its own above the slab and that of its isolators, of a
 * building on soil all of it. A building on soil has its stiffness as springs too. */
static void matrices(struct thud_text *out, const struct thud_scene *scene, const struct thud_model *model, int s,
                     int *tag)
{
    const struct thud_model_structure *m = &model->structure[s];
    const size_t n = (size_t)m->dofs;
    struct thud_model *alone = NULL; /* links of the scene would have a part in the modes */
    struct thud_scene *one = malloc(sizeof *one);
    double *modal = malloc(3 * n * n * sizeof *modal), *work = modal + n * n, *matrix = work + n * n;
    int node[THUD_STOREYS_MAX + 3];
    for (int i = 0; i < m->dofs; i++)
        node[i] = m->first + i + 1;
    if (one)
        *one = *scene;
    if (one) {
        one->structure[0] = scene->structure[s];
        one->nstructures = 1;
        one->nlinks = 0;
    }
    if (one && modal && thud_scene_assemble(one, &alone, NULL) == THUD_OK) {
        if (m->rise)
            soil_springs(out, model, s, alone, modal, work, matrix, node, tag);
        if (alone->structure[0].damping) {
            physical(alone, alone->structure[0].damping, work, matrix);
            springs(out, m->dofs, node, matrix, true, rounding, GROUND + s + 1, tag);
        }
    } else {
        out->failed = true;
    }
    thud_model_free(alone);
    free(modal);
    free(one);
}

/* The struck places of columns; what these give is in the contact's stiffness. */
static void places(struct thud_text *out, const struct thud_model *model, int *tag)
{
    for (int i = 0; i < model->npairs; i++) {
        const struct thud_model_contact *c = &model->contact[i];
        struct thud_law_memory memory = {0};
        if (c->struck == 0 || !has_contact(c))
            continue;
        const struct thud_branch b = thud_law_branch(c->law, &c->setup, &memory, THUD_APPROACH, false);
        thud_text_append(out, "# interface %d: columns under floor %d are struck\n", c->interface,
                         c->struck < 0 ? c->left_floor : c->right_floor);
        place(out, model, i, c->struck > 0, stiff * b.k_npm, tag);
    }
}

static void nodes(struct thud_text *out, const struct thud_scene *scene, const struct thud_model *model)
{
    int tag = SPRINGS;
    thud_text_append(out, "\nops.wipe()\nops.model(\"basic\", \"-ndm\", 1, \"-ndf\", 1)\n");
    for (int s = 0; s < model->nstructures; s++) {
        const struct thud_model_structure *m = &model->structure[s];
        thud_text_append(out, "\n# structure %d: ", s + 1);
        thud_json_string(out, scene->structure[s].name);
        thud_text_append(out, m->rise ? "; behind its floors sway and rotation (times its height) of its foundation\n"
                                      : "\n");
        if (m->n == 0 || m->drifts)
            thud_text_append(out, "ops.node(%d, 0.0)\nops.fix(%d, 1)\n", GROUND + s + 1, GROUND + s + 1);
        int node[THUD_STOREYS_MAX + 1];
        for (int i = 0; i < m->dofs; i++) {
            const int at = m->first + i + 1, below = i == 0 ? GROUND + s + 1 : at - 1,
                      yielding = i < m->n ? thud_model_yielding(model, m->first + i) : -1;
            thud_text_append(out, "ops.node(%d, 0.0)\nops.mass(%d, ", at, at);
            thud_text_number(out, model->mass_kg[m->first + i]);
            thud_text_append(out, ")\n");
            if (m->rise)
                continue;
            node[i] = at;
            if (m->stiffness_npm)
                spring(out, m->stiffness_npm[i], yielding < 0 ? NULL : &model->storey[yielding], at, below);
            if (m->geometric_npm)
                weight(out, m->geometric_npm[i], at, below);
        }
        if (m->matrix_npm && !m->rise)
            springs(out, m->n, node, m->matrix_npm, false, 0, GROUND + s + 1, &tag);
        if (m->rise || scene->structure[s].kind == THUD_ISOLATED)
            matrices(out, scene, model, s, &tag);
    }
    places(out, model, &tag);
}

/* Of every mode of a structure, beside what are dashpots. */
static double modal_damping(const struct thud_structure *of)
{
    return of->kind == THUD_ISOLATED || thud_structure_on_soil(of) ? 0
           : thud_wall_gives(of)                                   ? thud_wall_damping(of)
                                                                   : of->damping;
}

/* Modes of all structures, each on its own, lowest first, as OpenSees finds them before contacts and links. */
static void damping(struct thud_text *out, const struct thud_scene *scene, const struct thud_model *model)
{
    double above = -1;
    bool damped = false;
    for (int s = 0; s < model->nstructures; s++)
        damped = damped || (model->structure[s].n > 0 && modal_damping(&scene->structure[s]) > 0);
    if (!damped)
        return;
    thud_text_append(out,
                     "\n# damping ratio of every mode, the lowest frequency first\n"
                     "ops.eigen(\"-fullGenLapack\", %d)\nops.modalDamping(",
                     model->nmodes);
    for (int done = 0; done < model->nmodes;) {
        double next = INFINITY;
        for (int s = 0; s < model->nstructures; s++)
            for (int j = 0; j < model->structure[s].dofs; j++)
                if (model->structure[s].omega[j] > above)
                    next = fmin(next, model->structure[s].omega[j]);
        for (int s = 0; s < model->nstructures; s++)
            for (int j = 0; j < model->structure[s].dofs; j++)
                if (model->structure[s].omega[j] == next) {
                    thud_text_append(out, "%s", done++ > 0 ? ", " : "");
                    thud_text_number(out, next > 0 ? modal_damping(&scene->structure[s]) : 0);
                }
        above = next;
    }
    thud_text_append(out, ")\n");
}

static void contact(struct thud_text *out, const struct thud_model_contact *c, int tag, int from, int to)
{
    struct thud_law_memory memory = {0};
    thud_law_onset(c->law, &c->setup, 1, &memory);
    struct thud_branch b = thud_law_branch(c->law, &c->setup, &memory, THUD_APPROACH, false);
    double gap = -fmax(c->clearance_m, least_gap_m);
    double value[5];
    int n = 0;
    const char *name;
    if (is_law(c, "impact-material")) {
        name = "ImpactMaterial";
        value[n++] = b.k_npm;
        value[n++] = thud_law_branch(c->law, &c->setup, &memory, THUD_APPROACH, true).k_npm;
        value[n++] = -thud_law_ultimate(c->law, &c->setup, &memory, THUD_APPROACH);
        value[n++] = gap;
    } else if (c->law->flags & THUD_LAW_LINEAR) {
        name = "ViscoelasticGap";
        value[n++] = b.k_npm;
        value[n++] = b.c_nspm;
        value[n++] = gap;
    } else if (is_law(c, "jankowski")) {
        name = "JankowskiImpact";
        value[n++] = b.K;
        value[n++] = (b.D + b.c_nspm) / (2 * sqrt(b.K * c->setup.mass_kg));
        value[n++] = c->setup.mass_kg;
        value[n++] = gap;
        value[n++] = b.p;
    } else {
        name = "Hertzdamp";
        value[n++] = b.K;
        value[n++] = b.D / b.K; /* at a touch with 1 m/s */
        value[n++] = gap;
        value[n++] = b.p;
    }
    element(out, name, tag, value, n, from, to);
    thud_text_append(out, "CONTACTS.append(%d)\n", tag);
}

static void contacts(struct thud_text *out, const struct thud_model *model)
{
    thud_text_append(out, "\n# storeys that yield, by the floor above\nYIELDING = [");
    for (int i = 0; i < model->nstoreys - model->nslips; i++)
        thud_text_append(out, "%s%d", i > 0 ? ", " : "",
                         model->structure[model->storey[i].structure].first + model->storey[i].floor + 1);
    thud_text_append(out, "]\n\n# contacts, and behind them links\nCONTACTS = []\n");
    for (int i = 0; i < model->npairs; i++)
        if (has_contact(&model->contact[i]))
            contact(out, &model->contact[i], model->ndof + i + 1, node_of(model, i, false), node_of(model, i, true));
}

/* Springs and dashpots always act, friction up to its slip force. A restrainer holds past a gap that opens. A strut and
 * the soil behind a wall push past a gap that closes. */
static void link(struct thud_text *out, const struct thud_scene *scene, const struct thud_model *model, int i, int tag,
                 int from, int to)
{
    static const double strength_m = 1e3; /* what holds past a gap never yields */
    const struct thud_model_link *l = &model->link[i];
    if (l->storey >= 0) {
        element(out, "ElasticPP", tag, (double[]){l->stiffness_npm, model->storey[l->storey].yield_m}, 2, from, to);
    } else if (l->contact < 0) {
        element(out, "Elastic", tag, (double[]){l->stiffness_npm, l->damping_nspm}, 2, from, to);
    } else if (thud_link_wall(scene, i) >= 0) {
        const struct thud_structure *wall = &scene->structure[thud_link_wall(scene, i)];
        const double k = wall->backfill_stiffness_npm,
                     ratio = model->contact[l->contact].setup.value[thud_law_param(&thud_law_backfill, "ratio")];
        element(out, "HyperbolicGapMaterial", tag,
                (double[]){k, k, ratio, -wall->backfill_strength_n,
                           -fmax(model->contact[l->contact].clearance_m, least_gap_m)},
                5, from, to);
    } else {
        const struct thud_link *link = &scene->link[i];
        const int side = link->law == THUD_LINK_RESTRAINER ? 1 : -1;
        element(out, "ElasticPPGap", tag,
                (double[]){link->stiffness_npm, side * strength_m * link->stiffness_npm,
                           side * fmax(link->slack_m, least_gap_m)},
                3, from, to);
    }
    thud_text_append(out, "CONTACTS.append(%d)\n", tag);
}

static void links(struct thud_text *out, const struct thud_scene *scene, const struct thud_model *model)
{
    if (model->nlinks > 0)
        thud_text_append(out, "\n# links, and soil behind walls\n");
    for (int i = 0; i < model->nlinks; i++) {
        const struct thud_model_link *l = &model->link[i];
        const int tag = model->ndof + model->ncontacts + i + 1, wall = thud_link_wall(scene, i),
                  some = model->dof_structure[l->left_dof >= 0 ? l->left_dof : l->right_dof],
                  left = l->left_dof >= 0 ? l->left_dof + 1 : GROUND + some + (wall >= 0),
                  right = l->right_dof >= 0 ? l->right_dof + 1 : GROUND + some + 2 - (wall >= 0);
        link(out, scene, model, i, tag, left, right);
    }
}

/* A row of what the run gave: name, what OpenSees recorded, at which place, the value. */
static void peak(struct thud_text *out, const char *name, const char *quantity, int place, double value)
{
    thud_text_append(out, "    (");
    thud_json_string(out, name);
    thud_text_append(out, ", \"%s\", %d, ", quantity, place);
    thud_text_number(out, value);
    thud_text_append(out, "),\n");
}

static void expected(struct thud_text *out, const struct thud_scene *scene, const struct thud_model *model,
                     const struct thud_result *result)
{
    char name[2 * THUD_NAME_MAX + 32], level[24];
    int place = 0;
    thud_text_append(out, "\n# peaks by thud: name, quantity, place among the recorded, value\nEXPECTED = [\n");
    for (int s = 0; s < result->nstructures; s++)
        for (int i = 0; i < result->structure[s].floors; i++) {
            const struct thud_floor_result *f = &result->structure[s].floor[i];
            snprintf(name, sizeof name, "%s floor %d", scene->structure[s].name, i + 1);
            peak(out, name, "acceleration", model->structure[s].first + i, f->acceleration.value);
            peak(out, name, "displacement", model->structure[s].first + i, f->displacement.value);
        }
    for (int c = 0; c < result->ncontacts; c++) {
        const struct thud_contact_result *r = &result->contact[c];
        if (!has_contact(&model->contact[c]))
            continue;
        snprintf(name, sizeof name, "interface %d floors %d-%d", r->interface, r->left_floor, r->right_floor);
        peak(out, name, "force", place++, r->force.value);
    }
    for (int i = 0; i < result->nlinks; i++) {
        thud_link_name(scene, i, name, sizeof name);
        peak(out, name, "force", place++, result->link[i].force.value);
    }
    for (int i = 0; i < model->nstoreys - model->nslips; i++) {
        const struct thud_model_storey *storey = &model->storey[i];
        const struct thud_structure_result *r = &result->structure[storey->structure];
        const struct thud_structure *own = &scene->structure[storey->structure];
        snprintf(name, sizeof name, "%s %s", own->name, thud_structure_level_name(own, storey->floor, true, level));
        peak(out, name, "drift", i, r->floor[storey->floor].drift.value);
        peak(out, name, "shear", i, r->storey[storey->floor].shear.value);
    }
    thud_text_append(out, "]\n");
}

static const char analysis[] =
    "\n"
    "folder = tempfile.mkdtemp()\n"
    "path = {q: os.path.join(folder, q) for q in (\"acceleration\", \"displacement\", \"force\", \"drift\", "
    "\"shear\")}\n"
    "ops.recorder(\"EnvelopeNode\", \"-file\", path[\"acceleration\"], *TOTAL, \"-node\", *FLOORS, \"-dof\", 1, "
    "\"accel\")\n"
    "ops.recorder(\"EnvelopeNode\", \"-file\", path[\"displacement\"], \"-node\", *FLOORS, \"-dof\", 1, \"disp\")\n"
    "if CONTACTS:\n"
    "    ops.recorder(\"EnvelopeElement\", \"-file\", path[\"force\"], \"-ele\", *CONTACTS, \"material\", \"1\", "
    "\"stress\")\n"
    "if YIELDING:\n"
    "    for quantity, response in ((\"drift\", \"strain\"), (\"shear\", \"stress\")):\n"
    "        ops.recorder(\"EnvelopeElement\", \"-file\", path[quantity], \"-ele\", *YIELDING, \"material\", \"1\", "
    "response)\n"
    "ops.constraints(\"Plain\")\n"
    "ops.numberer(\"Plain\")\n"
    "ops.system(\"FullGeneral\")\n"
    "ops.test(\"NormUnbalance\", 1e-8 * WEIGHT, 100)\n"
    "ops.algorithm(\"Newton\")\n"
    "ops.integrator(\"Newmark\", 0.5, 0.25)\n"
    "ops.analysis(\"Transient\")\n"
    "if ops.analyze(int(round(END / STEP)), STEP) != 0:\n"
    "    print(\"no convergence: try a shorter step\", file=sys.stderr)\n"
    "    sys.exit(DIVERGED)\n"
    "ops.wipe()  # writes the envelopes\n"
    "peaks = {}\n"
    "for quantity, file in path.items():\n"
    "    if os.path.exists(file):\n"
    "        with open(file) as lines:\n"
    "            peaks[quantity] = [float(x) for x in lines.read().splitlines()[2].split()]\n"
    "        os.remove(file)\n"
    "os.rmdir(folder)\n"
    "print(TITLE)\n"
    "print(\"step %g s\" % STEP)\n"
    "print(\"%-28s %-13s %14s %14s %11s\" % (\"\", \"peak\", \"OpenSees\", \"thud\", \"difference\"))\n"
    "worst, acceleration = 0, 0\n"
    "for name, quantity, place, value in EXPECTED:\n"
    "    found = peaks[quantity][place]\n"
    "    difference = found / value - 1 if value else found\n"
    "    worst = max(worst, abs(difference))\n"
    "    if quantity == \"acceleration\":\n"
    "        acceleration = max(acceleration, abs(difference))\n"
    "    print(\"%-28s %-13s %14.7g %14.7g %+11.2e\" % (name, quantity, found, value, difference))\n"
    "print(\"largest difference %.2e, of an acceleration %.2e\" % (worst, acceleration))\n"
    "if acceleration > 0.01:\n"
    "    sys.exit(DIFFERS)\n";

/* The ground's motion does not push a rotation: a load against what it would. */
static void rotation_load(struct thud_text *out, const struct thud_model *model, int s)
{
    const int dof = model->structure[s].first + model->structure[s].n + 1;
    thud_text_append(out, "ops.pattern(\"Plain\", %d, 1)  # the ground does not push a rotation\nops.load(%d, ", s + 2,
                     dof + 1);
    thud_text_number(out, model->mass_kg[dof]);
    thud_text_append(out, ")\n");
}

void thud_opensees_script(const struct thud_scene *scene, const struct thud_model *model,
                          const struct thud_record *record, const struct thud_result *result, struct thud_text *out)
{
    double weight_n = 0;
    for (int i = 0; i < model->ndof; i++)
        weight_n += model->mass_kg[i] * THUD_GRAVITY;
    head(out, scene, model, record, result);
    nodes(out, scene, model);
    damping(out, scene, model);
    contacts(out, model);
    links(out, scene, model);
    thud_text_append(out, "\nFLOORS = list(range(1, %d))\nWEIGHT = ", model->ndof + 1);
    thud_text_number(out, weight_n);
    thud_text_append(out, "\n%s",
                     record ? "ops.timeSeries(\"Path\", 1, \"-dt\", DT, \"-values\", *GROUND, \"-factor\", 1.0)\n"
                              "ops.pattern(\"UniformExcitation\", 1, 1, \"-accel\", 1)\n"
                              "TOTAL = [\"-timeSeries\", 1]  # the ground's acceleration is added\n"
                            : "TOTAL = []\n");
    for (int s = 0; s < model->nstructures && record; s++)
        if (model->structure[s].rise)
            rotation_load(out, model, s);
    for (int s = 0; s < scene->nstructures; s++)
        if (scene->structure[s].kind == THUD_RIGID && scene->structure[s].velocity_mps != 0) {
            thud_text_append(out, "ops.setNodeVel(%d, 1, ", model->structure[s].first + 1);
            thud_text_number(out, scene->structure[s].velocity_mps);
            thud_text_append(out, ", \"-commit\")\n");
        }
    expected(out, scene, model, result);
    thud_text_append(out, "%s", analysis);
}
