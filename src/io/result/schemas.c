#include "io/result/schemas.h"

#include "io/result/result_rows.h"
#include "io/result/study_rows.h"
#include "io/result/sweep_csv.h"

static const struct thud_schema *const schemas[] = {
    &thud_impact_schema,        &thud_event_schema,  &thud_floor_schema,       &thud_storey_schema,
    &thud_record_schema,        &thud_method_schema, &thud_contact_schema,     &thud_column_schema,
    &thud_link_schema,          &thud_energy_schema, &thud_sweep_floor_schema, &thud_sweep_storey_schema,
    &thud_sweep_contact_schema, &thud_need_schema,   &thud_gap_rule_schema,    &thud_motion_schema,
    &thud_curve_key_schema,     &thud_stripe_schema, &thud_curve_schema,       &thud_best_schema,
    &thud_truncation_schema};

const struct thud_schema *thud_schema_at(int i)
{
    return i < (int)(sizeof schemas / sizeof *schemas) ? schemas[i] : NULL;
}
