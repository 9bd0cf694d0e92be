/* Cases: the same scene without the bumper, with it flush on the wall, or set in a cavity. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "study/scene/scene.h"
#include "study/scene/scene_words.h"

/* Words of a case by what the scene has: a bumper, links alone, both, or nothing that a case would omit; where not
 * given, those of a bumper. */
struct words {
    const char *title, *phrase;
};
enum { OF_BUMPER, OF_LINKS, OF_BOTH, OF_NOTHING, MEASURES };
static const struct {
    const char *name;
    struct words words[MEASURES];
} known[THUD_CASES + 3] = {
    {"no-pounding", {{"no pounding", "without pounding"}}},
    {"as-written", {{"as written", "as written"}}},
    {"none",
     {{"no bumper", "without the bumper"},
      {"no links", "without the links"},
      {"neither bumper nor links", "without the bumper and links"},
      {"pounding", "at the given gap"}}},
    {"bumper", {{"bumper", "with the bumper"}, [OF_BOTH] = {"bumper, no links", "with the bumper and without links"}}},
    {"cavity",
     {{"bumper in a cavity", "with the bumper in a cavity"},
      [OF_BOTH] = {"bumper in a cavity, no links", "with the bumper in a cavity and without links"}}},
    {"link", {{"links", "with the links"}, [OF_BOTH] = {"links, no bumper", "with the links and without the bumper"}}},
    {"",
     {{"bumper", "with the bumper"},
      {"links", "with the links"},
      {"bumper and links", "with the bumper and links"},
      {"pounding", "at the given gap"}}}};

int thud_scene_measures(const struct thud_scene *scene)
{
    return (thud_scene_has_bumper(scene) ? THUD_HAS_BUMPER : 0) | (scene->nlinks > 0 ? THUD_HAS_LINKS : 0);
}

static const struct words *words_of(int measures, enum thud_case which)
{
    static const int of[] = {[THUD_HAS_BUMPER] = OF_BUMPER,
                             [THUD_HAS_LINKS] = OF_LINKS,
                             [THUD_HAS_BUMPER | THUD_HAS_LINKS] = OF_BOTH,
                             [0] = OF_NOTHING};
    const struct words *words = known[which - THUD_CASE_FREE].words;
    return words[of[measures]].title ? &words[of[measures]] : words;
}

const char *thud_case_title(int measures, enum thud_case which)
{
    return words_of(measures, which)->title;
}

const char *thud_case_free_title(bool links)
{
    return links ? "no pounding, links act" : thud_case_title(0, THUD_CASE_FREE);
}

const char *thud_case_free_words(int measures, bool links)
{
    if (!(measures & THUD_HAS_LINKS))
        return "no pounding at all";
    return links ? thud_case_free_title(true) : "no pounding, without links";
}

const char *thud_case_phrase(int measures, enum thud_case which)
{
    return words_of(measures, which)->phrase;
}

const char *thud_case_subject(int measures, enum thud_case which, const char **verb)
{
    const char *subject = which == THUD_CASE_LINK     ? "links"
                          : which == THUD_CASE_CAVITY ? "bumper in a cavity"
                          : which == THUD_CASE_BUMPER ? "bumper"
                          : measures == 0             ? "scene as written"
                                                      : thud_case_title(measures, THUD_CASE_WHOLE);
    *verb = strstr(subject, "links") ? "" : "s";
    return subject;
}

const char *thud_case_name(enum thud_case which)
{
    return known[which - THUD_CASE_FREE].name;
}

enum thud_status thud_case_find(const char *name, enum thud_case *out, struct thud_error *err)
{
    struct thud_words words = {0};
    for (int i = THUD_CASE_AS_WRITTEN; i < THUD_CASES; i++) {
        if (strcmp(thud_case_name((enum thud_case)i), name) == 0) {
            *out = (enum thud_case)i;
            return THUD_OK;
        }
        thud_words_add(&words, thud_case_name((enum thud_case)i));
    }
    return thud_words_unknown(&words, "case", name, err);
}

enum thud_status thud_cases_parse(const char *text, enum thud_case cases[THUD_CASES_MAX], int *n,
                                  struct thud_error *err)
{
    enum { ROOM = 256 };
    char list[ROOM], *item[THUD_CASES_MAX];
    snprintf(list, sizeof list, *text == '[' ? "%s" : "[%s]", text);
    const int count = thud_list_split(list, item, THUD_CASES_MAX);
    if (count < 0 || count > THUD_CASES_MAX) {
        thud_error_set(err, THUD_INPUT, "too many cases, or an unterminated list");
        thud_error_allow(err, "up to %d", THUD_CASES_MAX);
        return THUD_INPUT;
    }
    for (int i = 0; i < count; i++) {
        enum thud_status status = thud_case_find(item[i], &cases[i], err);
        if (status != THUD_OK)
            return status;
        for (int j = 0; j < i; j++)
            if (cases[i] == cases[j])
                return thud_error_set(err, THUD_INPUT, "the case \"%.40s\" is named twice", item[i]);
    }
    *n = count;
    return THUD_OK;
}

