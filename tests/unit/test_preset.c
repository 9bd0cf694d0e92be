/* Presets: what is read, what is refused and where. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/preset/preset.h"
#include "preset_text.h"
#include "remarks.h"

static struct thud_preset *parse(const char *text, size_t size)
{
    struct thud_preset *preset;
    struct thud_error err = {0};
    char message[1400];
    ck_assert_msg(thud_preset_parse(text, size, "dir/towers.yaml", &preset, &err) == THUD_OK, "%s",
                  thud_error_text(&err, message, sizeof message));
    return preset;
}

/* The paper's law, its values and a remark that says so, until another is chosen. */
START_TEST(contact_without_a_law)
{
    char *text = strdup(preset_text), *at = strstr(text, "    contact: {law: linear, stiffness: 1 MN/mm} # flow\n");
    struct thud_error remark = {0};
    ck_assert_ptr_nonnull(at);
    memset(at, ' ', strcspn(at, "\n"));
    struct thud_preset *preset = parse(text, strlen(text));
    struct thud_scene *scene = malloc(sizeof *scene);
    *scene = *thud_preset_scene(preset);
    ck_assert_str_eq(scene->interface[1].contact.law->name, "kelvin-voigt-no-tension");
    ck_assert_double_eq(scene->interface[1].contact.value[0], 2.5e9);
    ck_assert_double_eq(scene->interface[1].contact.value[1], 0.6);
    int said = 0;
    for (int i = 0; nth_unusual(scene, i, &remark); i++)
        said += strcmp(remark.key, "interfaces.2.contact.law") == 0 && strstr(remark.what, "no impact law is given");
    ck_assert_int_eq(said, 1);
    ck_assert_int_eq(thud_scene_set(scene, "interfaces.2.contact.law", "hertz", NULL), THUD_OK);
    ck_assert(!scene->interface[1].contact.assumed);
    char *saved; /* what was not there is added */
    unsigned long n;
    ck_assert_int_eq(thud_preset_text(preset, scene, &saved, &n, NULL), THUD_OK);
    struct thud_preset *again = parse(saved, n);
    ck_assert_str_eq(thud_preset_scene(again)->interface[1].contact.law->name, "hertz");
    free(saved);
    free(scene);
    free(text);
    thud_preset_free(again);
    thud_preset_free(preset);
}
END_TEST

START_TEST(every_value_arrives)
{
    struct thud_preset *preset = parse(preset_text, sizeof preset_text - 1);
    const struct thud_scene *s = thud_preset_scene(preset);
    ck_assert_str_eq(s->name, "towers");
    ck_assert_str_eq(s->title, "Towers: # two");
    ck_assert_str_eq(s->record.file, "kobe.csv");
    ck_assert_double_eq_tol(s->record.peak_mps2, 8.05125965, 1e-15);
    ck_assert_int_eq(s->record.sign, 1);
    ck_assert_int_eq(s->nstructures, 3);
    ck_assert_int_eq(s->structure[0].storeys, 4);
    ck_assert_double_eq(s->structure[0].mass_kg[1], 320e3);
    ck_assert_double_eq(s->structure[0].mass_kg[3], 250e3);
    ck_assert_double_eq(s->structure[0].mass_kg[4], 0);
    ck_assert_double_eq(s->structure[0].stiffness_npm[3], 6e8);
    ck_assert_double_eq(s->structure[0].damping, 0.05);
    ck_assert_int_eq(s->structure[1].kind, THUD_SHEAR);
    ck_assert_double_eq(s->structure[1].mass_kg[1], 310e3);
    ck_assert_double_eq(s->structure[1].height_m[2], 3);
    ck_assert_int_eq(s->structure[2].kind, THUD_RIGID);
    ck_assert_str_eq(s->structure[2].name, "C");
    ck_assert_double_eq(s->structure[2].velocity_mps, -0.5);
    ck_assert_double_eq(s->interface[0].gap_m, 0.1);
    ck_assert_str_eq(s->interface[0].contact.law->name, "kelvin-voigt-no-tension");
    ck_assert_double_eq(s->interface[0].contact.value[1], 0.6);
    ck_assert(s->interface[0].has_bumper);
    ck_assert_double_eq(s->interface[0].bumper_thickness_m, 0.05);
    ck_assert_double_eq_tol(s->interface[0].bumper.value[0] * pow(0.04, 2.65), 0.36e3 * pow(40, 2.65), 1e-3);
    ck_assert(!s->interface[1].has_bumper);
    ck_assert_double_eq(s->interface[1].gap_m, 0.0762);
    ck_assert_double_eq(s->analysis.tolerance, 1e-8);
    ck_assert_double_eq(s->analysis.tail_s, 5);
    ck_assert_int_eq(s->study.nvary, 1);
    ck_assert_double_eq(s->study.vary[0].step, 0.005);
    ck_assert_int_eq(s->study.ncases, 2);
    thud_preset_free(preset);
}
END_TEST

