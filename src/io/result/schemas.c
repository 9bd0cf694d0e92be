#include "io/result/schemas.h"

#include "io/result/bench_rows.h"
#include "io/result/list_rows.h"
#include "io/result/result_rows.h"
#include "io/result/simplification_rows.h"
#include "io/result/study_rows.h"
#include "io/result/sweep_csv.h"

static const struct thud_schema *const schemas[] = {
    &thud_impact_schema,         &thud_remark_schema,         &thud_event_schema,
    &thud_floor_schema,          &thud_storey_schema,         &thud_record_schema,
    &thud_method_schema,         &thud_contact_schema,        &thud_column_schema,
    &thud_link_schema,           &thud_energy_schema,         &thud_sweep_floor_schema,
    &thud_sweep_storey_schema,   &thud_sweep_contact_schema,  &thud_need_schema,
    &thud_gap_rule_schema,       &thud_motion_schema,         &thud_curve_key_schema,
    &thud_stripe_schema,         &thud_curve_schema,          &thud_best_schema,
    &thud_truncation_schema,     &thud_bench_schema,          &thud_verdict_schema,
    &thud_energies_schema,       &thud_restitution_schema,    &thud_test_case_schema,
    &thud_motion_info_schema,    &thud_motion_list_schema,    &thud_spectrum_schema,
    &thud_spectrum_point_schema, &thud_verified_schema,       &thud_check_schema,
    &thud_fresh_schema,          &thud_published_schema,      &thud_published_value_schema,
    &thud_history_schema,        &thud_floor_spectrum_schema, &thud_law_schema,
    &thud_law_param_schema,      &thud_methods_schema,        &thud_stiffness_schema,
    &thud_spring_schema,         &thud_mode_schema,           &thud_quantity_schema,
    &thud_effect_schema,         &thud_sample_schema,         &thud_index_schema,
    &thud_tried_schema,          &thud_suite_row_schema,      &thud_median_schema,
    &thud_drawn_schema,          &thud_sampled_motion_schema, &thud_series_schema,
    &thud_gap_fractile_schema,   &thud_gap_range_schema,      &thud_used_motion_schema,
    &thud_first_contact_schema,  &thud_bench_cost_schema,     &thud_stability_summary_schema,
    &thud_simplify_schema,       &thud_gap_row_schema,        &thud_built_schema};

const struct thud_schema *thud_schema_at(int i)
{
    return i < (int)(sizeof schemas / sizeof *schemas) ? schemas[i] : NULL;
}
