/* Scenes: every key reads back what was set, refusals name key and remedy, checks and cases hold. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "remarks.h"
#include "study/scene/scene.h"

static struct thud_scene scene; /* large */

static void set(const char *path, const char *text)
{
    struct thud_error err = {0};
    char message[1200];
    ck_assert_msg(thud_scene_set(&scene, path, text, &err) == THUD_OK, "%s",
                  thud_error_text(&err, message, sizeof message));
}

static void gets(const char *path, const char *text)
{
    char got[2000];
    struct thud_error err = {0};
    ck_assert_msg(thud_scene_get(&scene, path, got, sizeof got, &err) == THUD_OK, "%s: %s", path, err.what);
    ck_assert_msg(strcmp(got, text) == 0, "%s: \"%s\", not \"%s\"", path, got, text);
}

static void refuses(const char *path, const char *text, const char *what, const char *allowed)
{
    static struct thud_scene before;
    struct thud_error err = {0};
    char message[1200];
    before = scene;
    ck_assert_msg(thud_scene_set(&scene, path, text, &err) == THUD_INPUT, "%s takes %s", path, text);
    thud_error_text(&err, message, sizeof message);
    ck_assert_msg(strstr(err.what, what) != NULL, "%s lacks \"%s\"", message, what);
    ck_assert_msg(strstr(err.allowed, allowed) != NULL, "%s lacks \"%s\"", message, allowed);
    ck_assert_str_eq(err.key, path);
    ck_assert_int_eq(memcmp(&before, &scene, sizeof scene), 0);
}

static void holds(void)
{
    struct thud_error err = {0};
    char message[1200];
    ck_assert_msg(thud_scene_check(&scene, &err) == THUD_OK, "%s", thud_error_text(&err, message, sizeof message));
}

static void fails(const char *key, const char *what)
{
    struct thud_error err = {0};
    ck_assert_int_eq(thud_scene_check(&scene, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, key);
    ck_assert_msg(strstr(err.what, what) != NULL, "\"%s\" lacks \"%s\"", err.what, what);
}

static void towers(void)
{
    thud_scene_init(&scene);
    scene.nstructures = 2;
    for (int s = 0; s < 2; s++) {
        char path[64];
        thud_structure_init(&scene.structure[s], THUD_SHEAR);
        scene.structure[s].name[0] = (char)('A' + s);
        snprintf(path, sizeof path, "structures.%d.storeys", s + 1);
        set(path, s ? "6" : "4");
        snprintf(path, sizeof path, "structures.%d.mass", s + 1);
        set(path, s ? "[320 t, 320 t, 320 t, 320 t, 320 t, 250 t]" : "[320 t, 320 t, 320 t, 250 t]");
        snprintf(path, sizeof path, "structures.%d.stiffness", s + 1);
        set(path, "600 MN/m");
    }
    thud_interface_init(&scene.interface[0]);
    thud_interface_add_bumper(&scene.interface[0]);
}

START_TEST(values_read_back_as_set)
{
    static const char *const rows[][2] = {
        {"title", "Two towers"},
        {"record.file", "kobe.csv"},
        {"record.peak", "0.821 g"},
        {"record.sign", "-"},
        {"record.factor", "1.5"},
        {"record.from", "2.5 s"},
        {"record.to", "12 s"},
        {"record.dt", "0.005 s"},
        {"record.unit", "g"},
        {"record.channel", "NS"},
        {"record.column", "all"},
        {"record.column", "2"},
        {"record.skip", "3"},
        {"structures.1.name", "tower \"a\" `b` 'c'"},
        {"structures.1.mass.2", "310 t"},
        {"structures.1.height", "[3.2 m, 3 m, 3 m, 3.5 m]"},
        {"structures.2.damping", "0 %"},
        {"gap", "12.5 cm"},
        {"interfaces.1.gap", "11 cm"},
        {"contact.restitution", "0.65"},
        {"contact.damping", "exact"},
        {"contact.residual", "recover"},
        {"bumper.thickness", "4 cm"},
        {"bumper.cavity", "1 cm"},
        {"bumper.stiffness", "0.4 kN/mm^2.65"},
        {"bumper.unloading", "continuous"},
        {"bumper.area", "0.5 m^2"},
        {"analysis.method", "exact"},
        {"analysis.tolerance", "1e-8"},
        {"analysis.step", "0.1 ms"},
        {"analysis.tail", "7 s"},
        {"analysis.locate", "off"},
        {"study.vary", "gap"},
        {"study.from", "5 cm"},
        {"study.to", "25 cm"},
        {"study.step", "0.5 cm"},
        {"study.cases", "[none, cavity]"},
        {"study.cases", "[link, cavity, bumper, as-written, none]"},
        {"study.vary", "[gap, bumper.stiffness]"},
        {"study.from", "[5 cm, 0.3 kN/mm^2.65]"},
        {"study.vary", "contact.damping"},
        {"study.values", "[exact, paper]"},
        {"study.vary", "[gap, bumper.thickness]"},
        {"study.values", "[[5 cm, 0.12 m], [4 cm]]"},
        {"study.from", ""}, /* no range beside them */
    };
    towers();
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        set(rows[i][0], rows[i][1]);
        gets(rows[i][0], rows[i][1]);
    }
    ck_assert_double_eq(scene.structure[0].mass_kg[1], 310e3);
    ck_assert_double_eq(scene.interface[0].gap_m, 0.11);
    ck_assert_int_eq(scene.record.sign, -1);
}
END_TEST

