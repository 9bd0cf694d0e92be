#include "base/version.h"

#ifndef THUD_COMMIT
#define THUD_COMMIT "unknown"
#endif
#ifndef THUD_VARIANT
#define THUD_VARIANT "unknown"
#endif

void thud_version_name(struct thud_text *out)
{
    thud_text_append(out, "thud %s, commit %s", THUD_VERSION, THUD_COMMIT);
}

void thud_version_text(struct thud_text *out)
{
    thud_text_append(out, "thud %s\nbuild: %s, commit %s, compiler %s, C%ld\n", THUD_VERSION, THUD_VARIANT, THUD_COMMIT,
                     __VERSION__, __STDC_VERSION__);
}
