/* The symmetric generalised eigenproblem K x = lambda M x on lanes: as many problems at once as a lane is wide.
 *
 * M is scaled by its diagonal and factored, K reduced to a standard problem (Golub and Van Loan, section 8.7.2), that to
 * a tridiagonal matrix by Householder reflections (section 8.3.1), and that solved by the implicit QL method (Bowdler,
 * Martin, Reinsch and Wilkinson 1968).  Each lane iterates until it has converged and is then left unchanged, so
 * its bits do not depend on its neighbours.  Tests are written so that a NaN counts as converged.
 *
 * Matrices are n by n, row-major, of lanes; of symmetric ones the lower triangle is used.
 */
#ifndef PKMODES_EIGEN_H
#define PKMODES_EIGEN_H

#include "lane.h"

/* Most iterations for one eigenvalue; two are usual, and a lane that needs more is reported as not converged. */
#define EIGEN_ITERATIONS 60
/* The most problems that are solved together. */
#define EIGEN_UNITS 3
#define EIGEN_PRECISION 2.220446049250313e-16
/* Components that differ by less from the largest one count as equal to it (`pkmodes.core.linalg.eigen.TIE`). */
#define EIGEN_TIE 1e-6

/* Factor M, scaled to a unit diagonal, as L L^T in its own place; L's diagonal is inverted.  Return where it is not
 * positive definite. */
INLINE mask eigen_factor(int n, lane *restrict M, lane *restrict scale)
{
    mask bad = (mask){0};
    for (int i = 0; i < n; i++) {
        const lane diagonal = M[i * n + i];
        bad |= ~(diagonal > 0.0);
        scale[i] = 1.0 / root(diagonal);
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++)
            M[i * n + j] *= scale[i] * scale[j];
    for (int j = 0; j < n; j++) {
        lane pivot = M[j * n + j];
        for (int k = 0; k < j; k++)
            pivot -= M[j * n + k] * M[j * n + k];
        bad |= ~(pivot > 0.0);
        const lane inverse = 1.0 / root(pivot);
        M[j * n + j] = inverse;
        for (int i = j + 1; i < n; i++) {
            lane sum = M[i * n + j];
            for (int k = 0; k < j; k++)
                sum -= M[i * n + k] * M[j * n + k];
            M[i * n + j] = sum * inverse;
        }
    }
    return bad;
}

/* K becomes L^-1 S K S L^-T, S the scale. */
INLINE void eigen_reduce(int n, const lane *restrict L, const lane *restrict scale, lane *restrict K)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++)
            K[i * n + j] *= scale[i] * scale[j];
    /* The lower triangle of X = K L^-T, column by column. */
    for (int j = 0; j < n; j++)
        for (int i = j; i < n; i++) {
            lane sum = K[i * n + j];
            for (int k = 0; k < j; k++)
                sum -= L[j * n + k] * K[i * n + k];
            K[i * n + j] = sum * L[j * n + j];
        }
    /* L^-1 X, which is symmetric: what stands above the diagonal is taken from below it. */
    for (int j = 0; j < n; j++)
        for (int i = j; i < n; i++) {
            lane sum = K[i * n + j];
            for (int k = 0; k < j; k++)
                sum -= L[i * n + k] * K[j * n + k];
            for (int k = j; k < i; k++)
                sum -= L[i * n + k] * K[k * n + j];
            K[i * n + j] = sum * L[i * n + i];
        }
}

/* Reduce A to a tridiagonal matrix with diagonal d and off-diagonal e; the reflectors stay in A and beta. */
INLINE void eigen_tridiagonal(
    int n, lane *restrict A, lane *restrict d, lane *restrict e, lane *restrict beta, lane *restrict w)
{
    for (int k = 0; k + 2 < n; k++) {
        const lane first = A[(k + 1) * n + k];
        lane rest = (lane){0};
        for (int i = k + 2; i < n; i++)
            rest += A[i * n + k] * A[i * n + k];
        const mask reflect = rest > 0.0;
        const lane norm = root(first * first + rest);
        const lane head = first + with_sign(norm, first);
        const lane factor = pick(reflect, 1.0 / (norm * magnitude(head)), (lane){0});
        e[k] = pick(reflect, -with_sign(norm, first), first);
        d[k] = A[k * n + k];
        beta[k] = factor;
        A[(k + 1) * n + k] = head;
        for (int i = k + 1; i < n; i++)
            w[i] = (lane){0};
        for (int i = k + 1; i < n; i++) {
            const lane v = A[i * n + k];
            lane sum = A[i * n + i] * v;
            for (int j = k + 1; j < i; j++) {
                sum += A[i * n + j] * A[j * n + k];
                w[j] += A[i * n + j] * v;
            }
            w[i] += sum;
        }
        lane along = (lane){0};
        for (int i = k + 1; i < n; i++) {
            w[i] *= factor;
            along += w[i] * A[i * n + k];
        }
        along *= 0.5 * factor;
        for (int i = k + 1; i < n; i++)
            w[i] -= along * A[i * n + k];
        for (int i = k + 1; i < n; i++)
            for (int j = k + 1; j <= i; j++)
                A[i * n + j] -= A[i * n + k] * w[j] + w[i] * A[j * n + k];
    }
    for (int k = n - 2 < 0 ? 0 : n - 2; k < n; k++)
        d[k] = A[k * n + k];
    if (n > 1)
        e[n - 2] = A[(n - 1) * n + n - 2];
    e[n - 1] = (lane){0};
}

