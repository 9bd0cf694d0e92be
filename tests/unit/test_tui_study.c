/* The study of the Sweep screen is the preset's own: typed, refused, undone, saved, and run again from the file. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/sweep/study_keys.h"
#include "plot/figures/figures_sweep.h"
#include "study/sweep/sweep.h"
#include "tui/document/motions.h"
#include "tui/screens/sweep_screen.h"
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

static const struct thud_study_choice *study(void)
{
    return &f.tui->doc.scene.study;
}

START_TEST(a_range_becomes_the_presets_study)
{
    unsigned long revision = f.tui->doc.revision;
    fixture_keys(&f, "<A-6><Enter><C-u>gap=2:4:0.5 cm<Enter>");
    ck_assert_int_eq(study()->nvary, 1);
    ck_assert_str_eq(study()->vary[0].key, "gap");
    ck_assert_double_eq_tol(study()->vary[0].from, 0.02, 1e-15);
    ck_assert_double_eq_tol(study()->vary[0].to, 0.04, 1e-15);
    ck_assert_double_eq_tol(study()->vary[0].step, 0.005, 1e-15);
    ck_assert_uint_eq(f.tui->doc.revision, revision); /* no run depends on it: none is made again */
    fixture_expect(&f, "towers [+]");
    fixture_keys(&f, "<Down><Enter>contact.restitution=0.5:0.7:0.1<Enter>");
    ck_assert_int_eq(study()->nvary, 2);
    fixture_keys(&f, "u");
    ck_assert_int_eq(study()->nvary, 1);
    fixture_keys(&f, "<C-r>");
    fixture_expect(&f, "contact.restitution=0.5:0");
    fixture_keys(&f, "<Home><Enter><C-u><Enter>"); /* the first one goes, the second moves up */
    ck_assert_int_eq(study()->nvary, 1);
    ck_assert_str_eq(study()->vary[0].key, "contact.restitution");
}
END_TEST

START_TEST(what_is_saved_is_the_same_study)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:3 cm:1 cm<Enter>");
    fixture_keys(&f, "<Down><Enter>bumper.stiffness=0.3:0.4:0.1 kN/mm^2.65<Enter>");
    fixture_keys(&f, "<Down><Down><Enter><C-u>none,bumper<Enter>w");
    fixture_expect(&f, "Saved");
    char *text = fixture_file(&f, "towers.yaml");
    ck_assert_ptr_nonnull(strstr(text, "# concrete to concrete"));
    free(text);
    struct thud_preset *preset;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_preset_read(f.tui->doc.path, &preset, &err), THUD_OK);
    ck_assert_mem_eq(&thud_preset_scene(preset)->study, study(), sizeof *study());
    struct thud_sweep_plan plan; /* as the command line plans it */
    thud_sweep_plan_init(&plan, thud_preset_scene(preset));
    ck_assert_int_eq(thud_sweep_study(&plan, true, true, &err), THUD_OK);
    fixture_keys(&f, "r");
    fixture_expect(&f, "6 of 6 points");
    ck_assert_int_eq((int)thud_sweep_points(&plan), 6);
    ck_assert_int_eq(plan.ncases, 2);
    thud_sweep_plan_clear(&plan);
    thud_preset_free(preset);
}
END_TEST

START_TEST(a_spread_is_kept_and_run)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=8 cm:9 cm:1 cm<Enter><Down><Down><Down><Down><Enter>90 %<Enter>");
    ck_assert(study()->sensitivity == 0);
    fixture_expect(&f, "too large");
    fixture_keys(&f, "<C-u>0.2 %<Enter>w");
    ck_assert_double_eq_tol(study()->sensitivity, 2e-3, 1e-15);
    struct thud_preset *preset;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_preset_read(f.tui->doc.path, &preset, &err), THUD_OK);
    ck_assert_mem_eq(&thud_preset_scene(preset)->study, study(), sizeof *study());
    thud_preset_free(preset);
    fixture_keys(&f, "r");
    fixture_expect(&f, "2 of 2 points");
    fixture_keys(&f, "e");
    fixture_expect(&f, "Written towers-sweep.csv");
    char *csv = fixture_file(&f, "towers-sweep.csv");
    ck_assert_ptr_nonnull(csv);
    ck_assert_ptr_nonnull(strstr(csv, ",drift_ratio_low,drift_ratio_high,"));
    free(csv);
    fixture_keys(&f, "<Enter><C-u><Enter>");
    ck_assert(study()->sensitivity == 0);
}
END_TEST

