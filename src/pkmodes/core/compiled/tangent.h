/* Derivatives of M, K and the platform's motion along paths, as far as the derivatives of given modes need them. */
#ifndef PKMODES_TANGENT_H
#define PKMODES_TANGENT_H

#include "rows.h"

/* A block of poses with their modes, whose derivatives along the paths are wanted: path by path, or with a single pose
 * as many paths at once as there are lanes. */
struct lanes_paths {
    struct lanes_block block;
    lane eigenvalues[LANES_ALL], shapes[LANES_ALL * LANES_ALL];
    int n, m, at_once;
};

/* The path in lane w of a group; the last one fills up the last group. */
INLINE int lanes_path_of(const struct lanes_paths *paths, int group, int w)
{
    const int last = (int)paths->block.request->path_count - 1;
    const int path = group * paths->at_once + (paths->at_once > 1 ? w : 0);
    return path < last ? path : last;
}

/* Sum the weights of a group of paths at each place in the gradient from one on, up to another. */
static void lanes_terms(const struct lanes_paths *paths, int group, int from, int to, lane *restrict sums)
{
    const struct pkmodes_request *request = paths->block.request;
    lanes_clear(sums, to - from);
    for (int w = 0; w < (paths->at_once > 1 ? LANES_WIDTH : 1); w++) {
        const int path = lanes_path_of(paths, group, w);
        for (int i = request->first_term[path]; i < request->first_term[path + 1]; i++) {
            const int place = request->places[i];
            if (place < from || place >= to)
                continue;
            if (paths->at_once > 1)
                sums[place - from][w] += request->weights[i];
            else
                sums[place - from] += request->weights[i];
        }
    }
}

/* The change of every quantity, and of the pose, along a path. */
static void lanes_direction(const struct lanes_paths *paths, int group, lane *restrict direction)
{
    lanes_terms(paths, group, 0, LANES_GRADIENT, direction);
}

/* The results of a group of paths, of `size` numbers for each path of a pose. */
INLINE void lanes_put_path(
    const struct lanes_paths *paths, double *restrict out, const lane *restrict x, int group, int size)
{
    struct lanes_block block = paths->block;
    double *row[LANES_WIDTH];
    for (int w = 0; w < LANES_WIDTH; w++) {
        const long long pose = block.start + (paths->at_once > 1 ? 0 : w);
        row[w] = out + (pose * block.request->path_count + lanes_path_of(paths, group, w)) * size;
    }
    if (paths->at_once > 1)
        block.count = lanes_path_of(paths, group, LANES_WIDTH - 1) - group * LANES_WIDTH + 1;
    lanes_put_at(&block, row, x, size);
}

/* The coordinates that follow free ones, after these in x: `at` says which of all coordinates each is. */
INLINE void lanes_follow(const struct pkmodes_request *restrict request, int n, const int *restrict at, lane *restrict x)
{
    for (int f = 0; f < request->fold_count; f++) {
        x[n + f] = (lane){0};
        for (int k = 0; k < n; k++)
            if (at[k] == request->leading[f])
                x[n + f] += request->fold_weights[f] * x[k];
    }
}

/* The forces on free coordinates, with those on the coordinates that follow them, each `stride` after the one before. */
INLINE void lanes_lead(
    const struct pkmodes_request *restrict request, int n, const int *restrict at, lane *restrict force, int stride)
{
    for (int f = 0; f < request->fold_count; f++)
        for (int k = 0; k < n; k++)
            if (at[k] == request->leading[f])
                force[k * stride] += request->fold_weights[f] * force[(n + f) * stride];
}

/* The coordinates that are not locked, and after them those that follow. */
INLINE void lanes_coordinates(const struct lanes_paths *paths, int *restrict at)
{
    const struct pkmodes_request *request = paths->block.request;
    for (int k = 0; k < paths->n; k++)
        at[k] = request->free_count ? request->free[k] : k;
    for (int f = 0; f < request->fold_count; f++)
        at[paths->n + f] = request->following[f];
}

/* Write the derivative of a matrix along a path, in the coordinates that are not locked, perhaps with springs. */
INLINE void lanes_put_matrix(const struct lanes_paths *paths, int group, const int *restrict at,
    const lane *restrict rate, const lane *restrict spring, double *restrict out)
{
    const struct pkmodes_request *request = paths->block.request;
    const int n = paths->n, size = n + (int)request->fold_count;
    lane A[LANES_ALL * LANES_ALL];
    for (int k = 0; k < size; k++)
        for (int l = 0; l < size; l++)
            A[k * size + l] = rate[at[k] * LANES_ALL + at[l]];
    for (int l = 0; l < size; l++) /* columns, then rows */
        lanes_lead(request, n, at, A + l, size);
    for (int k = 0; k < n; k++) {
        lanes_lead(request, n, at, A + k * size, 1);
        for (int l = 0; l < n; l++)
            A[k * n + l] = A[k * size + l];
        if (spring)
            A[k * n + k] += spring[at[k]];
    }
    lanes_put_path(paths, out, A, group, n * n);
}

