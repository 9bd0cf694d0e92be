#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "study/scene/building.h"
#include "study/scene/level.h"
#include "tui/screens/figures.h"
#include "tui/screens/movement.h"
#include "tui/widgets/dots.h"

/* The row at or before a time. */
static size_t row_before(const struct thud_history *h, double t)
{
    size_t low = 0, high = h->rows;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (h->time_s[middle] <= t)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Value of a column at a time, linear between rows. */
static double value_at(const struct thud_history *h, int column, double t)
{
    if (h->rows == 0)
        return 0.0;
    size_t row = row_before(h, t), next = row + 1 < h->rows ? row + 1 : row;
    double a = h->value[row * (size_t)h->columns + (size_t)column],
           b = h->value[next * (size_t)h->columns + (size_t)column];
    double width = h->time_s[next] - h->time_s[row];
    double along = width > 0.0 ? fmin(1.0, fmax(0.0, (t - h->time_s[row]) / width)) : 0.0;
    return a + along * (b - a);
}

/* A force; where it jumps just there (a law may let go of much of it at the largest indentation), the larger side. */
static double force_at(const struct thud_history *h, int contact, double t)
{
    const double moment_s = 1e-9;
    int column = thud_history_force(h, contact);
    double most = value_at(h, column, t);
    if (h->rows == 0)
        return 0.0;
    size_t row = row_before(h, t + moment_s);
    while (fabs(h->time_s[row] - t) <= moment_s) {
        most = fmax(most, h->value[row * (size_t)h->columns + (size_t)column]);
        if (row-- == 0)
            break;
    }
    return most;
}

static const double touch_n = 1.0; /* less is no contact that anybody would see */

struct stage {
    struct thud_dots dots;
    const struct thud_scene *scene;
    const struct thud_model *model;
    const struct thud_history *history;
    const struct thud_result *result;
    double t;
    bool bumper;
    double body;                      /* width of a building, dots */
    double scale;                     /* dots per metre across */
    double storey;                    /* dots per metre up */
    double ground;                    /* row of the lowest base, dots */
    double low_m;                     /* its elevation */
    double left[THUD_STRUCTURES_MAX]; /* left edge at rest, dots */
    double *shift;                    /* (ndof) displacements now, dots, with bodies kept out of each other */
};

/* Largest displacement of a structure's floors, m. */
static double reach(const struct thud_result *result, int s)
{
    double most = 0.0;
    for (int i = 0; i < result->structure[s].floors; i++)
        most = fmax(most, result->structure[s].floor[i].displacement.value);
    return most;
}

/* Row of an elevation, dots. */
static double row_of(const struct stage *stage, double level_m)
{
    return stage->ground - stage->storey * (level_m - stage->low_m);
}

/* Where a structure begins and ends, m; a wall or body that does not say how high it is has no end. */
static void extent(const struct thud_structure *structure, double *base_m, double *top_m)
{
    *base_m = thud_kind_is_building(structure->kind) ? structure->base_m : 0.0;
    *top_m = thud_kind_is_building(structure->kind)
                 ? thud_structure_elevation(structure, thud_structure_floors(structure) - 1)
                 : structure->height_m[0];
}

static double bounded_gap(const struct thud_scene *scene, int i)
{
    double least, most;
    thud_interface_gaps(&scene->interface[i], &least, &most);
    return fmax(0.0, least);
}

/* Scales such that everything stays inside for the whole run. */
static bool set_stage(struct stage *stage)
{
    const struct thud_scene *scene = stage->scene;
    int n = scene->nstructures;
    double across = 0.0, low = INFINITY, high = -INFINITY;
    for (int s = 0; s < n; s++) {
        double base, top;
        extent(&scene->structure[s], &base, &top);
        across += s + 1 < n ? bounded_gap(scene, s) : 0.0;
        low = fmin(low, base);
        high = fmax(high, top); /* fmax passes over NaN */
    }
    double margin = fmax(reach(stage->result, 0), reach(stage->result, n - 1));
    across += 2.0 * margin;
    stage->body = floor(stage->dots.width / (2.6 * n)); /* the movement is what is looked at */
    double room = stage->dots.width - n * stage->body - 2.0;
    if (stage->body < 3.0 || room < 4.0 || stage->dots.height < 8)
        return false;
    stage->scale = across > 0.0 ? room / across : 0.0;
    stage->ground = stage->dots.height - 2.0;
    stage->low_m = low;
    stage->storey = (stage->ground - 1.0) / (isfinite(high) && high > low ? high - low : 3.0);
    double at = 1.0 + stage->scale * margin;
    for (int s = 0; s < n; s++) {
        stage->left[s] = at;
        at += stage->body + (s + 1 < n ? stage->scale * bounded_gap(scene, s) : 0.0);
    }
    return true;
}

/* Of a floor, or of the place between two floors where columns are struck; 0 for a wall and the ground. */
static double side_shift(const struct stage *stage, const struct thud_model_side *side)
{
    double above = side->dof < 0 ? 0.0 : stage->shift[side->dof],
           below = side->below < 0 ? 0.0 : stage->shift[side->below];
    double shift = side->share < 1.0 ? side->share * above + (1.0 - side->share) * below : above;
    return side->tilt < 0 ? shift : shift + side->by_tilt * stage->shift[side->tilt];
}

/* How far the two sides of a contact are drawn into each other, dots. */
static double overlap(const struct stage *stage, const struct thud_model_contact *c)
{
    return stage->left[c->interface - 1] + stage->body + side_shift(stage, &c->left) - stage->left[c->interface] -
           side_shift(stage, &c->right);
}

/* Displacements to scale. Where the concrete itself is pressed in, both sides give way by half of that: what the law
 * says is an indentation is no overlap of two buildings. Columns that are struck bend by all of it (draw_storey). */
static void set_shifts(struct stage *stage)
{
    for (int i = 0; i < stage->model->ndof; i++)
        stage->shift[i] =
            stage->scale * value_at(stage->history, thud_history_displacement(stage->history, i), stage->t);
    for (int i = 0; i < stage->model->npairs; i++) {
        const struct thud_model_contact *c = &stage->model->contact[i];
        double over = overlap(stage, c);
        if (!(over > 0.0) || c->struck)
            continue;
        double part = c->left_dof >= 0 && c->right_dof >= 0 ? 0.5 : 1.0;
        if (c->left_dof >= 0)
            stage->shift[c->left_dof] -= part * over;
        if (c->right_dof >= 0)
            stage->shift[c->right_dof] += part * over;
    }
}

/* Elevation of a contact, m: that of the floor that meets another or strikes columns. */
static double contact_level(const struct stage *stage, const struct thud_model_contact *contact)
{
    const struct thud_structure *left = &stage->scene->structure[contact->interface - 1], *right = left + 1;
    const double breast_m = 1.5; /* of a body of unknown height */
    bool of_left = thud_slab_is_left(contact->left_floor, contact->struck);
    if (contact->struck == 0 && of_left) /* a building's floors say more than a body does */
        of_left = thud_kind_is_building(left->kind) || !thud_kind_is_building(right->kind);
    const struct thud_structure *of = of_left ? left : right;
    double level = thud_structure_elevation(of, (of_left ? contact->left_floor : contact->right_floor) - 1);
    if (thud_kind_is_building(of->kind))
        return level;
    return isfinite(level) ? fmin(0.5 * level, breast_m) : breast_m;
}

static double contact_row(const struct stage *stage, const struct thud_model_contact *contact)
{
    return fmax(1.0, row_of(stage, contact_level(stage, contact)));
}

/* A bar of a round length below the ground: "|---| 50 mm"; the gap and the bumpers are drawn to the same scale. */
static void draw_scale(const struct stage *stage, const struct thud_pane *row)
{
    double width = 0.4 * row->w * stage->dots.across / stage->scale, power = pow(10.0, floor(log10(width)));
    double length = power * (width >= 5.0 * power ? 5.0 : width >= 2.0 * power ? 2.0 : 1.0);
    int cells = (int)lround(length * stage->scale / stage->dots.across);
    struct thud_look look = thud_look(THUD_ROLE_MUTED, 0);
    if (!isfinite(length) || cells < 2)
        return;
    for (int x = 0; x <= cells; x++)
        thud_pane_glyph(row, x, 0, look, x == 0 ? 0x251c : x == cells ? 0x2524 : 0x2500);
    thud_pane_print(row, cells + 2, 0, look, "%g mm across", 1e3 * length);
}

static void draw_box(struct stage *stage, double x0, double y0, double x1, double y1, struct thud_look look)
{
    thud_dots_line(&stage->dots, x0, y0, x1, y0, 1, look);
    thud_dots_line(&stage->dots, x0, y1, x1, y1, 1, look);
    thud_dots_line(&stage->dots, x0, y0, x0, y1, 1, look);
    thud_dots_line(&stage->dots, x1, y0, x1, y1, 1, look);
}

/* The left column of a storey at rest with its building, dots: from its foot to its head. */
struct storey {
    double x0, y0, x1, y1;
};

/* A column of a storey that yielded: stiff at both ends, with a kink at each of its plastic hinges. */
static void draw_kinked(struct stage *stage, struct storey at, bool flows, struct thud_look look)
{
    const double stiff = 0.2; /* of its length */
    double low = at.y0 + stiff * (at.y1 - at.y0), high = at.y1 - stiff * (at.y1 - at.y0);
    struct thud_look hinge = thud_look(flows ? THUD_ROLE_ERROR : THUD_ROLE_WARN, THUD_BOLD);
    thud_dots_line(&stage->dots, at.x0, at.y0, at.x0, low, 1, look);
    thud_dots_line(&stage->dots, at.x0, low, at.x1, high, 1, flows ? hinge : look);
    thud_dots_line(&stage->dots, at.x1, high, at.x1, at.y1, 1, look);
    for (int i = 0; i < 2; i++) {
        double x = i ? at.x1 : at.x0, y = i ? high : low;
        thud_dots_line(&stage->dots, x - 1.0, y, x + 1.0, y, 1, hinge);
    }
}

/* The contact in which the column on this side of a storey (from 0) is pressed in most now; NULL: it is not. */
static const struct thud_model_contact *pressing(const struct stage *stage, int s, int storey, bool right_side)
{
    const struct thud_model_contact *found = NULL;
    double most = 0.0;
    for (int i = 0; i < stage->model->npairs; i++) {
        const struct thud_model_contact *c = &stage->model->contact[i];
        bool mine = right_side ? c->struck < 0 && c->interface - 1 == s && c->left_floor == storey + 1
                               : c->struck > 0 && c->interface == s && c->right_floor == storey + 1;
        if (mine && overlap(stage, c) > most) {
            most = overlap(stage, c);
            found = c;
        }
    }
    return found;
}

/* A building that bends as a wall is drawn as one in the middle of its slabs, from this part of their width on. */
static const double wall_edge = 0.35;

/* Both columns of a storey (from 0): kinked where it yielded, by way of the slab's edge where one presses them in. */
static void draw_storey(struct stage *stage, int s, int storey, struct storey at, struct thud_look look)
{
    int yielding = thud_model_yielding(stage->model, stage->model->structure[s].first + storey);
    double plastic = 0.0, drift = 0.0, yield = 0.0, body = stage->body - 1.0;
    const struct thud_collapse *fall = &stage->result->collapse;
    if (fall->happened && fall->structure == s && fall->floor == storey && stage->t >= fall->time_s)
        look = thud_look(THUD_ROLE_ERROR, THUD_BOLD);
    if (yielding >= 0) {
        plastic = value_at(stage->history, thud_history_storey_plastic(stage->history, yielding), stage->t);
        drift = value_at(stage->history, thud_history_storey_drift(stage->history, yielding), stage->t);
        yield = stage->model->storey[yielding].yield_m;
    }
    const bool bends = thud_structure_bends(&stage->scene->structure[s], &stage->model->structure[s]);
    for (double in = wall_edge * body; bends && in <= (1.0 - wall_edge) * body; in += 1.0)
        thud_dots_line(&stage->dots, at.x0 + in, at.y0, at.x1 + in, at.y1, 1, look);
    for (int side = 0; side < 2; side++) {
        const struct thud_model_contact *c = pressing(stage, s, storey, side == 1);
        const double in = c || !bends ? 0.0 : (side ? -wall_edge : wall_edge) * body;
        struct storey column = {at.x0 + side * body + in, at.y0, at.x1 + side * body + in, at.y1};
        if (c) {
            double y = row_of(stage, contact_level(stage, c)),
                   x = side ? stage->left[s + 1] + side_shift(stage, &c->right) - 1.0
                            : stage->left[s - 1] + stage->body + side_shift(stage, &c->left);
            thud_dots_line(&stage->dots, column.x0, column.y0, x, y, 1, look);
            thud_dots_line(&stage->dots, x, y, column.x1, column.y1, 1, look);
        } else if (fabs(plastic) > 1e-3 * yield) {
            draw_kinked(stage, column, fabs(drift - plastic) >= yield * (1.0 - 1e-6), look);
        } else {
            thud_dots_line(&stage->dots, column.x0, column.y0, column.x1, column.y1, 1, look);
        }
    }
}

/* What a building slides or yields on, at both ends of its slab: a dish on the ground and the slider on it, or a
 * bearing that is sheared between ground and slab; red while it moves beyond its elastic displacement. */
static void draw_isolators(struct stage *stage, int s, double ground, double slab)
{
    const struct thud_structure *structure = &stage->scene->structure[s];
    const int first = stage->model->structure[s].first, row = thud_model_yielding(stage->model, first);
    const double shift = stage->shift[first], half = fmax(1.0, 0.12 * stage->body);
    if (row < 0)
        return;
    const double plastic = value_at(stage->history, thud_history_storey_plastic(stage->history, row), stage->t),
                 drift = value_at(stage->history, thud_history_storey_drift(stage->history, row), stage->t);
    const bool slides = fabs(drift - plastic) >= stage->model->storey[row].yield_m * (1.0 - 1e-6);
    struct thud_look look = thud_look(slides ? THUD_ROLE_ERROR : THUD_ROLE_WARN, THUD_BOLD);
    for (int side = 0; side < 2; side++) {
        double x = stage->left[s] + (side ? stage->body - 1.0 - half : half);
        if (structure->isolator_law == THUD_ISOLATOR_PENDULUM) {
            thud_dots_line(&stage->dots, x - half, ground + 1.0, x + half, ground + 1.0, 1, look);
            thud_dots_line(&stage->dots, x - half, ground + 1.0, x - half, ground, 1, look);
            thud_dots_line(&stage->dots, x + half, ground + 1.0, x + half, ground, 1, look);
            thud_dots_line(&stage->dots, x + shift, ground, x + shift, slab, 1, look);
        } else {
            for (double at = -0.5 * half; at <= 0.5 * half; at += 1.0)
                thud_dots_line(&stage->dots, x + at, ground + 1.0, x + at + shift, slab, 1, look);
        }
    }
}

/* The foundation on soil, swayed and turned with its building: at a right angle to it where both are to scale. */
static void draw_foundation(struct stage *stage, const struct thud_model_structure *part, double x0, double ground)
{
    const int sway = part->first + part->n;
    const double x = x0 + stage->shift[sway], right = stage->body - 1.0,
                 height = stage->storey * part->arm_m, /* dots */
        dip = fmin(3.0, fmax(-3.0, 0.5 * (right + 4.0) * stage->shift[sway + 1] / fmax(height, 1.0)));
    for (int thick = 0; thick < 2; thick++)
        thud_dots_line(&stage->dots, x - 2.0, ground + 1.0 + thick - dip, x + right + 2.0, ground + 1.0 + thick + dip,
                       1, thud_look(THUD_ROLE_WARN, 0));
}

static void draw_building(struct stage *stage, int s)
{
    const struct thud_structure *structure = &stage->scene->structure[s];
    const struct thud_model_structure *part = &stage->model->structure[s];
    struct thud_look look = thud_look(THUD_ROLE_SERIES + s % 7, 0);
    double base, roof, x0 = stage->left[s], right = stage->body - 1.0;
    extent(structure, &base, &roof);
    double y0 = row_of(stage, base);
    if (structure->kind == THUD_WALL) { /* without a height it has no end */
        double top = isfinite(roof) ? fmin(y0 - 2.0, row_of(stage, roof)) : 1.0;
        x0 += thud_wall_gives(structure) ? stage->shift[part->first] : 0.0;
        draw_box(stage, x0, fmax(1.0, top), x0 + right, y0, look);
        return;
    }
    if (structure->kind == THUD_RIGID) {
        double x = x0 + stage->shift[part->first];
        double y = isfinite(roof) ? fmin(y0 - 4.0, row_of(stage, roof)) : 1.0;
        draw_box(stage, x, fmax(1.0, y), x + right, y0 - 1.0, look);
        return;
    }
    /* a slab on isolators stands on them, so that they are seen */
    double before = part->rise ? stage->shift[part->first + part->n] : 0.0,
           lift = thud_isolator_slides(structure) ? 4.0 : structure->kind == THUD_ISOLATED;
    if (part->rise)
        draw_foundation(stage, part, x0, y0);
    else
        thud_dots_line(&stage->dots, x0 - 2.0, y0 + 1.0, x0 + right + 2.0, y0 + 1.0, 1, thud_look(THUD_ROLE_BORDER, 0));
    for (int i = 0; i < part->n; i++) {
        double x = stage->shift[part->first + i],
               y = row_of(stage, thud_structure_elevation(structure, i)) - (i == 0 ? lift : 0.0);
        if (thud_isolator_slides(structure) && i == 0)
            draw_isolators(stage, s, y0, y);
        else
            draw_storey(stage, s, i, (struct storey){x0 + before, y0, x0 + x, y}, look);
        thud_dots_line(&stage->dots, x0 + x, y, x0 + right + x, y, 1, look);
        before = x;
        y0 = y;
    }
}

/* Bumpers project from the structure on the right, as far as the other one lets them. */
static void draw_contact(struct stage *stage, int index, int *worst, double *force)
{
    const struct thud_model_contact *contact = &stage->model->contact[index];
    const struct thud_interface *at = &stage->scene->interface[contact->interface - 1];
    int left = contact->interface - 1;
    double y = contact_row(stage, contact);
    double a = stage->left[left] + stage->body - 1.0 + side_shift(stage, &contact->left);
    double b = stage->left[left + 1] + side_shift(stage, &contact->right);
    double now = force_at(stage->history, index, stage->t);
    bool flash = now > touch_n;
    if (stage->bumper && at->has_bumper) {
        double out = stage->scale * (at->bumper_thickness_m - at->bumper_cavity_m);
        struct thud_look rubber = thud_look(flash ? THUD_ROLE_ERROR : THUD_ROLE_SERIES + 3, THUD_BOLD);
        double face = fmax(a + 1.0, b - out);
        for (int thick = -1; thick <= 1 && face <= b - 1.0; thick++)
            thud_dots_line(&stage->dots, face, y + thick, b - 1.0, y + thick, 1, rubber);
    }
    if (flash && now > *force) {
        *force = now;
        *worst = index;
    }
}

/* Where an end of a link is drawn; that of one that moves with the ground on the edge of its neighbour's. */
static double link_edge(const struct stage *stage, int dof, int other, bool right)
{
    int s = dof >= 0 ? stage->model->dof_structure[dof] : stage->model->dof_structure[other] + (right ? 1 : -1);
    return stage->left[s] + (right ? 0.0 : stage->body - 1.0) + (dof >= 0 ? stage->shift[dof] : 0.0);
}

static double link_row(const struct stage *stage, int dof)
{
    int s = stage->model->dof_structure[dof];
    double level = thud_structure_elevation(&stage->scene->structure[s], dof - stage->model->structure[s].first);
    return fmax(1.0, isfinite(level) ? row_of(stage, level) : stage->ground - 4.0);
}

/* Three strokes behind the wall, bright while it presses on its soil. */
static void draw_soil(struct stage *stage, int s, double force)
{
    const int dof = stage->model->structure[s].first;
    const bool first = s == 0;
    const double x = stage->left[s] + stage->shift[dof] + (first ? -1.0 : stage->body);
    const struct thud_look look =
        fabs(force) > touch_n ? thud_look(THUD_ROLE_SERIES + 5, THUD_BOLD) : thud_look(THUD_ROLE_MUTED, 0);
    for (int k = 0; k < 3; k++) {
        const double y = fmax(1.0, stage->ground - 3.0 * k);
        thud_dots_line(&stage->dots, x, y, x + (first ? -3.0 : 3.0), fmax(1.0, y - 2.0), 1, look);
    }
}

/* From edge to edge; one-sided ones are bright while they act, and muted while they hang loose. */
static void draw_link(struct stage *stage, int index)
{
    const struct thud_model_link *link = &stage->model->link[index];
    const double force = value_at(stage->history, thud_history_link_force(stage->history, index), stage->t);
    const int some = link->left_dof >= 0 ? link->left_dof : link->right_dof;
    if (link->contact >= 0 && stage->model->contact[link->contact].law == &thud_law_backfill) {
        draw_soil(stage, stage->model->dof_structure[some], force);
        return;
    }
    const bool loose = link->contact >= 0 && fabs(force) <= touch_n;
    const double y0 = link_row(stage, link->left_dof >= 0 ? link->left_dof : some),
                 y1 = link_row(stage, link->right_dof >= 0 ? link->right_dof : some);
    thud_dots_line(&stage->dots, link_edge(stage, link->left_dof, link->right_dof, false), y0 + 1.0,
                   link_edge(stage, link->right_dof, link->left_dof, true), y1 + 1.0, 1,
                   loose ? thud_look(THUD_ROLE_MUTED, 0) : thud_look(THUD_ROLE_SERIES + 5, THUD_BOLD));
}

static void flashes(struct stage *stage)
{
    for (int i = 0; i < stage->model->npairs; i++) {
        const struct thud_model_contact *contact = &stage->model->contact[i];
        if (!(force_at(stage->history, i, stage->t) > touch_n))
            continue;
        double a = stage->left[contact->interface - 1] + stage->body - 1.0 + side_shift(stage, &contact->left);
        thud_pane_glyph(&stage->dots.pane, (int)((a + 1.0) / stage->dots.across),
                        (int)(contact_row(stage, contact) / stage->dots.down),
                        thud_look(THUD_ROLE_ERROR, THUD_BOLD | THUD_REVERSE), '*');
    }
}

/* The contact with the largest force now, in the first row. */
static void say_contact(struct stage *stage, const struct thud_pane *pane, int worst, double force)
{
    if (worst < 0)
        return;
    const struct thud_model_contact *contact = &stage->model->contact[worst];
    double depth = value_at(stage->history, thud_history_indentation(stage->history, worst), stage->t);
    char text[80], name[32];
    if (contact->struck)
        thud_contact_pair_name(contact->left_floor, contact->right_floor, contact->struck, name, sizeof name);
    else
        snprintf(name, sizeof name, "%d", contact->left_floor > 0 ? contact->left_floor : contact->right_floor);
    snprintf(text, sizeof text, "*%s %.3g MN %.3g mm", name, 1e-6 * force, 1e3 * depth);
    thud_pane_right(pane, pane->w, 0, thud_look(THUD_ROLE_ERROR, THUD_BOLD), text);
}

static struct thud_pane stage_pane(const struct thud_pane *pane)
{
    return thud_pane_inside(pane, 0, 1, pane->w, pane->h - 1 - (pane->h >= 7));
}

int thud_storey_at(const struct thud_structure *structure, double level_m)
{
    int best = 0, slabs = thud_structure_floors(structure) - structure->storeys;
    for (int i = 1; i <= structure->storeys; i++)
        if (!best || fabs(thud_structure_elevation(structure, i - 1 + slabs) - level_m) <
                         fabs(thud_structure_elevation(structure, best - 1 + slabs) - level_m))
            best = i;
    return best;
}

int thud_movement_floor(const struct thud_pane *pane, const struct thud_scene *scene, const struct thud_model *model,
                        const struct thud_run *run, int x, int y, int *structure)
{
    struct stage stage = {
        .scene = scene, .model = model, .history = thud_run_history(run), .result = thud_run_result(run)};
    struct thud_pane area = stage_pane(pane);
    int floor = 0;
    if (thud_dots_init(&stage.dots, &area, NULL) != THUD_OK)
        return 0;
    for (int s = 0; s < scene->nstructures && floor == 0 && set_stage(&stage); s++) {
        double at = (x + 0.5) * stage.dots.across,
               level = stage.low_m + (stage.ground - (y - 0.5) * stage.dots.down) / stage.storey;
        bool inside = at >= stage.left[s] - stage.dots.across && at < stage.left[s] + stage.body + stage.dots.across;
        *structure = s;
        floor =
            inside && thud_kind_is_building(scene->structure[s].kind) ? thud_storey_at(&scene->structure[s], level) : 0;
    }
    thud_dots_clear(&stage.dots);
    return floor;
}

void thud_movement_draw(const struct thud_pane *pane, const struct thud_scene *scene, const struct thud_model *model,
                        const struct thud_run *run, bool bumper, double t)
{
    const struct thud_history *history = thud_run_history(run);
    struct stage stage = {
        .scene = scene, .model = model, .history = history, .result = thud_run_result(run), .t = t, .bumper = bumper};
    bool roomy = pane->h >= 7;
    struct thud_pane area = stage_pane(pane);
    struct thud_pane below = thud_pane_inside(pane, 1, pane->h - 1, pane->w - 1, 1);
    int worst = -1;
    double force = 0.0;
    if (area.w < 12 || area.h < 2 || history->rows == 0 || thud_dots_init(&stage.dots, &area, NULL) != THUD_OK)
        return;
    stage.shift = calloc((size_t)(model->ndof > 0 ? model->ndof : 1), sizeof *stage.shift);
    if (stage.shift && set_stage(&stage)) {
        set_shifts(&stage);
        for (int s = 0; s < scene->nstructures; s++)
            draw_building(&stage, s);
        for (int i = 0; i < model->npairs; i++)
            draw_contact(&stage, i, &worst, &force);
        for (int i = 0; i < model->nlinks; i++)
            draw_link(&stage, i);
        struct thud_look ground = thud_look(THUD_ROLE_BORDER, 0);
        thud_dots_line(&stage.dots, 0.0, stage.ground + 1.0, stage.dots.width - 1.0, stage.ground + 1.0, 1, ground);
        thud_dots_put(&stage.dots);
        flashes(&stage);
        say_contact(&stage, pane, worst, force);
        if (roomy)
            draw_scale(&stage, &below);
    } else {
        thud_pane_put(pane, 0, 1, thud_look(THUD_ROLE_MUTED, 0), "more room is needed");
    }
    free(stage.shift);
    thud_dots_clear(&stage.dots);
}