/* A study of the screen to its end, and the lines of its files. */
static void make_study(struct thud_live_study *data, unsigned shortcuts, char *text[THUD_SWEEP_CSVS])
{
    static char vary[THUD_VARY_MAX][THUD_VARY_TEXT] = {"bumper.thickness=1 cm,2 cm,3 cm", "gap=3 cm,6 cm,400 cm"};
    static const char *const name[THUD_SWEEP_CSVS] = {"s.csv", "s-contacts.csv", "s-needed-gaps.csv"};
    struct thud_error err = {0};
    ck_assert_int_eq(thud_study_vary_keep(vary, &f.tui->doc.scene, &err), THUD_OK);
    struct thud_session *session = thud_doc_session(&f.tui->doc);
    ck_assert_ptr_nonnull(session);
    ck_assert_int_eq(thud_live_study_prepare(data, session, &err), THUD_OK);
    free(session);
    data->plan.shortcuts = shortcuts;
    ck_assert_int_eq(thud_live_study_start(data, &err), THUD_OK);
    while (data->running)
        ck_assert_int_eq(thud_live_study_advance(data, &err), THUD_OK);
    ck_assert(data->complete);
    ck_assert_int_eq(thud_live_study_export(data, f.folder, "s", &err), THUD_OK);
    for (int i = 0; i < THUD_SWEEP_CSVS; i++)
        text[i] = fixture_file(&f, name[i]);
}

/* Case `none` is run once for each gap that is used up, whatever the bumper's thickness; the files are the same. With
 * several threads a point may come before the one it would share with: as many are shared, or fewer, never more. */
START_TEST(no_bumper_is_run_once_for_all_thicknesses)
{
    static struct thud_live_study data;
    char *all[THUD_SWEEP_CSVS], *none[THUD_SWEEP_CSVS];
    make_study(&data, THUD_SWEEP_ALL, all);
    ck_assert_int_eq(data.out.total.asked, 18);
    ck_assert_int_le(data.out.total.reused, 2 * 2);
    long work = data.out.total.made + data.out.total.reused;
    make_study(&data, THUD_SWEEP_ALL & ~(unsigned)THUD_SWEEP_SAME, none);
    ck_assert_int_eq(data.out.total.reused, 0);
    ck_assert_int_eq(data.out.total.made, work);
    for (int i = 0; i < THUD_SWEEP_CSVS; i++) {
        ck_assert_str_eq(all[i], none[i]);
        ck_assert_int_eq(all[i][strlen(all[i]) - 1], '\n');
        ck_assert_ptr_nonnull(strstr(all[i], "\npulse.csv,")); /* as it was named, not where it was found */
        free(all[i]);
        free(none[i]);
    }
    thud_live_study_clear(&data);
}
END_TEST

START_TEST(wrong_words_are_refused)
{
    static const char *const words[] = {"gap",
                                        "gap=",
                                        "gap=1 cm:2 cm",
                                        "gap=1 t:2 t:1 t",
                                        "nokey=1:2:1",
                                        "gap=3 cm:1 cm:1 cm",
                                        "record.file=a:b:c",
                                        "gap=600 cm:700 cm:50 cm"};
    fixture_keys(&f, "<A-6>");
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        fixture_keys(&f, "<Enter><C-u>");
        fixture_keys(&f, words[i]);
        fixture_keys(&f, "<Enter>");
        ck_assert_msg(f.tui->dialog.mode == THUD_MODE_OVER, "%s was taken", words[i]);
        fixture_expect(&f, " ! ");
        fixture_expect(&f, words[i]); /* stays in the form */
        fixture_keys(&f, "<Esc>");
        ck_assert_int_eq(study()->nvary, 0);
    }
    ck_assert_int_eq(f.tui->doc.undo.count, 0);
    fixture_keys(&f,
                 "<Enter>gap=1 cm:2 cm:1 cm<Tab>contact.restitution=0.5,0.6<Enter>"); /* all that is varied at once */
    ck_assert_int_eq(study()->nvary, 2);
    ck_assert_int_eq(f.tui->doc.undo.count, 1);
    fixture_keys(&f, "<Down><Enter><C-u><Enter>"); /* the second one, which is emptied */
    ck_assert_int_eq(study()->nvary, 1);
    fixture_keys(&f, "1/study.vary<Enter>");
    ck_assert_int_eq(f.tui->screen, THUD_SCREEN_SWEEP);
    ck_assert_ptr_nonnull(thud_form_focus(&f.tui->form));
    ck_assert_str_eq(thud_form_focus(&f.tui->form)->path, "study.vary");
}
END_TEST

