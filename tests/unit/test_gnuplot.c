/* gnuplot as a child: whole pictures, names taken literally, and a clear message for every way it can go wrong. Broken
 * gnuplots are small shell scripts. */
#include <check.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "plot/gnuplot/gnuplot.h"

static char folder[64], fake[96], trace[96];

static void make_folder(void)
{
    strcpy(folder, "/tmp/thud-gnuplot-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(fake, sizeof fake, "%s/gnuplot", folder);
    snprintf(trace, sizeof trace, "%s/trace", folder);
}

static void remove_folder(void)
{
    unlink(fake);
    unlink(trace);
    ck_assert_int_eq(rmdir(folder), 0); /* also: nothing else was left there */
}

static struct thud_figure *sample(const char *name)
{
    struct thud_figure *figure = thud_figure_create("sample", name, 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, name);
    const double x[] = {0.0, 1.0, 2.0}, y[] = {1.0, 3.0, 2.0};
    thud_panel_note(panel, name);
    thud_figure_note(figure, name);
    thud_panel_axis(panel, THUD_X, name, name);
    thud_panel_axis(panel, THUD_Y, name, "m");
    thud_panel_mark(panel, THUD_Y, 1.0, 1.0, name);
    thud_panel_tick(panel, THUD_X, 1.0, name);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES_POINTS}, name, 3, x, y);
    return figure;
}

/* Draws the sample with a gnuplot that is this shell script. */
static enum thud_status draw_with(const char *script, double deadline_s, struct thud_error *err)
{
    FILE *file = fopen(fake, "w");
    ck_assert_ptr_nonnull(file);
    fprintf(file, "#!/bin/sh\n%s\n", script);
    fclose(file);
    ck_assert_int_eq(chmod(fake, 0755), 0);
    struct thud_picture_options options = {.program = fake, .deadline_s = deadline_s};
    struct thud_figure *figure = sample("a");
    struct thud_text picture = {0};
    enum thud_status status = thud_gnuplot_draw(figure, &options, &picture, err);
    ck_assert_ptr_null(picture.data);
    thud_figure_free(figure);
    return status;
}

/* As it would have to be to count. */
#define DONE "echo 'thud: drawn to the end' >&2\n"

START_TEST(draws_every_format_whole_and_the_same_twice)
{
    static const char *const begin[] = {"\x89PNG\r\n\x1a\n", "<?xml", "%PDF-"};
    for (int format = 0; format < THUD_PICTURE_FORMATS; format++) {
        struct thud_picture_options options = {.format = (enum thud_picture_format)format};
        struct thud_figure *figure = sample("Impact force");
        struct thud_text one = {0}, two = {0};
        struct thud_error err;
        ck_assert_int_eq(thud_gnuplot_draw(figure, &options, &one, &err), THUD_OK);
        ck_assert_int_eq(memcmp(one.data, begin[format], strlen(begin[format])), 0);
        ck_assert_int_eq(thud_gnuplot_draw(figure, &options, &two, &err), THUD_OK);
        if (format != THUD_PDF) { /* which carries a date */
            ck_assert_uint_eq(one.size, two.size);
            ck_assert_int_eq(memcmp(one.data, two.data, one.size), 0);
        }
        thud_text_clear(&one);
        thud_text_clear(&two);
        thud_figure_free(figure);
    }
}
END_TEST

static unsigned big_endian(const char *data)
{
    const unsigned char *d = (const unsigned char *)data;
    return (unsigned)d[0] << 24 | (unsigned)d[1] << 16 | (unsigned)d[2] << 8 | d[3];
}

/* A legend of one tells nothing apart and is left out; two are told apart; a caption may take the place of the
 * title. */
START_TEST(legends_and_titles_stand_where_they_say_something)
{
    struct thud_figure *figure = thud_figure_create("f", "The title", 1, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "");
    const double x[] = {0, 1};
    struct thud_picture_options options = {.format = THUD_SVG};
    for (int curves = 1; curves <= 2; curves++) {
        struct thud_text script = {0};
        thud_panel_add(panel, (struct thud_style){.color = curves}, curves > 1 ? "second <b>" : "first", 2, x, x);
        options.no_title = curves > 1;
        ck_assert_int_eq(thud_gnuplot_script(figure, &options, NULL, &script, NULL), THUD_OK);
        ck_assert((strstr(script.data, "'first' at screen") != NULL) == (curves > 1));
        ck_assert((strstr(script.data, "'The title'") != NULL) == (curves == 1));
        thud_text_clear(&script);
    }
    struct thud_text svg = {0};
    ck_assert_int_eq(thud_gnuplot_draw(figure, &options, &svg, NULL), THUD_OK);
    ck_assert_ptr_nonnull(strstr(svg.data, "<title>The title</title>")); /* for who cannot see it */
    ck_assert_ptr_nonnull(strstr(svg.data, "<title>second &lt;b&gt;</title>"));
    ck_assert_ptr_null(strstr(svg.data, "<title>'+'")); /* gnuplot's own names say nothing to a reader */
    ck_assert_ptr_null(strstr(svg.data, "<title>gnuplot"));
    ck_assert_ptr_nonnull(strstr(svg.data, "first 0 to 1"));
    ck_assert_ptr_null(strstr(svg.data, "currentColor"));
    thud_text_clear(&svg);
    thud_figure_free(figure);
}
END_TEST

