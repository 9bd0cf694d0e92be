/* made-by.txt has a part for everything that wrote into its folder. A part is a line `made GROUP SCENE ASKED WHAT` with
 * two fingerprints, and a line `file NAME` for each of its files. A part whose files are all gone says nothing. */
#include "io/file/made_by.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"
#include "io/file/data_package.h"
#include "io/file/file.h"
#include "io/file/file_private.h"

static const char heading[] = "# thud: what wrote the results in this folder, and their files";
enum { LIST_MAX = 1 << 20, PATH_ROOM = 4400 };

/* The files of one folder, remembered as they come into it: only where they are renamed all of them pass. */
static struct {
    char folder[4096]; /* "": none */
    struct thud_text files;
} written;

/* Whether a list of `file NAME` lines has this one. */
static bool list_has(const struct thud_text *list, const char *name)
{
    size_t n = strlen(name);
    for (const char *at = list->data; at && (at = strstr(at, name)) != NULL; at++)
        if (at[n] == '\n' && at - list->data >= 5 && memcmp(at - 5, "file ", 5) == 0)
            return true;
    return false;
}

void thud_made_by_note(const char *path)
{
    size_t n = strlen(written.folder);
    if (n == 0 || strncmp(path, written.folder, n) != 0 || path[n] != '/')
        return;
    path += n + strspn(path + n, "/");
    size_t length = strlen(path);
    bool is_journal = length > 8 && strcmp(path + length - 8, ".journal") == 0; /* goes once the study is whole */
    if (is_journal || strcmp(path, THUD_MADE_BY_FILE) == 0)
        return;
    if (!strchr(path, '\n') && !list_has(&written.files, path))
        thud_text_append(&written.files, "file %s\n", path);
}

/* ---- reading ---- */

struct part {
    char *group, *what; /* in the text */
    unsigned long long scene, asked;
    struct thud_text files; /* those that are there */
};

static bool path_in(const char *folder, const char *name, char path[PATH_ROOM])
{
    bool inside =
        *name && *name != '/' && strcmp(name, "..") != 0 && strncmp(name, "../", 3) != 0 && !strstr(name, "/../");
    int n = snprintf(path, PATH_ROOM, "%s/%s", folder, name);
    return inside && n > 0 && n < PATH_ROOM;
}

static bool scan_word(char **at, char **word)
{
    *word = *at;
    *at += strcspn(*at, " ");
    if (**at == '\0')
        return false;
    *(*at)++ = '\0';
    return true;
}

/* The next part, its lines parted in place; false: there is none. */
static bool next_part(const char *folder, char **text, struct part *out)
{
    bool found = false;
    *out = (struct part){0};
    while (**text) {
        char *line = *text, *end = line + strcspn(line, "\n"), *scene, *asked, path[PATH_ROOM];
        if (found && strncmp(line, "made ", 5) == 0)
            break;
        *text = *end ? end + 1 : end;
        *end = '\0';
        struct stat about;
        if (strncmp(line, "made ", 5) == 0) {
            out->what = line + 5;
            found =
                scan_word(&out->what, &out->group) && scan_word(&out->what, &scene) && scan_word(&out->what, &asked);
            out->scene = found ? strtoull(scene, NULL, 16) : 0;
            out->asked = found ? strtoull(asked, NULL, 16) : 0;
        } else if (found && strncmp(line, "file ", 5) == 0 && path_in(folder, line + 5, path) &&
                   lstat(path, &about) == 0 && S_ISREG(about.st_mode)) {
            thud_text_append(&out->files, "file %s\n", line + 5);
        }
    }
    return found;
}

