/* Saving: nothing but what was changed changes, and what was saved reads back. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "io/file/file.h"
#include "io/preset/preset.h"
#include "preset_text.h"

static struct thud_scene scene, again; /* large */

static struct thud_preset *parse(const char *text, size_t size)
{
    struct thud_preset *preset;
    struct thud_error err = {0};
    char message[1400];
    ck_assert_msg(thud_preset_parse(text, size, "dir/towers.yaml", &preset, &err) == THUD_OK, "%s\n%s",
                  thud_error_text(&err, message, sizeof message), text);
    return preset;
}

static char *text_of(const struct thud_preset *preset, const struct thud_scene *wanted, size_t *size)
{
    char *text;
    struct thud_error err = {0};
    unsigned long n;
    ck_assert_int_eq(thud_preset_text(preset, wanted, &text, &n, &err), THUD_OK);
    *size = n;
    return text;
}

static void set(struct thud_scene *at, const char *path, const char *text)
{
    struct thud_error err = {0};
    char message[1400];
    ck_assert_msg(thud_scene_set(at, path, text, &err) == THUD_OK, "%s",
                  thud_error_text(&err, message, sizeof message));
}

START_TEST(unchanged_is_the_same_bytes)
{
    static const char *const names[] = {
        "towers",          "towers-yielding",       "towers-northridge", "towers-san-fernando",
        "towers-kaikoura", "towers-linked",         "rigid-concrete",    "rigid-bumper",
        "three-in-a-row",  "isolated-moat",         "isolated-pendulum", "isolated-lead-rubber",
        "beside-unknown",  "isolated-moat-backfill"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[64], *text, *saved;
        size_t size, n;
        struct thud_error err;
        snprintf(path, sizeof path, "presets/%s.yaml", names[i]);
        ck_assert_int_eq(thud_file_read(path, 1 << 20, &text, &size, &err), THUD_OK);
        struct thud_preset *preset = parse(text, size);
        saved = text_of(preset, thud_preset_scene(preset), &n);
        ck_assert_uint_eq(n, size);
        ck_assert_int_eq(memcmp(text, saved, n), 0);
        free(text);
        free(saved);
        thud_preset_free(preset);
    }
}
END_TEST

/* Gaps by level and levels that meet: a list that changes keeps its comment, one that is new or taken away leaves the
 * rest. */
START_TEST(lists_by_level)
{
    static const char base[] = "structures:\n  - {kind: shear, storeys: 2, mass: 300 t, stiffness: 600 MN/m}\n"
                               "  - {kind: shear, storeys: 2, mass: 300 t, stiffness: 400 MN/m}\ninterfaces:\n"
                               "  - gap: 5 cm # the line\n%s    contact:\n      law: linear\n      stiffness: 2 kN/m\n";
    static const char *const was[] = {"    gap-by-level: [none, 8 cm] # a setback\n", "",
                                      "    gap-by-level: [none, 8 cm] # a setback\n",
                                      "    contact-levels: [1] # below\n"},
                             *const now[] = {"    gap-by-level: [3 cm, none] # a setback\n",
                                             "    gap-by-level: [3 cm, none]\n", "",
                                             "    contact-levels: [2] # below\n"};
    char before[600], after[600];
    snprintf(before, sizeof before, base, was[_i]);
    snprintf(after, sizeof after, base, now[_i]);
    struct thud_preset *preset = parse(before, strlen(before));
    size_t size;
    scene = *thud_preset_scene(preset);
    ck_assert_int_eq(scene.interface[0].contact_levels.n, _i == 3);
    if (_i == 3)
        set(&scene, "contact-levels", "[2]");
    else
        set(&scene, "gap-by-level", _i == 2 ? "" : "[3 cm, none]");
    char *text = text_of(preset, &scene, &size);
    struct thud_preset *read = parse(text, size);
    ck_assert_int_eq(memcmp(thud_preset_scene(read), &scene, sizeof scene), 0);
    if (_i != 1) /* where a new key stands is free */
        ck_assert_msg(size == strlen(after) && memcmp(text, after, size) == 0, "%.*s", (int)size, text);
    thud_preset_free(read);
    free(text);
    thud_preset_free(preset);
}
END_TEST

