/* What a report is made of: computed by site_report.c and site_report_suite.c, put into words by site_report_text.c and
 * its neighbours. */
#pragma once

#include "app/report/document.h"
#include "app/report/site_report.h"
#include "app/sweep/gap_report.h"
#include "app/sweep/uncertainty_study.h"
#include "plot/figure/figure.h"
#include "study/methods/verify.h"
#include "study/scene/needed_gap.h"
#include "study/scene/solution.h"
#include "study/scene/stiffness.h"
#include "study/simplify/simplify.h"
#include "study/suite/fragility.h"
#include "study/sweep/floor_response.h"
#include "study/sweep/remark.h"

/* Order of the cases: without pounding, then without the measures, which are bumper and links. If the scene has both,
 * each alone follows from SITE_MEASURE on. The last case is the scene as written. */
enum { SITE_FREE, SITE_NONE, SITE_MEASURE, SITE_CASES = SITE_MEASURE + 3 };

struct site_case {
    enum thud_case which;
    const char *name, *words; /* in a table's head; in a sentence */
    const char *measure;      /* "bumper", "links alone" */
    struct thud_scene *scene;
    struct thud_solution solution;
    const struct thud_result *result;
};

/* The suite of ground motions: every one at several scales, without and with the bumper. Case k of the plan is
 * SITE_NONE + k of the report. */
struct site_suite {
    struct thud_sweep_plan plan; /* its axis: the factor on the motions; of one motion it has none */
    struct thud_suite *runs;
    bool leads;    /* there is more than one ground motion */
    long as_given; /* the setting with the motions unscaled */
    struct thud_event pounding, worse;
    struct thud_fragility pounds[SITE_CASES - SITE_NONE], worsens; /* of each case; as written */
    double *room;                                                  /* (nrecords) scratch */
    bool drawing;                                                  /* figures are of the suite, not of one motion */
};

/* A preset beside the scene, which is the first of them. */
enum { SITE_VARIANTS_MAX = 16, SITE_DRAWN_MAX = 64 };
struct site_variant {
    char name[THUD_NAME_MAX];
    double gap_m, bumper_m;       /* the smallest; the thickest, 0: there is none */
    double required_m;            /* by the report's code */
    struct thud_sweep_plan *plan; /* of its runs; NULL: of the scene itself, which the suite has */
    struct thud_suite *runs;
};

/* A ratio this near to 1 is reported as no difference. */
#define THUD_SITE_SAME 0.02

struct site {
    const struct thud_site_report_options *options;
    struct thud_session *session;
    const struct thud_scene *scene;   /* as written */
    const struct thud_record *record; /* shown in detail */
    int ncases;
    struct site_case cases[SITE_CASES];
    const struct site_case *own;       /* the scene as written: with the bumper where it has one */
    struct thud_gap_study gaps;        /* of all ground motions */
    const struct thud_needed_gap *gap; /* of the one shown in detail */
    int detail;                        /* which of them that is, from 0: a load case of the suite */
    struct thud_floor_spectra *floors; /* of the floors struck hardest; NULL: nothing is struck */
    struct thud_sensitivity *sensitivity;
    int nrows[THUD_STIFFNESSES];
    struct thud_stiffness_row row[THUD_STIFFNESSES][THUD_STIFFNESS_ROWS], reversed; /* of the motion reversed */
    struct thud_uncertainty *uncertainty;                                           /* NULL: nothing was drawn */
    struct thud_uncertainty_study samples;
    struct site_suite suite;
    const struct thud_gap_practice *code;           /* whose gap is recommended */
    struct thud_event limit[THUD_MEASURES];         /* by measure; an empty text: none */
    struct site_variant variant[SITE_VARIANTS_MAX]; /* (nvariants) */
    int nvariants;                                  /* 0: none are asked for */
    struct thud_simplify *simplify;                 /* NULL: not asked for */
    struct thud_text drawn[SITE_DRAWN_MAX];         /* (ndrawn) SVG pictures that were drawn before */
    int ndrawn;
    struct {
        const char *method;
        int values, counts; /* compared, 0: it was given up; impact counts that differ */
        double difference;  /* largest relative one */
    } second;
    struct thud_document document;
    enum thud_status pictures; /* THUD_OK, or what failed with the first that failed */
    struct thud_error picture_error;
};