START_TEST(size_and_font_are_as_asked)
{
    struct thud_picture_options options = {
        .width_px = 640, .height_px = 401, .font = "DejaVu Sans Mono", .font_px = 11};
    struct thud_figure *figure = sample("a");
    struct thud_text picture = {0}, script = {0};
    ck_assert_int_eq(thud_gnuplot_draw(figure, &options, &picture, NULL), THUD_OK);
    ck_assert_uint_eq(big_endian(picture.data + 16), 640); /* IHDR */
    ck_assert_uint_eq(big_endian(picture.data + 20), 401);
    ck_assert_int_eq(thud_gnuplot_script(figure, &options, "a.png", &script, NULL), THUD_OK);
    ck_assert_ptr_nonnull(
        strstr(script.data, "FONT = 'DejaVu Sans Mono'; PT = 8.25 ")); /* 11 px are 8.25 pt at 96 to the inch */
    ck_assert_ptr_nonnull(strstr(script.data, "set output 'a.png'"));
    thud_text_clear(&picture);
    thud_text_clear(&script);
    thud_figure_free(figure);
}
END_TEST

/* On paper 90 mm are 1063 pixels of 300 to the inch, type of 8 points is 33.3 of them (25 pt at 96), a line of half a
 * point 2.08; two panels have no room side by side. */
START_TEST(a_width_on_paper)
{
    struct thud_picture_options options = {.width_mm = 90};
    struct thud_figure *figure = thud_figure_create("paper", "A title that is too long for one line of a column", 1, 2);
    const double x[] = {0, 1};
    struct thud_text picture = {0}, script = {0};
    double left[2], right[2], bottom[2], top[2];
    for (int i = 0; i < 2; i++)
        thud_panel_add(thud_figure_panel(figure, 0, i, "panel"), (struct thud_style){.color = i}, i ? "b" : "a", 2, x,
                       x);
    ck_assert_int_eq(thud_gnuplot_script(figure, &options, "a.png", &script, NULL), THUD_OK);
    ck_assert_ptr_nonnull(strstr(script.data, "W = 1063;"));
    ck_assert_ptr_nonnull(strstr(script.data, "PT = 25 "));
    ck_assert_ptr_nonnull(strstr(script.data, "LW = 2.083 "));
    ck_assert_ptr_nonnull(strstr(script.data, " dt (14,5) ")); /* the second curve without its colour */
    for (int i = 0; i < 2; i++) {
        char head[24];
        snprintf(head, sizeof head, "L%d = ", i + 1);
        const char *at = strstr(script.data, head);
        int n = 0, one = 0;
        ck_assert_ptr_nonnull(at);
        ck_assert_int_eq(sscanf(at, "L%d = %lf; R%d = %lf; B%d = %lf; T%d = %lf", &one, &left[i], &n, &right[i], &n,
                                &bottom[i], &n, &top[i]),
                         8);
        ck_assert(left[i] < right[i] && bottom[i] < top[i]);
    }
    ck_assert(left[0] == left[1] && top[1] < bottom[0]);
    ck_assert_int_eq(thud_gnuplot_draw(figure, &options, &picture, NULL), THUD_OK);
    ck_assert_uint_eq(big_endian(picture.data + 16), 1063);
    thud_text_clear(&picture);
    thud_text_clear(&script);
    options.width_mm = 190; /* room for both */
    ck_assert_int_eq(thud_gnuplot_script(figure, &options, "a.png", &script, NULL), THUD_OK);
    ck_assert_ptr_nonnull(strstr(script.data, "W = 2244;"));
    thud_text_clear(&script);
    thud_figure_free(figure);
    double mm = 0;
    ck_assert(thud_picture_width_parse("9 cm", &mm, NULL) == THUD_OK && fabs(mm - 90) < 1e-9);
    ck_assert_int_eq(thud_picture_width_parse("90", &mm, NULL), THUD_USAGE);
    ck_assert_int_eq(thud_picture_width_parse("2mm", &mm, NULL), THUD_USAGE);
    ck_assert_int_eq(thud_picture_width_parse("1 s", &mm, NULL), THUD_USAGE);
}
END_TEST

/* Points above each other are all drawn; long curves alone are thinned. */
START_TEST(few_points_are_all_drawn)
{
    const double x[] = {1, 1, 1, 1, 2}, y[] = {1, 2, 3, 4, 5};
    struct thud_picture_options options = {0};
    struct thud_text script = {0};
    struct thud_figure *figure = thud_figure_create("marks", "", 1, 1);
    thud_panel_add(thud_figure_panel(figure, 0, 0, ""), (struct thud_style){.kind = THUD_POINTS}, "", 5, x, y);
    ck_assert_int_eq(thud_gnuplot_script(figure, &options, NULL, &script, NULL), THUD_OK);
    ck_assert_ptr_nonnull(strstr(script.data, "$P1S1 << EOD\n1 1\n1 2\n1 3\n1 4\n2 5\n"));
    thud_text_clear(&script);
    thud_figure_free(figure);
}
END_TEST