/* A key, its new value, and the line as it is to be; every other line stays. */
static const struct {
    const char *path, *value;
    int line;
    const char *now;
} changes[] = {
    {"title", "One tower", 2, "title: One tower   # a title"},
    {"title", "a: 'b' #c \"d\" \\", 2, "title: \"a: 'b' #c \\\"d\\\" \\\\\"   # a title"},
    {"record.file", "/tmp/my record.csv", 4, "  file: /tmp/my record.csv"},
    {"record.peak", "0.9 g", 5, "  peak: 0.9 g  # scaled"},
    {"record.peak", "9.80665 m/s2", 5, "  peak: 1 g  # scaled"},
    {"record.sign", "-", 6, "  sign: \"-\""},
    {"structures.1.name", "east tower", 8, "  - name: east tower      # left"},
    {"structures.1.mass.2", "321 t", 10, "    mass: [320 t, 321000 kg, 320 t, 250 t] # four"},
    {"structures.1.mass", "300 t", 10, "    mass: [300 t, 300000 kg, 300 t, 300 t] # four"},
    {"structures.1.storeys", "2", 10, "    mass: [320 t, 250 t] # four"},
    {"structures.1.stiffness", "[500 MN/m, 500 MN/m, 500 MN/m, 400 MN/m]", 11,
     "    stiffness: [500 MN/m, 500 MN/m, 500 MN/m, 400 MN/m]"},
    {"structures.1.damping", "7.5 %", 13, "    damping: 0.075"},
    {"structures.2.mass.1", "330 t", 17, "      - 330 t   # first"},
    {"structures.2.stiffness", "500 MN/m", 20, "    stiffness: 500000000 N/m"},
    {"structures.3.velocity", "0.25 m/s", 21, "  - {kind: rigid, mass: 320 t, velocity: 0.25 m/s}"},
    {"structures.3.height", "6 m", 21, "  - {name: C, kind: rigid, mass: 320 t, height: 6 m, velocity: -0.5 m/s}"},
    {"interfaces.1.gap", "12.3456789 cm", 24, "  - gap: 123.456789 mm   # wide"},
    {"interfaces.1.contact.restitution", "0.7", 28, "      restitution: 70 %"},
    {"interfaces.1.bumper.stiffness", "0.4 kN/mm^2.65", 31, "      stiffness: 0.4 kN/mm^2.65 # eq. 4"},
    {"interfaces.1.bumper.unloading", "continuous", 34, "      unloading: continuous  # or continuous"},
    {"interfaces.2.gap", "5.08 cm", 35, "  - gap: 2 in"},
    {"interfaces.2.contact.stiffness", "2 kN/m", 36, "    contact: {law: linear, stiffness: 2e-6 MN/mm} # flow"},
    {"analysis.tolerance", "1e-9", 38, "  tolerance: 1e-9"},
    {"study.vary", "interfaces.2.gap", 40, "  vary: interfaces.2.gap"},
    {"study.cases", "[cavity]", 44, "  cases: [cavity]  # two"},
};

static const char *line_at(const char *text, int line, size_t *length)
{
    while (--line > 0)
        text = strchr(text, '\n') + 1;
    *length = strcspn(text, "\n");
    return text;
}

START_TEST(one_value_changes_one_line)
{
    struct thud_preset *preset = parse(preset_text, sizeof preset_text - 1);
    scene = *thud_preset_scene(preset);
    if (strcmp(changes[_i].path, "study.vary") == 0) { /* its bounds go with it */
        struct thud_vary *vary = &scene.study.vary[0];
        strcpy(vary->key, changes[_i].value);
    } else
        set(&scene, changes[_i].path, changes[_i].value);
    size_t size, a, b;
    char *text = text_of(preset, &scene, &size);
    for (int line = 1; line <= 44; line++) {
        const char *was = line_at(preset_text, line, &a), *now = line_at(text, line, &b);
        if (line != changes[_i].line)
            ck_assert_msg(a == b && memcmp(was, now, a) == 0, "line %d: %.*s", line, (int)b, now);
        else
            ck_assert_msg(strlen(changes[_i].now) == b && memcmp(changes[_i].now, now, b) == 0, "line %d: %.*s", line,
                          (int)b, now);
    }
    struct thud_preset *read = parse(text, size);
    ck_assert_int_eq(memcmp(thud_preset_scene(read), &scene, sizeof scene), 0);
    thud_preset_free(read);
    free(text);
    thud_preset_free(preset);
}
END_TEST

