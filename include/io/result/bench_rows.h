/* Results of the studies of methods as rows: the bench, its costs, and where methods fail. */
#pragma once

#include "io/file/schema.h"
#include "study/methods/bench.h"
#include "study/methods/stability.h"

extern const struct thud_schema thud_bench_schema, thud_bench_cost_schema, thud_verdict_schema, thud_energies_schema,
    thud_restitution_schema, thud_test_case_schema, thud_stability_summary_schema;

struct thud_rows thud_bench_rows(struct thud_bench *bench);
struct thud_rows thud_bench_cost_rows(const struct thud_bench *bench);
enum { THUD_STABILITY_TABLES = 5 }; /* verdicts, energies, restitutions, test cases, methods */
struct thud_rows thud_stability_rows(const struct thud_stability *stability, int table);
