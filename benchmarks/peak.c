/* What one core can do, in vectors as wide as its registers: the peak, and the chain of a QL rotation.
 *
 * Compiled twice: with contraction (fused multiply-add) and without, as the evaluator is.
 */
#include <math.h>
#include <time.h>

#if defined(__AVX512F__)
#define WIDTH 8
#elif defined(__AVX__)
#define WIDTH 4
#else
#define WIDTH 2
#endif
#define CHAINS 12 /* independent accumulators: more than latency times throughput of any present core */

typedef double lane __attribute__((vector_size(8 * WIDTH)));

static lane root(lane x)
{
    for (int w = 0; w < WIDTH; w++)
        x[w] = sqrt(x[w]);
    return x;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

int width(void)
{
    return WIDTH;
}

/* Operations per second: a product and a sum in each lane of each chain. */
double peak(long rounds, double start, double factor)
{
    lane a[CHAINS], b[CHAINS];
    for (int i = 0; i < CHAINS; i++) {
        a[i] = (lane){0} + start + i;
        b[i] = (lane){0} + start - i;
    }
    const lane x = (lane){0} + factor, y = (lane){0} + start;
    const double begin = now();
    for (long r = 0; r < rounds; r++) {
#pragma GCC unroll 12
        for (int i = 0; i < CHAINS; i++) {
#ifdef SEPARATE
            a[i] = a[i] * x;
            b[i] = b[i] + y;
#else
            a[i] = a[i] * x + y;
#endif
        }
    }
    const double seconds = now() - begin;
    volatile double sink = 0.0;
    for (int i = 0; i < CHAINS; i++)
        sink += a[i][0] + b[i][0];
    return 2.0 * CHAINS * WIDTH * rounds / seconds;
}

/* Seconds for a rotation of QL in every lane: 17 operations, among them a root and a quotient on which the next
 * rotation waits.  Three at a time do not wait for each other; the time is that of all three. */
#define ROTATIONS(name, groups)                                                                              \
    double name(long rounds, double start)                                                                   \
    {                                                                                                        \
        lane g[groups], s[groups], c[groups], p[groups];                                                     \
        for (int u = 0; u < groups; u++) {                                                                   \
            g[u] = c[u] = (lane){0} + start + 0.1 * u;                                                       \
            s[u] = p[u] = (lane){0} + 0.5 * start;                                                           \
        }                                                                                                    \
        const lane e = (lane){0} + 0.3 * start, d = (lane){0} + start;                                       \
        const double begin = now();                                                                          \
        for (long r = 0; r < rounds; r++)                                                                    \
            for (int u = 0; u < groups; u++) {                                                               \
                const lane f = s[u] * e, b = c[u] * e, inverse = 1.0 / root(f * f + g[u] * g[u]);            \
                s[u] = f * inverse;                                                                          \
                c[u] = g[u] * inverse;                                                                       \
                const lane h = d - p[u], t = (d - h) * s[u] + 2.0 * c[u] * b;                                \
                p[u] = s[u] * t;                                                                             \
                g[u] = c[u] * t - b;                                                                         \
            }                                                                                                \
        const double seconds = now() - begin;                                                                \
        volatile double sink = 0.0;                                                                          \
        for (int u = 0; u < groups; u++)                                                                     \
            sink += g[u][0] + p[u][0];                                                                       \
        return seconds / rounds;                                                                             \
    }
ROTATIONS(rotation, 1)
ROTATIONS(three_rotations, 3)
