/* The evaluator of one mechanism for one instruction set: poses in, modes out, a block of lanes at a time.
 *
 * lanes.h is the generated header of the mechanism, LANES_RUN the name of the entry point.
 */
#include "lane.h"
#include "request.h"

#include "lanes.h"

#include "eigen.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))
#define TWO_PI 6.283185307179586
#define LARGEST 1.7976931348623157e308

/* A code where the condition holds, the other codes elsewhere. */
INLINE mask pick_code(mask where, long long code, mask otherwise)
{
    return (where & ((mask){0} + code)) | (~where & otherwise);
}

/* Why each pose cannot be evaluated, 0 where it can. */
INLINE mask lanes_checked(const lane *restrict pose, const lane *restrict margin, double largest_condition)
{
    mask code = (mask){0};
    int first = LANES_MARGINS;
    for (int i = COUNT(LANES_RULES) - 1; i >= 0; i--) {
        mask holds = ~(mask){0};
        first -= LANES_RULES[i].count;
        for (int k = first; k < first + LANES_RULES[i].count; k++)
            holds &= LANES_RULES[i].rule == LANES_AT_MOST_LIMIT ? margin[k] <= largest_condition
                : LANES_RULES[i].rule == LANES_ABOVE_ZERO       ? margin[k] > 0.0
                                                                : margin[k] >= 0.0;
        code = pick_code(~holds, i + 2, code);
    }
    mask finite = ~(mask){0};
    for (int i = 0; i < LANES_POSE; i++)
        finite &= magnitude(pose[i]) <= LANES(LARGEST);
    return pick_code(~finite, 1, code);
}

/* A block of poses: one for each lane. */
struct lanes_block {
    const struct pkmodes_request *request;
    long long start;
    int count;
    mask code;
};

/* Write rows of `size` lanes each: NaN where a pose is not evaluated. */
INLINE void lanes_put(const struct lanes_block *block, double *restrict out, const lane *restrict x, int size)
{
    double tile[LANES_ALL * LANES_ALL][LANES_WIDTH];
    for (int i = 0; i < size; i++)
        *(lane_in_memory *)tile[i] = pick(block->code == 0, x[i] + 0.0, LANES(NAN));
    for (int w = 0; w < block->count; w++) {
        double *restrict row = out + (block->start + w) * size;
        for (int i = 0; i < size; i++)
            row[i] = tile[i][w];
    }
}

/* The same for rows that belong to a mode: to the place of its eigenvalue among `modes`. */
INLINE void lanes_put_mode(
    const struct lanes_block *block, double *restrict out, const lane *restrict x, int size, mask place, int modes)
{
    double tile[LANES_ALL][LANES_WIDTH];
    for (int i = 0; i < size; i++)
        *(lane_in_memory *)tile[i] = pick(block->code == 0, x[i] + 0.0, LANES(NAN));
    for (int w = 0; w < block->count; w++) {
        double *restrict row = out + ((block->start + w) * modes + place[w]) * size;
        for (int i = 0; i < size; i++)
            row[i] = tile[i][w];
    }
}

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
    lane M[LANES_ALL * LANES_ALL], K[LANES_ALL * LANES_ALL], J_p[LANES_DIRECTIONS * LANES_ALL];
    lane follow[LANES_ALL * LANES_ALL], scale[LANES_ALL];
};

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

