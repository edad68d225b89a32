/* Derivatives of eigenvalues and frequencies along paths, from the gradients of the generated code. */
#ifndef PKMODES_GRADIENT_H
#define PKMODES_GRADIENT_H

#include "system.h"

#define TWO_PI 6.283185307179586
/* Rounding of eigenvalues relative to the largest (`pkmodes.loop.sensitivity.modes.ROUNDING`). */
#define ROUNDING 1e-13

/* The modes in all coordinates, or those of the model without effects. */
INLINE void lanes_shapes(const struct lanes_system *restrict system, const struct eigen_problem *restrict problem, int n,
    int m, const int *restrict column, int all, lane *restrict shapes)
{
    const struct pkmodes_request *request = system->block.request;
    lanes_clear(shapes, m * all);
    for (int i = 0; i < m; i++) {
        lane x[LANES_ALL];
        lanes_shape(system, problem->Z + i * m, LANES(1.0), n, m, x);
        for (int k = 0; k < n; k++)
            shapes[i * all + (request->free_count ? request->free[column[k]] : column[k])] = x[k];
        for (int f = 0; f < request->fold_count; f++)
            shapes[i * all + request->following[f]] += request->fold_weights[f] * shapes[i * all + request->leading[f]];
    }
}

/* For each mode, the derivative of the eigenvalue with respect to the stiffness of each spring, which is the square of its
 * deflection, or to the compliance of a locked joint, which is minus the square of the force that it carries. */
INLINE void lanes_joint_rates(const struct lanes_system *restrict system, int m, const lane *restrict shapes,
    const lane *restrict eigenvalues, lane *restrict gradients, int stride)
{
    const struct pkmodes_request *request = system->block.request;
    lane M[LANES_ALL * LANES_ALL], K[LANES_ALL * LANES_ALL], J_p[LANES_DIRECTIONS * LANES_ALL];
    int locked[LANES_ALL];
    for (int r = 0; r < LANES_ALL; r++)
        locked[r] = r >= LANES_BASE;
    for (int i = 0; i < request->free_count; i++)
        locked[request->free[i]] = 0;
    if (request->locked_joints)
        lanes_extended(system->pose, request->parameters, request->effects, M, K, J_p);
    for (int j = 0; j < m; j++)
        for (int r = 0; r < LANES_ALL; r++) {
            const lane *restrict shape = shapes + j * LANES_ALL;
            lane force = shape[r];
            if (locked[r] && request->locked_joints) {
                force = (lane){0};
                for (int i = 0; i < LANES_ALL; i++)
                    force += (K[r * LANES_ALL + i] - eigenvalues[j] * M[r * LANES_ALL + i]) * shape[i];
                for (int f = 0; f < request->fold_count; f++)
                    for (int i = 0; request->leading[f] == r && i < LANES_ALL; i++) {
                        const int k = request->following[f] * LANES_ALL + i;
                        force += request->fold_weights[f] * (K[k] - eigenvalues[j] * M[k]) * shape[i];
                    }
            }
            gradients[j * stride + LANES_GRADIENT + r] = locked[r] ? -force * force : force * force;
        }
}

/* Write derivatives along the paths: those of the eigenvalues times a factor for each mode, which is NaN where a pose is
 * not evaluated. */
static __attribute__((noinline)) void lanes_put_rates(const struct lanes_block *block, double *restrict out,
    const lane *restrict gradients, int stride, int m, const lane *restrict factor)
{
    const struct pkmodes_request *request = block->request;
    const long long size = request->path_count * m;
    lane tile[LANES_WIDTH];
    double *row[LANES_WIDTH];
    int filled = 0;
    for (int w = 0; w < LANES_WIDTH; w++)
        row[w] = out + (block->start + w) * size;
    for (long long t = 0; t < request->path_count; t++) {
        const int first = request->first_term[t], end = request->first_term[t + 1];
        const double weight = request->weights[first];
        const lane *restrict gradient = gradients + request->places[first];
        for (int j = 0; j < m; j++, gradient += stride) {
            lane rate = weight * *gradient;
            for (int i = first + 1; i < end; i++)
                rate += request->weights[i] * gradients[j * stride + request->places[i]];
            tile[filled++] = pick(factor[j] == factor[j], rate * factor[j] + 0.0, LANES(NAN));
            if (filled < LANES_WIDTH)
                continue;
            lanes_transpose(tile);
            for (int w = 0; w < LANES_WIDTH; w++) {
                if (w < block->count)
                    *(lane_in_memory *)row[w] = tile[w];
                row[w] += LANES_WIDTH;
            }
            filled = 0;
        }
    }
    for (int i = 0; i < filled; i++)
        for (int w = 0; w < block->count; w++)
            row[w][i] = tile[i][w];
}

/* Write the derivatives of the eigenvalues and frequencies of a block along the paths. */
static __attribute__((noinline)) void lanes_differentiate(const struct lanes_system *restrict system,
    const struct eigen_problem *restrict problem, int n, int m, const int *restrict column)
{
    enum { STRIDE = LANES_GRADIENT + LANES_ALL };
    const struct pkmodes_request *request = system->block.request;
    const int with_effects = request->all_coordinates || request->free_count;
    const int all = with_effects ? LANES_ALL : LANES_BASE;
    const lane *restrict eigenvalues = problem->d;
    lane shapes[LANES_ALL * LANES_ALL], gradients[LANES_ALL * STRIDE], factor[LANES_ALL], largest = (lane){0};
    lanes_shapes(system, problem, n, m, column, all, shapes);
    if (with_effects) {
        lanes_extended_gradient(system->pose, request->parameters, request->effects, m, shapes, eigenvalues, gradients, STRIDE);
        lanes_joint_rates(system, m, shapes, eigenvalues, gradients, STRIDE);
    } else
        lanes_base_gradient(system->pose, request->parameters, request->effects, m, shapes, eigenvalues, gradients, STRIDE);
    for (int j = 0; j < m; j++)
        largest = pick(magnitude(eigenvalues[j]) > largest, magnitude(eigenvalues[j]), largest);
    for (int j = 0; j < m; j++)
        factor[j] = pick(system->block.code == 0, LANES(1.0), LANES(NAN));
    if (request->eigenvalue_rates)
        lanes_put_rates(&system->block, request->eigenvalue_rates, gradients, STRIDE, m, factor);
    for (int j = 0; j < m; j++) {
        const lane size = magnitude(eigenvalues[j]);
        factor[j] = pick(size > ROUNDING * largest, factor[j] / (2.0 * TWO_PI * root(size)), LANES(NAN));
    }
    if (request->frequency_rates)
        lanes_put_rates(&system->block, request->frequency_rates, gradients, STRIDE, m, factor);
}

#endif
