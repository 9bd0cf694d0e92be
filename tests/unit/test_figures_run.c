/* Figures of runs show the histories' own numbers, converted to shown units. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "plot/figures/figures_case.h"
#include "plot/figures/figures_floor.h"
#include "plot/figures/figures_run.h"
#include "plot/figures/figures_scene.h"
#include "plot/gnuplot/gnuplot.h"
#include "study/scene/level.h"

/* Two buildings of 3 and 9 floors and a made-up run with one impact at 5 s on floor 2. */
enum { LEFT = 3, RIGHT = 9, DOFS = LEFT + RIGHT, CONTACTS = 3, ROWS = 1001 };

struct sample {
    struct thud_scene scene;
    struct thud_floor_result floor[DOFS];
    struct thud_structure_result structure[2];
    struct thud_contact_result contact[CONTACTS];
    struct thud_storey_result storey[LEFT]; /* of the left building: the two lower ones yield */
    struct thud_result result;
    struct thud_history history;
    struct thud_impact impact;
    double time[ROWS], *value;
    struct thud_figure_source source;
};

static double force_at(int i)
{
    return i > 500 && i < 520 ? 2e6 * sin((i - 500) * THUD_PI / 20) : 0.0;
}

static struct sample *make(void)
{
    struct sample *s = calloc(1, sizeof *s);
    strcpy(s->scene.title, "Two towers");
    s->scene.interface[0].gap_m = 0.1;
    s->scene.nstructures = 2;
    for (int k = 0; k < 2; k++) {
        strcpy(s->scene.structure[k].name, k ? "B" : "A");
        s->scene.structure[k].storeys = k ? RIGHT : LEFT;
        for (int f = 0; f < RIGHT; f++)
            s->scene.structure[k].height_m[f] = 3.0;
        s->structure[k] =
            (struct thud_structure_result){.floors = k ? RIGHT : LEFT, .floor = s->floor + (k ? LEFT : 0)};
    }
    for (int d = 0; d < DOFS; d++)
        s->floor[d] = (struct thud_floor_result){.acceleration = {d + 1.0, 0},
                                                 .displacement = {0.01 * (d + 1), 0},
                                                 .velocity = {0.1 * (d + 1), 0},
                                                 .drift = {1e-3 * (d + 1), 0}};
    for (int f = 0; f < 2; f++)
        s->storey[f] = (struct thud_storey_result){
            .yields = true, .ductility = 4 - f, .permanent_m = 1e-3 * (f + 1), .hysteretic_j = 1e3, .shear = {8e6, 1}};
    s->structure[0].storey = s->storey;
    for (int c = 0; c < CONTACTS; c++)
        s->contact[c] = (struct thud_contact_result){.interface = 1, .left_floor = c + 1, .right_floor = c + 1};
    s->contact[1].impacts = 1;
    s->contact[1].force.value = 2e6;
    s->impact = (struct thud_impact){.contact = 1, .start_s = 5.0, .duration_s = 0.2, .force_n = 2e6};
    s->result = (struct thud_result){
        .nstructures = 2, .ncontacts = CONTACTS, .structure = s->structure, .contact = s->contact, .end_s = 10.0};
    struct thud_history *h = &s->history;
    *h = (struct thud_history){
        .ndof = DOFS, .ncontacts = CONTACTS, .nstoreys = 2, .loses = true, .rows = ROWS, .time_s = s->time};
    thud_history_lay_out(h);
    h->value = s->value = calloc((size_t)ROWS * (size_t)h->columns, sizeof *s->value);
    for (int i = 0; i < ROWS; i++) {
        double *row = s->value + i * h->columns;
        s->time[i] = 0.01 * i;
        for (int d = 0; d < DOFS; d++) {
            row[thud_history_displacement(h, d)] = 0.01 * (d + 1) * sin(s->time[i]);
            row[thud_history_velocity(h, d)] = 0.1 * (d + 1) * cos(s->time[i]);
            row[thud_history_acceleration(h, d)] = -(d + 1) * sin(s->time[i]);
        }
        row[thud_history_force(h, 1)] = force_at(i);
        row[thud_history_indentation(h, 1)] = force_at(i) > 0.0 ? force_at(i) / 1e9 : -1e-3 * abs(i - 510) / 10.0;
        for (int e = 0; e < THUD_HISTORY_ENERGIES; e++)
            row[thud_history_energy(h, e)] = 1e3 * (e + 1) * s->time[i];
        row[thud_history_hysteretic(h, 0)] = 7e3 * s->time[i];
        for (int k = 0; k < 2; k++) {
            row[thud_history_storey_drift(h, k)] = 1e-3 * (k + 1) * s->time[i];
            row[thud_history_storey_shear(h, k)] = 2e6 * (k + 1) * sin(s->time[i]);
        }
    }
    s->source = (struct thud_figure_source){"bumper", THUD_CASE_BUMPER, &s->scene, &s->result, h, &s->impact, 1, false};
    return s;
}