START_TEST(what_need_not_be_given_can_be_taken_back)
{
    static const char *const paths[] = {"record.file",    "record.peak",   "record.dt",   "record.unit",
                                        "record.channel", "record.column", "record.skip", "analysis.step",
                                        "bumper.area",    "record.from",   "record.to"};
    towers();
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        set(paths[i], i == 1 ? "1 g" : i == 2 || i == 7 || i > 8 ? "1 s" : i == 8 ? "1 m2" : "1");
        set(paths[i], "");
        gets(paths[i], "");
    }
    static struct thud_scene fresh;
    fresh = scene;
    towers();
    ck_assert_int_eq(memcmp(&fresh, &scene, sizeof scene), 0);
    refuses("gap", "", "nothing is given", "cm");
    refuses("structures.1.mass", "", "nothing is given", "t");
}
END_TEST

START_TEST(units_convert_and_lists_are_written_short)
{
    towers();
    gets("structures.1.mass", "[320 t, 320 t, 320 t, 250 t]");
    gets("structures.1.stiffness", "600 MN/m");
    set("gap", "0.05 m");
    gets("gap", "5 cm");
    char text[64];
    ck_assert_int_eq(thud_scene_get_in(&scene, "gap", "mm", text, sizeof text, NULL), THUD_OK);
    ck_assert_str_eq(text, "50 mm");
    gets("bumper.stiffness", "0.36 kN/mm^2.65");
}
END_TEST

