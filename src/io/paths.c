#include "io/paths.h"

#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/nearest.h"

#ifndef THUD_DATADIR
#define THUD_DATADIR "/usr/local/share/thud"
#endif

enum { NAMES_MAX = 128 };

static bool is_folder(const char *path)
{
    struct stat st;
    return stat(path, &st) == 0 && S_ISDIR(st.st_mode);
}

static bool is_file(const char *path)
{
    struct stat st;
    return stat(path, &st) == 0 && !S_ISDIR(st.st_mode);
}

/* Folder of the running program, empty when the system does not tell. */
static void program_folder(char *path, size_t size)
{
    ssize_t n = readlink("/proc/self/exe", path, size - 1);
    path[n > 0 ? n : 0] = '\0';
    char *slash = strrchr(path, '/');
    if (slash)
        *slash = '\0';
}

void thud_paths_find(struct thud_paths *paths)
{
    char program[400];
    program_folder(program, sizeof program);
    snprintf(paths->presets, sizeof paths->presets, "%s/presets", program);
    snprintf(paths->records, sizeof paths->records, "%s/records", program);
    if (is_folder(paths->presets))
        return;
    snprintf(paths->presets, sizeof paths->presets, "%s/presets", THUD_DATADIR);
    snprintf(paths->records, sizeof paths->records, "%s/records", THUD_DATADIR);
}

/* Names of the presets of a folder, without their ending; returns how many. */
static int preset_names(const char *folder, char name[NAMES_MAX][64])
{
    DIR *dir = opendir(folder);
    struct dirent *entry;
    int n = 0;
    while (dir && n < NAMES_MAX && (entry = readdir(dir))) {
        size_t length = strlen(entry->d_name);
        if (length > 5 && length - 5 < sizeof name[0] && strcmp(entry->d_name + length - 5, ".yaml") == 0)
            snprintf(name[n++], sizeof name[0], "%.*s", (int)(length - 5), entry->d_name);
    }
    if (dir)
        closedir(dir);
    return n;
}

static enum thud_status unknown_preset(const struct thud_paths *paths, const char *name, struct thud_error *err)
{
    static const char *const none = "a file, or a name such as towers";
    char known[NAMES_MAX][64];
    const char *list[NAMES_MAX];
    int n = preset_names(paths->presets, known);
    for (int i = 0; i < n; i++)
        list[i] = known[i];
    const char *nearest = thud_nearest(name, list, n);
    thud_error_set(err, THUD_INPUT, "there is no preset or file `%.200s`", name);
    if (nearest)
        thud_error_allow(err, "did you mean %s?", nearest);
    else
        thud_error_allow(err, "%s", none);
    return THUD_INPUT;
}

static enum thud_status keep(const char *from, char *path, unsigned long size, struct thud_error *err)
{
    if ((size_t)snprintf(path, size, "%s", from) >= size)
        return thud_error_set(err, THUD_INPUT, "%.100s...: the path is too long", from);
    return THUD_OK;
}

enum thud_status thud_paths_preset(const struct thud_paths *paths, const char *name, char *path, unsigned long size,
                                   struct thud_error *err)
{
    char shipped[1024];
    bool is_name = !strchr(name, '/') && name[0];
    snprintf(shipped, sizeof shipped, "%s/%.400s.yaml", paths->presets, name);
    if (is_name && is_file(shipped))
        return keep(shipped, path, size, err);
    if (is_file(name))
        return keep(name, path, size, err);
    return unknown_preset(paths, name, err);
}

enum thud_status thud_paths_record(const struct thud_paths *paths, const char *preset_path, const char *name,
                                   char *path, unsigned long size, struct thud_error *err)
{
    char at[2048];
    if (is_file(name))
        return keep(name, path, size, err);
    const char *slash = preset_path ? strrchr(preset_path, '/') : NULL;
    if (slash && name[0] != '/') {
        snprintf(at, sizeof at, "%.*s/%.1000s", (int)(slash - preset_path), preset_path, name);
        if (is_file(at))
            return keep(at, path, size, err);
    }
    snprintf(at, sizeof at, "%s/%.1000s", paths->records, name);
    if (name[0] != '/' && is_file(at))
        return keep(at, path, size, err);
    thud_error_set(err, THUD_INPUT, "there is no ground motion `%.200s`", name);
    thud_error_key(err, "record.file");
    thud_error_allow(err, "looked for from here, beside the preset, and in %.120s", paths->records);
    return THUD_INPUT;
}