/* The text with one piece replaced. */
static char *replaced(const char *old, const char *new)
{
    const char *at = strstr(preset_text, old);
    ck_assert_msg(at != NULL, "%s", old);
    char *text = malloc(sizeof preset_text + strlen(new));
    size_t before = (size_t)(at - preset_text);
    memcpy(text, preset_text, before);
    strcpy(text + before, new);
    strcat(text, at + strlen(old));
    return text;
}

static void refused_text(const char *text, size_t size, const char *message)
{
    struct thud_preset *preset = (struct thud_preset *)&preset;
    struct thud_error err = {0};
    char said[1400];
    ck_assert_msg(thud_preset_parse(text, size, "p", &preset, &err) == THUD_INPUT, "taken: %s", message);
    ck_assert_ptr_null(preset);
    thud_error_text(&err, said, sizeof said);
    ck_assert_msg(strncmp(said, message, strlen(message)) == 0, "\"%s\"\nis not\n\"%s\"", said, message);
}

static const struct {
    const char *old, *new, *message;
} wrong[] = {
    {"gap: 100 mm", "gap: 100", "p:24:10: interfaces.1.gap: \"100\" has no unit; give a length (m, cm, mm, in, ft)"},
    {"gap: 100 mm", "gap: 100 kg", "p:24:10: interfaces.1.gap: \"100 kg\" is a mass; give a length (m, cm"},
    {"gap: 100 mm", "gap: 10,5 cm", "p:24:10: interfaces.1.gap: \"10,5 cm\" has a decimal comma (write 10.5 cm)"},
    {"gap: 100 mm", "gap: .nan", "p:24:10: interfaces.1.gap: \".nan\" is not a number; give a length"},
    {"gap: 100 mm", "gap: inf m", "p:24:10: interfaces.1.gap: \"inf m\" is not a number"},
    {"gap: 100 mm", "gap:", "p:24:9: interfaces.1.gap: nothing is given"},
    {"gap: 100 mm", "gap: [1 cm]", "p:24:10: interfaces.1.gap: a list is given where one value is expected"},
    {"gap: 100 mm", "gap: {a: 1}", "p:24:10: interfaces.1.gap: keys are given where a value is expected"},
    {"gap: 100 mm", "gap: 4 cm",
     "p:33:18: interfaces.1.bumper.thickness: the bumper projects by 5 cm into a gap of 4 cm (thickness - cavity <= "
     "gap)"},
    {"gap: 100 mm", "gap: 100 mm\n    gap: 2 m",
     "p:25:5: gap: the key is given twice (once; it is on line 24 already)"},
    {"gap: 100 mm", "gpa: 100 mm",
     "p:24:5: interfaces.1.gpa: unknown key \"gpa\"; did you mean \"gap\"? (gap, gap-by-level, levels, contact-levels, "
     "source, "
     "contact, bumper)"},
    {"gap: 100 mm", "gap: -1 mm", "p:24:10: interfaces.1.gap: -1 mm is too small (0 cm to 500 cm)"},
    {"  - gap: 100 mm   # wide\n    contact", "  - contact",
     "p:24:5: interfaces.1.gap: gap is not given (a length in m, cm"},
    {"320000 kg", "-5 t", "p:10:19: structures.1.mass.2: -5 t is too small (> 0 t"},
    {"320000 kg", "[1 t]", "p:10:19: structures.1.mass.2: a list or keys are given where one value is expected"},
    {"320000 kg", "", "p:10:"},
    {", 250 t] # four", "] # four\n    storeys: 4",
     "p:10:11: structures.1.mass: the list has 3 values, the structure has 4 storeys"},
    {"storeys: 3", "storeys: 0", "p:15:14: structures.2.storeys: 0 is too small (1 to 200)"},
    {"storeys: 3", "storeys: 4", "p:17:7: structures.2.mass: the list has 3 values, the structure has 4 storeys"},
    {"storeys: 3", "Storeys: 3", "p:15:5: structures.2.Storeys: unknown key \"Storeys\"; did you mean \"storeys\"?"},
    {"kind: shear", "kind: sheer",
     "p:9:11: structures.1.kind: unknown choice \"sheer\"; did you mean \"shear\"? (shear, rigid, isolated, wall, "
     "matrix, modes, estimated)"},
    {"kind: shear", "kind: wall", "p:10:11: structures.1.mass: a list is given where one value is expected"},
    {"kind: shear", "kind: isolated",
     "p:8:5: structures.1.base-mass: mass of the base slab is not given (a mass in t, kg, Mg, lb, kip s2/in, tonf "
     "s2/m)"},
    {"name: B", "name: A", "p:14:11: structures.2.name: \"A\" is the name of structure 1 too"},
    {"    stiffness: 600 MN/m\n", "",
     "p:8:5: structures.1.stiffness: storey stiffness is not given (a stiffness in N/m"},
    {"damping: 0.05", "damping: 100 %", "p:13:14: structures.1.damping: 100 % is too large (at least 0 %, < 100 %)"},
    {"restitution: 60 %", "restitution: 0", "p:28:20: interfaces.1.contact.restitution: 0 is too small (> 0, up to 1)"},
    {"restitution: 60 %", "restitutoin: 60 %",
     "p:28:7: interfaces.1.contact.restitutoin: unknown key \"restitutoin\"; did you mean \"restitution\"?"},
    {"law: rubber\n", "law: rubbr\n",
     "p:30:12: interfaces.1.bumper.law: unknown law \"rubbr\"; did you mean \"rubber\"?"},
    {"law: rubber\n", "exponent: 2\n", "p:32:7: exponent: the key is given twice"},
    {"      law: rubber\n", "", "p:30:7: interfaces.1.bumper.law: the impact law is not given"},
    {"      thickness: 5 cm\n", "", "p:30:7: interfaces.1.bumper.thickness: thickness is not given"},
    {"kN/mm^2.65 #", "kN/mm^2.5 #",
     "p:31:18: interfaces.1.bumper.stiffness: the unit of \"0.36 kN/mm^2.5\" has the exponent 2.5, the law's exponent "
     "is 2.65 (a number of kN/mm^2.65)"},
    {"exponent: 2.65", "exponent: 2.7",
     "p:31:18: interfaces.1.bumper.stiffness: the unit of \"0.36 kN/mm^2.65\" has the exponent 2.65, the law's "
     "exponent is 2.7"},
    {"  - gap: 3 in\n    contact: {law: linear, stiffness: 1 MN/mm} # flow\n", "",
     "p:24:3: interfaces: 3 structures need 2 interfaces, not 1"},
    {"exponent: 2.65", "kind: 2.65",
     "p:32:7: interfaces.1.bumper.kind: unknown key \"kind\""}, /* a key of others, set first */
    {"interfaces:\n", "interface:\n", "p:23:1: interface: unknown key \"interface\"; did you mean \"interfaces\"?"},
    {"record:\n", "record: kobe.csv\nrecords:\n", "p:4:1: records: unknown key \"records\"; did you mean \"record\"?"},
    {"record:\n", "record: &a\n", "p:3:9: anchors (&name) are not taken"},
    {"file: kobe.csv", "file: *a", "p:4:9: aliases (*name) are not taken"},
    {"file: kobe.csv", "file: !!str kobe.csv", "p:4:9: tags (!name) are not taken"},
    {"file: kobe.csv", "? [a, b]\n  : kobe.csv", "p:4:5: a list or keys are given where a key is expected"},
    {"sign: +", "sign: x", "p:6:9: record.sign: unknown choice \"x\" (+, -)"},
    {"sign: +", "sign: -", "p:6:9: block sequence entries are not allowed in this context"},
    {"sign: +", "<<: {a: 1}", "p:6:3: record.<<: unknown key \"<<\""},
    {"sign: +", "dt.x: 5 s", "p:6:3: record: presets have no such key"},
    {"  sign: +", "\tsign: +", "p:6:1: a tab is not allowed here (spaces)"},
    {"tolerance: 1e-8", "tolerance: 1", "p:38:14: analysis.tolerance: 1 is too large (1e-13 to 0.1)"},
    {"tolerance: 1e-8", "method: exakt", "p:38:11: analysis.method: unknown method \"exakt\"; did you mean \"exact\"?"},
    {"vary: interfaces.1.gap", "vary: gap", "p:40:9: "},
    {"  to: 25 cm\n", "", "p:40:3: study.to: the varied key interfaces.1.gap has no \"to\""},
    {"to: 25 cm", "to: 2 cm", "p:42:7: study.to: the last value is below the first one"},
    {"step: 0.5 cm", "step: 0.5 t", "p:43:9: study.step: \"0.5 t\" is a mass; give a length"},
    {"[none, bumper]", "[none, bumpr]", "p:44:10: study.cases: unknown case \"bumpr\"; did you mean \"bumper\"?"},
    {"  from: 5 cm\n", "  values: [5 cm, [6 cm, 7 cm]]\n", "p:41:11: study.values: \"[6 cm, 7 cm]\" is not a number"},
    {"  from: 5 cm\n", "  values: [5 cm, \"6 cm, 7 cm\"]\n",
     "p:41:18: study.values: a comma or a bracket inside a value"},
    {"  from: 5 cm\n", "  values: [5 cm, 6]\n", "p:41:11: study.values: \"6\" has no unit; give a length"},
    {"[none, bumper]", "[]", "p:44:10: study.cases: the list is empty"},
    {"study:\n", "---\nstudy:\n", "p:39:1: a second document begins (one in each file)"},
    {"# head\n", "%YAML 1.1\n---\n", "p:1:1: directives"},
    {"# head\n", "- a\n", "p:2:1: did not find expected"},
    {"name: A ", "name: \"\\0\" ", "p:8:11: a NUL character"},
    {"name: A ", "name: \"a\\tb\" ", "p:8:11: structures.1.name: the text has a control character"},
    {"mass: [320 t, 320000", "mass: '[320 t, 320000", "p:"},
    {"[320 t, 320000 kg, 320 t, 250 t]", "\"[320 t, 1 t]\"\n    storeys: 2",
     "p:10:11: structures.1.mass: a list must not be quoted"},
};

