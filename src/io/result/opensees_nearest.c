/* The nearest scene whose contacts OpenSees has. A contact whose dashpot separates at zero force becomes one that pulls
 * until it opens (kelvin-voigt, same stiffness and restitution). A rubber bumper becomes a Kelvin-Voigt contact at the
 * same clearance. Its spring has the same force F and energy E at the largest compression d of the full scene's run:
 *
 *     E = integral of F over 0 .. d,   F^2/(2 K) = E,   so that K = F^2/(2 E);
 *
 * its restitution is the bumper's. Not to be used where forces well below the largest matter: the spring is linear. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "io/result/opensees.h"
#include "study/scene/level.h"
#include "study/scene/solution.h"

/* Of a contact that is never pressed, m; and of one whose law has no stiffness, that of the paper's concrete, N/m. */
static const double usual_depth_m = 0.01, usual_npm = 2.5e9;

/* By its approach curve, which stores what it takes. */
static double equivalent_stiffness(const struct thud_model_contact *c, double depth_m)
{
    const struct thud_law_memory untouched = {0};
    const double energy = thud_law_energy(c->law, &c->setup, &untouched, THUD_APPROACH, depth_m), step = 1e-4 * depth_m,
                 force =
                     (energy - thud_law_energy(c->law, &c->setup, &untouched, THUD_APPROACH, depth_m - step)) / step;
    return force * force / (2 * energy);
}

static enum thud_status set(struct thud_scene *scene, int interface, const char *key, const char *value,
                            struct thud_error *err)
{
    char path[64];
    snprintf(path, sizeof path, "interfaces.%d.contact.%s", interface, key);
    return thud_scene_set(scene, path, value, err);
}

/* Of a linear contact with the same force and energy; the columns that it strikes are in series with it. */
static double own_stiffness(const struct thud_model_contact *c, double depth_m)
{
    const double whole_npm = equivalent_stiffness(c, depth_m);
    return c->setup.column_npm > whole_npm ? whole_npm / (1 - whole_npm / c->setup.column_npm) : whole_npm;
}

/* Whether what an interface has can stay: a power of the indentation finds no balance with columns that give. */
static bool stays(const struct thud_law *law, const struct thud_model *model, int i)
{
    bool struck = false;
    for (int k = 0; k < model->npairs; k++)
        struck = struck || (model->contact[k].interface == i + 1 && model->contact[k].struck != 0);
    return !law || law->flags & THUD_LAW_NO_FORCE ||
           (thud_opensees_has_law(law) && (!struck || law->flags & THUD_LAW_LINEAR));
}

/* One clearance for each level, without bumpers. */
static void take_bumper_off(struct thud_interface *interface)
{
    struct thud_by_level *gap = &interface->gap;
    const int levels = gap->n > interface->thickness.n ? gap->n : interface->thickness.n;
    for (int l = 0; l < levels; l++) {
        const struct thud_level_values at = thud_interface_level(interface, l);
        gap->value_m[l] = thud_level_clearance(&at);
    }
    gap->n = levels;
    interface->thickness.n = 0;
    interface->gap_m -= interface->bumper_thickness_m - interface->bumper_cavity_m;
    interface->has_bumper = false;
}

/* `law`: that of bumper or contact. An impulse has no stiffness of its own. */
static enum thud_status replace_law(struct thud_scene *scene, const struct thud_law *law,
                                    const struct thud_model *model, const struct thud_result *result, int i,
                                    struct thud_text *what, struct thud_error *err)
{
    struct thud_interface *interface = &scene->interface[i];
    const bool impulse = law->flags & THUD_LAW_IMPULSIVE;
    char key[64], restitution[64] = "1", stiffness[64];
    const struct thud_contact_result *hardest = thud_contact_hardest(result, i + 1);
    int c = hardest && hardest->force.value > 0 ? (int)(hardest - result->contact) : -1;
    double depth_m = c >= 0 ? result->contact[c].indentation.value : usual_depth_m;
    for (int k = 0; c < 0 && k < model->npairs; k++)
        c = model->contact[k].interface == i + 1 ? k : c;
    if (c < 0)
        return THUD_OK;
    const double stiffness_npm = impulse ? usual_npm : own_stiffness(&model->contact[c], depth_m);
    snprintf(key, sizeof key, "interfaces.%d.%s.restitution", i + 1, interface->has_bumper ? "bumper" : "contact");
    snprintf(stiffness, sizeof stiffness, "%.9g N/m", stiffness_npm);
    enum thud_status status = THUD_OK;
    if (thud_law_param(law, "restitution") >= 0)
        status = thud_scene_get(scene, key, restitution, sizeof restitution, err);
    if (status == THUD_OK)
        status = set(scene, i + 1, "law", "kelvin-voigt", err);
    if (status == THUD_OK)
        status = set(scene, i + 1, "stiffness", stiffness, err);
    if (status == THUD_OK)
        status = set(scene, i + 1, "restitution", restitution, err);
    thud_text_append(
        what, "interface %d: the %s is a Kelvin-Voigt contact of %.4g MN/m and restitution %s at the same clearance",
        i + 1, interface->has_bumper ? "rubber bumper" : law->name, 1e-6 * stiffness_npm, restitution);
    if (impulse)
        thud_text_append(what, ": time steps need a force\n");
    else
        thud_text_append(what, ", with the same force and energy at %.3g mm\n", 1e3 * depth_m);
    if (interface->has_bumper)
        take_bumper_off(interface);
    return status;
}

