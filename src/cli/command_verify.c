/* thud verify: presets against their stored expectations, or what others published against what is computed. */
#include <stdio.h>

#include "app/verify/verify_preset.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "io/file/file.h"
#include "io/file/paths.h"
#include "io/result/list_rows.h"

/* Over all presets. */
struct total {
    int presets, refused, count[THUD_GONE + 1];
    enum thud_status status; /* the first thing that went wrong with a preset */
    bool data;               /* as rows */
    struct thud_list list;
};

/* The difference is shown before anything is written. */
static enum thud_status deliver(const struct thud_args *args, struct thud_verification *v, struct total *total,
                                struct thud_error *err)
{
    struct thud_text text = {0};
    total->list.out = &text;
    if (total->data)
        thud_verify_add(v, &total->list);
    else
        thud_verify_table(v, args->noperands == 1 && !v->update, &text);
    total->presets++;
    for (int i = 0; i <= THUD_GONE; i++)
        total->count[i] += v->count[i];
    thud_progress_wipe();
    enum thud_status status = (total->data ? thud_text_print : thud_cli_print)(&text, err);
    if (status != THUD_OK || !v->update)
        return status;
    status = thud_verify_write(v, err);
    if (status == THUD_OK && !total->data) {
        thud_text_append(&text, "  %s: %s\n", v->path, v->written ? "written" : "as it was");
        status = thud_cli_print(&text, err);
    }
    return status;
}

/* Reports a preset that cannot be verified and takes the next one; an error of the machine ends the command. */
static enum thud_status one(const struct thud_args *args, const char *preset, struct total *total,
                            struct thud_error *err)
{
    struct thud_verification v;
    struct thud_error own = {0};
    enum thud_status status = thud_verify_preset(preset, thud_args_has(args, "update"), thud_progress_what, &v, &own);
    if (status == THUD_OK) {
        status = deliver(args, &v, total, err);
        thud_verify_clear(&v);
        return status;
    }
    thud_progress_wipe();
    if (status != THUD_INPUT && status != THUD_DIVERGED) {
        if (err)
            *err = own;
        return status;
    }
    thud_cli_complain(&own);
    total->refused++;
    if (total->status == THUD_OK)
        total->status = status;
    return THUD_OK;
}

static enum thud_status finish(const struct thud_args *args, struct total *total, struct thud_error *err)
{
    struct thud_text text = {0};
    int wrong = total->count[THUD_MOVED] + total->count[THUD_GONE];
    total->list.out = &text;
    if (total->data)
        thud_list_end(&total->list);
    else if (total->presets > 1 || (total->presets == 1 && total->refused > 0)) {
        thud_text_append(&text, "%d preset%s: %d hold, %d moved, %d gone", total->presets,
                         total->presets == 1 ? "" : "s", total->count[THUD_HOLDS], total->count[THUD_MOVED],
                         total->count[THUD_GONE]);
        if (total->refused > 0)
            thud_text_append(&text, "; %d could not be verified", total->refused);
        thud_text_append(&text, "\n");
    }
    enum thud_status status = (total->data ? thud_text_print : thud_cli_print)(&text, err);
    if (status != THUD_OK || total->status != THUD_OK)
        return status != THUD_OK ? status : total->status;
    return wrong > 0 && !thud_args_has(args, "update") ? THUD_CHECK : THUD_OK;
}

static enum thud_status published(const struct thud_args *args, struct thud_error *err)
{
    struct thud_published_result result[THUD_PUBLISHED_COUNT];
    struct thud_record_treatment motion;
    struct thud_record_choice *choice = NULL;
    struct thud_text text = {0};
    if (args->noperands > 0 || thud_args_has(args, "update"))
        return thud_error_set(err, THUD_USAGE, "--published takes neither presets nor --update");
    enum thud_status status = thud_record_options_read(args, &motion, err);
    if (status == THUD_OK && thud_args_has(args, "record")) {
        choice = &motion.choice;
        snprintf(choice->file, sizeof choice->file, "%s", thud_args_value(args, "record"));
    }
    for (int i = 0; i < THUD_PUBLISHED_COUNT && status == THUD_OK; i++)
        status = thud_published_verify((enum thud_published)i, choice, &result[i], err);
    if (status != THUD_OK)
        return status;
    bool json = thud_args_has(args, "json"), data = json || thud_args_has(args, "csv");
    if (data)
        thud_published_put(result, json, &text);
    else
        thud_published_table(result, &text);
    status = (data ? thud_text_print : thud_cli_print)(&text, err);
    return status == THUD_OK && thud_published_wrong(result) > 0 ? THUD_CHECK : status;
}

enum thud_status thud_command_verify(const struct thud_args *args, struct thud_error *err)
{
    if (thud_args_has(args, "published"))
        return published(args, err);
    if (thud_args_has(args, "record"))
        return thud_error_set(err, THUD_USAGE, "--record goes with --published");
    bool json = thud_args_has(args, "json");
    struct thud_text text = {0};
    struct total total = {.status = THUD_OK,
                          .data = json || thud_args_has(args, "csv"),
                          .list = {&text, &thud_verified_schema, &thud_check_schema, json, 0}};
    struct thud_paths paths;
    struct thud_file_names names;
    thud_paths_find(&paths);
    names.n = 0;
    if (args->noperands == 0)
        thud_paths_presets(&paths, &names);
    int n = args->noperands > 0 ? args->noperands : names.n;
    if (n == 0)
        return thud_error_in(err, THUD_INPUT, paths.presets, 0, "there is no preset");
    enum thud_status status = THUD_OK;
    if (total.data) {
        thud_list_begin(&total.list, "presets");
        status = thud_text_print(&text, err);
    }
    thud_progress_start(args);
    for (int i = 0; i < n && status == THUD_OK; i++) {
        char path[640];
        if (args->noperands == 0)
            snprintf(path, sizeof path, "%s/%s.yaml", paths.presets, names.list[i]);
        status = one(args, args->noperands > 0 ? args->operand[i] : path, &total, err);
    }
    thud_progress_end();
    return status == THUD_OK ? finish(args, &total, err) : status;
}
