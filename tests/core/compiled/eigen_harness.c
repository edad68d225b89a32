/* The eigenproblem of eigen.h alone, for tests: K and M of any size up to 24, one problem in each lane. */
#define LANES_ALL 24
#include "eigen.h"

/* M and K: (LANES_WIDTH, n, n); eigenvalues (LANES_WIDTH, n), unordered, shapes (LANES_WIDTH, n, n) in rows; bad:
 * (LANES_WIDTH). */
void solve(int n, const double *M, const double *K, double *eigenvalues, double *shapes, int *bad)
{
    static struct eigen_problem problem[EIGEN_UNITS];
    lane L[LANES_ALL * LANES_ALL], A[LANES_ALL * LANES_ALL], scale[LANES_ALL], beta[LANES_ALL], work[LANES_ALL];
    for (int i = 0; i < n * n; i++)
        for (int w = 0; w < LANES_WIDTH; w++) {
            L[i][w] = M[w * n * n + i];
            A[i][w] = K[w * n * n + i];
        }
    mask wrong = eigen_factor(n, L, scale);
    eigen_reduce(n, L, scale, A);
    eigen_tridiagonal(n, A, problem[0].d, problem[0].e, beta, work);
    eigen_vectors(n, L, A, beta, problem[0].Z);
    eigen_ql(n, 1, problem, n);
    wrong |= problem[0].late;
    for (int w = 0; w < LANES_WIDTH; w++) {
        bad[w] = wrong[w] != 0;
        for (int i = 0; i < n; i++) {
            eigenvalues[w * n + i] = problem[0].d[i][w];
            for (int k = 0; k < n; k++)
                shapes[(w * n + i) * n + k] = problem[0].Z[i * n + k][w] * scale[k][w];
        }
    }
}
