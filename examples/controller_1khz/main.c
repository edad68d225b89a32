/* A 1 kHz loop that shapes the command for the modes of the present pose, with the motors held as they are in use.
 *
 * The machine makes random straight moves, as fast as its speed and acceleration allow.  The shaped commands go to a
 * file: plant.py simulates the machine that follows them.  Every tick is timed.  README.md explains the output.
 */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "linear_delta_2022.h"

#define TICK 1e-3         /* [s] */
#define DAMPING 0.01      /* damping ratio where the robot file has none */
#define SPEED 1.0         /* [m/s] */
#define ACCELERATION 15.0 /* [m/s^2] */
#define SLOW 20.0         /* [us] longer ticks are counted */

enum {
    AXES = LINEAR_DELTA_2022_POSE,
    MODES = LINEAR_DELTA_2022_HELD_MODES,
    MOST = 3,       /* factors of a shaper */
    SETTLE = 150,   /* ticks after a move in which the machine is watched */
    LONGEST = 1500, /* ticks of a move, shaping and settling included */
    MOVES = 1000
};

static const pkmodes_real MIDDLE[AXES] = {(pkmodes_real)0.57, 0, (pkmodes_real)-0.2}; /* for which fixed shapers are designed */

/* One way to shape the command. */
typedef struct {
    const char *name;
    int kind, factors; /* one for each of the lowest modes; no factors: the command as it is */
    int follows;       /* the pose */
    linear_delta_2022_shaper shaper;
    linear_delta_2022_shaped shaped;
    pkmodes_real output[AXES];
    double *times; /* of the ticks [us] */
} loop;

/* Design the shaper for the modes of a pose: 0, or a status, and then the shaper is the last one. */
static int design(loop *l, const pkmodes_real pose[AXES])
{
    linear_delta_2022_shaper found = {0}, factor;
    pkmodes_real f[MODES], zeta[MODES], amplitude[MODES];
    const int status = linear_delta_2022_vibration(pose, f, zeta, amplitude);
    if (status != 0)
        return status;
    for (int i = 0; i < l->factors; ++i) {
        const pkmodes_real ratio = zeta[i] > 0 ? zeta[i] : (pkmodes_real)DAMPING;
        if (linear_delta_2022_shaper_design(l->kind, f[i], ratio, i == 0 ? &found : &factor) != 0
            || (i > 0 && linear_delta_2022_shaper_multiply(&found, &factor) != 0))
            return -1;
    }
    l->shaper = found;
    return 0;
}

