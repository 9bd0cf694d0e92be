/* Files: saving with comments kept, other names, changes by others, recovery, opening, quitting. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/run/command.h"
#include "app/run/new_preset.h"
#include "io/file/file.h"
#include "plot/figures/figures_sweep.h"
#include "tui/document/form_over.h"
#include "tui/loop/play.h"
#include "tui/screens/sweep_screen.h"
#include "tui/terminal/config.h"
#include "tui_fixture.h"

static struct fixture f;

static void setup(void)
{
    fixture_open(&f, "towers", 80, 24, true);
}

static void teardown(void)
{
    fixture_close(&f);
}

static const struct thud_scene *scene(void)
{
    return &f.tui->doc.scene;
}

START_TEST(saving_keeps_comments)
{
    fixture_keys(&f, "<A-2><Enter>3.5<Enter>w");
    fixture_expect(&f, "Saved");
    fixture_expect_not(&f, "[+]");
    char *text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "- gap: 3.5 cm   # concrete to concrete"));
    ck_assert_ptr_nonnull(strstr(text, "file: pulse.csv    # a sine"));
    ck_assert_ptr_nonnull(strstr(text, "# two towers, for tests"));
    free(text);
    fixture_keys(&f, "w");
    fixture_expect(&f, "Nothing to save");
}
END_TEST

START_TEST(saving_under_another_name)
{
    char keys[256];
    snprintf(keys, sizeof keys, "<A-2><Enter>4<Enter>W<C-u>%s/other<Enter>", f.folder);
    fixture_keys(&f, keys);
    fixture_expect(&f, "thud  other");
    char *text = fixture_file(&f, "other.yaml"), *old = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "- gap: 4 cm"));
    ck_assert_str_eq(old, fixture_towers);
    free(text);
    free(old);
    snprintf(keys, sizeof keys, "W%s/towers<Enter>", f.folder);
    fixture_keys(&f, keys);
    fixture_expect(&f, "exists. Write over it?");
    fixture_keys(&f, "n");
    old = fixture_file(&f, "towers.yaml");
    ck_assert_str_eq(old, fixture_towers);
    free(old);
}
END_TEST

START_TEST(a_file_changed_by_others_is_asked_about)
{
    fixture_keys(&f, "<A-2><Enter>4<Enter>");
    fixture_write(&f, "towers.yaml", "# someone else's\n");
    fixture_keys(&f, "w");
    fixture_expect(&f, "changed by someone else");
    fixture_keys(&f, "<Esc>");
    char *text = fixture_file(&f, "towers.yaml");
    ck_assert_str_eq(text, "# someone else's\n");
    free(text);
    fixture_keys(&f, "wy");
    fixture_expect(&f, "Saved");
    text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "- gap: 4 cm"));
    free(text);
}
END_TEST

START_TEST(a_full_disk_loses_nothing)
{
    fixture_keys(&f, "<A-2><Enter>4<Enter>W<C-u>/dev/full/x.yaml<Enter>");
    fixture_expect(&f, " ! ");
    fixture_expect(&f, "towers [+]");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.04, 1e-15);
}
END_TEST

/* The tables of `thud run --csv` and `-o`, of the case that is shown. */
START_TEST(results_as_csv)
{
    fixture_keys(&f, "<A-4>e");
    fixture_expect(&f, "Written towers-peaks-bumper-gap-20mm.csv");
    const struct thud_result *result = thud_live_result(&f.tui->run.live, THUD_LIVE_BUMPER);
    char *peaks = fixture_file(&f, "towers-peaks-bumper-gap-20mm.csv"),
         *impacts = fixture_file(&f, "towers-impacts-bumper-gap-20mm.csv");
    double acceleration = 0.0;
    int lines = 0, count;
    ck_assert_ptr_nonnull(peaks);
    ck_assert_ptr_nonnull(impacts);
    ck_assert_int_eq(sscanf(strchr(peaks, '\n'), "\nA,1,%lf", &acceleration), 1);
    ck_assert_double_eq(acceleration, result->structure[0].floor[0].acceleration.value);
    for (const char *at = impacts; (at = strchr(at, '\n')) != NULL; at++)
        lines++;
    thud_run_impacts(f.tui->run.live.which[THUD_LIVE_BUMPER].run, &count);
    ck_assert_int_eq(lines, count + 1);
    free(peaks);
    free(impacts);
    fixture_write(&f, "towers-impact-force-gap-20mm.csv", "mine\n"); /* a name that somebody else's file has */
    fixture_keys(&f, "5");
    fixture_keys(&f, "e");
    fixture_expect(&f, "towers-impact-force-gap-20mm-2.csv");
    fixture_keys(&f, "e");
    fixture_expect(&f, "towers-impact-force-gap-20mm-2.csv"); /* thud's own is written anew */
    char *others = fixture_file(&f, "towers-impact-force-gap-20mm.csv");
    ck_assert_str_eq(others, "mine\n");
    free(others);
    char keys[200];
    snprintf(keys, sizeof keys, ":folder %s/shipped<Enter>e:folder %s<Enter>4", f.folder, f.folder);
    fixture_keys(&f, keys);
    others = fixture_file(&f, "shipped/towers-impact-force-gap-20mm.csv");
    ck_assert_ptr_nonnull(others);
    free(others);
    fixture_take_record(&f);
    fixture_keys(&f, "e");
    fixture_expect(&f, "There are no results");
}
END_TEST

START_TEST(quitting_asks_only_when_unsaved)
{
    fixture_keys(&f, "<A-2><Enter>4<Enter>q");
    ck_assert(!f.tui->end.quit);
    fixture_expect(&f, "unsaved changes");
    fixture_keys(&f, "nuq");
    ck_assert(f.tui->end.quit);
}
END_TEST

START_TEST(unsaved_edits_can_be_recovered)
{
    struct thud_error err;
    fixture_keys(&f, "<A-2><Enter>7<Enter>");
    ck_assert_int_eq(thud_doc_recover(&f.tui->doc, &err), THUD_OK);
    char *text = fixture_file(&f, "towers.yaml.recovered"), *old = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "- gap: 7 cm   # concrete to concrete"));
    ck_assert_str_eq(old, fixture_towers);
    free(text);
    free(old);
    /* where the preset's folder cannot be written, in that for temporary files */
    ck_assert_int_eq(setenv("TMPDIR", f.folder, 1), 0);
    f.tui->doc.kept[0] = '\0';
    snprintf(f.tui->doc.path, sizeof f.tui->doc.path, "%s/towers.yaml/towers.yaml", f.folder);
    ck_assert_int_eq(thud_doc_recover(&f.tui->doc, &err), THUD_OK);
    ck_assert_ptr_eq(strstr(f.tui->doc.kept, f.folder), f.tui->doc.kept);
    text = fixture_file(&f, strrchr(f.tui->doc.kept, '/') + 1);
    ck_assert_ptr_nonnull(strstr(text, "- gap: 7 cm   # concrete to concrete"));
    free(text);
    unsetenv("TMPDIR");
}
END_TEST

START_TEST(opening_another_preset)
{
    fixture_keys(&f, "obodies<Enter>");
    fixture_expect(&f, "thud  bodies");
    fixture_keys(&f, "<A-2><Enter>1<Enter>o<C-u>towers<Enter>");
    fixture_expect(&f, "unsaved changes");
    fixture_keys(&f, "y");
    fixture_expect(&f, "thud  towers");
    ck_assert_int_eq(f.tui->doc.undo.count, 0);
    fixture_keys(&f, ":open nosuch<Enter>");
    fixture_expect(&f, " ! ");
    fixture_expect(&f, "thud  towers");
}
END_TEST

/* Nobody may ever write into a pipe: it is not waited for. */
START_TEST(a_pipe_is_no_ground_motion)
{
    char path[256];
    fixture_take_record(&f);
    snprintf(path, sizeof path, "%s/pulse.csv", f.folder);
    ck_assert_int_eq(mkfifo(path, 0600), 0);
    fixture_keys(&f, ":open towers<Enter>");
    fixture_keys(&f, "y");
    fixture_expect(&f, "is a pipe, not a file");
    ck_assert_int_eq(remove(path), 0);
    fixture_write_pulse(&f);
    fixture_keys(&f, ":open towers<Enter>");
    fixture_expect_not(&f, "is a pipe");
}
END_TEST

