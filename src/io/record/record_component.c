/* One horizontal component out of two: by its direction, or by rotation. The two stand in one file, or the second in a
 * file whose name differs by the component alone (AOM001.EW and AOM001.NS; KJM000.AT2 and KJM090.AT2).
 *     a(theta) = a_1 cos(theta) + a_2 sin(theta)
 * rotd100 is the theta, of 0 to 179 degrees, with the largest pseudo spectral acceleration at a period, and rotd50 that
 * whose one is nearest their median: Boore (2010), Bull. Seism. Soc. Am. 100(4), 1830, whose angle differs from period
 * to period while a ground motion needs one. */
#include "io/record/record_component.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/quantity.h"
#include "base/scan.h"
#include "base/statistics.h"
#include "base/text.h"
#include "ground/identity.h"
#include "ground/record_edit.h"
#include "ground/spectrum.h"
#include "io/file/paths.h"

enum { ANGLES = 180 };

bool thud_component_is_rotated(const char *component)
{
    return strncmp(component, "rot", 3) == 0 || strcmp(component, THUD_COMPONENT_GOVERNS) == 0;
}

/* Names that are alike but for at most so many characters in one place. */
static bool alike(const char *a, const char *b)
{
    enum { APART = 8 };
    size_t n = strlen(a), m = strlen(b), front = 0, back = 0;
    while (a[front] && a[front] == b[front])
        front++;
    while (back < n - front && back < m - front && a[n - 1 - back] == b[m - 1 - back])
        back++;
    return front > 0 && (n > m ? n : m) - front - back <= APART && strcmp(a, b) != 0;
}

/* Whether one is the other horizontal component of the same recording. */
static bool is_pair(const struct thud_record *a, const struct thud_record *b)
{
    const double turn = fabs(thud_record_azimuth(a) - thud_record_azimuth(b));
    const bool said = *a->event && *b->event && *a->station && *b->station;
    return fabs(fmod(turn, 180) - 90) < 1 && fabs(a->dt_s - b->dt_s) <= 1e-9 * a->dt_s && !thud_record_is_vertical(b) &&
           (!said || thud_record_same_station(a, b));
}

enum thud_status thud_record_companion(const char *path, const struct thud_record *record,
                                       const struct thud_record_choice *choice, char *other, size_t size,
                                       struct thud_record **out, struct thud_error *err)
{
    char folder[1024], **name;
    const char *own = thud_path_name(path);
    size_t count;
    *out = NULL;
    if (thud_record_is_vertical(record) || own - path >= (long)sizeof folder)
        return THUD_OK;
    snprintf(folder, sizeof folder, "%.*s", own > path ? (int)(own - path) : 1, own > path ? path : ".");
    enum thud_status status = thud_folder_names(folder, &name, &count, NULL, err);
    for (size_t i = 0; status == THUD_OK && !*out && i < count; i++) {
        struct thud_error no;
        if (!alike(own, name[i]) || snprintf(other, size, "%.*s%s", (int)(own - path), path, name[i]) >= (int)size)
            continue;
        if (thud_record_file_read(other, choice, out, &no) == THUD_OK && !is_pair(record, *out)) {
            thud_record_free(*out);
            *out = NULL;
        }
    }
    if (status == THUD_OK)
        thud_folder_names_free(name, count);
    return status;
}

/* As recorded: what is done to a motion is done to the rotated one. */
static struct thud_record_choice plain(const struct thud_record_choice *choice, int part)
{
    struct thud_record_choice out = *choice;
    out.component[0] = out.event[0] = out.station[0] = out.licence[0] = '\0';
    out.peak_mps2 = out.sa_mps2 = out.from_s = out.to_s = NAN;
    out.target[0] = '\0';
    out.factor = out.sign = 1;
    out.every = 0;
    out.part = part;
    return out;
}

