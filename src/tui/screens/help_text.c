#include "tui/screens/help_text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/grow.h"
#include "core/methods/method.h"
#include "io/file/file.h"
#include "tui/document/field.h"

enum { KEY_COLUMN = 3, HELP_COLUMN = 10, NAME_COLUMN = 3, FIELD_COLUMN = 7 };

static const char *const model[] = {
    "A scene is a ground motion and a row of structures, with an interface between two neighbours. Displacements "
    "are relative to the ground, positive to the right.",
    "Shear building: a mass for each floor, a spring for each storey, the same damping ratio in every mode. Isolated "
    "building: a shear building on a slab with isolators. Rigid body: one free mass with an initial velocity. Wall: "
    "moves with the ground. Floors at the same height can collide.",
    "Bare contact, linear viscoelastic without tension: F = k d + c d' while that is positive; c = 2 xi sqrt(k m), m = "
    "m1 m2/(m1 + m2), xi from the coefficient of restitution. damping paper: the classical formula; bodies separate "
    "faster than specified. damping exact: bodies separate as specified.",
    "Rubber bumper: F = k d^n on approach, past the ultimate strain a line of stiffness post-yield; on restitution F "
    "= k d^n (1 + C d').",
    "clearance = gap - (thickness - cavity).",
    "Three cases are run after every edit: no pounding (no contact at all), no bumper (bare contact at the same gap), "
    "and the bumper as written. ratio = bumper : no bumper; below 1 the bumper helps. Every peak is that of the "
    "continuous history, not of printed samples.",
    "Sweep also follows every edit; the varied keys may have any value in the scene. Studies that take more than a few "
    "seconds wait for r. For several ground motions (records: a folder, a list, files) it shows medians and bands, "
    "then the required gap and the fragility of the events. Other studies (:bench, :simplify, :stability, "
    ":uncertainty, ...) have forms, and show their figures on the shelf.",
    "Values take units and convert: 50 mm, 5cm, 0.05 m, 320 t, 600 MN/m, 2500 kN/mm, 0.36 kN/mm^2.65, 0.821 g, 5 %. "
    "The decimal sign is a point. Without a unit, the unit shown applies. All digits typed are kept.",
};

static struct thud_help_line *add(struct thud_help_text *text, enum thud_help_kind kind)
{
    struct thud_help_line *larger = thud_grow(text->line, (size_t)text->n, sizeof *larger);
    if (!larger)
        return NULL;
    text->line = larger;
    struct thud_help_line *line = &larger[text->n++];
    *line = (struct thud_help_line){.kind = kind};
    return line;
}

/* Words from column `indent` on; the first line may have a key before them. */
static void wrap(struct thud_help_text *text, int columns, const char *key, int key_column, int indent,
                 const char *words)
{
    bool first = true;
    if (columns > THUD_HELP_COLUMNS)
        columns = THUD_HELP_COLUMNS;
    if (*key && key_column + thud_utf8_columns(key) + 1 > indent) { /* a long name has a line of its own */
        wrap(text, columns, key, key_column, key_column + thud_utf8_columns(key) + 1, "");
        key = "";
    }
    do {
        struct thud_help_line *line = add(text, *key ? THUD_HELP_ITEM : THUD_HELP_PLAIN);
        if (!line)
            return;
        char start[THUD_HELP_COLUMNS + 1];
        snprintf(start, sizeof start, "%*s%s", key_column, "", first ? key : "");
        line->key = first && *key ? thud_utf8_columns(start) : 0;
        int at = indent;
        snprintf(line->text, sizeof line->text, "%-*s", indent, start);
        while (*words) {
            size_t length = strcspn(words, " ");
            char word[256];
            snprintf(word, sizeof word, "%.*s", (int)length, words);
            int width = thud_utf8_columns(word);
            bool begun = at > indent;
            if (begun && at + 1 + width > columns)
                break;
            thud_append(line->text, sizeof line->text, "%s%s", begun ? " " : "", word);
            at += begun + width;
            words += length + strspn(words + length, " ");
        }
        first = false;
        key = "";
    } while (*words);
}

static void head(struct thud_help_text *text, const char *words)
{
    if (text->n > 0)
        add(text, THUD_HELP_PLAIN);
    struct thud_help_line *line = add(text, THUD_HELP_HEAD);
    if (line)
        snprintf(line->text, sizeof line->text, " %.90s", words);
}

static void keys(struct thud_help_text *text, int columns, int where, bool general, const char *title)
{
    bool any = false;
    for (int i = 0; i < thud_key_count(); i++) {
        const struct thud_key_entry *key = thud_key_at(i);
        bool is_general = key->where == THUD_AT_GENERAL || key->where == THUD_AT_FORMS;
        if (!(key->where & where) || is_general != general || thud_key_action(where, key->key) != key->action)
            continue;
        if (!any)
            head(text, title);
        any = true;
        wrap(text, columns, key->written, KEY_COLUMN, HELP_COLUMN, key->help);
    }
}

static void put_param(struct thud_help_text *text, int columns, const struct thud_param *param)
{
    char name[100], words[700];
    bool said = strcmp(param->name, param->title) == 0;
    snprintf(name, sizeof name, "%.40s%s%.40s", param->name, said ? "" : ": ", said ? "" : param->title);
    thud_param_words(param, words, sizeof words);
    wrap(text, columns, name, NAME_COLUMN, FIELD_COLUMN, words);
}