/* The list of a folder; *text is "" where there is none. */
static enum thud_status read_list(const char *folder, char **text, struct thud_error *err)
{
    char path[PATH_ROOM];
    size_t size;
    struct stat about;
    snprintf(path, sizeof path, "%s/%s", folder, THUD_MADE_BY_FILE);
    if (lstat(path, &about) != 0) {
        *text = calloc(1, 1);
        return *text ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    enum thud_status status = thud_file_read(path, LIST_MAX, text, &size, err);
    if (status == THUD_OK && strncmp(*text, heading, sizeof heading - 1) != 0) {
        free(*text);
        *text = NULL;
        return thud_error_in(err, THUD_INPUT, path, 0, "is not a list of results by thud");
    }
    return status;
}

/* ---- what lies there ---- */

static bool is_own(const struct thud_made_by *by, const struct part *part)
{
    return strcmp(part->group, by->group) == 0 && part->scene == by->scene && part->asked == by->asked;
}

static bool is_other(const struct thud_made_by *by, const struct part *part)
{
    const bool scenes = part->scene != 0 && by->scene != 0;
    return part->files.size > 0 &&
           ((scenes && part->scene != by->scene) || (strcmp(part->group, by->group) == 0 && part->asked != by->asked));
}

static enum thud_status refuse(const struct thud_made_by *by, const struct part *part, struct thud_error *err)
{
    bool same = strcmp(part->what, by->what) == 0;
    thud_error_in(err, THUD_INPUT, by->folder, 0,
                  "the folder holds the results of another scene or study: %.200s; this is %s%.200s", part->what,
                  same ? "the same with other values in scene or motion, " : "", by->what);
    thud_error_allow(err, "another folder, or --replace, which removes what was written there");
    return THUD_INPUT;
}

enum thud_status thud_made_by_check(const struct thud_made_by *by, struct thud_error *err)
{
    char *text = NULL, *at;
    struct part part;
    enum thud_status status = thud_folder_check(by->folder, err);
    if (status == THUD_OK)
        status = read_list(by->folder, &text, err);
    for (at = text; status == THUD_OK && next_part(by->folder, &at, &part);) {
        if (part.files.failed)
            status = thud_error_set(err, THUD_MEMORY, "out of memory");
        else if (!by->replace && is_other(by, &part))
            status = refuse(by, &part, err);
        thud_text_clear(&part.files);
    }
    free(text);
    return status;
}

/* The files of a part, and folders below that they leave empty. */
static void remove_files(const char *folder, struct thud_text *files)
{
    char path[PATH_ROOM];
    for (char *at = files->data, *end; at && *at; at = end + 1) {
        end = strchr(at, '\n');
        *end = '\0';
        if (!path_in(folder, at + 5, path) || unlink(path) != 0)
            continue;
        for (char *slash; (slash = strrchr(path, '/')) != NULL && slash > path + strlen(folder);) {
            *slash = '\0';
            if (rmdir(path) != 0)
                break;
        }
    }
}

enum thud_status thud_made_by_enter(const struct thud_made_by *by, struct thud_error *err)
{
    char *text = NULL, *at;
    struct part part;
    written.folder[0] = '\0';
    thud_text_clear(&written.files);
    enum thud_status status = thud_made_by_check(by, err);
    if (status == THUD_OK)
        status = read_list(by->folder, &text, err);
    for (at = text; status == THUD_OK && next_part(by->folder, &at, &part);) {
        if (is_other(by, &part))
            remove_files(by->folder, &part.files);
        else if (is_own(by, &part))
            thud_text_append(&written.files, "%s", part.files.data ? part.files.data : "");
        thud_text_clear(&part.files);
    }
    free(text);
    if (status == THUD_OK)
        snprintf(written.folder, sizeof written.folder, "%s", by->folder);
    return status;
}

enum thud_status thud_made_by_begin(const struct thud_made_by *by, struct thud_error *err)
{
    enum thud_status status = thud_folder_make(by->folder, err);
    return status == THUD_OK ? thud_made_by_enter(by, err) : status;
}

static int compare_lines(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* The files by name, whatever the order in which a study that was stopped and gone on with wrote them. */
static void put_sorted(const struct thud_text *files, struct thud_text *out)
{
    size_t n = 0;
    for (const char *c = files->data; c && *c; c++)
        n += *c == '\n';
    const char **line = malloc((n + 1) * sizeof *line);
    const char *at = files->data;
    out->failed |= !line;
    for (size_t i = 0; line && i < n; at = strchr(at, '\n') + 1)
        line[i++] = at;
    if (line)
        qsort(line, n, sizeof *line, compare_lines);
    for (size_t i = 0; line && i < n; i++)
        thud_text_bytes(out, line[i], strcspn(line[i], "\n") + 1);
    free(line);
}

/* What the tables of the folder are made of. It is a file of the list too. */
static enum thud_status write_description(const struct thud_made_by *by, struct thud_text *list, struct thud_error *err)
{
    struct thud_text text = {0};
    enum thud_status status =
        list->failed || !by->schema ? THUD_OK : thud_data_package(by->folder, list->data, by->schema, &text, err);
    if (status == THUD_OK && text.size == 0)
        return THUD_OK;
    return thud_text_save(&text, by->folder, THUD_DATA_PACKAGE_FILE, status, err);
}

enum thud_status thud_made_by_keep(const struct thud_made_by *by, struct thud_error *err)
{
    char *text = NULL, *at;
    struct thud_text out = {0};
    struct part part;
    enum thud_status status = read_list(by->folder, &text, err);
    thud_text_append(&out, "%s\n", heading);
    for (at = text; status == THUD_OK && next_part(by->folder, &at, &part);) {
        if (!is_own(by, &part) && !is_other(by, &part) && part.files.size > 0) /* what was replaced is no part */
            thud_text_append(&out, "made %s %016llx %016llx %s\n%s", part.group, part.scene, part.asked, part.what,
                             part.files.data);
        out.failed |= part.files.failed;
        thud_text_clear(&part.files);
    }
    free(text);
    thud_text_append(&out, "made %s %016llx %016llx %s\n", by->group, by->scene, by->asked, by->what);
    size_t own = out.size;
    put_sorted(&written.files, &out);
    out.failed |= written.files.failed;
    if (status == THUD_OK)
        status = write_description(by, &out, err);
    out.size = own;
    put_sorted(&written.files, &out);
    return thud_text_save(&out, by->folder, THUD_MADE_BY_FILE, status, err);
}

enum thud_status thud_made_by_end(const struct thud_made_by *by, enum thud_status before, struct thud_error *err)
{
    if (before != THUD_OK && before != THUD_GNUPLOT)
        return before;
    enum thud_status status = thud_made_by_keep(by, before == THUD_OK ? err : NULL);
    return before == THUD_OK ? status : before;
}
