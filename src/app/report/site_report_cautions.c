/* Cautions: the remarks of the scene, its motions and its cases, what matters most first. */
#include <stdio.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "base/ascii.h"

/* What matters most comes first. */
enum { FOREMOST = 3 };

/* Adds a remark, of a case by its words; "also": another one shows it too. */
static void tell_one(struct site *site, const struct thud_remark *remark, const char *words, const char *also)
{
    const struct thud_error *said = &remark->said;
    char line[1400];
    if (*words)
        snprintf(line, sizeof line, "%s%s: %s%s%s%s", words, also, said->what, *said->allowed ? " (" : "",
                 said->allowed, *said->allowed ? ")" : "");
    else
        thud_error_text(said, line, sizeof line);
    if ((!*said->key || *words) && !memchr(line, '.', strcspn(line, " "))) /* a file's name stays as it is */
        line[0] = thud_ascii_upper(line[0]);
    thud_document_item(&site->document, "%s.", line);
}

void thud_site_tell(struct site *site, const struct thud_remark_scope *scope, unsigned about)
{
    struct thud_remarks found = thud_remarks_find(scope, about);
    for (int i = 0; i < found.n; i++)
        tell_one(site, &found.item[i], "", "");
    thud_remarks_clear(&found);
}

/* Those of a weight: of the scene and its motions; of each case once, in the scene as written where it shows them. */
static int tell_weight(struct site *site, const struct thud_remarks *of_scene, const struct thud_remarks *of_case,
                       enum thud_remark_weight weight)
{
    int n = 0;
    for (int i = 0; i < of_scene->n; i++)
        if (of_scene->item[i].weight == weight) {
            tell_one(site, &of_scene->item[i], "", "");
            n++;
        }
    for (int i = site->ncases - 1; i >= 0; i--)
        for (int k = 0; k < of_case[i].n; k++) {
            const struct thud_remark *remark = &of_case[i].item[k];
            bool later = false;
            for (int j = i + 1; j < site->ncases; j++)
                later = later || thud_remarks_like(&of_case[j], remark) != NULL;
            if (remark->weight != weight || later)
                continue;
            tell_one(site, remark, site->cases[i].words,
                     i > SITE_NONE && thud_remarks_like(&of_case[SITE_NONE], remark)
                         ? thud_site_is_plural(&site->cases[i]) ? ", and likewise without them"
                                                                : ", and likewise without it"
                         : "");
            n++;
        }
    return n;
}

/* What weighs most first. Returns how many. */
static int tell(struct site *site)
{
    const bool suite = site->suite.leads; /* whose section tells what is to be said of its motions */
    struct thud_remarks of_case[SITE_CASES] = {{0}};
    const struct thud_remark_scope scope = {.scene = site->scene,
                                            .record = suite ? site->suite.plan.record : &site->record,
                                            .nrecords = suite ? site->suite.plan.nrecords : site->record != NULL};
    struct thud_remarks of_scene = thud_remarks_find(&scope, THUD_REMARK_SCENE | THUD_REMARK_COMPUTED |
                                                                 (suite ? 0 : (unsigned)THUD_REMARK_MOTIONS));
    int n = 0;
    for (int i = 0; i < site->ncases; i++) {
        struct thud_remark_scope of = {.scene = site->cases[i].scene, .result = site->cases[i].result};
        of.sensitivity = &site->cases[i] == site->own ? site->sensitivity : NULL;
        of.impact = thud_run_impacts(site->cases[i].solution.run, &of.nimpacts);
        of_case[i] = thud_remarks_find(&of, THUD_REMARK_RESULT | THUD_REMARK_LEDGER);
    }
    for (int weight = 0; weight < THUD_WEIGHTS; weight++)
        n += tell_weight(site, &of_scene, of_case, (enum thud_remark_weight)weight);
    for (int i = 0; i < site->ncases; i++)
        thud_remarks_clear(&of_case[i]);
    thud_remarks_clear(&of_scene);
    return n;
}

void thud_site_foremost(struct site *site)
{
    struct thud_document *d = &site->document;
    thud_document_heading(d, "Main cautions");
    size_t from = d->n;
    int n = tell(site);
    thud_document_cut(d, from + FOREMOST);
    if (n > FOREMOST)
        thud_document_paragraph(d, "Further cautions: %d, in the section of this name.", n - FOREMOST);
    else if (n == 0)
        thud_document_paragraph(d, "No cautions. Examined: drifts, compression of the bumper, capacity of struck "
                                   "columns, unusual values, energy, sensitivity of the force, ground motion.");
}

void thud_site_cautions(struct site *site)
{
    struct thud_document *d = &site->document;
    size_t from = d->n;
    thud_document_heading(d, "Further cautions");
    size_t first = d->n;
    if (tell(site) > FOREMOST)
        thud_document_take(d, first, FOREMOST); /* the first page has them */
    else
        thud_document_cut(d, from);
}