/* Write (dK - lambda dM) phi, phi^T (dK - lambda dM) phi, phi^T dM phi and dJ phi of each mode, and dM and dK. */
static void lanes_take(const struct lanes_paths *paths, int group, const lane *restrict mass_rate,
    const lane *restrict stiffness_rate, const lane *restrict motion_rate)
{
    const struct pkmodes_request *request = paths->block.request;
    const int n = paths->n, m = paths->m, size = n + (int)request->fold_count;
    int at[LANES_ALL];
    lanes_coordinates(paths, at);
    lane changes[LANES_ALL * LANES_ALL], rates[LANES_ALL], norms[LANES_ALL], motions[LANES_ALL * LANES_DIRECTIONS];
    lane spring[LANES_ALL];
    lanes_terms(paths, group, LANES_GRADIENT, LANES_GRADIENT + LANES_ALL, spring);
    for (int i = 0; i < m; i++) {
        const lane eigenvalue = paths->eigenvalues[i];
        lane x[LANES_ALL], force[LANES_ALL], momentum[LANES_ALL];
        for (int k = 0; k < n; k++)
            x[k] = paths->shapes[i * n + k];
        lanes_follow(request, n, at, x);
        for (int k = 0; k < size; k++) {
            force[k] = k < n ? spring[at[k]] * x[k] : (lane){0};
            momentum[k] = (lane){0};
            for (int l = 0; l < size; l++) {
                force[k] += stiffness_rate[at[k] * LANES_ALL + at[l]] * x[l];
                momentum[k] += mass_rate[at[k] * LANES_ALL + at[l]] * x[l];
            }
        }
        lanes_lead(request, n, at, force, 1);
        lanes_lead(request, n, at, momentum, 1);
        rates[i] = norms[i] = (lane){0};
        for (int k = 0; k < n; k++) {
            changes[i * n + k] = force[k] - eigenvalue * momentum[k];
            rates[i] += x[k] * changes[i * n + k];
            norms[i] += x[k] * momentum[k];
        }
        for (int a = 0; a < LANES_DIRECTIONS; a++) {
            lane motion = (lane){0};
            for (int l = 0; l < size; l++)
                motion += motion_rate[a * LANES_ALL + at[l]] * x[l];
            motions[i * LANES_DIRECTIONS + a] = motion;
        }
    }
    if (request->changes)
        lanes_put_path(paths, request->changes, changes, group, m * n);
    if (request->mode_rates)
        lanes_put_path(paths, request->mode_rates, rates, group, m);
    if (request->norms)
        lanes_put_path(paths, request->norms, norms, group, m);
    if (request->motions)
        lanes_put_path(paths, request->motions, motions, group, m * LANES_DIRECTIONS);
    if (request->mass_rates)
        lanes_put_matrix(paths, group, at, mass_rate, 0, request->mass_rates);
    if (request->stiffness_rates)
        lanes_put_matrix(paths, group, at, stiffness_rate, spring, request->stiffness_rates);
}

/* Read a row of each pose of a block, the last one for lanes that are not filled. */
INLINE void lanes_get(const struct lanes_block *block, const double *restrict in, lane *restrict x, int size)
{
    for (int w = 0; w < LANES_WIDTH; w++) {
        const double *restrict row = in + (block->start + (w < block->count ? w : block->count - 1)) * size;
        for (int i = 0; i < size; i++)
            x[i][w] = row[i];
    }
}

/* The derivatives that the modes of a block need, along all paths, with the matrices of all coordinates. */
static __attribute__((noinline)) void lanes_along_paths(const struct lanes_block *block, const lane *restrict pose)
{
    const struct pkmodes_request *request = block->request;
    struct lanes_paths paths;
    paths.block = *block;
    paths.n = request->free_count ? (int)request->free_count : LANES_BASE;
    paths.m = (int)request->modes;
    paths.at_once = block->count == 1 ? LANES_WIDTH : 1;
    lanes_get(block, request->given_eigenvalues, paths.eigenvalues, paths.m);
    lanes_get(block, request->given_shapes, paths.shapes, paths.m * paths.n);
    if (request->mass_of_all && request->stiffness_of_all) {
        lane M[LANES_ALL * LANES_ALL], K[LANES_ALL * LANES_ALL], J_p[LANES_DIRECTIONS * LANES_ALL];
        lanes_extended(pose, request->parameters, request->effects, M, K, J_p);
        lanes_put(block, request->mass_of_all, M, LANES_ALL * LANES_ALL);
        lanes_put(block, request->stiffness_of_all, K, LANES_ALL * LANES_ALL);
    }
    if (request->path_count)
        lanes_extended_tangent(pose, request->parameters, request->effects,
            ((int)request->path_count + paths.at_once - 1) / paths.at_once, &paths);
}

#endif
