/* Left the elevation: slabs, columns, bumpers and the places that slabs strike, heights to scale, gaps wider by the
 * factor in the note. Right the model: masses, springs of storeys and isolators, contacts. Widths mean nothing. */
#include "plot/figures/figures_scene.h"

#include <math.h>
#include <stdio.h>

#include "core/model/model.h"
#include "study/scene/building.h"
#include "study/scene/level.h"

/* Widths on the drawing, m. */
static const double building_m = 6, body_m = 4, wall_m = 1.5, gap_drawn_m = 2, model_m = 6;
enum { LABELS_MOST = 8, TEETH = 6 };
enum { SLAB = THUD_COLOR_GREY, FRAME = 6, STRUCK = 1, BUMPER = 2, CONTACT = 0, MASS = 11 };
static const struct thud_style solid = {.color = FRAME, .wide = true};

struct drawing {
    const struct thud_scene *scene;
    struct thud_panel *elevation, *model;
    double left[THUD_STRUCTURES_MAX], right[THUD_STRUCTURES_MAX]; /* faces in elevation */
    double at[THUD_STRUCTURES_MAX];                               /* of the masses in the model */
    double wider, low, high, foot; /* factor of the gaps; lowest ground, highest floor, what stands on the ground */
};

static void rectangle(struct thud_panel *panel, const char *name, int color, const double x[2], double bottom,
                      double top)
{
    thud_panel_fill(panel, (struct thud_style){.color = color, .wide = true}, name, 2, x, (double[]){bottom, bottom},
                    (double[]){top, top});
}

static void line(struct thud_panel *panel, const char *name, struct thud_style style, double x0, double y0, double x1,
                 double y1)
{
    thud_panel_add(panel, style, name, 2, (double[]){x0, x1}, (double[]){y0, y1});
}

static void dot(struct thud_panel *panel, const char *name, int color, double x, double y)
{
    thud_panel_add(panel, (struct thud_style){.kind = THUD_POINTS, .color = color, .wide = true}, name, 1, &x, &y);
}

/* A spring from one point to another: a straight piece, teeth to either side, a straight piece. */
static void spring(struct thud_panel *panel, const char *name, int color, double x0, double y0, double x1, double y1,
                   double tooth_x, double tooth_y)
{
    double x[TEETH + 2], y[TEETH + 2];
    for (int i = 0; i < TEETH + 2; i++) {
        double t = i == 0 ? 0 : i == TEETH + 1 ? 1 : 0.2 + 0.6 * (i - 1) / (TEETH - 1);
        double side = i < 2 || i > TEETH - 1 ? 0 : i % 2 ? 1 : -1;
        x[i] = x0 + t * (x1 - x0) + side * tooth_x;
        y[i] = y0 + t * (y1 - y0) + side * tooth_y;
    }
    thud_panel_add(panel, (struct thud_style){.color = color, .thin = true}, name, TEETH + 2, x, y);
}

/* A contact: a spring on the left mass, and the gap between two plates. */
static void spring_and_gap(struct thud_panel *panel, const char *name, double left, double right, double y, double high)
{
    const struct thud_style thin = {.color = CONTACT, .thin = true}, plate = {.color = CONTACT};
    const double end[] = {left + 0.6 * (right - left), left + 0.7 * (right - left)};
    spring(panel, name, CONTACT, left, y, end[0], y, 0, 0.012 * high);
    for (int k = 0; k < 2; k++)
        line(panel, name, plate, end[k], y - 0.02 * high, end[k], y + 0.02 * high);
    line(panel, name, thin, end[1], y, right, y);
}

static double elevation(const struct drawing *d, int s, int floor)
{
    double z = thud_structure_elevation(&d->scene->structure[s], floor);
    return isnan(z) ? 0 : z;
}

static double width_of(enum thud_structure_kind kind)
{
    return kind == THUD_WALL ? wall_m : kind == THUD_RIGID ? body_m : building_m;
}

