#include "tui/terminal/decode.h"

#include <string.h>

#include "base/scan.h"
#include "tui/terminal/backend.h"
#include "tui/terminal/image.h"

enum { ESC = 27, BEL = 7, UNFINISHED = -1 };

void thud_decode_init(struct thud_decode *decode)
{
    decode->n = 0;
    decode->nlearned = 0;
    decode->pasting = false;
    decode->paste_size = 0;
    decode->paste[0] = '\0';
    decode->mouse_x = decode->mouse_y = 0;
    decode->attributes = decode->sixel = false;
}

void thud_decode_learn(struct thud_decode *decode, const char *sequence, int key)
{
    size_t n = strlen(sequence);
    if (n < 2 || n >= sizeof decode->learned[0].sequence || decode->nlearned == THUD_DECODE_LEARNED ||
        sequence[0] != ESC)
        return;
    memcpy(decode->learned[decode->nlearned].sequence, sequence, n + 1);
    decode->learned[decode->nlearned++].key = key;
}

size_t thud_decode_room(const struct thud_decode *decode)
{
    return sizeof decode->byte - decode->n;
}

void thud_decode_add(struct thud_decode *decode, const char *bytes, size_t n)
{
    size_t room = thud_decode_room(decode);
    n = n < room ? n : room;
    memcpy(decode->byte + decode->n, bytes, n);
    decode->n += n;
}

static void drop(struct thud_decode *decode, size_t n)
{
    memmove(decode->byte, decode->byte + n, decode->n - n);
    decode->n -= n;
}

/* Length of the escape sequence at the beginning; UNFINISHED where its end is not there yet. */
static int sequence_length(const unsigned char *s, size_t n)
{
    if (n < 2)
        return UNFINISHED;
    if (s[1] == '[') {
        size_t i = 2;
        if (n > 2 && s[2] == '[') /* F1 to F5 of the Linux console: ESC [ [ A */
            return n > 3 ? 4 : UNFINISHED;
        while (i < n && s[i] >= 0x20 && s[i] <= 0x3f)
            i++;
        if (i == n)
            return UNFINISHED;
        if (s[i] == 'M' && i == 2) /* the old mouse report */
            return n >= 6 ? 6 : UNFINISHED;
        return (int)(s[i] >= 0x40 && s[i] <= 0x7e ? i + 1 : i); /* a byte that cannot be there ends it */
    }
    if (s[1] == 'O')
        return n > 2 ? 3 : UNFINISHED;
    if (s[1] == 'P' || s[1] == ']' || s[1] == 'X' || s[1] == '^' || s[1] == '_') {
        for (size_t i = 2; i < n; i++) {
            if (s[i] == BEL)
                return (int)i + 1;
            if (s[i] == ESC)
                return i + 1 < n ? (int)i + (s[i + 1] == '\\' ? 2 : 0) : UNFINISHED;
        }
        return UNFINISHED;
    }
    return 2;
}

static int mouse(struct thud_decode *decode, int button, int x, int y, bool pressed)
{
    decode->mouse_x = x > 0 ? x - 1 : 0;
    decode->mouse_y = y > 0 ? y - 1 : 0;
    if (button == 64 || button == 65)
        return button == 64 ? THUD_KEY_WHEEL_UP : THUD_KEY_WHEEL_DOWN;
    if (button == 32)
        return THUD_KEY_DRAG;
    return button == 0 && pressed ? THUD_KEY_CLICK : THUD_KEY_NONE;
}

/* ESC [ < button ; x ; y M (pressed) or m (let go). */
static int mouse_report(struct thud_decode *decode, const char *text)
{
    int value[3];
    for (int i = 0; i < 3; i++)
        if (!thud_scan_count(&text, &value[i]) || (i < 2 && *text++ != ';'))
            return THUD_KEY_NONE;
    return *text == 'M' || *text == 'm' ? mouse(decode, value[0], value[1], value[2], *text == 'M') : THUD_KEY_NONE;
}

struct code {
    int code, key;
};

static int key_of(const struct code *table, size_t n, int code)
{
    for (size_t i = 0; i < n; i++)
        if (table[i].code == code)
            return table[i].key;
    return THUD_KEY_NONE;
}

static int final_key(char final)
{
    static const struct code table[] = {{'A', THUD_KEY_UP},   {'B', THUD_KEY_DOWN}, {'C', THUD_KEY_RIGHT},
                                        {'D', THUD_KEY_LEFT}, {'F', THUD_KEY_END},  {'H', THUD_KEY_HOME},
                                        {'P', THUD_KEY_F1},   {'Q', THUD_KEY_F2},   {'Z', THUD_KEY_BACKTAB},
                                        {'M', THUD_KEY_ENTER}}; /* of the keypad, after ESC O */
    return key_of(table, sizeof table / sizeof *table, final);
}

/* ESC [ number ~ */
static int number_key(int number)
{
    static const struct code table[] = {
        {1, THUD_KEY_HOME}, {3, THUD_KEY_DELETE},    {4, THUD_KEY_END}, {5, THUD_KEY_PAGE_UP}, {7, THUD_KEY_HOME},
        {8, THUD_KEY_END},  {6, THUD_KEY_PAGE_DOWN}, {11, THUD_KEY_F1}, {12, THUD_KEY_F2},     {200, THUD_KEY_PASTE}};
    return key_of(table, sizeof table / sizeof *table, number);
}

