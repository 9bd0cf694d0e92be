#include "app/run/new_preset.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/session.h"
#include "base/ascii.h"
#include "base/quantity.h"
#include "io/file/json.h"
#include "study/scene/building.h"

static const struct thud_new_about about[THUD_NEW_ROWS] = {
    [THUD_NEW_NAME] = {"name", "name", "", "File name without .yaml; heads figures and reports", true, false},
    [THUD_NEW_KIND] = {"kind", "kind", "",
                       "Space selects: shear, isolated, lead-rubber or pendulum bearings, rigid, wall, backfill "
                       "(a flexible wall), matrix, modes, estimated",
                       false, false},
    [THUD_NEW_STOREYS] = {"storeys", "storeys", "", "Floors above the ground, 1 to 200", false, false},
    [THUD_NEW_MASS] = {"mass", "floor mass", "t",
                       "Mass of every floor; t, kg, Mg. Single floors can be changed on Model", false, false},
    [THUD_NEW_STIFFNESS] = {"stiffness", "stiffness or period", "",
                            "Storey stiffness (MN/m, kN/mm, N/m), or first period (s) of a shear building; matrix and "
                            "modes: a file; estimated: the system",
                            false, false},
    [THUD_NEW_HEIGHT] = {"height", "storey height", "m", "Height of every storey; m, ft", false, false},
    [THUD_NEW_DAMPING] = {"damping", "damping", "%", "Damping ratio of every mode, %", false, false},
    [THUD_NEW_GAP] = {"gap", "gap", "cm", "Gap between the two at rest; cm, mm, m, in", true, false},
    [THUD_NEW_RECORD] = {"record", "ground motion", "",
                         "Type to narrow the list, Tab takes its first; empty: no ground motion", true, true},
    [THUD_NEW_SOIL] = {"soil", "soil", "m/s",
                       "Shear-wave velocity, m/s, under a disk of 9 m radius; empty: rigid ground", false, true},
    [THUD_NEW_DAMPER] = {"damper", "damper", "kN s/m", "Dashpot between the topmost common floors, kN s/m; empty: none",
                         true, true}};
static const char *const kinds[] = {"shear",    "isolated", "rigid", "wall",      "backfill", "lead-rubber",
                                    "pendulum", "matrix",   "modes", "estimated", NULL};

static const char *const usual[THUD_NEW_ROWS] = {
    "buildings", "shear", "4, 6", "320 t", "600 MN/m", "3 m", "5 %", "5 cm", "kobe-surrogate.csv", "", ""};
static const char systems[] = "concrete-frame, steel-frame, wall, masonry";

static bool is_isolated(const char *kind)
{
    return strcmp(kind, "isolated") == 0 || strcmp(kind, "lead-rubber") == 0 || strcmp(kind, "pendulum") == 0;
}

static bool is_wall(const char *kind)
{
    return strcmp(kind, "wall") == 0 || strcmp(kind, "backfill") == 0;
}

static bool is_read(const char *kind)
{
    return strcmp(kind, "matrix") == 0 || strcmp(kind, "modes") == 0;
}

static bool is_estimated(const char *kind)
{
    return strcmp(kind, "estimated") == 0;
}

/* Of a system; where the stiffness of another kind is left, it is none. */
static bool is_word(const char *text)
{
    return thud_ascii_is_alpha(*text);
}

const struct thud_new_about *thud_new_about(enum thud_new_row row)
{
    return &about[row];
}

const char *thud_new_kind(int i)
{
    return kinds[i];
}

/* "shear, isolated, ...", in `text`. */
static const char *all_kinds(char *text, size_t size)
{
    *text = '\0';
    for (int i = 0; kinds[i]; i++)
        thud_append(text, size, "%s%s", i ? ", " : "", kinds[i]);
    return text;
}

