#include "tui/terminal/image.h"

#include <stdlib.h>
#include <string.h>

const char thud_image_question[] = "\033[c";

const char *thud_image_choice_name(enum thud_image_choice choice)
{
    static const char *const name[THUD_IMAGES_CHOICES] = {"auto", "none", "kitty", "sixel"};
    return name[choice];
}

static bool is_set(const char *variable)
{
    return variable && *variable;
}

static bool begins(const char *text, const char *with)
{
    return text && strncmp(text, with, strlen(with)) == 0;
}

enum thud_image thud_image_known(enum thud_image_choice choice, const struct thud_image_variables *of, bool *ask)
{
    *ask = false;
    if (choice != THUD_IMAGES_AUTO)
        return choice == THUD_IMAGES_KITTY   ? THUD_IMAGE_KITTY
               : choice == THUD_IMAGES_SIXEL ? THUD_IMAGE_SIXEL
                                             : THUD_IMAGE_NONE;
    if (is_set(of->tmux) || is_set(of->sty) || begins(of->term, "screen") || begins(of->term, "tmux"))
        return THUD_IMAGE_NONE;
    if (begins(of->term, "xterm-kitty") || is_set(of->kitty_window))
        return THUD_IMAGE_KITTY;
    *ask = true;
    return THUD_IMAGE_NONE;
}

bool thud_image_answer_has_sixel(const char *sequence)
{
    if (!begins(sequence, "\033[?"))
        return false;
    for (const char *at = sequence + 3; *at >= '0' && *at <= '9';) {
        const char *number = at;
        while (*at >= '0' && *at <= '9')
            at++;
        if (at == number + 1 && *number == '4' && number > sequence + 3) /* the first is the terminal's class */
            return sequence[strlen(sequence) - 1] == 'c';
        at += *at == ';';
    }
    return false;
}

/* a=T: transmit and show; f=100: PNG; C=1: the cursor stays; q=2: no answers, which would come as keys. */
static void draw_kitty(const char *png, size_t n, int columns, int rows, struct thud_text *out)
{
    enum { PIECE = 3 * 1024 }; /* 4096 digits, as many as one escape may have */
    for (size_t i = 0; i < n; i += PIECE) {
        size_t size = n - i < PIECE ? n - i : PIECE;
        bool more = i + size < n;
        if (i == 0)
            thud_text_append(out, "\033_Ga=T,f=100,C=1,q=2,c=%d,r=%d,m=%d;", columns, rows, more);
        else
            thud_text_append(out, "\033_Gm=%d;", more);
        thud_text_base64(out, png + i, size);
        thud_text_append(out, "\033\\");
    }
}

void thud_image_draw(enum thud_image kind, const char *picture, size_t n, int columns, int rows, struct thud_text *out)
{
    if (kind == THUD_IMAGE_NONE)
        return;
    thud_text_append(out, "\0337\033[H");
    if (kind == THUD_IMAGE_KITTY)
        draw_kitty(picture, n, columns, rows, out);
    else
        thud_text_bytes(out, picture, n);
    thud_text_append(out, "\0338");
}

const char *thud_image_clear(enum thud_image kind)
{
    return kind == THUD_IMAGE_KITTY ? "\033_Ga=d,q=2\033\\" : "";
}