/* With the unit of the last one, as they run; a range beside them becomes a list. */
START_TEST(a_list_is_kept)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=3,4 cm<Enter>");
    ck_assert_str_eq(study()->vary[0].values, "3 cm, 4 cm");
    fixture_keys(&f, "<Down><Enter>contact.restitution=0.5:0.7:0.1<Enter>");
    fixture_keys(&f, "<Down><Enter>contact.damping=exact,paper<Enter>w");
    ck_assert_int_eq(study()->nvary, 3);
    ck_assert_str_eq(study()->vary[1].values, "0.5, 0.6, 0.7");
    struct thud_preset *preset;
    struct thud_error err = {0};
    ck_assert_int_eq(thud_preset_read(f.tui->doc.path, &preset, &err), THUD_OK);
    ck_assert_mem_eq(&thud_preset_scene(preset)->study, study(), sizeof *study());
    struct thud_sweep_plan plan;
    thud_sweep_plan_init(&plan, thud_preset_scene(preset));
    ck_assert_int_eq(thud_sweep_study(&plan, true, true, &err), THUD_OK);
    ck_assert_int_eq((int)thud_sweep_points(&plan), 12);
    thud_sweep_plan_clear(&plan);
    thud_preset_free(preset);
    fixture_keys(&f, "u");
    fixture_expect(&f, "contact.restitution=0.5");
    ck_assert_int_eq(study()->nvary, 2);
}
END_TEST

/* More values than a preset has room for run, and are not kept. */
START_TEST(a_list_too_long_is_run_but_not_kept)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:2 cm:1 cm<Enter>");
    fixture_keys(&f, "<Down><Enter>contact.restitution=0.5<Enter>");
    ck_assert_str_eq(study()->vary[0].values, "1 cm, 2 cm");
    fixture_keys(&f, "<Home><Enter><C-u>gap=1 cm:2 cm:0.01 cm<Enter>");
    fixture_expect(&f, "no room for so many values");
    ck_assert_str_eq(study()->vary[0].values, "1 cm, 2 cm");
}
END_TEST

START_TEST(edits_make_a_study_old)
{
    fixture_keys(&f, ":live off<Enter><A-6><Enter><C-u>gap=1 cm,3 cm<Enter>r");
    fixture_expect(&f, "2 of 2 points");
    fixture_expect_not(&f, "before edits");
    fixture_keys(&f, "<Enter><C-u>gap=1 cm:2 cm:1 cm<Enter>");
    fixture_expect(&f, "of the study before edits");
    fixture_keys(&f, "<A-2><Enter>3<Enter><A-6>");
    fixture_expect_not(&f, "of the scene before edits"); /* the gap is what it varies */
    fixture_keys(&f, "r:set contact.restitution 0.5<Enter>");
    fixture_expect(&f, "of the scene before edits");
}
END_TEST

/* Nobody asks for it: what is shown follows the words and the scene, and no run is made where neither changed. */
START_TEST(the_study_fills_by_itself)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:3 cm:1 cm<Enter>");
    fixture_expect(&f, "3 of 3 points");
    fixture_expect_not(&f, "before edits");
    struct thud_sweep_point **made = thud_sweep_state(f.tui)->data.done;
    double force = made[0]->contact[0].force_n;
    fixture_keys(&f, ":set gap 2.5 cm<Enter>:title Other<Enter>"); /* neither changes the study */
    ck_assert_ptr_eq(thud_sweep_state(f.tui)->data.done, made);
    ck_assert(thud_sweep_state(f.tui)->data.done[0]->contact[0].force_n == force);
    fixture_keys(&f, ":set contact.stiffness 1000 kN/mm<Enter>");
    fixture_expect(&f, "3 of 3 points");
    fixture_expect_not(&f, "before edits");
    ck_assert(thud_sweep_state(f.tui)->data.done[0]->contact[0].force_n < 0.9 * force);
    fixture_keys(&f, "u");
    ck_assert(thud_sweep_state(f.tui)->data.done[0]->contact[0].force_n == force);
}
END_TEST

