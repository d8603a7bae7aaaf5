/* Every misuse that a function can find out is an error, and changes nothing. */

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../hooke.h"
#include "check.h"

static void memory_and_pointers(void)
{
    size_t size = hooke_size_of(HOOKE_PRECISION_F32, 2, 1, 1);
    hooke_world *world = NULL;
    EXPECT(size > 0);
    EXPECT(hooke_size_of(7, 2, 1, 1) == 0);
    EXPECT(hooke_workspace_size(HOOKE_PRECISION_F32, 99, 0, 2, 1, 1, 0) == 0);
    char *memory = aligned_alloc(64, (size + 64 + 63) / 64 * 64);
    EXPECT_CODE(hooke_create(NULL, size, HOOKE_PRECISION_F32, 2, 1, 1, &world), HOOKE_CODE_NULL_POINTER);
    EXPECT_CODE(hooke_create(memory, size, HOOKE_PRECISION_F32, 2, 1, 1, NULL), HOOKE_CODE_NULL_POINTER);
    EXPECT_CODE(hooke_create(memory + 8, size, HOOKE_PRECISION_F32, 2, 1, 1, &world), HOOKE_CODE_MISALIGNED);
    EXPECT_CODE(hooke_create(memory, size - 1, HOOKE_PRECISION_F32, 2, 1, 1, &world), HOOKE_CODE_TOO_SMALL);
    EXPECT_CODE(hooke_create(memory, SIZE_MAX, HOOKE_PRECISION_F32, 2, 1, 1, &world), HOOKE_CODE_LENGTH);
    EXPECT_CODE(hooke_create(memory, size, HOOKE_PRECISION_F32, UINT32_MAX, UINT32_MAX, 1, &world),
                HOOKE_CODE_TOO_SMALL);
    EXPECT_CODE(hooke_create(memory, size, 2, 2, 1, 1, &world), HOOKE_CODE_NO_SUCH_OPTION);
    EXPECT(world == NULL);
    memset(memory, 0, size);
    EXPECT_CODE(hooke_step((hooke_world *)(void *)memory, 1e-3, 1, NULL), HOOKE_CODE_NOT_A_WORLD);
    EXPECT_CODE(hooke_step((hooke_world *)(void *)(memory + 4), 1e-3, 1, NULL), HOOKE_CODE_MISALIGNED);
    EXPECT_CODE(hooke_step(NULL, 1e-3, 1, NULL), HOOKE_CODE_NULL_POINTER);
    EXPECT(isnan(hooke_time(NULL)));
    EXPECT(hooke_snapshot_size(NULL) == 0);
    EXPECT(hooke_culprit(NULL) == UINT32_MAX);
    EXPECT_OK(hooke_create(memory, size, HOOKE_PRECISION_F32, 2, 1, 1, &world));
    EXPECT_OK(hooke_destroy(world));
    EXPECT_CODE(hooke_destroy(world), HOOKE_CODE_NOT_A_WORLD);
    free(memory);
}

