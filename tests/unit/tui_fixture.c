#include <check.h>
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/quantity.h"
#include "tui_fixture.h"

const char *const fixture_towers = "# two towers, for tests\n"
                                   "title: Two towers\n"
                                   "record:\n"
                                   "  file: pulse.csv    # a sine\n"
                                   "  peak: 0.6 g\n"
                                   "structures:\n"
                                   "  - name: A\n"
                                   "    kind: shear\n"
                                   "    mass: [320 t, 250 t]   # two floors\n"
                                   "    stiffness: 600 MN/m\n"
                                   "    storeys: 2\n"
                                   "    height: 3 m\n"
                                   "    damping: 5 %\n"
                                   "  - name: B\n"
                                   "    kind: shear\n"
                                   "    storeys: 3\n"
                                   "    mass: [320 t, 320 t, 250 t]\n"
                                   "    stiffness: 400 MN/m\n"
                                   "    height: 3 m\n"
                                   "    damping: 5 %\n"
                                   "interfaces:\n"
                                   "  - gap: 2 cm   # concrete to concrete\n"
                                   "    contact:\n"
                                   "      law: kelvin-voigt-no-tension\n"
                                   "      stiffness: 2500 kN/mm\n"
                                   "      restitution: 0.6\n"
                                   "    bumper:\n"
                                   "      law: rubber\n"
                                   "      thickness: 1 cm\n"
                                   "      stiffness: 0.36 kN/mm^2.65\n"
                                   "      exponent: 2.65\n"
                                   "      restitution: 0.5\n"
                                   "analysis:\n"
                                   "  tail: 1 s\n";

static const char *const bodies = "title: Two rigid bodies\n"
                                  "structures:\n"
                                  "  - name: L\n"
                                  "    kind: rigid\n"
                                  "    mass: 320 t\n"
                                  "    velocity: 0.5 m/s\n"
                                  "  - name: R\n"
                                  "    kind: rigid\n"
                                  "    mass: 320 t\n"
                                  "interfaces:\n"
                                  "  - gap: 0 cm\n"
                                  "    contact:\n"
                                  "      law: kelvin-voigt-no-tension\n"
                                  "      stiffness: 2500 kN/mm\n"
                                  "      restitution: 0.6\n"
                                  "analysis:\n"
                                  "  tail: 1 s\n";

void fixture_write(struct fixture *f, const char *name, const char *text)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", f->folder, name);
    FILE *file = fopen(path, "w");
    ck_assert_ptr_nonnull(file);
    fputs(text, file);
    ck_assert_int_eq(fclose(file), 0);
}

void fixture_lose_motion(struct fixture *f)
{
    char keys[200], path[100];
    snprintf(path, sizeof path, "%s/gone.csv", f->folder);
    fixture_write(f, "gone.csv", "time_s,acceleration_g\n0,0\n0.1,0.3\n0.2,0\n");
    snprintf(keys, sizeof keys, ":records %s<Enter>", path);
    fixture_keys(f, keys);
    ck_assert_int_eq(remove(path), 0);
}

void fixture_program(struct fixture *f, char *path, size_t size, const char *script)
{
    char text[2048];
    snprintf(path, size, "%s/thud.sh", f->folder);
    snprintf(text, sizeof text, "#!/bin/sh\n%s\n", script);
    fixture_write(f, "thud.sh", text);
    ck_assert_int_eq(chmod(path, 0755), 0);
    f->tui->options.program = path;
}

/* Three seconds of a sine with a period near the towers' own. */
void fixture_write_pulse(struct fixture *f)
{
    static char text[32768];
    size_t n = (size_t)snprintf(text, sizeof text, "time_s,acceleration_g\n");
    for (int i = 0; i <= 300; i++)
        n += (size_t)snprintf(text + n, sizeof text - n, "%.2f,%.8f\n", 0.01 * i, sin(2.0 * THUD_PI * 0.01 * i / 0.4));
    fixture_write(f, "pulse.csv", text);
}

