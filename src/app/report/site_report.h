/* `thud report`: a document about your own buildings. Runs without pounding, without and with the bumper, the required
 * gap, the uncertainty of the result, cautions, a second method, and all that is needed to repeat it. */
#pragma once

#include "app/run/record_list.h"
#include "app/run/session.h"
#include "app/sweep/uncertainty_study.h"
#include "io/file/made_by.h"
#include "plot/gnuplot/gnuplot.h"

struct thud_site_report_options {
    const struct thud_made_by *by;          /* the folder, and whose results its are */
    const char *command;                    /* as typed, to repeat it */
    const char *beside;                     /* presets to compare with, with commas; NULL: none */
    const char *drawn;                      /* SVG files, or folders of them, for its end, likewise */
    const struct thud_record_list *records; /* the suite of ground motions; one of them or none: there is no suite */
    int detail;                             /* its load case shown in detail, from 1; 0: the governing one */
    const struct thud_inputs *inputs;       /* that are uncertain */
    size_t samples;                         /* of them; 0: none are drawn */
    enum thud_sampling sampling;
    unsigned long long seed;
    const char *limits;               /* of criteria, "drift=1%,force=5MN"; "": none */
    const struct thud_target *target; /* design spectrum of the suite; NULL: not given */
    int threads;                      /* 0: the processors that are online */
    bool simplify;                    /* what the model needs, too */
    bool pdf;                         /* report.pdf too */
    struct thud_error *no_pdf;        /* why none could be made, where it need not be; NULL: it has to be */
    const struct thud_picture_options *pictures;
    void *context;
    void (*progress)(void *context, const char *what); /* may be NULL */
};

/* Writes report.html, which needs nothing else, and report.md with its figures (SVG) into the folder. THUD_GNUPLOT:
 * both are written, without figures. With `pdf` report.pdf too; one of before is removed in any case. Errors:
 * THUD_INPUT, THUD_DIVERGED, THUD_OUTPUT, THUD_MEMORY, THUD_CANCELLED. */
enum thud_status thud_site_report(struct thud_session *session, const struct thud_site_report_options *options,
                                  struct thud_error *err);
