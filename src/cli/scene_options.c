#include "cli/options.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/record_list.h"
#include "base/scan.h"
#include "io/building/building_file.h"
#include "study/sweep/sweep.h"

/* Groups of the scene's keys, and the options beside those of the record that set the key of the same name in one. */
static const struct {
    const char *group, *option;
} of_group[] = {{"analysis", "method"},   {"analysis", "step"},    {"analysis", "tolerance"}, {"analysis", "modes"},
                {"study", "sensitivity"}, {"document", "project"}, {"document", "author"},    {"document", "checker"},
                {"document", "date"},     {"document", "revision"}};
enum { OF_GROUPS = sizeof of_group / sizeof *of_group, KEY = 64 };

/* The i-th option that sets one value of the scene, and that value's key; NULL past the last. */
static const char *option_at(int i, char key[KEY])
{
    int nsettings = 0;
    while (nsettings <= i && thud_record_setting(nsettings))
        nsettings++;
    bool of_record = i < nsettings;
    if (i >= nsettings + OF_GROUPS)
        return NULL;
    const char *option = of_record ? thud_record_setting(i) : of_group[i - nsettings].option;
    snprintf(key, KEY, "%s.%s", of_record ? "record" : of_group[i - nsettings].group, option);
    return option;
}

/* A value that an option cannot take is wrong usage, whatever it is about. What --set says is input, as in a preset. */
static enum thud_status as_wrong_usage(enum thud_status status, struct thud_error *err)
{
    if (status != THUD_INPUT)
        return status;
    err->status = THUD_USAGE;
    return THUD_USAGE;
}

/* Whether an option, or --set, gives this key of the record. */
static bool gives_record(const struct thud_args *args, const char *setting)
{
    const char *assignment;
    bool given = thud_args_value(args, setting);
    for (int i = 0; !given && (assignment = thud_args_repeated(args, "set", i)) != NULL; i++)
        given = thud_scan_word(&assignment, "record.") && thud_scan_word(&assignment, setting) && *assignment == '=' &&
                assignment[1];
    return given;
}

/* One that is given takes the place of all that the preset says. */
static void drop_size(const struct thud_args *args, struct thud_record_choice *own)
{
    if (!gives_record(args, "peak") && !gives_record(args, "sa") && !gives_record(args, "target"))
        return;
    own->peak_mps2 = own->sa_mps2 = NAN;
    own->target[0] = '\0';
}

/* Options of a ground motion have no effect where there is none. */
static enum thud_status refuse_idle(const struct thud_args *args, const struct thud_session *session,
                                    struct thud_error *err)
{
    const char *setting;
    if (session->scene.record.file[0] || session->scene.study.records[0] || thud_args_value(args, "records"))
        return THUD_OK;
    for (int i = 0; (setting = thud_record_setting(i)) != NULL; i++)
        if (thud_args_value(args, setting)) {
            thud_error_set(err, THUD_USAGE, "the scene has no ground motion");
            thud_error_allow(err, "--record FILE gives it one");
            return thud_args_wrong(setting, err);
        }
    return THUD_OK;
}

/* The part of a `--set` before its last `.name=`, without the number of the only interface; NULL: it is another name's.
 */
static const char *key_before(const char *assignment, const char *name, bool one, size_t *length)
{
    const char *sign = strchr(assignment, '=');
    size_t n = strlen(name), whole = sign ? (size_t)(sign - assignment) : 0;
    if (whole <= n || strncmp(sign - n, name, n) != 0 || sign[-(ptrdiff_t)n - 1] != '.')
        return NULL;
    if (one && strncmp(assignment, "interfaces.1.", 13) == 0) {
        assignment += 13;
        whole -= 13;
    }
    *length = whole - n - 1;
    return assignment;
}

/* A stiffness is written in a unit with its exponent: another exponent alone would turn 0.36 kN/mm^2.65 into 0.36
 * kN/mm^2, as in no file. */
