/* Best match with CMSIS-DSP on the shapes of the budget: instructions on an emulated Cortex-M4F.
 *
 * Three ways to write it, each with a search for the smallest at the end: the distance function, a
 * dot product for each node with |m|^2 kept, and one product of matrix and vector. `run` builds and
 * starts this; it is linked with nothing but CMSIS-DSP's own sources.
 */
#include <stdint.h>
#include "arm_math.h"

#define NODES 400
#define FEATURES 150

extern uint32_t stack_top;
void start(void);
__attribute__((section(".vectors"), used)) void *const vectors[] = {&stack_top, start};

static volatile uint32_t *const timer = (uint32_t *)0x40000000; /* control, value, reload */
static float32_t map[NODES * FEATURES], norms[NODES], out[NODES], stimulus[FEATURES];

static long call(long operation, void *argument) {
    register long r0 __asm("r0") = operation;
    register void *r1 __asm("r1") = argument;
    __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void print(const char *text) { call(4, (void *)text); }

static void print_number(uint32_t number) {
    char digits[12], *at = digits + 11;
    *at = 0;
    do *--at = (char)('0' + number % 10);
    while (number /= 10);
    print(at);
}

/* An instruction takes 64 ns of the board's time, the timer counts every 40 ns. */
static uint32_t instructions(uint32_t before) { return (uint32_t)((uint64_t)(before - timer[1]) * 5 / 8); }

static uint32_t by_distance(uint32_t nodes, uint32_t features) {
    float32_t least;
    uint32_t winner;
    for (uint32_t i = 0; i < nodes; i++)
        out[i] = arm_euclidean_distance_f32(stimulus, map + i * features, features);
    arm_min_f32(out, nodes, &least, &winner);
    return winner;
}

static uint32_t by_dot_product(uint32_t nodes, uint32_t features) {
    float32_t least, dot;
    uint32_t winner;
    for (uint32_t i = 0; i < nodes; i++) {
        arm_dot_prod_f32(stimulus, map + i * features, features, &dot);
        out[i] = norms[i] - 2.0f * dot;
    }
    arm_min_f32(out, nodes, &least, &winner);
    return winner;
}

static uint32_t by_matrix(uint32_t nodes, uint32_t features) {
    float32_t least;
    uint32_t winner;
    arm_matrix_instance_f32 matrix = {(uint16_t)nodes, (uint16_t)features, map};
    arm_mat_vec_mult_f32(&matrix, stimulus, out);
    for (uint32_t i = 0; i < nodes; i++) out[i] = norms[i] - 2.0f * out[i];
    arm_min_f32(out, nodes, &least, &winner);
    return winner;
}

static void measure(const char *name, uint32_t (*search)(uint32_t, uint32_t), uint32_t nodes,
                    uint32_t features, uint32_t on) {
    uint32_t before = timer[1];
    uint32_t winner = search(nodes, features);
    uint32_t taken = instructions(before);
    print(name);
    print(" ");
    print_number(nodes);
    print("x");
    print_number(features);
    print(" on ");
    print_number(on);
    print(" = ");
    print_number(taken);
    print(" winner ");
    print_number(winner);
    print("\n");
}

static void shape(uint32_t nodes, uint32_t features, uint32_t on) {
    uint32_t seed = 1;
    for (uint32_t i = 0; i < nodes * features; i++) {
        seed = seed * 1664525u + 1013904223u;
        map[i] = (float32_t)(seed >> 8) / 16777216.0f;
    }
    for (uint32_t j = 0; j < features; j++) stimulus[j] = 0.0f;
    for (uint32_t i = 0; i < on; i++) stimulus[i * features / on] = 1.0f;
    for (uint32_t i = 0; i < nodes; i++) {
        norms[i] = 0.0f;
        for (uint32_t j = 0; j < features; j++) norms[i] += map[i * features + j] * map[i * features + j];
    }
    measure("distance", by_distance, nodes, features, on);
    measure("dot_product", by_dot_product, nodes, features, on);
    measure("matrix", by_matrix, nodes, features, on);
}

void start(void) {
    *(volatile uint32_t *)0xE000ED88 |= 0xFu << 20; /* the FPU */
    __asm volatile("dsb\nisb");
    timer[0] = 0;
    timer[1] = timer[2] = 0xFFFFFFFFu;
    timer[0] = 1;
    shape(400, 14, 4);
    shape(400, 142, 10);
    shape(100, 150, 12);
    call(0x18, (void *)0x20026); /* exit, all well */
    for (;;) {}
}
