/* Keys from the bytes that a terminal sends. No terminal here: bytes come in pieces of any size.
 *
 * An escape sequence is read whole before it means anything, so an unknown one is dropped and none of its bytes is
 * taken for a key:
 *
 *     CSI   ESC [  parameters 0x30-0x3f, intermediates 0x20-0x2f, one final byte 0x40-0x7e   (ECMA-48, 5.4)
 *     SS3   ESC O  one byte
 *     DCS, OSC, SOS, PM, APC   ESC P, ], X, ^, _   up to ESC \ or BEL
 *     Alt   ESC and one character
 *
 * A bracketed paste (ESC [ 200 ~ up to ESC [ 201 ~) is one key with its text. Reports of the mouse are those of xterm,
 * the old form (ESC [ M and three bytes) and the one with decimal numbers (ESC [ < b ; x ; y M or m). */
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { THUD_DECODE_BYTES = 4096, THUD_DECODE_LEARNED = 24, THUD_PASTE_MAX = 1 << 16 };

struct thud_decode {
    unsigned char byte[THUD_DECODE_BYTES]; /* (n) not yet understood */
    size_t n;
    struct {
        char sequence[16];
        int key;
    } learned[THUD_DECODE_LEARNED]; /* the terminal's own sequences, from its description */
    int nlearned;
    bool pasting;
    char paste[THUD_PASTE_MAX]; /* text of the last THUD_KEY_PASTE; what is longer is cut off */
    size_t paste_size;
    int mouse_x, mouse_y; /* of the last report, from 0 */
    bool attributes;      /* the terminal has said what it can (DA1) */
    bool sixel;           /* and that it draws these */
};

void thud_decode_init(struct thud_decode *decode);
/* Another sequence for a key; those of xterm, PuTTY, rxvt and the Linux console are known. */
void thud_decode_learn(struct thud_decode *decode, const char *sequence, int key);
/* Room for bytes that may be read next. */
size_t thud_decode_room(const struct thud_decode *decode);
void thud_decode_add(struct thud_decode *decode, const char *bytes, size_t n);
/* The next key. THUD_KEY_NONE with *more: the bytes so far may be the beginning of one; without: there is none, or one
 * that means nothing was dropped (*dropped). `ended`: no byte follows soon, so what is there is all (a lone ESC is the
 * key). */
int thud_decode_next(struct thud_decode *decode, bool ended, bool *more);