static void drop(struct sample *s)
{
    free(s->value);
    free(s);
}

START_TEST(histories_show_floors_in_their_units)
{
    static const enum thud_run_figure which[] = {THUD_FIGURE_VELOCITY, THUD_FIGURE_ACCELERATION,
                                                 THUD_FIGURE_DISPLACEMENT, THUD_FIGURE_DRIFT};
    struct sample *s = make();
    for (int w = 0; w < 4; w++) {
        ck_assert(thud_run_figure_has(which[w], &s->source, 1));
        struct thud_figure *figure = thud_run_figure(which[w], &s->source, 1);
        ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
        ck_assert(figure->rows == DOFS && figure->columns == 2); /* a strip for each floor, the highest first */
        const struct thud_panel *a = &figure->panel[2 * (LEFT - 2)], *zoom = &figure->panel[1];
        ck_assert(a->strip && a->nseries == 1);
        ck_assert_str_eq(a->title, which[w] == THUD_FIGURE_DRIFT ? "A, storey 2" : "A, floor 2");
        ck_assert_str_eq(figure->panel[2 * LEFT].title, which[w] == THUD_FIGURE_DRIFT ? "B, storey 9" : "B, floor 9");
        ck_assert(a->axis[THUD_Y].least == figure->panel[2 * LEFT].axis[THUD_Y].least);
        ck_assert_ptr_nonnull(strstr(figure->title, "bumper, gap 10 cm"));
        int i = 321, dof = 1;
        const double want[] = {0.1 * (dof + 1) * cos(3.21), -(dof + 1) * sin(3.21) / THUD_GRAVITY,
                               100 * 0.01 * (dof + 1) * sin(3.21), 1000 * 0.01 * sin(3.21)};
        ck_assert_msg(fabs(a->series[0]->y[i] - want[w]) < 1e-9, "%d: %g %g", w, a->series[0]->y[i], want[w]);
        ck_assert(zoom->axis[THUD_X].least < 5.0 && zoom->axis[THUD_X].most > 5.2 && zoom->axis[THUD_X].most < 7.0);
        thud_figure_free(figure);
    }
    drop(s);
}
END_TEST

/* Masses and slabs stand at the elevations of the floors, gap and bumper have one factor, and the figure says what it
 * shows. */
START_TEST(a_scene_is_drawn_to_scale)
{
    struct sample *s = make();
    const struct thud_scene *scene = s->source.scene;
    struct thud_figure *figure = thud_figure_of_scene(scene, "scene", "");
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    int masses = 0, floors = 0;
    for (int b = 0; b < scene->nstructures; b++) {
        const int n = thud_structure_floors(&scene->structure[b]);
        for (int f = 0; f < n; f++) {
            bool found = false;
            for (int i = 0; i < figure->panel[1].nseries; i++) {
                const struct thud_series *dot = figure->panel[1].series[i];
                found |= strcmp(dot->name, "mass") == 0 &&
                         fabs(dot->y[0] - thud_structure_elevation(&scene->structure[b], f)) < 1e-12;
            }
            ck_assert_msg(found, "%d %d", b, f);
        }
        floors += n;
    }
    for (int i = 0; i < figure->panel[1].nseries; i++)
        masses += strcmp(figure->panel[1].series[i]->name, "mass") == 0;
    ck_assert_int_eq(masses, floors);
    struct thud_text words = {0};
    thud_figure_words(figure, &words);
    ck_assert_ptr_nonnull(strstr(words.data, "a drawing of"));
    thud_text_clear(&words);
    thud_figure_free(figure);
    drop(s);
}
END_TEST

/* A slab that strikes columns is shown on them, at the middle of its depth, in the elevation and in the model; the gap
 * stands in the elevation alone, and the ground under each building where that stands. */
