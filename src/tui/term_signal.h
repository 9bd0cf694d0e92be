/* Signals around the terminal. Handlers only set a flag and wake the loop; the crash handler writes a fixed sequence.
 */
#ifndef THUD_TUI_TERM_SIGNAL_H
#define THUD_TUI_TERM_SIGNAL_H

#include <stdbool.h>

/* Before the terminal is opened: notes how it was, catches INT, TERM, HUP, TSTP, SEGV, BUS, FPE, ILL, ABRT and QUIT. */
void thud_term_signal_open(void);
/* After it was opened: what restores it is known now, and the window's size is followed. */
void thud_term_signal_ready(void);
/* Everything as before. */
void thud_term_signal_close(void);

int thud_term_signal_fd(void); /* readable when a signal came */
void thud_term_signal_drain(void);
int thud_term_signal_fatal(void);    /* INT, TERM or HUP that came, else 0 */
bool thud_term_signal_suspend(void); /* where TSTP came: stops, and returns true when the shell lets it go on */

#endif