void fixture_take_record(struct fixture *f)
{
    char path[256];
    snprintf(path, sizeof path, "%s/pulse.csv", f->folder);
    ck_assert_int_eq(remove(path), 0);
    fixture_keys(f, ":sign -<Enter>"); /* it is read again */
}

void fixture_open(struct fixture *f, const char *preset, int width, int height, bool utf8)
{
    struct thud_error err = {0};
    char text[1024], name[128];
    memset(f, 0, sizeof *f);
    snprintf(f->folder, sizeof f->folder, "/tmp/thud-tui-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(f->folder));
    snprintf(f->paths.presets, sizeof f->paths.presets, "%s/shipped", f->folder);
    ck_assert_int_eq(mkdir(f->paths.presets, 0777), 0);
    snprintf(f->paths.records, sizeof f->paths.records, "%s", f->folder);
    fixture_write_pulse(f);
    fixture_write(f, "towers.yaml", fixture_towers);
    fixture_write(f, "bodies.yaml", bodies);
    fixture_write(f, "shipped/towers.yaml", fixture_towers);
    fixture_write(f, "shipped/bodies.yaml", bodies);
    snprintf(name, sizeof name, "%s/%s.yaml", f->folder, preset);
    thud_script_open(&f->backend, &f->script, width, height, utf8);
    struct thud_tui_options options = {
        .preset = name, .paths = &f->paths, .output = f->folder, .program = "/nowhere/thud"};
    enum thud_status status = thud_tui_create(&options, &f->backend, &f->tui, &err);
    ck_assert_msg(status == THUD_OK, "%s", thud_error_text(&err, text, sizeof text));
    fixture_keys(f, "");
}

static void remove_files(const char *name)
{
    DIR *folder = opendir(name);
    for (struct dirent *entry; folder && (entry = readdir(folder)) != NULL;) {
        char path[1024];
        snprintf(path, sizeof path, "%s/%s", name, entry->d_name);
        if (*entry->d_name != '.' && unlink(path) != 0)
            remove_files(path);
    }
    if (folder)
        closedir(folder);
    rmdir(name);
}

void fixture_close(struct fixture *f)
{
    thud_tui_free(f->tui);
    thud_text_clear(&f->script.raw);
    remove_files(f->folder);
}

void fixture_keys(struct fixture *f, const char *keys)
{
    f->script.at = keys;
    for (int i = 0; i < 1000000 && (*f->script.at || thud_tui_turn(f->tui, false)) && !f->tui->end.quit; i++)
        if (*f->script.at)
            thud_tui_turn(f->tui, false);
    while (f->tui->files.work || f->tui->files.command)
        thud_tui_turn(f->tui, true);
    thud_tui_draw(f->tui);
}

char *fixture_text(struct fixture *f)
{
    char *text = thud_canvas_text(&f->tui->canvas);
    ck_assert_ptr_nonnull(text);
    return text;
}

bool fixture_shows(struct fixture *f, const char *text)
{
    char *screen = fixture_text(f);
    bool shown = strstr(screen, text) != NULL;
    free(screen);
    return shown;
}

void fixture_expect(struct fixture *f, const char *text)
{
    char *screen = fixture_text(f);
    ck_assert_msg(strstr(screen, text) != NULL, "\"%s\" is not on the screen:\n%s", text, screen);
    free(screen);
}

void fixture_expect_not(struct fixture *f, const char *text)
{
    char *screen = fixture_text(f);
    ck_assert_msg(strstr(screen, text) == NULL, "\"%s\" is on the screen:\n%s", text, screen);
    free(screen);
}

char *fixture_file(struct fixture *f, const char *name)
{
    char path[256];
    static char text[65536];
    snprintf(path, sizeof path, "%s/%s", f->folder, name);
    FILE *file = fopen(path, "r");
    if (!file)
        return NULL;
    size_t n = fread(text, 1, sizeof text - 1, file);
    text[n] = '\0';
    fclose(file);
    return strdup(text);
}
