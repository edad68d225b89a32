/* A 1 kHz loop that shapes the command for the natural frequency of the present pose.
 *
 * The machine makes random straight moves, as fast as its speed and acceleration allow.  A simulated
 * vibration, whose frequency is that of the pose in each moment, shows what each shaper leaves of it after a
 * move.  Every tick is timed.  README.md explains the output.
 */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "linear_delta_2022.h"
#include "shaper.h"

#define TICK 1e-3         /* [s] */
#define DAMPING 0.01      /* damping ratio of the mode, for the shaper and in the simulation */
#define SPEED 1.0         /* [m/s] */
#define ACCELERATION 15.0 /* [m/s^2] */
#define FIXED 51.0        /* [Hz] for shapers that do not follow the pose: the middle of the range */
#define SMOOTHING 0.015   /* [s] time constant of the frequency that a shaper follows */
#define SLOW 20.0         /* [us] longer ticks are counted */

enum {
    AXES = LINEAR_DELTA_2022_POSE,
    MODES = LINEAR_DELTA_2022_COORDINATES,
    LOWEST = LINEAR_DELTA_2022_RIGID_MODES, /* the first mode of vibration */
    SUBSTEPS = 20,                          /* of the simulation, in a tick */
    SETTLE = 100,                           /* ticks in which the vibration after a move is observed */
    REPEATS = 5                             /* calls at one pose, of which the fastest counts */
};

/* One way to shape the command, with the vibration that it leaves. */
typedef struct {
    const char *name;
    shaper_kind kind;
    int follows;      /* the pose */
    double frequency; /* of the impulses [Hz] */
    shaper_impulses impulses;
    shaper_history history[AXES];
    double output[AXES], before[AXES]; /* shaped command of this tick and of the last one */
    double q[AXES], q_dot[AXES];       /* the vibration: position and speed */
    double residual;                   /* its largest amplitude after a move [m] */
    double *times;                     /* of the ticks [us] */
} loop;

/* What a controller does in a tick: 0, or the status of a pose for which it has kept the impulses.
 *
 * The frequency is smoothed: where two modes cross, the lowest one has a kink, and a delay that suddenly
 * changes at another rate is a jump of the speed, which excites the vibration.
 */
static int tick(loop *l, const double command[AXES])
{
    pkmodes_real p[AXES], f[MODES];
    int status = 0;
    if (l->follows) {
        for (int i = 0; i < AXES; ++i)
            p[i] = (pkmodes_real)l->output[i]; /* where the machine is */
        status = linear_delta_2022_natural_frequencies(p, f);
        if (status == 0) {
            l->frequency += TICK/SMOOTHING*((double)f[LOWEST] - l->frequency);
            shaper_design(l->kind, l->frequency, DAMPING, &l->impulses);
        }
    }
    for (int i = 0; i < AXES; ++i) {
        shaper_append(&l->history[i], command[i]);
        l->output[i] = shaper_output(&l->history[i], &l->impulses, TICK);
    }
    return status;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e6*(double)t.tv_sec + 1e-3*(double)t.tv_nsec; /* [us] */
}

/* Time that the natural frequencies of a pose take [us]: the fastest call is one without interruption. */
static double undisturbed(const double pose[AXES])
{
    pkmodes_real p[AXES], f[MODES];
    double least = 1e9;
    for (int i = 0; i < AXES; ++i)
        p[i] = (pkmodes_real)pose[i];
    for (int i = 0; i < REPEATS; ++i) {
        const double start = now();
        linear_delta_2022_natural_frequencies(p, f);
        least = fmin(least, now() - start);
    }
    return least;
}

/* Angular frequency of the simulated vibration at a pose. */
static double omega(const double pose[AXES])
{
    pkmodes_real p[AXES], f[MODES];
    for (int i = 0; i < AXES; ++i)
        p[i] = (pkmodes_real)pose[i];
    if (linear_delta_2022_natural_frequencies(p, f) != 0) {
        fprintf(stderr, "error: the path leaves the workspace\n");
        exit(1);
    }
    return 6.283185307179586*(double)f[LOWEST];
}

/* q'' + 2 DAMPING w q' + w^2 (q - u) = 0 for one tick, in which u goes straight to the output. */
static void vibrate(loop *l)
{
    const double w = omega(l->output), h = TICK/SUBSTEPS;
    for (int i = 0; i < AXES; ++i)
        for (int k = 0; k < SUBSTEPS; ++k) {
            const double u = l->before[i] + (k + 0.5)/SUBSTEPS*(l->output[i] - l->before[i]);
            const double a = -2.0*DAMPING*w*l->q_dot[i] - w*w*(l->q[i] - u);
            const double half = l->q_dot[i] + 0.5*h*a, q = l->q[i] + 0.5*h*l->q_dot[i];
            l->q[i] += h*half;
            l->q_dot[i] += h*(-2.0*DAMPING*w*half - w*w*(q - u));
        }
    for (int i = 0; i < AXES; ++i)
        l->before[i] = l->output[i];
}

/* Amplitude of the vibration about the output [m]. */
static double amplitude(const loop *l)
{
    const double w = omega(l->output);
    double sum = 0.0;
    for (int i = 0; i < AXES; ++i)
        sum += pow(l->q[i] - l->output[i], 2.0) + pow(l->q_dot[i]/w, 2.0);
    return sqrt(sum);
}

