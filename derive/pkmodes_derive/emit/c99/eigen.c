/* Rounding, the relative difference up to which components of a shape count as equal, and the fraction of the
 * largest eigenvalue that those of vibrations must have: below it, rounding leaves a frequency fewer than six
 * digits, in single precision hardly two. */
#ifdef PKMODES_FLOAT
#define EIGEN_EPSILON 1.1920929e-07f
#define EIGEN_TIE 1e-4f
#define EIGEN_RESOLVED 1e-5f
#else
#define EIGEN_EPSILON 2.220446049250313e-16
#define EIGEN_TIE 1e-6
#define EIGEN_RESOLVED 1e-9
#endif

/* The symmetric eigenproblem K phi = lambda M phi: M is scaled and factored (Cholesky), K reduced to a
 * tridiagonal matrix by Householder reflections, and that diagonalised by the implicit QL method.  The lower
 * triangle of symmetric matrices is used, and of all arrays the first n <= N rows and columns.  Functions
 * that can fail return -1. */
static int eigen_factor(int n, pkmodes_real M[N][N], pkmodes_real scale[])
{
    int i, j, k;
    for (i = 0; i < n; ++i) {
        if (!(M[i][i] > 0))
            return -1;
        scale[i] = 1/R(sqrt)(M[i][i]);
    }
    for (i = 0; i < n; ++i)
        for (j = 0; j <= i; ++j)
            M[i][j] *= scale[i]*scale[j];
    for (j = 0; j < n; ++j) { /* the diagonal of the factor is inverted */
        pkmodes_real pivot = M[j][j];
        for (k = 0; k < j; ++k)
            pivot -= M[j][k]*M[j][k];
        if (!(pivot > 0))
            return -1;
        M[j][j] = 1/R(sqrt)(pivot);
        for (i = j + 1; i < n; ++i) {
            for (k = 0; k < j; ++k)
                M[i][j] -= M[i][k]*M[j][k];
            M[i][j] *= M[j][j];
        }
    }
    return 0;
}

static void eigen_reduce(int n, pkmodes_real L[N][N], const pkmodes_real scale[], pkmodes_real K[N][N])
{
    int i, j, k;
    for (i = 0; i < n; ++i)
        for (j = 0; j <= i; ++j)
            K[i][j] *= scale[i]*scale[j];
    for (j = 0; j < n; ++j)
        for (i = j; i < n; ++i) {
            for (k = 0; k < j; ++k)
                K[i][j] -= L[j][k]*K[i][k];
            K[i][j] *= L[j][j];
        }
    for (j = 0; j < n; ++j)
        for (i = j; i < n; ++i) {
            for (k = 0; k < j; ++k)
                K[i][j] -= L[i][k]*K[j][k];
            for (k = j; k < i; ++k)
                K[i][j] -= L[i][k]*K[k][j];
            K[i][j] *= L[i][i];
        }
}

static void eigen_tridiagonal(
    int n, pkmodes_real A[N][N], pkmodes_real d[], pkmodes_real e[], pkmodes_real beta[])
{
    pkmodes_real w[N];
    int i, j, k;
    for (k = 0; k + 2 < n; ++k) {
        const pkmodes_real first = A[k + 1][k];
        pkmodes_real rest = 0, along = 0, norm;
        for (i = k + 2; i < n; ++i)
            rest += A[i][k]*A[i][k];
        norm = R(copysign)(R(sqrt)(first*first + rest), first);
        d[k] = A[k][k];
        e[k] = rest > 0 ? -norm : first;
        beta[k] = rest > 0 ? 1/(norm*(first + norm)) : 0;
        A[k + 1][k] = first + norm;
        for (i = k + 1; i < n; ++i) {
            w[i] = 0;
            for (j = k + 1; j < n; ++j)
                w[i] += (j < i ? A[i][j] : A[j][i])*A[j][k];
            w[i] *= beta[k];
            along += w[i]*A[i][k];
        }
        for (i = k + 1; i < n; ++i)
            w[i] -= R(0.5)*beta[k]*along*A[i][k];
        for (i = k + 1; i < n; ++i)
            for (j = k + 1; j <= i; ++j)
                A[i][j] -= A[i][k]*w[j] + w[i]*A[j][k];
    }
    for (k = n > 2 ? n - 2 : 0; k < n; ++k)
        d[k] = A[k][k];
    for (k = n > 2 ? n - 2 : 0; k < n; ++k)
        e[k] = k + 1 < n ? A[k + 1][k] : 0;
}

