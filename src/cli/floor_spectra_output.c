#include "cli/study_output.h"

#include <stdlib.h>
#include <string.h>

#include "app/run/figure_files.h"
#include "app/run/result_table.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "io/file/file.h"
#include "io/result/floor_spectra_file.h"
#include "plot/figures/figures_floor.h"

/* The number of pieces grows without bound for shorter periods, where the response is the floor's peak acceleration. */
static const double shortest_s = 1e-3;

enum thud_status thud_cli_no_floor_spectra(const struct thud_args *args, struct thud_error *err)
{
    static const char *const own[] = {"floor", "periods"};
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (thud_args_has(args, own[i]))
            return thud_error_set(err, THUD_USAGE, "--%s without --floor-spectra", own[i]);
    return THUD_OK;
}

/* NAME.FLOOR */
static enum thud_status place_of(const struct thud_scene *scene, const char *text, struct thud_floor_place *out,
                                 struct thud_error *err)
{
    const char *dot = strrchr(text, '.');
    char *end = NULL;
    long floor = dot ? strtol(dot + 1, &end, 10) : 0;
    out->floor = floor > 0 && floor <= THUD_STOREYS_MAX && !*end ? (int)floor - 1 : -1;
    for (out->structure = 0; dot && out->structure < scene->nstructures; out->structure++) {
        const char *name = scene->structure[out->structure].name;
        if (strlen(name) == (size_t)(dot - text) && strncmp(name, text, strlen(name)) == 0 && out->floor >= 0)
            return THUD_OK;
    }
    thud_error_set(err, THUD_USAGE, "no floor is called \"%s\"", text);
    thud_error_allow(err, "a structure's name, a dot and the floor's number from 1, such as %s.1",
                     scene->structure[0].name);
    return thud_args_wrong("floor", err);
}

static enum thud_status read_ask(const struct thud_args *args, const struct thud_scene *scene,
                                 struct thud_floor_spectra_ask *ask, struct thud_floor_place *place,
                                 struct thud_error *err)
{
    static const char *const alone[] = {"case", "cases", "events", "sensitivity"};
    struct thud_spectrum_choice choice = {.from_s = 0.02, .to_s = 4, .count = 100};
    const char *text;
    enum thud_status status = THUD_OK;
    for (size_t i = 0; i < sizeof alone / sizeof *alone; i++)
        if (thud_args_has(args, alone[i]))
            return thud_error_set(err, THUD_USAGE, "--floor-spectra and --%s together", alone[i]);
    status = thud_spectrum_options_read(args, "floor-spectra", &choice, err);
    if (status == THUD_OK && !(choice.damping > 0))
        return thud_error_refuse(err, THUD_USAGE, "--floor-spectra", "above 0 and below 1",
                                 "oscillators without damping");
    if (status == THUD_OK && choice.from_s < shortest_s) {
        thud_error_set(err, THUD_USAGE, "a period of %g s", choice.from_s);
        thud_error_allow(err, "%g s or more", shortest_s);
        return thud_args_wrong("periods", err);
    }
    *ask = (struct thud_floor_spectra_ask){choice.damping, choice.from_s, choice.to_s, choice.count, 0, place};
    while (status == THUD_OK && (text = thud_args_repeated(args, "floor", ask->nfloors))) {
        status = place_of(scene, text, &place[ask->nfloors], err);
        ask->nfloors++;
    }
    return status;
}

static enum thud_status write_files(const struct thud_args *args, const struct thud_scene *scene,
                                    const struct thud_floor_spectra *spectra, struct thud_picture_choice *picture,
                                    const struct thud_made_by *by, struct thud_error *err)
{
    const char *folder = thud_args_value(args, "o");
    struct thud_text text = {0};
    enum thud_status status = thud_made_by_begin(by, err);
    thud_floor_spectra_csv(scene, spectra, &text);
    status = thud_text_save(&text, folder, "floor-spectra.csv", status, err);
    picture->options.no_data = true; /* they stand in that file */
    picture->options.cancel = thud_interrupt_watch();
    status = thud_figure_deliver(thud_figure_of_floors(scene, spectra), folder, &picture->options, status, err);
    return thud_made_by_end(by, status, err);
}

static enum thud_status print(const struct thud_args *args, const struct thud_scene *scene,
                              const struct thud_floor_spectra *spectra, struct thud_error *err)
{
    struct thud_text text = {0};
    (thud_args_has(args, "json")  ? thud_floor_spectra_json
     : thud_args_has(args, "csv") ? thud_floor_spectra_csv
                                  : thud_floor_table)(scene, spectra, &text);
    return thud_cli_print_as(args, &text, THUD_OK, err);
}

enum thud_status thud_cli_floor_spectra(const struct thud_args *args, struct thud_session *session,
                                        struct thud_error *err)
{
    static const char *const asked[] = {"floor-spectra", "floor", "periods", NULL};
    struct thud_floor_place place[THUD_GIVEN_MAX];
    struct thud_floor_spectra_ask ask;
    struct thud_floor_spectra *spectra = NULL;
    struct thud_picture_choice picture;
    struct thud_made_by by;
    enum thud_status status = thud_picture_options_read(args, &picture, err);
    if (status == THUD_OK)
        status = read_ask(args, &session->scene, &ask, place, err);
    if (status == THUD_OK)
        status = thud_session_read_record(session, err);
    if (status == THUD_OK)
        status = thud_made_by_scene(args, "floors", &session->scene,
                                    (const struct thud_record *const *)&session->record, 1, asked, &by, err);
    if (status == THUD_OK)
        status = thud_scene_check(&session->scene, err);
    if (status == THUD_OK)
        status = thud_floor_spectra_run(&session->scene, session->record, &ask, &spectra, err);
    if (status == THUD_OK)
        status = print(args, &session->scene, spectra, err);
    if (status == THUD_OK && thud_args_has(args, "o"))
        status = write_files(args, &session->scene, spectra, &picture, &by, err);
    thud_floor_spectra_free(spectra);
    return status;
}
