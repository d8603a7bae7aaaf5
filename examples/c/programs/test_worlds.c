/* Worlds in memory of just the size that is said: every stepper, both precisions, snapshots; and the digests of the
 * cloth that this program also writes as a scene, for the desktop to run. */

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../hooke.h"
#include "check.h"

enum { SIDE = 8, PARTICLES = SIDE * SIDE + 3, SPRINGS = 4 * SIDE * SIDE, PLANES = 1 };

static const char *const NAMES[] = {
    "explicit-euler", "semi-implicit-euler", "implicit-euler", "implicit-euler-linearised", "velocity-verlet", "rk4",
    "blanes-moan-s6", "dop853", "dormand-prince-rkn8", "implicit-midpoint", "tr-bdf2", "auto",
};
static const char *const FORMS[] = { "reflect", "project", "time-of-impact" };

typedef struct {
    double position[3 * PARTICLES];
    double mass[PARTICLES];
    uint32_t hold[PARTICLES];
    uint32_t between[2 * SPRINGS];
    double stiffness[SPRINGS];
    double damping[SPRINGS];
    double rest_length[SPRINGS];
    uint32_t springs;
} model;

static void join(model *cloth, uint32_t first, uint32_t second, double damping)
{
    const double *a = cloth->position + 3 * first;
    const double *b = cloth->position + 3 * second;
    double length = sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
    uint32_t s = cloth->springs++;
    cloth->between[2 * s] = first;
    cloth->between[2 * s + 1] = second;
    cloth->stiffness[s] = 50.0;
    cloth->damping[s] = damping;
    cloth->rest_length[s] = length;
}

static void make(model *cloth, double damping)
{
    memset(cloth, 0, sizeof *cloth);
    for (uint32_t i = 0; i < PARTICLES; i++) {
        int is_ball = i >= SIDE * SIDE;
        cloth->position[3 * i] = is_ball ? 3.0 + 0.25 * i : 0.125 * (i % SIDE);
        cloth->position[3 * i + 1] = is_ball ? 0.0 : 0.125 * (i / SIDE);
        cloth->position[3 * i + 2] = 0.5;
        cloth->mass[i] = 0.02;
        cloth->hold[i] = i == 0 ? HOOKE_HOLD_PINNED : HOOKE_HOLD_FREE;
    }
    for (uint32_t v = 0; v < SIDE; v++) {
        for (uint32_t u = 0; u < SIDE; u++) {
            uint32_t i = v * SIDE + u;
            if (u + 1 < SIDE) {
                join(cloth, i, i + 1, damping);
            }
            if (v + 1 < SIDE) {
                join(cloth, i, i + SIDE, damping);
            }
            if (u + 1 < SIDE && v + 1 < SIDE) {
                join(cloth, i, i + SIDE + 1, damping);
            }
        }
    }
}

/* The scene file of the same world, for `hooke run`. */
static void write_scene(const model *cloth, const char *file, const char *precision, uint32_t stepper, uint32_t form,
                        double dt, uint32_t steps)
{
    FILE *out = fopen(file, "w");
    if (out == NULL) {
        perror(file);
        exit(EXIT_FAILURE);
    }
    fprintf(out, "precision = \"%s\"\nstepper = \"%s\"\ncollision = \"%s\"\n", precision, NAMES[stepper], FORMS[form]);
    fprintf(out, "time_step = %.17g\nduration = %.17g\ngravity = [0.0, 0.0, -9.81]\ntolerance = 1e-6\n", dt, dt * steps);
    for (uint32_t i = 0; i < PARTICLES; i++) {
        const double *x = cloth->position + 3 * i;
        fprintf(out, "[[particle]]\nposition = [%.17g, %.17g, %.17g]\nmass = %.17g\n", x[0], x[1], x[2], cloth->mass[i]);
        fprintf(out, cloth->hold[i] == HOOKE_HOLD_PINNED ? "pinned = true\n" : "");
    }
    for (uint32_t s = 0; s < cloth->springs; s++) {
        fprintf(out, "[[spring]]\nbetween = [%" PRIu32 ", %" PRIu32 "]\nstiffness = %.17g\n", cloth->between[2 * s],
                cloth->between[2 * s + 1], cloth->stiffness[s]);
        fprintf(out, "damping = %.17g\nrest_length = %.17g\n", cloth->damping[s], cloth->rest_length[s]);
    }
    fputs("[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.25, 1.0]\nrestitution = 0.5\n", out);
    fclose(out);
}