START_TEST(refusals_name_key_and_remedy)
{
    towers();
    refuses("structures.1.mas", "3 t", "did you mean \"mass\"", "stiffness");
    refuses("structure.1.mass", "3 t", "did you mean \"structures\"", "interfaces");
    refuses("structures.3.mass", "3 t", "no structure \"3\"", "1 to 2");
    refuses("structures.0.mass", "3 t", "no structure \"0\"", "1 to 2");
    refuses("structures.1.mass.5", "3 t", "no floor \"5\"", "1 to 4");
    refuses("structures.1.damping.1", "3 %", "too many or too few parts", "");
    refuses("structures.1.velocity", "1 m/s", "unknown key", "damping");
    refuses("interfaces.2.gap", "3 cm", "no interface \"2\"", "1");
    refuses("bumper.thicknes", "3 cm", "did you mean \"thickness\"", "cavity");
    refuses("gapp", "3 cm", "did you mean \"gap\"", "");
    refuses("gap", "3", "no unit", "cm");
    refuses("gap", "3 kg", "is a mass; give a length", "cm");
    refuses("gap", "3,5 cm", "decimal comma", "3.5 cm");
    refuses("gap", "-1 cm", "too small", "0 cm to 500 cm");
    refuses("structures.1.mass", "-5 t", "too small", "> 0 t");
    refuses("structures.1.mass", "[1 t, 2 t]", "the list has 2 values, the structure has 4", "4");
    refuses("structures.1.mass", "[1 t, 2 t", "no end", "");
    refuses("structures.1.mass.2", "[1 t]", "not a list", "");
    refuses("structures.1.storeys", "0", "too small", "1 to 200");
    refuses("structures.1.storeys", "201", "too large", "1 to 200");
    refuses("structures.1.storeys", "2.5", "not a whole number", "1 to 200");
    refuses("structures.1.kind", "shaer", "did you mean \"shear\"", "wall");
    refuses("structures.1.name", "a\tb\n", "control character", "");
    refuses("structures.1.name", "\xff", "UTF-8", "");
    refuses("structures.1.damping", "100 %", "too large", "< 100 %");
    refuses("contact.law", "hertzz", "did you mean \"hertz\"", "rubber");
    refuses("contact.restitution", "0", "too small", "> 0");
    refuses("contact.damping", "papre", "did you mean \"paper\"", "exact");
    refuses("bumper.stiffness", "0.36 kN/mm^2.7", "has the exponent 2.7, the law's exponent is 2.65", "kN/mm^2.65");
    refuses("bumper.stiffness", "0.36 kN/mm", "has the exponent 1", "kN/mm^2.65");
    refuses("analysis.method", "exakt", "did you mean \"exact\"", "auto");
    refuses("analysis.locate", "maybe", "unknown choice", "off, on");
    refuses("record.sign", "x", "unknown choice", "+, -");
    refuses("record.peak", "3 m", "is a length; give an acceleration", "g");
    refuses("study.vary", "title", "neither a number nor a choice", "");
    refuses("study.values", "[5 cm]", "study.vary", "");
    refuses("study.vary", "[gap, gap]", "varied twice", "");
    refuses("study.from", "5 cm", "study.vary", "");
    refuses("study.cases", "[none, nine]", "unknown case", "cavity");
    refuses("study.cases", "[none, bumper, none]", "named twice", "");
    refuses("study.cases", "[none, bumper", "unterminated list", "");
    refuses("study.vary", "[gap, contact.damping, structures.1.damping, structures.2.damping, tail]", "too many values",
            "up to 4");
    set("study.vary", "gap");
    refuses("study.from", "5 t", "is a mass; give a length", "cm");
    refuses("study.step", "0 cm", "too small", "> 0");
    refuses("study.to", "[5 cm, 6 cm]", "2 values for 1 varied key", "");
    refuses("study.values", "[5 cm, 6]", "\"6\" has no unit", "cm");
    refuses("study.values", "[5 cm, , 6 cm]", "a value is empty", "");
    refuses("study.values", "[5 cm, 6 cm", "unterminated list", "");
    set("study.to", "6 cm");
    refuses("study.values", "[5 cm]", "values and a range", "");
    set("study.vary", "gap");
    set("study.values", "[5 cm]");
    refuses("study.to", "6 cm", "values and a range", "");
    set("study.vary", "[gap, contact.damping]");
    refuses("study.values", "[5 cm, 6 cm, 7 cm]", "3 lists for 2 varied keys", "");
    refuses("study.values", "[[5 cm], [papre]]", "did you mean \"paper\"", "exact");
    refuses("study.from", "[5 cm, paper]", "words have no range", "values: [paper]");
    char many[2 * THUD_VARY_VALUES] = "[[1 cm";
    for (size_t n = strlen(many); n < THUD_VARY_VALUES; n = strlen(many))
        snprintf(many + n, sizeof many - n, ", %zu mm", n);
    strcat(many, "], paper]");
    refuses("study.values", many, "too long", "bytes");
    scene.nstructures = 3;
    refuses("gap", "3 cm", "does not say which", "interfaces.1.gap");
}
END_TEST