/* What a whole sequence means; THUD_KEY_NONE: nothing. */
static int sequence_key(struct thud_decode *decode, const unsigned char *s, int n)
{
    char text[64];
    size_t size = (size_t)n < sizeof text - 1 ? (size_t)n : sizeof text - 1;
    memcpy(text, s, size);
    text[size] = '\0';
    for (int i = 0; i < decode->nlearned; i++)
        if (strcmp(decode->learned[i].sequence, text) == 0)
            return decode->learned[i].key;
    if (text[1] == 'O')
        return final_key(text[2]);
    if (text[1] != '[')
        return n == 2 && text[1] >= '0' && text[1] <= '9' ? THUD_KEY_ALT + text[1] : THUD_KEY_NONE;
    if (text[2] == '[')
        return text[3] == 'A' ? THUD_KEY_F1 : text[3] == 'B' ? THUD_KEY_F2 : THUD_KEY_NONE;
    if (text[2] == 'M' && n == 6)
        return mouse(decode, s[3] - 32, s[4] - 32, s[5] - 32, true);
    if (text[2] == '<')
        return mouse_report(decode, text + 3);
    if (text[2] == '?' && text[size - 1] == 'c') {
        decode->attributes = true;
        decode->sixel = thud_image_answer_has_sixel(text);
        return THUD_KEY_NONE;
    }
    int number;
    const char *at = text + 2;
    if (thud_scan_count(&at, &number))
        return at[0] == '~' && at[1] == '\0' ? number_key(number) : THUD_KEY_NONE;
    return n == 3 && text[2] != 'M' ? final_key(text[2]) : THUD_KEY_NONE;
}

/* Takes pasted text up to its end mark; false where that has not come. */
static bool take_paste(struct thud_decode *decode)
{
    static const char mark[] = "\033[201~";
    enum { MARK = sizeof mark - 1 };
    size_t i = 0;
    bool over = false;
    for (; i < decode->n && !over; i++) {
        size_t left = decode->n - i, common = left < MARK ? left : MARK;
        if (decode->byte[i] == ESC && memcmp(decode->byte + i, mark, common) == 0) {
            if (common < MARK)
                break; /* it may be the mark */
            over = true;
            i += MARK - 1;
            continue;
        }
        if (decode->paste_size + 1 < sizeof decode->paste && decode->byte[i] != '\0')
            decode->paste[decode->paste_size++] = (char)decode->byte[i];
    }
    drop(decode, i);
    decode->paste[decode->paste_size] = '\0';
    decode->pasting = !over;
    return over;
}

/* One code point; bytes that are no UTF-8 are dropped. */
static int take_character(struct thud_decode *decode, bool ended, bool *more)
{
    static const unsigned char least[] = {0, 0, 0xc2, 0xe0, 0xf0};
    unsigned char lead = decode->byte[0];
    size_t length = lead < 0x80 ? 1 : lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    char text[5] = "";
    if (lead >= 0x80 && (lead < least[length] || lead > 0xf4)) {
        drop(decode, 1);
        return THUD_KEY_NONE;
    }
    if (decode->n < length && !ended) {
        *more = true;
        return THUD_KEY_NONE;
    }
    memcpy(text, decode->byte, decode->n < length ? decode->n : length);
    const char *at = text;
    int code = (int)thud_utf8_next(&at);
    drop(decode, at > text ? (size_t)(at - text) : 1);
    if (code == 8)
        return THUD_KEY_BACKSPACE;
    if (code == '\n' || code == '\r')
        return THUD_KEY_ENTER;
    bool none = (length > 1 && code == '?') || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff);
    return none ? THUD_KEY_NONE : code;
}

int thud_decode_next(struct thud_decode *decode, bool ended, bool *more)
{
    *more = false;
    while (decode->n > 0) {
        int key = THUD_KEY_NONE;
        if (decode->pasting) {
            if (!take_paste(decode))
                break;
            return THUD_KEY_PASTE;
        }
        if (decode->byte[0] != ESC) {
            key = take_character(decode, ended, more);
        } else {
            size_t alt = decode->n > 2 && decode->byte[1] == ESC && (decode->byte[2] == '[' || decode->byte[2] == 'O');
            int length = sequence_length(decode->byte + alt, decode->n - alt);
            if (decode->n > 2 && decode->byte[1] == ESC && !alt)
                length = 1;
            if ((length == UNFINISHED || (decode->n == 2 && decode->byte[1] == ESC)) && !ended) {
                if (decode->n == sizeof decode->byte)
                    decode->n = 2 + alt; /* how it began tells how it ends */
                *more = true;
                return THUD_KEY_NONE;
            }
            if (decode->n == 1 || (decode->byte[1] == ESC && !alt)) {
                drop(decode, 1);
                return THUD_KEY_ESC;
            }
            length = length == UNFINISHED ? (int)decode->n : length + (int)alt; /* cut off: none of it is a key */
            key = alt ? THUD_KEY_NONE : sequence_key(decode, decode->byte, length);
            drop(decode, (size_t)length);
            if (key == THUD_KEY_PASTE) {
                decode->pasting = true;
                decode->paste_size = 0;
                decode->paste[0] = '\0';
                key = THUD_KEY_NONE;
            }
        }
        if (key != THUD_KEY_NONE || *more)
            return key;
    }
    *more = decode->n > 0 || decode->pasting;
    return THUD_KEY_NONE;
}
