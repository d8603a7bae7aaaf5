/* Without the standard library: whoever calls while a call is under way is told so, and disturbs nothing. A timer's signal
 * stands for the interrupt of a microcontroller. */

#define _XOPEN_SOURCE 700

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/time.h>

#include "../hooke.h"
#include "check.h"

enum { BALLS = 64, STEPS = 2000, ROUNDS = 1000, ENOUGH = 20 };

static hooke_world *world;
/* How often the signal came during a call, and what was not as it should be then. */
static volatile sig_atomic_t met;
static volatile sig_atomic_t missed;

static size_t workspace(void)
{
    return hooke_workspace_size(HOOKE_PRECISION_F32, HOOKE_STEPPER_RK4, HOOKE_COLLISION_REFLECT, BALLS, 0, 0, 0);
}

static void interrupt(int signal_number)
{
    (void)signal_number;
    if (!isnan(hooke_time(world))) {
        return; /* between two calls */
    }
    met++;
    missed += workspace() != 0;
    missed += hooke_culprit(world) != UINT32_MAX;
    missed += hooke_step(world, 1e-3, 1, NULL) != HOOKE_CODE_BUSY;
    missed += hooke_destroy(world) != HOOKE_CODE_BUSY;
}

static void *create(hooke_world **made)
{
    size_t size = hooke_size_of(HOOKE_PRECISION_F32, BALLS, 0, 0) + workspace();
    void *memory = aligned_alloc(64, (size + 63) / 64 * 64);
    EXPECT_OK(hooke_create(memory, size, HOOKE_PRECISION_F32, BALLS, 0, 0, made));
    for (int ball = 0; ball < BALLS; ball++) {
        EXPECT_OK(hooke_add_particle(*made, ball, 0, 0, 1, 0, 0, 1, HOOKE_HOLD_FREE, NULL));
    }
    EXPECT_OK(hooke_set_gravity(*made, 0, 0, -8));
    EXPECT_OK(hooke_set_stepper(*made, HOOKE_STEPPER_RK4, 1e-6));
    /* An error that is about somebody. */
    EXPECT_CODE(hooke_set_position(*made, BALLS, 0, 0, 0), HOOKE_CODE_NO_SUCH_PARTICLE);
    return memory;
}

int main(void)
{
    hooke_world *other = NULL;
    void *memory[2] = { create(&world), create(&other) };
    struct sigaction action = { .sa_handler = interrupt };
    const struct itimerval often = { { 0, 1000 }, { 0, 1000 } };
    const struct itimerval never = { { 0, 0 }, { 0, 0 } };
    uint64_t told[2] = { 0, 1 };
    int rounds = 0;
    sigemptyset(&action.sa_mask);
    EXPECT(sigaction(SIGALRM, &action, NULL) == 0);
    EXPECT(setitimer(ITIMER_REAL, &often, NULL) == 0);
    while (met < ENOUGH && rounds < ROUNDS) {
        EXPECT_OK(hooke_step(world, 0x1p-20, STEPS, NULL));
        rounds++;
    }
    EXPECT(setitimer(ITIMER_REAL, &never, NULL) == 0);
    EXPECT(met >= ENOUGH);
    EXPECT(missed == 0);
    /* And between calls all is as it ever was. */
    EXPECT(workspace() > 0);
    EXPECT(hooke_culprit(world) == BALLS);
    for (int round = 0; round < rounds; round++) {
        EXPECT_OK(hooke_step(other, 0x1p-20, STEPS, NULL));
    }
    EXPECT_OK(hooke_digest(world, &told[0]));
    EXPECT_OK(hooke_digest(other, &told[1]));
    EXPECT(told[0] == told[1]);
    EXPECT_OK(hooke_destroy(world));
    free(memory[0]);
    free(memory[1]);
    return conclude("interrupts");
}
