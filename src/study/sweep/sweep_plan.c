/* A study's plan: axes read from text, points numbered, the scene of a point. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/scene/scene_elements.h"
#include "study/sweep/measure.h"
#include "study/sweep/sweep.h"
#include "study/sweep/sweep_private.h"

enum { VALUES_MAX = 100000, TEXT = THUD_NAME_MAX };
static const double points_max = 1e9;

void thud_sweep_plan_init(struct thud_sweep_plan *plan, const struct thud_scene *scene)
{
    memset(plan, 0, sizeof *plan);
    plan->scene = *scene;
    plan->has = thud_scene_features(scene);
    plan->ncases = 1;
    plan->cases[0] = THUD_CASE_AS_WRITTEN;
    plan->shortcuts = THUD_SWEEP_ALL;
}

static void clear_axis(struct thud_sweep_axis *axis)
{
    free(axis->value);
    free(axis->text);
    *axis = (struct thud_sweep_axis){0};
}

void thud_sweep_plan_clear(struct thud_sweep_plan *plan)
{
    for (int i = 0; i < plan->naxes; i++)
        clear_axis(&plan->axis[i]);
    plan->naxes = plan->nouter = 0;
}

static enum thud_status refuse(struct thud_error *err, const char *key, const char *what, const char *allowed)
{
    return thud_error_refuse(err, THUD_USAGE, key, allowed, "%s", what);
}

static const char how[] = "KEY=FROM:TO:STEP or KEY=V1,V2,..., e.g. gap=5 cm:25 cm:0.5 cm";

/* Next part of a list up to `separator`, brackets kept together, blanks around it dropped. false: too long. */
static bool next_part(const char **text, char separator, char part[TEXT])
{
    const char *from = *text, *to = from;
    int depth = 0;
    for (; *to && (depth > 0 || *to != separator); to++)
        depth += (*to == '[') - (*to == ']');
    *text = *to ? to + 1 : NULL;
    while (*from == ' ')
        from++;
    while (to > from && to[-1] == ' ')
        to--;
    if (to - from >= TEXT)
        return false;
    memcpy(part, from, (size_t)(to - from));
    part[to - from] = '\0';
    return true;
}

/* The unit that stands after the number in `text`; NULL where it does not begin with a number. */
static const char *unit_of(const char *text)
{
    const char *end;
    double number;
    if (thud_number_parse(text, &end, &number) != 0)
        return NULL;
    return end + strspn(end, " ");
}

static enum thud_status reserve(struct thud_sweep_axis *axis, int n, struct thud_error *err)
{
    axis->value = calloc((size_t)n, sizeof *axis->value);
    axis->text = calloc((size_t)n, sizeof *axis->text);
    if (!axis->value || !axis->text)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    return THUD_OK;
}

/* SI value of a text; NaN for what is no single number. */
static double value_of(const struct thud_param *param, const char *text)
{
    struct thud_quantity q;
    if (param->kind == THUD_PARAM_QUANTITY && thud_quantity_parse(text, param->dimension, NULL, &q, NULL) == THUD_OK)
        return q.value;
    const char *end;
    if (param->kind == THUD_PARAM_INTEGER && thud_number_parse(text, &end, &q.value) == 0 && *end == '\0')
        return q.value;
    return NAN;
}

/* `14cm` as `14 cm`: the number that ends before `end` with this unit. */
static void with_unit(char text[TEXT], const char *end, const char *unit)
{
    char number[TEXT], whole[2 * TEXT];
    snprintf(number, sizeof number, "%.*s", (int)(end - text), text);
    number[strcspn(number, " ")] = '\0';
    int length = snprintf(whole, sizeof whole, "%s%s%s", number, *unit ? " " : "", unit);
    if (length < TEXT)
        memcpy(text, whole, (size_t)length + 1);
}