START_TEST(storeys_are_added_and_taken_below_the_top)
{
    towers();
    set("structures.1.storeys", "6");
    gets("structures.1.mass", "[320 t, 320 t, 320 t, 320 t, 320 t, 250 t]");
    ck_assert_int_eq(memcmp(scene.structure[0].mass_kg, scene.structure[1].mass_kg, sizeof scene.structure[0].mass_kg),
                     0);
    set("structures.1.storeys", "2");
    gets("structures.1.mass", "[320 t, 250 t]");
    ck_assert_double_eq(scene.structure[0].mass_kg[2], 0);
    set("structures.1.storeys", "1");
    gets("structures.1.mass", "250 t");
    set("structures.1.storeys", "200");
    gets("structures.1.mass", "250 t");
    holds();
}
END_TEST

START_TEST(a_change_of_kind_or_law_leaves_a_whole_scene)
{
    static const char *const kinds[] = {"isolated", "rigid", "wall", "shear", "isolated", "wall", "rigid", "shear"};
    towers();
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        set("structures.1.kind", kinds[i]);
        gets("structures.1.kind", kinds[i]);
        gets("structures.1.name", "A");
        holds();
    }
    for (int i = 0; i < thud_law_count(); i++) {
        set("bumper.law", thud_law_at(i)->name);
        holds();
        if (strcmp(thud_law_at(i)->name, "rubber") != 0) {
            set("contact.law", thud_law_at(i)->name);
            holds();
        }
    }
    set("contact.law", "linear");
    set("contact.stiffness", "1234 kN/mm");
    set("contact.law", "kelvin-voigt");
    gets("contact.stiffness", "1234 kN/mm");
    scene.interface[0] = (struct thud_interface){0};
    thud_interface_init(&scene.interface[0]);
    refuses("bumper.thickness", "3 cm", "has no bumper", "bumper.law");
    set("bumper.law", "rubber");
    gets("bumper.stiffness", "0.36 kN/mm^2.65");
    ck_assert(scene.interface[0].has_bumper);
}
END_TEST

START_TEST(an_exponent_keeps_the_number_of_its_stiffness)
{
    towers();
    set("bumper.exponent", "2.7");
    gets("bumper.stiffness", "0.36 kN/mm^2.7");
    ck_assert_double_eq_tol(scene.interface[0].bumper.value[0] / (0.36e3 * pow(1000, 2.7)), 1, 1e-14);
    set("bumper.exponent", "2.65");
    gets("bumper.stiffness", "0.36 kN/mm^2.65");
}
END_TEST

START_TEST(checks_hold_values_against_each_other)
{
    towers();
    holds();
    set("gap", "5 cm");
    holds(); /* clearance 0 */
    ck_assert_double_eq(thud_interface_clearance(&scene.interface[0]), 0);
    set("gap", "4.9 cm");
    fails("interfaces.1.bumper.thickness", "projects by 5 cm into a gap of 4.9 cm");
    set("bumper.cavity", "0.1 cm");
    holds();
    ck_assert_double_eq(thud_interface_clearance(&scene.interface[0]), 0);
    set("bumper.cavity", "5 cm");
    fails("interfaces.1.bumper.cavity", "as deep as");
    towers();
    set("bumper.alpha", "2");
    fails("interfaces.1.bumper.alpha", "together with stiffness");
    set("bumper.stiffness", "");
    fails("interfaces.1.bumper.material-stiffness", "not given");
    set("bumper.area", "0.5 m2");
    set("bumper.material-stiffness", "1 MPa");
    holds();
    towers();
    scene.structure[0].mass_kg[2] = -1;
    fails("structures.1.mass.3", "too small");
    scene.structure[0].mass_kg[2] = NAN;
    fails("structures.1.mass", "not given");
    towers();
    set("structures.2.name", "A");
    fails("structures.2.name", "name of structure 1 too");
    towers();
    set("structures.1.kind", "wall");
    set("structures.2.kind", "wall");
    fails("structures", "only walls");
    thud_scene_init(&scene);
    fails("structures", "no structure");
    towers();
    set("analysis.tail", "0 s");
    fails("analysis.tail", "duration");
    set("record.file", "kobe.csv");
    holds();
    set("study.vary", "gap");
    fails("study.from", "no \"from\"");
    set("study.from", "5 cm");
    set("study.to", "4 cm");
    set("study.step", "1 cm");
    fails("study.to", "below the first");
    set("study.vary", "contact.damping");
    fails("study.values", "has no values");
    set("study.values", "exact");
    holds();
}
END_TEST