static enum thud_status refuse_exponent(const struct thud_args *args, const struct thud_session *session,
                                        struct thud_error *err)
{
    const struct thud_scene *before = thud_preset_scene(session->preset);
    bool one = session->scene.nstructures == 2;
    const char *assignment, *other;
    for (int i = 0; (assignment = thud_args_repeated(args, "set", i)) != NULL; i++) {
        size_t n, m;
        const char *at = key_before(assignment, "exponent", one, &n), *to;
        bool given = false;
        for (int k = 0; at && (other = thud_args_repeated(args, "set", k)) != NULL; k++)
            given |= ((to = key_before(other, "stiffness", one, &m)) || (to = key_before(other, "law", one, &m))) &&
                     m == n && strncmp(at, to, n) == 0;
        char key[KEY + 64], was[96], is[96], exponents[2][32];
        if (!at || given || n > KEY)
            continue;
        snprintf(key, sizeof key, "%.*s.stiffness", (int)n, at);
        if (thud_scene_get(before, key, was, sizeof was, NULL) != THUD_OK || !*was ||
            thud_scene_get(&session->scene, key, is, sizeof is, NULL) != THUD_OK || strcmp(was, is) == 0)
            continue;
        snprintf(key, sizeof key, "%.*s.exponent", (int)n, at);
        if (thud_scene_get(before, key, exponents[0], sizeof exponents[0], NULL) != THUD_OK ||
            thud_scene_get(&session->scene, key, exponents[1], sizeof exponents[1], NULL) != THUD_OK)
            continue;
        thud_error_set(err, THUD_INPUT, "the stiffness of %s has the exponent %s in its unit, not %s", was,
                       exponents[0], exponents[1]);
        thud_error_key(err, "%s", key);
        thud_error_allow(err, "together with --set %.*s.stiffness=\"...%s\"", (int)n, at,
                         strchr(is, ' ') ? strchr(is, ' ') : "");
        return THUD_INPUT;
    }
    return THUD_OK;
}

enum thud_status thud_scene_options_set(const struct thud_args *args, struct thud_session *session,
                                        struct thud_error *err)
{
    const char **assignment = calloc((size_t)args->ngiven + 1, sizeof *assignment), *next;
    int n = 0;
    if (!assignment)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    while ((next = thud_args_repeated(args, "set", n)) != NULL)
        assignment[n++] = next;
    enum thud_status status = thud_session_assign_all(session, assignment, n, err);
    free(assignment);
    return status;
}

/* An option takes one value: where this is a range that the command's --vary takes, the error points there. */
static void point_to_vary(const struct thud_args *args, const struct thud_scene *scene, const char *key,
                          const char *value, struct thud_error *err)
{
    char vary[KEY + 100];
    const bool may = strchr(value, ':') && thud_option_find(args->command, "vary");
    struct thud_sweep_plan *plan = may ? malloc(sizeof *plan) : NULL;
    if (!plan)
        return;
    snprintf(vary, sizeof vary, "%s=%.90s", key, value);
    thud_sweep_plan_init(plan, scene);
    if (thud_sweep_vary(plan, vary, NULL) == THUD_OK)
        thud_error_allow(err, "one value; a range: --vary %s", vary);
    thud_sweep_plan_clear(plan);
    free(plan);
}

static enum thud_status apply_options(const struct thud_args *args, struct thud_session *session,
                                      struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    const char *option, *value;
    char key[KEY];
    if (thud_args_value(args, "record"))
        thud_session_choose_record(session, thud_args_value(args, "record"));
    for (int i = 0; (value = thud_args_repeated(args, "set", i)) != NULL; i++)
        if (thud_scan_word(&value, "record.file=") && strcmp(value, session->scene.record.file) != 0)
            thud_session_choose_record(session, value); /* before its other options, in any order */
    drop_size(args, &session->scene.record);
    for (int i = 0; status == THUD_OK && (option = option_at(i, key)) != NULL; i++)
        if ((value = thud_args_value(args, option)) != NULL &&
            (status = as_wrong_usage(thud_scene_set(&session->scene, key, value, err), err)) != THUD_OK)
            point_to_vary(args, &session->scene, key, value, err);
    if (status == THUD_OK)
        status = thud_scene_options_set(args, session, err);
    if (status == THUD_OK)
        status = thud_building_files_read(&session->scene, session->preset_path, err);
    if (status == THUD_OK)
        status = refuse_exponent(args, session, err);
    return status == THUD_OK ? refuse_idle(args, session, err) : status;
}

/* Whether the command, as given, asks for no bumper. */
static bool is_bare(const struct thud_args *args)
{
    const char *which = thud_args_value(args, "case"), *cases = thud_args_value(args, "cases"),
               *none = thud_case_name(THUD_CASE_NONE);
    return args->command == THUD_COMMAND_GAP || thud_args_has(args, "pad") || (which && strcmp(which, none) == 0) ||
           (cases && strcmp(cases, none) == 0);
}

