/* Results of `thud simplify` as rows. */
#pragma once

#include "io/file/schema.h"
#include "study/simplify/simplify.h"

extern const struct thud_schema thud_simplify_schema;
struct thud_rows thud_simplify_table_rows(const struct thud_simplify_found *found);
