/* Every kind of row there is: for thud-output(5) and the description of tables. */
#ifndef THUD_IO_SCHEMAS_H
#define THUD_IO_SCHEMAS_H

#include "io/file/schema.h"

const struct thud_schema *thud_schema_at(int i); /* NULL past the last */

#endif
