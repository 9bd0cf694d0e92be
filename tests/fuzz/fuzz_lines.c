/* Any bytes as a file that is read line by line, by its first byte: a list of ground motions (L), a hazard curve (H), a
 * session to be played (P). What is taken is sound; what is refused says where and why, and nothing is lost behind a
 * byte 0. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/run/record_list.h"
#include "app/sweep/fragility_report.h"
#include "tui/loop/loop.h"
#include "tui/loop/play.h"

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { PLAYED_MAX = 300 };
static char folder[] = "/tmp/thud-lines-XXXXXX";
static struct thud_paths paths;

static void must(int holds)
{
    if (!holds)
        abort();
}

static void write_file(const char *name, const void *bytes, size_t size)
{
    FILE *file = fopen(name, "w");
    must(file && fwrite(bytes, 1, size, file) == size && fclose(file) == 0);
}

static void write_text(const char *name, const char *text)
{
    write_file(name, text, strlen(text));
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    must(mkdtemp(folder) != NULL && chdir(folder) == 0);
    strcpy(paths.presets, folder);
    strcpy(paths.records, folder);
    write_text("a.csv", "time_s,acceleration_g\n0,0\n0.1,0.5\n0.2,-0.5\n0.3,0.25\n0.4,0\n");
    return 0;
}

static void check(enum thud_status status, const struct thud_error *err, int zero)
{
    must(!zero || status == THUD_INPUT);
    must(status == THUD_OK || (err->what[0] && (status == THUD_INPUT || status == THUD_USAGE)));
}

static void list(int zero)
{
    static struct thud_session session; /* large */
    struct thud_record_list motions;
    struct thud_error err = {0};
    session.paths = paths;
    thud_scene_init(&session.scene);
    enum thud_status status = thud_record_list_read(&session, "x.list", NULL, 0, false, &motions, &err);
    check(status, &err, zero);
    must((status == THUD_OK) == (motions.n > 0));
    for (int i = 0; i < motions.n; i++)
        for (size_t k = 0; k < motions.record[i]->samples; k++)
            must(isfinite(motions.record[i]->a_mps2[k]));
    thud_record_list_clear(&motions);
}

static void hazard(int zero)
{
    struct thud_sweep_axis axis = {.key = "record.peak"};
    struct thud_scene *scene = malloc(sizeof *scene);
    struct thud_hazard curve;
    struct thud_error err = {0};
    int floor;
    must(scene != NULL);
    thud_scene_init(scene);
    axis.param = thud_scene_param(scene, axis.key, &floor);
    enum thud_status status = thud_hazard_read("x.list", &axis, &curve, &err);
    check(status, &err, zero);
    for (int i = 1; status == THUD_OK && i < (int)curve.n; i++)
        must(curve.x[i] > curve.x[i - 1] && curve.rate[i] <= curve.rate[i - 1] && isfinite(curve.x[i]));
    if (status == THUD_OK)
        thud_hazard_clear(&curve);
    free(scene);
}

static void play(int zero)
{
    struct thud_backend backend;
    struct thud_script script;
    struct thud_tui *tui;
    struct thud_text out = {0};
    struct thud_error err = {0};
    struct thud_tui_options options = {.preset = "0.yaml", .paths = &paths, .output = folder, .gnuplot = "/bin/false"};
    write_text("0.yaml", "title: Two free bodies\nstructures:\n"
                         "  - {name: L, kind: rigid, mass: 320 t, velocity: 0.5 m/s}\n"
                         "  - {name: R, kind: rigid, mass: 320 t}\n"
                         "interfaces:\n  - gap: 0 cm\n"
                         "    contact: {law: kelvin-voigt-no-tension, stiffness: 2500 kN/mm, restitution: 0.6}\n"
                         "analysis: {tail: 0.2 s}\n");
    thud_script_open(&backend, &script, 80, 24, true);
    must(thud_tui_create(&options, &backend, &tui, &err) == THUD_OK);
    check(thud_tui_play_lines(tui, "x.list", &out, &err), &err, zero);
    must(thud_scene_check(&tui->doc.scene, &err) == THUD_OK);
    for (size_t i = 0; i < out.size; i++)
        must(out.data[i] != '\033' && out.data[i] != '\0');
    thud_text_clear(&out);
    thud_tui_free(tui);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size < 1 || memchr(data, '/', size)) /* files elsewhere are not touched */
        return 0;
    int zero = memchr(data + 1, '\0', size - 1) != NULL;
    write_file("x.list", data + 1, size - 1);
    if (data[0] == 'P' && size <= PLAYED_MAX)
        play(zero);
    else if (data[0] == 'H')
        hazard(zero);
    else if (data[0] == 'L')
        list(zero);
    return 0;
}
