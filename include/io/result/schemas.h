/* List of every kind of row, for thud-output(5) and the description of tables. */
#pragma once

#include "io/file/schema.h"

const struct thud_schema *thud_schema_at(int i); /* NULL past the last */
