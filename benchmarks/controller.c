/* Time that the functions for controllers take per pose [us], the least of many rounds that take turns. */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */
#include <stdio.h>
#include <time.h>

#include "robot.h" /* the header of a robot, its functions as robot_..., POSES, MODES, HELD and poses */

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e6*(double)t.tv_sec + 1e-3*(double)t.tv_nsec;
}

int main(void)
{
    static double f[MODES], phi[MODES][MODES], zeta[HELD], amplitude[HELD];
    double least[3] = {1e9, 1e9, 1e9};
    for (int round = 0; round < 200; ++round)
        for (int function = 0; function < 3; ++function) {
            const double start = now();
            int failed = 0;
            for (int i = 0; i < POSES; ++i)
                failed |= function == 0 ? robot_natural_frequencies(poses[i], f)
                    : function == 1     ? robot_modes(poses[i], f, phi)
                                        : robot_vibration(poses[i], f, zeta, amplitude);
            const double taken = (now() - start)/POSES;
            if (failed)
                return 1;
            least[function] = taken < least[function] ? taken : least[function];
        }
    printf("%.4f %.4f %.4f\n", least[0], least[1], least[2]);
    return 0;
}