/* What thud's own scene keeps, and the script has in another form. */
static void tell_forms(const struct thud_scene *scene, const struct thud_model *model, struct thud_text *what)
{
    for (int s = 0; s < scene->nstructures; s++)
        if (thud_structure_on_soil(&scene->structure[s]))
            thud_text_append(what,
                             "structure %d: foundation and building are springs and dashpots between floors, sway and "
                             "rotation, by its matrices of stiffness and damping\n",
                             s + 1);
    for (int i = 0, told = 0; i < model->npairs; i++)
        if (model->contact[i].struck != 0 && model->contact[i].interface != told) {
            told = model->contact[i].interface;
            thud_text_append(what,
                             "interface %d: the place at which a slab strikes columns is held by stiff springs to the "
                             "floors above and below, by their shares\n",
                             told);
        }
}

enum thud_status thud_opensees_nearest(const struct thud_scene *scene, const struct thud_model *model,
                                       const struct thud_result *result, struct thud_scene *out, struct thud_text *what,
                                       struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    *out = *scene;
    if (model->left_out > 0)
        thud_text_append(what, "every mode is integrated, also those that are left out\n");
    out->analysis.modes = 0;
    for (int s = 0; s < scene->nstructures; s++)
        out->structure[s].modes = 0;
    for (int i = 0; i + 1 < scene->nstructures && status == THUD_OK; i++) {
        const struct thud_interface *interface = &scene->interface[i];
        const struct thud_law *law = interface->has_bumper ? interface->bumper.law : interface->contact.law;
        if (stays(law, model, i))
            continue;
        if (strcmp(law->name, "kelvin-voigt-no-tension") != 0 || interface->has_bumper) {
            status = replace_law(out, law, model, result, i, what, err);
        } else {
            status = set(out, i + 1, "law", "kelvin-voigt", err);
            thud_text_append(
                what,
                "interface %d: the dashpot of the contact does not let go at zero force, it pulls until the "
                "contact opens\n",
                i + 1);
        }
    }
    tell_forms(scene, model, what);
    return status;
}

static void row(struct thud_text *what, const char *name, double full, double replaced)
{
    const double moved = full > 0 ? 100 * (replaced / full - 1) : replaced > 0 ? (double)INFINITY : 0;
    thud_text_append(what, isinf(moved) ? "%-32s %10.4g %10.4g       -" : "%-32s %10.4g %10.4g  %+.1f %%", name, full,
                     replaced, moved);
    thud_text_append(what, "%s\n", fabs(moved) > 10 ? "  WARNING: moved by more than 10 %" : "");
}

void thud_opensees_compare(const struct thud_scene *scene, const struct thud_result *full,
                           const struct thud_result *replaced, struct thud_text *what)
{
    const struct thud_result *both[2] = {full, replaced};
    double force[2] = {0, 0}, impacts[2] = {0, 0}, most[2];
    for (int k = 0; k < 2; k++)
        for (int c = 0; c < both[k]->ncontacts; c++) {
            force[k] = fmax(force[k], both[k]->contact[c].force.value);
            impacts[k] += both[k]->contact[c].impacts;
        }
    thud_text_append(what, "%-32s %10s %10s\n", "both run by thud", "full", "replaced");
    row(what, "largest force, MN", 1e-6 * force[0], 1e-6 * force[1]);
    row(what, "impacts", impacts[0], impacts[1]);
    for (int s = 0; s < scene->nstructures; s++) {
        char name[THUD_NAME_MAX + 32];
        for (int k = 0; k < 2; k++) {
            most[k] = 0;
            for (int f = 0; f < both[k]->structure[s].floors; f++)
                most[k] = fmax(most[k], both[k]->structure[s].floor[f].acceleration.value);
        }
        snprintf(name, sizeof name, "largest acceleration of %.10s, m/s2", scene->structure[s].name);
        if (both[0]->structure[s].floors > 0)
            row(what, name, most[0], most[1]);
    }
}