/* Where everything stands. */
static void lay_out(struct drawing *d)
{
    const struct thud_scene *scene = d->scene;
    double widest = 0, x = 0;
    for (int i = 0; i + 1 < scene->nstructures; i++)
        widest = fmax(widest, scene->interface[i].gap_m);
    d->wider = 1;
    for (double step = 10; widest > 0 && d->wider * widest < 0.5 * gap_drawn_m && step < 1e4; step *= 10)
        d->wider = 2 * step * widest < gap_drawn_m ? 2 * step : step;
    for (int s = 0; s < scene->nstructures; s++) {
        const struct thud_structure *p = &scene->structure[s];
        const int floors = thud_structure_floors(p);
        d->left[s] = x;
        d->right[s] = x + width_of(p->kind);
        d->at[s] = model_m * s;
        x = d->right[s];
        if (s + 1 < scene->nstructures)
            x += fmax(0.3, d->wider * scene->interface[s].gap_m);
        if (p->kind != THUD_WALL) {
            d->high = fmax(d->high, elevation(d, s, floors - 1));
            d->low = fmin(d->low, thud_kind_is_building(p->kind) ? p->base_m : 0);
        }
    }
    d->foot = d->low;
    for (int s = 0; s < scene->nstructures; s++) /* isolators stand below their slab, foundations below the ground */
        if (scene->structure[s].kind == THUD_ISOLATED || thud_structure_on_soil(&scene->structure[s]))
            d->foot = d->low - 0.1 * (d->high - d->low);
}

static double top_of_wall(const struct drawing *d, int s)
{
    double top = d->scene->structure[s].height_m[0];
    return isfinite(top) ? fmax(top, 0.5) : d->high;
}

static void levels(const struct drawing *d, int s, int floor, double z)
{
    const struct thud_scene *scene = d->scene;
    const int every = 1 + (thud_structure_floors(&scene->structure[s]) - 1) / LABELS_MOST;
    char text[32];
    if ((floor + 1) % every != 0)
        return;
    snprintf(text, sizeof text, "%+.2f", z);
    if (s == 0)
        thud_panel_label(d->elevation, d->left[s] - 0.3, z, -1, text);
    else if (s + 1 == scene->nstructures)
        thud_panel_label(d->elevation, d->right[s] + 0.3, z, 1, text);
    else
        thud_panel_label(d->elevation, 0.5 * (d->left[s] + d->right[s]), z + 0.03 * d->high, 0, text);
}

static void building(const struct drawing *d, int s)
{
    const struct thud_structure *p = &d->scene->structure[s];
    const double x[] = {d->left[s], d->right[s]};
    const int floors = thud_structure_floors(p), slab = p->kind == THUD_ISOLATED;
    for (int f = 0; f < floors; f++) {
        double z = elevation(d, s, f), below = f > 0 ? elevation(d, s, f - 1) : p->base_m;
        double depth = fmax(thud_structure_depth(p, f), 0.02 * d->high);
        rectangle(d->elevation, "slab", SLAB, x, z - depth, z);
        levels(d, s, f, z);
        for (int side = 0; side < 2 && f >= slab; side++)
            line(d->elevation, "columns", solid, x[side], below, x[side], z);
        for (int k = 0; k < 3 && f < slab; k++) {
            double at = x[0] + (0.2 + 0.3 * k) * (x[1] - x[0]);
            spring(d->elevation, "isolators", STRUCK, at, d->foot, at, z - depth, 0.25, 0);
        }
    }
}

static void number(const struct drawing *d, int s, double y, double value, const char *unit)
{
    char text[48];
    snprintf(text, sizeof text, "%.4g %s", value, unit);
    const int side = s > 0 || d->scene->nstructures == 1 ? 1 : -1;
    const bool between = s > 0 && s + 1 < d->scene->nstructures; /* contacts to both sides: above their line */
    thud_panel_label(d->model, d->at[s] + 0.4 * side, y + (between ? 0.025 * d->high : 0), side, text);
}

