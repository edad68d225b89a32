/* Motions of all coordinates that move the platform by 1 along each linear direction and strain nothing. */
#ifndef PKMODES_STRAIN_FREE_H
#define PKMODES_STRAIN_FREE_H

#include "lane.h"

_Static_assert(LANES_POSE == LANES_INDEPENDENT, "a pose determines as many coordinates as it has components");

/* Solve A X = B for `count` columns by elimination with partial pivoting, in their own places. */
INLINE void lanes_eliminate(int n, int count, lane *restrict A, lane *restrict B)
{
    for (int c = 0; c < n; c++) {
        for (int i = c + 1; i < n; i++) { /* the largest pivot moves up */
            const mask larger = magnitude(A[i * n + c]) > magnitude(A[c * n + c]);
            for (int j = c; j < n; j++) {
                const lane upper = pick(larger, A[i * n + j], A[c * n + j]);
                A[i * n + j] = pick(larger, A[c * n + j], A[i * n + j]);
                A[c * n + j] = upper;
            }
            for (int j = 0; j < count; j++) {
                const lane upper = pick(larger, B[i * count + j], B[c * count + j]);
                B[i * count + j] = pick(larger, B[c * count + j], B[i * count + j]);
                B[c * count + j] = upper;
            }
        }
        const lane inverse = 1.0 / A[c * n + c];
        for (int i = c + 1; i < n; i++) {
            const lane factor = A[i * n + c] * inverse;
            for (int j = c + 1; j < n; j++)
                A[i * n + j] -= factor * A[c * n + j];
            for (int j = 0; j < count; j++)
                B[i * count + j] -= factor * B[c * count + j];
        }
    }
    for (int i = n - 1; i >= 0; i--)
        for (int j = 0; j < count; j++) {
            for (int k = i + 1; k < n; k++)
                B[i * count + j] -= A[i * n + k] * B[k * count + j];
            B[i * count + j] /= A[i * n + i];
        }
}

/* The base coordinates by linear direction, from the platform Jacobian, which is overwritten, and the stiffness of the
 * transmissions: the dependent coordinates follow without force. */
INLINE void lanes_strain_free(lane *restrict jacobian, const lane *restrict elastic, lane *restrict motion)
{
    enum { n = LANES_BASE, k = LANES_INDEPENDENT, f = LANES_DEPENDENT, count = LANES_LINEAR };
    lane given[k * count], A[f * f], B[f * count];
    for (int i = 0; i < k; i++)
        for (int j = 0; j < count; j++)
            given[i * count + j] = LANES(i == j ? 1.0 : 0.0);
    lanes_eliminate(k, count, jacobian, given);
    for (int i = 0; i < f; i++) {
        const lane *row = elastic + LANES_DEPENDENT_INDICES[i] * n;
        for (int j = 0; j < f; j++)
            A[i * f + j] = row[LANES_DEPENDENT_INDICES[j]];
        for (int j = 0; j < count; j++) {
            B[i * count + j] = (lane){0};
            for (int c = 0; c < k; c++)
                B[i * count + j] -= row[LANES_INDEPENDENT_INDICES[c]] * given[c * count + j];
        }
    }
    lanes_eliminate(f, count, A, B);
    for (int j = 0; j < count; j++) {
        for (int i = 0; i < k; i++)
            motion[LANES_INDEPENDENT_INDICES[i] * count + j] = given[i * count + j];
        for (int i = 0; i < f; i++)
            motion[LANES_DEPENDENT_INDICES[i] * count + j] = B[i * count + j];
    }
}

#endif
