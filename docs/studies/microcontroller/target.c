/* What a controller does in a tick, for the poses of poses.h: results are printed as bytes in hexadecimal.
 *
 * On a Cortex-M7 without an operating system (an emulated MPS2 board with AN500 image), and on any other machine.  There
 * the most stack that the functions use is printed, too: the unused part keeps the pattern that it was painted with.
 */
#include <stddef.h>

#include "poses.h" /* of the robot: its header and functions, RESULTS, POSES and poses */

static robot_shaper shaper, factor;
static robot_shaped shaped;

static void print(const char *text);

static void print_bytes(const void *data, size_t count)
{
    static const char digits[] = "0123456789abcdef";
    const unsigned char *bytes = data;
    char text[] = "00";
    size_t i;
    for (i = 0; i < count; ++i) {
        text[0] = digits[bytes[i] >> 4];
        text[1] = digits[bytes[i] & 15];
        print(text);
    }
    print(" ");
}

/* A shaper for the modes of a pose, and the command that passes it. */
static void shape(const pkmodes_real *p, const pkmodes_real *f, const pkmodes_real *zeta, pkmodes_real *result)
{
    int i;
    robot_shaper_design(0, f[0], zeta[0], &shaper);
    for (i = 1; i < FACTORS; ++i)
        if (robot_shaper_design(0, f[i], zeta[i], &factor) == 0)
            robot_shaper_multiply(&shaper, &factor);
    robot_shaped_command(&shaped, &shaper, (pkmodes_real)1e-3, p, result);
}

#if defined(__arm__)

extern unsigned stack_end[], stack_top[];
int main(void);

/* Semihosting: the emulator prints, and ends. */
static int host(int operation, const void *argument)
{
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void print(const char *text) { host(4, text); }

static void start(void)
{
    *(volatile unsigned *)0xe000ed88u |= 0xf00000u; /* the floating-point unit: coprocessors 10 and 11 */
    __asm__ volatile("dsb; isb");
    main();
    host(0x18, (const void *)0x20026);
}

static void fault(void)
{
    print("fault\n");
    host(0x18, (const void *)0x20023);
}

__attribute__((section(".vectors"), used)) static void *const vectors[16] = {
    stack_top, (void *)start, (void *)fault, (void *)fault, (void *)fault, (void *)fault, (void *)fault};

enum { PATTERN = 0x5ca1ab1e };

static unsigned *here(void) { return __builtin_frame_address(0); }

static void paint(void)
{
    volatile unsigned *each;
    for (each = stack_end; each < here() - 32; ++each)
        *each = PATTERN;
}

/* Bytes below the caller's frame that are not painted any more. */
static unsigned used(void)
{
    const volatile unsigned *each = stack_end;
    while (*each == PATTERN)
        ++each;
    return (unsigned)((const volatile unsigned char *)here() - (const volatile unsigned char *)each);
}

#else

#include <stdio.h>

static void print(const char *text) { fputs(text, stdout); }
static void paint(void) {}
static unsigned used(void) { return 0; }

#endif

int main(void)
{
    static pkmodes_real f[MODES], zeta[MODES], amplitude[MODES], result[sizeof poses[0]/sizeof poses[0][0]];
    static int status;
    unsigned stack[2] = {0, 0}, now;
    int i;
    robot_shaped_rest(&shaped, poses[0]);
    for (i = 0; i < POSES; ++i) {
        paint();
        status = robot_vibration(poses[i], f, zeta, amplitude);
        now = used();
        stack[0] = now > stack[0] ? now : stack[0];
        paint();
        shape(poses[i], f, zeta, result);
        now = used();
        stack[1] = now > stack[1] ? now : stack[1];
        print_bytes(&status, sizeof status);
        print_bytes(f, sizeof f);
        print_bytes(zeta, sizeof zeta);
        print_bytes(amplitude, sizeof amplitude);
        print_bytes(result, sizeof result);
        print("\n");
    }
    print_bytes(stack, sizeof stack);
    print("\n");
    return 0;
}