static void numbers(void)
{
    size_t size = hooke_size_of(HOOKE_PRECISION_F32, 2, 1, 1);
    void *memory = aligned_alloc(64, (size + 63) / 64 * 64);
    hooke_world *world = NULL;
    uint32_t number = 7;
    double position[6];
    double value = 0.0;
    uint64_t before = 0;
    uint64_t after = 1;
    EXPECT_OK(hooke_create(memory, size, HOOKE_PRECISION_F32, 2, 1, 1, &world));
    EXPECT_CODE(hooke_add_particle(world, NAN, 0, 0, 0, 0, 0, 1, HOOKE_HOLD_FREE, NULL), HOOKE_CODE_NOT_FINITE);
    /* Past what single precision holds. */
    EXPECT_CODE(hooke_add_particle(world, 1e39, 0, 0, 0, 0, 0, 1, HOOKE_HOLD_FREE, NULL), HOOKE_CODE_NOT_FINITE);
    EXPECT_CODE(hooke_add_particle(world, 0, 0, 0, 0, 0, 0, 0, HOOKE_HOLD_FREE, &number), HOOKE_CODE_MASS);
    EXPECT(number == UINT32_MAX);
    EXPECT_CODE(hooke_add_particle(world, 0, 0, 0, 0, 0, 0, 1, 9, NULL), HOOKE_CODE_NO_SUCH_OPTION);
    EXPECT_OK(hooke_add_particle(world, 0, 0, 1, 0, 0, 0, 1, HOOKE_HOLD_PINNED, &number));
    EXPECT(number == 0);
    EXPECT_OK(hooke_add_particle(world, 0, 0, 0, 0, 0, 0, 1, HOOKE_HOLD_FREE, &number));
    EXPECT(number == 1);
    EXPECT_CODE(hooke_add_particle(world, 0, 0, 0, 0, 0, 0, 1, HOOKE_HOLD_FREE, NULL), HOOKE_CODE_FULL);
    EXPECT_CODE(hooke_add_spring(world, 0, 0, 1, 0, 1, NULL), HOOKE_CODE_SAME_PARTICLE);
    EXPECT_CODE(hooke_add_spring(world, 0, 2, 1, 0, 1, NULL), HOOKE_CODE_NO_SUCH_PARTICLE);
    EXPECT(hooke_culprit(world) == 2);
    EXPECT_CODE(hooke_add_spring(world, 0, 1, -1, 0, 1, NULL), HOOKE_CODE_STIFFNESS);
    EXPECT_CODE(hooke_add_spring(world, 0, 1, 1, NAN, 1, NULL), HOOKE_CODE_DAMPING);
    EXPECT_CODE(hooke_add_spring(world, 0, 1, 1, 0, INFINITY, NULL), HOOKE_CODE_REST_LENGTH);
    EXPECT_OK(hooke_add_spring(world, 0, 1, 100, 0, 0.9, &number));
    EXPECT(number == 0);
    EXPECT_CODE(hooke_add_spring(world, 0, 1, 1, 0, 1, NULL), HOOKE_CODE_FULL);
    EXPECT_CODE(hooke_add_plane(world, 0, 0, 0, 0, 0, 0, 1, NULL), HOOKE_CODE_NORMAL);
    EXPECT_CODE(hooke_add_plane(world, 0, 0, 0, 0, 0, 1, 1.1, NULL), HOOKE_CODE_RESTITUTION);
    EXPECT_OK(hooke_add_plane(world, 0, 0, -1, 0, 0, 1, 0.5, NULL));
    EXPECT_CODE(hooke_add_plane(world, 0, 0, -1, 0, 0, 1, 0.5, NULL), HOOKE_CODE_FULL);
    EXPECT_OK(hooke_digest(world, &before));
    EXPECT_CODE(hooke_set_position(world, 2, 0, 0, 0), HOOKE_CODE_NO_SUCH_PARTICLE);
    EXPECT_CODE(hooke_set_velocity(world, 1, 0, NAN, 0), HOOKE_CODE_NOT_FINITE);
    EXPECT_CODE(hooke_set_gravity(world, 0, 0, INFINITY), HOOKE_CODE_NOT_FINITE);
    EXPECT_CODE(hooke_set_hold(world, 5, HOOKE_HOLD_FREE), HOOKE_CODE_NO_SUCH_PARTICLE);
    EXPECT_CODE(hooke_set_hold(world, 1, 3), HOOKE_CODE_NO_SUCH_OPTION);
    EXPECT_CODE(hooke_drive(world, 9, 0, 0, 0, 0, 0, 0), HOOKE_CODE_NO_SUCH_PARTICLE);
    EXPECT_CODE(hooke_set_spring(world, 1, 1, 1, 1), HOOKE_CODE_NO_SUCH_SPRING);
    EXPECT_CODE(hooke_set_spring(world, 0, 1, 1, -1), HOOKE_CODE_REST_LENGTH);
    EXPECT_CODE(hooke_scale_springs(world, -1, 1), HOOKE_CODE_STIFFNESS);
    EXPECT_CODE(hooke_set_springs(world, 2, NULL, NULL, NULL), HOOKE_CODE_LENGTH);
    value = -1.0;
    EXPECT_CODE(hooke_set_springs(world, 1, NULL, &value, NULL), HOOKE_CODE_DAMPING);
    EXPECT(hooke_culprit(world) == 0);
    EXPECT_OK(hooke_spring(world, 0, NULL, &value, NULL));
    EXPECT(value == 0.0);
    EXPECT_CODE(hooke_set_restitution(world, 1, 0.5), HOOKE_CODE_NO_SUCH_PLANE);
    EXPECT_CODE(hooke_set_stepper(world, 12, 1e-6), HOOKE_CODE_NO_SUCH_OPTION);
    EXPECT_CODE(hooke_set_stepper(world, HOOKE_STEPPER_RK4, 0.0), HOOKE_CODE_TOLERANCE);
    EXPECT_CODE(hooke_set_collision(world, 3), HOOKE_CODE_NO_SUCH_OPTION);
    EXPECT_CODE(hooke_step(world, 0.0, 1, NULL), HOOKE_CODE_TIME_STEP);
    EXPECT_CODE(hooke_step(world, NAN, 1, NULL), HOOKE_CODE_TIME_STEP);
    EXPECT_CODE(hooke_read(world, position, NULL, 5), HOOKE_CODE_LENGTH);
    EXPECT_CODE(hooke_stable_step(world, HOOKE_STEPPER_RK4, NULL), HOOKE_CODE_NULL_POINTER);
    EXPECT_CODE(hooke_spring(world, 4, &value, NULL, NULL), HOOKE_CODE_NO_SUCH_SPRING);
    EXPECT_OK(hooke_digest(world, &after));
    EXPECT(before == after);
    /* There is no workspace: what needs one says so, and what needs none steps. */
    EXPECT_OK(hooke_set_stepper(world, HOOKE_STEPPER_RK4, 1e-6));
    EXPECT_CODE(hooke_step(world, 1e-3, 1, NULL), HOOKE_CODE_WORKSPACE);
    EXPECT_OK(hooke_digest(world, &after));
    EXPECT(before == after);
    EXPECT_OK(hooke_set_stepper(world, HOOKE_STEPPER_SEMI_IMPLICIT_EULER, 1e-6));
    EXPECT_OK(hooke_step(world, 1e-3, 1, NULL));
    EXPECT_OK(hooke_digest(world, &after));
    EXPECT(before != after);
    EXPECT(strlen(hooke_message(-5)) > 0);
    EXPECT_OK(hooke_destroy(world));
    free(memory);
}

