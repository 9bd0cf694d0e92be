#include "io/file/output.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

#include "io/file/file_private.h"

static enum thud_status failed(const struct thud_output *out, int why, struct thud_error *err)
{
    return thud_error_in(err, THUD_OUTPUT, out->path, 0, "cannot be written: %s", strerror(why));
}

enum thud_status thud_output_open(const char *path, struct thud_output *out, struct thud_error *err)
{
    out->fd = -1;
    if (strlen(path) >= sizeof out->path)
        return thud_error_set(err, THUD_OUTPUT, "the name of the file is too long");
    strcpy(out->path, path);
    out->fd = thud_file_open_beside(path, out->part, sizeof out->part);
    return out->fd >= 0 ? THUD_OK : failed(out, errno, err);
}

enum thud_status thud_output_drain(struct thud_output *out, struct thud_text *text, size_t least,
                                   struct thud_error *err)
{
    if (text->failed)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    if (text->size < least || text->size == 0)
        return THUD_OK;
    for (size_t done = 0; done < text->size;) {
        ssize_t n = write(out->fd, text->data + done, text->size - done);
        if (n < 0 && errno != EINTR)
            return failed(out, errno, err);
        done += n > 0 ? (size_t)n : 0;
    }
    text->size = 0;
    return THUD_OK;
}

enum thud_status thud_output_commit(struct thud_output *out, struct thud_error *err)
{
    int why = fsync(out->fd) != 0 ? errno : 0;
    if (why)
        thud_file_remove(out->part);
    else
        why = thud_file_replace(out->part, out->path);
    close(out->fd);
    out->fd = -1;
    return why ? failed(out, why, err) : THUD_OK;
}

void thud_output_abandon(struct thud_output *out)
{
    if (out->fd < 0)
        return;
    thud_file_remove(out->part);
    close(out->fd);
    out->fd = -1;
}
