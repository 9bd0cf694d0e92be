/* Status that every fallible function returns, and its message. */
#pragma once

#ifdef __FAST_MATH__
#error "thud is not to be compiled with -ffast-math: NaN and infinity carry meaning, and sums keep their order"
#endif

#include "thud.h" /* enum thud_status, struct thud_error and thud_error_text are the library's */

#if defined(__GNUC__)
#define THUD_PRINTF(fmt, args) __attribute__((format(printf, fmt, args)))
#else
#define THUD_PRINTF(fmt, args)
#endif

/* thud_error_set(err, status, fmt, ...) writes the message and evaluates to `status`, for `return thud_error_set(...)`;
 * `err` may be NULL. It is a macro so that compilers and analysers see which status a caller returns. `status` is
 * evaluated twice. */
#define thud_error_set(err, status, ...) thud_error_given(thud_error_write((err), (status), __VA_ARGS__), (status))
int thud_error_write(struct thud_error *err, enum thud_status status, const char *fmt, ...) THUD_PRINTF(3, 4);
static inline enum thud_status thud_error_given(int written, enum thud_status status)
{
    (void)written;
    return status;
}

/* Does the same with a key and the allowed values; either may be NULL. */
#define thud_error_refuse(err, status, key, allowed, ...)                                                              \
    thud_error_given(thud_error_write_whole((err), (status), (key), (allowed), __VA_ARGS__), (status))
int thud_error_write_whole(struct thud_error *err, enum thud_status status, const char *key, const char *allowed,
                           const char *fmt, ...) THUD_PRINTF(5, 6);

/* Does the same with a file and its line; line 0: the whole file. */
#define thud_error_in(err, status, file, line, ...)                                                                    \
    thud_error_given(thud_error_write_in((err), (status), (file), (line), __VA_ARGS__), (status))
int thud_error_write_in(struct thud_error *err, enum thud_status status, const char *file, int line, const char *fmt,
                        ...) THUD_PRINTF(5, 6);

/* Add a part to an error already set. */
void thud_error_place(struct thud_error *err, const char *file, int line, int column);
void thud_error_key(struct thud_error *err, const char *fmt, ...) THUD_PRINTF(2, 3);
void thud_error_allow(struct thud_error *err, const char *fmt, ...) THUD_PRINTF(2, 3);