/* A mark is as large beside the letters in an SVG of any width: its terminal makes marks grow with the font. */
START_TEST(marks_have_one_size)
{
    static const int width[] = {600, 2400};
    double size[2];
    const double at[] = {0, 1};
    struct thud_figure *figure = thud_figure_create("marks", "", 1, 1);
    thud_panel_add(thud_figure_panel(figure, 0, 0, ""), (struct thud_style){.kind = THUD_POINTS}, "", 2, at, at);
    for (int i = 0; i < 2; i++) {
        struct thud_picture_options options = {.format = THUD_SVG, .width_px = width[i]};
        struct thud_text picture = {0};
        ck_assert_int_eq(thud_gnuplot_draw(figure, &options, &picture, NULL), THUD_OK);
        const char *mark = strstr(picture.data, " scale(");
        ck_assert_ptr_nonnull(mark);
        size[i] = strtod(mark + 7, NULL) / width[i];
        thud_text_clear(&picture);
    }
    ck_assert_double_eq_tol(size[0], size[1], 0.02 * size[1]);
    thud_figure_free(figure);
}
END_TEST

/* 180 mm of a page are 2126 pixels. */
START_TEST(many_panels_fit_a_page)
{
    struct thud_picture_options options = {.width_mm = 90};
    const double x[] = {0, 1};
    for (int rows = 2; rows <= 6; rows += 4) {
        struct thud_figure *figure = thud_figure_create("paper", "title", rows, 1);
        struct thud_text script = {0};
        double width = 0, height = 0;
        for (int i = 0; i < rows; i++)
            thud_panel_add(thud_figure_panel(figure, i, 0, "panel"), (struct thud_style){.color = 0}, "", 2, x, x);
        ck_assert_int_eq(thud_gnuplot_script(figure, &options, "a.png", &script, NULL), THUD_OK);
        ck_assert_int_eq(sscanf(strstr(script.data, "\nW = ") + 1, "W = %lf; H = %lf", &width, &height), 2);
        ck_assert_double_le(height, 2126);
        ck_assert_double_ge(height, rows == 2 ? 1000 : 2120); /* no lower than it has to be */
        thud_text_clear(&script);
        thud_figure_free(figure);
    }
}
END_TEST

/* The title of a strip stands inside: curves that would run through it leave it room, in every strip of that range. */
START_TEST(titles_of_strips_have_room)
{
    struct thud_picture_options options = {0};
    for (int under = 0; under < 2; under++) {
        struct thud_figure *figure = thud_figure_create("strips", "title", 3, 1);
        struct thud_text script = {0};
        const double x[] = {0, 100}, flat[] = {0, 0.1}, high[] = {under, 1 - under};
        for (int i = 0; i < 3; i++) {
            struct thud_panel *panel = thud_figure_panel(figure, i, 0, "storey");
            thud_panel_add(panel, (struct thud_style){.color = 0}, "", 2, x, i == 1 ? high : flat);
            thud_panel_limits(panel, THUD_Y, 0, i < 2 ? 1 : 2);
        }
        thud_figure_strips(figure);
        ck_assert_int_eq(thud_gnuplot_script(figure, &options, "a.png", &script, NULL), THUD_OK);
        const char *at = script.data;
        for (int i = 0; i < 3; i++) {
            double most = 0;
            at = strstr(at, "set yrange [0:") + 1;
            ck_assert_int_eq(sscanf(at, "et yrange [0:%lf]", &most), 1);
            if (under && i < 2)
                ck_assert(most > 1.2 && most < 2);
            else
                ck_assert(most == (i < 2 ? 1 : 2));
        }
        thud_text_clear(&script);
        thud_figure_free(figure);
    }
}
END_TEST

/* However low a strip is, a number beside 0 says its scale. */
START_TEST(strips_have_a_scale)
{
    const struct thud_picture_options options = {.width_px = 1000, .height_px = 220, .font_px = 17};
    struct thud_figure *figure = thud_figure_create("strips", "title", 6, 1);
    struct thud_text script = {0};
    const double x[] = {0, 100}, y[] = {-42, 42};
    for (int i = 0; i < 6; i++)
        thud_panel_add(thud_figure_panel(figure, i, 0, "storey"), (struct thud_style){.color = 0}, "", 2, x, y);
    thud_figure_strips(figure);
    ck_assert_int_eq(thud_gnuplot_script(figure, &options, "a.png", &script, NULL), THUD_OK);
    const char *ticks = strstr(script.data, "set ytics ('");
    ck_assert_msg(ticks && !strncmp(ticks + 11, "'' 0, '50' 50)", 14), "%.60s", ticks);
    thud_text_clear(&script);
    thud_figure_free(figure);
}
END_TEST

