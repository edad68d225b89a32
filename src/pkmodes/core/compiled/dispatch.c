/* The entry points of a library: which of its evaluators this processor can run, and what it was built from. */
#include "processor.h"
#include "request.h"

#define EXPORT __attribute__((visibility("default")))

/* PKMODES_HAS_8 and PKMODES_HAS_4 say which of the wider evaluators are in this library. */
void pkmodes_run_8(const struct pkmodes_request *request);
void pkmodes_run_4(const struct pkmodes_request *request);
void pkmodes_run_2(const struct pkmodes_request *request);

EXPORT int pkmodes_layout(void)
{
    return PKMODES_LAYOUT;
}

/* SHA-256 of the sources. */
EXPORT const char *pkmodes_digest(void)
{
    return PKMODES_DIGEST;
}

/* The widest lanes that this processor has, whether the library has them or not. */
EXPORT int pkmodes_processor(void)
{
    return processor_lanes();
}

/* Whether the library has lanes of a width. */
EXPORT int pkmodes_has(int width)
{
#ifdef PKMODES_HAS_8
    if (width == 8)
        return 1;
#endif
#ifdef PKMODES_HAS_4
    if (width == 4)
        return 1;
#endif
    return width == 2;
}

/* The widest lanes that both have. */
EXPORT int pkmodes_width(void)
{
    int width = processor_lanes();
    while (!pkmodes_has(width))
        width /= 2;
    return width;
}

/* Evaluate with lanes of a width that `pkmodes_width` allows. */
EXPORT void pkmodes_run(const struct pkmodes_request *request, int width)
{
#ifdef PKMODES_HAS_8
    if (width == 8) {
        pkmodes_run_8(request);
        return;
    }
#endif
#ifdef PKMODES_HAS_4
    if (width == 4) {
        pkmodes_run_4(request);
        return;
    }
#endif
    (void)width;
    pkmodes_run_2(request);
}