/* The figure that would be written is of the study as it is, also where it has as many rows as the one before. */
START_TEST(the_figure_is_of_the_study_as_it_is)
{
    char *text[2];
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:3 cm:1 cm<Enter>");
    for (int i = 0; i < 2; i++) {
        if (i == 1)
            fixture_keys(&f, ":set contact.stiffness 1000 kN/mm<Enter>");
        struct thud_figure *anew = thud_live_study_figure(&thud_sweep_state(f.tui)->data, 0);
        struct thud_text shown = {0}, right = {0};
        thud_figure_csv(thud_views[THUD_SCREEN_SWEEP]->figure(f.tui), &shown);
        thud_figure_csv(anew, &right);
        ck_assert_str_eq(shown.data, right.data);
        thud_text_clear(&right);
        thud_figure_free(anew);
        text[i] = shown.data;
    }
    ck_assert_str_ne(text[0], text[1]);
    free(text[0]);
    free(text[1]);
    fixture_expect_not(&f, "before edits");
    fixture_keys(&f, ":live off<Enter>:set contact.stiffness 2000 kN/mm<Enter>");
    fixture_expect(&f, "before edits: ");
    static const char *const keys[] = {"p", "e"};
    for (int i = 0; i < 2; i++) {
        fixture_keys(&f, keys[i]);
        fixture_expect(&f, "is of before the edits, and is not written");
        char *csv = fixture_file(&f, i ? "towers-sweep.csv" : "towers-sweep-force.csv");
        ck_assert_ptr_null(csv);
    }
    fixture_keys(&f, "u");
    fixture_expect_not(&f, "before edits: ");
}
END_TEST

/* A rigid body has no drifts: of the four places of a figure of ratios one is empty, and no key leads there. */
START_TEST(panels_without_a_ratio_are_passed_over)
{
    const struct thud_sweep_state *s = thud_sweep_state(f.tui);
    fixture_keys(&f, ":set structures.1.kind rigid<Enter><A-6><Enter><C-u>gap=1 cm:3 cm:1 cm<Enter>");
    for (int i = 0; i < 9 && (!s->shown || s->shown->rows * s->shown->columns != 4); i++)
        fixture_keys(&f, "c");
    ck_assert_int_eq(s->shown->rows * s->shown->columns, 4);
    for (int back = 0; back < 2; back++) {
        int seen = 0;
        for (int i = 0; i < 4; i++) { /* three panels, and all of them */
            fixture_keys(&f, back ? "[" : "]");
            ck_assert(s->panel < 0 || s->shown->panel[s->panel].used);
            seen |= 1 << (s->panel + 1);
        }
        ck_assert_int_eq(seen, 1 | 1 << 1 | 1 << 2 | 1 << 4);
    }
}
END_TEST

/* One that takes long waits for r, and its words stay to be read. */
START_TEST(a_long_study_waits)
{
    f.tui->run.plain_s = 1;
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:3 cm:0.1 cm<Enter>");
    fixture_expect(&f, "gap=1 cm:3 cm:0.1 cm");
    fixture_expect(&f, "runs, about");
    fixture_expect_not(&f, "stopped");
    f.tui->run.plain_s = 0.02; /* what histories took for Plots is nothing to a study */
    f.tui->run.elapsed_s = 1e3;
    fixture_keys(&f, "<Home><Enter><C-u>gap=1 cm:3 cm:0.2 cm<Enter>");
    fixture_expect_not(&f, "runs, about");
    fixture_expect(&f, "11 of 11 points");
}
END_TEST

/* The numbers are those of the runner that `thud sweep` uses, in its order. */
START_TEST(the_cursor_sets_the_gap)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:3 cm:0.5 cm<Enter><Tab>");
    fixture_keys(&f, "<Enter>");
    fixture_expect(&f, "Left and Right read a value first");
    fixture_keys(&f, "<Right>"); /* from the scene's own 2 cm on */
    fixture_expect(&f, "Gap 2.5 cm:");
    fixture_keys(&f, "<Left><Left>");
    fixture_expect(&f, "Gap 1.5 cm:");
    fixture_keys(&f, "<Enter>");
    fixture_expect(&f, "gap is 1.5 cm now");
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.015, 1e-15);
    fixture_expect(&f, "at 1.5 cm"); /* the result above */
    fixture_keys(&f, "u");
    ck_assert_double_eq_tol(f.tui->doc.scene.interface[0].gap_m, 0.02, 1e-15);
}
END_TEST

