/* Names, axes and notes of the figures of a study. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/statistics.h"
#include "plot/figures/figures_run.h"
#include "plot/figures/figures_sweep_internal.h"

/* In its own words, event and station; false where it says none, or what another of the study says too. */
static bool motion_name(const struct thud_sweep_table *table, int record, char text[128])
{
    const struct thud_record *own = table->motion ? table->motion[record] : NULL;
    if (!own || !*own->event || strcmp(thud_path_name(own->file), table->record[record]) != 0)
        return false;
    for (int r = 0; r < table->nrecords; r++) {
        const struct thud_record *other = table->motion[r];
        if (r != record && other && strcmp(other->event, own->event) == 0 && strcmp(other->station, own->station) == 0)
            return false;
    }
    snprintf(text, 128, "%s%s%.30s", own->event, *own->station ? ", " : "", own->station);
    text[0] = thud_ascii_upper(text[0]);
    return true;
}

const char *thud_sweep_record_name(const struct thud_sweep_table *table, int record, char text[128])
{
    if (table->motions > 0) {
        snprintf(text, 128, "%d ground motions", table->motions);
        return text;
    }
    if (motion_name(table, record, text))
        return text;
    const char *name = thud_path_name(table->record[record]), *dot = strrchr(name, '.');
    bool suffix = dot && dot > name && strlen(dot) <= 5 && !strchr(dot, ' ') && !thud_ascii_is_digit(dot[1]);
    size_t length = suffix ? (size_t)(dot - name) : strlen(name);
    if (length == 0)
        return "No ground motion";
    snprintf(text, 128, "%.*s", (int)(length < 127 ? length : 127), name);
    return text;
}

bool thud_sweep_is_drawn(const struct thud_sweep_table *table, const struct thud_sweep_summary *d, int free,
                         const int *at)
{
    for (int a = free; a < table->naxes; a++) {
        if (d->at[a] != (at ? at[a] : 0))
            return false;
    }
    return true;
}

bool thud_sweep_has_case(const struct thud_sweep_table *table, enum thud_case which)
{
    for (size_t i = 0; i < table->npoints; i++) {
        if (thud_sweep_summary_find(table->point[i], which) >= 0)
            return true;
    }
    return false;
}

int thud_sweep_floors(const struct thud_sweep_table *table, int structure)
{
    int most = 0;
    for (size_t i = 0; i < table->npoints; i++) {
        int floors = thud_sweep_summary_floors(table->point[i], structure);
        most = floors > most ? floors : most;
    }
    return most;
}

int thud_sweep_columns(const struct thud_sweep_table *table, int *structure)
{
    int n = 0;
    for (int s = 0; s < table->nstructures && n < THUD_SWEEP_COLUMNS_MAX; s++) {
        if (thud_sweep_floors(table, s) > 0)
            structure[n++] = s;
    }
    return n;
}

const char *thud_sweep_helps(const struct thud_sweep_table *table, enum thud_case which, char text[THUD_SWEEP_TITLE])
{
    const char *ending;
    const enum thud_case of = which == THUD_CASE_CAVITY ? THUD_CASE_BUMPER : which;
    const char *subject = thud_case_subject(table->measures, of, &ending);
    snprintf(text, THUD_SWEEP_TITLE, "%s help%s", subject, ending);
    return text;
}

bool thud_sweep_has_ratio(const struct thud_sweep_table *table, enum thud_told told, int structure)
{
    return told != THUD_TOLD_DRIFT || !table->kind || thud_kind_is_building(table->kind[structure]);
}

int thud_sweep_ratio_rows(const struct thud_sweep_table *table)
{
    int rows = 1;
    for (int s = 0; s < table->nstructures; s++)
        if (thud_sweep_has_ratio(table, THUD_TOLD_DRIFT, s))
            rows = THUD_TOLD_RATIOS;
    return rows;
}

const char *thud_sweep_structure_title(const struct thud_sweep_table *table, int structure, char text[160])
{
    const char *name = table->structure[structure];
    bool isolated = table->kind && table->kind[structure] == THUD_ISOLATED;
    int storeys = thud_sweep_floors(table, structure) - isolated;
    if ((table->kind && !thud_kind_is_building(table->kind[structure])) || storeys < 1)
        snprintf(text, 160, "%s", name);
    else if (strlen(name) <= 2)
        snprintf(text, 160, "%d-storey building %s%s", storeys, name, isolated ? ", isolated" : "");
    else
        snprintf(text, 160, "%s, %d storey%s%s", name, storeys, storeys == 1 ? "" : "s", isolated ? ", isolated" : "");
    return text;
}

/* ---- the axis of what was varied ---- */

bool thud_axis_has_numbers(const struct thud_sweep_axis *axis)
{
    return axis->param && !axis->words;
}

double thud_varied_factor(const struct thud_sweep_axis *axis)
{
    double unit = thud_axis_has_numbers(axis) && axis->param->unit && *axis->param->unit
                      ? thud_unit_factor(axis->param->unit, NULL, NULL)
                      : 1.0;
    return unit > 0.0 ? 1.0 / unit : 1.0;
}

double thud_axis_place(const struct thud_sweep_axis *axis, int i)
{
    return thud_axis_has_numbers(axis) ? axis->value[i] * thud_varied_factor(axis) : i + 1.0;
}

