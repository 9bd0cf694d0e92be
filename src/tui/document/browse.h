/* Files to choose from: of the working folder, the preset's own and those that come with thud, or of any other folder,
 * each with a few words on what is in it. */
#pragma once

#include <stdbool.h>

#include "io/file/paths.h"

enum thud_browse_kind { THUD_BROWSE_RECORDS, THUD_BROWSE_PRESETS };

struct thud_browse_item {
    char name[256];  /* by which it is asked for: a name, or a path from the working folder */
    char path[1024]; /* where it is */
    bool folder;     /* `name` ends with a slash */
    bool read;       /* `about` says what is in it */
    char about[64];  /* "0.343g 0.01s 54s": peak, step, duration; "4+6 storeys  10 cm"; empty: nothing of the kind */
};

struct thud_browse {
    enum thud_browse_kind kind;
    int n;
    struct thud_browse_item *item; /* (n) files, then folders, by name */
};

/* Lists the files again. `folder`: one with a slash at its end; empty: the working folder, the preset's and the shipped
 * ones together. What cannot be read is left out. */
void thud_browse_list(struct thud_browse *browse, enum thud_browse_kind kind, const struct thud_paths *paths,
                      const char *preset_path, const char *folder);
/* Reads the file at the first call. */
const char *thud_browse_about(struct thud_browse *browse, int index);
void thud_browse_clear(struct thud_browse *browse);