static hooke_world *create(const model *cloth, uint32_t precision, uint32_t stepper, uint32_t form, void **memory)
{
    size_t size = hooke_size_of(precision, PARTICLES, cloth->springs, PLANES)
        + hooke_workspace_size(precision, stepper, form, PARTICLES, cloth->springs, PLANES, 16 * cloth->springs);
    hooke_world *world = NULL;
    *memory = aligned_alloc(16, (size + 15) / 16 * 16);
    EXPECT_OK(hooke_create(*memory, size, precision, PARTICLES, cloth->springs, PLANES, &world));
    EXPECT_OK(hooke_add_particles(world, PARTICLES, cloth->position, NULL, cloth->mass, cloth->hold));
    EXPECT_OK(hooke_add_springs(world, cloth->springs, cloth->between, cloth->stiffness, cloth->damping,
                                cloth->rest_length));
    EXPECT_OK(hooke_add_plane(world, 0, 0, 0, 0, 0.25, 1, 0.5, NULL));
    EXPECT_OK(hooke_set_gravity(world, 0, 0, -9.81));
    EXPECT_OK(hooke_set_stepper(world, stepper, 1e-6));
    EXPECT_OK(hooke_set_collision(world, form));
    return world;
}

static uint64_t digest(hooke_world *world)
{
    uint64_t told = 0;
    EXPECT_OK(hooke_digest(world, &told));
    return told;
}

/* Snapshots go on to the same bits, in the world they were taken of and in another one. */
static void keep(const model *cloth, hooke_world *world, uint32_t precision, uint32_t stepper, uint32_t form, double dt)
{
    size_t size = hooke_snapshot_size(world);
    uint8_t *bytes = (uint8_t *)malloc(size);
    void *memory = NULL;
    hooke_world *other = create(cloth, precision, stepper, form, &memory);
    uint32_t chosen[3] = { 99, 99, 99 };
    double tolerance = 0.0;
    EXPECT_OK(hooke_open_ledger(world));
    EXPECT_OK(hooke_set_stepper(other, HOOKE_STEPPER_EXPLICIT_EULER, 1e-3));
    EXPECT_OK(hooke_set_collision(other, (form + 1) % 3));
    EXPECT_OK(hooke_choices(other, NULL, NULL, NULL, &chosen[2]));
    EXPECT(chosen[2] == 0);
    EXPECT_CODE(hooke_snapshot(world, bytes, size - 1), HOOKE_CODE_LENGTH);
    EXPECT_OK(hooke_snapshot(world, bytes, size));
    uint64_t kept = digest(world);
    EXPECT_OK(hooke_step(world, dt, 100, NULL));
    uint64_t later = digest(world);
    EXPECT(later != kept);
    EXPECT_CODE(hooke_restore(other, bytes, size - 1), HOOKE_CODE_SNAPSHOT);
    EXPECT_OK(hooke_restore(other, bytes, size));
    EXPECT_OK(hooke_choices(other, &chosen[0], &tolerance, &chosen[1], &chosen[2]));
    EXPECT(chosen[0] == stepper && tolerance == 1e-6 && chosen[1] == form && chosen[2] == 1);
    EXPECT(digest(other) == kept);
    EXPECT_OK(hooke_step(other, dt, 100, NULL));
    EXPECT(digest(other) == later);
    EXPECT(hooke_time(other) == hooke_time(world));
    EXPECT_OK(hooke_restore(world, bytes, size));
    EXPECT(digest(world) == kept);
    free(bytes);
    free(memory);
}

