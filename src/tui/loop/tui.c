#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/run/command.h"
#include "tui/document/command_work.h"
#include "tui/document/session_log.h"
#include "tui/loop/loop.h"
#include "tui/loop/new_scene.h"
#include "tui/loop/verdict.h"

static const double slice_s = 0.012, redraw_s = 0.05, live_limit_s = 1.0, history_limit_s = 4.0;

/* Those of the list, and one more. */
static enum thud_status take_screens(struct thud_tui *tui, struct thud_error *err)
{
    for (int i = 0; i <= THUD_SCREENS; i++) {
        const struct thud_view *view = i < THUD_SCREENS ? thud_views[i] : tui->options.view;
        if (!view)
            break;
        tui->own[i] = calloc(1, view->size > 0 ? view->size : 1);
        if (!tui->own[i])
            return thud_error_set(err, THUD_MEMORY, "no memory for the screens");
        tui->view[i] = view;
        tui->screens = i + 1;
    }
    return THUD_OK;
}

enum thud_status thud_tui_create(const struct thud_tui_options *options, struct thud_backend *backend,
                                 struct thud_tui **out, struct thud_error *err)
{
    struct thud_tui *tui = calloc(1, sizeof *tui);
    if (!tui)
        return thud_error_set(err, THUD_MEMORY, "no memory for the screens");
    tui->backend = backend;
    tui->doc.paths = options->paths;
    tui->canvas.ascii = !backend->utf8;
    tui->canvas.hues = backend->hues;
    tui->mouse = true;
    thud_tui_redraw(tui, true);
    for (int i = 0; i <= THUD_SCREENS; i++)
        tui->reading[i] = NAN;
    tui->options = *options;
    tui->run.usual = !options->live_off;
    enum thud_status status = take_screens(tui, err);
    if (status == THUD_OK)
        status = thud_doc_open(&tui->doc, options->preset ? options->preset : "towers", err);
    if (status == THUD_OK && options->scene)
        status = thud_doc_change(&tui->doc, options->scene, "the options given at the start", err);
    if (status == THUD_OK)
        status = thud_canvas_resize(&tui->canvas, 1, 1, err);
    if (status != THUD_OK) {
        thud_tui_free(tui);
        return status;
    }
    thud_tui_opened(tui);
    thud_tui_log(tui, "open %s", options->preset ? options->preset : "towers");
    thud_tui_offer_recovery(tui);
    if (options->fresh && tui->dialog.mode == THUD_MODE_NORMAL)
        thud_new_scene_begin(tui);
    *out = tui;
    return THUD_OK;
}

void thud_tui_free(struct thud_tui *tui)
{
    if (!tui)
        return;
    thud_tui_writing_end(tui);
    if (tui->files.command) {
        struct thud_text printed = {0}, said = {0};
        thud_command_work_stop(tui->files.command);
        thud_command_work_finish(tui->files.command, &printed, &said);
        thud_text_clear(&printed);
        thud_text_clear(&said);
    }
    thud_tui_forget_made(tui);
    thud_live_clear(&tui->run.live);
    for (int i = 0; i < tui->screens; i++) {
        if (tui->view[i]->free)
            tui->view[i]->free(tui);
        free(tui->own[i]);
    }
    thud_tui_over_free(tui);
    thud_base_clear(&tui->base);
    thud_designs_clear(&tui->designs);
    thud_text_clear(&tui->messages);
    thud_model_free(tui->run.model);
    thud_doc_free(&tui->doc);
    thud_form_free(&tui->form);
    thud_chooser_free(&tui->dialog.chooser);
    thud_canvas_free(&tui->canvas);
    free(tui);
}

static void prompt_done(struct thud_tui *tui)
{
    char text[THUD_LINE_MAX];
    memcpy(text, tui->dialog.line.text, sizeof text);
    thud_tui_normal(tui);
    thud_tui_hush(tui);
    tui->dialog.prompt->done(tui, text);
}

static void typing_key(struct thud_tui *tui, int key)
{
    enum thud_action action = thud_key_action(thud_tui_where(tui), key);
    bool field = thud_tui_types_field(tui);
    if (action == THUD_DO_CANCEL) {
        thud_tui_normal(tui);
        thud_tui_hush(tui);
        tui->dialog.after_save = NULL; /* nothing was saved */
    } else if (!field && thud_tui_prompt_key(tui, key)) {
        return;
    } else if (action == THUD_DO_ACCEPT && !field) {
        prompt_done(tui);
    } else if (action == THUD_DO_ACCEPT) {
        thud_tui_accept(tui);
    } else if (action == THUD_DO_ACCEPT_NEXT || action == THUD_DO_ACCEPT_PREVIOUS || action == THUD_DO_ACCEPT_DOWN ||
               action == THUD_DO_ACCEPT_UP) {
        if (field)
            thud_tui_accept_and_go(tui, action);
    } else {
        thud_line_key(&tui->dialog.line, key);
    }
}

