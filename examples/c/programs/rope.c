/* A rope of 20 particles, held at one end, swings down and bounces on a floor: create, add, step, read. */

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "../hooke.h"

enum { PARTICLES = 20, SPRINGS = PARTICLES - 1, PLANES = 1 };

static void check(hooke_code code, const hooke_world *world)
{
    if (code == HOOKE_CODE_OK) {
        return;
    }
    uint32_t culprit = hooke_culprit(world);
    if (culprit == UINT32_MAX) {
        fprintf(stderr, "hooke: %s\n", hooke_message(code));
    } else {
        fprintf(stderr, "hooke: %s (number %" PRIu32 ")\n", hooke_message(code), culprit);
    }
    exit(EXIT_FAILURE);
}

int main(void)
{
    /* The world and the workspace of its stepper, in one piece. On a microcontroller it would be a static array. */
    size_t size = hooke_size_of(HOOKE_PRECISION_F64, PARTICLES, SPRINGS, PLANES)
        + hooke_workspace_size(HOOKE_PRECISION_F64, HOOKE_STEPPER_VELOCITY_VERLET, HOOKE_COLLISION_TIME_OF_IMPACT,
                               PARTICLES, SPRINGS, PLANES, 0);
    void *memory = aligned_alloc(64, (size + 63) / 64 * 64);
    hooke_world *world = NULL;
    check(hooke_create(memory, size, HOOKE_PRECISION_F64, PARTICLES, SPRINGS, PLANES, &world), world);
    check(hooke_set_gravity(world, 0.0, 0.0, -9.81), world);
    for (uint32_t i = 0; i < PARTICLES; i++) {
        uint32_t hold = i == 0 ? HOOKE_HOLD_PINNED : HOOKE_HOLD_FREE;
        check(hooke_add_particle(world, 0.05 * i, 0.0, 1.0, 0.0, 0.0, 0.0, 0.01, hold, NULL), world);
    }
    for (uint32_t i = 0; i < SPRINGS; i++) {
        check(hooke_add_spring(world, i, i + 1, 500.0, 0.05, 0.05, NULL), world);
    }
    check(hooke_add_plane(world, 0.0, 0.0, 0.1, 0.0, 0.0, 1.0, 0.5, NULL), world);
    check(hooke_set_stepper(world, HOOKE_STEPPER_VELOCITY_VERLET, 1e-6), world);
    check(hooke_set_collision(world, HOOKE_COLLISION_TIME_OF_IMPACT), world);
    check(hooke_open_ledger(world), world);

    double longest = 0.0;
    check(hooke_stable_step(world, HOOKE_STEPPER_VELOCITY_VERLET, &longest), world);
    printf("velocity Verlet is stable up to %.2f ms\n", 1e3 * longest);

    puts("  time       x       z    hits");
    for (int frame = 1; frame <= 10; frame++) {
        hooke_report report;
        double position[3 * PARTICLES];
        check(hooke_step(world, 1e-3, 100, &report), world);
        check(hooke_read(world, position, NULL, 3 * PARTICLES), world);
        printf("%4.1f s  %6.3f  %6.3f  %6" PRIu32 "\n", report.time, position[3 * PARTICLES - 3],
               position[3 * PARTICLES - 1], report.hits);
    }
    hooke_ledger ledger;
    uint64_t digest = 0;
    check(hooke_read_ledger(world, &ledger), world);
    check(hooke_digest(world, &digest), world);
    printf("%.4f J lost to damping, %.4f J in impacts; the stepper itself is off by %.1e J\n", ledger.lost_to_damping,
           ledger.lost_in_impacts, ledger.remainder);
    printf("digest %016" PRIx64 "\n", digest);
    check(hooke_destroy(world), NULL);
    free(memory);
    return EXIT_SUCCESS;
}
