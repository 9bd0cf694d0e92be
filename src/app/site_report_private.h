/* What a report is made of: computed by site_report.c, put into words by site_report_text.c. */
#ifndef THUD_APP_SITE_REPORT_PRIVATE_H
#define THUD_APP_SITE_REPORT_PRIVATE_H

#include "app/document.h"
#include "app/site_report.h"
#include "study/needed_gap.h"
#include "study/stiffness.h"
#include "study/verify.h"

/* Cases in this order; a scene without a bumper has no last one. */
enum { SITE_FREE, SITE_NONE, SITE_BUMPER, SITE_CASES };

struct site_case {
    const char *name, *words; /* in a table's head; in a sentence */
    struct thud_scene *scene;
    struct thud_answer answer;
    const struct thud_result *result;
};

struct site {
    const struct thud_site_report_options *options;
    struct thud_session *session;
    const struct thud_scene *scene; /* as written */
    const struct thud_record *record;
    int ncases;
    struct site_case cases[SITE_CASES];
    const struct site_case *own; /* the scene as written: with the bumper where it has one */
    struct thud_needed_gap *gap;
    struct thud_sensitivity *sensitivity;
    enum thud_stiffness varied;
    int nrows;
    struct thud_stiffness_row row[THUD_STIFFNESS_ROWS], reversed; /* of the motion turned round */
    struct {
        const char *method;
        int values, counts; /* compared, 0: it was given up; impact counts that differ */
        double difference;  /* largest relative one */
        char of[THUD_MEASURE_NAME_MAX];
    } second;
    struct thud_document document;
    enum thud_status pictures; /* THUD_OK, or what failed with the first that failed */
    struct thud_error picture_error;
};

/* All sections, in the order of the document. Errors: THUD_MEMORY, THUD_CANCELLED; see also site->pictures. */
enum thud_status thud_site_write(struct site *site, struct thud_error *err);

#endif