enum thud_status thud_scene_options_open(const struct thud_args *args, struct thud_session *session,
                                         struct thud_error *err)
{
    bool has_default = args->command == THUD_COMMAND_BENCH || args->command == THUD_COMMAND_STABILITY ||
                       args->command == THUD_COMMAND_SCREEN;
    const char *preset = args->noperands > 0 ? args->operand[0] : has_default ? "towers" : NULL;
    if (!preset || args->noperands > 1) {
        const char *name = thud_command_at(args->command)->name;
        return thud_error_refuse(err, THUD_USAGE, NULL, "a name such as towers, or a file",
                                 args->noperands == 0 ? "thud %s needs a preset" : "thud %s takes one preset", name);
    }
    enum thud_status status = (is_bare(args) ? thud_session_open_unfinished : thud_session_open)(session, preset, err);
    if (status == THUD_OK)
        status = apply_options(args, session, err);
    if (status == THUD_OK && thud_preset_unfinished(session->preset))
        status = thud_scene_case(&session->scene, THUD_CASE_NONE, &session->scene, err);
    if (status != THUD_OK)
        thud_session_close(session);
    return status;
}

/* A key of the preset that no option gave, refused by the model: its line. */
static void place_in_preset(const struct thud_args *args, const struct thud_session *session, enum thud_status status,
                            struct thud_error *err)
{
    const char *assignment;
    if (status != THUD_INPUT || !err || err->file[0] || strncmp(err->key, "structures.", 11) != 0)
        return;
    for (int i = 0; (assignment = thud_args_repeated(args, "set", i)) != NULL; i++)
        if (strncmp(assignment, err->key, strlen(err->key)) == 0)
            return;
    thud_preset_place(session->preset, err->key, err);
}

enum thud_status thud_scene_options_with(const struct thud_args *args, thud_scene_work *work, struct thud_error *err)
{
    struct thud_session *session = calloc(1, sizeof *session);
    struct thud_scene *scene = calloc(1, sizeof *scene);
    enum thud_status status = THUD_MEMORY;
    if (session && scene)
        status = thud_scene_options_open(args, session, err);
    else
        thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK) {
        status = work(args, session, scene, err);
        place_in_preset(args, session, status, err);
        thud_session_close(session);
    }
    free(scene);
    free(session);
    return status;
}

/* Whether a message about a key may be about the value of an option. The key is then that of the value, or the bare
 * word that readers of files and lists of cases call it by. */
static bool option_is_about(const char *option, const char *wanted)
{
    static const char *const others[][2] = {{"record", "record.file"}, {"records", "study.records"}, {"case", "cases"}};
    char key[KEY];
    const char *other;
    if (strcmp(option, wanted) == 0)
        return true;
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strcmp(option, others[i][0]) == 0 && strcmp(wanted, others[i][1]) == 0)
            return true;
    for (int i = 0; (other = option_at(i, key)) != NULL; i++)
        if (strcmp(option, other) == 0)
            return strcmp(wanted, key) == 0;
    return false;
}

enum thud_status thud_scene_options_name(const struct thud_args *args, enum thud_status status, struct thud_error *err)
{
    size_t n = strlen(err->key);
    const char *assignment;
    if (n == 0 || err->column > 0) /* a column: a place inside a file, which no option wrote */
        return status;
    for (int i = 0; (assignment = thud_args_repeated(args, "set", i)) != NULL; i++)
        if (strncmp(assignment, err->key, n) == 0 && assignment[n] == '=')
            return status;
    for (int i = 0; i < args->ngiven; i++)
        if (option_is_about(args->given[i].option->name, err->key)) {
            thud_args_key(args->given[i].option->name, err);
            /* a unit is not checked before the file is read; only the option can be wrong */
            return strcmp(args->given[i].option->name, "unit") == 0 ? as_wrong_usage(status, err) : status;
        }
    return status;
}

double thud_scene_options_change(const struct thud_args *args, const struct thud_scene *scene)
{
    if (!thud_args_has(args, "sensitivity"))
        return 0;
    return thud_args_value(args, "sensitivity") ? scene->study.sensitivity : thud_scene_change(scene);
}

enum thud_status thud_scene_options_case(const struct thud_args *args, enum thud_case *out, struct thud_error *err)
{
    const char *word = thud_args_value(args, "case");
    *out = THUD_CASE_AS_WRITTEN;
    struct thud_error why = {0};
    if (!word || thud_case_find(word, out, &why) == THUD_OK)
        return THUD_OK;
    return thud_error_refuse(err, THUD_USAGE, "--case", why.allowed, "%s", why.what);
}

enum thud_status thud_scene_options_of_case(const struct thud_args *args, const struct thud_session *session,
                                            struct thud_scene *scene, struct thud_error *err)
{
    enum thud_case which;
    enum thud_status status = thud_scene_options_case(args, &which, err);
    if (status != THUD_OK)
        return status;
    *scene = session->scene;
    if (which == THUD_CASE_AS_WRITTEN)
        return THUD_OK;
    status = thud_scene_case(&session->scene, which, scene, err);
    snprintf(scene->title, sizeof scene->title, "%.200s, case %s", session->scene.title, thud_case_name(which));
    return status;
}
