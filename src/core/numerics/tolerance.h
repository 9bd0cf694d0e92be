/* The constants that stand for rounding, each with its unit, the scale it is a part of, and the reason for its size.
 * A double carries 16 digits (epsilon = 2.2e-16). Constants that stand for the accuracy asked for (the tolerance of a
 * run and its parts) are not here but where they are used.
 *
 * Why events need such constants: after an event the function that was watched is 0 but for rounding, and its sign there
 * says nothing. A contact that opened by that sign would close at once, and so on at one instant (chattering). */
#pragma once

/* Time. A time is grid * dt + offset; many steps' offsets add up. */

/* Part of the interval of the ground motion, and of the whole duration, below which no time is left: an offset is the
 * sum of thousands of steps, each rounded to 1e-16 of the interval. */
#define THUD_TOL_TIME 1e-12
/* Part of the remaining time by which a segment may miss the end of the interval: one multiplication and one division. */
#define THUD_TOL_SEGMENT_END 1e-13
/* Part of a fixed step by which the number of steps in an interval may exceed a whole number: the interval of a record
 * is given with nine digits or so. */
#define THUD_TOL_STEP_COUNT 1e-9
/* Part of a step below which two steps have the same matrices: the steps of one interval differ by the rounding of the
 * remaining time over the step. */
#define THUD_TOL_STEP_CHANGE 1e-11
/* s. Events closer together than this are at one moment; also the first time that is passed over where they have no
 * end. 1 m/s times it is 1e-13 m, a thousand times the rounding of a displacement of 1 m. */
#define THUD_TOL_MOMENT_S 1e-13
/* Part of the duration below which an adaptive step is none. */
#define THUD_TOL_LEAST_STEP 1e-14
/* Part of the step of a history by which a row may lie past the end of a segment and still belong to it. */
#define THUD_TOL_ROW 1e-9

/* Displacement and rate. */

/* Parts of the length scale of the run. */

/* Floors nearer to each other than this touch where an impulse falls on one of them: neighbours that moved together,
 * or bounced down to rest, are apart by the rounding of many steps, and with a restitution near 0 a blow that is passed
 * on at once and one that follows a moment later end in other speeds. An indentation at contact onset above this was
 * there from the start (negative clearance): what the rounding of event location leaves is below. */
#define THUD_TOL_CONTACT 1e-12
/* An indentation below this is no contact, nor is a sticking contact's motion in one step: the rounding of displacements
 * of some times the scale. */
#define THUD_TOL_INDENTATION 1e-15
/* Part of the sum of two floors' rates that rounding may leave of their difference: a rate is a state, not a sum of
 * large terms that cancel. */
#define THUD_TOL_RATE 2e-14
/* Part of the velocity scale of the run below which a rate at a velocity reversal is 0: an event is located to 1e-16 of
 * the segment, and the rate there has lost four digits to cancellation at most. */
#define THUD_TOL_REVERSAL 1e-12
/* Part of the change of a rate by an impulse below which the rate after it is 0. */
#define THUD_TOL_IMPULSE_RATE 1e-9
/* Part of the work of impulses, each taken by its size, by which they may seem to give energy: the rates they are solved
 * from are right to 1e-12, and a contact that is held has a rate of rounding. */
#define THUD_TOL_IMPULSE_ENERGY 1e-6
/* Part of the acceleration scale of the run (ground + speed times fastest rate) that rounding leaves of the second rate
 * of an indentation that is 0. */
#define THUD_TOL_ACCELERATION 1e-12
/* Part of the velocity scale of the run: impacts that part slower have come to rest, however strict the tolerance. */
#define THUD_TOL_REST 1e-11

/* Part of the velocity scale of the run, times the effective mass: an impact with a smaller impulse does not count.
 * Neighbours that start together touch and part by rounding, each method another number of times; a bounce that has come
 * to rest is below it too (THUD_TOL_REST). 1e-6 would change the counts of three presets. */
#define THUD_TOL_IMPACT 1e-11
/* Part of the velocity scale of the run: an impact that closed slower has no restitution. In a row of bodies that touch,
 * the blow itself makes approach velocities of 1e-12 to 1e-10 where the exact ones are 0. */
#define THUD_TOL_CLOSING 1e-9
/* Part of a storey's yield drift: an excursion beyond it that moves the plastic drift by less is none. */
#define THUD_TOL_EXCURSION 1e-9
/* Part of the energy that may be unaccounted for where motion and contact are propagated to rounding: the ledger stood at
 * no more than 3e-13 over random scenes, presets and studies. */