/* Travel after time t of a move from rest to rest over a distance, and its duration. */
static double travel(double t, double distance, double *duration)
{
    const double ramp = fmin(SPEED/ACCELERATION, sqrt(distance/ACCELERATION));
    const double speed = ACCELERATION*ramp, end = distance/speed + ramp;
    *duration = end;
    if (t >= end)
        return distance;
    if (t < ramp)
        return 0.5*ACCELERATION*t*t;
    if (t < end - ramp)
        return speed*(t - 0.5*ramp);
    return distance - 0.5*ACCELERATION*(end - t)*(end - t);
}

/* A number between 0 and 1, the same sequence everywhere. */
static double chance(void)
{
    static unsigned long long state = 2022;
    state = state*6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(state >> 11)/9007199254740992.0;
}

static void choose(double target[AXES])
{
    target[0] = 0.32 + 0.5*chance();
    target[1] = -0.1 + 0.2*chance();
    target[2] = -0.24 + 0.08*chance();
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int count, char **arguments)
{
    static loop loops[] = {
        {.name = "none", .kind = SHAPER_NONE},
        {.name = "ZV, fixed", .kind = SHAPER_ZV},
        {.name = "ZV, of the pose", .kind = SHAPER_ZV, .follows = 1},
        {.name = "MZV, fixed", .kind = SHAPER_MZV},
        {.name = "MZV, of the pose", .kind = SHAPER_MZV, .follows = 1},
    };
    const int ways = (int)(sizeof loops/sizeof loops[0]), moves = count > 1 ? atoi(arguments[1]) : 100;
    const int most = moves*1000;
    double from[AXES] = {0.6, 0.0, -0.2}, to[AXES];
    double slowest = 0.0;
    int ticks = 0, kept = 0;
    if (moves < 1 || moves > 100000) {
        fprintf(stderr, "usage: %s [number of moves]\n", arguments[0]);
        return 2;
    }
    printf("%s, pkmodes %s, model %s\n", LINEAR_DELTA_2022_NAME, LINEAR_DELTA_2022_VERSION,
           LINEAR_DELTA_2022_HASH);
    for (int w = 0; w < ways; ++w) {
        loop *l = &loops[w];
        l->times = malloc((size_t)most*sizeof(double));
        if (!l->times)
            return 2;
        l->frequency = l->follows ? omega(from)/6.283185307179586 : FIXED;
        shaper_design(l->kind, l->frequency, DAMPING, &l->impulses);
        for (int i = 0; i < AXES; ++i) {
            shaper_rest(&l->history[i], from[i]);
            l->output[i] = l->before[i] = l->q[i] = from[i];
        }
    }
    for (int move = 0; move < moves; ++move) {
        double distance = 0.0, duration = 0.0;
        pkmodes_real target[AXES];
        choose(to);
        for (int i = 0; i < AXES; ++i) {
            target[i] = (pkmodes_real)to[i];
            distance += pow(to[i] - from[i], 2.0);
        }
        distance = sqrt(distance);
        if (linear_delta_2022_status(target) != 0 || distance < 0.01)
            continue; /* the status says why: its values are macros of the header */
        travel(0.0, distance, &duration);
        const int last = (int)ceil(duration/TICK), settled = last + 25; /* the longest shaper: 17 ms */
        for (int k = 1; k <= settled + SETTLE && ticks < most; ++k, ++ticks) {
            const double part = travel(k*TICK, distance, &duration)/distance;
            double command[AXES];
            for (int i = 0; i < AXES; ++i)
                command[i] = from[i] + part*(to[i] - from[i]);
            for (int w = 0; w < ways; ++w) {
                const double start = now();
                kept += tick(&loops[w], command) != 0;
                loops[w].times[ticks] = now() - start;
                vibrate(&loops[w]);
                if (w == 0)
                    slowest = fmax(slowest, undisturbed(loops[w].output));
                if (k > settled)
                    loops[w].residual = fmax(loops[w].residual, amplitude(&loops[w]));
            }
        }
        for (int i = 0; i < AXES; ++i)
            from[i] = to[i];
    }
    printf("%d ticks; impulses kept at %d\n\n", ticks, kept);
    printf("%-18s %13s %8s %11s %7s %7s %9s %6s\n", "shaper", "residual [um]", "of none", "tick [us]",
           "median", "99.9 %", "largest", "slow");
    for (int w = 0; w < ways; ++w) {
        loop *l = &loops[w];
        qsort(l->times, (size_t)ticks, sizeof(double), ascending);
        int slow = 0;
        while (slow < ticks && l->times[ticks - 1 - slow] > SLOW)
            ++slow;
        printf("%-18s %13.2f %8.4f %11.2f %7.2f %7.2f %9.2f %6d\n", l->name, 1e6*l->residual,
               l->residual/loops[0].residual, l->times[0], l->times[ticks/2], l->times[(int)(0.999*ticks)],
               l->times[ticks - 1], slow);
        free(l->times);
    }
    printf("\nnatural frequencies at the slowest pose, fastest of %d calls: %.2f us\n", REPEATS, slowest);
    return 0;
}
