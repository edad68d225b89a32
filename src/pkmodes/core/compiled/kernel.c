/* The evaluator of one mechanism for one instruction set: poses in, modes out, a block of lanes at a time.
 *
 * lanes.h is the generated header of the mechanism, LANES_RUN the name of the entry point.
 */
#include "lane.h"

#include "lanes.h"

#if __FINITE_MATH_ONLY__
#error "a pose that cannot be evaluated shows as NaN: compile without -ffast-math and -ffinite-math-only"
#endif

#include "gradient.h"
#include "strain_free.h"
#include "tangent.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))
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

/* Whether a result is wanted that follows from the shapes of modes. */
INLINE int lanes_of_shapes(const struct pkmodes_request *request)
{
    return request->shapes || request->platform_shapes || request->vibration_amplitudes;
}

/* The amplitude with which a mode rings after a step of acceleration along each linear direction. */
INLINE void lanes_amplitude(const struct lanes_system *restrict system, const lane *restrict motion, const lane *restrict x, int n,
    lane compliance, lane *restrict amplitude)
{
    lane squares = (lane){0};
    for (int a = 0; a < LANES_LINEAR; a++)
        squares += motion[a] * motion[a];
    for (int j = 0; j < LANES_LINEAR; j++) {
        lane momentum = (lane){0};
        for (int k = 0; k < n; k++)
            momentum += x[k] * system->momentum[k * LANES_LINEAR + j];
        amplitude[j] = root(squares) * magnitude(momentum) * compliance;
    }
}

/* Write the modes of a block, ascending; coordinate i of the system is column `column[i]` of the results. */
static __attribute__((noinline)) void lanes_write(const struct lanes_system *restrict system,
    const struct eigen_problem *restrict problem, int n, int m, const int *restrict column)
{
    const struct lanes_block *block = &system->block;
    const struct pkmodes_request *request = block->request;
    lane frequencies[LANES_ALL], shapes[LANES_ALL * LANES_ALL], motions[LANES_ALL * LANES_DIRECTIONS];
    lane amplitudes[LANES_ALL * LANES_LINEAR];
    if (request->frequencies) {
        for (int i = 0; i < m; i++)
            frequencies[i] = with_sign(root(magnitude(problem->d[i])), problem->d[i]) / TWO_PI;
        lanes_put(block, request->frequencies, frequencies, m);
    }
    if (request->eigenvalues)
        lanes_put(block, request->eigenvalues, problem->d, m);
    if (!lanes_of_shapes(request))
        return;
    for (int i = 0; i < m; i++) {
        lane x[LANES_ALL];
        lanes_shape(system, problem->Z + i * m, eigen_sign(m, problem->Z + i * m), n, m, x);
        for (int k = 0; k < n; k++)
            shapes[i * n + column[k]] = x[k];
        if (request->platform_shapes || request->vibration_amplitudes)
            for (int a = 0; a < LANES_DIRECTIONS; a++) {
                lane motion = (lane){0};
                for (int k = 0; k < n; k++)
                    motion += system->J_p[a * n + k] * x[k];
                motions[i * LANES_DIRECTIONS + a] = motion;
            }
        if (request->vibration_amplitudes)
            lanes_amplitude(system, motions + i * LANES_DIRECTIONS, x, n,
                i < request->rigid_modes ? LANES(NAN) : 1.0 / magnitude(problem->d[i]), amplitudes + i * LANES_LINEAR);
    }
    if (request->shapes)
        lanes_put(block, request->shapes, shapes, m * n);
    if (request->platform_shapes)
        lanes_put(block, request->platform_shapes, motions, m * LANES_DIRECTIONS);
    if (request->vibration_amplitudes)
        lanes_put(block, request->vibration_amplitudes, amplitudes, m * LANES_LINEAR);
}

/* Solve the systems and write the requested modes; a pose that needs another solver gets the code -1. */
INLINE void lanes_solve(struct lanes_system *restrict system, int units, int n, int m, const int *restrict column)
{
    const struct pkmodes_request *request = system->block.request;
    const int rates = request->eigenvalue_rates || request->frequency_rates;
    const int vectors = lanes_of_shapes(request) || rates;
    struct eigen_problem problem[EIGEN_UNITS];
    mask bad[EIGEN_UNITS];
    for (int u = 0; u < units; u++)
        bad[u] = lanes_reduce(system + u, n, m, vectors, problem + u);
    eigen_ql(m, units, problem, vectors ? m : 0);
    for (int u = 0; u < units; u++) {
        struct lanes_block *block = &system[u].block;
        bad[u] |= problem[u].late;
        for (int i = 0; i < m; i++)
            bad[u] |= ~(magnitude(problem[u].d[i]) <= LANES(LARGEST));
        block->code = pick_code((block->code == 0) & bad[u], -1, block->code);
        eigen_sort(m, problem + u, vectors ? m : 0);
        lanes_write(system + u, problem + u, n, m, column);
        if (rates)
            lanes_differentiate(system + u, problem + u, n, m, column);
    }
}

