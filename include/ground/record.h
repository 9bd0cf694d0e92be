/* Ground motion: acceleration at equal steps, linear between the samples, zero before the first and after the last. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/sha256.h"
#include "base/status.h"

#define THUD_RECORD_COMPUTED "computed, not recorded"

struct thud_record {
    char file[512];  /* as given by the user */
    char format[32]; /* "PEER AT2", "CSV", ... */
    char station[96];
    char component[64];
    char event[96];
    char licence[96];              /* under which its file may be passed on; empty: not stated in the file */
    char sha256[THUD_SHA256_TEXT]; /* of its file, unpacked; empty: no file */
    int parts;                     /* number of motions in its file; 0: one */
    char note[160];                /* how the samples were found in the file, for the user; may be empty */
    double dt_s;
    size_t samples;
    double *a_mps2; /* (samples), already scaled and signed */
    double scale;   /* what the file's samples were multiplied by, with the sign; 1: as recorded */
    bool synthetic; /* a comment of its file states this in the words of THUD_RECORD_COMPUTED */
};

/* Copies `samples` values. Errors: THUD_INPUT when dt is not positive or a value is not finite, THUD_MEMORY. */
enum thud_status thud_record_create(const double *a_mps2, size_t samples, double dt_s, struct thud_record **out,
                                    struct thud_error *err);
void thud_record_free(struct thud_record *record);

double thud_record_peak(const struct thud_record *record); /* largest |a|, m/s2 */
/* Returns the peak ground velocity from rest, m/s: that of the integrated acceleration, also between two samples. 0 for
 * NULL. */
double thud_record_speed(const struct thud_record *record);
void thud_record_scale(struct thud_record *record, double factor);
/* Creates the same motion times a factor. Errors: THUD_MEMORY. */
enum thud_status thud_record_scaled(const struct thud_record *record, double factor, struct thud_record **out,
                                    struct thud_error *err);