/* gnuplot 5.4 does not read 'a''b' where the apostrophe comes first, or two of them follow each other. */
START_TEST(names_come_out_literally_and_execute_nothing)
{
    static const char *const begin[] = {"a", "a'b", "'s-", "''", "a''b", "'", "a\\", "\\'", "\"'\""};
    char name[512], command[256];
    snprintf(name, sizeof name, "%s\"`touch %s`{_^@%%s $(touch %s) \\ \n# \x01 \xff &amp; <b>'\\", begin[_i], trace,
             trace);
    snprintf(command, sizeof command, "`touch %s`{_^@%%s $(touch", trace);
    struct thud_picture_options options = {.format = THUD_SVG, .width_px = 6000, .height_px = 4000, .font_px = 10};
    struct thud_figure *figure = sample(name);
    struct thud_text picture = {0};
    struct thud_error err = {0};
    char text[2048];
    ck_assert_msg(thud_gnuplot_draw(figure, &options, &picture, &err) == THUD_OK, "%s",
                  thud_error_text(&err, text, sizeof text));
    ck_assert_int_eq(access(trace, F_OK), -1);
    int seen = 0; /* title, panel, two notes, two axes, mark, tick, key */
    for (const char *at = picture.data; (at = strstr(at, command)) != NULL; at++)
        seen++;
    ck_assert_int_ge(seen, 9);
    thud_text_clear(&picture);
    thud_figure_free(figure);
}
END_TEST

START_TEST(the_script_by_hand_draws_the_same)
{
    struct thud_picture_options options = {.width_px = 700, .height_px = 500};
    struct thud_figure *figure = sample("by hand");
    struct thud_text script = {0}, picture = {0};
    char command[300];
    ck_assert_int_eq(thud_gnuplot_script(figure, &options, "trace", &script, NULL), THUD_OK);
    FILE *file = fopen(fake, "w");
    fwrite(script.data, 1, script.size, file);
    fclose(file);
    snprintf(command, sizeof command, "cd %s && gnuplot -d gnuplot", folder);
    ck_assert_int_eq(system(command), 0); /* the user's own shell, in a test only */
    ck_assert_int_eq(thud_gnuplot_draw(figure, &options, &picture, NULL), THUD_OK);
    file = fopen(trace, "r");
    ck_assert_ptr_nonnull(file);
    char *bytes = malloc(picture.size + 1);
    ck_assert_uint_eq(fread(bytes, 1, picture.size + 1, file), picture.size);
    ck_assert_int_eq(memcmp(bytes, picture.data, picture.size), 0);
    fclose(file);
    free(bytes);
    thud_text_clear(&script);
    thud_text_clear(&picture);
    thud_figure_free(figure);
}
END_TEST

/* gnuplot 6 moves the cursor home before a picture in sixel: both come out the same, and without it. */
START_TEST(a_sixel_of_gnuplot_5_and_of_gnuplot_6)
{
    static const char *const before[] = {"", "\\033[H"};
    for (int i = 0; i < 2; i++) {
        FILE *file = fopen(fake, "w");
        fprintf(file, "#!/bin/sh\ncat >/dev/null\nprintf '%s\\033Pq#0~-\\033\\\\'\n" DONE, before[i]);
        fclose(file);
        ck_assert_int_eq(chmod(fake, 0755), 0);
        struct thud_picture_options options = {.program = fake, .format = THUD_SIXEL};
        struct thud_figure *figure = sample("a");
        struct thud_text picture = {0};
        struct thud_error err = {0};
        ck_assert_msg(thud_gnuplot_draw(figure, &options, &picture, &err) == THUD_OK, "%s", err.what);
        ck_assert_str_eq(picture.data, "\033Pq#0~-\033\\");
        thud_text_clear(&picture);
        thud_figure_free(figure);
    }
}
END_TEST

START_TEST(a_missing_gnuplot_is_named)
{
    struct thud_picture_options options = {.program = "/nowhere/gnuplot"};
    struct thud_figure *figure = sample("a");
    struct thud_text picture = {0};
    struct thud_error err = {0};
    ck_assert_int_eq(thud_gnuplot_draw(figure, &options, &picture, &err), THUD_GNUPLOT);
    ck_assert_ptr_nonnull(strstr(err.what, "/nowhere/gnuplot was not found"));
    ck_assert_ptr_nonnull(strstr(err.allowed, "install"));
    thud_figure_free(figure);
}
END_TEST

START_TEST(a_failing_gnuplot_is_quoted)
{
    struct thud_error err = {0};
    ck_assert_int_eq(draw_with("cat >/dev/null; echo '\"/dev/stdin\" line 7: invalid command' >&2; exit 1", 20, &err),
                     THUD_GNUPLOT);
    ck_assert_ptr_nonnull(strstr(err.what, "exit status 1"));
    ck_assert_ptr_nonnull(strstr(err.what, "line 7: invalid command"));
}
END_TEST

START_TEST(a_gnuplot_that_does_not_listen_raises_no_signal)
{
    struct thud_error err = {0};
    signal(SIGPIPE, SIG_DFL);
    ck_assert_int_eq(draw_with("exec <&-; exit 3", 20, &err), THUD_GNUPLOT);
    ck_assert_ptr_nonnull(strstr(err.what, "exit status 3"));
    ck_assert_int_eq(draw_with("kill -9 $$", 20, &err), THUD_GNUPLOT);
    ck_assert_ptr_nonnull(strstr(err.what, "signal 9"));
}
END_TEST

