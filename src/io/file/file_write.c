/* Files written whole; apart from what reads them, so that who only reads has no list of files in the making. */
#include "io/file/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file/file_private.h"
#include "io/file/schema.h"

/* 0, or the errno of what went wrong. */
static int write_all(int fd, const char *text, size_t size)
{
    while (size > 0) {
        ssize_t n = write(fd, text, size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return errno;
        text += n;
        size -= (size_t)n;
    }
    return 0;
}

/* A whole file beside `path`, its name in `name`, open in *fd; 0, or the errno of what went wrong. */
static int write_beside(const char *path, const struct stat *old, const char *text, size_t size, char *name,
                        size_t name_size, int *fd)
{
    *fd = thud_file_open_beside(path, name, name_size);
    if (*fd < 0)
        return errno;
    int why = write_all(*fd, text, size);
    if (!why && old && fchmod(*fd, old->st_mode & 07777) != 0)
        why = errno;
    if (!why && fsync(*fd) != 0)
        why = errno;
    if (!why)
        return 0;
    thud_file_remove(name);
    close(*fd);
    return why;
}

static int write_through(const char *path, const char *text, size_t size)
{
    int fd = open(path, O_WRONLY | O_CLOEXEC);
    int why = fd < 0 ? errno : write_all(fd, text, size);
    if (fd >= 0 && close(fd) != 0 && !why)
        why = errno;
    return why;
}

static enum thud_status not_written(const char *path, int why, struct thud_error *err)
{
    return thud_error_in(err, THUD_OUTPUT, path, 0, "cannot be written: %s", strerror(why));
}

enum thud_status thud_file_draft(const char *path, const char *text, size_t size, enum thud_file_owner owner,
                                 struct thud_file_draft *out, struct thud_error *err)
{
    struct stat about;
    bool named = owner == THUD_FILE_NAMED, there = (named ? stat(path, &about) : lstat(path, &about)) == 0;
    *out = (struct thud_file_draft){0};
    if (there && S_ISDIR(about.st_mode))
        return not_written(path, EISDIR, err);
    bool regular = there && S_ISREG(about.st_mode);
    if (there && !regular && named) { /* a pipe or a terminal cannot be replaced */
        int why = write_through(path, text, size);
        return why ? not_written(path, why, err) : THUD_OK;
    }
    char part[4200];
    out->path = there && named ? realpath(path, NULL) : NULL; /* a link stays a link */
    if (!out->path)
        out->path = strdup(path);
    int why =
        out->path ? write_beside(out->path, regular ? &about : NULL, text, size, part, sizeof part, &out->fd) : ENOMEM;
    if (!why && !(out->part = strdup(part))) {
        thud_file_remove(part);
        close(out->fd);
        why = ENOMEM;
    }
    if (!why)
        return THUD_OK;
    free(out->path);
    *out = (struct thud_file_draft){0};
    return not_written(path, why, err);
}

/* The draft's part is where it belongs or gone. */
static void end_draft(struct thud_file_draft *draft)
{
    if (draft->part)
        close(draft->fd);
    free(draft->part);
    free(draft->path);
    *draft = (struct thud_file_draft){0};
}

void thud_file_drop(struct thud_file_draft *draft)
{
    if (draft->part)
        thud_file_remove(draft->part);
    end_draft(draft);
}

enum thud_status thud_file_keep(struct thud_file_draft *draft, struct thud_error *err)
{
    int why = draft->part ? thud_file_replace(draft->part, draft->path) : 0;
    enum thud_status status = why ? not_written(draft->path, why, err) : THUD_OK;
    end_draft(draft);
    return status;
}

static enum thud_status write_as(const char *path, const char *text, size_t size, enum thud_file_owner owner,
                                 struct thud_error *err)
{
    struct thud_file_draft draft;
    enum thud_status status = thud_file_draft(path, text, size, owner, &draft, err);
    return status == THUD_OK ? thud_file_keep(&draft, err) : status;
}

enum thud_status thud_file_write(const char *path, const char *text, size_t size, struct thud_error *err)
{
    return write_as(path, text, size, THUD_FILE_NAMED, err);
}

static enum thud_status write_text(struct thud_text *text, const char *path, enum thud_file_owner owner,
                                   struct thud_error *err)
{
    enum thud_status status = text->failed ? thud_file_refuse(err, THUD_MEMORY, path, "out of memory")
                                           : write_as(path, text->data ? text->data : "", text->size, owner, err);
    thud_text_clear(text);
    return status;
}

enum thud_status thud_text_write(struct thud_text *text, const char *path, struct thud_error *err)
{
    return write_text(text, path, THUD_FILE_NAMED, err);
}

enum thud_status thud_text_save(struct thud_text *text, const char *folder, const char *name, enum thud_status before,
                                struct thud_error *err)
{
    char path[4096];
    int n = snprintf(path, sizeof path, "%s/%s", *folder ? folder : ".", name);
    if (before == THUD_OK && n >= 0 && (size_t)n < sizeof path)
        return write_text(text, path, THUD_FILE_RESULT, err);
    thud_text_clear(text);
    return before != THUD_OK ? before : thud_error_set(err, THUD_OUTPUT, "the path to %.100s is too long", name);
}

/* Every folder on the way to `path`, and itself: made, or looked at where it is there. */
static enum thud_status walk_folder(const char *path, bool make, struct thud_error *err)
{
    char part[4096];
    size_t length = strlen(path);
    if (length == 0 || length >= sizeof part)
        return thud_file_refuse(err, THUD_OUTPUT, path, "is no name for a folder");
    if (strcmp(path, "-") == 0)
        return thud_file_refuse(err, THUD_OUTPUT, path, "stands for standard output, which is no folder (./- is one)");
    memcpy(part, path, length + 1);
    for (size_t i = 1; i <= length; i++) {
        if (part[i] != '/' && part[i] != '\0')
            continue;
        char kept = part[i];
        part[i] = '\0';
        struct stat about;
        errno = EEXIST;
        if (make ? mkdir(part, 0777) != 0 && (errno != EEXIST || stat(part, &about) != 0 || !S_ISDIR(about.st_mode))
                 : stat(part, &about) == 0 && !S_ISDIR(about.st_mode)) {
            int why = errno;
            bool is_file = why == EEXIST && stat(part, &about) == 0;
            return thud_error_in(err, THUD_OUTPUT, part, 0, "the folder cannot be made: %s",
                                 is_file ? "there is a file of this name" : strerror(why));
        }
        part[i] = kept;
    }
    thud_folder_tidy(path);
    return THUD_OK;
}

enum thud_status thud_folder_make(const char *path, struct thud_error *err)
{
    return walk_folder(path, true, err);
}

enum thud_status thud_folder_check(const char *path, struct thud_error *err)
{
    return walk_folder(path, false, err);
}

enum thud_status thud_rows_save(const struct thud_rows *rows, const char *folder, enum thud_status before,
                                struct thud_error *err)
{
    struct thud_text text = {0};
    if (before == THUD_OK)
        thud_rows_csv(rows, &text);
    return thud_text_save(&text, folder, rows->schema->name, before, err);
}
