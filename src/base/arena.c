#include "base/arena.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#if defined __SANITIZE_ADDRESS__
#define POISONS 1
#elif defined __has_feature
#if __has_feature(address_sanitizer)
#define POISONS 1
#endif
#endif

#ifdef POISONS
#include <sanitizer/asan_interface.h>
/* Elements behind an array that are poisoned: a row of the Jacobian may belong to one of several storeys, not to a
 * contact. */
enum { BEHIND = 8, BEHIND_LEAST = 64 };
#else
enum { BEHIND = 0, BEHIND_LEAST = 0 };
#define ASAN_POISON_MEMORY_REGION(at, bytes) ((void)(at), (void)(bytes))
#endif

static size_t whole(size_t bytes)
{
    return (bytes + 15) / 16 * 16;
}

size_t thud_arena_room(size_t count, size_t size)
{
    return whole(count * size) + whole(BEHIND * size + BEHIND_LEAST);
}

bool thud_arena_open(struct thud_arena *arena, size_t bytes)
{
    arena->next = calloc(1, bytes + 1);
    arena->end = arena->next ? arena->next + bytes : NULL;
    return arena->next != NULL;
}

void *thud_arena_take(struct thud_arena *arena, size_t count, size_t size)
{
    char *piece = arena->next;
    arena->next += thud_arena_room(count, size);
    assert(arena->next <= arena->end);
    ASAN_POISON_MEMORY_REGION(piece + count * size, (size_t)(arena->next - piece) - count * size);
    return piece;
}

void thud_blocks_free(struct thud_blocks *blocks)
{
    for (void **block = blocks->last, **before; block; block = before) {
        before = *block;
        free(block);
    }
    blocks->last = NULL;
}

enum thud_status thud_arena_lay(struct thud_blocks *blocks, const struct thud_piece *piece, struct thud_error *err)
{
    struct thud_arena arena;
    size_t bytes = blocks ? thud_arena_room(1, sizeof *blocks->last) : 0;
    for (const struct thud_piece *p = piece; p->pointer; p++)
        bytes += thud_arena_room(p->count, p->size);
    const bool opened = thud_arena_open(&arena, bytes);
    if (opened && blocks) {
        void **block = thud_arena_take(&arena, 1, sizeof *block);
        *block = blocks->last;
        blocks->last = block;
    }
    for (; piece->pointer; piece++) {
        const void *at = opened ? thud_arena_take(&arena, piece->count, piece->size) : NULL;
        memcpy(piece->pointer, &at, sizeof at); /* all pointers to objects look alike */
    }
    return opened ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
}
