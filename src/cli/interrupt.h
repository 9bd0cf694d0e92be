/* Ctrl-C while something long runs. */
#ifndef THUD_CLI_INTERRUPT_H
#define THUD_CLI_INTERRUPT_H

#include <stdatomic.h>

/* For the beginning of the program: INT, TERM and HUP end it without leaving a file in the making, and a file that
 * grows beyond `ulimit -f` is an error of writing. A signal that is ignored stays so. */
void thud_interrupt_start(void);
/* From now on INT, TERM and HUP set the flag to their number instead of ending the program; a second one ends it. A HUP
 * that is ignored (nohup) stays so. */
const atomic_int *thud_interrupt_watch(void);
/* The signal that came; 0: none. */
int thud_interrupt_signal(void);

#endif