START_TEST(shipped_presets_stay_as_they_are)
{
    char keys[400];
    char *before = fixture_file(&f, "shipped/bodies.yaml");
    fixture_keys(&f, ":open bodies<Enter>");
    fixture_keys(&f, ":set gap 3 cm<Enter>w");
    fixture_expect(&f, "a name for yours");
    fixture_expect(&f, "my-bodies.yaml");
    snprintf(keys, sizeof keys, "%s/shipped/other<Enter>", f.folder); /* nor is anything put beside them */
    fixture_keys(&f, keys);
    fixture_expect(&f, "a name for yours");
    ck_assert_ptr_null(fixture_file(&f, "shipped/other.yaml"));
    snprintf(keys, sizeof keys, "%s/mine<Enter>", f.folder); /* what is typed replaces the name */
    fixture_keys(&f, keys);
    fixture_expect(&f, "Saved");
    fixture_expect(&f, "thud  mine");
    char *after = fixture_file(&f, "shipped/bodies.yaml"), *mine = fixture_file(&f, "mine.yaml");
    ck_assert_str_eq(before, after);
    ck_assert_ptr_nonnull(strstr(mine, "gap: 3 cm"));
    fixture_keys(&f, ":set gap 4 cm<Enter>w"); /* that one is */
    fixture_expect(&f, "Saved");
    free(before);
    free(after);
    free(mine);
}
END_TEST

START_TEST(unsaved_changes_can_be_saved_on_the_way_out)
{
    fixture_keys(&f, ":set gap 4 cm<Enter>:open bodies<Enter>");
    fixture_expect(&f, "s save  y lose  Esc stay");
    fixture_keys(&f, "s");
    fixture_expect(&f, "thud  bodies");
    char *text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "- gap: 4 cm"));
    free(text);
    char keys[300];
    snprintf(keys, sizeof keys, ":open %s/towers.yaml<Enter>:set gap 5 cm<Enter><C-c>", f.folder);
    fixture_keys(&f, keys);
    fixture_expect(&f, "s save  y lose  Esc stay");
    fixture_keys(&f, "<Esc>");
    ck_assert(!f.tui->end.quit);
    fixture_keys(&f, "qs");
    ck_assert(f.tui->end.quit);
    text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "- gap: 5 cm"));
    free(text);
}
END_TEST

/* After every edit, so that a crash loses none; the file goes when they are saved or undone. */
START_TEST(edits_are_kept_as_they_are_made)
{
    static const char kept[] = "towers.yaml.recovered";
    f.tui->end.keeps = true;
    fixture_keys(&f, "");
    ck_assert_ptr_null(fixture_file(&f, kept));
    for (int i = 0; i < 3; i++) {
        fixture_keys(&f, ":set gap 7 cm<Enter>");
        char *text = fixture_file(&f, kept);
        ck_assert_ptr_nonnull(strstr(text, "gap: 7 cm   # concrete"));
        free(text);
        fixture_keys(&f, i == 0 ? "u" : i == 1 ? ":set gap 2 cm<Enter>" : "w");
        ck_assert_ptr_null(fixture_file(&f, kept));
    }
    fixture_write(&f, kept, "of another session\n"); /* stays */
    ck_assert_int_eq(setenv("TMPDIR", f.folder, 1), 0);
    fixture_keys(&f, ":set gap 8 cm<Enter>");
    char *text = fixture_file(&f, kept);
    ck_assert_str_eq(text, "of another session\n");
    free(text);
    ck_assert_ptr_nonnull(strstr(f.tui->doc.kept, "/towers-"));
    text = fixture_file(&f, strrchr(f.tui->doc.kept, '/') + 1);
    ck_assert_ptr_nonnull(strstr(text, "gap: 8 cm"));
    free(text);
    /* where nothing can be written that is said */
    thud_doc_forget_kept(&f.tui->doc);
    ck_assert_int_eq(setenv("TMPDIR", "/nowhere", 1), 0);
    fixture_keys(&f, ":set gap 9 cm<Enter>");
    fixture_expect(&f, "Unsaved changes cannot be kept");
    unsetenv("TMPDIR");
}
END_TEST

START_TEST(kept_changes_are_offered_at_the_start)
{
    struct thud_error err;
    char name[128];
    fixture_keys(&f, ":set gap 7 cm<Enter>");
    ck_assert_int_eq(thud_doc_recover(&f.tui->doc, &err), THUD_OK);
    thud_tui_free(f.tui);
    snprintf(name, sizeof name, "%s/towers.yaml", f.folder);
    struct thud_tui_options options = {.preset = name, .paths = &f.paths, .output = f.folder};
    ck_assert_int_eq(thud_tui_create(&options, &f.backend, &f.tui, &err), THUD_OK);
    fixture_keys(&f, "");
    fixture_expect(&f, "Unsaved changes were kept in");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.02, 1e-15);
    fixture_keys(&f, "y");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.07, 1e-15);
    fixture_expect(&f, "towers [+]");
    fixture_keys(&f, "w");
    fixture_expect(&f, "Saved");
    ck_assert_ptr_null(fixture_file(&f, "towers.yaml.recovered"));
}
END_TEST

START_TEST(commands_are_completed_and_remembered)
{
    fixture_keys(&f, ":rec<Tab>");
    fixture_expect(&f, "record  records");
    ck_assert_str_eq(f.tui->dialog.line.text, "record");
    fixture_keys(&f, "<Esc>:set structures.2.na<Tab>");
    ck_assert_str_eq(f.tui->dialog.line.text, "set structures.2.name ");
    fixture_keys(&f, "North<Enter>");
    ck_assert_str_eq(scene()->structure[1].name, "North");
    fixture_keys(&f, "<Esc>:record pul<Tab>");
    ck_assert_str_eq(f.tui->dialog.line.text, "record pulse.csv");
    fixture_keys(&f, "<Esc>:zz<Tab>");
    fixture_expect(&f, "nothing begins with");
    fixture_keys(&f, "<Esc>:title Five and seven<Enter>:<Up><Up>");
    ck_assert_str_eq(f.tui->dialog.line.text, "set structures.2.name North");
    fixture_keys(&f, "<Down>");
    ck_assert_str_eq(f.tui->dialog.line.text, "title Five and seven");
    fixture_keys(&f, "<Down>");
    ck_assert_str_eq(f.tui->dialog.line.text, "");
    ck_assert_str_eq(scene()->title, "Five and seven");
    fixture_keys(&f, "<Esc>4");
    fixture_expect(&f, "Five and seven");
}
END_TEST

/* From nothing: the first period that was asked for is that of the assembled model; a right value not typed is the left
 * one's; what has no unit has the shown one. */
START_TEST(a_scene_from_nothing)
{
    char record[128];
    const struct thud_scene *scene = &f.tui->doc.scene;
    snprintf(record, sizeof record, "%s/pul", f.folder);
    fixture_keys(&f, "n");
    fixture_expect(&f, "New scene");
    fixture_keys(&f, "5<Tab>7<Tab>300<Tab><Tab>0.5 s<Tab>0.7 s<Down><Down><Down>8<Down>");
    fixture_keys(&f, record);
    fixture_expect(&f, "pulse.csv");
    fixture_expect(&f, "1.000g 0.01s 3s");
    fixture_keys(&f, "<Enter>");
    ck_assert_int_eq(f.tui->dialog.mode, THUD_MODE_NORMAL);
    ck_assert_int_eq((int)f.tui->screen, THUD_SCREEN_MODEL);
    ck_assert_int_eq(scene->structure[0].storeys, 5);
    ck_assert_int_eq(scene->structure[1].storeys, 7);
    ck_assert_double_eq_tol(scene->structure[1].mass_kg[6], 300e3, 1e-6);
    ck_assert_double_eq_tol(scene->interface[0].gap_m, 0.08, 1e-15);
    const struct thud_model *model = thud_tui_model(f.tui);
    for (int i = 0; i < 2; i++)
        ck_assert_double_eq_tol(2 * THUD_PI / model->structure[i].omega[0], i ? 0.7 : 0.5, 1e-9);
    ck_assert_double_eq_tol(thud_record_peak(f.tui->doc.record), THUD_GRAVITY, 1e-3); /* as recorded */
    fixture_expect(&f, "buildings [+]");
    fixture_expect(&f, " at 8 cm");
    fixture_keys(&f, "n"); /* what is unsaved is asked about */
    fixture_expect(&f, "has unsaved changes");
    fixture_keys(&f, "<Esc>");
    ck_assert_int_eq(f.tui->dialog.mode, THUD_MODE_NORMAL);
}
END_TEST

