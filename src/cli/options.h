/* What options say: of the scene, ground motions, uncertain inputs and pictures. */
#pragma once

#include "app/run/record_list.h"
#include "app/run/record_verbs.h"
#include "app/run/session.h"
#include "app/sweep/uncertainty_study.h"
#include "cli/args.h"
#include "ground/record.h"
#include "ground/synthesize.h"
#include "plot/gnuplot/gnuplot.h"

/* ---- The options that change the scene, for every command that has them ---- */

/* Opens the preset that is the command's only operand (towers if it may be left out). Then applies --record, --peak,
 * --dt, ..., --tolerance and after them every --set. The session is closed on failure. Errors: THUD_USAGE, THUD_INPUT,
 * THUD_MEMORY. */
enum thud_status thud_scene_options_open(const struct thud_args *args, struct thud_session *session,
                                         struct thud_error *err);

/* Opens the preset as above, does the work and closes it again; `scene` is room for the scene that is worked on.
 * Errors: THUD_MEMORY, and those of both. */
typedef enum thud_status thud_scene_work(const struct thud_args *args, struct thud_session *session,
                                         struct thud_scene *scene, struct thud_error *err);
enum thud_status thud_scene_options_with(const struct thud_args *args, thud_scene_work *work, struct thud_error *err);
/* What --set says, all of it together. Errors: as thud_session_assign. */
enum thud_status thud_scene_options_set(const struct thud_args *args, struct thud_session *session,
                                        struct thud_error *err);

/* A message about a key of the scene whose value came from an option is about the option, by the name that was typed.
 * Gives `status`, or THUD_USAGE where the option's value is what is wrong. */
enum thud_status thud_scene_options_name(const struct thud_args *args, enum thud_status status, struct thud_error *err);

/* --sensitivity with its value, else with that of the scene's study or 0.1 %; 0: not asked for. */
double thud_scene_options_change(const struct thud_args *args, const struct thud_scene *scene);

/* The scene of --case, its name in the title; as written without it. Errors: THUD_USAGE, THUD_INPUT. */
enum thud_status thud_scene_options_of_case(const struct thud_args *args, const struct thud_session *session,
                                            struct thud_scene *scene, struct thud_error *err);

/* --case; THUD_CASE_AS_WRITTEN without it. Errors: THUD_USAGE. */
enum thud_status thud_scene_options_case(const struct thud_args *args, enum thud_case *out, struct thud_error *err);

/* ---- The options of `thud record` ---- */

enum { THUD_PERIODS_MAX = 10000 };

/* How a file is read and what is done to it. Errors: THUD_USAGE, with the option as key. */
enum thud_status thud_record_options_read(const struct thud_args *args, struct thud_record_treatment *treatment,
                                          struct thud_error *err);

/* The ratio in the option `damping`, and --periods; what is not given stays. Errors: THUD_USAGE. */
struct thud_spectrum_choice {
    double damping, from_s, to_s;
    int count;
};
enum thud_status thud_spectrum_options_read(const struct thud_args *args, const char *damping,
                                            struct thud_spectrum_choice *choice, struct thud_error *err);

/* The values of a surrogate from --set KEY=VALUE (the parameters' names, and `event`, a text), --peak and --dt. *event
 * stays NULL when it is not given. Errors: THUD_USAGE. */
enum thud_status thud_synthesis_options_read(const struct thud_args *args, struct thud_synthesis *synthesis,
                                             const char **event, struct thud_error *err);

/* ---- --records: the ground motions of a study ---- */

/* Those of --records, or of the preset's study, with what --peak, --dt, ... specify for all of them; else the session's
 * own one (--record), or none. thud_records_warn reports what is wrong with them. Errors: THUD_USAGE, THUD_INPUT,
 * THUD_MEMORY. */
enum thud_status thud_records_option_read(const struct thud_args *args, struct thud_session *session,
                                          struct thud_record_list *out, struct thud_error *err);

/* Ground motions named in a text, as --records names them, with what the other options say of all. Errors: as
 * thud_record_list_read. */
enum thud_status thud_records_named(const struct thud_args *args, const struct thud_session *session, const char *text,
                                    bool both, struct thud_record_list *out, struct thud_error *err);

/* What is wrong with motions (a factor, a direction, too few), on standard error; not with --quiet. */
void thud_records_warn(const struct thud_args *args, const struct thud_record *const *record, int n);

/* --uncertain, --samples, --sampling, --seed: the inputs that are not known, and how often they are drawn. */

struct thud_inputs_choice {
    struct thud_inputs inputs;
    size_t samples;
    enum thud_sampling sampling;
    unsigned long long seed;
};
/* `samples`: the default. Errors: THUD_USAGE. */
enum thud_status thud_inputs_option_read(const struct thud_args *args, int samples, struct thud_inputs_choice *out,
                                         struct thud_error *err);

/* ---- --format, --size, --font, for every command that draws ---- */

struct thud_picture_choice {
    struct thud_picture_options options; /* points into `font`: do not copy */
    char font[128];
};

/* With the gnuplot that THUD_GNUPLOT names. Errors: THUD_USAGE. */
enum thud_status thud_picture_options_read(const struct thud_args *args, struct thud_picture_choice *choice,
                                           struct thud_error *err);
/* Every title says how many of the ground motions drawn from are synthetic. */
void thud_picture_options_motions(struct thud_picture_choice *choice, const struct thud_record *const *record, int n);