void thud_new_question(const struct thud_new_preset *preset, enum thud_new_row row, int side, struct thud_text *out)
{
    const char *k = preset->text[THUD_NEW_KIND][side];
    char all[120];
    thud_text_append(out, "%s", about[row].single ? "" : side ? "right " : "left ");
    if (row == THUD_NEW_STIFFNESS && is_read(k))
        thud_text_append(out, "file of %s", k[1] == 'a' ? "the stiffness matrix" : "periods and shapes");
    else if (row == THUD_NEW_STIFFNESS && is_estimated(k))
        thud_text_append(out, "system (%s)", systems);
    else if (row == THUD_NEW_KIND)
        thud_text_append(out, "kind (%s)", all_kinds(all, sizeof all));
    else
        thud_text_append(out, "%s%s%s",
                         row == THUD_NEW_STIFFNESS && is_isolated(k) ? "storey stiffness" : about[row].label,
                         *about[row].unit || row == THUD_NEW_STIFFNESS ? ", with its unit" : "",
                         about[row].optional ? ", or \"no\"" : "");
    thud_text_append(out, " [%s]: ", preset->text[row][side]);
}

void thud_new_preset_answer(struct thud_new_preset *preset, enum thud_new_row row, int side, const char *text)
{
    char before[THUD_NEW_TEXT], kind[THUD_NEW_TEXT];
    char(*value)[THUD_NEW_TEXT] = preset->text[row];
    const bool no = about[row].optional && (thud_ascii_same(text, "no") || thud_ascii_same(text, "none"));
    memcpy(before, value[side], sizeof before);
    memcpy(kind, preset->text[THUD_NEW_KIND][side], sizeof kind);
    snprintf(value[side], THUD_NEW_TEXT, "%s", no ? "" : text);
    /* the right one goes with the left one until it has an answer of its own */
    if (side == 0 && !about[row].single && row != THUD_NEW_KIND && row != THUD_NEW_STOREYS &&
        strcmp(value[1], before) == 0 && !strchr(text, ','))
        memcpy(value[1], value[0], sizeof before);
    if (row == THUD_NEW_KIND && strcmp(kind, value[side]) != 0)
        snprintf(preset->text[THUD_NEW_STIFFNESS][side], THUD_NEW_TEXT, "%s",
                 is_read(text)        ? ""
                 : is_estimated(text) ? "concrete-frame"
                                      : usual[THUD_NEW_STIFFNESS]);
}

void thud_new_preset_init(struct thud_new_preset *preset)
{
    memset(preset, 0, sizeof *preset);
    for (int row = 0; row < THUD_NEW_ROWS; row++)
        thud_new_preset_put(preset, (enum thud_new_row)row, usual[row]);
}

/* Without blanks at both ends. */
static void put(const char *text, size_t length, char *to)
{
    while (length > 0 && *text == ' ')
        text++, length--;
    while (length > 0 && text[length - 1] == ' ')
        length--;
    snprintf(to, THUD_NEW_TEXT, "%.*s", (int)length, text);
}

void thud_new_preset_put(struct thud_new_preset *preset, enum thud_new_row row, const char *text)
{
    const char *comma = about[row].single ? NULL : strchr(text, ','), *right = comma ? comma + 1 : text;
    put(text, comma ? (size_t)(comma - text) : strlen(text), preset->text[row][0]);
    put(right, strlen(right), preset->text[row][1]);
}

/* The topmost storey that both have, above which floors of an isolated building are one more; 0: one has none. */
static int common_floor(const struct thud_new_preset *preset)
{
    int common = THUD_STOREYS_MAX;
    for (int side = 0; side < 2; side++) {
        const char *end;
        double n = 0;
        if (!thud_new_applies(preset, THUD_NEW_STOREYS, side) ||
            thud_number_parse(preset->text[THUD_NEW_STOREYS][side], &end, &n) != 0 || !(n >= 1))
            return 0;
        common = n < common ? (int)n : common;
    }
    return common;
}