START_TEST(a_drawing_shows_where_columns_are_struck)
{
    struct sample *s = make();
    for (int f = 0; f < LEFT; f++) {
        s->scene.structure[0].height_m[f] = 3.6;
        s->scene.structure[0].slab_depth_m[f] = s->scene.structure[1].slab_depth_m[f] = 0.4;
    }
    s->scene.structure[0].storeys = s->scene.structure[1].storeys = 1;
    thud_interface_init(&s->scene.interface[0]);
    s->scene.interface[0].gap_m = 0.1;
    s->scene.structure[1].base_m = 0.9;
    s->scene.structure[1].height_m[0] -= 0.9;
    struct thud_figure *figure = thud_figure_of_scene(&s->scene, "scene", "");
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    for (int p = 0; p < 2; p++) {
        int grounds[2] = {0, 0};
        const struct thud_series *struck = NULL, *columns = NULL;
        bool gap = false;
        for (int i = 0; i < figure->panel[p].nseries; i++) {
            const struct thud_series *one = figure->panel[p].series[i];
            for (int b = 0; b < 2 && *one->name == '\0' && one->n == 2; b++)
                grounds[b] += one->y[0] == one->y[1] && one->y[0] == s->scene.structure[b].base_m;
            if (strcmp(one->name, "columns are struck here") == 0)
                struck = one;
            else if (strcmp(one->name, "columns") == 0 && !columns)
                columns = figure->panel[p].series[i + 1]; /* on the right of A */
        }
        for (int i = 0; i < figure->panel[p].nlabels; i++)
            gap |= strcmp(figure->panel[p].label[i].text, "gap 10 cm") == 0;
        ck_assert_msg(struck && gap == (p == 0), "panel %d", p);
        ck_assert(grounds[0] == 1 && grounds[1] == 1);
        ck_assert(struck->n == 1 && fabs(struck->y[0] - (3 - 0.2)) < 1e-12);
        ck_assert(p == 1 || struck->x[0] == columns->x[0]);
    }
    thud_figure_free(figure);
    drop(s);
}
END_TEST

/* Floors that move less than a wall that is struck have a scale of their own, one for all of them. */
START_TEST(walls_do_not_set_the_scale_of_floors)
{
    struct sample *s = make();
    s->scene.structure[1].kind = THUD_WALL;
    s->structure[1].floors = 1; /* the fourth dof */
    struct thud_figure *figure = thud_run_figure(THUD_FIGURE_ACCELERATION, &s->source, 1);
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    ck_assert_int_eq(figure->rows, LEFT + 1);
    const double *floors = &figure->panel[0].axis[THUD_Y].most, *wall = &figure->panel[2 * LEFT].axis[THUD_Y].most;
    ck_assert(*floors > 3 / THUD_GRAVITY && *floors < 4 / THUD_GRAVITY + 1e-9 && *wall > 4 / THUD_GRAVITY);
    for (int r = 1; r < LEFT; r++)
        ck_assert(figure->panel[2 * r].axis[THUD_Y].most == *floors);
    ck_assert(figure->panel[2 * LEFT + 1].axis[THUD_Y].most == *wall); /* the closer look too */
    ck_assert_ptr_nonnull(strstr(figure->note, "Walls have scales of their own."));
    thud_figure_free(figure);
    s->scene.structure[0].kind = THUD_ISOLATED; /* beside drifts isolators stand apart, and walls have none */
    s->scene.structure[0].storeys = LEFT - 1;
    s->floor[0].drift.value = 0.5;
    for (int i = 0; i < ROWS; i++)
        for (int d = 0; d < LEFT; d++)
            s->value[i * s->history.columns + thud_history_displacement(&s->history, d)] += 0.49 * sin(s->time[i]);
    figure = thud_run_figure(THUD_FIGURE_DRIFT, &s->source, 1);
    ck_assert_int_eq(figure->rows, LEFT);
    ck_assert(figure->panel[4].axis[THUD_Y].most > 500 && figure->panel[0].axis[THUD_Y].most < 100);
    ck_assert_ptr_nonnull(strstr(figure->note, "Isolators have scales of their own."));
    thud_figure_free(figure);
    figure = thud_run_figure(THUD_FIGURE_ENVELOPE, &s->source, 1);
    ck_assert(isnan(figure->panel[2].series[0]->x[0]) && figure->panel[2].axis[THUD_X].most < 10);
    thud_figure_free(figure);
    drop(s);
}
END_TEST