/* What a controller does in a tick: 0, or what kept it from following the pose. */
static int tick(loop *l, const pkmodes_real command[AXES])
{
    const int status = l->follows ? design(l, command) : 0;
    const int taken =
        linear_delta_2022_shaped_command(&l->shaped, &l->shaper, (pkmodes_real)TICK, command, l->output);
    return status != 0 ? status : taken;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e6*(double)t.tv_sec + 1e-3*(double)t.tv_nsec; /* [us] */
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

static double length(const pkmodes_real from[AXES], const pkmodes_real to[AXES])
{
    double squares = 0.0;
    for (int i = 0; i < AXES; ++i)
        squares += pow((double)(to[i] - from[i]), 2.0);
    return sqrt(squares);
}

/* A number between 0 and 1, the same sequence everywhere. */
static double chance(void)
{
    static unsigned long long state = 2022;
    state = state*6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(state >> 11)/9007199254740992.0;
}

/* Where the next move goes: to a pose of the workspace that is not nearly where it starts. */
static void choose(const pkmodes_real from[AXES], pkmodes_real to[AXES])
{
    do {
        to[0] = (pkmodes_real)(0.32 + 0.5*chance());
        to[1] = (pkmodes_real)(-0.1 + 0.2*chance());
        to[2] = (pkmodes_real)(-0.24 + 0.08*chance());
    } while (linear_delta_2022_status(to) != 0 || length(from, to) < 0.01);
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Make a move and write it; return the number of ticks in which a shaper could not follow the pose. */
static int make(
    loop *l, int move, const pkmodes_real from[AXES], const pkmodes_real to[AXES], int *ticks, FILE *file)
{
    const double distance = length(from, to);
    double duration;
    int kept = 0;
    linear_delta_2022_shaped_rest(&l->shaped, from);
    travel(0.0, distance, &duration);
    for (int k = 0, arrived = 0, settled = 0; settled < SETTLE && k < LONGEST; ++k) {
        const pkmodes_real part = (pkmodes_real)(travel(k*TICK, distance, &duration)/distance);
        pkmodes_real command[AXES];
        for (int i = 0; i < AXES; ++i)
            command[i] = from[i] + part*(to[i] - from[i]);
        const double start = now();
        kept += tick(l, command) != 0;
        l->times[(*ticks)++] = now() - start;
        arrived = k*TICK >= duration;
        for (int i = 0; i < AXES; ++i) /* exactly: nothing is on its way any more */
            arrived = arrived && l->output[i] == command[i];
        settled += arrived;
        fprintf(file, "\"%s\",%d,%.3f,%d", l->name, move, k*TICK, arrived);
        for (int i = 0; i < AXES; ++i)
            fprintf(file, ",%.12g", (double)l->output[i]);
        fprintf(file, "\n");
    }
    return kept;
}

static void print_times(loop *l, int ticks)
{
    int slow = 0;
    qsort(l->times, (size_t)ticks, sizeof(double), ascending);
    while (slow < ticks && l->times[ticks - 1 - slow] > SLOW)
        ++slow;
    printf("%-22s %8d %11.2f %7.2f %7.2f %9.2f %6d\n", l->name, ticks, l->times[0], l->times[ticks/2],
           l->times[(int)(0.999*ticks)], l->times[ticks - 1], slow);
}

int main(int count, char **arguments)
{
    static loop loops[] = {
        {.name = "none"},
        {.name = "zv, fixed", .kind = LINEAR_DELTA_2022_SHAPER_ZV, .factors = 1},
        {.name = "zv, of the pose", .kind = LINEAR_DELTA_2022_SHAPER_ZV, .factors = 1, .follows = 1},
        {.name = "mzv, fixed", .kind = LINEAR_DELTA_2022_SHAPER_MZV, .factors = 1},
        {.name = "zv*zv*zv, fixed", .kind = LINEAR_DELTA_2022_SHAPER_ZV, .factors = MOST},
        {.name = "zv*zv*zv, of the pose", .kind = LINEAR_DELTA_2022_SHAPER_ZV, .factors = MOST, .follows = 1},
    };
    static pkmodes_real poses[MOVES + 1][AXES] = {{(pkmodes_real)0.6, 0, (pkmodes_real)-0.2}};
    const int ways = (int)(sizeof loops/sizeof loops[0]), moves = count > 2 ? atoi(arguments[2]) : 30;
    pkmodes_real f[MODES], zeta[MODES], amplitude[MODES];
    if (count < 2 || count > 3 || moves < 1 || moves > MOVES) {
        fprintf(stderr, "usage: %s COMMANDS.csv [number of moves, at most %d]\n", arguments[0], MOVES);
        return 2;
    }
    FILE *file = fopen(arguments[1], "w");
    if (!file) {
        perror(arguments[1]);
        return 1;
    }
    printf("%s, pkmodes %s, model %s\n\n", LINEAR_DELTA_2022_NAME, LINEAR_DELTA_2022_VERSION,
           LINEAR_DELTA_2022_HASH);
    if (linear_delta_2022_vibration(MIDDLE, f, zeta, amplitude) != 0)
        return 1;
    printf("motors held, in the middle: mode [Hz], and the ringing after a step of the acceleration [um per m/s^2]\n");
    for (int i = 0; i < MODES; ++i)
        printf("%10.2f %8.3f\n", (double)f[i], 1e6*(double)amplitude[i]);
    printf("\n%-22s %8s %11s %7s %7s %9s %6s\n", "shaper", "ticks", "tick [us]", "median", "99.9 %", "largest",
           "slow");
    fprintf(file, "shaper,move,time,arrived,x,y,z\n");
    for (int move = 0; move < moves; ++move)
        choose(poses[move], poses[move + 1]);
    int kept = 0;
    for (int w = 0; w < ways; ++w) {
        loop *l = &loops[w];
        int ticks = 0;
        l->times = malloc((size_t)moves*LONGEST*sizeof(double));
        if (!l->times || design(l, MIDDLE) != 0)
            return 1;
        for (int move = 0; move < moves; ++move)
            kept += make(l, move, poses[move], poses[move + 1], &ticks, file);
        print_times(l, ticks);
        free(l->times);
    }
    printf("\nticks in which a shaper could not follow the pose: %d\n", kept);
    return fclose(file) == 0 ? 0 : 1;
}