bool thud_new_applies(const struct thud_new_preset *preset, enum thud_new_row row, int side)
{
    const char *k = preset->text[THUD_NEW_KIND][side];
    bool building = strcmp(k, "shear") == 0 || is_isolated(k) || is_read(k) || is_estimated(k);
    if (row == THUD_NEW_DAMPER)
        return side == 0 && common_floor(preset) > 0;
    if (about[row].single)
        return side == 0;
    if (row == THUD_NEW_SOIL)
        return building && !is_isolated(k);
    return row == THUD_NEW_KIND || building || (row == THUD_NEW_MASS && strcmp(k, "rigid") == 0);
}

/* The value, in brackets where it is a list of floors; a bare number gets the shown unit. */
static void value_of(const struct thud_new_preset *preset, enum thud_new_row row, int side, char *text, size_t size)
{
    const char *end, *typed = preset->text[row][side], *bare = about[row].unit;
    double number;
    typed += strspn(typed, " ");
    bool plain = thud_number_parse(typed, &end, &number) == 0 && !end[strspn(end, " ")];
    bool list = strchr(typed, ',') && *typed != '[' && !about[row].single;
    snprintf(text, size, "%s%s%s%s%s", list ? "[" : "", typed, plain && *bare ? " " : "", plain ? bare : "",
             list ? "]" : "");
}

/* The mean mass of a floor, and how many there are. */
static enum thud_status mean_mass(const struct thud_new_preset *preset, int side, double *kg, double *storeys,
                                  struct thud_error *err)
{
    char item[THUD_NEW_TEXT];
    const char *at = preset->text[THUD_NEW_MASS][side], *end;
    int n = 0;
    if (thud_number_parse(preset->text[THUD_NEW_STOREYS][side], &end, storeys) != 0 || !(*storeys >= 1))
        return thud_error_refuse(err, THUD_INPUT, NULL, "1 to 200", "\"%.40s\" is not a number of storeys",
                                 preset->text[THUD_NEW_STOREYS][side]);
    for (*kg = 0; *(at += strspn(at, " ,[]")); n++) {
        struct thud_quantity mass;
        const size_t length = strcspn(at, ",]");
        snprintf(item, sizeof item, "%.*s", (int)length, at);
        enum thud_status status = thud_quantity_parse(item, THUD_MASS, about[THUD_NEW_MASS].unit, &mass, err);
        if (status != THUD_OK)
            return status;
        *kg += mass.value;
        at += length;
    }
    *kg /= n > 0 ? n : 1;
    return THUD_OK;
}

/* The slab is as heavy as a floor. */
static void bearings(const char *kind, double floor_kg, double storeys, struct thud_text *out)
{
    struct thud_usual bearing[THUD_USUAL_BEARINGS];
    thud_usual_bearings(strcmp(kind, "pendulum") == 0 ? THUD_ISOLATOR_PENDULUM : THUD_ISOLATOR_LEAD_RUBBER,
                        floor_kg * (storeys + 1), bearing);
    thud_text_append(out, "    isolator: # a guess: usual bearings\n");
    for (int i = 0; i < THUD_USUAL_BEARINGS && bearing[i].key; i++)
        thud_text_append(out, "      %s: %s\n", strchr(bearing[i].key, '.') + 1, bearing[i].value);
}

/* KEY: VALUE, and what is to be said of it. */
static void line(struct thud_text *out, const char *key, const char *value, const char *comment)
{
    char text[THUD_NEW_TEXT + 64];
    snprintf(text, sizeof text, "%s: %s", key, value);
    if (comment)
        thud_text_append(out, "    %-30s # %s\n", text, comment);
    else
        thud_text_append(out, "    %s\n", text);
}