START_TEST(no_marker_and_no_picture_are_no_success)
{
    struct thud_error err = {0};
    ck_assert_int_eq(draw_with("cat >/dev/null; exit 0", 20, &err), THUD_GNUPLOT);
    ck_assert_ptr_nonnull(strstr(err.what, "before the end"));
    ck_assert_int_eq(draw_with("cat >/dev/null\n" DONE "exit 0", 20, &err), THUD_GNUPLOT);
    ck_assert_ptr_nonnull(strstr(err.what, "without a whole png picture (0 bytes)"));
    ck_assert_int_eq(
        draw_with("cat >/dev/null\nprintf '\\211PNG\\r\\n\\032\\nhalf of it and no more'\n" DONE, 20, &err),
        THUD_GNUPLOT);
    ck_assert_ptr_nonnull(strstr(err.what, "without a whole png"));
}
END_TEST

/* A killed process has ended, or is about to: the kernel is given its turn, but not for ever. */
static bool is_gone(long pid)
{
    char path[64], line[512];
    snprintf(path, sizeof path, "/proc/%ld/stat", pid);
    for (time_t until = time(NULL) + 10; time(NULL) < until; sched_yield()) {
        FILE *file = fopen(path, "r");
        if (!file)
            return true;
        const char *name = fgets(line, sizeof line, file) ? strrchr(line, ')') : NULL;
        fclose(file);
        if (!name || name[2] == 'Z' || name[2] == 'X') /* its new parent has not collected it yet */
            return true;
    }
    return false;
}

/* Also what it started must be gone, and what it said is passed on. */
START_TEST(a_hanging_gnuplot_is_ended_with_its_children)
{
    struct thud_error err = {0};
    char script[300];
    snprintf(script, sizeof script, "cat >/dev/null; echo 'waiting for a display' >&2; sleep 1000 & echo $! >%s; wait",
             trace);
    ck_assert_int_eq(draw_with(script, 0.2, &err), THUD_GNUPLOT);
    ck_assert_ptr_nonnull(strstr(err.what, "did not end within 0.2 s"));
    ck_assert_ptr_nonnull(strstr(err.what, "waiting for a display"));
    FILE *file = fopen(trace, "r");
    long pid = 0;
    ck_assert_ptr_nonnull(file);
    ck_assert_int_eq(fscanf(file, "%ld", &pid), 1);
    fclose(file);
    ck_assert(pid > 1);
    ck_assert_msg(is_gone(pid), "process %ld still runs", pid);
}
END_TEST

START_TEST(a_gnuplot_that_closes_everything_and_stays_is_ended)
{
    struct thud_error err = {0};
    ck_assert_int_eq(draw_with("exec <&- >&- 2>&-; sleep 1000", 0.2, &err), THUD_GNUPLOT);
    ck_assert_ptr_nonnull(strstr(err.what, "did not end"));
}
END_TEST

/* Draws with a gnuplot that takes a second and a deadline of four; exit status 0: it was drawn. */
static _Noreturn void draw_slowly(void)
{
    struct thud_picture_options options = {.program = fake, .deadline_s = 4.0};
    struct thud_figure *figure = sample("slow");
    struct thud_text picture = {0};
    _exit(thud_gnuplot_draw(figure, &options, &picture, NULL) == THUD_OK ? 0 : 1);
}

START_TEST(time_in_which_it_was_stopped_does_not_count)
{
    FILE *file = fopen(fake, "w");
    ck_assert_ptr_nonnull(file);
    fprintf(file, "#!/bin/sh\ntouch %s\nsleep 1\nexec gnuplot \"$@\"\n", trace);
    fclose(file);
    ck_assert_int_eq(chmod(fake, 0755), 0);
    pid_t pid = fork();
    if (pid == 0)
        draw_slowly();
    while (access(trace, F_OK) != 0)
        nanosleep(&(struct timespec){0, 1000000}, NULL);
    ck_assert_int_eq(kill(pid, SIGSTOP), 0);
    nanosleep(&(struct timespec){4, 500000000}, NULL);
    ck_assert_int_eq(kill(pid, SIGCONT), 0);
    int status = -1;
    ck_assert_int_eq(waitpid(pid, &status, 0), pid);
    ck_assert_int_eq(status, 0);
}
END_TEST

/* The dynamic linker ends with 127 too, for example under `ulimit -v`: that is another thing than no gnuplot. */
START_TEST(a_gnuplot_that_cannot_be_loaded_is_not_missing)
{
    struct thud_error err = {0};
    struct rlimit before, space = {.rlim_cur = (rlim_t)1 << 45, .rlim_max = RLIM_INFINITY};
    ck_assert_int_eq(getrlimit(RLIMIT_AS, &before), 0);
    space.rlim_max = before.rlim_max;
    ck_assert_int_eq(setrlimit(RLIMIT_AS, &space), 0);
    ck_assert_int_eq(draw_with("echo 'gnuplot: error while loading shared libraries: libqt.so: failed to map segment' "
                               ">&2; exit 127",
                               20, &err),
                     THUD_GNUPLOT);
    ck_assert_ptr_null(strstr(err.what, "not found"));
    ck_assert_ptr_nonnull(strstr(err.what, "failed to map segment"));
    ck_assert_ptr_nonnull(strstr(err.allowed, "ulimit -v"));
    setrlimit(RLIMIT_AS, &before);
}
END_TEST

