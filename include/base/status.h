/* What every fallible function returns, and the message that goes with it. */
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

/* thud_error_set(err, status, fmt, ...) writes the message and gives `status`, so that a caller can write `return
 * thud_error_set(...)`; `err` may be NULL. A macro, so that whoever compiles or checks the caller sees that what is
 * given is `status` and no other. `status` is evaluated twice. */
#define thud_error_set(err, status, ...) thud_error_given(thud_error_write((err), (status), __VA_ARGS__), (status))
int thud_error_write(struct thud_error *err, enum thud_status status, const char *fmt, ...) THUD_PRINTF(3, 4);
static inline enum thud_status thud_error_given(int written, enum thud_status status)
{
    (void)written;
    return status;
}

/* The same with a key and with what is allowed; either may be NULL. */
#define thud_error_refuse(err, status, key, allowed, ...)                                                              \
    thud_error_given(thud_error_write_whole((err), (status), (key), (allowed), __VA_ARGS__), (status))
int thud_error_write_whole(struct thud_error *err, enum thud_status status, const char *key, const char *allowed,
                           const char *fmt, ...) THUD_PRINTF(5, 6);

/* The same with the file it is about and a line of it; line 0: all of it. */
#define thud_error_in(err, status, file, line, ...)                                                                    \
    thud_error_given(thud_error_write_in((err), (status), (file), (line), __VA_ARGS__), (status))
int thud_error_write_in(struct thud_error *err, enum thud_status status, const char *file, int line, const char *fmt,
                        ...) THUD_PRINTF(5, 6);

/* Add a part to an error already set. */
void thud_error_place(struct thud_error *err, const char *file, int line, int column);
void thud_error_key(struct thud_error *err, const char *fmt, ...) THUD_PRINTF(2, 3);
void thud_error_allow(struct thud_error *err, const char *fmt, ...) THUD_PRINTF(2, 3);
