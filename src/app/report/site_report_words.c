/* Words and pictures that several sections of a report share. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "app/run/run_cases.h"
#include "ground/identity.h"

/* Picture width and letters, px: 190 mm on paper gives letters of 9 pt. */
enum { WIDTH_PX = 1080 };
static const double letters_px = 17;

const char *thud_site_name(const struct site *site, int structure)
{
    const char *name = site->scene->structure[structure].name;
    return name[0] ? name : "?";
}

bool thud_site_is_building(const struct site *site, int structure)
{
    enum thud_structure_kind kind = site->scene->structure[structure].kind;
    return thud_kind_is_building(kind);
}

bool thud_site_is_plural(const struct site_case *one)
{
    const char *ending;
    thud_case_subject(thud_scene_measures(one->scene), one->which, &ending);
    return !*ending;
}

struct thud_site_shown thud_site_verb(const struct site_case *one, const char *verb)
{
    struct thud_site_shown out;
    snprintf(out.text, sizeof out.text, "%.*s", (int)strlen(verb) - thud_site_is_plural(one), verb);
    return out;
}

void thud_site_case_table(struct site *site, const char *caption, int from)
{
    struct thud_text text = {0};
    thud_text_append(&text, "%s", caption);
    for (int i = from; i < site->ncases; i++)
        thud_text_append(&text, "%s%c: %s", i > from ? "; " : " (", thud_site_letter(i), site->cases[i].name);
    thud_text_append(&text, ")");
    thud_document_table(&site->document, text.data ? text.data : caption);
    site->document.failed = site->document.failed || text.failed;
    thud_text_clear(&text);
}

const struct site_case *thud_site_bare(const struct site *site)
{
    const struct site_case *one = &site->cases[SITE_NONE];
    for (int i = SITE_MEASURE; i < site->ncases; i++)
        if (site->cases[i].scene->nlinks > 0 && !thud_scene_has_bumper(site->cases[i].scene))
            one = &site->cases[i];
    return one;
}

const struct thud_contact_result *thud_site_strongest(const struct thud_result *r)
{
    const struct thud_contact_result *most = NULL;
    for (int c = 0; c < r->ncontacts; c++)
        if (thud_peak_force(&r->contact[c]) > (most ? most->force.value : 0))
            most = &r->contact[c];
    return most;
}

const char *thud_site_floor(const struct site *site, int structure, int floor, char *text, size_t size)
{
    const char *name = thud_site_name(site, structure);
    const enum thud_structure_kind kind = site->scene->structure[structure].kind;
    if (kind == THUD_WALL)
        snprintf(text, size, "%s", name);
    else if (kind == THUD_ISOLATED && floor == 1)
        snprintf(text, size, "the base slab of %s", name);
    else
        snprintf(text, size, "floor %d of %s", floor, name);
    return text;
}

void thud_site_sides(const struct site *site, int interface, int left, int right, int struck, char *text, size_t size)
{
    char side[2][THUD_NAME_MAX + 40];
    static const char columns_below[] = "the columns below ";
    const int floor[2] = {left, right}, columns[2] = {struck<0, struck> 0};
    for (int i = 0; i < 2; i++) {
        const size_t n = columns[i] ? sizeof columns_below - 1 : 0;
        memcpy(side[i], columns_below, n);
        thud_site_floor(site, interface - 1 + i, floor[i], side[i] + n, sizeof side[i] - n);
    }
    snprintf(text, size, "%s and %s", side[0], side[1]);
}

/* Of a figure with this share of height to width. */
static struct thud_picture_options options_of(const struct site *site, double share)
{
    struct thud_picture_options options = {0};
    if (site->options->pictures)
        options = *site->options->pictures;
    options.format = THUD_SVG;
    options.no_title = true;
    if (options.width_px == 0) {
        options.width_px = WIDTH_PX;
        options.height_px = (int)(share * WIDTH_PX);
    }
    if (options.font_px == 0)
        options.font_px = letters_px;
    return options;
}