/* The fields of a screen, or (`others`) those of all the rest. */
static void fields(struct thud_help_text *text, int columns, int screen, bool others)
{
    static const struct {
        enum thud_group group;
        int screen;
        const char *title;
    } part[] = {{THUD_GROUP_STRUCTURE, THUD_SCREEN_MODEL, "Fields of a structure"},
                {THUD_GROUP_COLUMN, THUD_SCREEN_MODEL, "Fields of the columns that a slab strikes"},
                {THUD_GROUP_ISOLATOR, THUD_SCREEN_MODEL, "Fields of isolators"},
                {THUD_GROUP_FOUNDATION, THUD_SCREEN_MODEL, "Fields of a foundation on soil"},
                {THUD_GROUP_BACKFILL, THUD_SCREEN_MODEL, "Fields of the soil behind a wall"},
                {THUD_GROUP_INTERFACE, THUD_SCREEN_CONTACT, "Fields of an interface"},
                {THUD_GROUP_CONTACT, THUD_SCREEN_CONTACT, "Fields of the bare contact"},
                {THUD_GROUP_BUMPER, THUD_SCREEN_CONTACT, "Fields of the bumper"},
                {THUD_GROUP_LINK, THUD_SCREEN_CONTACT, "Fields of a link"},
                {THUD_GROUP_RECORD, THUD_SCREEN_RECORD, "Fields of the ground motion"},
                {THUD_GROUP_ANALYSIS, THUD_SCREEN_RESULTS, "Fields of the analysis"},
                {THUD_GROUP_STUDY, THUD_SCREEN_SWEEP, "Fields of the study"}};
    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
        if ((part[i].screen == screen) == others)
            continue;
        head(text, part[i].title);
        for (int k = 0; thud_group_param(part[i].group, k); k++)
            put_param(text, columns, thud_group_param(part[i].group, k));
    }
}

static bool in_use(const struct thud_scene *scene, const struct thud_law *law)
{
    for (int i = 0; i + 1 < scene->nstructures; i++)
        if (scene->interface[i].contact.law == law ||
            (scene->interface[i].has_bumper && scene->interface[i].bumper.law == law))
            return true;
    return false;
}

static void laws(struct thud_help_text *text, int columns, const struct thud_scene *scene, bool used)
{
    for (int i = 0; i < thud_law_count(); i++) {
        const struct thud_law *law = thud_law_at(i);
        char title[100];
        if (in_use(scene, law) != used)
            continue;
        snprintf(title, sizeof title, "Law %.30s%s", law->name, used ? " (in use)" : "");
        head(text, title);
        wrap(text, columns, "", 0, NAME_COLUMN, law->title);
        wrap(text, columns, "", 0, NAME_COLUMN, law->summary);
        wrap(text, columns, "", 0, NAME_COLUMN, law->reference);
        for (int k = 0; k < law->nparams; k++)
            put_param(text, columns, &law->params[k]);
    }
}

static void methods(struct thud_help_text *text, int columns)
{
    head(text, "Methods (analysis.method)");
    for (int i = 0; i < thud_method_count(); i++) {
        const struct thud_method *method = thud_method_at(i);
        wrap(text, columns, method->name, NAME_COLUMN, FIELD_COLUMN, method->summary);
        wrap(text, columns, "", 0, FIELD_COLUMN, method->limits);
    }
}

static void commands(struct thud_help_text *text, int columns)
{
    struct thud_text words = {0};
    thud_commands_text(&words);
    head(text, "Commands after :");
    char *rest = words.data;
    for (char *line; rest && (line = thud_text_line(&rest)) != NULL;)
        wrap(text, columns, "", 0, KEY_COLUMN, line);
    thud_text_clear(&words);
}

void thud_help_text_make(struct thud_help_text *text, const struct thud_tui *tui, int screen, int columns)
{
    const struct thud_view *view = tui->view[screen];
    const struct thud_scene *scene = &tui->doc.scene;
    char title[64];
    text->n = 0;
    if (columns < 30)
        columns = 30;
    snprintf(title, sizeof title, "Keys of %s", view->title);
    keys(text, columns, view->where, false, title);
    if (screen == THUD_SCREEN_PLOTS)
        keys(text, columns, THUD_AT_SIDE, false, "On the fields beside the figure (a wide terminal; Tab goes there)");
    keys(text, columns, view->where, true, "General keys");
    keys(text, columns, THUD_AT_TYPING, false, "While typing (every other key is text)");
    fields(text, columns, screen, false);
    if (screen == THUD_SCREEN_CONTACT)
        laws(text, columns, scene, true);
    head(text, "The model in short");
    for (size_t i = 0; i < sizeof model / sizeof *model; i++)
        wrap(text, columns, "", 0, KEY_COLUMN, model[i]);
    commands(text, columns);
    fields(text, columns, screen, true);
    if (screen != THUD_SCREEN_CONTACT)
        laws(text, columns, scene, true);
    laws(text, columns, scene, false);
    methods(text, columns);
}

void thud_help_text_clear(struct thud_help_text *text)
{
    free(text->line);
    *text = (struct thud_help_text){0};
}

int thud_help_line_find(const struct thud_help_line *line, const char *word, int from)
{
    const char *at = *word ? thud_ascii_find(line->text + from, word) : NULL;
    return at ? (int)(at - line->text) : -1;
}

int thud_help_text_find(const struct thud_help_text *text, const char *word, int from, int step)
{
    for (int i = 0; i < text->n; i++) {
        int at = ((from + i * step) % text->n + text->n) % text->n;
        if (thud_help_line_find(&text->line[at], word, 0) >= 0)
            return at;
    }
    return -1;
}
