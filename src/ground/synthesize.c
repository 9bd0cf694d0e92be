#include "ground/synthesize.h"
#include "base/quantity.h"
#include "base/random.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "ground/oscillator.h"

#define FIELD(name) offsetof(struct thud_synthesis, name)

const struct thud_synthesis_param thud_synthesis_params[] = {
    {"peak", "largest acceleration", THUD_ACCELERATION, "g", THUD_GRAVITY, FIELD(peak_mps2), 1e-6, 100},
    {"pulse-amplitude", "velocity amplitude A of the pulse; 0 for none", THUD_VELOCITY, "m/s", 1,
     FIELD(pulse_amplitude_mps), 0, 100},
    {"pulse-period", "period Tp of the pulse", THUD_TIME, "s", 1, FIELD(pulse_period_s), 0.01, 100},
    {"pulse-cycles", "gamma: how many half cycles the pulse has", THUD_NUMBER, "", 1, FIELD(pulse_cycles), 1, 20},
    {"pulse-phase", "phase nu of the pulse", THUD_NUMBER, "deg", 1, FIELD(pulse_phase_deg), -360, 360},
    {"pulse-time", "time t0 of the pulse's middle", THUD_TIME, "s", 1, FIELD(pulse_time_s), 0, 1000},
    {"ground-frequency", "Kanai-Tajimi frequency of the ground", THUD_NUMBER, "Hz", 1, FIELD(ground_frequency_hz), 0.05,
     50},
    {"ground-damping", "Kanai-Tajimi damping ratio", THUD_NUMBER, "", 1, FIELD(ground_damping), 0.01, 0.99},
    {"cut-frequency", "Clough-Penzien high pass: its frequency", THUD_NUMBER, "Hz", 1, FIELD(cut_frequency_hz), 0.01,
     10},
    {"cut-damping", "Clough-Penzien high pass: its damping ratio", THUD_NUMBER, "", 1, FIELD(cut_damping), 0.01, 0.99},
    {"rise", "the envelope rises as t^2 until then", THUD_TIME, "s", 1, FIELD(rise_s), 0.01, 1000},
    {"hold", "the envelope is 1 until then", THUD_TIME, "s", 1, FIELD(hold_s), 0.01, 1000},
    {"decay", "and falls with this rate from then on", THUD_NUMBER, "1/s", 1, FIELD(decay_ps), 0.001, 100},
    {"duration", "length of the record", THUD_TIME, "s", 1, FIELD(duration_s), 0.1, 1000},
    {"dt", "time step", THUD_TIME, "s", 1, FIELD(dt_s), 0.0001, 0.1},
    {"seed", "of the noise, a whole number", THUD_NUMBER, "", 1, FIELD(seed), 0, 9007199254740992.0},
};
const size_t thud_synthesis_param_count = sizeof thud_synthesis_params / sizeof *thud_synthesis_params;

void thud_synthesis_init(struct thud_synthesis *s)
{
    *s = (struct thud_synthesis){.peak_mps2 = 0.5 * THUD_GRAVITY,
                                 .pulse_period_s = 1,
                                 .pulse_cycles = 2,
                                 .pulse_time_s = 6,
                                 .ground_frequency_hz = 2,
                                 .ground_damping = 0.6,
                                 .cut_frequency_hz = 0.3,
                                 .cut_damping = 0.6,
                                 .rise_s = 3,
                                 .hold_s = 9,
                                 .decay_ps = 0.35,
                                 .duration_s = 40,
                                 .dt_s = 0.01,
                                 .seed = 1};
}

double *thud_synthesis_field(struct thud_synthesis *synthesis, const struct thud_synthesis_param *param)
{
    return (double *)(void *)((char *)synthesis + param->offset);
}

static double shown(const struct thud_synthesis *s, const struct thud_synthesis_param *param)
{
    double value = *thud_synthesis_field((struct thud_synthesis *)s, param) / param->scale;
    double neat = rint(value * 1e9) / 1e9; /* prints 0.821 for 0.821 g, not 0.8209999999999999 */
    return fabs(neat - value) <= 4e-16 * fabs(value) ? neat : value;
}

void thud_synthesis_describe(const struct thud_synthesis *s, const char *prefix, struct thud_text *text)
{
    for (size_t i = 0; i < thud_synthesis_param_count; i++) {
        const struct thud_synthesis_param *param = &thud_synthesis_params[i];
        thud_text_append(text, "%s%s: ", prefix, param->name);
        thud_text_number(text, shown(s, param));
        thud_text_append(text, "%s%s\n", param->unit[0] ? " " : "", param->unit);
    }
}

static enum thud_status refuse(struct thud_error *err, const char *key, const char *what)
{
    return thud_error_refuse(err, THUD_INPUT, key, NULL, "%s", what);
}