/* Rows of Z: the columns of L^-T times the reflections, on which the rotations of QL act. */
INLINE void eigen_vectors(int n, const lane *restrict L, const lane *restrict A, const lane *restrict beta, lane *restrict Z)
{
    /* Row c of Z is column c of L^-T: the solution of L^T x = unit vector c, zero below c. */
    for (int c = 0; c < n; c++)
        for (int i = n - 1; i >= 0; i--) {
            if (i > c) {
                Z[c * n + i] = (lane){0};
                continue;
            }
            lane sum = LANES(i == c ? 1.0 : 0.0);
            for (int k = i + 1; k <= c; k++)
                sum -= L[k * n + i] * Z[c * n + k];
            Z[c * n + i] = sum * L[i * n + i];
        }
    /* Z times H_0 H_1 ...: each mixes the columns from k + 1 on. */
    for (int k = 0; k + 2 < n; k++)
        for (int i = 0; i < n; i++) {
            lane sum = (lane){0};
            for (int c = k + 1; c < n; c++)
                sum += Z[c * n + i] * A[c * n + k];
            sum *= beta[k];
            for (int c = k + 1; c < n; c++)
                Z[c * n + i] -= sum * A[c * n + k];
        }
}

/* A tridiagonal problem: diagonal, off-diagonal, and rows that turn with the rotations. */
struct eigen_problem {
    lane d[LANES_ALL], e[LANES_ALL], Z[LANES_ALL * LANES_ALL];
    mask late;
};

/* Diagonalise several problems together, so that one computes while another waits for its roots and quotients: d
 * becomes the eigenvalues, in no order, and the rows of Z, each of `width`, turn with it.  `late` says where it has not
 * converged. */