START_TEST(a_wish_to_stop_ends_it)
{
    static atomic_int stop = 1;
    struct thud_picture_options options = {.cancel = &stop};
    struct thud_figure *figure = sample("a");
    struct thud_text picture = {0};
    ck_assert_int_eq(thud_gnuplot_draw(figure, &options, &picture, NULL), THUD_CANCELLED);
    ck_assert_ptr_null(picture.data);
    thud_figure_free(figure);
}
END_TEST

START_TEST(nothing_to_show_still_draws)
{
    struct thud_figure *figure = thud_figure_create("empty", "", 2, 2);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "no data");
    thud_panel_add(panel, (struct thud_style){.kind = THUD_LINES}, "none", 0, NULL, NULL);
    panel = thud_figure_panel(figure, 1, 1, "no map");
    const double at[] = {1.0, 2.0};
    thud_panel_map(panel, 2, at, 2, at, NULL, "z", "")->level = 1.0;
    panel = thud_figure_panel(figure, 0, 1, "bars and bands");
    thud_panel_fill(panel, (struct thud_style){.color = 1}, "band", 2, at, at, at);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_BARS}, "bars", 2, at, at);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_STEPS}, "steps", 2, at, at);
    struct thud_text picture = {0};
    struct thud_picture_options options = {0};
    struct thud_error err = {0};
    char text[2048];
    ck_assert_msg(thud_gnuplot_draw(figure, &options, &picture, &err) == THUD_OK, "%s",
                  thud_error_text(&err, text, sizeof text));
    thud_text_clear(&picture);
    thud_figure_free(figure);
}
END_TEST

/* Classes have a name each beside the colors, and a map of a quantity after them has its numbers again. */
START_TEST(classes_are_named)
{
    static const char *const names[] = {"whole", "cracked"};
    const double at[] = {1.0, 2.0}, z[] = {0.0, 1.0, 1.0, 0.0};
    struct thud_figure *figure = thud_figure_create("classes", "", 1, 2);
    struct thud_map *map = thud_panel_map(thud_figure_panel(figure, 0, 0, "classes"), 2, at, 2, at, z, "state", "");
    map->class_name = names;
    map->classes = 2;
    thud_panel_map(thud_figure_panel(figure, 0, 1, "quantity"), 2, at, 2, at, z, "ratio", "");
    struct thud_figure *copy = thud_figure_copy(figure);
    struct thud_text script = {0}, picture = {0};
    struct thud_picture_options options = {.format = THUD_SVG};
    ck_assert_int_eq(thud_gnuplot_script(copy, &options, NULL, &script, NULL), THUD_OK);
    const char *named = strstr(script.data, "set cbtics ('whole' 0, 'cracked' 1)");
    ck_assert_ptr_nonnull(named);
    ck_assert_ptr_nonnull(strstr(named, "set palette maxcolors 0"));
    ck_assert_int_eq(thud_gnuplot_draw(copy, &options, &picture, NULL), THUD_OK);
    ck_assert_ptr_nonnull(strstr(picture.data, "cracked"));
    ck_assert_ptr_null(strstr(picture.data, "state"));
    ck_assert_ptr_nonnull(strstr(picture.data, "ratio"));
    thud_text_clear(&script);
    thud_text_clear(&picture);
    thud_figure_free(figure);
    thud_figure_free(copy);
}
END_TEST