static void moat_wall(struct thud_text *out)
{
    for (int i = 0; thud_usual_wall[i][0]; i++)
        line(out, thud_usual_wall[i][0], thud_usual_wall[i][1], "a guess: for the wall only");
    thud_text_append(out, "    backfill: # a guess\n");
    for (int i = 0; thud_usual_backfill[i][0]; i++)
        thud_text_append(out, "      %s: %s\n", thud_usual_backfill[i][0], thud_usual_backfill[i][1]);
}

/* From the mass of its floors their area; in the place of the stiffness one of the systems. */
static void estimated(const struct thud_new_preset *preset, int side, double floor_kg, struct thud_text *out)
{
    char text[THUD_NEW_TEXT + 16], among[80];
    const char *system = preset->text[THUD_NEW_STIFFNESS][side];
    const bool given = is_word(system);
    snprintf(among, sizeof among, "%s%s", given ? "" : "a guess: ", systems);
    line(out, "system", given ? system : "concrete-frame", among);
    thud_quantity_format(floor_kg / THUD_ESTIMATE_KGPM2, "m2", text, sizeof text);
    line(out, "area", text, "a guess: 1 t/m2 per floor");
}

/* What a building's mass and stiffness are given by. */
static void springs(const struct thud_new_preset *preset, int side, struct thud_text *out)
{
    const char *k = preset->text[THUD_NEW_KIND][side];
    char text[THUD_NEW_TEXT + 16];
    value_of(preset, THUD_NEW_MASS, side, text, sizeof text);
    line(out, "mass", text, side ? NULL : "for every floor, or a list from the lowest: [320 t, 250 t]");
    value_of(preset, THUD_NEW_STIFFNESS, side, text, sizeof text);
    if (is_read(k))
        line(out, k[1] == 'a' ? "stiffness-matrix" : "periods", preset->text[THUD_NEW_STIFFNESS][side], "a file");
    else if (strcmp(k, "shear") == 0 &&
             thud_quantity_parse(text, THUD_TIME, NULL, &(struct thud_quantity){0}, NULL) == THUD_OK)
        line(out, "period", text, "first period, for equal storeys");
    else
        line(out, "stiffness", text, side ? NULL : "for every storey, or a list");
}

/* Of a surface foundation on a half-space, with usual values of the rest. */
static void soil(const struct thud_new_preset *preset, int side, struct thud_text *out)
{
    char vs[THUD_NEW_TEXT + 16];
    if (!thud_new_applies(preset, THUD_NEW_SOIL, side) || !*preset->text[THUD_NEW_SOIL][side])
        return;
    value_of(preset, THUD_NEW_SOIL, side, vs, sizeof vs);
    thud_text_append(out,
                     "    foundation:\n      mass: 400 t # a guess\n      vs: %s # shear-wave velocity\n"
                     "      density: 1.9 t/m3 # a guess\n      poisson: 0.4 # a guess\n"
                     "      radius: 9 m # a guess: disk of equal area\n",
                     vs);
}

static void damper(const struct thud_new_preset *preset, struct thud_text *out)
{
    char damping[THUD_NEW_TEXT + 16];
    const int floor = common_floor(preset);
    if (!*preset->text[THUD_NEW_DAMPER][0] || floor == 0)
        return;
    value_of(preset, THUD_NEW_DAMPER, 0, damping, sizeof damping);
    thud_text_append(out,
                     "links:\n  - law: dashpot # spring: a tie, with a stiffness\n    from: A.%d\n    to: B.%d\n"
                     "    damping: %s\n",
                     floor + is_isolated(preset->text[THUD_NEW_KIND][0]),
                     floor + is_isolated(preset->text[THUD_NEW_KIND][1]), damping);
}