static enum thud_status read_two(const char *path, const struct thud_record_choice *choice, struct thud_record *two[2],
                                 struct thud_error *err)
{
    char other[1100];
    struct thud_record_choice each = plain(choice, 1);
    enum thud_status status = thud_record_file_read(path, &each, &two[0], err);
    if (status != THUD_OK)
        return status;
    if (two[0]->parts > 1) {
        each.part = 2;
        return thud_record_file_read(path, &each, &two[1], err);
    }
    each.part = 0;
    status = thud_record_companion(path, two[0], &each, other, sizeof other, &two[1], err);
    if (status == THUD_OK && !two[1])
        status = thud_error_refuse(err, THUD_INPUT, "component", "a file of both, or two that are named alike",
                                   "the other horizontal component of %.60s is not found", thud_path_name(path));
    return status;
}

static enum thud_status rotate(struct thud_record *const two[2], int degrees, struct thud_record **out,
                               struct thud_error *err)
{
    const size_t n = two[0]->samples < two[1]->samples ? two[0]->samples : two[1]->samples;
    const double c = cos(degrees * THUD_PI / 180), s = sin(degrees * THUD_PI / 180);
    double *a = malloc(n * sizeof *a);
    if (!a)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (size_t i = 0; i < n; i++)
        a[i] = c * two[0]->a_mps2[i] + s * two[1]->a_mps2[i];
    enum thud_status status = thud_record_like(two[0], a, n, two[0]->dt_s, out, err);
    free(a);
    if (status == THUD_OK)
        snprintf((*out)->component, sizeof(*out)->component, "%d deg from %.20s to %.20s", degrees % 360,
                 *two[0]->component ? two[0]->component : "the first",
                 *two[1]->component ? two[1]->component : "the second");
    return status;
}

/* The angle of rotd50 or rotd100, degrees. */
static enum thud_status find_angle(struct thud_record *const two[2], bool largest, double period_s, int *degrees,
                                   struct thud_error *err)
{
    double sa[ANGLES], sorted[ANGLES];
    enum thud_status status = THUD_OK;
    for (int k = 0; k < ANGLES && status == THUD_OK; k++) {
        struct thud_record *turned = NULL;
        status = rotate(two, k, &turned, err);
        sorted[k] = sa[k] = status == THUD_OK ? thud_record_sa(turned, period_s) : 0;
        thud_record_free(turned);
    }
    thud_sort_numbers(sorted, ANGLES);
    const double wanted = largest ? sorted[ANGLES - 1] : 0.5 * (sorted[ANGLES / 2 - 1] + sorted[ANGLES / 2]);
    *degrees = 0;
    for (int k = 1; k < ANGLES; k++)
        if (fabs(sa[k] - wanted) < fabs(sa[*degrees] - wanted))
            *degrees = k;
    return status;
}

enum thud_status thud_record_rotated_read(const char *path, const struct thud_record_choice *choice,
                                          struct thud_record **out, struct thud_error *err)
{
    static const char allowed[] = "a name such as NS, rotd50, rotd100, rot30 (degrees), governs";
    struct thud_record *two[2] = {NULL, NULL};
    const char *word = choice->component;
    int degrees = 0;
    const bool largest = strcmp(word, "rotd100") == 0, median = strcmp(word, "rotd50") == 0;
    enum thud_status status = THUD_OK;
    if (!largest && !median && (!thud_scan_word(&word, "rot") || !thud_scan_count(&word, &degrees) || *word))
        return thud_error_refuse(err, THUD_INPUT, "component", allowed,
                                 strcmp(choice->component, THUD_COMPONENT_GOVERNS) == 0
                                     ? "the direction that governs needs buildings"
                                     : "\"%.30s\" is not understood",
                                 choice->component);
    if ((largest || median) && !(choice->period_s > 0))
        return thud_error_refuse(err, THUD_INPUT, "period", "a time such as 0.5 s, or buildings",
                                 "%s needs the period at which directions are compared", choice->component);
    status = read_two(path, choice, two, err);
    if (status == THUD_OK && fabs(two[0]->dt_s - two[1]->dt_s) > 1e-9 * two[0]->dt_s)
        status = thud_error_refuse(err, THUD_INPUT, "component", "two of one time step",
                                   "the components have time steps of %g and %g s", two[0]->dt_s, two[1]->dt_s);
    if (status == THUD_OK && (largest || median))
        status = find_angle(two, largest, choice->period_s, &degrees, err);
    if (status == THUD_OK)
        status = rotate(two, degrees, out, err);
    thud_record_free(two[0]);
    thud_record_free(two[1]);
    return status;
}
