/* Derivatives of M, K and the platform's motion along paths, as far as the derivatives of given modes need them. */
#ifndef PKMODES_TANGENT_H
#define PKMODES_TANGENT_H

#include "rows.h"

/* A block of poses with their modes, whose derivatives along the paths are wanted. */
struct lanes_paths {
    struct lanes_block block;
    lane eigenvalues[LANES_ALL], shapes[LANES_ALL * LANES_ALL];
    int m;
};

/* The change of every quantity along a path; the pose and the joints are not quantities, but change in the same way. */
static void lanes_direction(const struct lanes_paths *paths, int path, lane *restrict direction)
{
    const struct pkmodes_request *request = paths->block.request;
    lanes_clear(direction, LANES_GRADIENT);
    for (int i = request->first_term[path]; i < request->first_term[path + 1]; i++)
        if (request->places[i] < LANES_GRADIENT)
            direction[request->places[i]] += request->weights[i];
}

/* Row `t` of the results of each pose, of `size` numbers. */
INLINE void lanes_put_path(const struct lanes_block *block, double *restrict out, const lane *restrict x, int t, int size)
{
    double *row[LANES_WIDTH];
    for (int w = 0; w < LANES_WIDTH; w++)
        row[w] = out + ((block->start + w) * block->request->path_count + t) * size;
    lanes_put_at(block, row, x, size);
}

/* The coordinates that follow free ones, after these in x: `at` says which of all coordinates each is. */
INLINE void lanes_follow(const struct pkmodes_request *restrict request, const int *restrict at, lane *restrict x)
{
    const int n = (int)request->free_count;
    for (int f = 0; f < request->fold_count; f++) {
        x[n + f] = (lane){0};
        for (int k = 0; k < n; k++)
            if (at[k] == request->leading[f])
                x[n + f] += request->fold_weights[f] * x[k];
    }
}

/* The forces on free coordinates, with those on the coordinates that follow them. */
INLINE void lanes_lead(const struct pkmodes_request *restrict request, const int *restrict at, lane *restrict force)
{
    const int n = (int)request->free_count;
    for (int f = 0; f < request->fold_count; f++)
        for (int k = 0; k < n; k++)
            if (at[k] == request->leading[f])
                force[k] += request->fold_weights[f] * force[n + f];
}

/* Write (dK - lambda dM) phi, phi^T (dK - lambda dM) phi, phi^T dM phi and dJ phi of each mode. */
static void lanes_take(const struct lanes_paths *paths, int path, const lane *restrict mass_rate,
    const lane *restrict stiffness_rate, const lane *restrict motion_rate)
{
    const struct pkmodes_request *request = paths->block.request;
    const int n = (int)request->free_count, m = paths->m, followers = (int)request->fold_count;
    int at[LANES_ALL];
    for (int k = 0; k < n + followers; k++)
        at[k] = k < n ? request->free[k] : request->following[k - n];
    lane changes[LANES_ALL * LANES_ALL], rates[LANES_ALL], norms[LANES_ALL], motions[LANES_ALL * LANES_DIRECTIONS];
    double spring[LANES_ALL] = {0.0};
    for (int i = request->first_term[path]; i < request->first_term[path + 1]; i++)
        if (request->places[i] >= LANES_GRADIENT)
            spring[request->places[i] - LANES_GRADIENT] += request->weights[i];
    for (int i = 0; i < m; i++) {
        const lane eigenvalue = paths->eigenvalues[i];
        lane x[LANES_ALL], force[LANES_ALL], momentum[LANES_ALL];
        for (int k = 0; k < n; k++)
            x[k] = paths->shapes[i * n + k];
        lanes_follow(request, at, x);
        for (int k = 0; k < n + followers; k++) {
            force[k] = k < n ? spring[at[k]] * x[k] : (lane){0};
            momentum[k] = (lane){0};
            for (int l = 0; l < n + followers; l++) {
                force[k] += stiffness_rate[at[k] * LANES_ALL + at[l]] * x[l];
                momentum[k] += mass_rate[at[k] * LANES_ALL + at[l]] * x[l];
            }
        }
        lanes_lead(request, at, force);
        lanes_lead(request, at, momentum);
        rates[i] = norms[i] = (lane){0};
        for (int k = 0; k < n; k++) {
            changes[i * n + k] = force[k] - eigenvalue * momentum[k];
            rates[i] += x[k] * changes[i * n + k];
            norms[i] += x[k] * momentum[k];
        }
        for (int a = 0; a < LANES_DIRECTIONS; a++) {
            lane motion = (lane){0};
            for (int l = 0; l < n + followers; l++)
                motion += motion_rate[a * LANES_ALL + at[l]] * x[l];
            motions[i * LANES_DIRECTIONS + a] = motion;
        }
    }
    lanes_put_path(&paths->block, request->changes, changes, path, m * n);
    lanes_put_path(&paths->block, request->mode_rates, rates, path, m);
    lanes_put_path(&paths->block, request->norms, norms, path, m);
    lanes_put_path(&paths->block, request->motions, motions, path, m * LANES_DIRECTIONS);
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

/* The derivatives that the modes of a block need, along all paths. */
static __attribute__((noinline)) void lanes_along_paths(const struct lanes_block *block, const lane *restrict pose)
{
    const struct pkmodes_request *request = block->request;
    struct lanes_paths paths;
    paths.block = *block;
    paths.m = (int)request->modes;
    lanes_get(block, request->given_eigenvalues, paths.eigenvalues, paths.m);
    lanes_get(block, request->given_shapes, paths.shapes, paths.m * (int)request->free_count);
    lanes_extended_tangent(pose, request->parameters, request->effects, (int)request->path_count, &paths);
}

#endif
