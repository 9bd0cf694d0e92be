/* Allocates pieces of one block. Under the address sanitizer the space after each piece is poisoned, so an index past
 * the end of an array is also detected inside the block. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

struct thud_arena {
    char *next, *end;
};

/* Returns the bytes that a piece of `count` elements of `size` bytes takes. */
size_t thud_arena_room(size_t count, size_t size);
/* Allocates a block of this size, all 0, to be freed with free; false: out of memory. */
bool thud_arena_open(struct thud_arena *arena, size_t bytes);
/* Returns the next piece, aligned to 16 bytes. */
void *thud_arena_take(struct thud_arena *arena, size_t count, size_t size);

/* Pieces of a block: where the pointer to each stands, and how many elements it has. */
struct thud_piece {
    void *pointer;
    size_t count, size;
};
#define THUD_PIECE(pointer, count)                                                                                     \
    {                                                                                                                  \
        &(pointer), (size_t)(count), sizeof *(pointer)                                                                 \
    }

/* Blocks that one owner frees together. */
struct thud_blocks {
    void **last; /* each begins with the one before it; NULL: none */
};
void thud_blocks_free(struct thud_blocks *blocks);

/* Allocates the pieces, up to one without a pointer, as one block, all 0, and sets their pointers. It becomes one of the
 * blocks; or where these are NULL it begins with the first piece, and free of that pointer frees all. Errors: THUD_MEMORY,
 * and the pointers are NULL. */
enum thud_status thud_arena_lay(struct thud_blocks *blocks, const struct thud_piece *piece, struct thud_error *err);
#define THUD_LAY_IN(blocks, err, ...)                                                                                  \
    thud_arena_lay(blocks, (const struct thud_piece[]){__VA_ARGS__, {NULL, 0, 0}}, err)
#define THUD_LAY(err, ...) THUD_LAY_IN(NULL, err, __VA_ARGS__)
