#include "shaper.h"

#include <math.h>

static const double PI = 3.141592653589793;

int shaper_design(shaper_kind kind, double frequency, double damping, shaper_impulses *impulses)
{
    if (!(frequency > 0.0 && isfinite(frequency) && damping >= 0.0 && damping < 1.0))
        return -1;
    const double root = sqrt(1.0 - damping*damping);
    const double period = 1.0/(frequency*root); /* of the damped vibration */
    shaper_impulses found = {1, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    if (kind == SHAPER_ZV) {
        const double K = exp(-damping*PI/root);
        found = (shaper_impulses){2, {1.0, K, 0.0}, {0.0, 0.5*period, 0.0}};
    } else if (kind == SHAPER_MZV) {
        const double K = exp(-0.75*damping*PI/root);
        const double first = 1.0 - 1.0/sqrt(2.0);
        found = (shaper_impulses){
            3, {first, (sqrt(2.0) - 1.0)*K, first*K*K}, {0.0, 0.375*period, 0.75*period}};
    }
    double sum = 0.0;
    for (int i = 0; i < found.count; ++i)
        sum += found.amplitude[i];
    for (int i = 0; i < found.count; ++i)
        found.amplitude[i] /= sum;
    *impulses = found;
    return 0;
}

void shaper_rest(shaper_history *history, double command)
{
    for (int i = 0; i < SHAPER_LENGTH; ++i)
        history->command[i] = command;
    history->newest = 0;
}

void shaper_append(shaper_history *history, double command)
{
    history->newest = (history->newest + 1)%SHAPER_LENGTH;
    history->command[history->newest] = command;
}

/* The command a whole number of ticks ago. */
static double ago(const shaper_history *history, int ticks)
{
    return history->command[(history->newest - ticks + SHAPER_LENGTH)%SHAPER_LENGTH];
}

double shaper_output(const shaper_history *history, const shaper_impulses *impulses, double tick)
{
    double output = 0.0;
    for (int i = 0; i < impulses->count; ++i) {
        const double delay = fmin(impulses->delay[i]/tick, SHAPER_LENGTH - 1.0);
        const int whole = (int)delay;
        const double part = delay - whole;
        const double newer = ago(history, whole);
        const double older = part > 0.0 ? ago(history, whole + 1) : newer;
        output += impulses->amplitude[i]*(newer + part*(older - newer));
    }
    return output;
}