/* Columns of the inverse factor, transposed, times the reflections: rows of Z. */
static void eigen_vectors(
    int n, pkmodes_real L[N][N], pkmodes_real A[N][N], const pkmodes_real beta[], pkmodes_real Z[N][N])
{
    int c, i, k;
    for (c = 0; c < n; ++c)
        for (i = n - 1; i >= 0; --i) {
            Z[c][i] = i == c ? 1 : 0;
            for (k = i + 1; k <= c; ++k)
                Z[c][i] -= L[k][i]*Z[c][k];
            Z[c][i] *= i <= c ? L[i][i] : 0;
        }
    for (k = 0; k + 2 < n; ++k)
        for (i = 0; i < n; ++i) {
            pkmodes_real sum = 0;
            for (c = k + 1; c < n; ++c)
                sum += Z[c][i]*A[c][k];
            for (c = k + 1; c < n; ++c)
                Z[c][i] -= beta[k]*sum*A[c][k];
        }
}

static int eigen_ql(int n, pkmodes_real d[], pkmodes_real e[], pkmodes_real (*Z)[N])
{
    int i, k, l, m, iteration;
    for (l = 0; l < n; ++l)
        for (iteration = 0;; ++iteration) {
            pkmodes_real g, s = 1, c = 1, p = 0, half;
            for (m = l; m < n - 1; ++m)
                if (!(R(fabs)(e[m]) > EIGEN_EPSILON*(R(fabs)(d[m]) + R(fabs)(d[m + 1]))))
                    break;
            if (m == l)
                break;
            if (iteration == EIGEN_ITERATIONS)
                return -1;
            half = (d[l + 1] - d[l])/(2*e[l]);
            g = d[m] - d[l] + e[l]/(half + R(copysign)(R(sqrt)(half*half + 1), half));
            for (i = m - 1; i >= l; --i) {
                const pkmodes_real f = s*e[i], b = c*e[i], r = R(sqrt)(f*f + g*g);
                pkmodes_real h, t;
                if (i + 1 < m)
                    e[i + 1] = r;
                if (r == 0) { /* the matrix splits here */
                    d[i + 1] -= p;
                    break;
                }
                s = f/r;
                c = g/r;
                h = d[i + 1] - p;
                t = (d[i] - h)*s + 2*c*b;
                p = s*t;
                d[i + 1] = h + p;
                g = c*t - b;
                for (k = 0; Z && k < n; ++k) {
                    const pkmodes_real x = Z[i + 1][k], y = Z[i][k];
                    Z[i + 1][k] = s*y + c*x;
                    Z[i][k] = c*y - s*x;
                }
            }
            if (i < l) {
                d[l] -= p;
                e[l] = g;
            }
            e[m] = 0;
        }
    return 0;
}

/* Sort, and choose signs: the first of a shape's largest components, in units of the scale, is positive. */
static void eigen_order(int n, pkmodes_real d[], pkmodes_real (*Z)[N], const pkmodes_real scale[])
{
    int i, j, k;
    for (i = 1; i < n; ++i)
        for (j = i; j > 0 && d[j] < d[j - 1]; --j) {
            const pkmodes_real value = d[j];
            d[j] = d[j - 1];
            d[j - 1] = value;
            for (k = 0; Z && k < n; ++k) {
                const pkmodes_real x = Z[j][k];
                Z[j][k] = Z[j - 1][k];
                Z[j - 1][k] = x;
            }
        }
    for (i = 0; Z && i < n; ++i) {
        pkmodes_real largest = 0, sign = 1;
        for (k = 0; k < n; ++k)
            largest = R(fmax)(largest, R(fabs)(Z[i][k]));
        for (k = n - 1; k >= 0; --k)
            if (R(fabs)(Z[i][k]) >= (1 - EIGEN_TIE)*largest)
                sign = Z[i][k];
        for (k = 0; k < n; ++k)
            Z[i][k] *= R(copysign)(1, sign)*scale[k];
    }
}

/* Eigenvalues d, ascending, and unless Z is NULL the shapes as its rows; M and K are overwritten. */
static int eigen_solve(
    int n, pkmodes_real M[N][N], pkmodes_real K[N][N], pkmodes_real d[], pkmodes_real (*Z)[N])
{
    pkmodes_real scale[N], e[N], beta[N];
    if (eigen_factor(n, M, scale))
        return -1;
    eigen_reduce(n, M, scale, K);
    eigen_tridiagonal(n, K, d, e, beta);
    if (Z)
        eigen_vectors(n, M, K, beta, Z);
    if (eigen_ql(n, d, e, Z))
        return -1;
    eigen_order(n, d, Z, scale);
    return 0;
}

/* Find vibrations, from the given mode on, that are lost in the rounding of the largest eigenvalue. */
static int eigen_lost(int n, const pkmodes_real d[], int vibration)
{
    int i;
    for (i = vibration; i < n; ++i)
        if (!(R(fabs)(d[i]) >= EIGEN_RESOLVED*R(fabs)(d[n - 1])))
            return -1;
    return 0;
}

/* Replace eigenvalues by natural frequencies sqrt(|lambda|)/(2 pi) with the sign of lambda [Hz]. */
static void eigen_frequencies(int n, pkmodes_real d[])
{
    int i;
    for (i = 0; i < n; ++i)
        d[i] = R(copysign)(R(sqrt)(R(fabs)(d[i])), d[i])/R(6.283185307179586);
}
