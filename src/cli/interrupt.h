/* Ctrl-C while something long runs. */
#ifndef THUD_CLI_INTERRUPT_H
#define THUD_CLI_INTERRUPT_H

#include <signal.h>

/* From now on INT, TERM and HUP set the flag instead of ending the program; a second one ends it. */
const volatile sig_atomic_t *thud_interrupt_watch(void);

#endif