/* A folder of motions: medians of all of them first, the gap that is enough and the fragility after their own. */
START_TEST(a_suite_has_its_statistics)
{
    char words[600];
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:5 cm:1 cm<Enter>:signs both<Enter>:events pounding,drift:2 cm<Enter>");
    snprintf(words, sizeof words, ":records %s/pulse.csv:peak=0.2g, %s/pulse.csv:peak=0.6g<Enter>", f.folder, f.folder);
    fixture_keys(&f, words);
    fixture_expect(&f, "20 of 20 points");
    fixture_expect(&f, "4 ground motions");
    fixture_expect(&f, "means ove");
    int n = thud_live_study_figures(&thud_sweep_state(f.tui)->data), gap = -1, fragility = 0;
    for (int i = 0; i < n; i++) {
        struct thud_figure *figure = thud_live_study_figure(&thud_sweep_state(f.tui)->data, i);
        ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
        gap = strcmp(figure->name, "needed-gap") == 0 ? i : gap;
        fragility += strncmp(figure->name, "fragility", 9) == 0;
        thud_figure_free(figure);
    }
    ck_assert_int_ge(gap, 1);
    ck_assert_int_eq(fragility, 2);
    /* the needed gap of a motion is what the fragility against the gap turns on */
    const struct thud_needed_gap *weak = thud_sweep_state(f.tui)->data.gap[0],
                                 *strong = thud_sweep_state(f.tui)->data.gap[2];
    ck_assert_double_eq_tol(thud_needed_gap_widest(strong, 0, THUD_GAP_EXACT, NULL),
                            3 * thud_needed_gap_widest(weak, 0, THUD_GAP_EXACT, NULL), 1e-9);
    fixture_keys(&f, "e");
    fixture_expect(&f, "-suite.csv");
    char *csv = fixture_file(&f, "towers-sweep-suite.csv");
    ck_assert_ptr_nonnull(csv);
    free(csv);
    fixture_keys(&f, ":signs maybe<Enter>");
    fixture_expect(&f, "one, both");
}
END_TEST

/* Motions are marked on Record; one that lacks its step is asked for it. The marked ones are the study's, and their
 * spectra stand against the target. */
START_TEST(a_suite_is_put_together_on_the_record_screen)
{
    const char *records = f.tui->doc.scene.study.records;
    char folder[sizeof f.folder];
    memcpy(folder, f.folder, sizeof folder);
    ck_assert_int_eq(chdir(folder), 0);
    fixture_write(&f, "plain.txt", "0.1\n-0.2\n0.3\n-0.1\n0.2\n-0.3\n0.1\n0.0\n");
    fixture_keys(&f, "<Size 100x30>3<Home><Down> ");
    fixture_expect(&f, "its dt, to be read:");
    fixture_keys(&f, "fast<Enter>");
    fixture_expect(&f, "fast");
    ck_assert_str_eq(records, "");
    fixture_keys(&f, " 0.05 s<Enter>g<Enter>");
    ck_assert_str_eq(records, "plain.txt:dt=0.05 s:unit=g");
    fixture_expect(&f, "+  plain.txt");
    fixture_keys(&f, "<Down> ");
    ck_assert_str_eq(records, "plain.txt:dt=0.05 s:unit=g,pulse.csv");
    fixture_expect(&f, "suite of 2");
    fixture_keys(&f, "<Up> ");
    ck_assert_str_eq(records, "pulse.csv");
    fixture_keys(&f, "u:peak<Enter>:set record.target en1998:0.3g,B<Enter>cccc");
    fixture_expect(&f, "Spectra of the suite");
    fixture_expect(&f, "90 % of the target");
    fixture_keys(&f, ":vary gap=1 cm:2 cm:1 cm<Enter>6");
    fixture_expect(&f, "2 ground motions");
    fixture_keys(&f, "uuu");
    ck_assert_str_eq(records, "plain.txt:dt=0.05 s:unit=g,pulse.csv");
}
END_TEST

/* Needed gaps and fragility stand there from the third motion on, and grow with each: the last ones are those of a
 * study that was shown only at its end. */