/* What cannot be stays in the form, with the reason. */
START_TEST(a_new_scene_is_refused)
{
    fixture_keys(&f, "n300<Enter>");
    fixture_expect(&f, "storeys");
    ck_assert_int_eq(f.tui->dialog.mode, THUD_MODE_OVER);
    fixture_keys(&f, "5<Tab>7<Tab>3 kN<Enter>");
    fixture_expect(&f, "is a force");
    fixture_keys(&f, "<C-u>3 t<Down><Down><Down><Down><Down>nowhere.csv<Enter>");
    fixture_expect(&f, "nowhere.csv");
    ck_assert_int_eq(f.tui->dialog.mode, THUD_MODE_OVER);
    fixture_keys(&f, "<Esc>");
    ck_assert_str_eq(f.tui->doc.scene.name, "towers");
    fixture_expect(&f, "POUNDS at 2 cm");
}
END_TEST

/* A kind that is typed is taken, letter by letter; what is none of them is said, and each building has its own. */
START_TEST(kinds_are_typed)
{
    fixture_keys(&f, "n<Up>isolated");
    fixture_expect(&f, "isolated");
    struct thud_form_over *form = f.tui->dialog.own;
    ck_assert_str_eq(form->row[THUD_NEW_KIND].value[0].text, "isolated");
    ck_assert_str_eq(form->row[THUD_NEW_KIND].value[1].text, "shear");
    fixture_keys(&f, "x");
    fixture_expect(&f, "none begins with \"isolatedx\"");
    ck_assert_str_eq(form->row[THUD_NEW_KIND].value[0].text, "isolated");
    fixture_keys(&f, "<Tab> ");
    ck_assert_str_eq(form->row[THUD_NEW_KIND].value[0].text, "isolated");
    ck_assert_str_ne(form->row[THUD_NEW_KIND].value[1].text, "shear");
    fixture_keys(&f, "<Esc>");
}
END_TEST

/* As `thud new` takes them when the field is left: the right value goes with the left one, a kind has its usual
 * stiffness, "no" is none. A blank does not take away what is selected. */
START_TEST(answers_are_those_of_the_command)
{
    fixture_keys(&f, "n ");
    struct thud_form_over *form = f.tui->dialog.own;
    ck_assert_str_eq(form->row[THUD_NEW_STOREYS].value[0].text, "4");
    fixture_keys(&f, "<Down>300 t<Tab>");
    ck_assert_str_eq(form->row[THUD_NEW_MASS].value[1].text, "300 t");
    fixture_keys(&f, "<Up><Up>estimated<Down>");
    ck_assert_str_eq(form->row[THUD_NEW_STIFFNESS].value[0].text, "600 MN/m");
    ck_assert_str_eq(form->row[THUD_NEW_STIFFNESS].value[1].text, "concrete-frame");
    fixture_keys(&f, "<Up>shear<Down>");
    ck_assert_str_eq(form->row[THUD_NEW_STIFFNESS].value[1].text, "600 MN/m");
    while (form->at != THUD_NEW_SOIL)
        fixture_keys(&f, "<Down>");
    fixture_keys(&f, "no<Down>");
    ck_assert_str_eq(form->row[THUD_NEW_SOIL].value[0].text, "");
    fixture_keys(&f, "<Esc>");
}
END_TEST

/* Goal and range are asked for in fields of their own. */
START_TEST(solving_has_a_form)
{
    fixture_keys(&f, "2G");
    fixture_expect(&f, "has to hold");
    fixture_keys(&f, "no pounding<Tab>1 cm<Tab>30 cm<Enter>");
    fixture_expect(&f, "no pounding holds from interfaces.1.gap");
    fixture_keys(&f, "<Enter>");
    ck_assert_double_gt(f.tui->doc.scene.interface[0].gap_m, 0.1);
}
END_TEST

/* A wall and a rigid body have no storeys: Tab passes over what they have not. */
START_TEST(other_kinds_from_nothing)
{
    fixture_keys(&f, "n<Up>rig<Tab>wal<Tab>");
    ck_assert_int_eq(f.tui->dialog.mode, THUD_MODE_OVER);
    fixture_keys(&f, "40<Enter>");
    ck_assert_int_eq(f.tui->doc.scene.structure[0].kind, THUD_RIGID);
    ck_assert_int_eq(f.tui->doc.scene.structure[1].kind, THUD_WALL);
    ck_assert_double_eq_tol(f.tui->doc.scene.structure[0].mass_kg[0], 40e3, 1e-9);
}
END_TEST

/* Files with what is in them; folders are gone into. */
START_TEST(files_are_browsed)
{
    fixture_keys(&f, "<A-3><Size 130x40>");
    fixture_expect(&f, "pulse.csv");
    fixture_expect(&f, "1.000g 0.01s 3s");
    char words[200];
    snprintf(words, sizeof words, "record %s/", "shipped");
    struct thud_browse files = {0};
    thud_browse_list(&files, THUD_BROWSE_PRESETS, &f.paths, f.tui->doc.path, "");
    int towers = -1;
    for (int i = 0; i < files.n; i++)
        towers = strcmp(files.item[i].name, "towers") == 0 ? i : towers;
    ck_assert_int_ge(towers, 0);
    ck_assert_str_eq(thud_browse_about(&files, towers), "2+3  2 cm  pulse.csv");
    snprintf(words, sizeof words, "%s/", f.folder);
    thud_browse_list(&files, THUD_BROWSE_PRESETS, &f.paths, f.tui->doc.path, words);
    int own = 0, folders = 0;
    for (int i = 0; i < files.n; i++) {
        own += strcmp(thud_path_name(files.item[i].name), "bodies.yaml") == 0;
        folders += files.item[i].folder;
    }
    ck_assert_int_eq(own, 1);
    ck_assert_int_eq(folders, 2); /* up, and `shipped` */
    thud_browse_clear(&files);
    fixture_keys(&f, "obodies<Enter>");
    fixture_expect(&f, "Opened");
    ck_assert_str_eq(f.tui->doc.scene.name, "bodies");
}
END_TEST

/* What was done by keys is kept as commands, which do the same again from the beginning. */
START_TEST(a_session_is_played_again)
{
    static struct thud_scene by_keys;
    struct thud_text out = {0};
    struct thud_error err = {0};
    char line[200], path[100], text[700];
    f.script.paste = "310\n290\n";
    fixture_keys(&f, "<A-2><Enter>3.5<Enter><Down>+u<A-1>a:title Tried<Enter>=/structures.1.mass.2<Enter><Paste>");
    fixture_keys(&f, "xv:vary gap=1 cm:2 cm:1 cm; contact.restitution=0.5,0.6<Enter><A-2>B<A-1>V");
    fixture_keys(&f, "<A-4>e");
    by_keys = f.tui->doc.scene;
    snprintf(path, sizeof path, "%s/tried.thud", f.folder);
    snprintf(line, sizeof line, ":log %s<Enter>", path);
    fixture_keys(&f, line);
    fixture_expect(&f, "repeats it");
    enum thud_status status = thud_tui_play_lines(f.tui, path, &out, &err);
    ck_assert_msg(status == THUD_OK, "%s\n%s", thud_error_text(&err, text, sizeof text), out.data);
    ck_assert_mem_eq(&f.tui->doc.scene, &by_keys, sizeof by_keys);
    ck_assert_str_eq(f.tui->doc.scene.title, "Tried");
    ck_assert_ptr_nonnull(strstr(out.data, "\n> set "));
    ck_assert_ptr_nonnull(strstr(out.data, "POUNDS at "));
    thud_text_clear(&out);
    fixture_write(&f, "notes.txt", "mine\n"); /* what is no session is not written over */
    snprintf(line, sizeof line, ":log %s/notes.txt<Enter>", f.folder);
    fixture_keys(&f, line);
    fixture_expect(&f, "is no session");
    fixture_keys(&f, ":log<Enter>");
    fixture_expect(&f, "What was done");
    fixture_expect(&f, "title Tried");
    fixture_keys(&f, "<Enter>");
    ck_assert_int_eq(f.tui->dialog.mode, THUD_MODE_NORMAL);
}
END_TEST

