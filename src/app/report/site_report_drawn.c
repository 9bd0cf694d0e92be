/* Figures that were drawn before the report, such as those marked in the terminal: SVG pictures, as they are, each with
 * its title as its caption. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/report/site_report_private.h"
#include "io/file/file.h"
#include "io/file/paths.h"

enum { PICTURE_MOST = 32 << 20 }; /* bytes */
static const char title_begin[] = "<title>";

static enum thud_status read_one(const char *path, struct thud_text *out, struct thud_error *err)
{
    char *bytes = NULL;
    size_t size = 0;
    enum thud_status status = thud_file_read(path, PICTURE_MOST, &bytes, &size, err);
    if (status == THUD_OK && (memchr(bytes, '\0', size) || !strstr(bytes, "<svg")))
        status = thud_error_set(err, THUD_INPUT, "%s: is no SVG picture; `--format svg` draws one", path);
    if (status == THUD_OK)
        thud_text_bytes(out, bytes, size);
    free(bytes);
    return status;
}

static enum thud_status read_next(struct site *site, const char *path, struct thud_error *err)
{
    if (site->ndrawn == SITE_DRAWN_MAX)
        return thud_error_set(err, THUD_USAGE, "a report takes at most %d figures", SITE_DRAWN_MAX);
    return read_one(path, &site->drawn[site->ndrawn++], err);
}

/* Every SVG picture of a folder, by name. */
static enum thud_status read_folder(struct site *site, const char *folder, struct thud_error *err)
{
    char **name, path[2 * THUD_TEXT_MAX];
    size_t count;
    enum thud_status status = thud_folder_names(folder, &name, &count, NULL, err);
    if (status != THUD_OK)
        return status;
    for (size_t i = 0; i < count && status == THUD_OK; i++) {
        const char *dot = strrchr(name[i], '.');
        snprintf(path, sizeof path, "%s/%s", folder, name[i]);
        if (dot && strcmp(dot, ".svg") == 0)
            status = read_next(site, path, err);
    }
    thud_folder_names_free(name, count);
    return status;
}

enum thud_status thud_site_drawn_read(struct site *site, struct thud_error *err)
{
    const char *list = site->options->drawn ? site->options->drawn : "";
    char path[THUD_TEXT_MAX];
    enum thud_status status = THUD_OK;
    for (size_t n; *list && status == THUD_OK; list += n + (list[n] == ',')) {
        n = strcspn(list, ",");
        snprintf(path, sizeof path, "%.*s", (int)n, list);
        status = thud_path_is_folder(path) ? read_folder(site, path, err) : read_next(site, path, err);
    }
    return status;
}

/* The text of an XML element. */
static void read_title(const char *svg, char *text, size_t size)
{
    static const char *const entity[] = {"amp;&", "lt;<", "gt;>", "quot;\"", "apos;'"};
    const char *at = strstr(svg, title_begin);
    size_t n = 0;
    for (at = at ? at + sizeof title_begin - 1 : ""; *at && *at != '<' && n + 1 < size; at++) {
        text[n++] = *at;
        for (size_t i = 0; i < sizeof entity / sizeof *entity && *at == '&'; i++) {
            const size_t length = strlen(entity[i]) - 1;
            if (strncmp(at + 1, entity[i], length) == 0) {
                text[n - 1] = entity[i][length];
                at += length;
                break;
            }
        }
    }
    text[n] = '\0';
}

void thud_site_drawn(struct site *site)
{
    if (site->ndrawn == 0)
        return;
    thud_document_heading(&site->document, "Further figures");
    for (int i = 0; i < site->ndrawn; i++) {
        char file[32], caption[400], words[402];
        read_title(site->drawn[i].data, caption, sizeof caption);
        snprintf(file, sizeof file, "further-%d.svg", i + 1);
        snprintf(words, sizeof words, "%s.", caption);
        thud_document_figure(&site->document, file, words, caption, &site->drawn[i]);
    }
}
