/* A lane: a vector of doubles, one for each pose, as wide as the registers of the instruction set.
 *
 * GCC's and Clang's vector extensions give the operators; what they lack is here.  LANES_WIDTH is set by the
 * compiler's command line: 8 for AVX-512, 4 for AVX2, 2 for SSE2, NEON and everything else.
 */
#ifndef PKMODES_LANE_H
#define PKMODES_LANE_H

#include <math.h>

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

#define INLINE static inline __attribute__((always_inline))

typedef double lane __attribute__((vector_size(8 * LANES_WIDTH)));
/* The same in an array of doubles, aligned or not. */
typedef double lane_in_memory __attribute__((vector_size(8 * LANES_WIDTH), aligned(8), may_alias));
typedef long long mask __attribute__((vector_size(8 * LANES_WIDTH)));

/* How a margin must compare. */
enum { LANES_AT_LEAST_ZERO, LANES_ABOVE_ZERO, LANES_AT_MOST_LIMIT };
struct lanes_rule {
    int count, rule;
};

/* The same double in every lane, or a lane as it is. */
#define LANES(x) ((lane){0} + (x))

INLINE lane pick(mask where, lane a, lane b)
{
    return (lane)((where & (mask)a) | (~where & (mask)b));
}

INLINE int any(mask where)
{
#if defined(__AVX512F__) && LANES_WIDTH == 8
    return _mm512_test_epi64_mask((__m512i)where, (__m512i)where) != 0;
#elif defined(__AVX2__) && LANES_WIDTH == 4
    return !_mm256_testz_si256((__m256i)where, (__m256i)where);
#else
    long long found = 0;
    for (int w = 0; w < LANES_WIDTH; w++)
        found |= where[w];
    return found != 0;
#endif
}

INLINE lane root(lane x)
{
#if defined(__AVX512F__) && LANES_WIDTH == 8
    return (lane)_mm512_sqrt_pd((__m512d)x);
#elif defined(__AVX__) && LANES_WIDTH == 4
    return (lane)_mm256_sqrt_pd((__m256d)x);
#elif defined(__SSE2__) && LANES_WIDTH == 2
    return (lane)_mm_sqrt_pd((__m128d)x);
#elif defined(__aarch64__) && LANES_WIDTH == 2
    return (lane)vsqrtq_f64((float64x2_t)x);
#else
    lane r;
    for (int w = 0; w < LANES_WIDTH; w++)
        r[w] = sqrt(x[w]);
    return r;
#endif
}

INLINE lane magnitude(lane x)
{
    return (lane)((mask)x & ((mask){0} + 0x7fffffffffffffffLL));
}

INLINE lane with_sign(lane size, lane of)
{
    const mask bit = (mask){0} + (-0x7fffffffffffffffLL - 1);
    return (lane)(((mask)size & ~bit) | ((mask)of & bit));
}

INLINE void lanes_clear(lane *restrict x, int count)
{
    for (int i = 0; i < count; i++)
        x[i] = (lane){0};
}

#ifdef __has_builtin
#if __has_builtin(__builtin_shufflevector)
#define LANES_SHUFFLE __builtin_shufflevector
#endif
#endif

