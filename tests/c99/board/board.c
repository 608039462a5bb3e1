/* A board without a library: starts, runs a scene, says what came out, by semihosting. */
#include <stdint.h>
#include <string.h>

#include SCENE_HEADER

#define JOINED(a, b) a##b
#define NAMED(scene, name) JOINED(scene, name)
#define OF(name) NAMED(SCENE, name)

extern uint32_t data_from[], data_start[], data_end[], bss_start[], bss_end[];
extern uint32_t stack_start[], stack_end[];

void reset(void);
static void stop(void);

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    stack_end, (const void *)reset, (const void *)stop, (const void *)stop, (const void *)stop,
    (const void *)stop, (const void *)stop
};

static int host(int operation, const void *argument)
{
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void stop(void)
{
    /* SYS_EXIT, ADP_Stopped_ApplicationExit. */
    (void)host(0x18, (const void *)0x20026);
    for (;;) {
    }
}

static void put(const char *name, uint64_t number)
{
    char line[80];
    size_t at = 0u;
    int digit;
    while (*name != '\0') {
        line[at++] = *name++;
    }
    line[at++] = ' ';
    for (digit = 60; digit >= 0; digit -= 4) {
        line[at++] = "0123456789abcdef"[(number >> digit) & 15u];
    }
    line[at++] = '\n';
    line[at] = '\0';
    (void)host(0x04, line);
}

static OF(_machine_t) machine;

#ifdef MEASURE_HEADER
/* A filter follows the machine, which is not timed. */
#include MEASURE_HEADER
static OF(_estimator_t) runner;
#define STATE runner.machine.state
#else
#define runner machine
#define STATE machine.state
#endif

static void put_all(const void *from, size_t count)
{
    size_t entry;
    for (entry = 0u; entry < count; ++entry) {
        uint64_t bits = 0u;
        (void)memcpy(&bits, (const unsigned char *)from + entry * sizeof(REAL), sizeof(REAL));
        put("state", bits);
    }
}

int main(void)
{
    volatile uint32_t *const control = (volatile uint32_t *)0xe000e010u;
    volatile uint32_t *const reload = (volatile uint32_t *)0xe000e014u;
    volatile uint32_t *const current = (volatile uint32_t *)0xe000e018u;
    const REAL step = STEP;
    uint64_t ticks = 0u, most = 0u;
    long k, events = 0;

    OF(_begin)(&machine);
#ifdef MEASURE_HEADER
    OF(_estimator_begin)(&runner);
#endif
    *reload = 0xffffffu;
    *control = 5u;
    for (k = 0; k < STEPS; ++k) {
        uint32_t took;
#ifdef MEASURE_HEADER
        OF(_measured_t) measured;
        measure(&machine, step, k, &measured);
        *current = 0u;
        events += OF(_estimator_predict)(&runner, step);
        (void)OF(_estimator_correct)(&runner, &measured);
#else
        *current = 0u;
        events += OF(_step)(&machine, step);
#endif
        took = *current;
        /* Zero until the first tick. */
        took = (took == 0u) ? 0u : 0xffffffu - took;
        ticks += took;
        most = (took > most) ? took : most;
    }
    put_all(&STATE, sizeof STATE / sizeof(REAL));
#ifdef MEASURE_HEADER
    put_all(runner.root, sizeof runner.root / sizeof(REAL));
#endif
    put("ticks", ticks);
    put("most", most);
    put("events", (uint64_t)events);
    put("ram", sizeof runner);
    {
        const uint32_t *low = stack_start;
        while (*low == 0xa5a5a5a5u) {
            ++low;
        }
        put("stack", (uint64_t)((const char *)stack_end - (const char *)low));
    }
    return 0;
}

__attribute__((noreturn)) void reset(void)
{
    uint32_t *to, *from = data_from;
    /* The processor's unit for floating point. */
    *(volatile uint32_t *)0xe000ed88u |= 0xfu << 20;
    __asm__ volatile("dsb\nisb");
    for (to = data_start; to < data_end; ++to) {
        *to = *from++;
    }
    for (to = bss_start; to < bss_end; ++to) {
        *to = 0u;
    }
    for (to = stack_start; to < (uint32_t *)&to - 16; ++to) {
        *to = 0xa5a5a5a5u;
    }
    (void)main();
    stop();
    for (;;) {
    }
}