/* From the ground that the building stands on down to the foot of the drawing. */
static void foundation(const struct drawing *d, int s)
{
    const struct thud_structure *p = &d->scene->structure[s];
    const struct thud_foundation_input f = thud_structure_foundation(p);
    const double x = d->at[s], top = p->base_m, high = d->high - d->low, under = top - 0.03 * high;
    rectangle(d->elevation, "foundation on soil", STRUCK, (double[]){d->left[s] - 0.3, d->right[s] + 0.3}, under, top);
    rectangle(d->model, "foundation on soil", STRUCK, (double[]){x - 0.5, x + 0.5}, under, top);
    for (int side = -1; side < 2; side += 2)
        spring(d->model, "soil against rocking", STRUCK, x + 0.4 * side, d->foot, x + 0.4 * side, under, 0.1, 0);
    const int numbers = s > 0 || d->scene->nstructures == 1 ? 1 : -1; /* the side of number() */
    char text[48];
    spring(d->model, "soil against sway", STRUCK, x - 0.5 * numbers, 0.5 * (under + top), x - 1.3 * numbers,
           0.5 * (under + top), 0, 0.01 * high);
    snprintf(text, sizeof text, "%.4g MN/m", 1e-6 * f.sway_npm);
    thud_panel_label(d->model, x + 0.6 * numbers, 0.5 * (under + top), numbers, text);
    number(d, s, d->foot - 0.04 * high, 1e-9 * f.rocking_nmprad, "GN m/rad");
}

/* A wall by what holds it: a fixed one by the ground, one that gives by its own spring and by the soil behind it. */
static const char *wall_name(const struct thud_structure *p)
{
    return thud_wall_gives(p) ? "flexible wall" : "wall, moves with the ground";
}

/* Its mass, and to the side where no neighbour is its springs, which end at the ground. Of a wall without a height the
 * mass stands in the middle of the drawing. */
static void wall_that_gives(const struct drawing *d, int s)
{
    const struct thud_structure *p = &d->scene->structure[s];
    const double x = d->at[s], high = d->high - d->low, out = s > 0 ? 1 : -1;
    const double z = isfinite(elevation(d, s, 0)) ? elevation(d, s, 0) : d->low + 0.5 * high;
    const char *const name[] = {"stiffness of the wall", "soil behind the wall"};
    const double stiffness[] = {p->wall_stiffness_npm, p->backfill_stiffness_npm};
    char text[48];
    for (int k = 0; k < 1 + thud_wall_has_backfill(p); k++) {
        const double end = x + 1.3 * out, y = z + (k ? -0.06 : 0.06) * high;
        spring(d->model, name[k], k ? STRUCK : FRAME, x, z, end, y, 0, 0.012 * high);
        line(d->model, name[k], solid, end, y - 0.03 * high, end, y + 0.03 * high);
        snprintf(text, sizeof text, "%.4g MN/m", 1e-6 * stiffness[k]);
        thud_panel_label(d->model, end + 0.2 * out, y, (int)out, text);
    }
    line(d->model, wall_name(p), (struct thud_style){.color = FRAME, .wide = true}, x, d->low, x, top_of_wall(d, s));
    dot(d->model, "mass", MASS, x, z);
    snprintf(text, sizeof text, "%.4g t", 1e-3 * p->wall_mass_kg);
    thud_panel_label(d->model, x + 0.2 * out, z + 0.13 * high, (int)out, text);
}

static void in_elevation(const struct drawing *d, int s)
{
    const struct thud_structure *p = &d->scene->structure[s];
    const double x[] = {d->left[s], d->right[s]}, z = p->kind == THUD_RIGID ? elevation(d, s, 0) : 0;
    if (p->kind == THUD_WALL)
        rectangle(d->elevation, wall_name(p), FRAME, x, d->foot, top_of_wall(d, s));
    else if (p->kind == THUD_RIGID)
        rectangle(d->elevation, "body", SLAB, x, z - 0.5, z + 0.5);
    else
        building(d, s);
    thud_panel_label(d->elevation, 0.5 * (x[0] + x[1]),
                     (p->kind == THUD_WALL ? top_of_wall(d, s) : elevation(d, s, thud_structure_floors(p) - 1)) +
                         0.13 * (d->high - d->low),
                     0, p->name);
}

/* Mass and stiffness are a line each: the floors with numbers stand this part of the drawing's height apart. */
static const double told_apart = 0.15;