/* All sections, in the order of the document. Errors: THUD_MEMORY, THUD_CANCELLED; see also site->pictures. */
enum thud_status thud_site_write(struct site *site, struct thud_error *err);

/* ---- sections, in the order of the document ---- */

/* Project, author, checker, date and revision, where they are given. */
void thud_site_title_block(struct site *site);
/* Code and limits that are asked for. Errors: THUD_INPUT with the preset's line, THUD_USAGE. */
enum thud_status thud_site_criteria_read(struct site *site, struct thud_error *err);
/* The gap that the code asks for, and each criterion against its limit. */
void thud_site_conclusion(struct site *site);
/* A row for each thing that is decided. */
void thud_site_verdicts(struct site *site);
void thud_site_verdict(struct site *site, const char *what, const char *found);
/* The three cautions that matter most; the others. */
void thud_site_foremost(struct site *site);
void thud_site_cautions(struct site *site);
/* The remarks of a set of enum thud_remark_about, an item each. */
void thud_site_tell(struct site *site, const struct thud_remark_scope *scope, unsigned about);
/* The drawing and the structures; every number that the runs use, by its key in a preset; the ground motions. */
void thud_site_scene(struct site *site);
void thud_site_inputs(struct site *site);
void thud_site_loads(struct site *site);
void thud_site_method(struct site *site);
void thud_site_checks(struct site *site);
void thud_site_unmade(struct site *site);
void thud_site_provenance(struct site *site);

/* Storeys of buildings that can yield, in the scene as written, without isolators. *past (or NULL): those that do. */
int thud_site_storeys(const struct site *site, int *past);
/* How many floors (storeys, for drifts) the measure of a case lowers, leaves unchanged and raises. */
void thud_site_effect(const struct site *site, const struct site_case *one, bool drifts, int count[3]);

/* ---- the suite ---- */

/* Of a scene as written under the report's ground motions, which are scaled already. */
void thud_site_plan(const struct site *site, const struct thud_scene *scene, struct thud_sweep_plan *plan);
/* Runs it, or the one motion as it is. Errors: those of the studies. */
enum thud_status thud_site_suite_run(struct site *site, struct thud_error *err);
/* What its runs come to, by so many jobs of which several may be done at once. */
int thud_site_suite_jobs(const struct site *site);
enum thud_status thud_site_suite_job(struct site *site, int job, struct thud_error *err);
void thud_site_suite_clear(struct site *site);
/* The rows of the verdicts that are over it. */
void thud_site_suite_verdicts(struct site *site);
/* Of a quantity that is sampled the median over its motions, with the inputs as they are. */
double thud_site_suite_median(const struct site *site, const struct thud_quantity_of_run *quantity);
/* Its part of the result, and its own section. */
void thud_site_suite_summary(struct site *site);
void thud_site_suite_section(struct site *site);

/* ---- the required gap ---- */

/* What a rule asks for over the ground motions at an interface (from 1; 0: of all), as `thud gap` tells it:
 * THUD_GAP_EXACT is the largest of them. A gap of -1: nothing can touch. */
struct thud_gap_ruled thud_site_ruled(const struct thud_gap_study *gaps, int nstructures, int interface, int rule);
/* The same of the report's code over a study of so many structures, and where it is from. */
double thud_site_gap_by_code(const struct site *site, const struct thud_gap_study *gaps, int nstructures,
                             int interface);
const char *thud_site_gap_source(const struct site *site, char *text, size_t size);
/* Of a rule: "those of this one motion", "the largest of 3 ground motions", "the means over 14 ground motions of 7
 * recordings". */