START_TEST(options_are_read_strictly)
{
    enum thud_picture_format format;
    int w, h;
    ck_assert_int_eq(thud_picture_format_parse("svg", &format, NULL), THUD_OK);
    ck_assert_int_eq(format, THUD_SVG);
    ck_assert_int_eq(thud_picture_format_parse("jpg", &format, NULL), THUD_USAGE);
    ck_assert_int_eq(thud_picture_size_parse("640x400", &w, &h, NULL), THUD_OK);
    ck_assert(w == 640 && h == 400);
    static const char *const bad[] = {"",
                                      "640",
                                      "640x",
                                      "x400",
                                      "640x400x",
                                      "-640x400",
                                      "640x-400",
                                      " 640x400",
                                      "640 x400",
                                      "10x10",
                                      "99999999999999999999x400",
                                      "640x400px"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        ck_assert_msg(thud_picture_size_parse(bad[i], &w, &h, NULL) == THUD_USAGE, "%s", bad[i]);
    char font[32];
    double px = 0.0;
    ck_assert_int_eq(thud_picture_font_parse("DejaVu Serif", font, sizeof font, &px, NULL), THUD_OK);
    ck_assert(strcmp(font, "DejaVu Serif") == 0 && px == 0.0);
    ck_assert_int_eq(thud_picture_font_parse("DejaVu Sans Mono,28.5", font, sizeof font, &px, NULL), THUD_OK);
    ck_assert(strcmp(font, "DejaVu Sans Mono") == 0 && px == 28.5);
    static const char *const no_font[] = {"",    ",12",  "A,",    "A,b",   "A,12,",
                                          "A,0", "A,-3", "A,1e9", "A,nan", "A name with far too many characters"};
    for (size_t i = 0; i < sizeof no_font / sizeof *no_font; i++)
        ck_assert_msg(thud_picture_font_parse(no_font[i], font, sizeof font, &px, NULL) == THUD_USAGE, "%s",
                      no_font[i]);
}
END_TEST

/* Every kind of thing a figure holds, copied: the same data and the same script. */
START_TEST(a_copy_is_just_like_it)
{
    struct thud_figure *figure = thud_figure_create("all", "All there is", 2, 2);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, "lines"), *close = thud_figure_panel(figure, 0, 1, "");
    struct thud_panel *map = thud_figure_panel(figure, 1, 0, "map");
    const double x[] = {1.0, 2.0, 3.0}, y[] = {1.0, 4.0, 2.0}, high[] = {2.0, 5.0, 3.0},
                 z[] = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
    thud_figure_note(figure, "a note");
    thud_panel_note(panel, "another");
    thud_panel_axis(panel, THUD_X, "Time", "s");
    thud_panel_axis(panel, THUD_Y, "Force", "MN");
    thud_panel_log(panel, THUD_Y);
    thud_panel_limits(panel, THUD_Y, 0.5, 20.0);
    thud_panel_add(panel, (struct thud_style){.kind = THUD_STEPS, .color = 2, .wide = true}, "steps", 3, x, y);
    thud_panel_fill(panel, (struct thud_style){.color = 1}, "band", 3, x, y, high);
    thud_panel_mark(panel, THUD_X, 1.0, 2.0, "here");
    thud_panel_zoom(close, panel, 1.5, 2.5);
    thud_panel_tick(map, THUD_Y, 1.0, "one");
    struct thud_map *m = thud_panel_map(map, 3, x, 2, y, z, "Ratio", "");
    ck_assert_ptr_nonnull(m);
    m->centre = 2.0;
    m->level = 3.0;
    struct thud_figure *copy = thud_figure_copy(figure);
    ck_assert_ptr_nonnull(copy);
    struct thud_text script[2] = {{0}, {0}}, csv[2] = {{0}, {0}}, bytes = {0};
    struct thud_picture_options options = {0};
    struct thud_error err;
    thud_figure_write(figure, &bytes);
    for (size_t n = 0; n < bytes.size; n++) { /* what is cut off is refused, wherever that was */
        char *part = malloc(n + 1);
        const char *at = memcpy(part, bytes.data, n);
        ck_assert_msg(!thud_figure_read(&at, part + n), "%zu of %zu bytes", n, bytes.size);
        free(part);
    }
    thud_text_clear(&bytes);
    for (int i = 0; i < 2; i++) {
        struct thud_figure *which = i ? copy : figure;
        ck_assert_int_eq(thud_gnuplot_script(which, &options, "all.png", &script[i], &err), THUD_OK);
        thud_figure_csv(which, &csv[i]);
    }
    thud_figure_free(figure); /* nothing of the copy is the other's */
    ck_assert_str_eq(script[0].data, script[1].data);
    ck_assert_str_eq(csv[0].data, csv[1].data);
    thud_panel_mark(&copy->panel[0], THUD_X, 2.5, 2.5, "");
    ck_assert_int_eq(thud_figure_check(copy, &err), THUD_OK);
    thud_figure_free(copy);
    for (int i = 0; i < 2; i++) {
        thud_text_clear(&script[i]);
        thud_text_clear(&csv[i]);
    }
}
END_TEST

/* The names of two near lines stand on their outer sides; a reference that coincides with a curve lies over it in
 * dashes; a strip of zeros takes the scale of the others. */
START_TEST(nothing_hides_another)
{
    struct thud_figure *figure = thud_figure_create("near", "", 2, 1);
    struct thud_panel *panel = thud_figure_panel(figure, 0, 0, ""), *zeros = thud_figure_panel(figure, 1, 0, "");
    const double x[] = {0.02, 10.0}, y[] = {0.0, 0.2}, none[] = {0.0, 0.0};
    thud_panel_log(panel, THUD_X);
    thud_panel_limits(panel, THUD_X, x[0], x[1]);
    thud_panel_mark(panel, THUD_X, 0.506, 0.506, "library");
    thud_panel_mark(panel, THUD_X, 0.409, 0.409, "school");
    thud_panel_add(panel, (struct thud_style){.color = -1}, "no pounding", 2, x, y);
    thud_panel_add(panel, (struct thud_style){.color = 0}, "no bumper", 2, x, y);
    thud_panel_add(zeros, (struct thud_style){.color = 0}, "no bumper", 2, x, none);
    thud_figure_share_scale(figure, THUD_Y, 0, 1, 2, NULL);
    ck_assert_double_lt(thud_panel_range(zeros, THUD_Y).most, 0.5);
    ck_assert_double_ge(thud_panel_range(zeros, THUD_Y).least, 0.0);
    struct thud_text script = {0};
    struct thud_error err;
    ck_assert_int_eq(thud_gnuplot_script(figure, &(struct thud_picture_options){0}, "near.png", &script, &err),
                     THUD_OK);
    ck_assert_ptr_nonnull(strstr(script.data, "first 0.409, graph 1 right"));
    ck_assert_ptr_nonnull(strstr(script.data, "first 0.506, graph 1 left"));
    const char *curve = strstr(script.data, "$P1S2 using"), *reference = strstr(script.data, "$P1S1 using");
    ck_assert(curve && curve < reference);
    thud_text_clear(&script);
    thud_figure_free(figure);
}
END_TEST