/* A single system, with or without effects: the compiler unrolls this once, and not for each. */
static __attribute__((noinline)) void lanes_solve_one(
    struct lanes_system *restrict system, int n, int m, const int *restrict column)
{
    lanes_solve(system, 1, n, m, column);
}

/* M, n by n, times the motion that strains nothing. */
static __attribute__((noinline)) void lanes_momentum(
    const struct lanes_system *restrict system, int n, const lane *restrict M, lane *restrict momentum)
{
    const struct pkmodes_request *request = system->block.request;
    lane jacobian[LANES_POSE * LANES_INDEPENDENT], torque[LANES_DRIVES], rotation[LANES_DEPENDENT];
    lane elastic[LANES_BASE * LANES_BASE], motion[LANES_BASE * LANES_LINEAR];
    lanes_statics(system->pose, request->parameters, request->effects, jacobian, torque, rotation, elastic);
    lanes_strain_free(jacobian, elastic, motion);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < LANES_LINEAR; j++) {
            lane sum = (lane){0};
            for (int c = 0; c < LANES_BASE; c++)
                sum += M[i * n + c] * motion[c * LANES_LINEAR + j];
            momentum[i * LANES_LINEAR + j] = sum;
        }
}

/* The model without effects. */
INLINE void lanes_without_effects(
    struct lanes_system *restrict system, int units, int modes)
{
    enum { n = LANES_BASE };
    int column[n];
    const struct pkmodes_request *request = system->block.request;
    for (int i = 0; i < n; i++)
        column[i] = i;
    for (int u = 0; u < units; u++) {
        lanes_base(system[u].pose, request->parameters, request->effects, system[u].M, system[u].K, system[u].J_p);
        if (request->mass)
            lanes_put(&system[u].block, request->mass, system[u].M, n * n);
        if (request->stiffness)
            lanes_put(&system[u].block, request->stiffness, system[u].K, n * n);
        if (request->platform_motion)
            lanes_put(&system[u].block, request->platform_motion, system[u].J_p, LANES_DIRECTIONS * n);
        if (request->vibration_amplitudes)
            lanes_momentum(system + u, n, system[u].M, system[u].momentum);
    }
    if (modes && units == 1)
        lanes_solve_one(system, n, n, column);
    else if (modes)
        lanes_solve(system, EIGEN_UNITS, n, n, column);
}

/* Of a matrix in all coordinates the rows and columns that are free, in an order. */
INLINE void lanes_select(int n, const lane *restrict all, const int *restrict rows, lane *restrict some)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            some[i * n + j] = all[rows[i] * LANES_ALL + rows[j]];
}

/* Of the motion of the platform, per unit of all coordinates, that of those that are free, in an order. */
INLINE void lanes_select_motion(int n, const lane *restrict all, const int *restrict columns, lane *restrict some)
{
    for (int a = 0; a < LANES_DIRECTIONS; a++)
        for (int i = 0; i < n; i++)
            some[a * n + i] = all[a * LANES_ALL + columns[i]];
}

/* Add to the rows and columns of leading coordinates what those that follow them contribute. */
INLINE void lanes_fold(const struct pkmodes_request *restrict request, lane *restrict M, lane *restrict K,
    lane *restrict J_p, lane *restrict momentum)
{
    for (int f = 0; f < request->fold_count; f++) {
        const int to = request->leading[f], from = request->following[f];
        const double weight = request->fold_weights[f];
        for (int i = 0; i < LANES_ALL; i++) {
            M[to * LANES_ALL + i] += weight * M[from * LANES_ALL + i];
            K[to * LANES_ALL + i] += weight * K[from * LANES_ALL + i];
        }
        for (int i = 0; i < LANES_ALL; i++) {
            M[i * LANES_ALL + to] += weight * M[i * LANES_ALL + from];
            K[i * LANES_ALL + to] += weight * K[i * LANES_ALL + from];
        }
        for (int a = 0; a < LANES_DIRECTIONS; a++)
            J_p[a * LANES_ALL + to] += weight * J_p[a * LANES_ALL + from];
        for (int j = 0; momentum && j < LANES_LINEAR; j++)
            momentum[to * LANES_LINEAR + j] += weight * momentum[from * LANES_LINEAR + j];
    }
}

