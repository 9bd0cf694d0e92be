#include "cli/study_output.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/record_list.h"
#include "io/file/file.h"
#include "io/file/json.h"
#include "io/result/result_file.h"
#include "io/result/scene_json.h"
#include "io/result/schemas.h"

/* An option and its value, which is cleared. */
static void put_option(struct thud_text *out, const char *option, struct thud_text *value, bool *any)
{
    thud_text_append(out, "%s\n    \"--%s\", ", *any ? "," : "", option);
    thud_json_string(out, value->data ? value->data : "");
    out->failed |= value->failed;
    thud_text_clear(value);
    *any = true;
}

static void put_given(struct thud_text *out, const struct thud_args *args, const char *option, bool *any)
{
    struct thud_text value = {0};
    if (!thud_args_value(args, option))
        return;
    thud_text_append(&value, "%s", thud_args_value(args, option));
    put_option(out, option, &value, any);
}

/* Every value of every axis, so that nothing depends on how it was asked for. */
static void put_options(const struct thud_args *args, const struct thud_sweep_plan *plan, struct thud_text *out)
{
    static const char *const pictures[] = {"best", "format", "size", "font"};
    struct thud_text value = {0};
    const char *setting;
    bool any = false;
    for (int i = 0; i < plan->naxes; i++) {
        thud_text_append(&value, "%s=", plan->axis[i].key);
        for (int v = 0; v < plan->axis[i].n; v++)
            thud_text_append(&value, "%s%s", v > 0 ? "," : "", plan->axis[i].text[v]);
        put_option(out, "vary", &value, &any);
    }
    for (int i = 0; i < plan->ncases; i++)
        thud_text_append(&value, "%s%s", i > 0 ? "," : "", thud_case_name(plan->cases[i]));
    put_option(out, "cases", &value, &any);
    if (plan->sensitivity > 0) {
        thud_text_append(out, ",\n    \"--sensitivity=");
        thud_text_number(out, plan->sensitivity);
        thud_text_append(out, "\"");
    }
    put_given(out, args, "records", &any);
    put_given(out, args, "signs", &any);
    for (int i = 0; thud_args_value(args, "records") && (setting = thud_record_setting(i)) != NULL; i++)
        put_given(out, args, setting, &any);
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; i++)
        put_given(out, args, pictures[i], &any);
}

static void put_records(const struct thud_sweep_plan *plan, struct thud_text *out)
{
    for (int i = 0; i < plan->nrecords; i++) {
        thud_text_append(out, "%s\n    ", i > 0 ? "," : "");
        thud_record_json(plan->record[i], out);
    }
}

/* The first line. */
static void put_head(struct thud_text *out, const struct thud_scene *scene)
{
    thud_text_append(out, "{\n  ");
    thud_json_head(out, scene->name);
    thud_text_append(out, ",\n");
}

static void put_scene(struct thud_text *out, const struct thud_scene *scene, const char *record)
{
    thud_scene_members_json(scene, record, out);
    thud_text_append(out, "\n}\n");
}

void thud_study_file_json(const struct thud_args *args, const struct thud_session *session,
                          const struct thud_sweep_plan *plan, struct thud_text *out)
{
    put_head(out, &session->scene);
    thud_text_append(out, "  \"options\": [");
    put_options(args, plan, out);
    thud_text_append(out, "],\n  \"records\": [");
    put_records(plan, out);
    thud_text_append(out, "],\n");
    put_scene(out, &session->scene, NULL);
}

/* ---- made-by.txt ---- */

static unsigned long long hash_options(unsigned long long h, const struct thud_args *args, const char *const *asked)
{
    const char *value;
    for (; *asked; asked++) {
        h = thud_hash_text(h, thud_args_has(args, *asked) ? *asked : "");
        for (int i = 0; (value = thud_args_repeated(args, *asked, i)) != NULL; i++)
            h = thud_hash_text(h, value);
    }
    return h;
}

/* The command, the scene and its ground motion, in words; the rest is added by the caller. */
static enum thud_status begin_made_by(const struct thud_args *args, const char *group, const struct thud_scene *scene,
                                      struct thud_made_by *out, struct thud_error *err)
{
    struct thud_text text = {0};
    *out = (struct thud_made_by){
        .folder = thud_args_value(args, "o"), .replace = thud_args_has(args, "replace"), .schema = thud_schema_at};
    snprintf(out->group, sizeof out->group, "%s", group);
    struct thud_scene *untitled = malloc(sizeof *untitled); /* what it is called changes no result */
    if (!untitled)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    *untitled = *scene;
    untitled->title[0] = '\0';
    untitled->document = (struct thud_title_block){0};
    thud_scene_json(untitled, NULL, 0, &text);
    free(untitled);
    for (int s = 0; s < scene->nstructures; s++)
        thud_text_append(&text, "%s", scene->structure[s].file_sha256);
    if (!text.failed)
        out->scene = out->asked = thud_hash(THUD_HASH_START, text.data, text.size);
    snprintf(out->what, sizeof out->what, "%s of %.60s", thud_command_at(args->command)->name, scene->name);
    enum thud_status status = text.failed ? thud_error_set(err, THUD_MEMORY, "out of memory") : THUD_OK;
    thud_text_clear(&text);
    return status;
}