const char *thud_site_displacements(const struct site *site, int rule, char *text, size_t size);

/* One number of those in the suite's room, which it sorts: the mean or the largest of the code, or what is enough for
 * 84 % of the motions. NaN: one of them is not known. */
double thud_site_decided(const struct site *site);
/* "the means over 14 ground motions of 7 recordings", "what is enough for 84 % of 8 ground motions". */
const char *thud_site_decided_words(const struct site *site, char *text, size_t size);

/* ---- variants ---- */

/* Errors: those of opening and running a preset. */
enum thud_status thud_site_variants_run(struct site *site, struct thud_error *err);
void thud_site_variants(struct site *site);
void thud_site_variants_clear(struct site *site);

/* ---- figures that were drawn before ---- */

/* Reads them. Errors: THUD_INPUT (a file that is no SVG picture), THUD_USAGE (too many). */
enum thud_status thud_site_drawn_read(struct site *site, struct thud_error *err);
void thud_site_drawn(struct site *site);

/* ---- how sure it is ---- */

void thud_site_samples_summary(struct site *site);
void thud_site_sure_section(struct site *site);

/* ---- what the model needs ---- */

/* Errors: THUD_MEMORY, THUD_CANCELLED. */
enum thud_status thud_site_simplify_run(struct site *site, struct thud_error *err);
void thud_site_simplify(struct site *site);

/* ---- words ---- */

const char *thud_site_name(const struct site *site, int structure);
bool thud_site_is_building(const struct site *site, int structure);
/* In which documents show a quantity; " g" behind a number, "" where there is none. */
struct thud_site_unit {
    double size;
    const char *name;
};
struct thud_site_unit thud_site_unit(enum thud_dimension kind);
/* A number with so many significant digits, and no exponent where it has a size of daily life. */
struct thud_site_shown {
    char text[32];
};
struct thud_site_shown thud_site_number(double value, int digits);
/* A table with a column for every case from one on, whose head has its letter: "b", "b: force MN", "c/b". The caption
 * says which is which. */
void thud_site_case_table(struct site *site, const char *caption, int from);
static inline char thud_site_letter(int i)
{
    return (char)('a' + i);
}
/* `verb`, "lowers", of the measure of a case. */
bool thud_site_is_plural(const struct site_case *one);
struct thud_site_shown thud_site_verb(const struct site_case *one, const char *verb);
/* The case without bumpers that has the links of the scene. */
const struct site_case *thud_site_bare(const struct site *site);
/* "floor 4 of A", counted from 1; "the base slab of B", which is the first floor of an isolated building; of a wall its
 * name. Returns `text`. */
const char *thud_site_floor(const struct site *site, int structure, int floor, char *text, size_t size);
/* "floor 4 of A and floor 4 of B". */
void thud_site_sides(const struct site *site, int interface, int left, int right, int struck, char *text, size_t size);
/* Event, station and component, or "kobe.csv"; "(synthetic)" where it is. */
void thud_site_motion(const struct thud_record *record, char *text, size_t size);
/* Whose struck columns they are: "floor 5 of B". Returns `name`. */
const char *thud_site_columns(const struct site *site, const struct thud_column_result *r, char *name, size_t size);
/* What a choice stands for, of "keep: it widens the clearance; recover: ..." the words behind the value's own, and
 * their length; NULL: its help has none. */
const char *thud_site_choice(const struct thud_param *param, const char *value, int *length);
/* The contact with the largest force; NULL where there was no contact. */
const struct thud_contact_result *thud_site_strongest(const struct thud_result *result);
/* The caption ends in a stop. `share`: of its height to its width; 0: chosen for the figure. Takes the figure. */
void thud_site_figure(struct site *site, struct thud_figure *figure, double share, const char *caption);
/* What the figure keeps of its panels at that size, before its caption is written. */
void thud_site_fit(const struct site *site, struct thud_figure *figure, double share);
