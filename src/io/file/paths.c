#define _GNU_SOURCE /* dladdr, which POSIX has since 2024 */
#include "io/file/paths.h"

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/nearest.h"

#ifndef THUD_DATADIR
#define THUD_DATADIR "/usr/local/share/thud"
#endif

static const char own_address = 0; /* an address in this library */

bool thud_path_is_folder(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 && S_ISDIR(about.st_mode);
}

/* Something that can be read as a file; what it is, reading it will say. */
static bool is_there(const char *path)
{
    struct stat about;
    return strcmp(path, "-") == 0 || (stat(path, &about) == 0 && !S_ISDIR(about.st_mode));
}

/* Cuts a path's last part off; false where there is none. */
static bool cut(char *path)
{
    char *slash = strrchr(path, '/');
    if (slash)
        *slash = '\0';
    return slash != NULL;
}

/* The folder of data beside a file, or under the parent of its folder. */
static bool find_beside(char *file, char *folder, size_t size)
{
    static const char *const beside[] = {"", "/share/thud"};
    char presets[512];
    for (size_t i = 0; i < sizeof beside / sizeof *beside && cut(file); i++) {
        snprintf(presets, sizeof presets, "%s%s/presets", file, beside[i]);
        if (thud_path_is_folder(presets)) {
            snprintf(folder, size, "%s%s", file, beside[i]);
            return true;
        }
    }
    return false;
}

/* The folder that holds presets/ and records/: of the shared library that this is part of, else of the program, else as
 * built. */
static void find_data(char *folder, size_t size)
{
    char file[400];
    Dl_info here;
    if (dladdr(&own_address, &here) && here.dli_fname && strstr(here.dli_fname, ".so")) {
        snprintf(file, sizeof file, "%s", here.dli_fname);
        if (find_beside(file, folder, size))
            return;
    }
    ssize_t n = readlink("/proc/self/exe", file, sizeof file - 1);
    file[n > 0 ? n : 0] = '\0';
    if (!find_beside(file, folder, size))
        snprintf(folder, size, "%s", THUD_DATADIR);
}

void thud_paths_find(struct thud_paths *paths)
{
    char folder[480];
    find_data(folder, sizeof folder);
    snprintf(paths->presets, sizeof paths->presets, "%s/presets", folder);
    snprintf(paths->records, sizeof paths->records, "%s/records", folder);
}

