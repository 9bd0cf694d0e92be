/* What of the scene is needed, of the ground motion shown in detail alone: as `thud simplify` tells it. */
#include <math.h>

#include "app/report/site_report_private.h"
#include "app/sweep/simplify_report.h"

/* Some 3 s on a slow processor, in steps and evaluations times modes: a report is the same wherever it is made. */
static const double work_most = 1.5e7;

enum thud_status thud_site_simplify_run(struct site *site, struct thud_error *err)
{
    const struct thud_record_list *all = site->options->records,
                                  one = {.n = site->record != NULL, .record = all->record + site->detail};
    const struct thud_simplify_ask ask = {.within = 0.05, .no_methods = true, .work_most = work_most};
    struct thud_error failed = {0};
    if (!site->options->simplify)
        return THUD_OK;
    const enum thud_status status = thud_simplify_search(
        site->scene, site->record ? &one : all, &ask, site->options->pictures ? site->options->pictures->cancel : NULL,
        &site->simplify, &failed);
    if (status != THUD_MEMORY && status != THUD_CANCELLED)
        return THUD_OK;
    *err = failed;
    return status;
}

void thud_site_simplify(struct site *site)
{
    struct thud_document *d = &site->document;
    struct thud_text text = {0};
    const struct thud_simplify_found *f = site->simplify ? thud_simplify_found(site->simplify) : NULL;
    if (!f || f->n == 0)
        return;
    thud_simplify_sentence(f, &text);
    thud_document_heading(d, "Simplified models");
    thud_document_paragraph(d, "Within %.3g %% of every peak, under the ground motion shown in detail: %s.",
                            100 * f->within, text.data ? text.data : "");
    thud_text_clear(&text);
    thud_simplify_remarks(f, "", &text);
    char *rest = text.data, *line;
    while (rest && (line = thud_text_line(&rest)) != NULL)
        thud_document_item(d, "%s", line);
    thud_text_clear(&text);
    if (f->steps > 0) {
        thud_document_table(d, "Possible simplifications");
        thud_document_head(d, "simplification|change alone, %|number of inputs|work, %");
        for (int i = 0; i < f->steps; i++) {
            const struct thud_simplification *one = &f->one[f->step[i]];
            thud_document_cells(d, "%s\t%s\t%d\t%.0f", one->words, thud_site_number(100 * one->change.all, 2).text,
                                one->inputs, 100 * one->work);
            thud_document_row(d);
        }
    }
    thud_document_paragraph(
        d, "The command thud simplify lists all that was tried, over several ground motions too, and writes this "
           "model as a preset.");
}
