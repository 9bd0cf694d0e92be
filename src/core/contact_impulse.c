/* Stereomechanical contact: impulses at touch, and holding where the structures go on pushing. */
#include <math.h>

#include "core/run_private.h"

enum thud_status thud_contact_impulse(struct thud_run *run, int contact, struct thud_error *err)
{
    (void)contact;
    (void)run;
    return thud_error_set(err, THUD_INPUT, "stereomechanical contact is not there yet");
}