INLINE void eigen_ql(int n, int units, struct eigen_problem *restrict problem, int width)
{
    for (int u = 0; u < units; u++)
        problem[u].late = (mask){0};
    for (int l = 0; l < n - 1; l++) {
        for (int iteration = 0;; iteration++) {
            /* The first negligible element from l on ends the block of a lane: at `end` it is true there. */
            mask end[LANES_ALL][EIGEN_UNITS], working[EIGEN_UNITS], all = (mask){0};
            int top = l;
            for (int u = 0; u < units; u++) {
                const lane *restrict d = problem[u].d, *restrict e = problem[u].e;
                mask open = ~(mask){0};
                for (int i = l; i < n - 1; i++) {
                    const mask large = magnitude(e[i]) > EIGEN_PRECISION * (magnitude(d[i]) + magnitude(d[i + 1]));
                    end[i][u] = open & ~large;
                    open &= large;
                }
                end[n - 1][u] = open;
                working[u] = ~end[l][u];
                all |= working[u];
            }
            if (!any(all))
                break;
            if (iteration == EIGEN_ITERATIONS) {
                for (int u = 0; u < units; u++)
                    problem[u].late |= working[u];
                break;
            }
            for (int i = n - 1; i > l; i--) {
                mask here = (mask){0};
                for (int u = 0; u < units; u++)
                    here |= end[i][u];
                if (any(here)) {
                    top = i;
                    break;
                }
            }
            lane g[EIGEN_UNITS], s[EIGEN_UNITS], c[EIGEN_UNITS], p[EIGEN_UNITS];
            mask active[EIGEN_UNITS], stopped[EIGEN_UNITS];
            for (int u = 0; u < units; u++) {
                const lane *restrict d = problem[u].d, *restrict e = problem[u].e;
                lane last = d[l];
                for (int i = l + 1; i <= top; i++)
                    last = pick(end[i][u], d[i], last);
                /* Wilkinson's shift; a lane that has converged computes with harmless numbers. */
                const lane off = pick(working[u], e[l], LANES(1.0));
                const lane half = (d[l + 1] - d[l]) / (2.0 * off);
                g[u] = last - d[l] + off / (half + with_sign(root(half * half + 1.0), half));
                s[u] = c[u] = LANES(1.0);
                p[u] = (lane){0};
                active[u] = stopped[u] = (mask){0};
            }
            for (int i = top - 1; i >= l; i--) {
                lane sine[EIGEN_UNITS], cosine[EIGEN_UNITS];
                for (int u = 0; u < units; u++) {
                    lane *restrict d = problem[u].d, *restrict e = problem[u].e;
                    const mask begins = end[i + 1][u] & working[u];
                    const lane f = s[u] * e[i], b = c[u] * e[i];
                    const lane r = root(f * f + g[u] * g[u]);
                    /* Both zero: the matrix splits here; the rest of the sweep is for the next one. */
                    const mask nearby = (active[u] | begins) & ~stopped[u], splits = nearby & (r == 0.0);
                    const mask now = nearby & ~splits;
                    e[i + 1] = pick(nearby & ~begins, r, e[i + 1]);
                    d[i + 1] = pick(splits, d[i + 1] - p[u], d[i + 1]);
                    stopped[u] |= splits;
                    active[u] = now;
                    const lane inverse = 1.0 / pick(now, r, LANES(1.0));
                    s[u] = pick(now, f * inverse, s[u]);
                    c[u] = pick(now, g[u] * inverse, c[u]);
                    const lane h = d[i + 1] - p[u];
                    const lane t = (d[i] - h) * s[u] + 2.0 * c[u] * b;
                    p[u] = pick(now, s[u] * t, p[u]);
                    d[i + 1] = pick(now, h + p[u], d[i + 1]);
                    g[u] = pick(now, c[u] * t - b, g[u]);
                    sine[u] = pick(now, s[u], (lane){0});
                    cosine[u] = pick(now, c[u], LANES(1.0));
                }
                if (width)
                    for (int u = 0; u < units; u++) {
                        lane *restrict a = problem[u].Z + i * width, *restrict z = problem[u].Z + (i + 1) * width;
                        for (int k = 0; k < width; k++) {
                            const lane x = z[k], y = a[k];
                            z[k] = sine[u] * y + cosine[u] * x;
                            a[k] = cosine[u] * y - sine[u] * x;
                        }
                    }
            }
            for (int u = 0; u < units; u++) {
                lane *restrict d = problem[u].d, *restrict e = problem[u].e;
                const mask done = working[u] & ~stopped[u];
                d[l] = pick(done, d[l] - p[u], d[l]);
                e[l] = pick(done, g[u], e[l]);
                for (int i = l; i <= top; i++)
                    e[i] = pick(end[i][u] & working[u], (lane){0}, e[i]);
            }
        }
    }
}

/* Sort a problem's eigenvalues, ascending, and with them the rows of Z, each of `width`: by insertion, each lane
 * separately. */
INLINE void eigen_sort(int n, struct eigen_problem *restrict problem, int width)
{
    lane *restrict d = problem->d;
    for (int i = 1; i < n; i++)
        for (int j = i; j > 0; j--) {
            const mask swapped = d[j] < d[j - 1];
            if (!any(swapped))
                break;
            const lane value = d[j];
            d[j] = pick(swapped, d[j - 1], value);
            d[j - 1] = pick(swapped, value, d[j - 1]);
            lane *restrict lower = problem->Z + (j - 1) * width, *restrict upper = problem->Z + j * width;
            for (int k = 0; k < width; k++) {
                const lane x = upper[k];
                upper[k] = pick(swapped, lower[k], x);
                lower[k] = pick(swapped, x, lower[k]);
            }
        }
}

/* The sign that makes the first of the largest components positive. */
INLINE lane eigen_sign(int n, const lane *restrict x)
{
    lane largest = (lane){0};
    for (int i = 0; i < n; i++) {
        const lane size = magnitude(x[i]);
        largest = pick(size > largest, size, largest);
    }
    largest *= 1.0 - EIGEN_TIE;
    lane decides = LANES(1.0);
    for (int i = n - 1; i >= 0; i--)
        decides = pick(magnitude(x[i]) >= largest, x[i], decides);
    return with_sign(LANES(1.0), decides);
}

#endif