/* A range that becomes a list, two of them, and a range again; in each, what is written reads back. */
START_TEST(a_study_of_values_and_back)
{
    struct thud_preset *preset = parse(preset_text, sizeof preset_text - 1);
    static const char *const study[][3] = {
        {"interfaces.1.gap", "[6 cm, 7.5 cm]", "  values: [6 cm, 7.5 cm]\n"},
        {"[interfaces.1.gap, interfaces.1.contact.damping]", "[[6 cm], [paper, exact]]",
         "  values: [[6 cm], [paper, exact]]\n"},
        {"[interfaces.1.gap, interfaces.1.contact.damping]", "[[6 cm, 9 cm], [paper]]",
         "  values: [[6 cm, 9 cm], [paper]]\n"},
    };
    size_t size;
    char *text;
    for (size_t i = 0; i < sizeof study / sizeof *study; i++) {
        scene = *thud_preset_scene(preset);
        set(&scene, "study.vary", study[i][0]);
        set(&scene, "study.values", study[i][1]);
        text = text_of(preset, &scene, &size);
        thud_preset_free(preset);
        preset = parse(text, size);
        ck_assert_int_eq(memcmp(thud_preset_scene(preset), &scene, sizeof scene), 0);
        ck_assert_ptr_nonnull(strstr(text, study[i][2]));
        ck_assert_ptr_null(strstr(text, "  step:"));
        free(text);
    }
    set(&scene, "study.vary", "interfaces.1.gap");
    set(&scene, "study.from", "5 cm");
    set(&scene, "study.to", "25 cm");
    set(&scene, "study.step", "0.5 cm");
    text = text_of(preset, &scene, &size);
    struct thud_preset *read = parse(text, size);
    ck_assert_int_eq(memcmp(thud_preset_scene(read), &scene, sizeof scene), 0);
    ck_assert_ptr_null(strstr(text, "values"));
    thud_preset_free(read);
    free(text);
    thud_preset_free(preset);
}
END_TEST

/* A value written anew as a whole leaves the lines of comment that stood in it, before it; also where it goes. */
START_TEST(comments_in_a_list_stay)
{
    static const char body[] = "structures:\n  - kind: shear\n    mass: [320 t,\n      # the roof\n      250 t]\n"
                               "    stiffness: 600 MN/m\n  - {kind: rigid,\n     # free\n     mass: 320 t}\n"
                               "interfaces:\n  - gap: 6 cm\n    contact: {law: linear, stiffness: 2500 kN/mm}\n"
                               "study:\n  vary: gap\n  values: \n    - 6 cm\n      # wider\n    - 7 cm # last\n";
    static const char *const wanted[][3] = {
        {"structures.1.storeys", "3", "    mass:\n      # the roof\n      [320 t, 320 t, 250 t]\n    stiffness"},
        {"structures.2.velocity", "1 m/s",
         "  -\n     # free\n    {name: B, kind: rigid, mass: 320 t, velocity: 1 m/s}\n"},
        {"study.values", "[8 cm]", "  values: \n      # wider\n    [8 cm] # last\n"},
        {"study.step", "1 cm", "  vary: gap\n      # wider\n"},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        struct thud_preset *preset = parse(body, sizeof body - 1);
        size_t size;
        scene = *thud_preset_scene(preset);
        if (strcmp(wanted[i][0], "study.step") == 0) {
            set(&scene, "study.vary", "gap"); /* its values go */
            set(&scene, "study.from", "5 cm");
            set(&scene, "study.to", "7 cm");
        }
        set(&scene, wanted[i][0], wanted[i][1]);
        char *text = text_of(preset, &scene, &size);
        ck_assert_msg(strstr(text, wanted[i][2]) != NULL, "%s: %s", wanted[i][0], text);
        struct thud_preset *read = parse(text, size);
        ck_assert_int_eq(memcmp(thud_preset_scene(read), &scene, sizeof scene), 0);
        thud_preset_free(read);
        free(text);
        thud_preset_free(preset);
    }
}
END_TEST