static enum thud_status structure(const struct thud_new_preset *preset, int side, struct thud_text *out,
                                  struct thud_error *err)
{
    const char *k = preset->text[THUD_NEW_KIND][side];
    char text[THUD_NEW_TEXT + 16];
    double floor_kg, storeys;
    thud_text_append(out, "  - name: %s\n", side ? "B" : "A");
    line(out, "kind",
         is_isolated(k) ? "isolated"
         : is_wall(k)   ? "wall"
                        : k,
         side ? NULL : "shear | isolated | rigid | wall | matrix | modes | estimated");
    if (is_wall(k)) {
        if (strcmp(k, "backfill") == 0)
            moat_wall(out);
        return THUD_OK;
    }
    if (strcmp(k, "rigid") == 0) {
        value_of(preset, THUD_NEW_MASS, side, text, sizeof text);
        line(out, "mass", text, NULL);
        line(out, "height", "3 m", "a guess: its elevation");
        return THUD_OK;
    }
    enum thud_status status = mean_mass(preset, side, &floor_kg, &storeys, err);
    if (status != THUD_OK)
        return status;
    line(out, "storeys", preset->text[THUD_NEW_STOREYS][side], NULL);
    if (is_estimated(k))
        estimated(preset, side, floor_kg, out);
    else
        springs(preset, side, out);
    value_of(preset, THUD_NEW_HEIGHT, side, text, sizeof text);
    line(out, "height", text, side ? NULL : "for every storey, or a list");
    value_of(preset, THUD_NEW_DAMPING, side, text, sizeof text);
    line(out, "damping", text, side ? NULL : "for every mode");
    line(out, "slab-depth", "30 cm", "a guess: slab and beam at the face");
    if (!is_isolated(k))
        return THUD_OK;
    thud_quantity_format(floor_kg, "t", text, sizeof text);
    line(out, "base-mass", text, "a guess: mass of a floor");
    if (strcmp(k, "isolated") != 0) {
        bearings(k, floor_kg, storeys, out);
        return THUD_OK;
    }
    line(out, "isolation-stiffness", "12.5 MN/m", "a guess");
    line(out, "isolation-damping", "15 %", "a guess");
    return THUD_OK;
}

/* "5-storey building" */
static void called(const struct thud_new_preset *preset, int side, char *text, size_t size)
{
    const char *k = preset->text[THUD_NEW_KIND][side];
    if (thud_new_applies(preset, THUD_NEW_STOREYS, side))
        snprintf(text, size, "%.20s-storey %s", preset->text[THUD_NEW_STOREYS][side],
                 is_isolated(k) ? "isolated building" : "building");
    else
        snprintf(text, size, "%s", is_wall(k) ? "wall" : "rigid body");
}

void thud_new_preset_title(const struct thud_new_preset *preset, char *title, size_t size)
{
    char left[64], right[64];
    called(preset, 0, left, sizeof left);
    called(preset, 1, right, sizeof right);
    snprintf(title, size, "%s: %s and %s", preset->text[THUD_NEW_NAME][0], left, right);
}

/* What `thud sweep` varies: the gap, from a quarter of what it is to four times that. */
static void study(const char *gap, struct thud_text *out)
{
    struct thud_quantity q;
    if (thud_quantity_parse(gap, THUD_LENGTH, NULL, &q, NULL) != THUD_OK || !(q.value > 0))
        return;
    thud_text_append(out, "study: # for `thud sweep`\n  vary: gap\n  from: %.6g cm\n  to: %.6g cm\n  step: %.6g cm\n",
                     25 * q.value, 400 * q.value, 25 * q.value);
}