/* Write the modes of a block, ascending; coordinate i of the system is column `column[i]` of the results. */
INLINE void lanes_write(const struct lanes_system *restrict system, const struct eigen_problem *restrict problem,
    const mask *restrict place, int n, int m, const int *restrict column)
{
    const struct lanes_block *block = &system->block;
    const struct pkmodes_request *request = block->request;
    for (int i = 0; i < m; i++) {
        if (request->frequencies) {
            const lane value = problem->d[i];
            const lane frequency = with_sign(root(magnitude(value)), value) / TWO_PI;
            lanes_put_mode(block, request->frequencies, &frequency, 1, place[i], m);
        }
        if (request->eigenvalues)
            lanes_put_mode(block, request->eigenvalues, &problem->d[i], 1, place[i], m);
        if (!(request->shapes || request->platform_shapes))
            continue;
        lane x[LANES_ALL], shape[LANES_ALL], motion[LANES_DIRECTIONS];
        const lane sign = eigen_sign(m, problem->Z + i * m);
        for (int k = 0; k < m; k++)
            x[k] = problem->Z[i * m + k] * sign * system->scale[k];
        for (int r = m; r < n; r++) {
            x[r] = (lane){0};
            for (int j = 0; j < r; j++)
                x[r] += system->follow[(r - m) * n + j] * x[j];
        }
        if (request->shapes) {
            for (int k = 0; k < n; k++)
                shape[column[k]] = x[k];
            lanes_put_mode(block, request->shapes, shape, n, place[i], m);
        }
        if (request->platform_shapes) {
            for (int a = 0; a < LANES_DIRECTIONS; a++) {
                motion[a] = (lane){0};
                for (int k = 0; k < n; k++)
                    motion[a] += system->J_p[a * n + k] * x[k];
            }
            lanes_put_mode(block, request->platform_shapes, motion, LANES_DIRECTIONS, place[i], m);
        }
    }
}

/* Solve the systems and write the requested modes; a pose that needs another solver gets the code -1. */
INLINE void lanes_solve(struct lanes_system *restrict system, int units, int n, int m, const int *restrict column)
{
    const struct pkmodes_request *request = system->block.request;
    const int vectors = request->shapes || request->platform_shapes;
    struct eigen_problem problem[EIGEN_UNITS];
    mask bad[EIGEN_UNITS], place[LANES_ALL];
    for (int u = 0; u < units; u++)
        bad[u] = lanes_reduce(system + u, n, m, vectors, problem + u);
    if (vectors)
        eigen_ql(m, units, problem, m);
    else
        eigen_ql(m, units, problem, 0);
    for (int u = 0; u < units; u++) {
        struct lanes_block *block = &system[u].block;
        bad[u] |= problem[u].late;
        for (int i = 0; i < m; i++)
            bad[u] |= ~(magnitude(problem[u].d[i]) <= LANES(LARGEST));
        block->code = pick_code((block->code == 0) & bad[u], -1, block->code);
        eigen_order(m, problem[u].d, place);
        for (int i = 0; i < m; i++) /* without an order, as they are: inside their arrays */
            place[i] = pick_code(bad[u], i, place[i]);
        lanes_write(system + u, problem + u, place, n, m, column);
    }
}

/* The model without effects. */
INLINE void lanes_without_effects(
    struct lanes_system *restrict system, int units, lane (*pose)[LANES_POSE], int modes)
{
    enum { n = LANES_BASE };
    int column[n];
    const struct pkmodes_request *request = system->block.request;
    for (int i = 0; i < n; i++)
        column[i] = i;
    for (int u = 0; u < units; u++) {
        lanes_base(pose[u], request->parameters, request->effects, system[u].M, system[u].K, system[u].J_p);
        if (request->mass)
            lanes_put(&system[u].block, request->mass, system[u].M, n * n);
        if (request->stiffness)
            lanes_put(&system[u].block, request->stiffness, system[u].K, n * n);
    }
    if (modes)
        lanes_solve(system, units, n, n, column);
}

/* Of a matrix in all coordinates the rows and columns that are free, in an order. */
INLINE void lanes_select(int n, const lane *restrict all, const int *restrict rows, lane *restrict some)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            some[i * n + j] = all[rows[i] * LANES_ALL + rows[j]];
}