/* The model with effects: of all coordinates those that are free. */
static __attribute__((noinline)) void lanes_with_effects(
    struct lanes_system *restrict system, int units, int modes)
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
        lanes_extended(system[u].pose, request->parameters, request->effects, M, K, J_p);
        for (int i = 0; i < n; i++)
            K[request->free[i] * (LANES_ALL + 1)] += request->joints[request->free[i]];
        lane momentum[LANES_ALL * LANES_LINEAR];
        if (request->vibration_amplitudes)
            lanes_momentum(system + u, LANES_ALL, M, momentum);
        if (request->fold_count)
            lanes_fold(request, M, K, J_p, request->vibration_amplitudes ? momentum : 0);
        if (request->mass) {
            lanes_select(n, M, request->free, system[u].M);
            lanes_put(&system[u].block, request->mass, system[u].M, n * n);
        }
        if (request->stiffness) {
            lanes_select(n, K, request->free, system[u].K);
            lanes_put(&system[u].block, request->stiffness, system[u].K, n * n);
        }
        if (request->platform_motion) {
            lanes_select_motion(n, J_p, request->free, system[u].J_p);
            lanes_put(&system[u].block, request->platform_motion, system[u].J_p, LANES_DIRECTIONS * n);
        }
        lanes_select(n, M, rows, system[u].M);
        lanes_select(n, K, rows, system[u].K);
        lanes_select_motion(n, J_p, rows, system[u].J_p);
        if (request->vibration_amplitudes)
            for (int i = 0; i < n; i++)
                for (int j = 0; j < LANES_LINEAR; j++)
                    system[u].momentum[i * LANES_LINEAR + j] = momentum[rows[i] * LANES_LINEAR + j];
    }
    if (modes && units == 1)
        lanes_solve_one(system, n, m, column);
    else if (modes)
        lanes_solve(system, EIGEN_UNITS, n, m, column);
}

/* Write the platform Jacobian, what holds each pose, and the stiffness of the transmissions. */
static __attribute__((noinline)) void lanes_put_statics(const struct lanes_block *block, const lane *restrict pose)
{
    const struct pkmodes_request *request = block->request;
    lane jacobian[LANES_POSE * LANES_INDEPENDENT], torque[LANES_DRIVES], rotation[LANES_DEPENDENT];
    lane elastic[LANES_BASE * LANES_BASE];
    lanes_statics(pose, request->parameters, request->effects, jacobian, torque, rotation, elastic);
    if (request->free_count)
        lanes_extended_statics(pose, request->parameters, request->effects, torque, rotation);
    if (request->platform_jacobian)
        lanes_put(block, request->platform_jacobian, jacobian, LANES_POSE * LANES_INDEPENDENT);
    if (request->static_torque)
        lanes_put(block, request->static_torque, torque, LANES_DRIVES);
    if (request->static_rotation)
        lanes_put(block, request->static_rotation, rotation, LANES_DEPENDENT);
    if (request->elastic_stiffness)
        lanes_put(block, request->elastic_stiffness, elastic, LANES_BASE * LANES_BASE);
}

/* Evaluate as many blocks as there are units, and write the requested results and the codes. */
INLINE void lanes_evaluate(const struct pkmodes_request *request, long long start, int units)
{
    const int modes = request->frequencies || request->eigenvalues || lanes_of_shapes(request)
        || request->eigenvalue_rates || request->frequency_rates;
    const int matrices = request->mass || request->stiffness || request->platform_motion;
    struct lanes_system system[EIGEN_UNITS];
    for (int u = 0; u < units; u++) {
        const long long first = start + u * LANES_WIDTH, left = request->count - first;
        lane q[LANES_INDEPENDENT], margin[LANES_MARGINS];
        for (int i = 0; i < LANES_POSE; i++)
            for (int w = 0; w < LANES_WIDTH; w++) /* the last pose fills up the last block */
                system[u].pose[i][w] = request->poses[(w < left ? first + w : request->count - 1) * LANES_POSE + i];
        lanes_position(system[u].pose, request->parameters, request->effects, q, margin);
        const mask code = lanes_checked(system[u].pose, margin, request->largest_condition);
        system[u].block = (struct lanes_block){request, first, left < LANES_WIDTH ? (int)left : LANES_WIDTH, code};
        if (request->joint_positions)
            lanes_put(&system[u].block, request->joint_positions, q, LANES_INDEPENDENT);
        if (request->platform_jacobian || request->static_torque || request->static_rotation
            || request->elastic_stiffness)
            lanes_put_statics(&system[u].block, system[u].pose);
        if (request->changes || request->mass_rates || request->stiffness_rates || request->mass_of_all)
            lanes_along_paths(&system[u].block, system[u].pose);
    }
    if (modes || matrices) {
        if (request->free_count)
            lanes_with_effects(system, units, modes);
        else
            lanes_without_effects(system, units, modes);
    }
    for (int u = 0; u < units; u++)
        for (int w = 0; w < system[u].block.count; w++)
            request->codes[system[u].block.start + w] = (signed char)system[u].block.code[w];
}

/* Evaluate one robot at its poses, from `start` to before `request->count`. */
static void lanes_robot(const struct pkmodes_request *request, long long start)
{
    for (; request->count - start > (EIGEN_UNITS - 1) * LANES_WIDTH; start += EIGEN_UNITS * LANES_WIDTH)
        lanes_evaluate(request, start, EIGEN_UNITS);
    for (; start < request->count; start += LANES_WIDTH)
        lanes_evaluate(request, start, 1);
}

void LANES_RUN(const struct pkmodes_request *request)
{
    const long long each = request->count / request->robots;
    for (long long r = 0; r < request->robots; r++) {
        struct pkmodes_request robot = *request;
        robot.count = (r + 1) * each;
        robot.parameters += r * request->parameter_count;
        robot.effects += r * request->effect_count;
        robot.joints += r * request->joint_count;
        if (request->term_count)
            robot.first_term += r * request->term_count;
        lanes_robot(&robot, r * each);
    }
}