START_TEST(a_fragility_fills_as_the_motions_come_in)
{
    char words[400] = ":records ";
    for (int i = 1; i <= 12; i++)
        snprintf(words + strlen(words), sizeof words - strlen(words), "pulse.csv:peak=0.%02dg%s", 5 * i,
                 i < 12 ? "," : "");
    fixture_keys(&f, ":live off<Enter>:vary gap=1 cm:12 cm:1 cm<Enter>");
    strcat(words, "<Enter>");
    fixture_keys(&f, words);
    fixture_keys(&f, "6");
    thud_tui_key(f.tui, 'r');
    struct thud_live_study *data = &thud_sweep_state(f.tui)->data;
    int before = 0, grew = 0;
    bool seen = false; /* a fast machine has all between two turns */
    while (data->running) {
        thud_tui_turn(f.tui, false);
        int own = data->out.rows.table.nrows > 0 ? thud_sweep_figure_count(&data->out.rows.table) : 0;
        bool told = thud_live_study_figures(data) > own;
        ck_assert_int_eq(told, data->next >= 3 * 12);
        if (!told || data->complete)
            continue;
        seen = true;
        grew += data->told > before;
        before = data->told;
        ck_assert_int_eq(data->told, (int)(data->next / 12));
        struct thud_figure *figure = thud_live_study_figure(data, own);
        ck_assert_int_eq(thud_figure_check(figure, NULL), THUD_OK);
        thud_figure_free(figure);
    }
    ck_assert_int_ge(grew, seen);
    ck_assert(data->complete);
    ck_assert_int_gt(thud_live_study_figures(data), 0);
    ck_assert_int_eq(data->told, 12);
}
END_TEST

/* Ground motions, signs and events are the preset's own too: unsaved is said, undone, saved, and found on opening. */
START_TEST(motions_signs_and_events_are_kept)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:2 cm:1 cm<Enter>w");
    fixture_expect_not(&f, "towers [+]");
    fixture_keys(&f, ":records pulse.csv:peak=0.2 g , pulse.csv:peak=0.6 g<Enter>");
    fixture_expect(&f, "towers [+]");
    fixture_keys(&f, ":signs both<Enter>:events pounding, drift:2 cm<Enter>");
    ck_assert_str_eq(study()->records, "pulse.csv:peak=0.2 g , pulse.csv:peak=0.6 g");
    ck_assert(study()->both_signs);
    fixture_keys(&f, "u");
    ck_assert_str_eq(study()->events, "");
    fixture_keys(&f, "<C-r>w");
    fixture_expect(&f, "Saved");
    fixture_keys(&f, ":signs one<Enter>:events<Enter>:records<Enter>");
    ck_assert_str_eq(study()->records, "");
    ck_assert(!study()->both_signs);
    char open[200];
    snprintf(open, sizeof open, ":open %s/bodies.yaml<Enter>y<A-6>", f.folder);
    fixture_keys(&f, open);
    fixture_expect_not(&f, "both");
    snprintf(open, sizeof open, ":open %s/towers.yaml<Enter>", f.folder);
    fixture_keys(&f, open);
    ck_assert_str_eq(study()->records, "pulse.csv:peak=0.2 g , pulse.csv:peak=0.6 g");
    fixture_expect(&f, "signs    both");
    fixture_expect(&f, "events   pounding, drift");
    fixture_keys(&f, "r");
    fixture_expect(&f, "4 ground motions");
    ck_assert_int_eq(thud_sweep_state(f.tui)->data.fragility.nevents, 2);
    ck_assert_str_eq(thud_sweep_state(f.tui)->data.fragility.event[1].text, "drift:2 cm");
}
END_TEST

/* Lists in brackets are taken, and stay so in the file. */
START_TEST(lists_in_brackets_are_taken)
{
    static char text[8192];
    snprintf(text, sizeof text,
             "%sstudy:\n  vary: gap\n  values: [1 cm, 2 cm]\n"
             "  records: [pulse.csv, \"pulse.csv:peak=0.2 g\"]\n  events: [worse, \"force:5 MN\"]\n",
             fixture_towers);
    fixture_write(&f, "listed.yaml", text);
    snprintf(text, sizeof text, ":open %s/listed.yaml<Enter><A-6>", f.folder);
    fixture_keys(&f, text);
    ck_assert_int_eq(thud_sweep_state(f.tui)->data.records.n, 2);
    ck_assert_str_eq(thud_sweep_state(f.tui)->data.fragility.event[1].text, "force:5 MN");
    fixture_expect(&f, "4 of 4 points");
    fixture_keys(&f, ":signs both<Enter>w");
    fixture_expect(&f, "Saved");
    char *file = fixture_file(&f, "listed.yaml");
    ck_assert_ptr_nonnull(strstr(file, "records: [pulse.csv, \"pulse.csv:peak=0.2 g\"]"));
    ck_assert_ptr_nonnull(strstr(file, "events: [worse, \"force:5 MN\"]"));
    ck_assert_ptr_nonnull(strstr(file, "signs: both"));
    free(file);
}
END_TEST

