/* Input shapers ZV and MZV whose frequency follows the pose: C99 without allocation.
 *
 * An input shaper replaces a command by a sum of delayed copies of it, such that the vibrations that they
 * excite cancel.  See README.md for the formulas and their sources.
 */
#ifndef SHAPER_H
#define SHAPER_H

enum {
    SHAPER_IMPULSES = 3, /* the most that a shaper has */
    SHAPER_LENGTH = 128  /* ticks of the command that are kept: one more than the longest delay */
};

typedef enum { SHAPER_NONE, SHAPER_ZV, SHAPER_MZV } shaper_kind;

/* The impulses: amplitudes, which add up to 1, and delays [s]. */
typedef struct {
    int count;
    double amplitude[SHAPER_IMPULSES];
    double delay[SHAPER_IMPULSES];
} shaper_impulses;

/* The last commands, in a ring. */
typedef struct {
    double command[SHAPER_LENGTH];
    int newest;
} shaper_history;

/* The impulses for a natural frequency [Hz] and a damping ratio below 1.
 *
 * Return 0, or -1 if there are none for these numbers; the impulses are then left as they were.
 */
int shaper_design(shaper_kind kind, double frequency, double damping, shaper_impulses *impulses);

/* Fill the history with one command: the machine has been at rest there. */
void shaper_rest(shaper_history *history, double command);

/* Append the command of this tick. */
void shaper_append(shaper_history *history, double command);

/* The shaped command of this tick; `tick` is the time between two commands [s].
 *
 * A delay between two ticks is interpolated; one beyond the history takes the oldest command.  The result is
 * between the least and the largest command of the history, whatever the impulses were before: the amplitudes
 * are positive and add up to 1.
 */
double shaper_output(const shaper_history *history, const shaper_impulses *impulses, double tick);

#endif