/* A key that is held is one change, in the log as well, and another key begins the next one. */
START_TEST(a_held_key_is_one_change)
{
    const double *gap_m = &f.tui->doc.scene.interface[0].gap_m;
    struct thud_text out = {0};
    struct thud_error err = {0};
    char path[100], line[200];
    fixture_keys(&f, ":set gap 4 cm<Enter><A-2>");
    const int before = f.tui->doc.undo.count;
    fixture_keys(&f, "((");
    ck_assert_double_eq_tol(*gap_m, 0.038, 1e-12);
    fixture_keys(&f, ")");
    ck_assert_double_eq_tol(*gap_m, 0.039, 1e-12);
    ck_assert_int_eq(f.tui->doc.undo.count, before + 2);
    fixture_keys(&f, "u");
    ck_assert_double_eq_tol(*gap_m, 0.038, 1e-12);
    fixture_keys(&f, "((u((");
    snprintf(path, sizeof path, "%s/held.thud", f.folder);
    snprintf(line, sizeof line, ":log %s<Enter>", path);
    fixture_keys(&f, line);
    fixture_keys(&f, "u"); /* both at once, not one of them */
    ck_assert_double_eq_tol(*gap_m, 0.038, 1e-12);
    fixture_keys(&f, ":set gap 9 cm<Enter>");
    ck_assert_int_eq(thud_tui_play_lines(f.tui, path, &out, &err), THUD_OK);
    ck_assert_double_eq_tol(*gap_m, 0.036, 1e-12);
    thud_text_clear(&out);
}
END_TEST

/* The list of what was done and said has one line of a held key, with the last value and what was said of that. */
START_TEST(a_held_key_is_one_line_of_the_list)
{
    static const char *const lines[] = {":set gap 4 cm\n", ":set interfaces.1.gap 3.7 cm\n", ":set gap 7 cm\n",
                                        ":set structures.1.mass.1 8.7 t\n", "! mass 8.7 t is unusual"};
    fixture_keys(&f, ":set gap 4 cm<Enter><A-2>(((:set gap 7 cm<Enter>");
    fixture_keys(&f, ":structures.1.mass.1 9 t<Enter>/structures.1.mass.1<Enter>---");
    const char *at = f.tui->messages.data;
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        const char *found = strstr(at, lines[i]);
        ck_assert_msg(found != NULL, "%s in\n%s", lines[i], f.tui->messages.data);
        at = found + strlen(lines[i]);
    }
    ck_assert_ptr_null(strstr(f.tui->messages.data, "3.8 cm"));
    ck_assert_ptr_null(strstr(f.tui->messages.data, "8.9 t"));
    fixture_keys(&f, "<C-o>");
    fixture_expect(&f, ":set interfaces.1.gap 3.7 cm");
}
END_TEST

/* Lines of a session are as long as what they say: pasted storeys, which a terminal ends with CR, and a list of
 * values. */
START_TEST(long_lines_are_played_again)
{
    enum { STOREYS = 120 };
    const struct thud_structure *a = &f.tui->doc.scene.structure[0];
    struct thud_text rows = {0}, list = {0}, out = {0};
    struct thud_error err = {0};
    char path[100], line[200], text[700];
    for (int i = 0; i < STOREYS; i++)
        thud_text_append(&rows, "%d t\t%d\r", 300 + i, 1000 + i);
    fixture_keys(&f, ":structures.1.storeys 120<Enter>/structures.1.mass.120<Enter>");
    f.script.paste = rows.data;
    fixture_keys(&f, "<Paste>");
    fixture_expect(&f, "240 pasted values taken");
    ck_assert_double_eq_tol(a->mass_kg[0], 419e3, 1e-6);
    snprintf(path, sizeof path, "%s/long.thud", f.folder);
    snprintf(line, sizeof line, ":log %s<Enter>", path);
    fixture_keys(&f, line);
    fixture_keys(&f, "u");
    ck_assert_double_eq_tol(a->mass_kg[0], a->mass_kg[1], 1e-6);
    enum thud_status status = thud_tui_play_lines(f.tui, path, &out, &err);
    ck_assert_msg(status == THUD_OK, "%s", thud_error_text(&err, text, sizeof text));
    for (int i = 0; i < STOREYS; i++) {
        ck_assert_double_eq_tol(a->mass_kg[STOREYS - 1 - i], 1e3 * (300 + i), 1e-6);
        ck_assert_double_eq_tol(a->stiffness_npm[STOREYS - 1 - i], 1e6 * (1000 + i), 1e-3);
    }
    thud_text_append(&list, "open towers\nset structures.1.storeys %d\nset structures.1.mass [", STOREYS);
    for (int i = 0; i < STOREYS; i++)
        thud_text_append(&list, "%s%d t", i > 0 ? ", " : "", 200 + i);
    thud_text_append(&list, "]\n");
    fixture_write(&f, "list.thud", list.data);
    snprintf(path, sizeof path, "%s/list.thud", f.folder);
    status = thud_tui_play_lines(f.tui, path, &out, &err);
    ck_assert_msg(status == THUD_OK, "%s", thud_error_text(&err, text, sizeof text));
    ck_assert_double_eq_tol(a->mass_kg[STOREYS - 1], 1e3 * (199 + STOREYS), 1e-6);
    thud_text_clear(&rows);
    thud_text_clear(&list);
    thud_text_clear(&out);
}
END_TEST

/* Words that were said give way when there are many; commands stay. */
START_TEST(commands_outlast_what_was_said)
{
    char line[200];
    fixture_keys(&f, ":set gap 4 cm<Enter>");
    for (int i = 0; i < 4000; i++)
        thud_tui_keep_message(f.tui, "", "a message of forty bytes, more or less .");
    ck_assert_uint_lt(f.tui->messages.size, 1 << 17);
    fixture_keys(&f, ":set gap 5 cm<Enter>");
    snprintf(line, sizeof line, ":log %s/kept.thud<Enter>", f.folder);
    fixture_keys(&f, line);
    char *log = fixture_file(&f, "kept.thud");
    ck_assert_ptr_nonnull(strstr(log, "\nset gap 4 cm\nset gap 5 cm\n"));
    ck_assert_ptr_null(strstr(log, "forty"));
    free(log);
}
END_TEST

/* What is longer than its place is refused, never shortened to something else. */
START_TEST(what_has_no_room_is_refused)
{
    static const char *const refused[] = {"folder", "write", "vary gap=", "report -o"};
    struct thud_text out = {0};
    struct thud_error err = {0};
    char path[100];
    snprintf(path, sizeof path, "%s/much.thud", f.folder);
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        struct thud_text line = {0};
        thud_text_append(&line, "%s ", refused[i]);
        for (int j = 0; j < 300; j++)
            thud_text_append(&line, "%s%d%s", i < 2 ? "ab" : i > 2 ? "a -o " : "", j, i == 2 ? " cm," : "");
        fixture_write(&f, "much.thud", line.data);
        ck_assert_msg(thud_tui_play_lines(f.tui, path, &out, &err) == THUD_INPUT, "%s", refused[i]);
        ck_assert_msg(strstr(err.what, i < 3 ? "too long" : "fewer than") != NULL, "%s", err.what);
        thud_text_clear(&line);
    }
    thud_text_clear(&out);
}
END_TEST

/* Varied keys that change their places at once do so again where the session is played. */
START_TEST(swapped_keys_of_a_study_are_played_again)
{
    const struct thud_study_choice *study = &f.tui->doc.scene.study;
    struct thud_text out = {0};
    struct thud_error err = {0};
    char path[100], line[200];
    fixture_keys(&f, "<A-6><Enter>gap=1 cm:2 cm:1 cm<Tab>contact.restitution=0.5:0.6:0.1<Enter>");
    fixture_keys(&f, "<Enter>contact.restitution=0.5:0.6:0.1<Tab>gap=1 cm:2 cm:1 cm<Enter>");
    ck_assert_str_eq(study->vary[0].key, "contact.restitution");
    snprintf(path, sizeof path, "%s/swapped.thud", f.folder);
    snprintf(line, sizeof line, ":log %s<Enter>:vary gap=3 cm:4 cm:1 cm<Enter>", path);
    fixture_keys(&f, line);
    ck_assert_int_eq(study->nvary, 1);
    ck_assert_msg(thud_tui_play_lines(f.tui, path, &out, &err) == THUD_OK, "%s", err.what);
    ck_assert_int_eq(study->nvary, 2);
    ck_assert_str_eq(study->vary[0].key, "contact.restitution");
    ck_assert_str_eq(study->vary[1].key, "gap");
    thud_text_clear(&out);
}
END_TEST