#define THUD_TOL_BALANCE 1e-9

/* Coefficients of the power series of an indentation that starts at 0 (`guards suppressed at an event`). */

/* Part of the length scale of the run. */
#define THUD_TOL_LEAST_COEFFICIENT 1e-20
/* Part of the two floors' coefficients of order 2 and above, which are sums of large terms that cancel. */
#define THUD_TOL_COEFFICIENT 1e-12
/* The same for a stepping method, of the largest coefficient: its higher coefficients are differences of the states at
 * the two ends of a step. */
#define THUD_TOL_STEP_COEFFICIENT 2e-14
/* Part of the largest coefficient that a collocated contact force does not resolve, however strict the tolerance. */
#define THUD_TOL_UNRESOLVED 1e-6
/* Terms of a series below this part of its first are left out: 1/100 of epsilon. */
#define THUD_TOL_SERIES 1e-18
/* Size of the last terms of a series over the largest above which the segment is shortened: half of epsilon. */
#define THUD_TOL_SERIES_TAIL 1e-16

/* Force. */

/* Part of force times stroke below which what a link takes in all is rounding. */
#define THUD_TOL_LINK_LOSS 1e-12

/* Part of the elastic force below which a force has not left 0. */
#define THUD_TOL_FORCE 1e-9
/* Part of the force on the approach branch by which it must exceed that of the restitution branch for a contact to
 * stick between the two. */
#define THUD_TOL_BRANCH_GAP 1e-12
/* Part of the displacements and rates that an indentation and its rate are differences of: what rounding leaves. */
#define THUD_TOL_STATE 2e-15
/* Part of two positions that their rounding makes of the difference: two units in the last place of each. */
#define THUD_TOL_POSITION 4.4e-16
/* Part of the force scale: floor of the error estimate of a polynomial through seven points. Without it the step never
 * grows again after a contact onset. */
#define THUD_TOL_POLYNOMIAL 4e-12
/* Part of the force scale: a polynomial through the collocation nodes carries no more than eleven digits. */
#define THUD_TOL_COLLOCATION 6e-11
/* Part of a force that cancels another one, below which rounding hides what is left of both: 1e-13 was seen. */
#define THUD_TOL_CANCELLED 1e-12
/* 1/s2, times the length scale and the effective mass: least force scale where nothing moves. */
#define THUD_TOL_LEAST_ACCELERATION_PS2 1e-9
/* Part of the peak ground acceleration, times the effective mass: least force scale. */
#define THUD_TOL_GROUND_FORCE 1e-6

/* Iterations end where a change is below the first, or below the second and no smaller than half of the one before. */
#define THUD_TOL_NEWTON       1e-14
#define THUD_TOL_NEWTON_STALL 1e-10
/* The same for the collocation, whose forces are known to its tolerance. */
#define THUD_TOL_COLLOCATION_STALL 1e-7
/* Part of the interval of a constraint force by which it has to be outside before it has jumped there. */
#define THUD_TOL_UNSTICK 1e-6

/* Part of the largest right-hand side below which a complementary variable is not negative. */
#define THUD_TOL_COMPLEMENTARITY 1e-13
/* The same of a problem whose matrix is singular, which is solved by steps that each leave a millionth. Where there is no
 * solution, it is as large as the right-hand side itself. */
#define THUD_TOL_SOLVABLE 1e-9
/* Part of a pivot's row in a Cholesky factor below which the row depends on those before it: 50 times the rounding. A
 * light floor between two that are 1e13 times heavier is above it. */
#define THUD_TOL_DEPENDENT 1e-14
/* Part of its position to which the root of a polynomial is located: two units in the last place. */
#define THUD_TOL_ROOT 4e-16
/* Bound of what a last step of Halley's method leaves of a root, as a part of its position: half of epsilon. */
#define THUD_TOL_ROOT_REST 1e-16
/* Part of a segment to which the place of a peak is found: a peak is flat there, and its value right to 1e-24. */
#define THUD_TOL_PEAK_PLACE 1e-12
/* Part of a peak by which bounds of it are widened: they are sums of modes that may cancel, and which intervals are read
 * must not depend on their rounding. */
#define THUD_TOL_PEAK_BOUND 1e-9
/* Part of two ground accelerations below which they are the same sample read in two intervals. */
#define THUD_TOL_GROUND 1e-12
/* The same where a scheme goes on with an acceleration of its own, which a jump of the ground motion would spoil. */
#define THUD_TOL_GROUND_JUMP 1e-9