/* Named classes have a name each on a scale without numbers between them; the ends of a log axis lie a hair outside
 * their ticks; the numbers of a narrow frame stand apart. */
START_TEST(scales_can_be_read)
{
    static const char *const classes[] = {"low", "it's", "high"};
    const double at[] = {0.0, 1.0, 2.0}, z[] = {0.0, 1.0, 2.0, 2.0, 1.0, 0.0, 0.0, 1.0, 2.0};
    const double x[] = {0.0, 132.0}, y[] = {10.0, 10000.0};
    struct thud_figure *figure = thud_figure_create("scales", "", 1, 3);
    struct thud_map *map = thud_panel_map(thud_figure_panel(figure, 0, 0, ""), 3, at, 3, at, z, "class", "");
    struct thud_panel *narrow = thud_figure_panel(figure, 0, 1, "");
    map->class_name = classes;
    map->classes = 3;
    thud_panel_log(narrow, THUD_Y);
    thud_panel_limits(narrow, THUD_Y, y[0], y[1]);
    thud_panel_add(narrow, (struct thud_style){.kind = THUD_LINES}, "", 2, x, y);
    struct thud_text script = {0};
    struct thud_picture_options options = {.width_px = 1800, .font_px = 28};
    ck_assert_int_eq(thud_gnuplot_script(figure, &options, "x.png", &script, NULL), THUD_OK);
    ck_assert_ptr_nonnull(strstr(script.data, "set cbrange [-0.5:2.5]"));
    ck_assert_ptr_nonnull(strstr(script.data, "set palette maxcolors 3\n"));
    ck_assert_ptr_nonnull(strstr(script.data, "('low' 0, \"it's\" 1, 'high' 2)"));
    ck_assert_ptr_nonnull(strstr(script.data, "set yrange [9.999999:10000.001]"));
    ck_assert_ptr_nonnull(strstr(script.data, "autofreq 50\n")); /* by default every 20 */
    thud_text_clear(&script);
    options.width_px = 5400;
    ck_assert_int_eq(thud_gnuplot_script(figure, &options, "x.png", &script, NULL), THUD_OK);
    ck_assert_ptr_nonnull(strstr(script.data, "autofreq 20\n"));
    thud_text_clear(&script);
    thud_figure_free(figure);
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("gnuplot");
    TCase *tcase = tcase_create("gnuplot");
    tcase_set_timeout(tcase, 60);
    tcase_add_checked_fixture(tcase, make_folder, remove_folder);
    tcase_add_test(tcase, draws_every_format_whole_and_the_same_twice);
    tcase_add_test(tcase, legends_and_titles_stand_where_they_say_something);
    tcase_add_test(tcase, a_copy_is_just_like_it);
    tcase_add_test(tcase, nothing_hides_another);
    tcase_add_test(tcase, scales_can_be_read);
    tcase_add_test(tcase, size_and_font_are_as_asked);
    tcase_add_test(tcase, a_width_on_paper);
    tcase_add_test(tcase, few_points_are_all_drawn);
    tcase_add_test(tcase, marks_have_one_size);
    tcase_add_test(tcase, many_panels_fit_a_page);
    tcase_add_test(tcase, titles_of_strips_have_room);
    tcase_add_test(tcase, strips_have_a_scale);
    tcase_add_loop_test(tcase, names_come_out_literally_and_execute_nothing, 0, 9);
    tcase_add_test(tcase, the_script_by_hand_draws_the_same);
    tcase_add_test(tcase, a_sixel_of_gnuplot_5_and_of_gnuplot_6);
    tcase_add_test(tcase, a_missing_gnuplot_is_named);
    tcase_add_test(tcase, a_failing_gnuplot_is_quoted);
    tcase_add_test(tcase, a_gnuplot_that_does_not_listen_raises_no_signal);
    tcase_add_test(tcase, no_marker_and_no_picture_are_no_success);
    tcase_add_test(tcase, a_hanging_gnuplot_is_ended_with_its_children);
    tcase_add_test(tcase, a_gnuplot_that_closes_everything_and_stays_is_ended);
    tcase_add_test(tcase, time_in_which_it_was_stopped_does_not_count);
    tcase_add_test(tcase, a_gnuplot_that_cannot_be_loaded_is_not_missing);
    tcase_add_test(tcase, a_wish_to_stop_ends_it);
    tcase_add_test(tcase, nothing_to_show_still_draws);
    tcase_add_test(tcase, classes_are_named);
    tcase_add_test(tcase, options_are_read_strictly);
    suite_add_tcase(suite, tcase);
    return suite;
}