/* A refused command ends it, with its line. */
START_TEST(a_session_stops_where_it_cannot)
{
    struct thud_text out = {0};
    struct thud_error err = {0};
    char path[100];
    fixture_write(&f, "wrong.thud", "# one\nset gap 3 cm\nset gap 3 kN\nset gap 4 cm\n");
    snprintf(path, sizeof path, "%s/wrong.thud", f.folder);
    ck_assert_int_eq(thud_tui_play_lines(f.tui, path, &out, &err), THUD_INPUT);
    ck_assert_int_eq(err.line, 3);
    ck_assert_ptr_nonnull(strstr(err.what, "is a force"));
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.03, 1e-15);
    thud_text_clear(&out);
}
END_TEST

START_TEST(a_new_scene_as_a_command)
{
    fixture_keys(&f, ":new storeys: 5, 7; mass: 300; stiffness: 0.5 s, 0.7 s; gap: 8; name: mine<Enter>");
    ck_assert_str_eq(f.tui->doc.scene.name, "mine");
    ck_assert_int_eq(f.tui->doc.scene.structure[1].storeys, 7);
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.08, 1e-15);
    fixture_keys(&f, ":new size: 5<Enter>");
    fixture_expect(&f, "unsaved changes");
}
END_TEST

/* Keys of a script: a name in angle brackets is one. */
static int count_keys(const char *keys)
{
    int n = 0;
    for (; *keys; keys++, n++)
        if (*keys == '<')
            keys = strchr(keys, '>');
    return n;
}

/* Two buildings of one's own, their roofs lighter, on one's own ground motion, at one's own gap: the result, the
 * figures, the file, and all of it there again. 178 keys before there was a form, a list of files and a step back to
 * what was saved; half of that is the least that was asked for. */
START_TEST(the_walk_of_an_engineer)
{
    static const char *const walk[] = {
        "n5<Tab>7<Tab>300<Tab><Tab>500MN/m<Tab>550MN/m<Down><Down><Down>8<Down>pul<Enter>",
        "<Down><Down><Enter>250<Enter>", /* the roof of the left one */
        "<Tab><Down><Down><Enter>260<Enter>",
        "P",
        "w",
        "obuil<Enter>"};
    const struct thud_scene *now = &f.tui->doc.scene;
    static struct thud_scene made;
    int keys = 0;
    f.tui->options.gnuplot = "/nowhere/gnuplot"; /* scripts and numbers are written all the same */
    ck_assert_int_eq(chdir(f.folder), 0);
    for (size_t i = 0; i < sizeof walk / sizeof *walk; i++) {
        fixture_keys(&f, walk[i]);
        keys += count_keys(walk[i]);
        if (i == 2) {
            ck_assert_double_eq_tol(now->structure[0].mass_kg[4], 250e3, 1e-6);
            ck_assert_double_eq_tol(now->structure[0].mass_kg[3], 300e3, 1e-6);
            ck_assert_double_eq_tol(now->structure[1].mass_kg[6], 260e3, 1e-6);
            ck_assert_double_eq_tol(now->structure[1].stiffness_npm[0], 550e6, 1e-3);
            fixture_expect(&f, " at 8 cm"); /* the result */
            fixture_expect(&f, "needs ");
            made = *now;
        }
    }
    fixture_expect(&f, "Opened ");
    ck_assert_mem_eq(&now->structure, &made.structure, sizeof made.structure);
    ck_assert_mem_eq(&now->interface, &made.interface, sizeof made.interface);
    ck_assert_str_eq(now->record.file, "pulse.csv");
    ck_assert_ptr_nonnull(strstr(f.tui->files.wrote[0].stem, "/buildings-")); /* figures, by the scene's name */
    printf("# the walk takes %d keys\n", keys);
    ck_assert_int_le(keys, 178 / 2);
}
END_TEST

/* Two buildings of one's own, a suite of two motions, three designs: another gap and a bumper, fragility over the
 * suite, and the report of what is on the screen, with the others beside it. */
START_TEST(the_walk_to_a_report)
{
    static const char *const walk[] = {
        "n5<Tab>7<Down><Tab>500MN/m<Tab>550MN/m<Down><Down><Down>3<Down>pul<Enter>", /* two buildings */
        "3<Home><Down> <Down> ",                                                     /* the suite */
        "w2<Home><Enter>5<Enter>",                                                   /* saved; another gap */
        "B",                                                                         /* a bumper */
        "6r",                                                                        /* the suite at every gap */
        "c",
        "U   wR<Enter>", /* the designs marked, and the report */
    };
    char program[200];
    int keys = 0;
    f.tui->options.gnuplot = "/nowhere/gnuplot";
    ck_assert_int_eq(chdir(f.folder), 0);
    fixture_write(&f, "another.csv", "time_s,acceleration_g\n0,0\n0.1,0.2\n0.2,-0.3\n0.3,0.1\n0.4,0\n");
    fixture_program(&f, program, sizeof program, "printf '[%s]' \"$@\" >said; : >report.html; echo report.html");
    for (size_t i = 0; i < sizeof walk / sizeof *walk; i++) {
        fixture_keys(&f, walk[i]);
        keys += count_keys(walk[i]);
        if (i == 1)
            ck_assert_str_eq(f.tui->doc.scene.study.records, "another.csv,pulse.csv");
        if (i == 2)
            ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.05, 1e-12);
        if (i == 4)
            fixture_expect(&f, "2 ground motions");
    }
    char *first = fixture_file(&f, "buildings-1.yaml"), *wide = fixture_file(&f, "buildings-2.yaml");
    ck_assert_ptr_nonnull(first);
    ck_assert_ptr_nonnull(wide);
    ck_assert_ptr_nonnull(strstr(first, "gap: 3 cm"));
    ck_assert_ptr_nonnull(strstr(wide, "gap: 5 cm"));
    free(first);
    free(wide);
    ck_assert_int_gt(
        thud_live_study_figures(&thud_sweep_state(f.tui)->data),
        thud_sweep_figure_count(&thud_sweep_state(f.tui)->data.out.rows.table)); /* its fragility is there */
    fixture_expect(&f, "Written report.html");
    char *said = fixture_file(&f, "said");
    ck_assert_ptr_nonnull(said);
    ck_assert_ptr_nonnull(strstr(said, "[report][buildings.yaml]"));
    ck_assert_ptr_nonnull(strstr(said, "[--beside]["));
    ck_assert_ptr_nonnull(strstr(said, "buildings-1.yaml,")); /* its designs are compared there */
    ck_assert_ptr_nonnull(strstr(said, "buildings-2.yaml]"));
    free(said);
    printf("# the walk to a report takes %d keys\n", keys);
    ck_assert_int_le(keys, 60);
}
END_TEST

/* Every kind of the form makes a scene that runs: bearings with 2.5 s and 5 % of the weight, stiffnesses and modes that
 * are read from files. */