/* Where a snapshot has three doubles of gravity and five of a ledger: behind eight letters, eight words, and two doubles. */
enum { GRAVITY = 56, DOUBLES = 8 };

/* A snapshot of which one number is past what the world holds is refused as a whole. */
static void restoring(void)
{
    size_t size = hooke_size_of(HOOKE_PRECISION_F32, 1, 0, 0);
    void *memory = aligned_alloc(64, (size + 63) / 64 * 64);
    hooke_world *world = NULL;
    EXPECT_OK(hooke_create(memory, size, HOOKE_PRECISION_F32, 1, 0, 0, &world));
    EXPECT_OK(hooke_add_particle(world, 0, 0, 1, 0, 0, 0, 1, HOOKE_HOLD_FREE, NULL));
    EXPECT_OK(hooke_set_gravity(world, 0, 0, -8));
    EXPECT_OK(hooke_open_ledger(world));
    size_t length = hooke_snapshot_size(world);
    uint8_t *kept = (uint8_t *)malloc(length);
    uint8_t *before = (uint8_t *)malloc(length);
    uint8_t *after = (uint8_t *)malloc(length);
    EXPECT_OK(hooke_snapshot(world, kept, length));
    double gravity = 0.0;
    memcpy(&gravity, kept + GRAVITY + 2 * sizeof gravity, sizeof gravity);
    EXPECT(gravity == -8.0);
    /* Elsewhere, so that what is half put back shows. */
    EXPECT_OK(hooke_step(world, 0.5, 3, NULL));
    EXPECT_OK(hooke_snapshot(world, before, length));
    EXPECT(memcmp(before, kept, length) != 0);
    for (size_t place = 0; place < DOUBLES; place++) {
        /* Single precision ends at 3.4e38; what a ledger has come to is in doubles, and takes any finite one. */
        const double wrong[] = { NAN, INFINITY, 1e300 };
        for (size_t each = 0; each < (place < 3 ? 3 : 2); each++) {
            uint8_t *number = kept + GRAVITY + place * sizeof *wrong;
            uint8_t right[sizeof *wrong];
            memcpy(right, number, sizeof right);
            memcpy(number, &wrong[each], sizeof right);
            EXPECT_CODE(hooke_restore(world, kept, length), HOOKE_CODE_SNAPSHOT);
            EXPECT_OK(hooke_snapshot(world, after, length));
            EXPECT(memcmp(before, after, length) == 0);
            memcpy(number, right, sizeof right);
        }
    }
    EXPECT_OK(hooke_restore(world, kept, length));
    EXPECT_OK(hooke_snapshot(world, after, length));
    EXPECT(memcmp(kept, after, length) == 0);
    EXPECT_OK(hooke_destroy(world));
    free(kept);
    free(before);
    free(after);
    free(memory);
}

int main(void)
{
    memory_and_pointers();
    numbers();
    restoring();
    return conclude("errors");
}