START_TEST(what_is_wrong_is_said_with_its_place)
{
    char *text = replaced(wrong[_i].old, wrong[_i].new);
    refused_text(text, strlen(text), wrong[_i].message);
    free(text);
}
END_TEST

START_TEST(whole_files_that_are_none)
{
    static const char *const rows[][2] = {
        {"", "p:1:1: the file is empty"},
        {"# only a comment\n", "p:1:1: the file is empty"},
        {"---\n", "p:2:1: keys with values are expected here"},
        {"hello\n", "p:1:1: keys with values are expected here"},
        {"- a\n- b\n", "p:1:1: keys with values are expected here"},
        {"{}\n", "p:1:1: structures: there is no structure"},
        {"structures: []\n", "p:1:13: structures: there is no structure"},
        {"structures: 5\n", "p:1:13: structures: a list is expected here"},
        {"structures:\n  - 5\n", "p:2:5: structures.1: keys with values are expected here"},
        {"structures:\n  - kind: shear\n    mass: 3 t\n",
         "p:2:5: structures.1.storeys: storeys is not given (a number, or a list"},
        {"structures:\n  - kind: wall\n", "p:2:3: structures: there are only walls"},
        {"structures:\n  - {kind: rigid, mass: 3 t}\nanalysis: {tail: 0 s}\n",
         "p:3:18: analysis.tail: without a ground motion"},
        {"a: [[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]\n", "p:1:"},
        {"a: \xff\xff\n", "p:1:4: invalid leading UTF-8 octet (printable UTF-8 text)"},
        {"a: b\nc: \x01\n", "p:2:4: control characters are not allowed"},
        {"\xff\xfe"
         "a",
         "p:1:1: the file is UTF-16 (UTF-8 text)"},
        {"a: 'b\n", "p:2:1: found unexpected end of stream"},
        {"a: b: c\n", "p:1:5: mapping values are not allowed in this context"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        refused_text(rows[i][0], strlen(rows[i][0]), rows[i][1]);
    refused_text("a\0b", 3, "p:1:2: control characters");
    char *large = malloc(2u << 20);
    memset(large, '#', 2u << 20);
    refused_text(large, 2u << 20, "p: the file is too large (at most 1048576 bytes)");
    free(large);
}
END_TEST

/* A byte-order mark and carriage returns change nothing but the bytes. */
START_TEST(marks_and_carriage_returns_are_taken)
{
    struct thud_preset *plain = parse(preset_text, sizeof preset_text - 1);
    char *text = malloc(2 * sizeof preset_text + 3);
    size_t n = 0;
    memcpy(text, "\xef\xbb\xbf", 3);
    n = 3;
    for (const char *c = preset_text; *c; c++) {
        if (*c == '\n')
            text[n++] = '\r';
        text[n++] = *c;
    }
    struct thud_preset *dressed = parse(text, n);
    ck_assert_int_eq(memcmp(thud_preset_scene(plain), thud_preset_scene(dressed), sizeof(struct thud_scene)), 0);
    thud_preset_free(dressed);
    /* and the place of an error stays the same */
    memcpy(strstr(text, "0.821 g"), "0.821 t", 7);
    refused_text(text, n, "p:5:9: record.peak: \"0.821 t\" is a mass; give an acceleration");
    free(text);
    thud_preset_free(plain);
}
END_TEST

/* No file cut short or with a byte changed does harm. */
START_TEST(broken_files_do_no_harm)
{
    char text[sizeof preset_text];
    unsigned state = 12345;
    int taken = 0;
    for (int i = 0; i < 4000; i++) {
        struct thud_preset *preset;
        size_t size = sizeof preset_text - 1;
        memcpy(text, preset_text, size);
        for (int k = 0; k < 1 + i % 3; k++) {
            state = state * 1664525u + 1013904223u;
            text[(state >> 8) % size] = "\n :-[]{}#'\"0a,\t\xc3"[(state >> 24) % 17];
        }
        if (i % 5 == 0)
            size = (state >> 8) % size;
        struct thud_error err = {0};
        if (thud_preset_parse(text, size, "p", &preset, &err) == THUD_OK) {
            taken++;
            thud_preset_free(preset);
        } else
            ck_assert(err.status == THUD_INPUT && err.what[0] && err.line > 0);
    }
    ck_assert_int_gt(taken, 100); /* a comment may change */
    ck_assert_int_lt(taken, 3900);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("preset");
    TCase *tests = tcase_create("preset");
    tcase_add_test(tests, every_value_arrives);
    tcase_add_test(tests, contact_without_a_law);
    tcase_add_loop_test(tests, what_is_wrong_is_said_with_its_place, 0, sizeof wrong / sizeof *wrong);
    tcase_add_test(tests, whole_files_that_are_none);
    tcase_add_test(tests, marks_and_carriage_returns_are_taken);
    tcase_add_test(tests, broken_files_do_no_harm);
    suite_add_tcase(suite, tests);
    return suite;
}