START_TEST(new_scenes_of_every_kind)
{
    const struct thud_scene *now = &f.tui->doc.scene;
    char keys[400];
    ck_assert_int_eq(chdir(f.folder), 0);
    fixture_write(&f, "k.tab", "Story,1,2\n,kN/m,kN/m\n1,2e5,-1e5\n2,-1e5,1e5\n");
    fixture_write(&f, "m.tab",
                  "Case,Mode,Period,Story1,Story2\n,,sec,,\nModal,1,0.4,1,1.618033988749895\n"
                  "Modal,2,0.15,1.618033988749895,-1\n");
    for (int i = 0; thud_new_kind(i); i++) {
        const char *kind = thud_new_kind(i);
        bool matrix = strcmp(kind, "matrix") == 0, modes = strcmp(kind, "modes") == 0;
        snprintf(keys, sizeof keys,
                 ":new name: n%d; kind: %s, shear; storeys: 2; mass: 250 t; stiffness: %s, 500 MN/m; gap: 2 cm; "
                 "record: pulse.csv; soil: %s; damper: 3000<Enter>",
                 i, kind,
                 matrix  ? "k.tab"
                 : modes ? "m.tab"
                         : "500 MN/m",
                 matrix || modes ? ", 200" : "200");
        fixture_keys(&f, keys);
        fixture_expect(&f, "each value can be changed here now");
        ck_assert_int_eq((int)f.tui->run.live.which[THUD_LIVE_NONE].state, (int)THUD_LIVE_DONE);
        const struct thud_structure *s = &now->structure[0];
        ck_assert_double_eq_tol(now->structure[1].soil_vs_mps, 200.0, 1e-9); /* under the right one, which is shear */
        const bool building = thud_kind_is_building(s->kind);
        ck_assert_int_eq(now->nlinks, building);
        if (building)
            ck_assert_double_eq_tol(now->link[0].damping_nspm, 3e6, 1e-3);
        ck_assert_int_eq(s->soil_vs_mps > 199.0, building && s->kind != THUD_ISOLATED && !matrix && !modes);
        if (strcmp(kind, "lead-rubber") == 0) {
            ck_assert_double_eq_tol(s->isolator_strength_n, 0.05 * 750e3 * 9.80665, 1e-3 * s->isolator_strength_n);
            ck_assert_double_eq_tol(s->isolator_post_yield_npm, 750e3 * 6.3165, 1e-3 * s->isolator_post_yield_npm);
        } else if (strcmp(kind, "pendulum") == 0)
            ck_assert_double_eq_tol(2 * 3.14159265 * sqrt(s->isolator_radius_m / 9.80665), 2.5, 0.01);
        else if (strcmp(kind, "backfill") == 0)
            ck_assert(thud_wall_gives(s) && thud_wall_has_backfill(s));
        else if (matrix || modes)
            ck_assert_double_eq_tol(2 * 3.14159265 / f.tui->run.live.which[THUD_LIVE_NONE].model->structure[0].omega[0],
                                    matrix ? 0.508 : 0.4, 1e-3);
        fixture_keys(&f, "u");
        fixture_keys(&f, "w");
        snprintf(keys, sizeof keys, "n%d.yaml", i);
        char *file = fixture_file(&f, keys); /* a stiffness is no system: it is guessed, and marked */
        ck_assert_int_eq(strstr(file, "system: concrete-frame         # a guess: ") != NULL,
                         strcmp(kind, "estimated") == 0);
        free(file);
    }
}
END_TEST

/* The form has the command's own options; what is filled in is what the command gets, on the file that is open.
 * Progress is said while it runs, then the files or what it prints. */
START_TEST(commands_have_forms)
{
    char program[200], expected[300];
    ck_assert_int_eq(chdir(f.folder), 0);
    fixture_program(&f, program, sizeof program, "printf '[%s]' \"$@\" >said; : >report.html; echo report.html");
    fixture_keys(&f, ":set gap 3 cm<Enter>R");
    fixture_expect(&f, "w saves them first");
    fixture_keys(&f, "uR");
    fixture_expect(&f, "thud report: a document about your buildings");
    fixture_keys(&f, "<Down>"); /* the next one is the command's own */
    ck_assert_str_eq(thud_option_at(0)->name, "set");
    fixture_keys(&f, "<Size 80x40>");
    fixture_expect(&f, "--project TEXT");
    char *screen = fixture_text(&f);
    int row = 0;
    for (const char *at = strstr(screen, "-o DIR"), *to = strstr(screen, "--project"); at && at < to; at++)
        row += *at == '\n';
    free(screen);
    for (int i = 1; i < row; i++)
        fixture_keys(&f, "<Down>");
    fixture_keys(&f, "Two towers<Enter>");
    fixture_expect(&f, "Written report.html");
    char *said = fixture_file(&f, "said");
    snprintf(expected, sizeof expected, "[report][%s/towers.yaml][-o][towers-report][--project][Two towers]", f.folder);
    ck_assert_str_eq(said, expected);
    free(said);
    fixture_program(&f, program, sizeof program, "printf '[%s]' \"$@\" >said; echo ' a table'; echo 'of two rows'");
    fixture_keys(&f, ":export opensees --case none<Enter>");
    fixture_expect(&f, "of two rows");
    said = fixture_file(&f, "said");
    snprintf(expected, sizeof expected, "[export][opensees][%s/towers.yaml][--case][none]", f.folder);
    ck_assert_str_eq(said, expected);
    free(said);
    fixture_program(&f, program, sizeof program, "echo 'half of it' >&2; exit 3");
    fixture_keys(&f, "<Esc>:gap<Enter><Enter>");
    fixture_expect(&f, "! thud gap: half of it");
    fixture_program(&f, program, sizeof program, "echo 'thud: thud gap takes one preset' >&2; exit 2");
    fixture_keys(&f, "<Esc>:gap<Enter><Enter>");
    fixture_expect(&f, " ! thud gap takes one preset"); /* its name once */
    fixture_program(&f, program, sizeof program, "echo working >&2; exec sleep 1000");
    fixture_expect(&f, "thud gap");
    thud_tui_command(f.tui, (char[]){"gap -j 1"});
    while (strcmp(f.tui->said.text, "thud gap: working") != 0)
        thud_tui_turn(f.tui, true);
    thud_tui_draw(f.tui);
    fixture_expect(&f, "thud gap  Esc stops");
    fixture_keys(&f, "<Esc>");
    fixture_expect(&f, "thud gap was stopped");
}
END_TEST

/* A study's figures come while it runs, each in place of the one before it, of what stands on the screen; they stay,
 * and say so, once that is another. */
START_TEST(studies_show_their_figures)
{
    char program[200], expected[300];
    const double x[] = {1, 2}, y[] = {3, 4};
    struct thud_text bytes = {0};
    ck_assert_int_eq(chdir(f.folder), 0);
    for (int i = 0; i < 2; i++) {
        struct thud_figure *figure = thud_figure_create("bench", i ? "All of it" : "So far", 1, 1);
        thud_panel_add(thud_figure_panel(figure, 0, 0, ""), (struct thud_style){0}, "a curve", 2, x, y);
        thud_figure_write(figure, &bytes);
        ck_assert_int_eq(thud_text_write(&bytes, i ? "second" : "first", NULL), THUD_OK);
        thud_figure_free(figure);
    }
    fixture_program(
        &f, program, sizeof program,
        "printf '[%s]' \"$@\" >said; cat first >$THUD_FIGURES; echo >&2; until test -f go; do sleep 0.01; done; "
        "cat second >>$THUD_FIGURES; echo >&2; echo 'its table'");
    fixture_keys(&f, "<Size 130x40>:set gap 3 cm<Enter>");
    thud_tui_command(f.tui, (char[]){"bench -o out"});
    while (f.tui->dialog.mode == THUD_MODE_NORMAL)
        thud_tui_turn(f.tui, true);
    while (thud_tui_turn(f.tui, false))
        ;
    thud_tui_draw(f.tui);
    fixture_expect(&f, "So far");
    fixture_expect(&f, "a curve");
    fixture_write(&f, "go", "");
    while (f.tui->files.command)
        thud_tui_turn(f.tui, true);
    fixture_keys(&f, "");
    fixture_expect(&f, "All of it");
    fixture_expect_not(&f, "So far");
    fixture_expect(&f, "thud bench is done; Ctrl-O has its table");
    char *said = fixture_file(&f, "said"); /* not the file that lacks the edit */
    snprintf(expected, sizeof expected, "[bench][%s/towers.yaml.recovered][-o][out]", f.folder);
    ck_assert_str_eq(said, expected);
    free(said);
    ck_assert_ptr_null(fixture_file(&f, "towers.yaml.recovered"));
    fixture_keys(&f, "<Esc><C-o>");
    fixture_expect(&f, "its table");
    fixture_keys(&f, "<Esc>uF");
    fixture_expect(&f, "All of it (before edits)");
}
END_TEST

/* Tabs between columns, as a spreadsheet takes them; of a chart its data. */
START_TEST(numbers_are_copied)
{
    fixture_keys(&f, "<A-4>y");
    ck_assert_ptr_nonnull(strstr(f.script.copied, "\nA 2\t"));
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:2 cm:1 cm<Enter><Tab>");
    fixture_keys(&f, "y");
    ck_assert_ptr_nonnull(strstr(f.script.copied, "panel,series,kind,"));
}
END_TEST