static int floors_told(const struct drawing *d, int s)
{
    const int floors = thud_structure_floors(&d->scene->structure[s]);
    const double high = floors > 0 ? elevation(d, s, floors - 1) - d->scene->structure[s].base_m : 0;
    return high > 0 ? (int)ceil(told_apart * (d->high - d->low) * floors / high) : 1;
}

static void in_model(const struct drawing *d, int s)
{
    const struct thud_structure *p = &d->scene->structure[s];
    const int floors = thud_structure_floors(p), slab = p->kind == THUD_ISOLATED, every = floors_told(d, s);
    const double x = d->at[s];
    if (thud_structure_on_soil(p))
        foundation(d, s);
    if (p->kind == THUD_WALL && !thud_wall_gives(p))
        rectangle(d->model, wall_name(p), FRAME, (double[]){x - 0.3, x + 0.3}, d->foot, top_of_wall(d, s));
    else if (p->kind == THUD_WALL)
        wall_that_gives(d, s);
    for (int f = 0; f < floors && p->kind != THUD_WALL; f++) {
        double z = elevation(d, s, f), below = f > 0 ? elevation(d, s, f - 1) : p->kind == THUD_RIGID ? z : p->base_m;
        const bool told = (f + 1) % every == 0;
        if (f < slab) {
            spring(d->model, "isolators", STRUCK, x, d->foot, x, z, 0.25, 0);
            number(d, s, d->foot - 0.07 * (d->high - d->low), 1e-6 * thud_structure_isolator(p).stiffness_npm, "MN/m");
        } else if (thud_kind_is_read(p->kind)) {
            line(d->model, "stiffness read from a file", (struct thud_style){.color = FRAME}, x, below, x, z);
        } else if (p->kind != THUD_RIGID) {
            spring(d->model, "storey stiffness", FRAME, x, below, x, z, 0.25, 0);
            if (told)
                number(d, s, fmin(0.5 * (below + z), z - 0.4 * told_apart * (d->high - d->low)),
                       1e-6 * thud_structure_stiffness(p, f - slab), "MN/m");
        }
        dot(d->model, "mass", MASS, x, z);
        if (told)
            number(d, s, z, 1e-3 * (f < slab ? p->base_mass_kg : p->mass_kg[f - slab]), "t");
    }
}

/* The ground under a structure. Isolators and the support of a wall stand on the foot of the drawing, a foundation on
 * soil in the ground. In the model its springs stand on the foot. */
static void ground(const struct drawing *d, int s)
{
    const struct thud_structure *p = &d->scene->structure[s];
    const struct thud_style style = {.color = FRAME};
    const double own = thud_kind_is_building(p->kind) && p->kind != THUD_ISOLATED ? p->base_m : d->foot,
                 model = thud_structure_on_soil(p) ? d->foot : own, beside = 0.2;
    line(d->elevation, "", style, d->left[s] - beside, own, d->right[s] + beside, own);
    line(d->model, "", style, d->at[s] - 0.3 * model_m, model, d->at[s] + 0.3 * model_m, model);
}

/* Half the height of the bumpers of an interface: they stay apart from each other. */
static double bumper_half(const struct drawing *d, int n, const double *y)
{
    double half = 0.015 * d->high;
    for (int k = 0; k < n; k++)
        for (int j = 0; j < k; j++)
            half = fmin(half, 0.4 * fabs(y[k] - y[j]));
    return half;
}