static int count(const char *text, const char *what)
{
    int n = 0;
    for (const char *at = strstr(text, what); at; at = strstr(at + 1, what))
        n++;
    return n;
}

/* Keys that come and go, structures and bumpers too: what is written reads back, and no comment outside what went is
 * lost. */
START_TEST(keys_come_and_go)
{
    struct thud_preset *preset = parse(preset_text, sizeof preset_text - 1);
    size_t size;
    scene = *thud_preset_scene(preset);
    set(&scene, "record.peak", "");
    set(&scene, "record.factor", "1.5");
    set(&scene, "structures.1.height", "3.2 m");
    set(&scene, "structures.2.height", "3.2 m");
    set(&scene, "interfaces.1.bumper.restitution", "0.4");
    set(&scene, "interfaces.1.contact.damping", "exact");
    set(&scene, "interfaces.2.contact.law", "hertz");
    set(&scene, "analysis.step", "0.1 ms");
    scene.study = (struct thud_study_choice){0};
    char *text = text_of(preset, &scene, &size);
    struct thud_preset *read = parse(text, size);
    ck_assert_int_eq(memcmp(thud_preset_scene(read), &scene, sizeof scene), 0);
    ck_assert_int_eq(count(text, "#"), count(preset_text, "#") - 2); /* of the peak and of the study */
    ck_assert_ptr_null(strstr(text, "study"));
    ck_assert_ptr_nonnull(strstr(text, "  sign: +\n  factor: 1.5\nstructures:"));
    ck_assert_ptr_nonnull(strstr(text, "contact: {law: hertz, stiffness: "));
    /* and back again */
    size_t n;
    char *back = text_of(read, thud_preset_scene(preset), &n);
    struct thud_preset *first = parse(back, n);
    ck_assert_int_eq(memcmp(thud_preset_scene(first), thud_preset_scene(preset), sizeof scene), 0);
    thud_preset_free(first);
    thud_preset_free(read);
    free(back);
    free(text);
    thud_preset_free(preset);
}
END_TEST

START_TEST(bumpers_and_structures_come_and_go)
{
    struct thud_preset *preset = parse(preset_text, sizeof preset_text - 1);
    size_t size;
    scene = *thud_preset_scene(preset);
    scene.interface[0].has_bumper = false;
    thud_interface_add_bumper(&scene.interface[1]);
    char *text = text_of(preset, &scene, &size);
    struct thud_preset *read = parse(text, size);
    ck_assert(!thud_preset_scene(read)->interface[0].has_bumper);
    ck_assert(thud_preset_scene(read)->interface[1].has_bumper);
    ck_assert_int_eq(count(text, "#"), count(preset_text, "#"));
    ck_assert_ptr_nonnull(strstr(text, "      fitted: off\n")); /* it keeps its values */
    ck_assert_mem_eq(&thud_preset_scene(read)->interface[0].bumper, &scene.interface[0].bumper,
                     sizeof scene.interface[0].bumper);
    ck_assert_double_eq(thud_preset_scene(read)->interface[0].bumper_thickness_m,
                        scene.interface[0].bumper_thickness_m);
    scene.interface[0].has_bumper = true; /* and is put in again by taking the line out */
    free(text);
    text = text_of(read, &scene, &size);
    ck_assert_ptr_null(strstr(text, "fitted: off"));
    thud_preset_free(read);
    free(text);
    /* the first structure goes: what is left keeps its bytes */
    scene = *thud_preset_scene(preset);
    memmove(&scene.structure[0], &scene.structure[1], 2 * sizeof *scene.structure);
    memmove(&scene.interface[0], &scene.interface[1], sizeof *scene.interface);
    memset(&scene.structure[2], 0, sizeof *scene.structure);
    memset(&scene.interface[1], 0, sizeof *scene.interface);
    scene.nstructures = 2;
    text = text_of(preset, &scene, &size);
    read = parse(text, size);
    ck_assert_int_eq(memcmp(thud_preset_scene(read), &scene, sizeof scene), 0);
    ck_assert_ptr_nonnull(strstr(text, "      - 320 t   # first\n      - 310 t\n"));
    ck_assert_ptr_nonnull(strstr(text, "stiffness: 1 MN/mm} # flow\n"));
    ck_assert_ptr_nonnull(strstr(text, "# a title"));
    thud_preset_free(read);
    free(text);
    /* and one alone */
    memset(&scene.structure[1], 0, sizeof *scene.structure);
    memset(&scene.interface[0], 0, sizeof *scene.interface);
    scene.nstructures = 1;
    scene.study = (struct thud_study_choice){0};
    text = text_of(preset, &scene, &size);
    read = parse(text, size);
    ck_assert_int_eq(memcmp(thud_preset_scene(read), &scene, sizeof scene), 0);
    ck_assert_ptr_null(strstr(text, "interfaces"));
    char *grown;
    grown = text_of(read, thud_preset_scene(preset), &size);
    struct thud_preset *last = parse(grown, size);
    ck_assert_int_eq(memcmp(thud_preset_scene(last), thud_preset_scene(preset), sizeof scene), 0);
    thud_preset_free(last);
    free(grown);
    thud_preset_free(read);
    free(text);
    thud_preset_free(preset);
}
END_TEST