START_TEST(walls_do_not_set_the_scale_of_spectra)
{
    struct sample *s = make();
    double period[] = {0.1, 1}, sa[] = {10, 5, 500, 5, 20, 5, 600, 5}, peak[4] = {0};
    struct thud_floor_place floor[] = {{0, 0}, {1, 0}};
    struct thud_floor_spectra spectra = {.nperiods = 2,
                                         .nfloors = 2,
                                         .ncases = 2,
                                         .damping = 0.05,
                                         .period_s = period,
                                         .floor = floor,
                                         .sa_mps2 = sa,
                                         .peak_mps2 = peak};
    s->scene.structure[1].kind = THUD_WALL;
    struct thud_figure *figure = thud_figure_of_floors(&s->scene, &spectra);
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    ck_assert(figure->panel[0].axis[THUD_Y].most < 5 && figure->panel[1].axis[THUD_Y].most > 60);
    thud_figure_free(figure);
    drop(s);
}
END_TEST

/* A wall that gives is a mass between its own spring and the soil's, each with its number; not a part of the ground,
 * also where it has no height. */
START_TEST(a_wall_that_gives_is_drawn_with_what_holds_it)
{
    struct sample *s = make();
    static struct thud_scene scene;
    scene = *s->source.scene;
    struct thud_structure *wall = &scene.structure[1];
    wall->kind = THUD_WALL;
    wall->wall_mass_kg = 27e3;
    wall->wall_stiffness_npm = 40e6;
    for (int i = 0; i < 3; i++) {
        const int soil = i == 1;
        wall->height_m[0] = i < 2 ? 3 : INFINITY;
        wall->backfill_stiffness_npm = soil ? 304.5e6 : NAN;
        wall->backfill_strength_n = soil ? 4.89e6 : NAN;
        wall->backfill_ratio = wall->backfill_gap_m = NAN;
        struct thud_figure *figure = thud_figure_of_scene(&scene, "scene", "");
        ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
        struct thud_text script = {0};
        const struct thud_picture_options options = {.format = THUD_SVG};
        ck_assert_int_eq(thud_gnuplot_script(figure, &options, NULL, &script, NULL), THUD_OK);
        ck_assert_ptr_nonnull(strstr(script.data, "27 t"));
        ck_assert_ptr_nonnull(strstr(script.data, "40 MN/m"));
        ck_assert(!strstr(script.data, "304.5 MN/m") == !soil);
        ck_assert(!strstr(script.data, "soil behind the wall") == !soil);
        ck_assert_ptr_null(strstr(script.data, "moves with the ground"));
        ck_assert_ptr_null(strstr(script.data, "inf"));
        thud_text_clear(&script);
        thud_figure_free(figure);
    }
    drop(s);
}
END_TEST

/* Masses and stiffnesses of a tall building stand apart from each other: 14 lines have room in the height of the
 * drawing. */
START_TEST(numbers_of_a_tall_building_stand_apart)
{
    struct sample *s = make();
    static struct thud_scene scene;
    scene = *s->source.scene;
    struct thud_error err;
    for (int storeys = 3; storeys <= 40; storeys += 37) {
        char text[16];
        snprintf(text, sizeof text, "%d", storeys);
        ck_assert_int_eq(thud_scene_set(&scene, "structures.1.storeys", text, &err), THUD_OK);
        ck_assert_int_eq(thud_scene_set(&scene, "structures.2.storeys", text, &err), THUD_OK);
        struct thud_figure *figure = thud_figure_of_scene(&scene, "scene", "");
        const struct thud_panel *model = &figure->panel[1];
        double nearest = INFINITY, low = INFINITY, high = -INFINITY;
        int of_first = 0;
        for (int i = 0; i < model->nlabels; i++) {
            low = fmin(low, model->label[i].y), high = fmax(high, model->label[i].y);
            of_first += model->label[i].x == model->label[0].x;
            for (int k = 0; k < i; k++)
                if (model->label[i].x == model->label[k].x)
                    nearest = fmin(nearest, fabs(model->label[i].y - model->label[k].y));
        }
        ck_assert_int_ge(of_first, 6);
        ck_assert_double_ge(nearest, 0.05 * (high - low));
        ck_assert_int_le(of_first, 14);
        thud_figure_free(figure);
    }
    drop(s);
}
END_TEST