static void contacts(const struct drawing *d, int i)
{
    const struct thud_interface *interface = &d->scene->interface[i];
    struct thud_contact_pair pair[THUD_CONTACT_PAIRS_MAX];
    const int n = thud_interface_contact_pairs(d->scene, i, pair);
    const double from = d->right[i], to = d->left[i + 1];
    double level[THUD_CONTACT_PAIRS_MAX];
    for (int k = 0; k < n; k++) {
        const bool left = thud_slab_is_left(pair[k].left_floor, pair[k].struck);
        const int s = left ? i : i + 1, floor = left ? pair[k].left_floor : pair[k].right_floor;
        level[k] = elevation(d, s, floor - 1) - 0.5 * thud_structure_depth(&d->scene->structure[s], floor - 1);
    }
    const double half = bumper_half(d, n, level);
    for (int k = 0; k < n; k++) {
        const double y = level[k];
        const struct thud_level_values at = thud_interface_level(interface, k);
        if (at.has_bumper) {
            double face = from - d->wider * at.cavity_m;
            rectangle(d->elevation, "bumper", BUMPER, (double[]){face, face + d->wider * at.thickness_m}, y - half,
                      y + half);
        }
        for (int side = 0; pair[k].struck && side < 2; side++)
            dot(side ? d->model : d->elevation, "columns are struck here", STRUCK,
                pair[k].struck < 0 ? (side ? d->at[i] : from) : (side ? d->at[i + 1] : to), y);
        spring_and_gap(d->model, at.has_bumper ? "contact with bumper and gap" : "contact with gap", d->at[i],
                       d->at[i + 1], y, d->high);
    }
    char gap[64], text[80];
    thud_interface_gap_text(interface, gap, sizeof gap);
    snprintf(text, sizeof text, "gap %s", gap);
    thud_panel_label(d->elevation, 0.5 * (from + to), d->foot - 0.06 * (d->high - d->low), 0, text);
}

static void links(const struct drawing *d)
{
    for (int i = 0; i < d->scene->nlinks; i++) {
        int s[2], floor[2];
        double z[2];
        const char *const end[] = {d->scene->link[i].from, d->scene->link[i].to};
        for (int k = 0; k < 2; k++) {
            if (thud_link_end(d->scene, end[k], &s[k], &floor[k], NULL) != THUD_OK)
                return;
            z[k] = floor[k] > 0 ? elevation(d, s[k], floor[k] - 1) : 0;
        }
        const int a = s[0] < s[1] ? 0 : 1, b = 1 - a;
        line(d->elevation, "link", (struct thud_style){.color = 5}, d->right[s[a]], z[a], d->left[s[b]], z[b]);
        line(d->model, "link", (struct thud_style){.color = 5}, d->at[s[a]], z[a], d->at[s[b]], z[b]);
    }
}

struct thud_figure *thud_figure_of_scene(const struct thud_scene *scene, const char *name, const char *title)
{
    struct thud_figure *figure = thud_figure_create(name, title, 1, 2);
    struct drawing d = {.scene = scene,
                        .elevation = thud_figure_panel(figure, 0, 0, "Elevation"),
                        .model = thud_figure_panel(figure, 0, 1, "Model")};
    char note[240];
    if (!figure)
        return NULL;
    d.high = 1;
    lay_out(&d);
    const double high = d.high - d.low, last = d.right[scene->nstructures - 1];
    struct thud_panel *const panel[] = {d.elevation, d.model};
    for (int k = 0; k < 2; k++) {
        panel[k]->drawing = true;
        thud_panel_axis(panel[k], THUD_Y, "Level", "m");
        thud_panel_limits(panel[k], THUD_Y, d.foot - 0.12 * high, d.high + 0.18 * high);
    }
    thud_panel_limits(d.elevation, THUD_X, -0.25 * last, 1.25 * last);
    double outside = 0.8 * model_m; /* springs of flexible walls and of soil have their numbers there */
    for (int s = 0; s < scene->nstructures; s++)
        if (thud_wall_gives(&scene->structure[s]) || thud_structure_on_soil(&scene->structure[s]))
            outside = 1.4 * model_m;
    thud_panel_limits(d.model, THUD_X, -outside, d.at[scene->nstructures - 1] + outside);
    for (int s = 0; s < scene->nstructures; s++) {
        in_elevation(&d, s);
        in_model(&d, s);
        ground(&d, s);
    }
    for (int i = 0; i + 1 < scene->nstructures; i++)
        contacts(&d, i);
    links(&d);
    snprintf(note, sizeof note,
             "Levels and slabs are to scale (thin slabs at least as a line). Widths of the buildings are not inputs. "
             "Gaps and bumpers are drawn %.4g times their width.",
             d.wider);
    thud_figure_note(figure, note);
    return figure;
}
