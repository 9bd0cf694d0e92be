/* Files written whole; apart from what reads them, so that who only reads has no list of files in the making. */
#include "io/file/file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
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

enum thud_status thud_file_begin(const char *path, struct thud_file_draft *out, struct thud_error *err)
{
    *out = (struct thud_file_draft){.fd = -1};
    if (strlen(path) >= sizeof out->path)
        return thud_error_set(err, THUD_OUTPUT, "the name of the file is too long");
    strcpy(out->path, path);
    out->fd = thud_file_open_beside(path, out->part, sizeof out->part);
    out->is_open = out->fd >= 0;
    return out->is_open ? THUD_OK : not_written(path, errno, err);
}

enum thud_status thud_file_add(struct thud_file_draft *draft, struct thud_text *text, size_t least,
                               struct thud_error *err)
{
    if (text->failed)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    if (text->size < least || text->size == 0)
        return THUD_OK;
    int why = write_all(draft->fd, text->data, text->size);
    text->size = 0;
    return why ? not_written(draft->path, why, err) : THUD_OK;
}

static int sync_file(int fd)
{
    return fsync(fd) != 0 ? errno : 0;
}

enum thud_status thud_file_draft(const char *path, const char *text, size_t size, enum thud_file_owner owner,
                                 struct thud_file_draft *out, struct thud_error *err)
{
    struct stat about;
    char whole[PATH_MAX];
    bool named = owner == THUD_FILE_NAMED, there = (named ? stat(path, &about) : lstat(path, &about)) == 0;
    *out = (struct thud_file_draft){0};
    if (there && S_ISDIR(about.st_mode))
        return not_written(path, EISDIR, err);
    bool regular = there && S_ISREG(about.st_mode);
    if (there && !regular && named) { /* a pipe or a terminal cannot be replaced */
        int why = write_through(path, text, size);
        return why ? not_written(path, why, err) : THUD_OK;
    }
    if (there && named && realpath(path, whole)) /* a link stays a link */
        path = whole;
    enum thud_status status = thud_file_begin(path, out, err);
    if (status != THUD_OK)
        return status;
    int why = write_all(out->fd, text, size);
    if (!why && regular && fchmod(out->fd, about.st_mode & 07777) != 0)
        why = errno;
    if (!why)
        why = sync_file(out->fd);
    out->is_synced = true;
    if (!why)
        return THUD_OK;
    thud_file_drop(out);
    return not_written(path, why, err);
}

void thud_file_drop(struct thud_file_draft *draft)
{
    if (!draft->is_open)
        return;
    thud_file_remove(draft->part);
    close(draft->fd);
    draft->is_open = false;
}

enum thud_status thud_file_keep(struct thud_file_draft *draft, struct thud_error *err)
{
    int why = draft->is_open && !draft->is_synced ? sync_file(draft->fd) : 0;
    if (why)
        thud_file_drop(draft);
    if (draft->is_open) {
        why = thud_file_replace(draft->part, draft->path);
        close(draft->fd);
        draft->is_open = false;
    }
    return why ? not_written(draft->path, why, err) : THUD_OK;
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
        return thud_file_refuse(err, THUD_OUTPUT, path, "is not a valid folder name");
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

enum thud_status thud_text_print(struct thud_text *text, struct thud_error *err)
{
    if (text->data && isatty(STDOUT_FILENO))
        text->size = thud_text_shown(text->data, "\n\t");
    enum thud_status status = THUD_OK;
    if (text->failed)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    else if (text->size > 0 && (fwrite(text->data, 1, text->size, stdout) != text->size || fflush(stdout) != 0))
        status = thud_error_set(err, THUD_OUTPUT, "standard output: %s", strerror(errno));
    thud_text_clear(text);
    return status;
}