/* Where a text is no number all are words, which have places. */
static void number_words(struct thud_sweep_axis *axis)
{
    for (int i = 0; i < axis->n; i++)
        axis->words = axis->words || isnan(axis->value[i]);
    for (int i = 0; axis->words && i < axis->n; i++)
        axis->value[i] = i;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int by_text(const void *a, const void *b)
{
    return strcmp(a, b);
}

/* A value that is there twice, as a decimal comma makes it: 5,5 cm is 5 cm and 5 cm. */
static enum thud_status check_twice(const struct thud_sweep_axis *axis, struct thud_error *err)
{
    size_t n = (size_t)axis->n, size = axis->words ? sizeof *axis->text : sizeof *axis->value;
    int (*order)(const void *, const void *) = axis->words ? by_text : by_value;
    char *sorted = malloc(n * size);
    if (!sorted)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    memcpy(sorted, axis->words ? (const void *)axis->text : axis->value, n * size);
    qsort(sorted, n, size, order);
    bool twice = false;
    for (size_t i = 1; i < n; i++)
        twice |= order(sorted + i * size, sorted + (i - 1) * size) == 0;
    free(sorted);
    return twice ? refuse(err, axis->key, "names a value twice", "each value once; a decimal point is a point: 5.5 cm")
                 : THUD_OK;
}

/* V1,V2,...: a bare number takes the unit of the last one. */
static enum thud_status list(struct thud_sweep_axis *axis, const char *text, struct thud_error *err)
{
    int n = 1;
    for (const char *p = text; *p; p++)
        n += *p == ',';
    if (n > VALUES_MAX)
        return refuse(err, axis->key, "too many values", how);
    enum thud_status status = reserve(axis, n, err);
    if (status != THUD_OK)
        return status;
    while (text) {
        if (!next_part(&text, ',', axis->text[axis->n]) || !axis->text[axis->n][0])
            return refuse(err, axis->key, "a value is empty or too long", how);
        axis->n++;
    }
    axis->range[0] = axis->range[1] = axis->range[2] = NAN;
    const char *unit = unit_of(axis->text[axis->n - 1]);
    for (int i = 0; i < axis->n; i++) {
        char *t = axis->text[i];
        const char *own = unit_of(t);
        if (unit && own && axis->param->kind == THUD_PARAM_QUANTITY)
            with_unit(t, own, *own ? own : unit);
        axis->value[i] = value_of(axis->param, t);
    }
    number_words(axis);
    return check_twice(axis, err);
}

/* Parts of a range in units of different dimensions: whether the key can be in all of them, as in % and a bare ratio.
 */
static enum thud_status check_parts(const struct thud_sweep_axis *axis, char part[3][TEXT], struct thud_error *err)
{
    struct thud_quantity unused;
    for (int i = 0; i < 3; i++)
        if (thud_quantity_parse(part[i], axis->param->dimension, "", &unused, err) != THUD_OK) {
            thud_error_key(err, "%s", axis->key);
            return THUD_INPUT;
        }
    return THUD_OK;
}

/* FROM:TO:STEP: values in the unit of TO, free of the rounding of sums. */
static enum thud_status range(struct thud_sweep_axis *axis, const char *text, struct thud_error *err)
{
    char part[3][TEXT];
    double number[3], factor[3];
    const char *unit[3], *end;
    for (int i = 0; i < 3; i++) {
        if (!text || !next_part(&text, ':', part[i]) || thud_number_parse(part[i], &end, &number[i]) != 0)
            return refuse(err, axis->key, "is no range of numbers", how);
        unit[i] = end + strspn(end, " ");
    }
    if (text || (axis->param->kind != THUD_PARAM_QUANTITY && axis->param->kind != THUD_PARAM_INTEGER))
        return refuse(err, axis->key, "is no range of numbers", how);
    enum thud_dimension dimension[3] = {THUD_NUMBER, THUD_NUMBER, THUD_NUMBER};
    for (int i = 2; i >= 0; i--) {
        if (!*unit[i])
            unit[i] = unit[2];
        factor[i] = *unit[i] ? thud_unit_factor(unit[i], &dimension[i], NULL) : 1;
        if (factor[i] == 0)
            return refuse(err, axis->key, "has an unknown unit", thud_dimension_units(axis->param->dimension));
    }
    if ((dimension[0] != dimension[1] || dimension[2] != dimension[1]) && check_parts(axis, part, err) != THUD_OK)
        return THUD_INPUT;
    for (int i = 0; i < 3; i++)
        axis->range[i] = number[i] * factor[i];
    double from = number[0] * factor[0] / factor[1], step = number[2] * factor[2] / factor[1];
    double count = floor((number[1] - from) / step + 1e-9) + 1;
    if (count > VALUES_MAX && step != 0)
        return refuse(err, axis->key, "the step makes too many values", "at most 100000 of a key");
    if (step == 0 || !(count >= 1))
        return refuse(err, axis->key, "the step does not lead from the first value to the last", how);
    enum thud_status status = reserve(axis, (int)count, err);
    for (; status == THUD_OK && axis->n < (int)count; axis->n++) {
        int written =
            snprintf(axis->text[axis->n], TEXT, "%.12g%s%s", from + axis->n * step, *unit[1] ? " " : "", unit[1]);
        if (written >= TEXT)
            return refuse(err, axis->key, "a value is too long", how);
        axis->value[axis->n] = value_of(axis->param, axis->text[axis->n]);
    }
    if (status == THUD_OK)
        number_words(axis);
    return status;
}

/* Whether a key changes the motion without pounding. */
static bool is_outer(const char *key)
{
    static const char *const contact[] = {"interfaces.", "contact.", "bumper."};
    const char *last = strrchr(key, '.'), *name = last ? last + 1 : key;
    /* other contacts, whose motion relative to each other is read */
    if (strcmp(name, "levels") == 0 || strcmp(name, "contact-levels") == 0)
        return true;
    for (size_t i = 0; i < sizeof contact / sizeof *contact; i++)
        if (strncmp(key, contact[i], strlen(contact[i])) == 0)
            return false;
    return strcmp(key, "gap") != 0;
}

/* Every value can be set. */
static enum thud_status try_values(const struct thud_sweep_plan *plan, const struct thud_sweep_axis *axis,
                                   struct thud_error *err)
{
    struct thud_scene *scratch = malloc(sizeof *scratch);
    if (!scratch)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = THUD_OK;
    for (int i = 0; i < axis->n && status == THUD_OK; i++) {
        thud_scene_copy(scratch, &plan->scene);
        status = thud_scene_set(scratch, axis->key, axis->text[i], err);
    }
    free(scratch);
    return status;
}

/* The period of a spectral acceleration that is varied, where it is the same at every point. */
static void find_period(struct thud_sweep_plan *plan)
{
    struct thud_record_choice choice = plan->scene.record;
    bool same = true;
    for (int a = 0; a < plan->naxes; a++)
        same &= choice.period_s > 0 || strncmp(plan->axis[a].key, "structures.", 11) != 0;
    for (int a = 0; a < plan->naxes; a++) {
        if (strcmp(plan->axis[a].key, "record.sa") != 0)
            continue;
        choice.sa_mps2 = plan->axis[a].value[0];
        if (!same || thud_record_choice_resolve(&plan->scene, &choice, NULL) != THUD_OK)
            choice.period_s = NAN;
        plan->axis[a].period_s = choice.period_s;
    }
}

/* Where the scene's own value stands among those of an axis; -1: nowhere. */
static int own_place(const struct thud_scene *scene, const struct thud_sweep_axis *axis)
{
    static const double rounding = 1e-9; /* of values that are written and read in two units */
    char text[TEXT];
    if (axis->words || thud_scene_get(scene, axis->key, text, sizeof text, NULL) != THUD_OK)
        return -1;
    const double own = value_of(axis->param, text);
    int place = axis->n - 1;
    while (place >= 0 && !(fabs(axis->value[place] - own) <= rounding * fabs(own)))
        place--;
    return place;
}

static long product(const struct thud_sweep_plan *plan, int from)
{
    long n = 1;
    for (int i = from; i < plan->naxes; i++)
        n *= plan->axis[i].n;
    return n;
}

/* Features of the scene, and those by varied keys. */
static unsigned features(const struct thud_sweep_plan *plan)
{
    unsigned has = thud_scene_features(&plan->scene);
    struct thud_scene *at = malloc(sizeof *at);
    for (int a = 0; at && a < plan->naxes; a++)
        for (int v = 0; v < plan->axis[a].n; v++)
            if (thud_sweep_scene(plan, v * product(plan, a + 1), at, NULL) == THUD_OK &&
                thud_scene_check(at, NULL) == THUD_OK)
                has |= thud_scene_features(at);
    free(at);
    return has;
}

static void insert_axis(struct thud_sweep_plan *plan, const struct thud_sweep_axis *axis)
{
    int at = is_outer(axis->key) ? plan->nouter++ : plan->naxes;
    memmove(plan->axis + at + 1, plan->axis + at, (size_t)(plan->naxes - at) * sizeof *axis);
    plan->axis[at] = *axis;
    plan->axis[at].own = own_place(&plan->scene, axis);
    plan->naxes++;
    plan->has = features(plan);
    find_period(plan);
}

static enum thud_status check_axis(const struct thud_sweep_plan *plan, const struct thud_sweep_axis *axis,
                                   struct thud_error *err)
{
    static const char *const scaling[] = {"record.peak", "record.sa", "record.factor", "record.sign"};
    bool scales = false;
    for (size_t i = 0; i < sizeof scaling / sizeof *scaling; i++)
        scales |= strcmp(axis->key, scaling[i]) == 0;
    if (strncmp(axis->key, "record.", 7) == 0 && !scales)
        return refuse(
            err, axis->key, "cannot be varied",
            "record.peak, record.sa, record.factor, record.sign; other ground motions by the study's `records`");
    if (strncmp(axis->key, "study.", 6) == 0 || strncmp(axis->key, "analysis.", 9) == 0)
        return refuse(err, axis->key, "cannot be varied", "keys of structures, interfaces and record.peak");
    for (int i = 0; i < plan->naxes; i++)
        if (strcmp(plan->axis[i].key, axis->key) == 0)
            return refuse(err, axis->key, "is varied twice", "each key once");
    if (plan->naxes == THUD_VARY_MAX)
        return refuse(err, axis->key, "is one key too many", "at most 4 varied keys");
    double points = axis->n;
    for (int i = 0; i < plan->naxes; i++)
        points *= plan->axis[i].n;
    return points <= points_max ? THUD_OK : refuse(err, axis->key, "makes too many runs", "at most 1e9 points");
}

enum thud_status thud_sweep_vary(struct thud_sweep_plan *plan, const char *text, struct thud_error *err)
{
    struct thud_sweep_axis axis = {0};
    const char *equals = strchr(text, '=');
    if (!equals || equals == text || (size_t)(equals - text) >= sizeof axis.key || !equals[1])
        return refuse(err, "vary", "is not understood", how);
    memcpy(axis.key, text, (size_t)(equals - text));
    int floor;
    axis.param = thud_scene_param(&plan->scene, axis.key, &floor);
    if (!axis.param) { /* setting it says what is wrong with the key */
        struct thud_scene *scratch = malloc(sizeof *scratch);
        if (!scratch)
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        *scratch = plan->scene;
        enum thud_status unknown = thud_scene_set(scratch, axis.key, equals + 1, err);
        free(scratch);
        return unknown != THUD_OK ? unknown : refuse(err, axis.key, "cannot be varied", how);
    }
    if (thud_scene_is_words(&plan->scene, axis.key))
        return refuse(err, axis.key, "changes no result, and cannot be varied", how);
    enum thud_status status = strchr(equals + 1, ':') ? range(&axis, equals + 1, err) : list(&axis, equals + 1, err);
    if (status == THUD_OK)
        status = check_axis(plan, &axis, err);
    if (status == THUD_OK)
        status = try_values(plan, &axis, err);
    if (status == THUD_OK)
        insert_axis(plan, &axis);
    else
        clear_axis(&axis);
    return status;
}

enum thud_status thud_sweep_cases(struct thud_sweep_plan *plan, const char *text, struct thud_error *err)
{
    struct thud_error why = {0};
    plan->ncases = 0;
    if (!text || thud_cases_parse(text, plan->cases, &plan->ncases, &why) == THUD_OK)
        return THUD_OK;
    return refuse(err, "cases", why.what, why.allowed);
}

enum thud_status thud_sweep_study(struct thud_sweep_plan *plan, bool axes, bool cases, struct thud_error *err)
{
    const struct thud_study_choice *study = &plan->scene.study;
    for (int i = 0; axes && i < study->nvary; i++) {
        char text[THUD_VARY_TEXT];
        thud_study_vary_text(&plan->scene, i, text, sizeof text);
        enum thud_status status = thud_sweep_vary(plan, text, err);
        if (status != THUD_OK)
            return status;
    }
    plan->sensitivity = study->sensitivity;
    if (cases && study->ncases > 0) {
        plan->ncases = study->ncases;
        memcpy(plan->cases, study->cases, (size_t)study->ncases * sizeof *plan->cases);
    }
    return THUD_OK;
}

long thud_sweep_points(const struct thud_sweep_plan *plan)
{
    return product(plan, 0) * (plan->nrecords > 0 ? plan->nrecords : 1);
}

long thud_sweep_points_per_group(const struct thud_sweep_plan *plan)
{
    return product(plan, plan->nouter);
}

int thud_sweep_place(const struct thud_sweep_plan *plan, long point, int *at)
{
    for (int i = plan->naxes - 1; i >= 0; i--) {
        at[i] = (int)(point % plan->axis[i].n);
        point /= plan->axis[i].n;
    }
    return (int)point;
}

const char *thud_sweep_setting(const struct thud_sweep_plan *plan, int n, const int *at, int but, bool keys, char *text,
                               size_t size)
{
    snprintf(text, size, "%s", n > 0 ? "" : "nominal");
    for (int a = 0; a < n; a++)
        if (a != but)
            thud_append(text, size, "%s%s%s%s", *text ? ", " : "", keys ? plan->axis[a].key : "", keys ? " " : "",
                        at[a] < 0 ? "-" : plan->axis[a].text[at[a]]);
    return text;
}

bool thud_is_spread(int n, int i)
{
    enum { MOST = 5 };
    bool shown = n <= MOST;
    for (int j = 0; j < MOST && !shown; j++)
        shown = i == (j * (n - 1) + (MOST - 1) / 2) / (MOST - 1);
    return shown;
}

bool thud_sweep_is_spread(const struct thud_sweep_plan *plan, const int *at, int but)
{
    for (int a = 0; a < plan->naxes; a++)
        if (a != but && at[a] != plan->axis[a].own && !thud_is_spread(plan->axis[a].n, at[a]))
            return false;
    return true;
}

enum thud_status thud_sweep_scene(const struct thud_sweep_plan *plan, long point, struct thud_scene *out,
                                  struct thud_error *err)
{
    int at[THUD_VARY_MAX] = {0};
    thud_sweep_place(plan, point, at);
    thud_scene_copy(out, &plan->scene);
    enum thud_status status = THUD_OK;
    /* keys that determine others come first, so that what they determine is refused whatever the order of the axes */
    for (int i = 0; i < 2 * plan->naxes && status == THUD_OK; i++) {
        const struct thud_sweep_axis *axis = &plan->axis[i % plan->naxes];
        const char *name = strrchr(axis->key, '.') ? strrchr(axis->key, '.') + 1 : axis->key;
        if ((thud_key_rank(name, strlen(name)) == THUD_RANK_LAST) == (i < plan->naxes))
            status = thud_scene_set(out, axis->key, axis->text[at[i % plan->naxes]], err);
    }
    for (int i = 0; i < plan->naxes && status == THUD_OK; i++) /* what another value of the law needs */
        if (strstr(plan->axis[i].key, ".isolator.law"))
            thud_isolator_keep_own(&out->structure[atoi(plan->axis[i].key + strlen("structures.")) - 1]);
    return status;
}

enum thud_status thud_sweep_case(const struct thud_sweep_plan *plan, const struct thud_scene *scene,
                                 enum thud_case which, int variant, bool check, struct thud_scene *cased,
                                 struct thud_error *err)
{
    enum thud_change change;
    double factor;
    enum thud_status status = thud_scene_case(scene, which, cased, err);
    if (status == THUD_OK && check)
        status = thud_scene_check(cased, err);
    if (status == THUD_OK && thud_sweep_variant(plan, variant, &change, &factor))
        thud_change_scene(cased, change, factor);
    return status;
}

const struct thud_gap_level *thud_sweep_levels(const struct thud_sweep_point *point, enum thud_case which)
{
    return point->level + thud_sweep_linkage(point->nlinkages, which) * point->ncontacts;
}

const struct thud_collapse *thud_sweep_fall(const struct thud_sweep_point *point, enum thud_case which)
{
    return &point->fall[thud_sweep_linkage(point->nlinkages, which)];
}