static void end_words(const struct thud_args *args, struct thud_made_by *out)
{
    const char *assignment;
    for (int i = 0; (assignment = thud_args_repeated(args, "set", i)) != NULL; i++)
        if (strncmp(assignment, "gap=", 4) != 0)
            thud_append(out->what, sizeof out->what, ", %.60s", assignment);
    for (char *c = out->what; *c; c++)
        *c = (unsigned char)*c < ' ' ? '?' : *c; /* one line */
}

enum thud_status thud_made_by_scene(const struct thud_args *args, const char *group, const struct thud_scene *scene,
                                    const struct thud_record *const *records, int nrecords, const char *const *asked,
                                    struct thud_made_by *out, struct thud_error *err)
{
    const char *value;
    if (!thud_args_has(args, "o"))
        return THUD_OK;
    enum thud_status status = begin_made_by(args, group, scene, out, err);
    out->asked = hash_options(out->asked, args, asked);
    if (scene->nstructures > 1)
        thud_append(out->what, sizeof out->what, ", gap %.6g cm", 100 * scene->interface[0].gap_m);
    for (; *asked; asked++)
        if ((value = thud_args_value(args, *asked)) != NULL)
            thud_append(out->what, sizeof out->what, ", %s %.60s", *asked, value);
    for (int i = 0; i < nrecords; i++)
        if (records[i]) {
            out->asked = thud_hash_text(out->asked, records[i]->file);
            out->asked = thud_hash(out->asked, records[i]->a_mps2, records[i]->samples * sizeof *records[i]->a_mps2);
        }
    if (nrecords > 1)
        thud_append(out->what, sizeof out->what, ", %d ground motions", nrecords);
    else if (nrecords == 1 && records[0])
        thud_append(out->what, sizeof out->what, ", %.60s %.4g g", thud_path_name(records[0]->file),
                    thud_record_peak(records[0]) / THUD_GRAVITY);
    end_words(args, out);
    return status == THUD_OK ? thud_made_by_check(out, err) : status;
}

enum thud_status thud_made_by_study(const struct thud_args *args, const struct thud_sweep_plan *plan,
                                    struct thud_made_by *out, struct thud_error *err)
{
    static const char *const fragility[] = {"event", "hazard", "samples", "seed", NULL};
    enum thud_status status = begin_made_by(args, "study", &plan->scene, out, err);
    unsigned long long whole = thud_sweep_fingerprint(plan);
    out->asked = thud_hash(out->asked, &whole, sizeof whole);
    if (args->command == THUD_COMMAND_FRAGILITY)
        out->asked = hash_options(thud_hash_text(out->asked, "fragility"), args, fragility);
    if (args->command == THUD_COMMAND_FRAGILITY && plan->scene.study.events[0])
        out->asked = thud_hash_text(out->asked, plan->scene.study.events);
    for (int i = 0; i < plan->naxes; i++) {
        const struct thud_sweep_axis *axis = &plan->axis[i];
        if (axis->n > 2)
            thud_append(out->what, sizeof out->what, ", %s %s to %s, %d values", axis->key, axis->text[0],
                        axis->text[axis->n - 1], axis->n);
        else
            thud_append(out->what, sizeof out->what, ", %s %s%s%s", axis->key, axis->text[0],
                        axis->n > 1 ? " and " : "", axis->n > 1 ? axis->text[1] : "");
    }
    thud_append(out->what, sizeof out->what, ", cases");
    for (int i = 0; i < plan->ncases; i++)
        thud_append(out->what, sizeof out->what, "%s%s", i > 0 ? "," : " ", thud_case_name(plan->cases[i]));
    if (plan->nrecords > 1)
        thud_append(out->what, sizeof out->what, ", %d ground motions", plan->nrecords);
    else if (plan->nrecords == 1 && plan->record[0])
        thud_append(out->what, sizeof out->what, ", %.60s", thud_path_name(plan->record[0]->file));
    end_words(args, out);
    return status;
}

enum thud_status thud_made_by_scene_file(const struct thud_args *args, const char *group,
                                         const struct thud_session *session, const struct thud_scene *scene,
                                         const char *const *asked, struct thud_made_by *out, struct thud_error *err)
{
    struct thud_text text = {0};
    if (!thud_args_has(args, "o"))
        return THUD_OK;
    enum thud_status status = thud_made_by_scene(
        args, group, &session->scene, (const struct thud_record *const *)&session->record, 1, asked, out, err);
    if (status == THUD_OK)
        status = thud_made_by_begin(out, err);
    if (status != THUD_OK)
        return status;
    put_head(&text, scene);
    put_scene(&text, scene, session->record ? session->record->file : NULL);
    return thud_text_save(&text, out->folder, "scene.json", THUD_OK, err);
}

enum thud_status thud_made_by_finish(const struct thud_args *args, const struct thud_made_by *by,
                                     enum thud_status before, struct thud_error *err)
{
    if (thud_args_has(args, "o") && before == THUD_CANCELLED) /* what was done stands there */
        thud_made_by_keep(by, NULL);
    return thud_args_has(args, "o") ? thud_made_by_end(by, before, err) : before;
}
