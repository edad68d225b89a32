/* The eigenproblem of a block of poses, and its shapes in the coordinates of the model. */
#ifndef PKMODES_SYSTEM_H
#define PKMODES_SYSTEM_H

#include "eigen.h"
#include "rows.h"

/* Condense the last n - m coordinates, which have no inertia: K becomes that of the first m, and row r of `follow` says
 * how coordinate r follows those before it. */
INLINE void lanes_condense(int n, int m, lane *restrict K, lane *restrict follow)
{
    for (int r = n - 1; r >= m; r--) {
        const lane inverse = 1.0 / K[r * n + r];
        for (int j = 0; j < r; j++)
            follow[(r - m) * n + j] = -K[r * n + j] * inverse;
        for (int i = 0; i < r; i++)
            for (int j = 0; j <= i; j++)
                K[i * n + j] += K[r * n + i] * follow[(r - m) * n + j];
    }
}

/* The eigenproblem of a block: M and K with the coordinates with inertia first, and how the others follow these. */
struct lanes_system {
    struct lanes_block block;
    lane pose[LANES_POSE];
    lane M[LANES_ALL * LANES_ALL], K[LANES_ALL * LANES_ALL], J_p[LANES_DIRECTIONS * LANES_ALL];
    lane follow[LANES_ALL * LANES_ALL], scale[LANES_ALL];
    lane momentum[LANES_ALL * LANES_LINEAR]; /* M times the motion that strains nothing, by linear direction */
};

/* The shape of a row of Z, with the coordinates without inertia, times a sign. */
INLINE void lanes_shape(
    const struct lanes_system *restrict system, const lane *restrict z, lane sign, int n, int m, lane *restrict x)
{
    for (int k = 0; k < m; k++)
        x[k] = z[k] * sign * system->scale[k];
    for (int r = m; r < n; r++) {
        x[r] = (lane){0};
        for (int j = 0; j < r; j++)
            x[r] += system->follow[(r - m) * n + j] * x[j];
    }
}

/* Reduce a system to a tridiagonal problem.  Return where M is not positive definite. */
INLINE mask lanes_reduce(struct lanes_system *restrict system, int n, int m, int vectors, struct eigen_problem *restrict problem)
{
    lane beta[LANES_ALL], work[LANES_ALL], A[LANES_ALL * LANES_ALL], L[LANES_ALL * LANES_ALL];
    if (m < n)
        lanes_condense(n, m, system->K, system->follow);
    for (int i = 0; i < m; i++)
        for (int j = 0; j <= i; j++) {
            A[i * m + j] = system->K[i * n + j];
            L[i * m + j] = system->M[i * n + j];
        }
    const mask bad = eigen_factor(m, L, system->scale);
    eigen_reduce(m, L, system->scale, A);
    eigen_tridiagonal(m, A, problem->d, problem->e, beta, work);
    if (vectors)
        eigen_vectors(m, L, A, beta, problem->Z);
    return bad;
}

#endif