START_TEST(forces_and_loops_show_contacts)
{
    struct sample *s = make();
    struct thud_figure *figure = thud_run_figure(THUD_FIGURE_FORCE, &s->source, 1);
    const struct thud_panel *panel = &figure->panel[0];
    ck_assert_int_eq(figure->rows, 1); /* the others never touched */
    ck_assert_str_eq(panel->title, "floor 2");
    ck_assert_str_eq(panel->axis[THUD_Y].unit, "MN");
    ck_assert(fabs(panel->series[0]->y[510] - 2.0) < 1e-6);
    thud_figure_free(figure);
    figure = thud_run_figure(THUD_FIGURE_LOOP, &s->source, 1);
    const struct thud_series *loop = figure->panel[0].series[0];
    ck_assert_uint_ge(loop->n, 19);
    ck_assert_uint_le(loop->n, 23);
    for (size_t i = 0; i < loop->n; i++) /* 1 MN is 1 mm here, and rows out of contact are no part of it */
        ck_assert(isnan(loop->x[i]) || fabs(loop->x[i] - loop->y[i]) < 1e-9);
    thud_figure_free(figure);
    s->source.nimpacts = 0;
    ck_assert(!thud_run_figure_has(THUD_FIGURE_LOOP, &s->source, 1));
    drop(s);
}
END_TEST

START_TEST(storeys_that_yield_show_their_loops)
{
    struct sample *s = make();
    ck_assert(thud_run_figure_has(THUD_FIGURE_HYSTERESIS, &s->source, 1));
    struct thud_figure *figure = thud_run_figure(THUD_FIGURE_HYSTERESIS, &s->source, 1);
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    ck_assert(figure->rows == 1 && figure->columns == 2);
    ck_assert_str_eq(figure->panel[1].title, "A, storey 2");
    ck_assert_double_eq_tol(figure->panel[1].series[0]->x[500], 10.0, 1e-9);         /* mm */
    ck_assert_double_eq_tol(figure->panel[1].series[0]->y[500], 4 * sin(5.0), 1e-9); /* MN */
    thud_figure_free(figure);
    s->scene.structure[0].base_m = 1.5;
    figure = thud_run_figure(THUD_FIGURE_PERMANENT, &s->source, 1);
    ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
    ck_assert(figure->rows == 1 && figure->columns == 2);
    const struct thud_series *ductility = figure->panel[0].series[0], *left = figure->panel[1].series[0];
    ck_assert(ductility->n == 2 * LEFT && ductility->x[2] == 3.0 && ductility->y[2] == 4.5 && ductility->y[3] == 7.5);
    ck_assert(isnan(ductility->x[4]) && left->x[0] == 1.0 && left->x[3] == 2.0); /* the highest storey is elastic */
    thud_figure_free(figure);
    figure = thud_run_figure(THUD_FIGURE_ENERGY, &s->source, 1);
    ck_assert_str_eq(figure->panel[0].series[THUD_HISTORY_ENERGIES]->name, "yielding");
    thud_figure_free(figure);
    s->structure[0].storey = NULL;
    ck_assert(!thud_run_figure_has(THUD_FIGURE_HYSTERESIS, &s->source, 1));
    ck_assert(!thud_run_figure_has(THUD_FIGURE_PERMANENT, &s->source, 1));
    drop(s);
}
END_TEST

/* Whether every curve of a name has the case's colour, and there is one of each case. */
static void expect_colors(const struct thud_figure *figure, const struct thud_figure_source *source, int n)
{
    for (int i = 0; i < n; i++) {
        int found = 0;
        for (int p = 0; p < figure->rows * figure->columns; p++)
            for (int k = 0; k < figure->panel[p].nseries; k++) {
                const struct thud_series *series = figure->panel[p].series[k];
                const char *strip = strrchr(figure->panel[p].title, ':');
                if (strcmp(strip ? strip + 2 : series->name, source[i].name) != 0)
                    continue;
                ck_assert_int_eq(series->style.color, thud_case_color(source[i].which));
                found++;
            }
        ck_assert_msg(found > 0, "%s: %s", figure->name, source[i].name);
    }
}

/* Histories stand one above the other, a case in each strip; what is no history has a curve for each case. The order of
 * the cases does not change their colours. */
