/* Whatever a preset can hold is reached from a screen: every key of the schema has a field, or a line of the study. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tui_fixture.h"

static struct fixture f;

static void setup(void)
{
    fixture_open(&f, "towers", 200, 60, true);
    f.tui->run.on = false; /* nothing here is of a result */
}

static void teardown(void)
{
    fixture_close(&f);
}

static bool on_a_screen(const char *path)
{
    for (int i = 0; i < f.tui->form.n; i++)
        if (f.tui->form.field[i].kind == THUD_FIELD_VALUE && strcmp(f.tui->form.field[i].path, path) == 0)
            return true;
    return false;
}

/* Left of every value that is seen there is a blank, a rule or the cursor, and no letter of its label. */
static void labels_stand_apart(void)
{
    enum { CURSOR = 0x25b8, RULE = 0x2500 };
    struct thud_rect rect[THUD_PANES_MAX], area = thud_tui_area(f.tui);
    const int n = thud_tui_view(f.tui)->layout(f.tui, area, rect), screen = (int)f.tui->screen;
    for (int i = 0; i < f.tui->form.n; i++) {
        const struct thud_field *field = &f.tui->form.field[i];
        const bool alone = thud_tui_one_pane(f.tui);
        if (field->kind != THUD_FIELD_VALUE || field->beside || field->pane >= n ||
            (alone && field->pane != f.tui->form.pane[screen]))
            continue;
        const struct thud_rect *at = alone ? &area : &rect[field->pane];
        const int x = at->x + field->x, y = at->y + 1 + field->y - f.tui->form.scroll[screen][field->pane];
        if (field->x > at->w - 3 || y <= at->y || y >= at->y + at->h - 1)
            continue;
        const struct thud_cell *cell = f.tui->canvas.cell + y * f.tui->canvas.width + x;
        ck_assert_msg(cell->glyph == ' ' || cell->glyph == CURSOR || cell->glyph == RULE || cell[1].glyph == ' ',
                      "%s at %dx%d: %c stands before it", field->path, f.tui->canvas.width, f.tui->canvas.height,
                      (int)cell->glyph);
    }
}

static void apart_at_any_size(void)
{
    static const char *const sizes[] = {"<Size 80x24>", "<Size 130x40>", "<Size 100x30>",
                                        "<Size 40x10>", "<Size 60x18>",  "<Size 200x60>"};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        char keys[40];
        for (int screen = 1; screen <= 6; screen++)
            for (int down = 0; down < 2; down++) {
                snprintf(keys, sizeof keys, "%s<A-%d>%s", sizes[i], screen, down ? "<End>" : "<Home>");
                fixture_keys(&f, keys);
                labels_stand_apart();
            }
    }
}

/* Goes to the field as `/` does, and finds the cursor on it. */
static bool has_field(const char *path)
{
    thud_tui_go_to_field(f.tui, path);
    thud_tui_draw(f.tui);
    return on_a_screen(path) && strcmp(thud_form_focus(&f.tui->form)->path, path) == 0;
}

/* Of one group: which keys have had a field so far, in some kind of structure or law. */
struct found {
    bool key[64];
};

static void look_for(enum thud_group group, const char *prefix, struct found *found)
{
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(group, i)); i++) {
        char path[THUD_PATH_MAX];
        snprintf(path, sizeof path, "%s%s", prefix, param->name);
        if (!thud_scene_param(&f.tui->doc.scene, path, &(int){0}))
            continue; /* this kind has it not */
        if (thud_scene_by_floor(&f.tui->doc.scene, path))
            snprintf(path, sizeof path, "%s%s.1", prefix, param->name);
        found->key[i] |= has_field(path);
    }
}

static void expect_all(enum thud_group group, const struct found *found)
{
    const struct thud_param *param;
    for (int i = 0; (param = thud_group_param(group, i)); i++)
        ck_assert_msg(found->key[i], "%s of %s has no field", param->name, thud_group_key(group));
}

