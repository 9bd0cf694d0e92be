#include "core/laws/law_common.h"

/* What the laws with a line or a power share lies first in their parameters and constants. */
enum { STIFFNESS, EXPONENT };
enum { DASHPOT };

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

double thud_law_energy_line(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    (void)memory;
    return thud_law_power_energy(setup->value[STIFFNESS], 1, d_m);
}

double thud_law_energy_power(const struct thud_law_setup *setup, const struct thud_law_memory *memory, double d_m)
{
    (void)memory;
    return thud_law_power_energy(setup->value[STIFFNESS], setup->value[EXPONENT], d_m);
}

struct thud_branch thud_law_branch_viscoelastic(const struct thud_law_setup *setup,
                                                const struct thud_law_memory *memory, enum thud_phase phase,
                                                bool past_ultimate)
{
    (void)memory;
    (void)phase;
    (void)past_ultimate;
    return (struct thud_branch){.k_npm = setup->value[STIFFNESS], .c_nspm = setup->constant[DASHPOT]};
}