/* Parameters by number: those of a world that is made with them. */
static void change(void)
{
    static model cloth;
    static model other;
    static double doubled[SPRINGS];
    void *memory[2] = { NULL, NULL };
    make(&cloth, 0.01);
    make(&other, 0.01);
    for (uint32_t s = 0; s < other.springs; s++) {
        other.stiffness[s] = 40.0 + 0.25 * s;
        other.rest_length[s] *= 1.0 + 0.001 * s;
        doubled[s] = 2.0 * other.stiffness[s];
    }
    hooke_world *changed = create(&cloth, HOOKE_PRECISION_F32, HOOKE_STEPPER_VELOCITY_VERLET, 0, &memory[0]);
    hooke_world *made = create(&other, HOOKE_PRECISION_F32, HOOKE_STEPPER_VELOCITY_VERLET, 0, &memory[1]);
    EXPECT_OK(hooke_set_springs(changed, cloth.springs, other.stiffness, NULL, other.rest_length));
    EXPECT_OK(hooke_step(changed, 1e-3, 50, NULL));
    EXPECT_OK(hooke_step(made, 1e-3, 50, NULL));
    EXPECT(digest(changed) == digest(made));
    /* Where one is wrong none is changed, and it is named. */
    doubled[7] = INFINITY;
    EXPECT_CODE(hooke_set_springs(changed, cloth.springs, doubled, NULL, NULL), HOOKE_CODE_STIFFNESS);
    EXPECT(hooke_culprit(changed) == 7);
    EXPECT_OK(hooke_step(changed, 1e-3, 50, NULL));
    EXPECT_OK(hooke_step(made, 1e-3, 50, NULL));
    EXPECT(digest(changed) == digest(made));
    /* Factors are of what there is now. */
    doubled[7] = 2.0 * other.stiffness[7];
    EXPECT_OK(hooke_set_springs(changed, cloth.springs, doubled, NULL, NULL));
    EXPECT_OK(hooke_step(changed, 1e-3, 50, NULL));
    EXPECT_OK(hooke_scale_springs(made, 4.0, 1.0));
    EXPECT_OK(hooke_scale_springs(made, 0.5, 1.0));
    EXPECT_OK(hooke_step(made, 1e-3, 50, NULL));
    EXPECT(digest(changed) == digest(made));
    free(memory[0]);
    free(memory[1]);
}

int main(int count, char **arguments)
{
    static model cloth;
    const double dt = 0.0009765625; /* 2^-10 s, so that the desktop counts just so many steps */
    const uint32_t steps = 500;
    for (uint32_t stepper = 0; stepper < 12; stepper++) {
        make(&cloth, stepper == HOOKE_STEPPER_DORMAND_PRINCE_RKN8 ? 0.0 : 0.01);
        for (uint32_t precision = 0; precision < 2; precision++) {
            /* A form of collision each, so that all of them are met with both. */
            uint32_t form = (stepper + precision) % 3;
            const char *name = precision == HOOKE_PRECISION_F32 ? "f32" : "f64";
            void *memory = NULL;
            hooke_world *world = create(&cloth, precision, stepper, form, &memory);
            hooke_report report;
            EXPECT_OK(hooke_step(world, dt, steps, &report));
            EXPECT(report.steps == steps && report.converged == 1 && report.without_factor == 0);
            EXPECT(report.hits > 0);
            EXPECT(fabs(report.time - dt * steps) < 1e-12);
            if (count > 1) {
                char file[4096];
                snprintf(file, sizeof file, "%s/%s-%s.toml", arguments[1], NAMES[stepper], name);
                write_scene(&cloth, file, name, stepper, form, dt, steps);
                printf("digest %s-%s %016" PRIx64 "\n", NAMES[stepper], name, digest(world));
            }
            keep(&cloth, world, precision, stepper, form, dt);
            EXPECT_OK(hooke_destroy(world));
            free(memory);
        }
    }
    change();
    return conclude("worlds");
}
