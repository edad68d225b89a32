/* Load a library of the compiled evaluator as pkmodes does, and write frequencies and shapes of a robot at poses.
 *
 *     one_library LIBRARY INPUT OUTPUT
 *
 * INPUT: numbers of poses, their components, parameters, effects, and coordinates, then the doubles.
 */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

#include "request.h"

enum { POSES, COMPONENTS, PARAMETERS, EFFECTS, COORDINATES, SIZES };

int main(int argc, char **argv)
{
    long long sizes[SIZES];
    void *library = argc == 4 ? dlopen(argv[1], RTLD_NOW) : NULL;
    FILE *in = library ? fopen(argv[2], "rb") : NULL, *out = in ? fopen(argv[3], "wb") : NULL;
    if (!out || fread(sizes, sizeof *sizes, SIZES, in) != SIZES) {
        fprintf(stderr, "%s\n", library ? "cannot read or write" : dlerror());
        return 1;
    }
    void (*run)(const struct pkmodes_request *, int) = (void (*)(const struct pkmodes_request *, int))dlsym(library, "pkmodes_run");
    int (*width)(void) = (int (*)(void))dlsym(library, "pkmodes_width");
    const size_t given = sizes[POSES] * sizes[COMPONENTS] + sizes[PARAMETERS] + sizes[EFFECTS];
    const size_t n = sizes[COORDINATES], results = sizes[POSES] * (n + n * n);
    double *input = malloc(given * sizeof *input), *output = malloc(results * sizeof *output);
    signed char *codes = malloc(sizes[POSES]);
    if (fread(input, sizeof *input, given, in) != given)
        return 1;
    struct pkmodes_request request = {.count = sizes[POSES], .poses = input, .largest_condition = 1e6, .robots = 1};
    request.parameters = input + sizes[POSES] * sizes[COMPONENTS];
    request.effects = request.parameters + sizes[PARAMETERS];
    request.frequencies = output;
    request.shapes = output + sizes[POSES] * n;
    request.codes = codes;
    run(&request, width());
    return fwrite(output, sizeof *output, results, out) != results || fclose(out);
}
