#include "core/laws/law_common.h"

const char *const thud_damping_choices[] = {"paper", "exact", NULL};

enum thud_status thud_law_check_hertz_stiffness(double stiffness, double exponent, struct thud_error *err)
{
    if (stiffness != THUD_HERTZ_STIFFNESS || exponent == 1.5)
        return THUD_OK;
    thud_error_set(err, THUD_INPUT, "the default is for exponent 1.5, not %g: give the stiffness too", exponent);
    thud_error_key(err, "stiffness");
    thud_error_allow(err, "a number of kN/mm^%g", exponent);
    return THUD_INPUT;
}

double thud_law_nominal_one(const struct thud_law_setup *setup)
{
    (void)setup;
    return 1;
}

double thud_law_restitution_one(const struct thud_law_setup *setup, double v_mps)
{
    (void)setup;
    (void)v_mps;
    return 1;
}

double thud_law_power_energy(double K, double p, double d_m)
{
    return d_m > 0 ? K * pow(d_m, p + 1) / (p + 1) : 0;
}
