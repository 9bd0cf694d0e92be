/* What every fallible function returns, and the message that goes with it. */
#ifndef THUD_BASE_STATUS_H
#define THUD_BASE_STATUS_H

#ifdef __FAST_MATH__
#error "thud is not to be compiled with -ffast-math: NaN and infinity carry meaning, and sums keep their order"
#endif

#if defined(__GNUC__)
#define THUD_PRINTF(fmt, args) __attribute__((format(printf, fmt, args)))
#else
#define THUD_PRINTF(fmt, args)
#endif

/* The first seven are the program's exit statuses; the rest are mapped to one of them by the program. */
enum thud_status {
    THUD_OK = 0,
    THUD_CHECK = 1,    /* a check did not hold */
    THUD_USAGE = 2,    /* wrong usage, or no terminal */
    THUD_INPUT = 3,    /* bad input */
    THUD_DIVERGED = 4, /* the integration failed */
    THUD_GNUPLOT = 5,  /* gnuplot is missing or failed */
    THUD_OUTPUT = 6,   /* output could not be written */
    THUD_MEMORY = 7,   /* out of memory */
    THUD_CANCELLED = 8 /* stopped on request; what was done is kept */
};

/* One message: FILE:LINE:COLUMN: KEY: what is wrong (what is allowed). Unused parts are empty or 0. */
struct thud_error {
    enum thud_status status;
    char file[512];
    int line;   /* from 1; 0 unknown */
    int column; /* from 1; 0 unknown */
    char key[128];
    char what[512];
    char allowed[256];
};

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

/* Add a part to an error already set. */
void thud_error_place(struct thud_error *err, const char *file, int line, int column);
void thud_error_key(struct thud_error *err, const char *key);
void thud_error_allow(struct thud_error *err, const char *fmt, ...) THUD_PRINTF(2, 3);

/* The whole message in one line without a newline; returns `text`. Control characters are shown as `?`. */
char *thud_error_text(const struct thud_error *err, char *text, unsigned long size);

#endif
