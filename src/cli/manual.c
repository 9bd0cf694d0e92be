#include "cli/manual.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/param.h"
#include "core/law.h"

enum { COLUMNS = 76 };

/* Text filled to lines, a new one for each sentence, so that none is taken for a request. */
static void fill(struct thud_text *out, const char *text)
{
    size_t column = 0;
    for (const char *word = text; *word;) {
        size_t length = strcspn(word, " ");
        bool sentence_ends = length > 0 && word[length - 1] == '.' && word[length] != '\0';
        if (column > 0 && column + 1 + length > COLUMNS) {
            thud_text_append(out, "\n");
            column = 0;
        }
        thud_text_append(out, "%s%s", column > 0 ? " " : "", column == 0 && strchr(".'", word[0]) ? "\\&" : "");
        for (size_t i = 0; i < length; i++)
            thud_text_append(out, word[i] == '\\' ? "\\e" : "%c", word[i]);
        column += length + 1;
        word += length + strspn(word + length, " ");
        if (sentence_ends) {
            thud_text_append(out, "\n");
            column = 0;
        }
    }
    if (column > 0)
        thud_text_append(out, "\n");
}

static void put_value(struct thud_text *out, const struct thud_param *param, double value)
{
    char text[64];
    if (value == 0)
        strcpy(text, "0");
    else
        thud_quantity_format(value, param->unit, text, sizeof text);
    thud_text_append(out, "%s", text);
}

static void put_range(struct thud_text *out, const struct thud_param *param, double least, double most, bool open_least,
                      bool open_most)
{
    if (!isnan(least)) {
        thud_text_append(out, open_least ? "more than " : isnan(most) ? "at least " : "from ");
        put_value(out, param, least);
    }
    if (!isnan(most)) {
        thud_text_append(out, isnan(least) ? open_most ? "less than " : "at most "
                              : open_most  ? ", less than "
                                           : " to ");
        put_value(out, param, most);
    }
}

static void put_bounds(struct thud_text *out, const struct thud_param *param)
{
    if (param->kind == THUD_PARAM_CHOICE) {
        for (int i = 0; param->choices[i]; i++)
            thud_text_append(out, "%s%s",
                             i == 0                  ? "One of "
                             : param->choices[i + 1] ? ", "
                                                     : " or ",
                             param->choices[i]);
        thud_text_append(out, ". ");
        return;
    }
    if (param->unit && param->unit[0])
        thud_text_append(out, "Unit %s. ", param->unit);
    if (!isnan(param->least) || !isnan(param->most)) {
        thud_text_append(out, "Allowed: ");
        put_range(out, param, param->least, param->most, param->least_open, param->most_open);
        thud_text_append(out, ". ");
    }
    if (!isnan(param->soft_least) || !isnan(param->soft_most)) {
        thud_text_append(out, "Usual: ");
        put_range(out, param, param->soft_least, param->soft_most, false, false);
        thud_text_append(out, ". ");
    }
}

static void put_default(struct thud_text *out, const struct thud_param *param)
{
    if (isnan(param->fallback))
        return;
    thud_text_append(out, "Default ");
    if (param->kind == THUD_PARAM_CHOICE)
        thud_text_append(out, "%s", param->choices[(int)param->fallback]);
    else
        put_value(out, param, param->fallback);
    thud_text_append(out, ".");
}

static void put_params(struct thud_text *out, const struct thud_param *params, int n)
{
    if (n == 0)
        return;
    thud_text_append(out, ".Bl -tag -width Ds\n");
    for (int i = 0; i < n; i++) {
        struct thud_text item = {0};
        thud_text_append(&item, "%s ", params[i].help);
        put_bounds(&item, &params[i]);
        put_default(&item, &params[i]);
        thud_text_append(out, ".It Cm %s\n", params[i].name);
        if (item.failed)
            out->failed = 1;
        else
            fill(out, item.data);
        thud_text_clear(&item);
    }
    thud_text_append(out, ".El\n");
}

static void units(struct thud_text *out)
{
    thud_text_append(out, ".Bl -tag -width Ds -compact\n");
    for (int d = THUD_RATIO; d < THUD_DIMENSIONS; d++) {
        const char *name = thud_dimension_name((enum thud_dimension)d); /* "a length" */
        const char *blank = strchr(name, ' ');
        thud_text_append(out, ".It %s\n", blank ? blank + 1 : name);
        fill(out, thud_dimension_units((enum thud_dimension)d));
    }
    thud_text_append(out, ".El\n");
}

static void laws(struct thud_text *out)
{
    for (int i = 0; i < thud_law_count(); i++) {
        const struct thud_law *law = thud_law_at(i);
        thud_text_append(out, ".Ss Law %s\n", law->name);
        struct thud_text about = {0};
        thud_text_append(&about, "%s: %s", law->title, law->summary);
        if (about.failed)
            out->failed = 1;
        else
            fill(out, about.data);
        thud_text_clear(&about);
        put_params(out, law->params, law->nparams);
    }
}

static const struct {
    const char *name;
    void (*write)(struct thud_text *out);
} parts[] = {{"units", units}, {"laws", laws}};
enum { PARTS = sizeof parts / sizeof *parts };

bool thud_manual_part(struct thud_text *out, const char *name)
{
    for (int i = 0; i < PARTS; i++) {
        if (strcmp(parts[i].name, name) == 0) {
            parts[i].write(out);
            return true;
        }
    }
    return false;
}

const char *thud_manual_part_name(int index)
{
    return index < PARTS ? parts[index].name : NULL;
}
