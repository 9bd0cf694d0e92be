#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "study/level.h"
#include "tui/dots.h"
#include "tui/movement.h"

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
    double ground;                    /* row of the ground, dots */
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

static double height_of(const struct thud_structure *structure, int floors)
{
    double height = 0.0;
    if (structure->kind == THUD_WALL)
        return isfinite(structure->height_m[0]) ? structure->height_m[0] : 0.0;
    for (int i = 0; i < floors && i < structure->storeys; i++)
        height += structure->height_m[i];
    return height;
}

static double bounded_gap(const struct thud_scene *scene, int i)
{
    return fmax(0.0, scene->interface[i].gap_m);
}

/* Scales such that everything stays inside for the whole run. */
static bool set_stage(struct stage *stage)
{
    const struct thud_scene *scene = stage->scene;
    int n = scene->nstructures;
    double across = 0.0, top = 0.0;
    for (int s = 0; s < n; s++) {
        across += s + 1 < n ? bounded_gap(scene, s) : 0.0;
        top = fmax(top, height_of(&scene->structure[s], scene->structure[s].storeys));
    }
    double margin = fmax(reach(stage->result, 0), reach(stage->result, n - 1));
    across += 2.0 * margin;
    stage->body = floor(stage->dots.width / (2.6 * n)); /* the movement is what is looked at */
    double room = stage->dots.width - n * stage->body - 2.0;
    if (stage->body < 3.0 || room < 4.0 || stage->dots.height < 8)
        return false;
    stage->scale = across > 0.0 ? room / across : 0.0;
    stage->ground = stage->dots.height - 2.0;
    stage->storey = top > 0.0 ? (stage->ground - 1.0) / top : (stage->ground - 1.0) / 3.0;
    double at = 1.0 + stage->scale * margin;
    for (int s = 0; s < n; s++) {
        stage->left[s] = at;
        at += stage->body + (s + 1 < n ? stage->scale * bounded_gap(scene, s) : 0.0);
    }
    return true;
}

static double displacement(const struct stage *stage, int dof)
{
    return dof < 0 ? 0.0 : stage->shift[dof];
}

/* Displacements to scale. Where the concrete itself is pressed in, both sides give way by half of that: what the law
 * says is an indentation is no overlap of two buildings. */
static void set_shifts(struct stage *stage)
{
    for (int i = 0; i < stage->model->ndof; i++)
        stage->shift[i] =
            stage->scale * value_at(stage->history, thud_history_displacement(stage->history, i), stage->t);
    for (int i = 0; i < stage->model->ncontacts; i++) {
        const struct thud_model_contact *c = &stage->model->contact[i];
        double over = stage->left[c->interface - 1] + stage->body + displacement(stage, c->left_dof) -
                      stage->left[c->interface] - displacement(stage, c->right_dof);
        if (!(over > 0.0))
            continue;
        double part = c->left_dof >= 0 && c->right_dof >= 0 ? 0.5 : 1.0;
        if (c->left_dof >= 0)
            stage->shift[c->left_dof] -= part * over;
        if (c->right_dof >= 0)
            stage->shift[c->right_dof] += part * over;
    }
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
    char text[48];
    snprintf(text, sizeof text, "%g mm across", 1e3 * length);
    thud_pane_put(row, cells + 2, 0, look, text);
}

static void draw_box(struct stage *stage, double x0, double y0, double x1, double y1, struct thud_look look)
{
    thud_dots_line(&stage->dots, x0, y0, x1, y0, 1, look);
    thud_dots_line(&stage->dots, x0, y1, x1, y1, 1, look);
    thud_dots_line(&stage->dots, x0, y0, x0, y1, 1, look);
    thud_dots_line(&stage->dots, x1, y0, x1, y1, 1, look);
}

