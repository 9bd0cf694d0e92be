/* Signals around the terminal. Handlers only set a flag and wake the loop; the crash handler writes a fixed sequence.
 */
#pragma once

#include <stdbool.h>

/* Reports of the mouse (xterm: presses, wheel, moves with a button down; decimal), pasted text in marks; neither. */
#define THUD_MOUSE_ON  "\033[?1002h\033[?1006h"
#define THUD_MOUSE_OFF "\033[?1006l\033[?1002l"
#define THUD_PASTE_ON  "\033[?2004h"
#define THUD_PASTE_OFF "\033[?2004l"

/* Before the terminal is opened: notes how it was, and catches INT, TERM, HUP, TSTP and every other signal that ends a
 * process. A signal that was ignored stays so. */
void thud_term_signal_open(void);
/* After it was opened: what restores it is known now, and the window's size is followed. */
void thud_term_signal_ready(void);
/* Everything as before. */
void thud_term_signal_close(void);

int thud_term_signal_fd(void); /* readable when a signal came */
void thud_term_signal_drain(void);
bool thud_term_signal_resized(void); /* the window has another size since the last call */
int thud_term_signal_fatal(void);    /* INT, TERM or HUP that came, else 0 */
/* Where TSTP came: stops, and returns true when the shell lets it go on. */
bool thud_term_signal_suspend(void);
