/* A block of poses, one in each lane, and writing what was computed for it: a row of doubles for each pose. */
#ifndef PKMODES_ROWS_H
#define PKMODES_ROWS_H

#include "lane.h"
#include "request.h"

/* A block of poses: one for each lane. */
struct lanes_block {
    const struct pkmodes_request *request;
    long long start;
    int count;
    mask code;
};

/* Write a row for each pose, NaN where it is not evaluated; `row` says where they begin. */
static __attribute__((noinline)) void lanes_put_at(
    const struct lanes_block *block, double *const *row, const lane *restrict x, int size)
{
    int i = 0;
    for (; i + LANES_WIDTH <= size; i += LANES_WIDTH) {
        lane tile[LANES_WIDTH];
        for (int k = 0; k < LANES_WIDTH; k++)
            tile[k] = pick(block->code == 0, x[i + k] + 0.0, LANES(NAN));
        lanes_transpose(tile);
        if (block->count == LANES_WIDTH)
            for (int w = 0; w < LANES_WIDTH; w++)
                *(lane_in_memory *)(row[w] + i) = tile[w];
        else
            for (int w = 0; w < block->count; w++)
                *(lane_in_memory *)(row[w] + i) = tile[w];
    }
    for (; i < size; i++) {
        double tile[LANES_WIDTH];
        *(lane_in_memory *)tile = pick(block->code == 0, x[i] + 0.0, LANES(NAN));
        for (int w = 0; w < block->count; w++)
            row[w][i] = tile[w];
    }
}

/* The same for rows of `size` that follow one another. */
INLINE void lanes_put(const struct lanes_block *block, double *restrict out, const lane *restrict x, int size)
{
    double *row[LANES_WIDTH];
    for (int w = 0; w < LANES_WIDTH; w++)
        row[w] = out + (block->start + w) * size;
    lanes_put_at(block, row, x, size);
}

#endif
