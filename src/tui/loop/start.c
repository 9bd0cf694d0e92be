/* From the start to the end of the terminal interface: the terminal is opened and restored, or a session is played. */
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include "tui/loop/play.h"
#include "tui/terminal/config.h"

/* Ended by a signal or a lost terminal: what was not saved goes to a file beside the preset. */
static void rescue(struct thud_tui *tui)
{
    struct thud_error err;
    char text[600];
    if (!thud_doc_unsaved(&tui->doc))
        return;
    if (thud_doc_recover(&tui->doc, &err) == THUD_OK)
        fprintf(stderr, "thud: unsaved changes are kept in %s\n", tui->doc.kept);
    else if (*tui->doc.kept) /* an edit before */
        fprintf(stderr, "thud: the last unsaved change is lost (%s); those before it are kept in %s\n",
                thud_error_text(&err, text, sizeof text), tui->doc.kept);
    else
        fprintf(stderr, "thud: unsaved changes are lost: %s\n", thud_error_text(&err, text, sizeof text));
}

/* On a terminal a session is played and then goes on by hand. */
static void play_first(struct thud_tui *tui)
{
    struct thud_text out = {0};
    struct thud_error err = {0};
    thud_tui_normal(tui);
    if (thud_tui_play_lines(tui, tui->options.play, &out, &err) != THUD_OK)
        thud_tui_say_error(tui, &err);
    thud_text_clear(&out);
}

enum thud_status thud_tui_main(const struct thud_tui_options *options, struct thud_error *err)
{
    struct thud_backend backend;
    struct thud_tui *tui;
    struct thud_paths paths;
    struct thud_tui_options all = *options;
    if (!all.paths) {
        thud_paths_find(&paths);
        all.paths = &paths;
    }
    struct thud_config config;
    char config_path[512];
    thud_config_init(&config);
    thud_config_path(config_path, sizeof config_path);
    enum thud_status status = thud_config_read(&config, config_path, err);
    if (status != THUD_OK)
        return status;
    all.ascii |= config.ascii;
    all.color &= config.color;
    config.ascii = all.ascii;
    config.color = all.color;
    all.live_off = !config.live;
    if (*config.folder && !all.output)
        all.output = config.folder;
    if (options->play && !(isatty(STDIN_FILENO) && isatty(STDOUT_FILENO)))
        return thud_tui_play(&all, err);
    status = thud_term_open(&backend, &config, err);
    if (status != THUD_OK)
        return status;
    status = thud_tui_create(&all, &backend, &tui, err);
    if (status == THUD_OK && options->play)
        play_first(tui);
    if (status != THUD_OK) {
        thud_term_close(&backend);
        return status;
    }
    tui->end.keeps = true;
    tui->mouse = config.mouse;
    backend.mouse(&backend, tui->mouse);
    int number = 0;
    while (!tui->end.quit && (number = backend.signal(&backend)) == 0)
        thud_tui_turn(tui, true);
    if (!number)
        number = tui->end.hangup ? SIGHUP : tui->end.interrupted ? SIGINT : 0;
    sigset_t fatal, before; /* a second one, as a closing terminal sends, must not cut off the rescue */
    sigemptyset(&fatal);
    sigaddset(&fatal, SIGHUP);
    sigaddset(&fatal, SIGINT);
    sigaddset(&fatal, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &fatal, &before);
    thud_term_close(&backend);
    if (number && !tui->end.interrupted)
        rescue(tui);
    else
        thud_doc_forget_kept(&tui->doc);
    thud_tui_free(tui);
    if (number) {
        signal(number, SIG_DFL);
        raise(number);
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return THUD_OK;
}