static bool fits(int written, unsigned long size)
{
    return written >= 0 && (unsigned long)written < size;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* Without `ending`; for what may have been meant. */
static void read_names(const char *folder, const char *ending, struct thud_file_names *names)
{
    DIR *dir = opendir(folder);
    struct dirent *entry;
    size_t tail = strlen(ending);
    while (dir && names->n < THUD_FILES_MAX && (entry = readdir(dir)) != NULL) {
        size_t length = strlen(entry->d_name);
        if (entry->d_name[0] == '.' || length <= tail || length - tail >= THUD_FILE_NAME_MAX ||
            strcmp(entry->d_name + length - tail, ending) != 0 || strcmp(entry->d_name, "README.md") == 0)
            continue;
        snprintf(names->text[names->n], THUD_FILE_NAME_MAX, "%.*s", (int)(length - tail), entry->d_name);
        names->list[names->n] = names->text[names->n];
        names->n++;
    }
    if (dir)
        closedir(dir);
    qsort(names->list, (size_t)names->n, sizeof *names->list, by_name);
}

void thud_paths_presets(const struct thud_paths *paths, struct thud_file_names *names)
{
    names->n = 0;
    read_names(paths->presets, ".yaml", names);
}

static enum thud_status not_found(const char *what, const char *name, const char *folder, const char *ending,
                                  struct thud_error *err)
{
    if (thud_path_is_folder(name))
        return thud_error_in(err, THUD_INPUT, name, 0, "is a folder, not a file");
    struct thud_file_names *names = calloc(1, sizeof *names);
    const char *near = NULL;
    char list[sizeof err->allowed] = "";
    size_t n = 0;
    if (names) {
        read_names(folder, ending, names);
        near = thud_nearest(name, names->list, names->n);
    }
    for (int i = 0; names && i < names->n && n < sizeof list; i++)
        n += (size_t)snprintf(list + n, sizeof list - n, "%s%s", i ? ", " : "", names->list[i]);
    if (near)
        thud_error_set(err, THUD_INPUT, "no %s \"%.200s\"; did you mean \"%s\"?", what, name, near);
    else
        thud_error_set(err, THUD_INPUT, "no %s \"%.200s\"", what, name);
    if (n > 0 && n < sizeof list)
        thud_error_allow(err, "a file, or one of %s", list);
    else
        thud_error_allow(err, "a file, or a name in %.200s", folder);
    free(names);
    return THUD_INPUT;
}

static enum thud_status too_long(struct thud_error *err)
{
    return thud_error_set(err, THUD_INPUT, "the file's name is too long");
}

enum thud_status thud_paths_preset(const struct thud_paths *paths, const char *name, char *path, unsigned long size,
                                   struct thud_error *err)
{
    static const char *const endings[] = {".yaml", ""};
    bool plain = *name && !strchr(name, '/');
    for (size_t i = 0; plain && i < sizeof endings / sizeof *endings; i++) {
        if (*endings[i] == '\0' && is_there(name))
            break; /* towers.yaml: from the working folder first */
        if (!fits(snprintf(path, size, "%s/%s%s", paths->presets, name, endings[i]), size))
            return too_long(err);
        if (is_there(path))
            return THUD_OK;
    }
    if (!fits(snprintf(path, size, "%s", name), size))
        return too_long(err);
    if (is_there(path))
        return THUD_OK;
    if (*name && !fits(snprintf(path, size, "%s.yaml", name), size))
        return too_long(err);
    if (*name && is_there(path))
        return THUD_OK;
    return not_found("preset", name, paths->presets, ".yaml", err);
}

/* As given, or beside the preset; *found: there is such a file. */
static enum thud_status look_beside(const char *preset_path, const char *name, char *path, unsigned long size,
                                    bool *found, struct thud_error *err)
{
    const char *slash = preset_path && name[0] != '/' ? strrchr(preset_path, '/') : NULL;
    if (!fits(snprintf(path, size, "%s", name), size))
        return too_long(err);
    *found = is_there(path);
    if (*found || !slash)
        return THUD_OK;
    if (!fits(snprintf(path, size, "%.*s/%s", (int)(slash - preset_path), preset_path, name), size))
        return too_long(err);
    *found = is_there(path);
    return THUD_OK;
}

enum thud_status thud_paths_beside(const char *preset_path, const char *name, char *path, unsigned long size,
                                   struct thud_error *err)
{
    bool found = false;
    enum thud_status status = look_beside(preset_path, name, path, size, &found, err);
    if (status != THUD_OK || found)
        return status;
    struct thud_paths paths;
    thud_paths_find(&paths);
    if (name[0] != '/' && fits(snprintf(path, size, "%s/%s", paths.presets, name), size) && is_there(path))
        return THUD_OK;
    return thud_error_refuse(err, THUD_INPUT, NULL,
                             "a path from the working folder, beside the preset, or in the presets folder",
                             "there is no file \"%.200s\"", name);
}

enum thud_status thud_paths_record(const struct thud_paths *paths, const char *preset_path, const char *name,
                                   char *path, unsigned long size, struct thud_error *err)
{
    bool found = false;
    enum thud_status status = look_beside(preset_path, name, path, size, &found, err);
    if (status != THUD_OK || found)
        return status;
    if (name[0] != '/') {
        if (!fits(snprintf(path, size, "%s/%s", paths->records, name), size))
            return too_long(err);
        if (is_there(path))
            return THUD_OK;
    }
    not_found("ground motion", name, paths->records, "", err);
    thud_error_key(err, "record.file");
    return THUD_INPUT;
}

void thud_folder_names_free(char **names, size_t count)
{
    for (size_t i = 0; names && i < count; i++)
        free(names[i]);
    free(names);
}

/* Something to read that is neither prose nor a list of ground motions. */
static bool may_be_record(const char *folder, const char *name)
{
    static const char *const others[] = {".md", ".list"};
    char path[2048];
    struct stat about;
    const char *suffix = strrchr(name, '.');
    for (size_t i = 0; suffix && i < sizeof others / sizeof *others; i++)
        if (strcmp(suffix, others[i]) == 0)
            return false;
    int n = snprintf(path, sizeof path, "%s/%s", folder, name);
    return n > 0 && (size_t)n < sizeof path && (stat(path, &about) != 0 || S_ISREG(about.st_mode));
}

enum thud_status thud_folder_names(const char *folder, char ***names, size_t *count, size_t *others,
                                   struct thud_error *err)
{
    DIR *dir = opendir(folder);
    *names = NULL;
    *count = 0;
    if (!dir)
        return thud_error_in(err, THUD_INPUT, folder, 0, "%s", strerror(errno));
    bool failed = false;
    size_t left_out = 0;
    for (const struct dirent *entry; !failed && (entry = readdir(dir)) != NULL;) {
        if (entry->d_name[0] == '.')
            continue;
        if (!may_be_record(folder, entry->d_name)) {
            left_out++;
            continue;
        }
        char *name = strdup(entry->d_name);
        char **more = name ? realloc(*names, (*count + 1) * sizeof **names) : NULL;
        if (more) {
            *names = more;
            more[(*count)++] = name;
        } else {
            free(name);
            failed = true;
        }
    }
    closedir(dir);
    if (others)
        *others = left_out;
    if (failed) {
        thud_folder_names_free(*names, *count);
        *names = NULL;
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    }
    if (*names)
        qsort(*names, *count, sizeof **names, by_name);
    return THUD_OK;
}
