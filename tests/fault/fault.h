/* Failing memory and files: the n-th call of a kind fails. The linker puts the functions of fault.c in place of the C
 * library's (--wrap), for thud's own calls and not for those inside other libraries. */
#pragma once

#include <stdbool.h>

enum thud_fault {
    THUD_FAULT_MEMORY, /* malloc, calloc, realloc, strdup, strndup */
    THUD_FAULT_READ,   /* open and fopen for reading, read, fread, fstat */
    THUD_FAULT_WRITE,  /* open, mkstemp and fopen for writing, write, fwrite, fsync, close after writing, rename, mkdir
                        */
    THUD_FAULTS
};

/* From now on the n-th call (from 1) of the kind fails, once. Check is linked in and calls these functions too, so no
 * assertion may stand before thud_fault_end. */
void thud_fault_arm(enum thud_fault kind, long n);
/* From now on each file is opened for writing between these two calls; NULL: nothing is called. */
void thud_fault_around_open(void (*before)(void), void (*after)(void));
/* No call fails any more; whether the armed one came. */
bool thud_fault_end(void);
/* Blocks allocated through the shim and not freed. */
long thud_fault_live(void);