static void draw_building(struct stage *stage, int s)
{
    const struct thud_structure *structure = &stage->scene->structure[s];
    const struct thud_model_structure *part = &stage->model->structure[s];
    struct thud_look look = thud_look(THUD_ROLE_SERIES + s % 7, 0);
    double y0 = stage->ground, x0 = stage->left[s], right = stage->body - 1.0;
    if (structure->kind == THUD_WALL) { /* without a height it has no end */
        bool endless = !isfinite(structure->height_m[0]);
        double top = endless ? 1.0 : stage->ground - fmax(2.0, stage->storey * structure->height_m[0]);
        draw_box(stage, x0, fmax(1.0, top), x0 + right, y0, look);
        return;
    }
    if (structure->kind == THUD_RIGID) {
        double x = x0 + displacement(stage, part->first);
        double y = stage->ground - fmax(4.0, fmin(stage->ground - 1.0, stage->storey * structure->height_m[0]));
        draw_box(stage, x, y, x + right, y0 - 1.0, look);
        return;
    }
    double before = 0.0;
    for (int i = 0; i < part->n; i++) {
        int storeys = structure->kind == THUD_ISOLATED ? i : i + 1;
        double x = displacement(stage, part->first + i),
               y = stage->ground - stage->storey * height_of(structure, storeys) - (storeys == 0);
        thud_dots_line(&stage->dots, x0 + before, y0, x0 + x, y, 1, look);
        thud_dots_line(&stage->dots, x0 + right + before, y0, x0 + right + x, y, 1, look);
        thud_dots_line(&stage->dots, x0 + x, y, x0 + right + x, y, 1, look);
        before = x;
        y0 = y;
    }
}

/* Height of a contact above the ground, dots, taken on the side that is no wall. */
static double contact_row(const struct stage *stage, const struct thud_model_contact *contact)
{
    bool left = thud_slab_is_left(contact->left_floor, contact->struck);
    int s = left ? contact->interface - 1 : contact->interface;
    int floor = left ? contact->left_floor : contact->right_floor;
    const struct thud_structure *structure = &stage->scene->structure[s];
    int storeys = structure->kind == THUD_ISOLATED ? floor - 1 : floor;
    double height =
        structure->kind == THUD_RIGID ? 0.5 * fmin(structure->height_m[0], 3.0) : height_of(structure, storeys);
    return fmax(1.0, stage->ground - stage->storey * height);
}

/* Bumpers stand out from the structure on the right, as far as the other one lets them. */
static void draw_contact(struct stage *stage, int index, int *worst, double *force)
{
    const struct thud_model_contact *contact = &stage->model->contact[index];
    const struct thud_interface *at = &stage->scene->interface[contact->interface - 1];
    int left = contact->interface - 1;
    double y = contact_row(stage, contact);
    double a = stage->left[left] + stage->body - 1.0 + displacement(stage, contact->left_dof);
    double b = stage->left[left + 1] + displacement(stage, contact->right_dof);
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

static void flashes(struct stage *stage)
{
    for (int i = 0; i < stage->model->ncontacts; i++) {
        const struct thud_model_contact *contact = &stage->model->contact[i];
        if (!(force_at(stage->history, i, stage->t) > touch_n))
            continue;
        double a = stage->left[contact->interface - 1] + stage->body - 1.0 + displacement(stage, contact->left_dof);
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
    int floor = thud_slab_floor(contact->left_floor, contact->right_floor, contact->struck);
    char text[80];
    snprintf(text, sizeof text, "*%d %.3g MN %.3g mm", floor, 1e-6 * force, 1e3 * depth);
    thud_pane_right(pane, pane->w, 0, thud_look(THUD_ROLE_ERROR, THUD_BOLD), text);
}

void thud_movement_draw(const struct thud_pane *pane, const struct thud_scene *scene, const struct thud_model *model,
                        const struct thud_run *run, bool bumper, double t)
{
    const struct thud_history *history = thud_run_history(run);
    struct stage stage = {
        .scene = scene, .model = model, .history = history, .result = thud_run_result(run), .t = t, .bumper = bumper};
    bool roomy = pane->h >= 7;
    struct thud_pane area = thud_pane_inside(pane, 0, 1, pane->w, pane->h - 1 - roomy);
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
        for (int i = 0; i < model->ncontacts; i++)
            draw_contact(&stage, i, &worst, &force);
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
