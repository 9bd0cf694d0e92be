#include "cli/options.h"

#include <stdio.h>
#include <string.h>

#include "cli/commands.h"

enum thud_status thud_records_named(const struct thud_args *args, const struct thud_session *session, const char *text,
                                    bool both, struct thud_record_list *out, struct thud_error *err)
{
    const char *common[THUD_RECORD_SETTINGS_MAX][2], *setting;
    int n = 0;
    for (int i = 0; (setting = thud_record_setting(i)) != NULL; i++) {
        common[n][0] = setting;
        common[n][1] = thud_args_value(args, setting);
        n += common[n][1] != NULL;
    }
    return thud_record_list_read(session, text, common, n, both, out, err);
}

/* What the scene says of its own record alone, and options for motions that have a size of their own. */
static void tell_unused(const struct thud_args *args, const struct thud_record_list *list)
{
    static const char *const size[] = {"peak", "sa", "factor"};
    struct thud_text names = {0};
    struct thud_error said = {0};
    for (size_t i = 0; i < sizeof size / sizeof *size; i++)
        if (list->own_size > 0 && thud_args_value(args, size[i]))
            thud_text_append(&names, "%s--%s for %d of them", names.size > 0 ? ", " : "", size[i], list->own_size);
    if (list->unused[0])
        thud_text_append(&names, "%s%s", names.size > 0 ? ", " : "", list->unused);
    thud_error_set(&said, THUD_OK, "not used for these ground motions: %s", names.data ? names.data : "");
    thud_error_allow(&said,
                     "record.* is of the preset's own motion; FILE:peak=0.3g goes before --peak, --sa and --factor");
    if (names.data && !thud_args_has(args, "quiet"))
        thud_cli_warn(&said);
    thud_text_clear(&names);
}

void thud_records_warn(const struct thud_args *args, const struct thud_record *const *record, int n)
{
    thud_cli_remarks(args, &(struct thud_remark_scope){.record = record, .nrecords = n}, THUD_REMARK_MOTIONS);
}

enum thud_status thud_records_option_read(const struct thud_args *args, struct thud_session *session,
                                          struct thud_record_list *out, struct thud_error *err)
{
    const struct thud_study_choice *study = &session->scene.study;
    const char *text = thud_args_value(args, "records");
    bool both = thud_args_has(args, "signs") || study->both_signs;
    if (thud_args_has(args, "signs") && strcmp(thud_args_value(args, "signs"), "both") != 0)
        return thud_args_refuse("signs", thud_args_value(args, "signs"), "both; --sign - reverses the polarity", err);
    if (!text && study->records[0] && !thud_args_value(args, "record"))
        text = study->records;
    enum thud_status status = THUD_OK;
    if (!text) {
        status = thud_record_list_own(session, both, out, err);
        if (status == THUD_OK) /* not of its other sign as well */
            thud_records_warn(args, (const struct thud_record *const *)out->record, out->n > 0);
        return status;
    }
    if (thud_args_value(args, "record") && thud_args_value(args, "records"))
        return thud_error_set(err, THUD_USAGE, "--record and --records together");
    status = thud_records_named(args, session, text, both, out, err);
    if (status == THUD_OK)
        tell_unused(args, out);
    if (status == THUD_OK)
        thud_records_warn(args, (const struct thud_record *const *)out->record, out->n);
    return status;
}
