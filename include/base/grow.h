/* Arrays that grow. */
#pragma once

#include <stddef.h>
#include <stdlib.h>

/* Makes room for one more behind the n members of an array that only this function has allocated, in blocks of a power
 * of two. Returns the array, which may have moved; NULL when out of memory: it stays as it was. */
static inline void *thud_grow(void *array, size_t n, size_t size)
{
    enum { LEAST = 16 };
    if (n < LEAST ? n > 0 : (n & (n - 1)) != 0)
        return array;
    return realloc(array, (n > 0 ? 2 * n : LEAST) * size);
}