START_TEST(settings_come_from_a_file)
{
    struct thud_config config;
    struct thud_error err = {0};
    char path[100];
    thud_config_init(&config);
    ck_assert(config.color && config.live && config.mouse && !config.ascii);
    snprintf(path, sizeof path, "%s/config", f.folder);
    ck_assert_int_eq(thud_config_read(&config, path, &err), THUD_OK); /* there is none */
    fixture_write(&f, "config", "# mine\n  live off # slow machine\nmouse off\r\nfolder my figures\n\n");
    ck_assert_int_eq(thud_config_read(&config, path, &err), THUD_OK);
    ck_assert(config.color && !config.live && !config.mouse);
    ck_assert_str_eq(config.folder, "my figures");
    ck_assert_int_eq((int)config.theme, (int)THUD_THEME_AUTO);
    ck_assert_int_eq((int)config.images, (int)THUD_IMAGES_AUTO);
    for (int i = 0; i < THUD_THEMES || i < THUD_IMAGES_CHOICES; i++) {
        enum thud_theme theme = (enum thud_theme)(i % THUD_THEMES);
        enum thud_image_choice images = (enum thud_image_choice)(i % THUD_IMAGES_CHOICES);
        char text[80];
        snprintf(text, sizeof text, "theme %s\nimages %s\n", thud_theme_name(theme), thud_image_choice_name(images));
        fixture_write(&f, "config", text);
        ck_assert_int_eq(thud_config_read(&config, path, &err), THUD_OK);
        ck_assert(config.theme == theme && config.images == images);
    }
    fixture_write(&f, "config", "theme pink\n");
    ck_assert_int_eq(thud_config_read(&config, path, &err), THUD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.allowed, "mono"));
    fixture_write(&f, "config", "mouse off\ncolour on\n");
    ck_assert_int_eq(thud_config_read(&config, path, &err), THUD_INPUT);
    ck_assert_int_eq(err.line, 2);
}
END_TEST

/* Designs over a suite: the larger of two single runs. */
START_TEST(designs_over_a_suite)
{
    double force[2];
    int impacts[2];
    char keys[80], number[24];
    for (int i = 0; i < 2; i++) {
        snprintf(keys, sizeof keys, ":set record.peak %s<Enter>", i ? "0.3 g" : "0.5 g");
        fixture_keys(&f, keys);
        force[i] = thud_live_force(&f.tui->run.live, THUD_LIVE_BUMPER, 0, &impacts[i]);
    }
    fixture_keys(&f, "Us");
    fixture_expect(&f, "The study has no ground motions");
    fixture_keys(&f, "<Esc>:records pulse.csv:peak=0.5g,pulse.csv:peak=0.3g<Enter>U");
    thud_tui_key(f.tui, 's'); /* nobody waits for it: keys are taken meanwhile */
    ck_assert(!f.tui->designs.item[0].suite.known);
    thud_tui_key(f.tui, 'j');
    thud_tui_draw(f.tui);
    fixture_expect(&f, "over 2 ground motions, running");
    fixture_keys(&f, "");
    fixture_expect_not(&f, "running");
    const struct thud_design *d = &f.tui->designs.item[0];
    ck_assert(force[0] != force[1]);
    ck_assert_double_eq_tol(d->suite.force_n[0], fmax(force[0], force[1]), 1e-6 * force[0]);
    ck_assert_int_eq(d->suite.impacts[0], impacts[0] > impacts[1] ? impacts[0] : impacts[1]);
    fixture_expect(&f, thud_tui_number(1e-6 * fmax(force[0], force[1]), number));
    fixture_keys(&f, "s");
    fixture_expect(&f, "* on the screen");
}
END_TEST

/* A report's list of designs has room for some; a path that has none is left out whole, which is said. */
START_TEST(designs_without_room_are_named)
{
    char keys[80];
    for (int i = 0; i < 25; i++) {
        snprintf(keys, sizeof keys, ":set gap %d cm<Enter>:name a-rather-long-name-%02d<Enter>", 3 + i, i);
        fixture_keys(&f, keys);
    }
    fixture_keys(&f, ":set gap 50 cm<Enter>:report<Enter>");
    fixture_expect(&f, "--beside has no room for");
    ck_assert_int_eq((int)f.tui->dialog.mode, (int)THUD_MODE_OVER);
    const struct thud_form_over *form = f.tui->dialog.own;
    for (int i = 0; i < form->n; i++) {
        const struct thud_option *option = form->row[i].of;
        if (!option || strcmp(option->name, "beside") != 0)
            continue;
        const char *list = form->row[i].value[0].text;
        ck_assert_int_gt((int)strlen(list), 400);
        ck_assert_str_eq(list + strlen(list) - 5, ".yaml");
        return;
    }
    ck_abort_msg("the form has no row of designs");
}
END_TEST

/* The state on the screen is the one that is named, whether it was run or not. */
START_TEST(the_state_on_the_screen_is_named)
{
    char path[160];
    struct thud_preset *preset;
    fixture_keys(&f, ":live off<Enter>:set gap 7 cm<Enter>U<F2>v7<Enter>");
    fixture_expect(&f, "This design is v7 now");
    snprintf(path, sizeof path, "%s/v7.yaml", f.folder);
    ck_assert_int_eq(thud_preset_read(path, &preset, NULL), THUD_OK);
    ck_assert_double_eq_tol(thud_preset_scene(preset)->interface[0].gap_m, 0.07, 1e-15);
    thud_preset_free(preset);
}
END_TEST

/* A bumper that is out is saved so, with its values and their comments, and there is nothing left to save. */
START_TEST(a_bumper_that_is_out_is_saved)
{
    fixture_keys(&f, "2Bw");
    fixture_expect(&f, "Saved");
    fixture_expect_not(&f, "[+]");
    fixture_keys(&f, "R");
    ck_assert_int_eq((int)f.tui->dialog.mode, (int)THUD_MODE_OVER); /* the report's form */
    fixture_keys(&f, "<Esc>");
    char *text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "stiffness: 0.36 kN/mm^2.65"));
    ck_assert_ptr_nonnull(strstr(text, "fitted: off"));
    free(text);
    fixture_keys(&f, "Bw");
    text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_null(strstr(text, "fitted"));
    ck_assert(scene()->interface[0].has_bumper);
    free(text);
    fixture_keys(&f, "Bq");
    fixture_expect(&f, "has unsaved changes");
    fixture_keys(&f, "n");
}
END_TEST

START_TEST(a_deleted_preset_is_said_to_be_deleted)
{
    char path[160];
    snprintf(path, sizeof path, "%s/towers.yaml", f.folder);
    fixture_keys(&f, ":set gap 4 cm<Enter>");
    ck_assert_int_eq(remove(path), 0);
    fixture_keys(&f, "w");
    fixture_expect(&f, "was deleted since");
    fixture_keys(&f, "y");
    char *text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "gap: 4 cm"));
    free(text);
}
END_TEST

/* A file name that is proposed is selected: what is typed replaces it. */
START_TEST(what_a_prompt_proposes_is_selected)
{
    char keys[160];
    ck_assert_int_eq(chdir(f.folder), 0);
    snprintf(keys, sizeof keys, ":name bare<Enter>U<F2>bumper5<Enter>");
    fixture_keys(&f, keys);
    char *text = fixture_file(&f, "bumper5.yaml");
    ck_assert_ptr_nonnull(text);
    free(text);
    ck_assert_ptr_null(fixture_file(&f, "barebumper5.yaml"));
}
END_TEST

/* Own ground motions are found by letters where they are kept: in records/ beside the work. */
START_TEST(own_records_are_found)
{
    char path[160];
    snprintf(path, sizeof path, "%s/records", f.folder);
    ck_assert_int_eq(mkdir(path, 0777), 0);
    fixture_write(&f, "records/mine.csv", "time_s,acceleration_g\n0,0\n0.01,0.1\n0.02,0\n");
    ck_assert_int_eq(chdir(f.folder), 0);
    fixture_keys(&f, "3");
    fixture_expect(&f, "records/mine");
    fixture_keys(&f, "/mine<Enter>");
    ck_assert_str_eq(scene()->record.file, "records/mine.csv");
}
END_TEST