enum thud_status thud_new_preset_text(const struct thud_new_preset *preset, struct thud_text *out,
                                      struct thud_error *err)
{
    char text[THUD_NEW_TEXT + 160];
    thud_new_preset_title(preset, text, sizeof text);
    thud_text_append(out, "# Every key is described in thud-preset(5); numbers need units.\ntitle: ");
    thud_json_string(out, text);
    if (*preset->text[THUD_NEW_RECORD][0]) {
        thud_text_append(out, "\nrecord:\n  file: ");
        thud_json_string(out, preset->text[THUD_NEW_RECORD][0]);
        thud_text_append(out, " # add \"peak: 0.3 g\" to scale it");
    }
    thud_text_append(out, "\nstructures: # from left to right\n");
    for (int side = 0; side < 2; side++) {
        enum thud_status status = structure(preset, side, out, err);
        if (status != THUD_OK)
            return status;
        soil(preset, side, out);
    }
    value_of(preset, THUD_NEW_GAP, 0, text, sizeof text);
    thud_text_append(
        out,
        "interfaces:\n  - gap: %s # at rest\n    contact:\n"
        "      law: kelvin-voigt-no-tension # one of `thud laws`\n"
        "      stiffness: 2500 kN/mm # a guess: see `thud stiffness`\n      restitution: 0.6 # a guess: concrete\n",
        text);
    damper(preset, out);
    study(preset->text[THUD_NEW_GAP][0], out);
    return out->failed ? thud_error_set(err, THUD_MEMORY, "out of memory") : THUD_OK;
}

/* Reads the preset that these values make, and its ground motion. */
static enum thud_status read_trial(const struct thud_new_preset *trial, struct thud_error *err)
{
    struct thud_text text = {0};
    struct thud_session *session = calloc(1, sizeof *session);
    enum thud_status status =
        session ? thud_new_preset_text(trial, &text, err) : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK)
        status = thud_session_parse(session, text.data, text.size, "new.yaml", err);
    if (status == THUD_OK)
        status = thud_scene_check(&session->scene, err);
    if (status == THUD_OK && session->scene.record.file[0])
        status = thud_session_read_record(session, err);
    if (status != THUD_OK && err)
        err->file[0] = err->key[0] = '\0', err->line = err->column = 0; /* of a text that nobody sees */
    if (session)
        thud_session_close(session);
    free(session);
    thud_text_clear(&text);
    return status;
}

enum thud_status thud_new_preset_check(const struct thud_new_preset *preset, enum thud_new_row row, int side,
                                       struct thud_error *err)
{
    static const enum thud_new_row with[] = {THUD_NEW_STOREYS, THUD_NEW_KIND};
    struct thud_new_preset trial;
    const char *answer = preset->text[row][side];
    thud_new_preset_init(&trial);
    for (int i = 0; row == THUD_NEW_KIND && kinds[i]; i++)
        if (strcmp(kinds[i], answer) == 0)
            return THUD_OK;
    char all[120];
    if (row == THUD_NEW_KIND)
        return thud_error_refuse(err, THUD_INPUT, NULL, all_kinds(all, sizeof all),
                                 "\"%.40s\" is not a kind of structure", answer);
    if (!*answer && !about[row].optional)
        return thud_error_refuse(err, THUD_INPUT, NULL, "or < to go back", "an answer is needed");
    const char *end;
    double number;
    if (row == THUD_NEW_STIFFNESS && is_estimated(preset->text[THUD_NEW_KIND][side]) && !is_word(answer))
        return thud_error_refuse(err, THUD_INPUT, NULL, systems, "\"%.40s\" is not a system", answer);
    if (row == THUD_NEW_STIFFNESS && thud_number_parse(answer, &end, &number) == 0 && !end[strspn(end, " ")])
        return thud_error_refuse(err, THUD_INPUT, NULL, "a stiffness, 600 MN/m, or a first period, 0.9 s",
                                 "\"%.40s\" has no unit", answer);
    for (int k = 0; k < 2; k++) /* the kind counts only for what a stiffness is */
        for (int i = 0; i < 1 + (row == THUD_NEW_STIFFNESS); i++)
            if (thud_new_applies(preset, THUD_NEW_STOREYS, k) && (k == side || row == THUD_NEW_DAMPER))
                memcpy(trial.text[with[i]][k], preset->text[with[i]][k], sizeof trial.text[0][0]);
    memcpy(trial.text[row][side], answer, sizeof trial.text[0][0]);
    return read_trial(&trial, err);
}