START_TEST(cases_are_the_scene_with_another_bumper)
{
    static struct thud_scene out;
    struct thud_error err = {0};
    towers();
    set("bumper.cavity", "0.3 cm");
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_AS_WRITTEN, &out, &err), THUD_OK);
    ck_assert_int_eq(memcmp(&out, &scene, sizeof out), 0);
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_NONE, &out, &err), THUD_OK);
    ck_assert_double_eq(thud_interface_clearance(&out.interface[0]), 0.1);
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_BUMPER, &out, &err), THUD_OK);
    ck_assert_double_eq_tol(thud_interface_clearance(&out.interface[0]), 0.05, 1e-15);
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_CAVITY, &out, &err), THUD_OK);
    ck_assert_double_eq_tol(out.interface[0].bumper_cavity_m, 0.01, 1e-15);
    ck_assert_double_eq_tol(thud_interface_clearance(&out.interface[0]), 0.06, 1e-15);
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_CAVITY, &scene, &err), THUD_OK); /* in place */
    ck_assert_int_eq(memcmp(&out, &scene, sizeof out), 0);
    set("bumper.thickness-by-level", "[5 cm, 5 cm, 5 cm, 1 cm]"); /* as thin as the cavity is deep */
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_CAVITY, &out, &err), THUD_INPUT);
    ck_assert_str_eq(err.key, "case");
    ck_assert_ptr_nonnull(strstr(err.what, "1 cm thick at level 4"));
    ck_assert_ptr_nonnull(strstr(err.allowed, "0 cm: no bumper there"));
    set("bumper.thickness-by-level", "[5 cm, 5 cm, 5 cm, 0 cm]");
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_CAVITY, &out, &err), THUD_OK);
    set("bumper.thickness-by-level", "");
    set("bumper.law", "linear");
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_CAVITY, &out, &err), THUD_INPUT);
    scene.interface[0].has_bumper = false;
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_BUMPER, &out, &err), THUD_INPUT);
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_NONE, &out, &err), THUD_OK);
    enum thud_case which;
    for (int i = -1; i < THUD_CASES; i++) {
        ck_assert_int_eq(thud_case_find(thud_case_name((enum thud_case)i), &which, &err), THUD_OK);
        ck_assert_int_eq((int)which, i);
    }
    ck_assert_int_eq(thud_case_find("bumpr", &which, &err), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.what, "did you mean \"bumper\""));
}
END_TEST

START_TEST(unusual_values_are_told)
{
    struct thud_error err;
    towers();
    ck_assert(!nth_unusual(&scene, 0, &err));
    set("structures.1.damping", "30 %");
    set("structures.2.mass.3", "1 t");
    set("bumper.restitution", "0.99");
    ck_assert(nth_unusual(&scene, 0, &err));
    ck_assert_str_eq(err.key, "structures.1.damping");
    ck_assert_str_eq(err.allowed, "usually 1 % to 20 %");
    ck_assert(nth_unusual(&scene, 1, &err));
    ck_assert_str_eq(err.key, "structures.2.mass.3");
    ck_assert(nth_unusual(&scene, 2, &err));
    ck_assert_str_eq(err.key, "interfaces.1.bumper.restitution");
    ck_assert(!nth_unusual(&scene, 3, &err));
    holds();
}
END_TEST

/* What only values together make unusual; the paper's bumper has 6.33 MN at its ultimate strain, from which
 * its curve rises by 510.9 kN/mm to its thickness. */
START_TEST(unusual_combinations_are_told)
{
    static const struct {
        const char *path, *value, *key, *said, *usual;
    } odd[] = {{"bumper.stiffness", "0.005 kN/mm^2.65", "interfaces.1.bumper.stiffness", "0.088 MN", "0.1 to 100 MN"},
               {"bumper.post-yield", "400 kN/mm", "interfaces.1.bumper.post-yield", "400 kN/mm", "510.9 kN/mm"},
               {"bumper.cavity", "1.5 cm", "interfaces.1.bumper.cavity", "1.5 cm", "1 cm"},
               {"structures.2.base", "20 m", "interfaces.1", "the same level", "heights"}};
    struct thud_error err;
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++) {
        towers();
        set(odd[i].path, odd[i].value);
        ck_assert_msg(nth_unusual(&scene, 0, &err), "%s", odd[i].path);
        ck_assert_str_eq(err.key, odd[i].key);
        ck_assert_msg(strstr(err.what, odd[i].said) && strstr(err.allowed, odd[i].usual), "%s (%s)", err.what,
                      err.allowed);
        ck_assert(!nth_unusual(&scene, 1, &err));
        holds();
    }
    towers();
    set("bumper.post-yield", "511 kN/mm");
    set("bumper.cavity", "1 cm");
    ck_assert(!nth_unusual(&scene, 0, &err));
}
END_TEST