/* Reasons stay in sight, in the terminal's own words. */
START_TEST(what_is_wrong_is_said)
{
    char digits[401], keys[500], program[160];
    memset(digits, '7', 400);
    digits[400] = '\0';
    snprintf(keys, sizeof keys, ":set gap %s<Enter>", digits);
    fixture_keys(&f, keys);
    fixture_expect(&f, "is not a number; give a length");
    fixture_keys(&f, ":storey add 9 9<Enter>");
    fixture_expect(&f, "storey add STRUCTURE FLOOR, counted from 1");
    fixture_keys(&f, ":storey add 1 99<Enter>");
    fixture_expect(&f, "storey add 1 99: storey add STRUCTURE FLOOR, counted from 1");
    fixture_keys(&f, ":live off<Enter>:live maybe<Enter>");
    fixture_expect(&f, "live is on or off, not \"maybe\"");
    ck_assert(!f.tui->run.on);
    fixture_keys(&f, ":live on<Enter>");
    ck_assert(f.tui->run.on);
    snprintf(keys, sizeof keys, ":bumper 1%80sboth<Enter>", ""); /* nor is the end of a long line cut */
    fixture_keys(&f, keys);
    fixture_expect(&f, "[INTERFACE], counted from 1");
    fixture_keys(&f, ":events pounding, shaking<Enter>");
    fixture_expect(&f, "\"shaking\" is not an event (pounding,");
    ck_assert_str_eq(scene()->study.events, "");
    fixture_keys(&f, ":bumper both<Enter>"); /* nothing is done that was not asked for */
    fixture_expect(&f, "bumper [INTERFACE], counted from 1");
    fixture_keys(&f, ":swap 1 3<Enter>");
    fixture_expect(&f, "swap STRUCTURE, counted from 1");
    fixture_keys(&f, "3<Home><Enter>");
    fixture_expect(&f, "Record: Enter on a ground motion");
    fixture_expect_not(&f, "--record");
    fixture_keys(&f, "u");
    fixture_program(&f, program, sizeof program, "echo 'thud: no such thing' >&2; exit 2");
    fixture_keys(&f, "1w:report rep<Enter>");
    fixture_expect(&f, "thud report: no such thing");
    fixture_expect_not(&f, "thud: no such");
}
END_TEST

/* Kinds are chosen from a list; a building that was a body for a while has its storeys again. */
START_TEST(storeys_survive_another_kind)
{
    thud_tui_go_to_field(f.tui, "structures.2.kind");
    thud_tui_draw(f.tui);
    fixture_keys(&f, " ");
    ck_assert_int_eq((int)f.tui->dialog.mode, (int)THUD_MODE_CHOOSING);
    fixture_keys(&f, "rigid<Enter>");
    ck_assert_int_eq((int)scene()->structure[1].kind, (int)THUD_RIGID);
    fixture_keys(&f, " shear<Enter>");
    ck_assert_int_eq(scene()->structure[1].storeys, 3);
    ck_assert_double_eq(scene()->structure[1].mass_kg[2], 250e3);
    ck_assert_double_eq(scene()->structure[1].stiffness_npm[0], 400e6);
    fixture_keys(&f, "uu");
    ck_assert_int_eq(scene()->structure[1].storeys, 3);
}
END_TEST

/* Every design that was run is there with its result; they are gone to, named, which saves them, compared with, marked
 * for the report and forgotten. */
START_TEST(designs_are_gone_to_named_and_compared)
{
    char text[40], path[160];
    struct thud_preset *preset;
    int impacts;
    const double force = thud_live_force(&f.tui->run.live, THUD_LIVE_BUMPER, 0, &impacts);
    fixture_keys(&f, ":set gap 4 cm<Enter>");
    fixture_keys(&f, ":set gap 6 cm<Enter>");
    fixture_keys(&f, ":set gap 4 cm<Enter>"); /* twice the same is once */
    fixture_keys(&f, "U");
    ck_assert_int_eq(f.tui->designs.n, 3);
    fixture_expect(&f, thud_tui_number(1e-6 * force, text));
    fixture_expect(&f, "*#2 gap 4 cm"); /* the one on the screen comes first, */
    fixture_expect(&f, "#3 gap 6 cm");  /* the others by what they have other than the first */
    fixture_expect(&f, "#1 as opened");
    fixture_keys(&f, "<Down><Down><Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.02, 1e-15);
    fixture_keys(&f, "u");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.04, 1e-15);
    fixture_keys(&f, "U<Down><F2>wide<Enter>");
    snprintf(path, sizeof path, "%s/wide.yaml", f.folder);
    ck_assert_int_eq(thud_preset_read(path, &preset, NULL), THUD_OK);
    ck_assert_double_eq_tol(thud_preset_scene(preset)->interface[0].gap_m, 0.06, 1e-15);
    thud_preset_free(preset);
    fixture_keys(&f, "U<Down><Tab><Esc>");
    ck_assert_double_eq_tol(f.tui->base.scene.interface[0].gap_m, 0.06, 1e-15);
    ck_assert_ptr_nonnull(thud_tui_compared(f.tui));
    fixture_keys(&f, "U<Down><Down> <Esc>"); /* what goes into the report is a file */
    char *marked = fixture_file(&f, "towers-1.yaml");
    ck_assert_ptr_nonnull(marked);
    ck_assert_ptr_nonnull(strstr(marked, "gap: 2 cm"));
    free(marked);
    fixture_keys(&f, ":name wide<Enter>"); /* taken */
    fixture_expect(&f, "neither a design nor a preset");
    for (int i = 0; i < 60; i++) { /* the newest stay, and what has a name */
        char keys[64];
        snprintf(keys, sizeof keys, ":set gap %d mm<Enter>", 30 + i);
        fixture_keys(&f, keys);
    }
    ck_assert_int_eq(f.tui->designs.n, THUD_DESIGNS_MAX);
    fixture_keys(&f, ":design wide<Enter>");
    ck_assert_double_eq_tol(scene()->interface[0].gap_m, 0.06, 1e-15);
    fixture_keys(&f, "U<Down><Del><Esc>");
    ck_assert_int_eq(f.tui->designs.n, THUD_DESIGNS_MAX - 1);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui files");
    TCase *files = tcase_create("files");
    tcase_set_timeout(files, 60.0);
    tcase_add_checked_fixture(files, setup, teardown);
    tcase_add_test(files, saving_keeps_comments);
    tcase_add_test(files, a_scene_from_nothing);
    tcase_add_test(files, designs_over_a_suite);
    tcase_add_test(files, the_state_on_the_screen_is_named);
    tcase_add_test(files, designs_without_room_are_named);
    tcase_add_test(files, a_bumper_that_is_out_is_saved);
    tcase_add_test(files, a_deleted_preset_is_said_to_be_deleted);
    tcase_add_test(files, what_a_prompt_proposes_is_selected);
    tcase_add_test(files, own_records_are_found);
    tcase_add_test(files, what_is_wrong_is_said);
    tcase_add_test(files, storeys_survive_another_kind);
    tcase_add_test(files, designs_are_gone_to_named_and_compared);
    tcase_add_test(files, a_new_scene_is_refused);
    tcase_add_test(files, kinds_are_typed);
    tcase_add_test(files, answers_are_those_of_the_command);
    tcase_add_test(files, solving_has_a_form);
    tcase_add_test(files, other_kinds_from_nothing);
    tcase_add_test(files, files_are_browsed);
    tcase_add_test(files, the_walk_of_an_engineer);
    tcase_add_test(files, the_walk_to_a_report);
    tcase_add_test(files, new_scenes_of_every_kind);
    tcase_add_test(files, commands_have_forms);
    tcase_add_test(files, studies_show_their_figures);
    tcase_add_test(files, numbers_are_copied);
    tcase_add_test(files, settings_come_from_a_file);
    tcase_add_test(files, a_session_is_played_again);
    tcase_add_test(files, a_held_key_is_one_change);
    tcase_add_test(files, a_held_key_is_one_line_of_the_list);
    tcase_add_test(files, commands_outlast_what_was_said);
    tcase_add_test(files, long_lines_are_played_again);
    tcase_add_test(files, what_has_no_room_is_refused);
    tcase_add_test(files, swapped_keys_of_a_study_are_played_again);
    tcase_add_test(files, a_session_stops_where_it_cannot);
    tcase_add_test(files, a_new_scene_as_a_command);
    tcase_add_test(files, saving_under_another_name);
    tcase_add_test(files, a_file_changed_by_others_is_asked_about);
    tcase_add_test(files, a_full_disk_loses_nothing);
    tcase_add_test(files, results_as_csv);
    tcase_add_test(files, quitting_asks_only_when_unsaved);
    tcase_add_test(files, unsaved_edits_can_be_recovered);
    tcase_add_test(files, edits_are_kept_as_they_are_made);
    tcase_add_test(files, opening_another_preset);
    tcase_add_test(files, a_pipe_is_no_ground_motion);
    tcase_add_test(files, shipped_presets_stay_as_they_are);
    tcase_add_test(files, unsaved_changes_can_be_saved_on_the_way_out);
    tcase_add_test(files, kept_changes_are_offered_at_the_start);
    tcase_add_test(files, commands_are_completed_and_remembered);
    suite_add_tcase(suite, files);
    return suite;
}
