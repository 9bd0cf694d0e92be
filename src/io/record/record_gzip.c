/* gzip files (RFC 1952) by zlib, which checks sums and lengths. */
#include "io/record/record_source.h"

#include <zlib.h>

enum { GZIP_ALONE = 15 + 16, ROOM = 1 << 16 };

/* zlib counts in unsigned int: what is left is handed over in pieces. */
static unsigned clip_length(size_t left)
{
    return left > (1u << 30) ? 1u << 30 : (unsigned)left;
}

static enum thud_status unpack_all(z_stream *stream, const char *end, size_t most, struct thud_text *out,
                                   struct thud_error *err)
{
    Bytef room[ROOM];
    for (;;) {
        stream->avail_in = clip_length((size_t)(end - (const char *)stream->next_in));
        stream->next_out = room;
        stream->avail_out = ROOM;
        int result = inflate(stream, Z_NO_FLUSH);
        bool all = (const char *)stream->next_in == end;
        thud_text_bytes(out, (const char *)room, ROOM - stream->avail_out);
        if (result == Z_MEM_ERROR || out->failed)
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        if (out->size > most) {
            thud_error_set(err, THUD_INPUT, "the file is too large when it is unpacked");
            thud_error_allow(err, "at most %zu bytes", most);
            return THUD_INPUT;
        }
        if (result == Z_STREAM_END && all)
            return THUD_OK;
        if (result == Z_STREAM_END) {
            if (inflateReset(stream) != Z_OK) /* another member follows */
                return thud_error_set(err, THUD_MEMORY, "out of memory");
        } else if (result == Z_BUF_ERROR || (result == Z_OK && all && stream->avail_out > 0)) {
            return thud_error_set(err, THUD_INPUT, "the compressed file is cut off");
        } else if (result != Z_OK) {
            return thud_error_set(err, THUD_INPUT, "the compressed file is damaged");
        }
    }
}

enum thud_status record_gunzip(const char *packed, size_t size, size_t most, struct thud_text *out,
                               struct thud_error *err)
{
    z_stream stream = {.next_in = (Bytef *)packed};
    if (inflateInit2(&stream, GZIP_ALONE) != Z_OK)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    enum thud_status status = unpack_all(&stream, packed + size, most, out, err);
    inflateEnd(&stream);
    if (status != THUD_OK)
        thud_text_clear(out);
    return status;
}
