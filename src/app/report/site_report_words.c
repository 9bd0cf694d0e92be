/* Words and pictures that several sections of a report share. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/report/site_report_private.h"
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

const struct thud_contact_result *thud_site_strongest(const struct thud_result *r)
{
    const struct thud_contact_result *most = NULL;
    for (int c = 0; c < r->ncontacts; c++)
        if (r->contact[c].force.value > 0 && (!most || r->contact[c].force.value > most->force.value))
            most = &r->contact[c];
    return most;
}

void thud_site_sides(const struct site *site, int interface, int left, int right, int struck, char *text, size_t size)
{
    char l[THUD_NAME_MAX + 40], r[THUD_NAME_MAX + 40];
    const char *a = thud_site_name(site, interface - 1), *b = thud_site_name(site, interface);
    if (left > 0)
        snprintf(l, sizeof l, "%sfloor %d of %s", struck < 0 ? "the columns below " : "", left, a);
    else
        snprintf(l, sizeof l, "the wall");
    if (right > 0)
        snprintf(r, sizeof r, "%sfloor %d of %s", struck > 0 ? "the columns below " : "", right, b);
    else
        snprintf(r, sizeof r, "the wall");
    snprintf(text, size, "%s and %s", l, r);
}

void thud_site_figure(struct site *site, struct thud_figure *figure, double share, const char *caption)
{
    struct thud_document *d = &site->document;
    struct thud_picture_options options = {0};
    struct thud_error err = {0};
    struct thud_text svg = {0};
    char file[96];
    if (site->options->pictures)
        options = *site->options->pictures;
    options.format = THUD_SVG;
    if (options.width_px == 0) {
        options.width_px = WIDTH_PX;
        options.height_px = (int)(share * WIDTH_PX);
    }
    if (options.font_px == 0)
        options.font_px = letters_px;
    const struct thud_record *const *record = site->suite.drawing ? site->suite.plan.record : &site->record;
    int nrecords = site->suite.drawing ? site->suite.plan.nrecords : 1;
    thud_synthetic_text(thud_records_synthetic(record, nrecords), nrecords, options.motions, sizeof options.motions);
    thud_figure_title_add(figure, options.motions);
    enum thud_status status = thud_figure_check(figure, &err);
    if (status == THUD_OK && site->pictures == THUD_OK)
        status = thud_gnuplot_draw(figure, &options, &svg, &err);
    if (site->pictures == THUD_OK && status != THUD_OK) {
        site->pictures = status;
        site->picture_error = err;
    }
    if (site->pictures == THUD_OK) {
        snprintf(file, sizeof file, "%s.svg", figure->name);
        thud_document_figure(d, file, caption, &svg);
    } else {
        thud_document_paragraph(d, "[Not drawn: %s]", caption);
    }
    thud_figure_free(figure);
}

struct thud_site_shown thud_site_number(double value, int digits)
{
    struct thud_site_shown out = {"0"};
    if (value == 0)
        return out;
    int places = fabs(value) < 1e7 ? digits - 1 - (int)floor(log10(fabs(value)) + 1e-9) : 0;
    if (fabs(value) < 1e-4)
        snprintf(out.text, sizeof out.text, "%.*g", digits, value);
    else
        snprintf(out.text, sizeof out.text, "%.*f", places > 0 ? places : 0, value);
    return out;
}
