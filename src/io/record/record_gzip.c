/* gzip files (RFC 1952) by zlib, which checks sums and lengths. */
#include "io/record/record_source.h"

#include <stdbool.h>
#include <stdlib.h>

#include <zlib.h>

enum { GZIP_ALONE = 15 + 16, ROOM_LEAST = 1 << 16 };

struct unpacked {
    char *text;
    size_t length, capacity, most;
};

static enum thud_status make_room(struct unpacked *u, struct thud_error *err)
{
    size_t capacity = u->capacity ? 2 * u->capacity : ROOM_LEAST;
    if (capacity > u->most + 1)
        capacity = u->most + 1;
    if (capacity <= u->capacity) {
        thud_error_set(err, THUD_INPUT, "the file is too large when it is unpacked");
        thud_error_allow(err, "at most %zu bytes", u->most);
        return THUD_INPUT;
    }
    char *more = realloc(u->text, capacity + 1);
    if (!more)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    u->text = more;
    u->capacity = capacity;
    return THUD_OK;
}

/* zlib counts in unsigned int: what is left is handed over in pieces. */
static unsigned clip_length(size_t left)
{
    return left > (1u << 30) ? 1u << 30 : (unsigned)left;
}

/* One call of inflate with what room there is. */
static int inflate_once(z_stream *stream, const char *end, struct unpacked *u)
{
    size_t room = u->capacity - u->length;
    stream->avail_in = clip_length((size_t)(end - (const char *)stream->next_in));
    stream->next_out = (Bytef *)u->text + u->length;
    stream->avail_out = clip_length(room);
    unsigned offered = stream->avail_out;
    int result = inflate(stream, Z_NO_FLUSH);
    u->length += offered - stream->avail_out;
    return result;
}

static enum thud_status unpack_all(z_stream *stream, const char *end, struct unpacked *u, struct thud_error *err)
{
    for (;;) {
        enum thud_status status = u->length == u->capacity ? make_room(u, err) : THUD_OK;
        if (status != THUD_OK)
            return status;
        int result = inflate_once(stream, end, u);
        bool all = (const char *)stream->next_in == end;
        if (result == Z_MEM_ERROR)
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        if (result == Z_STREAM_END && all)
            return THUD_OK;
        if (result == Z_STREAM_END) {
            if (inflateReset(stream) != Z_OK) /* another member follows */
                return thud_error_set(err, THUD_MEMORY, "out of memory");
        } else if (result == Z_BUF_ERROR || (result == Z_OK && all && u->length < u->capacity)) {
            return thud_error_set(err, THUD_INPUT, "the compressed file is cut off");
        } else if (result != Z_OK) {
            return thud_error_set(err, THUD_INPUT, "the compressed file is damaged");
        }
    }
}

enum thud_status record_gunzip(const char *packed, size_t size, size_t most, char **out, size_t *length,
                               struct thud_error *err)
{
    struct unpacked u = {.most = most};
    z_stream stream = {.next_in = (Bytef *)packed};
    *out = NULL;
    if (inflateInit2(&stream, GZIP_ALONE) != Z_OK)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = unpack_all(&stream, packed + size, &u, err);
    inflateEnd(&stream);
    if (status != THUD_OK) {
        free(u.text);
        return status;
    }
    u.text[u.length] = '\0';
    *out = u.text;
    *length = u.length;
    return THUD_OK;
}
