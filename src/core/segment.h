/* A piece of motion as polynomials in s = (t - t0)/h, 0 <= s <= 1: what every method proposes, and what the run reads
 * events, peaks and energies from. */
#ifndef THUD_CORE_SEGMENT_H
#define THUD_CORE_SEGMENT_H

struct thud_run;
struct thud_model;

enum { THUD_SEGMENT_TERMS = 24, THUD_SEGMENT_TERMS_LEAST = 10 }; /* coefficients of a polynomial */

struct thud_segment {
    double h_s;
    int terms;     /* coefficients in use */
    int loaded;    /* orders below this one may have contact forces */
    double a0, a1; /* ground acceleration a0 + a1 s */
    double *q;     /* (terms x nmodes): coefficients of the modal coordinates, by order */
    double *force; /* (terms x ncontacts): of the contact forces; 0 where a contact does not act */
};

/* Bound of the fastest rate of the run's motion with the linear contacts that are closed, 1/s. */
double thud_segment_rate(const struct thud_run *run);
/* Terms after which angle^k/k! is below `least`: angle = rate times h. */
int thud_segment_terms(double angle, double least);
/* Sets h and the ground acceleration over the next h seconds of the run, and clears the forces. */
void thud_segment_begin(struct thud_run *run, struct thud_segment *seg, double h_s);

/* Taylor coefficients of the motion from (q, qd) under seg->a0, a1 and the forces in seg->force. Exact to rounding
 * where omega h is about 1.5 or less. */
void thud_taylor_given(const struct thud_model *model, struct thud_segment *seg, const double *q, const double *qd);
/* Motion from rest under the modal load load[j] s^order alone (seg->a0, a1 and seg->force must be 0). */
void thud_taylor_load(const struct thud_model *model, struct thud_segment *seg, const double *load, int order);
/* The same from the run's state with the linear branches of its closed contacts, whose forces are found along with it.
 */
double thud_taylor_linear(struct thud_run *run, struct thud_segment *seg);
/* Size of the last terms over the largest. */
double thud_segment_tail(const struct thud_segment *seg, int nmodes);
/* Shortens the segment to factor * h by scaling its coefficients. */
void thud_segment_shorten(struct thud_segment *seg, int nmodes, int ncontacts, double factor);

/* Values of all modal coordinates and their rates at s. */
void thud_segment_state(const struct thud_segment *seg, int nmodes, double s, double *q, double *qd);
/* Coefficients of the indentation of contact c, out (terms). Where it is known to start at 0 (an event has just been
 * there), returns how many of the lowest ones are 0 but for rounding: neighbours that start together move together to
 * high orders, and what rounding leaves of their difference is no motion. Elsewhere 0. */
int thud_segment_indentation(const struct thud_run *run, const struct thud_segment *seg, int c, double *out);

#endif