/* Rows become columns: what was lane k of x[w] is lane w of x[k]. */
INLINE void lanes_transpose(lane *restrict x)
{
    lane y[LANES_WIDTH];
#if defined(LANES_SHUFFLE) && LANES_WIDTH == 8
    for (int i = 0; i < 4; i++) {
        y[i] = LANES_SHUFFLE(x[i], x[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        y[i + 4] = LANES_SHUFFLE(x[i], x[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
    for (int k = 0; k < 4; k++) {
        const int i = k + (k & 2);
        x[i] = LANES_SHUFFLE(y[i], y[i + 2], 0, 1, 8, 9, 4, 5, 12, 13);
        x[i + 2] = LANES_SHUFFLE(y[i], y[i + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
    for (int i = 0; i < 8; i += 2) {
        y[i] = LANES_SHUFFLE(x[i], x[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        y[i + 1] = LANES_SHUFFLE(x[i], x[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
#elif defined(LANES_SHUFFLE) && LANES_WIDTH == 4
    for (int i = 0; i < 2; i++) {
        y[i] = LANES_SHUFFLE(x[i], x[i + 2], 0, 1, 4, 5);
        y[i + 2] = LANES_SHUFFLE(x[i], x[i + 2], 2, 3, 6, 7);
    }
    for (int i = 0; i < 4; i += 2) {
        x[i] = LANES_SHUFFLE(y[i], y[i + 1], 0, 4, 2, 6);
        x[i + 1] = LANES_SHUFFLE(y[i], y[i + 1], 1, 5, 3, 7);
    }
    return;
#else
    for (int k = 0; k < LANES_WIDTH; k++)
        for (int w = 0; w < LANES_WIDTH; w++)
            y[k][w] = x[w][k];
#endif
    for (int i = 0; i < LANES_WIDTH; i++)
        x[i] = y[i];
}

/* Functions of the C library that generated code may call, of a lane or of a double. */
#define lanes_sqrt(x) _Generic((x), lane: root, default: sqrt)(x)
#define LANES_OF_ONE(name)                                                                                   \
    INLINE lane lanes_each_##name(lane x)                                                                    \
    {                                                                                                        \
        lane r;                                                                                              \
        for (int w = 0; w < LANES_WIDTH; w++)                                                                \
            r[w] = name(x[w]);                                                                               \
        return r;                                                                                            \
    }
LANES_OF_ONE(sin)
LANES_OF_ONE(cos)
LANES_OF_ONE(tan)
LANES_OF_ONE(asin)
LANES_OF_ONE(acos)
LANES_OF_ONE(atan)
LANES_OF_ONE(sinh)
LANES_OF_ONE(cosh)
LANES_OF_ONE(tanh)
LANES_OF_ONE(exp)
LANES_OF_ONE(log)
#define lanes_sin(x) _Generic((x), lane: lanes_each_sin, default: sin)(x)
#define lanes_cos(x) _Generic((x), lane: lanes_each_cos, default: cos)(x)
#define lanes_tan(x) _Generic((x), lane: lanes_each_tan, default: tan)(x)
#define lanes_asin(x) _Generic((x), lane: lanes_each_asin, default: asin)(x)
#define lanes_acos(x) _Generic((x), lane: lanes_each_acos, default: acos)(x)
#define lanes_atan(x) _Generic((x), lane: lanes_each_atan, default: atan)(x)
#define lanes_sinh(x) _Generic((x), lane: lanes_each_sinh, default: sinh)(x)
#define lanes_cosh(x) _Generic((x), lane: lanes_each_cosh, default: cosh)(x)
#define lanes_tanh(x) _Generic((x), lane: lanes_each_tanh, default: tanh)(x)
#define lanes_exp(x) _Generic((x), lane: lanes_each_exp, default: exp)(x)
#define lanes_log(x) _Generic((x), lane: lanes_each_log, default: log)(x)
#define lanes_fabs(x) _Generic((x), lane: magnitude, default: fabs)(x)

INLINE lane lanes_each_sign(lane x)
{
    return pick(x == 0.0, LANES(0.0), with_sign(LANES(1.0), x));
}

INLINE double lanes_one_sign(double x)
{
    return x == 0.0 ? 0.0 : copysign(1.0, x);
}
#define lanes_sign(x) _Generic((x), lane: lanes_each_sign, default: lanes_one_sign)(x)

INLINE lane lanes_each_atan2(lane y, lane x)
{
    lane r;
    for (int w = 0; w < LANES_WIDTH; w++)
        r[w] = atan2(y[w], x[w]);
    return r;
}

INLINE lane lanes_each_pow(lane x, lane y)
{
    lane r;
    for (int w = 0; w < LANES_WIDTH; w++)
        r[w] = pow(x[w], y[w]);
    return r;
}
/* A double and a lane together are two lanes. */
#define lanes_atan2(y, x) lanes_each_atan2(LANES(y), LANES(x))
#define lanes_pow(x, y) lanes_each_pow(LANES(x), LANES(y))

#endif