static void has_fields(enum thud_group group, const char *prefix)
{
    struct found found = {0};
    look_for(group, prefix, &found);
    expect_all(group, &found);
}

START_TEST(every_key_of_the_schema)
{
    static const struct {
        const char *kind, *then[5];
    } kinds[] = {{"shear", {"foundation.vs=250 m/s", "column.EI=1e3 MN m2", "yield=10 mm", "period=0.5 s"}},
                 {"isolated", {"isolator.law=lead-rubber"}},
                 {"isolated", {"isolator.law=pendulum"}},
                 {"isolated", {"isolator.law=linear"}},
                 {"estimated", {"base=1 m"}},
                 {"matrix k.csv", {NULL}},
                 {"modes modes.csv", {NULL}},
                 {"rigid", {NULL}},
                 {"wall", {"stiffness=100 MN/m", "backfill.stiffness=100 MN/m"}}};
    struct found structure = {0}, nested[THUD_NESTED_GROUPS] = {0};
    fixture_write(&f, "k.csv", "1 (MN/m),2 (MN/m)\n1200,-600\n-600,600\n");
    fixture_write(&f, "modes.csv", "period (s),1,2\n0.4,0.5,1\n0.15,1,-0.5\n");
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        char line[128];
        snprintf(line, sizeof line, ":set structures.1.kind %s<Enter>", kinds[k].kind);
        fixture_keys(&f, line);
        for (int i = 0; kinds[k].then[i]; i++) {
            snprintf(line, sizeof line, ":set structures.1.%s<Enter>", kinds[k].then[i]);
            fixture_keys(&f, line);
        }
        ck_assert_msg(f.tui->said.role != THUD_ROLE_ERROR, "%s: %s", kinds[k].kind, f.tui->said.text);
        apart_at_any_size();
        look_for(THUD_GROUP_STRUCTURE, "structures.1.", &structure);
        for (int i = 0; i < THUD_NESTED_GROUPS; i++) {
            snprintf(line, sizeof line, "structures.1.%s.", thud_group_key(thud_nested_group(i)));
            look_for(thud_nested_group(i), line, &nested[i]);
        }
    }
    expect_all(THUD_GROUP_STRUCTURE, &structure);
    for (int i = 0; i < THUD_NESTED_GROUPS; i++)
        expect_all(thud_nested_group(i), &nested[i]);
    fixture_keys(&f, ":link add 1<Enter>");
    ck_assert(has_field("links.1.source"));
    has_fields(THUD_GROUP_SCENE, "");
    has_fields(THUD_GROUP_RECORD, "record.");
    has_fields(THUD_GROUP_INTERFACE, "interfaces.1.");
    has_fields(THUD_GROUP_CONTACT, "interfaces.1.contact.");
    has_fields(THUD_GROUP_BUMPER, "interfaces.1.bumper.");
    has_fields(THUD_GROUP_ANALYSIS, "analysis.");
    has_fields(THUD_GROUP_DOCUMENT, "document.");
}
END_TEST

/* Soil under a building that stood on rock: one value brings the others. */
START_TEST(soil_on_an_existing_building)
{
    fixture_keys(&f, "/structures.1.foundation.vs<Enter>");
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "structures.1.foundation.vs");
    fixture_keys(&f, "<Enter>200<Enter>");
    ck_assert(thud_structure_on_soil(&f.tui->doc.scene.structure[0]));
    ck_assert_double_eq(f.tui->doc.scene.structure[0].soil_vs_mps, 200);
    fixture_expect(&f, "density");
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui schema");
    TCase *schema = tcase_create("schema");
    tcase_add_checked_fixture(schema, setup, teardown);
    tcase_add_test(schema, every_key_of_the_schema);
    tcase_add_test(schema, soil_on_an_existing_building);
    suite_add_tcase(suite, schema);
    return suite;
}
