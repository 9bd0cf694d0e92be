/* Allocates pieces of one block. Under the address sanitizer the space after each piece is poisoned, so an index past
 * the end of an array is also detected inside the block. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

struct thud_arena {
    char *next, *end;
};

/* Returns the bytes that a piece of `count` elements of `size` bytes takes. */
size_t thud_arena_room(size_t count, size_t size);
/* Allocates a block of this size, all 0, to be freed with free; false: out of memory. */
bool thud_arena_open(struct thud_arena *arena, size_t bytes);
/* Returns the next piece, aligned to 16 bytes. */
void *thud_arena_take(struct thud_arena *arena, size_t count, size_t size);