/* ---- random edits ---- */

static unsigned state;

static unsigned draw(unsigned n)
{
    state = state * 1664525u + 1013904223u;
    return (state >> 10) % n;
}

/* A random path of the scene with a value of the right kind in a random unit. */
static void random_edit(struct thud_scene *s)
{
    static const char *const words[] = {"title",         "record.file", "record.unit",       "record.channel",
                                        "record.column", "record.skip", "structures.1.name", "structures.2.name"};
    static const char *const texts[] = {"a b", "x: y",          "- q",  "it's #1", "\xc3\xa9t\xc3\xa9",
                                        "[1]", "\xe2\x80\xa8z", "\"q\""};
    int s1 = (int)draw((unsigned)s->nstructures), i1 = s->nstructures > 1 ? (int)draw((unsigned)s->nstructures - 1) : 0,
        n;
    char path[96], value[96];
    switch (draw(8)) {
    case 0:
        n = (int)draw(8);
        snprintf(value, sizeof value, "%u", draw(50) + 1);
        snprintf(path, sizeof path, "%s", words[n]);
        thud_scene_set(s, path, n == 4 || n == 5 ? value : texts[draw(8)], NULL);
        return;
    case 1:
        snprintf(path, sizeof path, "structures.%d.storeys", s1 + 1);
        snprintf(value, sizeof value, "%u", draw(7) + 1);
        break;
    case 2:
        snprintf(path, sizeof path, "structures.%d.mass.%u", s1 + 1, draw(6) + 1);
        snprintf(value, sizeof value, "%.17g kg", 1e5 * (draw(1000) + 1.0) / 7);
        break;
    case 3:
        snprintf(path, sizeof path, "structures.%d.height", s1 + 1);
        snprintf(value, sizeof value, "%.3f m", 1 + draw(900) / 100.0);
        break;
    case 4:
        snprintf(path, sizeof path, "structures.%d.kind", s1 + 1);
        snprintf(value, sizeof value, "%s", (const char *[]){"shear", "rigid", "isolated", "wall"}[draw(4)]);
        break;
    case 5:
        snprintf(path, sizeof path, "interfaces.%d.%s.law", i1 + 1, draw(2) ? "bumper" : "contact");
        snprintf(value, sizeof value, "%s", thud_law_at((int)draw((unsigned)thud_law_count()))->name);
        break;
    case 6:
        snprintf(path, sizeof path, "interfaces.%d.%s", i1 + 1,
                 (const char *[]){"gap", "bumper.thickness", "bumper.cavity"}[draw(3)]);
        snprintf(value, sizeof value, "%u mm", draw(200));
        break;
    default:
        snprintf(path, sizeof path, "interfaces.%d.%s", i1 + 1,
                 (const char *[]){"bumper.restitution", "contact.restitution", "bumper.exponent",
                                  "contact.damping"}[draw(4)]);
        snprintf(value, sizeof value, "%s", draw(2) ? "exact" : "");
        if (!*value)
            snprintf(value, sizeof value, "%.2f", 0.3 + draw(60) / 100.0 + (strstr(path, "expo") ? 1 : 0));
    }
    thud_scene_set(s, path, value, NULL);
}