/* A third structure: the study's gap is one of two, and says which. */
START_TEST(a_structure_more_names_the_studys_interface)
{
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm:2 cm:1 cm<Enter>1A");
    fixture_expect(&f, "the study varies interfaces.1");
    ck_assert_int_eq(f.tui->doc.scene.nstructures, 3);
    ck_assert_str_eq(study()->vary[0].key, "interfaces.1.gap");
    fixture_keys(&f, "6");
    fixture_expect(&f, "2 of 2 points");
    fixture_keys(&f, "u");
    ck_assert_str_eq(study()->vary[0].key, "gap");
}
END_TEST

/* Why it cannot run stays on the screen, and not that it does. */
START_TEST(a_study_that_cannot_begin_says_why)
{
    fixture_keys(&f, "<A-6>:live off<Enter>");
    fixture_lose_motion(&f);
    fixture_keys(&f, "r<Down><Up>");
    fixture_expect(&f, "study.records: no ground");
    fixture_expect_not(&f, "r runs the study");
    fixture_expect(&f, "nothing to show yet");
}
END_TEST

/* Motions that are not there are refused where they are set, and the study keeps those it had. */
START_TEST(motions_that_are_not_there_are_refused)
{
    fixture_keys(&f, "<A-6>:records pulse.csv<Enter>");
    static const char *const wrong[] = {"nowhere.csv", "pulse.csv,nowhere.csv:unit=g", "[pulse.csv, nowhere.list]"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char keys[100];
        snprintf(keys, sizeof keys, ":records %s<Enter>", wrong[i]);
        fixture_keys(&f, keys);
        fixture_expect(&f, "study.records: no ground motion \"nowhere.");
        ck_assert_str_eq(study()->records, "pulse.csv");
    }
}
END_TEST

/* Two of five files cannot be read: one question, and the others are run. */
START_TEST(unreadable_motions_are_skipped)
{
    char keys[200], path[100];
    snprintf(path, sizeof path, "%s/suite", f.folder);
    ck_assert_int_eq(mkdir(path, 0777), 0);
    for (int i = 0; i < 5; i++) {
        char name[32];
        snprintf(name, sizeof name, "suite/%d.csv", i);
        fixture_write(&f, name, i % 2 ? "no numbers here\n" : "time_s,acceleration_g\n0,0\n0.1,0.3\n0.2,0\n");
    }
    snprintf(keys, sizeof keys, "<A-6>:vary gap=1 cm,3 cm<Enter>:records %s<Enter>r", path);
    fixture_keys(&f, keys);
    fixture_expect(&f, "2 of 5 files cannot be read");
    fixture_expect(&f, "Skip");
    fixture_keys(&f, "y");
    fixture_expect(&f, "3 ground motions");
    fixture_expect(&f, "2 files skipped");
    ck_assert_int_eq(thud_sweep_state(f.tui)->data.records.n, 3);
    ck_assert(thud_sweep_state(f.tui)->data.complete);
    for (int i = 0; i < 5; i++) {
        snprintf(keys, sizeof keys, "%s/%d.csv", path, i);
        remove(keys);
    }
    ck_assert_int_eq(rmdir(path), 0);
}
END_TEST