/* Concrete on concrete: 2 pi sqrt(m/k) with m of 250 t against 320 t and 2500 kN/mm is 47.08 ms. */
START_TEST(a_step_too_long_for_a_contact_is_told)
{
    struct thud_error err;
    towers();
    ck_assert_int_eq(thud_scene_case(&scene, THUD_CASE_NONE, &scene, &err), THUD_OK);
    set("analysis.step", "2.36 ms");
    ck_assert(!nth_unusual(&scene, 0, &err)); /* nobody takes it */
    set("analysis.method", "rk4");
    ck_assert(nth_unusual(&scene, 0, &err) && strcmp(err.key, "analysis.step") == 0);
    ck_assert_msg(strstr(err.what, "47.08 ms") && strstr(err.allowed, "2.354 ms"), "%s (%s)", err.what, err.allowed);
    set("analysis.step", "2.35 ms");
    ck_assert(!nth_unusual(&scene, 0, &err));
}
END_TEST

/* Every parameter of the tables is found by its path, has words, and its fallback is allowed. */
START_TEST(the_tables_are_whole)
{
    towers();
    for (int g = 0; g < THUD_GROUPS; g++) {
        const struct thud_param *param;
        ck_assert_ptr_nonnull(thud_group_param((enum thud_group)g, 0));
        for (int i = 0; (param = thud_group_param((enum thud_group)g, i)); i++) {
            ck_assert_msg(param->title && param->help && *param->help, "%s", param->name);
            if (param->kind == THUD_PARAM_QUANTITY && *param->unit) {
                enum thud_dimension dimension;
                ck_assert(thud_unit_factor(param->unit, &dimension, NULL) > 0);
                ck_assert_int_eq((int)dimension, (int)param->dimension);
            }
            if (param->kind == THUD_PARAM_QUANTITY && !isnan(param->fallback))
                ck_assert_msg(thud_param_check(param, param->fallback, "", NULL) == THUD_OK, "%s", param->name);
        }
    }
    int floor;
    ck_assert_ptr_nonnull(thud_scene_param(&scene, "structures.2.mass.6", &floor));
    ck_assert_int_eq(floor, 5);
    ck_assert_ptr_nonnull(thud_scene_param(&scene, "structures.2.mass", &floor));
    ck_assert_int_eq(floor, -1);
    ck_assert_ptr_null(thud_scene_param(&scene, "structures.2.mass.7", &floor));
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("scene");
    TCase *tests = tcase_create("scene");
    tcase_add_test(tests, values_read_back_as_set);
    tcase_add_test(tests, what_need_not_be_given_can_be_taken_back);
    tcase_add_test(tests, units_convert_and_lists_are_written_short);
    tcase_add_test(tests, refusals_name_key_and_remedy);
    tcase_add_test(tests, storeys_are_added_and_taken_below_the_top);
    tcase_add_test(tests, a_change_of_kind_or_law_leaves_a_whole_scene);
    tcase_add_test(tests, an_exponent_keeps_the_number_of_its_stiffness);
    tcase_add_test(tests, checks_hold_values_against_each_other);
    tcase_add_test(tests, cases_are_the_scene_with_another_bumper);
    tcase_add_test(tests, unusual_values_are_told);
    tcase_add_test(tests, unusual_combinations_are_told);
    tcase_add_test(tests, a_step_too_long_for_a_contact_is_told);
    tcase_add_test(tests, the_tables_are_whole);
    suite_add_tcase(suite, tests);
    return suite;
}