static void choosing_key(struct thud_tui *tui, int key)
{
    enum thud_action action = thud_key_action(thud_tui_where(tui), key);
    if (action == THUD_DO_CANCEL)
        thud_tui_normal(tui);
    else if (action == THUD_DO_ACCEPT)
        thud_tui_chosen(tui);
    else
        thud_chooser_key(&tui->dialog.chooser, key);
}

static void answered(struct thud_tui *tui, int key)
{
    const struct thud_question *question = tui->dialog.question;
    bool yes = key == 'y' || key == 'Y' || (question->enter && key == THUD_KEY_ENTER),
         no = key == 'n' || key == 'N' || key == THUD_KEY_ESC;
    bool save = question->unsaved && (key == 's' || key == 'S');
    char target[sizeof tui->dialog.target];
    if (!yes && !no && !save)
        return;
    memcpy(target, tui->dialog.target, sizeof target);
    thud_tui_normal(tui);
    thud_tui_hush(tui);
    if (save) {
        tui->dialog.after_save = question;
        memcpy(tui->dialog.after_target, target, sizeof target);
        thud_tui_save(tui, NULL, false);
    } else if (yes)
        question->yes(tui, target);
}

/* A digit goes to its screen, always (also after g, or with Alt); the rest are actions. */
static void normal_key(struct thud_tui *tui, int key)
{
    int digit = key >= '1' && key <= '9'                                ? key - '1'
                : key > THUD_KEY_ALT + '0' && key <= THUD_KEY_ALT + '9' ? key - THUD_KEY_ALT - '1'
                                                                        : -1;
    if (digit >= 0) {
        if (digit < tui->screens)
            thud_tui_go(tui, digit);
        else
            thud_tui_say(tui, THUD_ROLE_WARN, "There is no screen %d: 1 to %d", digit + 1, tui->screens);
        return;
    }
    enum thud_action action = thud_key_action(thud_tui_where(tui), key);
    char glyph[5];
    if (action != THUD_DO_NOTHING) {
        thud_tui_act(tui, action);
    } else if (key > ' ' && key < THUD_KEY_FIRST && key != THUD_KEY_BACKSPACE) {
        glyph[thud_utf8_put((uint32_t)key, glyph)] = '\0';
        thud_tui_say(tui, THUD_ROLE_PLAIN, "%s does nothing here; ? lists the keys", glyph);
    }
}

/* On a terminal too small to show anything only what leads out is heard. */
static bool heard(struct thud_tui *tui, int key)
{
    return !thud_tui_too_small(tui) || tui->dialog.mode == THUD_MODE_ASKING || key == THUD_KEY_HANGUP ||
           key == THUD_CTRL('c') || (key == 'q' && tui->dialog.mode == THUD_MODE_NORMAL);
}

/* Ctrl-C ends as the signal would, but asks first where something is unsaved. */
static void interrupt(struct thud_tui *tui)
{
    if (tui->dialog.mode != THUD_MODE_ASKING)
        thud_tui_normal(tui);
    thud_tui_quit(tui, false);
    tui->end.interrupted = tui->end.quit;
}

static void key_of_mode(struct thud_tui *tui, int key)
{
    switch (tui->dialog.mode) {
    case THUD_MODE_TYPING:
        typing_key(tui, key);
        break;
    case THUD_MODE_CHOOSING:
        choosing_key(tui, key);
        break;
    case THUD_MODE_ASKING:
        answered(tui, key);
        break;
    case THUD_MODE_OVER:
        tui->dialog.over->key(tui, key);
        break;
    case THUD_MODE_NORMAL:
        normal_key(tui, key);
        break;
    }
}