/* Of a linear law the force goes with the speed: half of it at half the speed. */
START_TEST(a_value_is_solved_for)
{
    fixture_close(&f);
    fixture_open(&f, "bodies", 80, 24, true);
    double force = thud_live_force(&f.tui->run.live, THUD_LIVE_NONE, 0, &(int){0}), found;
    char keys[160];
    fixture_keys(&f, "/structures.1.velocity<Enter>G");
    fixture_expect(&f, "0.167 m/s");
    snprintf(keys, sizeof keys, "force <lt> %.9g MN<Tab>0.1 m/s<Tab>0.7 m/s<Enter>", 0.5e-6 * force);
    fixture_keys(&f, keys);
    fixture_expect(&f, "holds up to structures.1.velocity");
    fixture_keys(&f, "<Enter>");
    found = f.tui->doc.scene.structure[0].velocity_mps;
    ck_assert_msg(found < 0.25 && found > 0.25 - 0.0011 * 0.6, "%.9g", found);
    fixture_keys(&f, "u:solve pounding; gap=0 cm:5 cm<Enter>"); /* it does at every gap */
    fixture_expect(&f, "holds at every value");
    ck_assert_double_eq_tol(f.tui->doc.scene.structure[0].velocity_mps, 0.5, 1e-15);
    fixture_keys(&f, ":solve force; gap=0 cm:5 cm<Enter>");
    fixture_expect(&f, "is not understood");
}
END_TEST

/* What is there already and was not written here is not written over. */
START_TEST(tables_of_others_stay)
{
    fixture_write(&f, "towers-sweep-contacts.csv", "mine\n");
    fixture_keys(&f, "<A-6><Enter><C-u>gap=1 cm,3 cm<Enter>");
    fixture_keys(&f, "e");
    fixture_expect(&f, "Written towers-sweep-2.csv");
    char *csv = fixture_file(&f, "towers-sweep-contacts.csv");
    ck_assert_str_eq(csv, "mine\n");
    free(csv);
    fixture_keys(&f, "e"); /* its own are */
    fixture_expect(&f, "Written towers-sweep-2.csv");
}
END_TEST

/* Cases alone are not a whole study: the screen proposes the range of gaps with them, but for a suite of motions. */
START_TEST(cases_keep_the_proposed_range)
{
    struct thud_scene scene = f.tui->doc.scene;
    char vary[THUD_VARY_MAX][THUD_VARY_TEXT];
    memset(&scene.study, 0, sizeof scene.study);
    ck_assert_int_eq(thud_scene_set(&scene, "study.cases", "none", NULL), THUD_OK);
    thud_study_vary_texts(&scene, vary);
    ck_assert_str_eq(vary[0], "gap=5 cm:25 cm:1 cm");
    ck_assert_ptr_null(thud_study_proposed_cases(&scene));
    ck_assert_int_eq(thud_scene_set(&scene, "study.records", "motions.list", NULL), THUD_OK);
    thud_study_vary_texts(&scene, vary);
    ck_assert_str_eq(vary[0], "");
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("tui study");
    TCase *words = tcase_create("study");
    tcase_set_timeout(words, 60.0);
    tcase_add_checked_fixture(words, setup, teardown);
    tcase_add_test(words, a_range_becomes_the_presets_study);
    tcase_add_test(words, what_is_saved_is_the_same_study);
    tcase_add_test(words, a_spread_is_kept_and_run);
    tcase_add_test(words, no_bumper_is_run_once_for_all_thicknesses);
    tcase_add_test(words, wrong_words_are_refused);
    tcase_add_test(words, a_list_is_kept);
    tcase_add_test(words, a_list_too_long_is_run_but_not_kept);
    tcase_add_test(words, edits_make_a_study_old);
    tcase_add_test(words, the_study_fills_by_itself);
    tcase_add_test(words, the_figure_is_of_the_study_as_it_is);
    tcase_add_test(words, panels_without_a_ratio_are_passed_over);
    tcase_add_test(words, a_long_study_waits);
    tcase_add_test(words, the_cursor_sets_the_gap);
    tcase_add_test(words, a_suite_has_its_statistics);
    tcase_add_test(words, motions_signs_and_events_are_kept);
    tcase_add_test(words, a_suite_is_put_together_on_the_record_screen);
    tcase_add_test(words, a_fragility_fills_as_the_motions_come_in);
    tcase_add_test(words, lists_in_brackets_are_taken);
    tcase_add_test(words, a_structure_more_names_the_studys_interface);
    tcase_add_test(words, a_study_that_cannot_begin_says_why);
    tcase_add_test(words, motions_that_are_not_there_are_refused);
    tcase_add_test(words, unreadable_motions_are_skipped);
    tcase_add_test(words, a_value_is_solved_for);
    tcase_add_test(words, tables_of_others_stay);
    tcase_add_test(words, cases_keep_the_proposed_range);
    suite_add_tcase(suite, words);
    return suite;
}
