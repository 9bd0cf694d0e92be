#include "cli/study_file.h"

#include "app/run/record_list.h"
#include "base/version.h"
#include "io/file/file.h"
#include "io/file/json.h"
#include "io/result/result_file.h"
#include "io/result/scene_json.h"

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
    thud_text_append(out, "{\n  \"preset\": ");
    thud_json_string(out, scene->name);
    thud_text_append(out, ", \"version\": \"%s\",\n", THUD_VERSION);
}

static void put_scene(struct thud_text *out, const struct thud_scene *scene, const char *record)
{
    thud_text_append(out, "  \"scene\": ");
    thud_scene_json(scene, record, 4, out);
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

enum thud_status thud_scene_file_write(const struct thud_args *args, const struct thud_scene *scene,
                                       const struct thud_record *record, struct thud_error *err)
{
    const char *folder = thud_args_value(args, "o");
    struct thud_text text = {0};
    if (!folder)
        return THUD_OK;
    enum thud_status status = thud_folder_make(folder, err);
    if (status != THUD_OK)
        return status;
    put_head(&text, scene);
    put_scene(&text, scene, record ? record->file : NULL);
    return thud_text_write_in(&text, folder, "scene.json", err);
}