void thud_site_fit(const struct site *site, struct thud_figure *figure, double share)
{
    const struct thud_picture_options options = options_of(site, share);
    thud_figure_fit(figure, &options);
}

void thud_site_figure(struct site *site, struct thud_figure *figure, double share, const char *caption)
{
    struct thud_document *d = &site->document;
    struct thud_picture_options options = options_of(site, share);
    struct thud_error err = {0};
    struct thud_text svg = {0};
    char file[96];
    const struct thud_record *const *record = site->suite.drawing ? site->suite.plan.record : &site->record;
    int nrecords = site->suite.drawing ? site->suite.plan.nrecords : 1;
    thud_synthetic_text(thud_records_synthetic(record, nrecords), nrecords, options.motions, sizeof options.motions);
    enum thud_status status = thud_figure_check(figure, &err);
    thud_figure_fit(figure, &options);
    if (status == THUD_OK && site->pictures == THUD_OK)
        status = thud_gnuplot_draw(figure, &options, &svg, &err);
    if (site->pictures == THUD_OK && status != THUD_OK) {
        site->pictures = status;
        site->picture_error = err;
    }
    if (site->pictures == THUD_OK) {
        snprintf(file, sizeof file, "%s.svg", figure->name);
        struct thud_text alt = {0};
        char all[400];
        thud_figure_words(figure, &alt);
        const bool told = *options.motions && !figure->panel[0].drawing;
        snprintf(all, sizeof all, told ? "%.*s (%s)." : "%.*s.", (int)strlen(caption) - 1, caption, options.motions);
        thud_document_figure(d, file, all, alt.data ? alt.data : caption, &svg);
        thud_text_clear(&alt);
    } else {
        thud_document_paragraph(d, "[Not drawn: %s]", caption);
    }
    thud_figure_free(figure);
}

void thud_site_motion(const struct thud_record *record, char *text, size_t size)
{
    thud_record_title(record, text, size);
    thud_append(text, size, "%s", thud_record_synthetic_mark(record));
}

const char *thud_site_columns(const struct site *site, const struct thud_column_result *r, char *name, size_t size)
{
    return thud_site_floor(site, r->structure, r->storey, name, size);
}

const char *thud_site_choice(const struct thud_param *param, const char *value, int *length)
{
    char key[64];
    const int n = snprintf(key, sizeof key, "%s: ", value);
    const char *at = strstr(param->help, key);
    if (!at)
        return NULL;
    at += n;
    *length = (int)(strcspn(at, ";") - (at[strcspn(at, ";")] == '\0'));
    return at;
}

struct thud_site_unit thud_site_unit(enum thud_dimension kind)
{
    static const struct thud_site_unit unit[THUD_DIMENSIONS] = {[THUD_RATIO] = {0.01, " %"},
                                                                [THUD_LENGTH] = {1e-3, " mm"},
                                                                [THUD_FORCE] = {1e6, " MN"},
                                                                [THUD_ACCELERATION] = {THUD_GRAVITY, " g"}};
    return unit[kind].size > 0 ? unit[kind] : (struct thud_site_unit){1, ""};
}

struct thud_site_shown thud_site_number(double value, int digits)
{
    struct thud_site_shown out = {{isnan(value) ? '-' : '0'}};
    if (value == 0 || isnan(value))
        return out;
    const double shown = fabs(value) / (1 - 0.5 * pow(10, -digits)); /* 0.9996 is 1.00 */
    int places = fabs(value) < 1e7 ? digits - 1 - (int)floor(log10(shown)) : 0;
    if (fabs(value) < 5e-4)
        snprintf(out.text, sizeof out.text, value > 0 ? "<0.001" : ">-0.001");
    else
        snprintf(out.text, sizeof out.text, "%.*f", places > 0 ? places : 0, value);
    return out;
}