/* `table`: whose structures' names a key may stand for; NULL: it is shown by its number. */
static void axis_of_key(struct thud_panel *panel, enum thud_side side, const struct thud_sweep_axis *axis,
                        const struct thud_sweep_table *table)
{
    char label[192];
    const char *title = axis->param && axis->param->title ? axis->param->title : axis->key, *of = NULL;
    if (strstr(axis->key, "bumper.") && !strstr(title, "bumper"))
        of = "bumper";
    if (strstr(axis->key, "contact.") && !strstr(title, "contact"))
        of = "contact";
    if (strncmp(axis->key, "links.", 6) == 0)
        of = "link";
    if (strncmp(axis->key, "record.", 7) == 0)
        of = "ground motion";
    int structure = 0;
    snprintf(label, sizeof label, "%c%s", thud_ascii_upper(title[0]), title[0] ? title + 1 : "");
    if (of)
        snprintf(label, sizeof label, "%c%s: %s", thud_ascii_upper(of[0]), of + 1, title);
    else if (table && sscanf(axis->key, "structures.%d.", &structure) == 1 && structure >= 1 &&
             structure <= table->nstructures)
        snprintf(label, sizeof label, "%s: %s", table->structure[structure - 1], title);
    if (strcmp(axis->key, "record.sa") == 0 && isnan(axis->period_s))
        snprintf(label, sizeof label, "Sa at the mean first period, 5 %% damped");
    else if (strcmp(axis->key, "record.sa") == 0)
        snprintf(label, sizeof label, "Sa at %.3g s, 5 %% damped", axis->period_s);
    thud_panel_axis(panel, side, label, thud_axis_has_numbers(axis) && axis->param->unit ? axis->param->unit : "");
    if (!thud_axis_has_numbers(axis))
        thud_panel_limits(panel, side, 0.5, axis->n + 0.5);
    for (int i = 0; !thud_axis_has_numbers(axis) && i < axis->n; i++)
        thud_panel_tick(panel, side, i + 1.0, axis->text[i]);
}

void thud_panel_varied(struct thud_panel *panel, enum thud_side side, const struct thud_sweep_axis *axis)
{
    axis_of_key(panel, side, axis, NULL);
}

/* For a varied gap: the smallest one at which no ground motion of the study causes contact without the bumper, m; NaN:
 * not known, or not among those shown. */
static double free_gap(const struct thud_sweep_table *table, int varied)
{
    const struct thud_sweep_axis *axis = &table->axis[varied];
    int interface = strcmp(axis->key, "gap") == 0 ? 1 : 0;
    double widest = NAN;
    const int motions = table->motions > 0 ? table->motions : table->nrecords;
    if (!table->need || !thud_axis_has_numbers(axis))
        return NAN;
    if (strncmp(axis->key, "interfaces.", 11) == 0 && strcmp(axis->key + strlen(axis->key) - 4, ".gap") == 0)
        interface = atoi(axis->key + 11);
    for (int r = 0; r < motions; r++)
        if (interface > 0 && table->need[r].level.interface == interface)
            widest = fmax(widest, table->need[r].level.relative_displacement_m);
    return widest >= axis->value[0] && widest <= axis->value[axis->n - 1] ? widest : NAN;
}

void thud_sweep_axis_of(struct thud_panel *panel, enum thud_side side, const struct thud_sweep_table *table, int which)
{
    const double at = free_gap(table, which) * thud_varied_factor(&table->axis[which]);
    axis_of_key(panel, side, &table->axis[which], table);
    if (!isnan(at))
        thud_panel_mark(panel, side, at, at, "");
}

void thud_figure_note_free_gap(struct thud_figure *figure, const char *line, int measures, bool links, bool several)
{
    char text[160];
    const bool acting = links && measures & THUD_HAS_LINKS;
    snprintf(text, sizeof text, "%s line: no contact %s%sat this gap or wider%s.", line,
             measures ? thud_case_phrase(measures, acting ? THUD_CASE_LINK : THUD_CASE_NONE) : "", measures ? " " : "",
             several ? ", under any of the motions" : "");
    thud_figure_note(figure, text);
}

void thud_sweep_note_gap(struct thud_figure *figure, const struct thud_sweep_table *table, int axes)
{
    const bool several = table->nrecords > 1 || table->motions > 1, across = !isnan(free_gap(table, 0));
    if (across || (axes > 1 && !isnan(free_gap(table, 1))))
        thud_figure_note_free_gap(figure, across ? "Vertical" : "Level", table->measures, table->need_links, several);
}

void thud_sweep_note_shades(struct thud_figure *figure, const struct thud_sweep_table *table, bool shaded)
{
    char text[128];
    if (table->motions > 0)
        snprintf(text, sizeof text,
                 shaded && table->draws >= THUD_SHARES_LEAST ? "Medians of %d ground motions, 16 to 84 %% shaded."
                                                             : "Medians of %d ground motions.",
                 table->motions);
    else
        snprintf(text, sizeof text,
                 "Shaded: spread under %g %% less or more gap, ground motion, stiffness, one at a time.",
                 100 * table->sensitivity);
    if (table->motions > 0 || table->sensitivity > 0)
        thud_figure_note(figure, text);
}

void thud_sweep_note_rest(struct thud_figure *figure, const struct thud_sweep_table *table)
{
    char text[256];
    thud_sweep_note_gap(figure, table, 1);
    for (int a = 1; a < table->naxes; a++) {
        snprintf(text, sizeof text, "%s = %s.", table->axis[a].key, table->axis[a].text[0]);
        thud_figure_note(figure, text);
    }
}

void thud_sweep_same_scale(struct thud_figure *figure, const struct thud_figure *other)
{
    for (int row = 0; figure && row < figure->rows; row++)
        thud_figure_share_scale(figure, THUD_Y, row * figure->columns, 1, figure->columns, other);
}