/* The model with effects: of all coordinates those that are free. */
static __attribute__((noinline)) void lanes_with_effects(
    struct lanes_system *restrict system, int units, lane (*pose)[LANES_POSE], int modes)
{
    const struct pkmodes_request *request = system->block.request;
    const int n = (int)request->free_count;
    int column[LANES_ALL], rows[LANES_ALL], m = 0, last = n;
    lane M[LANES_ALL * LANES_ALL], K[LANES_ALL * LANES_ALL], J_p[LANES_DIRECTIONS * LANES_ALL];
    for (int i = 0; i < n; i++)
        if (!request->massless[i])
            column[m++] = i;
    for (int i = n - 1; i >= 0; i--)
        if (request->massless[i])
            column[--last] = i;
    for (int i = 0; i < n; i++)
        rows[i] = request->free[column[i]];
    for (int u = 0; u < units; u++) {
        lanes_extended(pose[u], request->parameters, request->effects, M, K, J_p);
        for (int i = 0; i < n; i++)
            K[request->free[i] * (LANES_ALL + 1)] += request->joints[request->free[i]];
        if (request->mass) {
            lanes_select(n, M, request->free, system[u].M);
            lanes_put(&system[u].block, request->mass, system[u].M, n * n);
        }
        if (request->stiffness) {
            lanes_select(n, K, request->free, system[u].K);
            lanes_put(&system[u].block, request->stiffness, system[u].K, n * n);
        }
        lanes_select(n, M, rows, system[u].M);
        lanes_select(n, K, rows, system[u].K);
        for (int a = 0; a < LANES_DIRECTIONS; a++)
            for (int i = 0; i < n; i++)
                system[u].J_p[a * n + i] = J_p[a * LANES_ALL + rows[i]];
    }
    if (modes && units == 1)
        lanes_solve(system, 1, n, m, column);
    else if (modes)
        lanes_solve(system, EIGEN_UNITS, n, m, column);
}

/* Evaluate as many blocks as there are units, and write the requested results and the codes. */
INLINE void lanes_evaluate(const struct pkmodes_request *request, long long start, int units)
{
    const int modes = request->frequencies || request->eigenvalues || request->shapes || request->platform_shapes;
    const int matrices = request->mass || request->stiffness;
    struct lanes_system system[EIGEN_UNITS];
    lane pose[EIGEN_UNITS][LANES_POSE];
    for (int u = 0; u < units; u++) {
        const long long first = start + u * LANES_WIDTH, left = request->count - first;
        lane q[LANES_INDEPENDENT], margin[LANES_MARGINS];
        for (int i = 0; i < LANES_POSE; i++)
            for (int w = 0; w < LANES_WIDTH; w++) /* the last pose fills up the last block */
                pose[u][i][w] = request->poses[(w < left ? first + w : request->count - 1) * LANES_POSE + i];
        lanes_position(pose[u], request->parameters, request->effects, q, margin);
        const mask code = lanes_checked(pose[u], margin, request->largest_condition);
        system[u].block = (struct lanes_block){request, first, left < LANES_WIDTH ? (int)left : LANES_WIDTH, code};
        if (request->joint_positions)
            lanes_put(&system[u].block, request->joint_positions, q, LANES_INDEPENDENT);
    }
    if (modes || matrices) {
        if (request->free_count)
            lanes_with_effects(system, units, pose, modes);
        else
            lanes_without_effects(system, units, pose, modes);
    }
    for (int u = 0; u < units; u++)
        for (int w = 0; w < system[u].block.count; w++)
            request->codes[system[u].block.start + w] = (signed char)system[u].block.code[w];
}

void LANES_RUN(const struct pkmodes_request *request)
{
    long long start = 0;
    for (; request->count - start > (EIGEN_UNITS - 1) * LANES_WIDTH; start += EIGEN_UNITS * LANES_WIDTH)
        lanes_evaluate(request, start, EIGEN_UNITS);
    for (; start < request->count; start += LANES_WIDTH)
        lanes_evaluate(request, start, 1);
}
