/* The formats of record files: one table each, in its own file. */
#ifndef THUD_IO_RECORD_FORMATS_H
#define THUD_IO_RECORD_FORMATS_H

#include <stdbool.h>

#include "io/record/record_source.h"

/* `recognize` looks at content only. `read` fills `raw` (empty, with dt and factor NaN); it may leave dt and factor for
 * the user to give. */
struct record_format {
    const char *name;
    bool plain; /* says nothing of itself: also what is left after --skip is read so */
    bool (*recognize)(const struct record_source *source);
    enum thud_status (*read)(const struct record_source *source, const struct thud_record_choice *choice,
                             struct record_raw *raw, struct thud_error *err);
};

/* The first that recognizes a file reads it. */
/* clang-format off */
#define RECORD_FORMATS(X) \
    X(at2) X(knet) X(kiknet) X(esm) X(cosmos) X(smc) X(csmip) X(geonet) X(at2_bare) X(csv) X(columns)
/* clang-format on */
#define RECORD_DECLARE(name) extern const struct record_format record_format_##name;
RECORD_FORMATS(RECORD_DECLARE)
#undef RECORD_DECLARE

#endif