static void random_shape(struct thud_scene *s)
{
    unsigned what = draw(6);
    int n = s->nstructures;
    if (what == 0 && n < 5) {
        s->structure[n] = s->structure[draw((unsigned)n)];
        memset(s->structure[n].name, 0, sizeof s->structure[n].name);
        snprintf(s->structure[n].name, sizeof s->structure[n].name, "n%u", draw(1000));
        if (n > 1)
            s->interface[n - 1] = s->interface[draw((unsigned)n - 1)];
        else
            thud_interface_init(&s->interface[0]);
        s->nstructures++;
    } else if (what == 1 && n > 1) {
        memset(&s->structure[n - 1], 0, sizeof *s->structure);
        memset(&s->interface[n - 2], 0, sizeof *s->interface);
        s->nstructures--;
    } else if (what == 2 && n > 1)
        s->interface[draw((unsigned)n - 1)].has_bumper = false;
}

/* A thickness without a bumper is not written. */
static void strip(struct thud_scene *s)
{
    for (int i = 0; i + 1 < s->nstructures; i++)
        if (!s->interface[i].has_bumper && !s->interface[i].bumper.law) {
            memset(&s->interface[i].bumper, 0, sizeof s->interface[i].bumper);
            s->interface[i].bumper_thickness_m = s->interface[i].bumper_cavity_m = 0;
        }
}

START_TEST(random_edits_read_back)
{
    struct thud_preset *preset = parse(preset_text, sizeof preset_text - 1);
    int whole = 0, kept = 0;
    state = 4711;
    for (int round = 0; round < 800; round++) {
        scene = *thud_preset_scene(preset);
        scene.study = (struct thud_study_choice){0};
        for (unsigned k = 1 + draw(4); k > 0; k--) {
            again = scene;
            random_edit(&again);
            random_shape(&again);
            strip(&again);
            if (thud_scene_check(&again, NULL) == THUD_OK)
                scene = again;
        }
        size_t size;
        char *text = text_of(preset, &scene, &size);
        struct thud_preset *read = parse(text, size);
        ck_assert_msg(memcmp(thud_preset_scene(read), &scene, sizeof scene) == 0, "round %d\n%s", round, text);
        whole++;
        kept += strstr(text, "# a title") != NULL;
        if (round % 7 == 6) { /* go on from what was saved, else from the start */
            thud_preset_free(preset);
            preset = round % 70 == 69 ? parse(preset_text, sizeof preset_text - 1) : parse(text, size);
        }
        thud_preset_free(read);
        free(text);
    }
    ck_assert_int_eq(kept, whole); /* never written as a whole for want of a better way */
    thud_preset_free(preset);
}
END_TEST

/* An interface without a law: another value of its contact names the law and leaves the rest of the file, comments and
 * all; a value elsewhere leaves the interface. Both once wrote the whole file anew. */
START_TEST(an_interface_without_a_law_keeps_the_file)
{
    static const char text[] = "structures:\n  - kind: rigid\n    mass: 3 t\n    velocity: 1 m/s\n  # the second\n"
                               "  - kind: rigid\n    mass: 4 t\ninterfaces:\n  - gap: 5 cm\n";
    struct thud_preset *preset = parse(text, sizeof text - 1);
    size_t size;
    scene = *thud_preset_scene(preset);
    set(&scene, "structures.1.mass", "5 t");
    char *out = text_of(preset, &scene, &size);
    ck_assert_uint_eq(size, sizeof text - 1);
    ck_assert_ptr_nonnull(strstr(out, "mass: 5 t\n    velocity: 1 m/s\n  # the second\n"));
    free(out);
    scene = *thud_preset_scene(preset);
    set(&scene, "interfaces.1.contact.restitution", "0.55");
    out = text_of(preset, &scene, &size);
    ck_assert_int_eq(memcmp(out, text, sizeof text - 1), 0);
    ck_assert_ptr_nonnull(strstr(out, "  - gap: 5 cm\n    contact:\n      law: kelvin-voigt-no-tension\n"));
    free(out);
    thud_preset_free(preset);
}
END_TEST