START_TEST(several_runs_keep_their_colours)
{
    struct sample *s = make();
    struct thud_figure_source both[2] = {s->source, s->source};
    both[1].which = THUD_CASE_NONE;
    both[1].name = thud_case_title(0, THUD_CASE_NONE);
    for (int w = 0; w < THUD_RUN_FIGURES; w++) {
        if (w == THUD_FIGURE_COLUMNS) /* floors meet floors here */
            continue;
        struct thud_figure *figure = thud_run_figure((enum thud_run_figure)w, both, 2);
        ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
        const struct thud_series *key[20];
        int n = thud_figure_key(figure, key, 20);
        if (w <= THUD_FIGURE_DRIFT) {
            ck_assert_int_eq(n, 0);
            for (int p = 0; p < figure->rows * figure->columns; p++)
                ck_assert_int_eq(figure->panel[p].nseries, 1);
        } else if (w != THUD_FIGURE_ENERGY)
            ck_assert_int_eq(n, 2);
        if (w != THUD_FIGURE_ENERGY)
            expect_colors(figure, both, 2);
        thud_figure_free(figure);
    }
    drop(s);
}
END_TEST

/* Each case has a name, a colour and dashes of its own. */
START_TEST(cases_differ_without_their_colours)
{
    struct thud_figure *figure = thud_figure_create("x", "", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    enum { CASES = THUD_CASES - THUD_CASE_FREE };
    struct thud_text script = {0};
    const struct thud_picture_options options = {.format = THUD_SVG};
    char style[CASES][80] = {{0}};
    for (int i = 0; i < CASES; i++) {
        const enum thud_case which = (enum thud_case)(i + THUD_CASE_FREE);
        thud_panel_add(panel, (struct thud_style){.color = thud_case_color(which)}, thud_case_title(0, which), 2,
                       (double[]){0, 1}, (double[]){i, i});
    }
    ck_assert_int_eq(thud_gnuplot_script(figure, &options, NULL, &script, NULL), THUD_OK);
    for (int i = 0; i < CASES; i++) {
        char block[32];
        snprintf(block, sizeof block, "$P1S%d using", i + 1);
        const char *at = strstr(script.data, block);
        ck_assert(at && (at = strstr(at, "lw")));
        snprintf(style[i], sizeof style[i], "%.*s", (int)strcspn(at, "#"), at); /* up to its colour */
        for (int k = 0; k < i; k++) {
            ck_assert_str_ne(style[i], style[k]);
            ck_assert_str_ne(thud_case_title(0, (enum thud_case)(i + THUD_CASE_FREE)),
                             thud_case_title(0, (enum thud_case)(k + THUD_CASE_FREE)));
        }
    }
    thud_text_clear(&script);
    thud_figure_free(figure);
}
END_TEST

/* Luma of Rec. 601, 0 to 255. */
static double grey(int color)
{
    const unsigned rgb = thud_color_rgb(color);
    return 0.299 * (rgb >> 16) + 0.587 * (rgb >> 8 & 0xff) + 0.114 * (rgb & 0xff);
}

/* Kinetic and strain energy follow each other many times, as do the loops of floors one above the other. */
START_TEST(curves_that_cross_are_apart_in_grey)
{
    struct sample *s = make();
    for (int c = 0; c < CONTACTS; c++) {
        s->contact[c].impacts = 1;
        s->contact[c].force.value = 2e6;
    }
    for (int w = 0; w < 2; w++) {
        struct thud_figure *figure = thud_run_figure(w ? THUD_FIGURE_LOOP : THUD_FIGURE_ENERGY, &s->source, 1);
        const struct thud_panel *panel = &figure->panel[0];
        ck_assert_int_eq(panel->nseries, w ? CONTACTS : THUD_HISTORY_ENERGIES + 1);
        for (int i = 1; i < panel->nseries; i++) {
            ck_assert_int_gt(panel->series[i]->style.color, panel->series[i - 1]->style.color); /* the key's order */
            ck_assert_double_gt(fabs(grey(panel->series[i]->style.color) - grey(panel->series[i - 1]->style.color)),
                                25);
        }
        thud_figure_free(figure);
    }
    drop(s);
}
END_TEST

/* Where a scene has bumper and links every case has its own name, which says of both whether they are there. */
START_TEST(cases_say_what_they_leave_out)
{
    const int both = THUD_HAS_BUMPER | THUD_HAS_LINKS;
    for (enum thud_case i = THUD_CASE_NONE; i <= THUD_CASE_WHOLE; i++) {
        for (enum thud_case k = THUD_CASE_FREE; k < i; k++) {
            ck_assert_str_ne(thud_case_title(both, i), thud_case_title(both, k));
            ck_assert_str_ne(thud_case_phrase(both, i), thud_case_phrase(both, k));
        }
        const char *words[] = {thud_case_title(both, i), thud_case_phrase(both, i)};
        for (int w = 0; w < 2; w++)
            ck_assert_msg(strstr(words[w], "bumper") && strstr(words[w], "links"), "%s", words[w]);
    }
    ck_assert_str_eq(thud_case_title(THUD_HAS_LINKS, THUD_CASE_NONE), "no links");
    ck_assert_str_eq(thud_case_title(THUD_HAS_BUMPER, THUD_CASE_NONE), "no bumper");
    ck_assert_str_eq(thud_case_title(0, THUD_CASE_WHOLE), "pounding");
}
END_TEST

START_TEST(envelopes_stand_over_the_height)
{
    struct sample *s = make();
    struct thud_figure *figure = thud_run_figure(THUD_FIGURE_ENVELOPE, &s->source, 1);
    const struct thud_series *acceleration = figure->panel[0].series[0], *drift = figure->panel[2].series[0];
    ck_assert_uint_eq(acceleration->n, LEFT + 1); /* and the ground */
    ck_assert(acceleration->x[0] == 0.0 && acceleration->y[0] == 0.0);
    ck_assert(fabs(acceleration->x[3] - 3.0 / THUD_GRAVITY) < 1e-12 && acceleration->y[3] == 9.0);
    const struct thud_panel *ratio = &figure->panel[3];
    ck_assert_str_eq(ratio->axis[THUD_X].label, "Drift ratio");
    ck_assert(fabs(ratio->series[0]->x[2] - 100 * 2e-3 / 3) < 1e-12); /* storey 2: 2 mm of 3 m */
    ck_assert(figure->panel[0].axis[THUD_Y].most >= 27 &&
              figure->panel[4].axis[THUD_Y].most == figure->panel[0].axis[THUD_Y].most); /* one height scale */
    ck_assert_uint_eq(drift->n, 2 * LEFT);
    ck_assert(drift->y[0] == 0.0 && drift->y[1] == 3.0 && drift->x[0] == drift->x[1]);
    const int rows = figure->rows;
    thud_figure_free(figure);
    s->scene.structure[1].kind = THUD_WALL; /* one that gives, of one height */
    figure = thud_run_figure(THUD_FIGURE_ENVELOPE, &s->source, 1);
    ck_assert(rows == 2 && figure->rows == 1);
    thud_figure_free(figure);
    drop(s);
}
END_TEST

START_TEST(rigid_bodies_have_no_deflections)
{
    struct sample *s = make();
    s->scene.structure[0].kind = s->scene.structure[1].kind = THUD_RIGID;
    ck_assert(!thud_run_figure_has(THUD_FIGURE_DRIFT, &s->source, 1));
    ck_assert(!thud_run_figure_has(THUD_FIGURE_ENVELOPE, &s->source, 1));
    ck_assert(thud_run_figure_has(THUD_FIGURE_VELOCITY, &s->source, 1));
    s->history.rows = 0;
    ck_assert(!thud_run_figure_has(THUD_FIGURE_VELOCITY, &s->source, 1));
    drop(s);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("figures_run");
    TCase *tcase = tcase_create("figures_run");
    tcase_add_test(tcase, cases_say_what_they_leave_out);
    tcase_add_test(tcase, histories_show_floors_in_their_units);
    tcase_add_test(tcase, a_scene_is_drawn_to_scale);
    tcase_add_test(tcase, a_drawing_shows_where_columns_are_struck);
    tcase_add_test(tcase, walls_do_not_set_the_scale_of_floors);
    tcase_add_test(tcase, walls_do_not_set_the_scale_of_spectra);
    tcase_add_test(tcase, a_wall_that_gives_is_drawn_with_what_holds_it);
    tcase_add_test(tcase, numbers_of_a_tall_building_stand_apart);
    tcase_add_test(tcase, forces_and_loops_show_contacts);
    tcase_add_test(tcase, several_runs_keep_their_colours);
    tcase_add_test(tcase, cases_differ_without_their_colours);
    tcase_add_test(tcase, curves_that_cross_are_apart_in_grey);
    tcase_add_test(tcase, storeys_that_yield_show_their_loops);
    tcase_add_test(tcase, envelopes_stand_over_the_height);
    tcase_add_test(tcase, rigid_bodies_have_no_deflections);
    suite_add_tcase(suite, tcase);
    return suite;
}