static void take_key(struct thud_tui *tui, int key)
{
    if (tui->files.picture != THUD_IMAGE_NONE) {
        thud_tui_leave_picture(tui);
        if (key != THUD_CTRL('c') && key != THUD_KEY_HANGUP)
            return;
    }
    if (key == THUD_KEY_RESIZE || !heard(tui, key))
        return;
    tui->again = key == tui->key;
    tui->key = key;
    if (key == THUD_KEY_HANGUP) {
        tui->end.hangup = tui->end.quit = true;
    } else if (key == THUD_CTRL('c')) {
        interrupt(tui);
    } else if (key == THUD_KEY_CLICK) {
        thud_tui_click(tui);
    } else if (key == THUD_KEY_DRAG) {
        thud_tui_drag(tui);
    } else if (key == THUD_KEY_WHEEL_UP || key == THUD_KEY_WHEEL_DOWN) {
        thud_tui_wheel(tui, key == THUD_KEY_WHEEL_UP ? -1 : 1);
    } else if (key == THUD_KEY_PASTE) {
        thud_tui_paste(tui, tui->backend->paste);
    } else {
        key_of_mode(tui, key);
    }
}

/* What a list, a form or a command asked for. */
static void do_next(struct thud_tui *tui)
{
    const enum thud_action next = tui->dialog.next;
    tui->dialog.next = THUD_DO_NOTHING;
    if (next != THUD_DO_NOTHING)
        thud_tui_act(tui, next);
}

/* What the key changed is followed, and the fields it led to are known, before the next one. */
void thud_tui_key(struct thud_tui *tui, int key)
{
    thud_tui_redraw(tui, false);
    take_key(tui, key);
    do_next(tui);
    thud_tui_follow(tui);
    if (tui->redraw.edits != tui->doc.edits || tui->redraw.screen != tui->screen)
        thud_tui_draw(tui);
}

/* A screen with work of its own, shown or not; NULL: none has any. */
static const struct thud_view *busy_view(struct thud_tui *tui)
{
    for (int i = 0; i < tui->screens; i++)
        if (tui->view[i]->busy && tui->view[i]->busy(tui))
            return tui->view[i];
    return NULL;
}

static bool over_busy(const struct thud_tui *tui)
{
    return tui->dialog.mode == THUD_MODE_OVER && tui->dialog.over->busy && tui->dialog.over->busy(tui);
}

/* Whether the state to compare with is still to be run, or to be run with its histories. */
static bool comparing(const struct thud_tui *tui)
{
    return tui->run.on && tui->run.revision == tui->doc.revision && thud_tui_view(tui)->compares &&
           thud_base_busy(&tui->base, &tui->doc, thud_tui_wants_history(tui));
}

/* The live run has ended: does what waited for it, and reports a failure. */
static void end_live_run(struct thud_tui *tui)
{
    enum thud_action action = tui->files.whole_wanted;
    const char *what = thud_undo_what(&tui->doc.undo, 0);
    struct thud_design_result result;
    thud_design_measure(&tui->doc.scene, &tui->run.live, &result);
    const struct thud_design *design =
        result.known && tui->run.revision == tui->doc.revision
            ? thud_designs_note(&tui->designs, &tui->doc.scene, what ? what : "as opened", &result)
            : NULL;
    tui->run.design = design ? design->number : 0;
    tui->files.whole_wanted = THUD_DO_NOTHING;
    if (tui->files.pictures_wanted)
        thud_tui_pictures(tui);
    if (action != THUD_DO_NOTHING)
        thud_tui_draw(tui); /* what is seen is what is written */
    if (action != THUD_DO_NOTHING && !thud_tui_cannot(tui, action))
        thud_tui_act(tui, action);
    const struct thud_live_case *c = thud_live_failed(&tui->run.live);
    if (c) {
        const enum thud_live_which which = (enum thud_live_which)(c - tui->run.live.which);
        char text[600], when[40] = "";
        if (c->run)
            snprintf(when, sizeof when, " at t = %.4g s", c->failed_s);
        thud_tui_say(tui, THUD_ROLE_ERROR, "! FAILED (%s)%s: %s", thud_tui_case_name(tui, which), when,
                     thud_tui_error_text(&c->error, text, sizeof text));
    }
}

