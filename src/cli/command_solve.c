/* thud solve: which value makes something hold. */
#include <stdlib.h>

#include "app/sweep/solve.h"
#include "cli/commands.h"
#include "cli/options.h"

/* --share: above 0, at most 1; all without it. */
static enum thud_status read_share(const struct thud_args *args, double *share, struct thud_error *err)
{
    const char *text = thud_args_value(args, "share");
    struct thud_quantity q = {.value = 1};
    if (text && (thud_quantity_parse(text, THUD_RATIO, NULL, &q, NULL) != THUD_OK || !(q.value > 0 && q.value <= 1)))
        return thud_error_refuse(err, THUD_USAGE, "--share", "above 0, at most 100 %",
                                 "is no share of the ground motions");
    *share = q.value;
    return THUD_OK;
}

enum thud_status thud_command_solve(const struct thud_args *args, struct thud_session *session,
                                    struct thud_scene *scene, struct thud_error *err)
{
    struct thud_record_list records = {0};
    struct thud_criterion criterion;
    struct thud_text text = {0};
    double share;
    const char *what = thud_args_value(args, "for"), *by = thud_args_value(args, "by");
    struct thud_solve *found = malloc(sizeof *found);
    enum thud_status status = found ? read_share(args, &share, err) : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK && !what)
        status = thud_error_refuse(err, THUD_USAGE, "--for", "e.g. --for \"force < 10 MN\"", "says what has to hold");
    if (status == THUD_OK && !by)
        status = thud_error_refuse(err, THUD_USAGE, "--by", "e.g. --by gap=2cm:20cm", "says which value may change");
    if (status == THUD_OK && (status = thud_criterion_parse(what, &criterion, err)) != THUD_OK)
        thud_args_key("for", err);
    if (status == THUD_OK)
        status = thud_scene_options_of_case(args, session, scene, err);
    if (status == THUD_OK)
        status = thud_records_option_read(args, session, &records, err);
    if (status == THUD_OK) {
        status = thud_solve_run(scene, &records, by, &criterion, share, thud_interrupt_watch(), found, err);
        if (status == THUD_USAGE)
            thud_args_key("by", err);
    }
    if (status == THUD_OK)
        (thud_args_has(args, "json")  ? thud_solve_json
         : thud_args_has(args, "csv") ? thud_solve_csv
                                      : thud_solve_report)(found, &text);
    status = thud_cli_print_as(args, &text, status, err);
    thud_record_list_clear(&records);
    free(found);
    return status;
}
