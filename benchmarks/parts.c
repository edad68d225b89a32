/* Time of the parts of the compiled eigensolver: compiled like the evaluator, with its eigen.h. */
#include <time.h>

#define LANES_ALL 9
#include "lane.h"

#include "eigen.h"

#define APART static __attribute__((noinline))

struct problem {
    lane M[LANES_ALL * LANES_ALL], K[LANES_ALL * LANES_ALL], scale[LANES_ALL];
};

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

APART void load(const double *from, lane *to)
{
    for (int i = 0; i < LANES_ALL * LANES_ALL; i++)
        for (int w = 0; w < LANES_WIDTH; w++)
            to[i][w] = from[w * LANES_ALL * LANES_ALL + i];
}

APART void reduce(struct problem *x)
{
    eigen_factor(LANES_ALL, x->M, x->scale);
    eigen_reduce(LANES_ALL, x->M, x->scale, x->K);
}

APART void tridiagonal(struct problem *x, struct eigen_problem *to)
{
    lane beta[LANES_ALL], work[LANES_ALL];
    eigen_tridiagonal(LANES_ALL, x->K, to->d, to->e, beta, work);
}

APART void iterate(struct eigen_problem *x)
{
    eigen_ql(LANES_ALL, EIGEN_UNITS, x, 0);
}

int together(void)
{
    return EIGEN_UNITS * LANES_WIDTH;
}

/* Add the seconds of the reduction, the tridiagonalisation and QL; `count` is a multiple of `together`. */
void parts(long count, const double *M, const double *K, double *seconds)
{
    static struct problem x[EIGEN_UNITS];
    static struct eigen_problem tridiagonals[EIGEN_UNITS];
    const int size = LANES_ALL * LANES_ALL;
    for (long first = 0; first < count; first += EIGEN_UNITS * LANES_WIDTH) {
        for (int u = 0; u < EIGEN_UNITS; u++) {
            load(M + (first + u * LANES_WIDTH) * size, x[u].M);
            load(K + (first + u * LANES_WIDTH) * size, x[u].K);
        }
        const double begin = now();
        for (int u = 0; u < EIGEN_UNITS; u++)
            reduce(x + u);
        const double reduced = now();
        for (int u = 0; u < EIGEN_UNITS; u++)
            tridiagonal(x + u, tridiagonals + u);
        const double ready = now();
        iterate(tridiagonals);
        seconds[0] += reduced - begin;
        seconds[1] += ready - reduced;
        seconds[2] += now() - ready;
    }
}