static enum thud_status check(const struct thud_synthesis *s, struct thud_error *err)
{
    for (size_t i = 0; i < thud_synthesis_param_count; i++) {
        const struct thud_synthesis_param *param = &thud_synthesis_params[i];
        double value = shown(s, param);
        if (value >= param->least && value <= param->most)
            continue;
        thud_error_set(err, THUD_INPUT, "%g %s is out of range", value, param->unit);
        thud_error_key(err, "%s", param->name);
        thud_error_allow(err, "%g to %g %s", param->least, param->most, param->unit);
        return THUD_INPUT;
    }
    if (s->seed != floor(s->seed))
        return refuse(err, "seed", "must be a whole number");
    if (s->hold_s < s->rise_s)
        return refuse(err, "hold", "must not be before rise");
    if (s->duration_s / s->dt_s > 1e7)
        return refuse(err, "duration", "more than ten million samples");
    double half = s->pulse_cycles * s->pulse_period_s / 2;
    if (s->pulse_amplitude_mps > 0 && (s->pulse_time_s < half || s->pulse_time_s + half > s->duration_s))
        return refuse(err, "pulse-time", "the pulse does not fit: it needs gamma Tp / 2 before and after its middle");
    return THUD_OK;
}

/* Acceleration of the pulse: the derivative of v = A/2 (1 + cos(theta/gamma)) cos(theta + nu), theta = 2 pi fp (t -
 * t0). */
static double pulse(const struct thud_synthesis *s, double t)
{
    double wp = 2 * THUD_PI / s->pulse_period_s, theta = wp * (t - s->pulse_time_s),
           nu = s->pulse_phase_deg * THUD_PI / 180;
    if (fabs(theta) > THUD_PI * s->pulse_cycles)
        return 0;
    double slow = theta / s->pulse_cycles;
    return -s->pulse_amplitude_mps / 2 * wp *
           (sin(slow) / s->pulse_cycles * cos(theta + nu) + (1 + cos(slow)) * sin(theta + nu));
}

/* Nearly normal, mean 0, deviation 1: a sum of twelve uniform numbers needs no logarithm, whose last bit differs
 * between machines. */
static double normal(struct thud_random *random)
{
    double sum = -6;
    for (int i = 0; i < 12; i++)
        sum += thud_random_unit(random);
    return sum;
}

static double envelope(const struct thud_synthesis *s, double t)
{
    if (t < s->rise_s)
        return t * t / (s->rise_s * s->rise_s);
    return t <= s->hold_s ? 1 : exp(-s->decay_ps * (t - s->hold_s));
}

/* Noise under the envelope through the ground, then through the high pass, which leaves no velocity behind. */
static void make_noise(const struct thud_synthesis *s, double *noise, size_t samples)
{
    struct thud_oscillator ground, cut;
    thud_oscillator_init(&ground, 2 * THUD_PI * s->ground_frequency_hz, s->ground_damping, s->dt_s);
    thud_oscillator_init(&cut, 2 * THUD_PI * s->cut_frequency_hz, s->cut_damping, s->dt_s);
    struct thud_random random = {(uint64_t)s->seed};
    double w0 = 0, g0 = 0, x = 0, v = 0, z = 0, zv = 0;
    for (size_t i = 0; i < samples; i++) {
        double w1 = i ? envelope(s, (double)i * s->dt_s) * normal(&random) : 0;
        if (i)
            thud_oscillator_step(&ground, w0, w1, &x, &v);
        double g1 = thud_oscillator_acceleration(&ground, w1, x, v) + w1; /* absolute acceleration */
        if (i)
            thud_oscillator_step(&cut, g0, g1, &z, &zv);
        noise[i] = -thud_oscillator_acceleration(&cut, g1, z, zv);
        w0 = w1;
        g0 = g1;
    }
}

/* The smallest positive s with max |pulse + s noise| = peak: each sample meets the peak at one s of its own. */
static double noise_scale(const double *noise, const double *pulses, size_t samples, double peak)
{
    double scale = INFINITY;
    for (size_t i = 0; i < samples; i++)
        if (noise[i] != 0)
            scale = fmin(scale, (copysign(peak, noise[i]) - pulses[i]) / noise[i]);
    return scale;
}

enum thud_status thud_synthesis_run(const struct thud_synthesis *s, struct thud_record **out, struct thud_error *err)
{
    *out = NULL;
    enum thud_status status = check(s, err);
    if (status)
        return status;
    size_t samples = (size_t)floor(s->duration_s / s->dt_s + 1e-6) + 1;
    double *noise = malloc(2 * samples * sizeof *noise), *pulses = noise ? noise + samples : NULL;
    if (!noise)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    double largest = 0;
    for (size_t i = 0; i < samples; i++) {
        pulses[i] = s->pulse_amplitude_mps > 0 ? pulse(s, (double)i * s->dt_s) : 0;
        largest = fmax(largest, fabs(pulses[i]));
    }
    if (largest >= s->peak_mps2) {
        free(noise);
        return thud_error_refuse(err, THUD_INPUT, "peak", "more than that, or a smaller or longer pulse",
                                 "the pulse alone reaches %.4g g", largest / THUD_GRAVITY);
    }
    make_noise(s, noise, samples);
    double scale = noise_scale(noise, pulses, samples, s->peak_mps2);
    for (size_t i = 0; i < samples; i++)
        noise[i] = rint((pulses[i] + scale * noise[i]) * 1e8) / 1e8;
    status = thud_record_create(noise, samples, s->dt_s, out, err);
    if (status == THUD_OK)
        (*out)->synthetic = true;
    free(noise);
    return status;
}
