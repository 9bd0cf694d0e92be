#include "cli/scene_options.h"

#include <string.h>

/* Option and the key of the scene that it sets. */
static const struct {
    const char *option, *key;
} keys[] = {{"peak", "record.peak"},
            {"dt", "record.dt"},
            {"unit", "record.unit"},
            {"channel", "record.channel"},
            {"column", "record.column"},
            {"skip", "record.skip"},
            {"method", "analysis.method"},
            {"step", "analysis.step"},
            {"tolerance", "analysis.tolerance"},
            {"modes", "analysis.modes"},
            {"sensitivity", "study.sensitivity"}};

static enum thud_status apply(const struct thud_args *args, struct thud_session *session, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    if (thud_args_value(args, "record"))
        thud_session_choose_record(session, thud_args_value(args, "record"));
    for (size_t i = 0; i < sizeof keys / sizeof *keys && status == THUD_OK; i++) {
        const char *value = thud_args_value(args, keys[i].option);
        if (value)
            status = thud_scene_set(&session->scene, keys[i].key, value, err);
        if (status != THUD_OK) {
            char option[32] = "--";
            thud_error_key(err, strncat(option, keys[i].option, sizeof option - 3));
        }
    }
    const char *assignment;
    for (int i = 0; status == THUD_OK && (assignment = thud_args_repeated(args, "set", i)); i++)
        status = thud_session_assign(session, assignment, err);
    return status;
}

enum thud_status thud_scene_options_open(const struct thud_args *args, struct thud_session *session,
                                         struct thud_error *err)
{
    bool has_default = args->command == THUD_COMMAND_BENCH || args->command == THUD_COMMAND_STABILITY ||
                       args->command == THUD_COMMAND_SCREEN;
    const char *preset = args->noperands > 0 ? args->operand[0] : has_default ? "towers" : NULL;
    if (!preset || args->noperands > 1) {
        const char *name = thud_command_at(args->command)->name;
        thud_error_set(err, THUD_USAGE, args->noperands == 0 ? "thud %s needs a preset" : "thud %s takes one preset",
                       name);
        thud_error_allow(err, "a name such as towers, or a file");
        return THUD_USAGE;
    }
    enum thud_status status = thud_session_open(session, preset, err);
    if (status == THUD_OK)
        status = apply(args, session, err);
    if (status != THUD_OK)
        thud_session_close(session);
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
    if (!word)
        return THUD_OK;
    for (int i = 0; i < THUD_CASES; i++)
        if (strcmp(word, thud_case_name((enum thud_case)i)) == 0) {
            *out = (enum thud_case)i;
            return THUD_OK;
        }
    thud_error_set(err, THUD_USAGE, "`%.40s` is no case", word);
    thud_error_key(err, "--case");
    thud_error_allow(err, "none, bumper, cavity");
    return THUD_USAGE;
}