double thud_interface_max_strain(const struct thud_interface *interface)
{
    const struct thud_law_choice *bumper = &interface->bumper;
    int i = interface->has_bumper && bumper->law ? thud_law_param(bumper->law, "max-strain") : -1;
    return i < 0 ? NAN : bumper->value[i];
}

void thud_scene_copy(struct thud_scene *to, const struct thud_scene *from)
{
    const size_t n = (size_t)from->nstructures, rest = offsetof(struct thud_scene, study);
    bool shapes = false;
    for (size_t s = 0; s < n; s++)
        shapes |= from->structure[s].shape_rows > 0;
    memcpy(to, from, offsetof(struct thud_scene, structure) + n * sizeof *from->structure);
    memcpy(to->interface, from->interface, (n > 0 ? n - 1 : 0) * sizeof *from->interface);
    to->analysis = from->analysis;
    if (shapes)
        memcpy(to->shape, from->shape, sizeof to->shape);
    memcpy((char *)to + rest, (const char *)from + rest, sizeof *from - rest);
}

/* And what its study varies of them. */
static void drop_links(struct thud_scene *scene)
{
    struct thud_study_choice *study = &scene->study;
    memset(scene->link, 0, sizeof scene->link);
    scene->nlinks = 0;
    for (int i = study->nvary - 1; i >= 0; i--)
        if (strncmp(study->vary[i].key, "links.", 6) == 0) {
            memmove(&study->vary[i], &study->vary[i + 1], (size_t)(study->nvary - i - 1) * sizeof *study->vary);
            memset(&study->vary[--study->nvary], 0, sizeof *study->vary);
        }
}

void thud_interface_case(struct thud_interface *at, enum thud_case which)
{
    if (which == THUD_CASE_NONE || which == THUD_CASE_LINK)
        at->has_bumper = false;
    else if (which == THUD_CASE_FREE) {
        at->has_bumper = false;
        thud_law_choice_init(&at->contact, thud_law_find("none"));
    } else if (which == THUD_CASE_BUMPER && at->has_bumper)
        at->bumper_cavity_m = 0;
    else if (which == THUD_CASE_CAVITY && at->has_bumper)
        at->bumper_cavity_m = at->bumper_thickness_m * (1 - thud_interface_max_strain(at));
}

/* The one depth of all levels suits the bumper of each. */
static enum thud_status check_cavity(const struct thud_interface *at, int interface, struct thud_error *err)
{
    static const double rounding_m = 1e-9;
    struct thud_interface cased = *at;
    thud_interface_case(&cased, THUD_CASE_CAVITY);
    if (at->has_bumper && isnan(thud_interface_max_strain(at)))
        return thud_error_refuse(
            err, THUD_INPUT, "case", NULL,
            "the cavity's depth is thickness (1 - max-strain), and the bumper's law %s has no max-strain",
            at->bumper.law ? at->bumper.law->name : "");
    for (int l = 0; l < at->thickness.n && at->has_bumper; l++) {
        const struct thud_level_values of = thud_interface_level(&cased, l);
        if (!of.has_bumper || of.thickness_m > of.cavity_m + rounding_m)
            continue;
        return thud_error_refuse(
            err, THUD_INPUT, "case",
            "thickness-by-level above that depth, or 0 cm: no bumper there; or bumper.cavity by hand",
            "the cavity is %.4g cm deep at every level, thickness (1 - max-strain), and the bumper of "
            "interface %d is %.4g cm thick at level %d",
            100 * of.cavity_m, interface + 1, 100 * of.thickness_m, l + 1);
    }
    return THUD_OK;
}

enum thud_status thud_scene_case(const struct thud_scene *scene, enum thud_case which, struct thud_scene *out,
                                 struct thud_error *err)
{
    int bumpers = 0;
    enum thud_status status = THUD_OK;
    for (int i = 0; i + 1 < scene->nstructures && status == THUD_OK; i++) {
        const struct thud_interface *at = &scene->interface[i];
        bumpers += at->has_bumper;
        if (which == THUD_CASE_CAVITY)
            status = check_cavity(at, i, err);
    }
    if (status != THUD_OK)
        return status;
    if (bumpers == 0 && (which == THUD_CASE_BUMPER || which == THUD_CASE_CAVITY))
        return thud_error_refuse(err, THUD_INPUT, "case", "none, or add one, e.g. bumper.law=rubber",
                                 "the scene has no bumper for the case \"%s\"", thud_case_name(which));
    if (scene->nlinks == 0 && which == THUD_CASE_LINK)
        return thud_error_refuse(err, THUD_INPUT, "case", "none, or add one, e.g. links.1.law=dashpot",
                                 "the scene has no link for the case \"%s\"", thud_case_name(which));
    if (out != scene)
        thud_scene_copy(out, scene);
    if (!thud_case_has_links(which))
        drop_links(out);
    for (int i = 0; i + 1 < out->nstructures; i++)
        thud_interface_case(&out->interface[i], which);
    return THUD_OK;
}

bool thud_scene_has_bumper(const struct thud_scene *scene)
{
    for (int i = 0; i + 1 < scene->nstructures; i++)
        if (scene->interface[i].has_bumper)
            return true;
    return false;
}

bool thud_scene_has_measure(const struct thud_scene *scene)
{
    return scene->nlinks > 0 || thud_scene_has_bumper(scene);
}