/* Works for one slice; what takes long says so. */
static void work(struct thud_tui *tui)
{
    double start = tui->backend->now(tui->backend), now = start;
    const struct thud_view *view = busy_view(tui);
    unsigned long ended = tui->run.live.ended;
    for (int i = 0; i < 64 && now - start < slice_s; i++) {
        if (tui->run.live.running) {
            thud_live_advance(&tui->run.live);
            now = tui->backend->now(tui->backend);
            break; /* keys are looked for in between */
        } else if (comparing(tui)) {
            if (!thud_base_advance(&tui->base, &tui->doc, thud_tui_wants_history(tui)))
                thud_tui_redraw(tui, false);
        } else if (over_busy(tui)) {
            tui->dialog.over->work(tui);
        } else if (!view || !view->work(tui)) {
            if (view)
                thud_tui_redraw(tui, false);
            break;
        }
        now = tui->backend->now(tui->backend);
    }
    double limit_s = tui->run.live.history ? history_limit_s : live_limit_s;
    if (tui->run.live.running && tui->run.on && now - tui->run.started_s > limit_s) {
        tui->run.on = false;
        thud_tui_log(tui, "live off");
        thud_tui_say(tui, THUD_ROLE_WARN, "A run takes over %g s: after an edit, r runs (:live turns this back)",
                     limit_s);
    }
    if (!tui->run.live.running && tui->run.was_running) {
        tui->run.elapsed_s = now - tui->run.started_s;
        if (!tui->run.live.history)
            tui->run.plain_s = tui->run.elapsed_s;
        end_live_run(tui);
        thud_tui_redraw(tui, false);
    }
    tui->run.was_running = tui->run.live.running;
    if (tui->run.live.ended != ended || now - tui->redraw.drawn_s >= redraw_s)
        thud_tui_redraw(tui, tui->run.live.ended != ended);
}

/* A crash, a signal or a closed terminal loses nothing then. */
static void keep_edits(struct thud_tui *tui)
{
    struct thud_error err;
    tui->end.kept_edits = tui->doc.edits;
    if (!thud_doc_unsaved(&tui->doc)) {
        thud_doc_forget_kept(&tui->doc);
        return;
    }
    bool failed = thud_doc_recover(&tui->doc, &err) != THUD_OK;
    if (failed && !tui->end.keeping_failed) {
        char text[600];
        thud_tui_say(tui, THUD_ROLE_WARN, "! Unsaved changes cannot be kept, and a crash would lose them: %s",
                     thud_error_text(&err, text, sizeof text));
    }
    tui->end.keeping_failed = failed;
}

/* Notifies a user in another window when a long computation has ended. */
static void notice(struct thud_tui *tui, bool making)
{
    static const double long_s = 10.0;
    static const char ended[] = "\033]9;thud: the study has ended\a\033]777;notify;thud;the study has ended\a";
    const double now_s = tui->backend->now(tui->backend);
    if (making && tui->busy_since_s == 0.0)
        tui->busy_since_s = now_s;
    if (making || tui->busy_since_s == 0.0)
        return;
    if (now_s - tui->busy_since_s > long_s)
        tui->backend->raw(tui->backend, ended, sizeof ended - 1);
    tui->busy_since_s = 0.0;
}

bool thud_tui_turn(struct thud_tui *tui, bool wait)
{
    do_next(tui); /* of a command that no key gave */
    thud_tui_follow(tui);
    notice(tui, busy_view(tui) != NULL || over_busy(tui) || tui->files.work || tui->files.command);
    const struct thud_view *view = thud_tui_view(tui);
    if (view->live && tui->run.on && !tui->run.live.running && !tui->run.was_running && !tui->end.quit)
        view->live(tui);
    bool busy =
        tui->run.live.running || tui->run.was_running || busy_view(tui) != NULL || over_busy(tui) || comparing(tui);
    double pause = view->pause ? view->pause(tui) : -1.0;
    if (tui->redraw.wanted &&
        (!busy || tui->redraw.now || tui->backend->now(tui->backend) - tui->redraw.drawn_s >= redraw_s))
        thud_tui_draw(tui);
    bool keep = tui->end.keeps && tui->end.kept_edits != tui->doc.edits;
    int timeout = busy || keep || !wait ? 0 : pause >= 0.0 ? (int)(1e3 * pause) + 1 : -1;
    int key = tui->backend->key(tui->backend, timeout);
    if (tui->files.work)
        thud_tui_writing_look(tui);
    if (tui->files.report_wanted && !tui->files.work && tui->dialog.mode == THUD_MODE_NORMAL) {
        tui->files.report_wanted = false;
        thud_tui_verb_form(tui, THUD_COMMAND_REPORT);
    }
    if (tui->files.command)
        thud_tui_verb_look(tui);
    if (key != THUD_KEY_NONE)
        thud_tui_key(tui, key);
    else if (keep)
        keep_edits(tui);
    else if (busy)
        work(tui);
    else if (pause >= 0.0 && view->tick) {
        view->tick(tui);
        thud_tui_redraw(tui, false);
    }
    return key != THUD_KEY_NONE || keep || busy;
}
