#include "cli/study_output.h"

#include "app/sweep/fragility_report.h"
#include "cli/commands.h"
#include "io/file/file.h"
#include "io/result/result_rows.h"
#include "io/result/sweep_csv.h"

static void begin(struct thud_sweep_output *o)
{
    if (o->begun)
        return;
    o->begun = true;
    if (o->format == THUD_SWEEP_OUTPUT_CSV) {
        thud_sweep_csv_header(o->plan, THUD_SWEEP_CSV_FLOORS, &o->text);
    } else {
        thud_text_append(&o->text, "{");
        thud_json_head_of(&o->text, 2, o->plan->scene.name); /* 2: means of drifts are over storeys */
        thud_text_append(&o->text, ", \"rows\": [");
    }
}

enum thud_status thud_sweep_output_point(void *context, const struct thud_sweep_point *point, struct thud_error *err)
{
    struct thud_sweep_output *o = context;
    if (o->format == THUD_SWEEP_OUTPUT_TABLE)
        return THUD_OK;
    begin(o);
    if (o->format == THUD_SWEEP_OUTPUT_CSV)
        thud_sweep_csv_rows(o->plan, THUD_SWEEP_CSV_FLOORS, point, &o->text);
    else
        thud_sweep_json_rows(o->plan, point, &o->row, &o->text);
    return thud_text_print(&o->text, err);
}

enum thud_status thud_sweep_output_end(struct thud_sweep_output *output, const struct thud_remark_scope *scope,
                                       struct thud_error *err)
{
    if (output->format == THUD_SWEEP_OUTPUT_TABLE)
        return THUD_OK;
    begin(output);
    if (output->format == THUD_SWEEP_OUTPUT_JSON) {
        enum thud_status status = THUD_OK;
        thud_text_append(&output->text, "\n]");
        if (output->suite) {
            thud_text_append(&output->text, ", \"statistics\": ");
            status = thud_suite_report(output->suite, THUD_AS_JSON, &output->text, err);
        }
        thud_remarks_json(scope, THUD_REMARKS_OF_STUDY, &output->text);
        thud_text_append(&output->text, "}\n");
        if (status != THUD_OK)
            return status;
    }
    return thud_text_print(&output->text, err);
}