START_TEST(carriage_returns_and_a_missing_newline_stay)
{
    static const char crlf[] = "structures:\r\n  - kind: rigid  # one\r\n    mass: 3 t\r\nanalysis:\r\n  tail: 2 s";
    struct thud_preset *preset = parse(crlf, sizeof crlf - 1);
    scene = *thud_preset_scene(preset);
    set(&scene, "structures.1.velocity", "1 m/s");
    set(&scene, "analysis.tolerance", "1e-4");
    size_t size;
    char *text = text_of(preset, &scene, &size);
    ck_assert_ptr_nonnull(
        strstr(text, "mass: 3 t\r\n    velocity: 1 m/s\r\nanalysis:\r\n  tail: 2 s\r\n  tolerance: 0.0001\r\n"));
    struct thud_preset *read = parse(text, size);
    ck_assert_int_eq(memcmp(thud_preset_scene(read), &scene, sizeof scene), 0);
    thud_preset_free(read);
    free(text);
    thud_preset_free(preset);
}
END_TEST

/* Where values are from stands beside each group of keys: it is read back whatever letters it has, a line comes and
 * goes and nothing else changes, and no run sees it. */
START_TEST(sources_beside_every_group)
{
    static const char text[] =
        "record:\r\n  file: kobe.csv  # of a file\r\n  source: NGA-West2\r\nstructures:\r\n"
        "  - {kind: shear, storeys: 1, mass: 300 t, stiffness: 600 MN/m, column: {capacity: 1 MN, source: '[1] p. "
        "4'}}\r\n"
        "  - kind: isolated\r\n    storeys: 1\r\n    mass: 300 t\r\n    stiffness: 600 MN/m\r\n    base-mass: 300 t\r\n"
        "    isolator:  # by its maker\r\n      law: pendulum\r\n      radius: 2 m\r\n      friction: 5 %\r\n"
        "      source: \"a \\\"b\\\": c # d\"\r\n  - {kind: wall, mass: 27 t, stiffness: 40 MN/m}\r\n"
        "interfaces:\r\n  - gap: 9 cm\r\n    source: >-\r\n      survey\r\n      of May\r\n"
        "  - gap: 9 cm\r\n    bumper: {law: rubber, thickness: 5 cm, stiffness: 0.36 kN/mm^2.65, exponent: 2.65}\r\n"
        "links:\r\n  - {law: dashpot, from: A.1, to: B.1, damping: 1 MN s/m}\r\n";
    static const char *const path[] = {"record.source",
                                       "structures.1.source",
                                       "structures.1.column.source",
                                       "structures.2.isolator.source",
                                       "structures.2.foundation.source",
                                       "structures.3.backfill.source",
                                       "interfaces.1.source",
                                       "interfaces.1.contact.source",
                                       "interfaces.2.bumper.source",
                                       "links.1.source",
                                       "analysis.source"},
                             *const first[] = {"NGA-West2", "", "[1] p. 4", "a \"b\": c # d", "", "", "survey of May"};
    enum { PATHS = sizeof path / sizeof *path, LONG = 400 };
    char words[4][LONG + 1] = {"drawing S-12: \"plan\", 'b' # {c} [d]", "[1] EN 1992-1-1, table 3.1",
                               "\xc3\x96-Norm B 1998, \xd0\xbf. 4"},
                         value[THUD_SOURCE_MAX];
    struct thud_preset *preset = parse(text, sizeof text - 1);
    size_t size;
    memset(words[3], 'x', LONG);
    for (size_t i = 0; i < sizeof first / sizeof *first; i++) {
        ck_assert_int_eq(thud_scene_get(thud_preset_scene(preset), path[i], value, sizeof value, NULL), THUD_OK);
        ck_assert_str_eq(value, first[i]);
    }
    for (int i = 0; i < PATHS; i++) {
        ck_assert(thud_scene_is_words(thud_preset_scene(preset), path[i]));
        for (int w = 0; w < 4; w++) {
            scene = *thud_preset_scene(preset);
            if (i == 5) /* soil without its strength is none */
                set(&scene, "structures.3.backfill.stiffness", "300 MN/m"),
                    set(&scene, "structures.3.backfill.strength", "4 MN");
            set(&scene, path[i], words[w]);
            scene.interface[0].contact.assumed = i != 7; /* the contact that is written has a law */
            char *saved = text_of(preset, &scene, &size);
            struct thud_preset *read = parse(saved, size);
            ck_assert_msg(memcmp(thud_preset_scene(read), &scene, sizeof scene) == 0, "%s: %.*s", path[i], (int)size,
                          saved);
            ck_assert(strstr(saved, "kobe.csv  # of a file\r\n") && strstr(saved, "isolator:  # by its maker\r\n"));
            free(saved);
            if (i == 0 || i == 4 || i == 10) { /* as it was before, and so is the file */
                set(&scene, path[i], i == 0 ? first[0] : "");
                saved = text_of(read, &scene, &size);
                ck_assert_msg(size == sizeof text - 1 && memcmp(saved, text, size) == 0, "%s: %.*s", path[i], (int)size,
                              saved);
                free(saved);
            }
            thud_preset_free(read);
        }
    }
    char longer[THUD_SOURCE_MAX + 1] = "";
    memset(longer, 'x', THUD_SOURCE_MAX - 1);
    ck_assert_int_eq(thud_scene_set(&scene, "links.1.source", longer, NULL), THUD_OK);
    longer[THUD_SOURCE_MAX - 1] = 'x';
    ck_assert_int_eq(thud_scene_set(&scene, "links.1.source", longer, NULL), THUD_INPUT);
    ck_assert_int_eq(thud_scene_set(&scene, "study.source", "x", NULL), THUD_INPUT);
    thud_preset_free(preset);
}
END_TEST

START_TEST(a_file_is_replaced_whole)
{
    char folder[] = "/tmp/thud-save-XXXXXX", path[64];
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/mine.yaml", folder);
    struct thud_preset *preset = parse(preset_text, sizeof preset_text - 1), *read;
    struct thud_error err = {0};
    scene = *thud_preset_scene(preset);
    set(&scene, "interfaces.1.gap", "77 mm");
    ck_assert_int_eq(thud_preset_save(preset, &scene, path, &err), THUD_OK);
    ck_assert_int_eq(thud_preset_read(path, &read, &err), THUD_OK);
    ck_assert_str_eq(thud_preset_scene(read)->name, "mine");
    ck_assert_double_eq(thud_preset_scene(read)->interface[0].gap_m, 0.077);
    thud_preset_free(read);
    unlink(path);
    rmdir(folder);
    ck_assert_int_eq(thud_preset_save(preset, &scene, path, &err), THUD_OUTPUT);
    ck_assert_str_eq(err.file, path);
    ck_assert_int_eq(thud_preset_read(path, &read, &err), THUD_INPUT);
    ck_assert_ptr_null(read);
    thud_preset_free(preset);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("preset_save");
    TCase *tests = tcase_create("preset_save");
    tcase_add_test(tests, unchanged_is_the_same_bytes);
    tcase_add_loop_test(tests, lists_by_level, 0, 4);
    tcase_add_loop_test(tests, one_value_changes_one_line, 0, sizeof changes / sizeof *changes);
    tcase_add_test(tests, keys_come_and_go);
    tcase_add_test(tests, a_study_of_values_and_back);
    tcase_add_test(tests, comments_in_a_list_stay);
    tcase_add_test(tests, bumpers_and_structures_come_and_go);
    tcase_add_test(tests, random_edits_read_back);
    tcase_add_test(tests, an_interface_without_a_law_keeps_the_file);
    tcase_add_test(tests, carriage_returns_and_a_missing_newline_stay);
    tcase_add_test(tests, sources_beside_every_group);
    tcase_add_test(tests, a_file_is_replaced_whole);
    suite_add_tcase(suite, tests);
    return suite;
}
