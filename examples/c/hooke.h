/*
 * Hooke: particles joined by springs, stepped in memory that the caller supplies. Nothing is allocated.
 *
 * Units are SI everywhere: m, s, kg, N/m, N s/m, J. Numbers are doubles here, and rounded to the precision of the world.
 *
 * Every function that returns a hooke_code leaves what it was to change as it was, unless it returns
 * HOOKE_CODE_OK or says otherwise. Null and misaligned pointers, numbers out of range and things that do not exist are
 * such errors. What no function can find out is up to the caller:
 *   - memory handed over is as large as is said, and nobody else's until hooke_destroy, or until another workspace;
 *   - a hooke_world is one that hooke_create made, in memory that has not been used for anything else since;
 *   - arrays are as long as is said, and none of them lies in the memory of a world;
 *   - a world is used by one thread at a time. Different worlds may be used by different threads if the library was
 *     built with the feature `std`; without it a call made while another is under way returns HOOKE_CODE_BUSY.
 * A program that is built without `std` supplies abort().
 *
 * Enumerations are passed as uint32_t. This file is generated from the library's source, which a test compares it with.
 */

#ifndef HOOKE_H
#define HOOKE_H

#include <stddef.h>
#include <stdint.h>

// What the memory of a world must be a multiple of, bytes.
#define HOOKE_ALIGNMENT 16

// Where there is no particle, spring or plane to name.
#define HOOKE_NOBODY UINT32_MAX

// What a call came to. After any but `OK` what the call was to change is as it was.
enum hooke_code
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // Done.
  HOOKE_CODE_OK = 0,
  // A pointer is null that must not be.
  HOOKE_CODE_NULL_POINTER = 1,
  // A pointer is not a multiple of what it must be.
  HOOKE_CODE_MISALIGNED = 2,
  // The memory is too small: `hooke_size_of` tells how much is needed.
  HOOKE_CODE_TOO_SMALL = 3,
  // There is no world at this address: `hooke_create` makes one.
  HOOKE_CODE_NOT_A_WORLD = 4,
  // An enumeration has no such number, or this build of the library is without it.
  HOOKE_CODE_NO_SUCH_OPTION = 5,
  // The world has no room for another: its capacity was set when it was created.
  HOOKE_CODE_FULL = 6,
  // There is no particle of this number.
  HOOKE_CODE_NO_SUCH_PARTICLE = 7,
  // There is no spring of this number.
  HOOKE_CODE_NO_SUCH_SPRING = 8,
  // There is no plane of this number.
  HOOKE_CODE_NO_SUCH_PLANE = 9,
  // Both ends of the spring are the same particle.
  HOOKE_CODE_SAME_PARTICLE = 10,
  // The mass, or its inverse, is not positive and finite.
  HOOKE_CODE_MASS = 11,
  // A coordinate, a velocity, a gravity or a time is infinite or NaN, or becomes so in the world's precision.
  HOOKE_CODE_NOT_FINITE = 12,
  // The stiffness is not finite and 0 or more.
  HOOKE_CODE_STIFFNESS = 13,
  // The damping is not finite and 0 or more.
  HOOKE_CODE_DAMPING = 14,
  // The rest length is not finite and 0 or more.
  HOOKE_CODE_REST_LENGTH = 15,
  // The normal is 0 or not finite.
  HOOKE_CODE_NORMAL = 16,
  // The restitution is outside 0 to 1.
  HOOKE_CODE_RESTITUTION = 17,
  // The time step is not positive and finite, or too short for the time to change.
  HOOKE_CODE_TIME_STEP = 18,
  // The tolerance is not positive and finite.
  HOOKE_CODE_TOLERANCE = 19,
  // The stepper is for worlds without damping.
  HOOKE_CODE_DAMPED = 20,
  // The workspace is too small for the stepper: `hooke_set_workspace` gives it a larger one.
  HOOKE_CODE_WORKSPACE = 21,
  // The step would have made a position or a velocity infinite or NaN; a shorter one, or another stepper, may not.
  HOOKE_CODE_NON_FINITE = 22,
  // An array is not as long as it must be.
  HOOKE_CODE_LENGTH = 23,
  // The bytes are no snapshot, or that of a world with other particles, springs or planes.
  HOOKE_CODE_SNAPSHOT = 24,
  // Another call is under way: without the feature `std` there can be only one at a time.
  HOOKE_CODE_BUSY = 25,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum hooke_code hooke_code;
#else
typedef int32_t hooke_code;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What a world's numbers are.
enum hooke_precision
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // 32 bits.
  HOOKE_PRECISION_F32 = 0,
  // 64 bits.
  HOOKE_PRECISION_F64 = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum hooke_precision hooke_precision;
#else
typedef uint32_t hooke_precision;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The rule that makes a step. h = w dt, where w is the highest frequency of the world.
enum hooke_stepper
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // v' = v + dt a(x, v), x' = x + dt v. First order; grows without damping.
  HOOKE_STEPPER_EXPLICIT_EULER = 0,
  // v' = v + dt a(x, v), x' = x + dt v'. First order, stable up to h = 2.
  HOOKE_STEPPER_SEMI_IMPLICIT_EULER = 1,
  // v' = v + dt a(x', v'), x' = x + dt v', solved to the tolerance. First order, stable.
  HOOKE_STEPPER_IMPLICIT_EULER = 2,
  // The same, by one linear solve. First order, stable on linear springs.
  HOOKE_STEPPER_IMPLICIT_EULER_LINEARISED = 3,
  // Second order, stable up to h = 2.
  HOOKE_STEPPER_VELOCITY_VERLET = 4,
  // The classical Runge-Kutta method. Fourth order, stable up to h = 2.6.
  HOOKE_STEPPER_RK4 = 5,
  // Blanes and Moan's splitting. Fourth order, stable up to h = 3.1.
  HOOKE_STEPPER_BLANES_MOAN_S6 = 6,
  // Dormand and Prince's Runge-Kutta method. Eighth order, stable up to h = 5.9.
  HOOKE_STEPPER_DOP853 = 7,
  // Their Nystroem method. Eighth order, stable up to h = 3.1; refuses springs with damping.
  HOOKE_STEPPER_DORMAND_PRINCE_RKN8 = 8,
  // Second order, stable, damps nothing; solved to the tolerance.
  HOOKE_STEPPER_IMPLICIT_MIDPOINT = 9,
  // Second order, stable, damps what is too fast; solved to the tolerance.
  HOOKE_STEPPER_TR_BDF2 = 10,
  // Free particles fly exactly; the rest by velocity Verlet, semi-implicit Euler or implicit Euler, the first of
  // them that is stable.
  HOOKE_STEPPER_AUTO = 11,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum hooke_stepper hooke_stepper;
#else
typedef uint32_t hooke_stepper;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What happens when a step takes particles through planes.
enum hooke_collision
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // The velocity is turned round after the step.
  HOOKE_COLLISION_REFLECT = 0,
  // The same, and the particle is put back on the plane.
  HOOKE_COLLISION_PROJECT = 1,
  // The hit is found inside the step, and the rest of the step is taken from there.
  HOOKE_COLLISION_TIME_OF_IMPACT = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum hooke_collision hooke_collision;
#else
typedef uint32_t hooke_collision;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// How a particle is held.
enum hooke_hold
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // It moves as the forces on it say.
  HOOKE_HOLD_FREE = 0,
  // It stays where it is.
  HOOKE_HOLD_PINNED = 1,
  // It moves with the velocity that it is given.
  HOOKE_HOLD_KINEMATIC = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum hooke_hold hooke_hold;
#else
typedef uint32_t hooke_hold;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// A world, in memory of the caller's.
typedef struct hooke_world hooke_world;

// What happened in some steps.
typedef struct {
  // The time after them, s.
  double time;
  // The largest remaining residual of an implicit step, relative to the size of its terms.
  double residual;
  // Steps that were taken.
  uint32_t steps;
  // 1 if every equation was solved to the tolerance, as it always is where there are none; else 0.
  uint32_t converged;
  // Newton iterations.
  uint32_t iterations;
  // Iterations of the linear solver inside those.
  uint32_t linear_iterations;
  // Factorisations of its matrix.
  uint32_t factorisations;
  // Evaluations of all spring forces.
  uint32_t force_evaluations;
  // Bounces on planes.
  uint32_t hits;
  // Particles with too many hits to follow one by one: they were stopped until the end of their step.
  uint32_t capped;
  // Springs of length 0, which have no direction and exerted no force, in the last evaluation.
  uint32_t degenerate_springs;
  // 1 if a factor had no room in the workspace, and conjugate gradients took its place.
  uint32_t without_factor;
} hooke_report;

// Where the energy is, and where it went, J.
typedef struct {
  // The sum of m v^2 / 2.
  double kinetic;
  // The sum of k (l - l_rest)^2 / 2.
  double elastic;
  // The sum of -m g.x.
  double gravitational;
  // Since the ledger was opened.
  double lost_to_damping;
  // In all bounces since then; putting a particle back on a plane counts with them.
  double lost_in_impacts;
  // What it took since then to move kinematic particles against their springs.
  double work_of_pins;
  // The first three when it was opened.
  double opened_with;
  // What the stepper has added (positive) or lost (negative) since then: 0 for the exact solution. Whatever is changed from
  // outside counts into it, until the ledger is opened anew.
  double remainder;
} hooke_ledger;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// A code in words: a string that is always there.
const char *hooke_message(int32_t code);

// The bytes of a world of so many particles, springs and planes, without a workspace for its stepper; 0 if there is no
// such precision.
size_t hooke_size_of(uint32_t precision,
                     uint32_t particles,
                     uint32_t springs,
                     uint32_t planes);

// The bytes of the workspace that a stepper and a form of collision need in such a world; 0 if there is no such option, and
// without `std` while another call is under way.
//
// Implicit steppers, and `HOOKE_STEPPER_AUTO` where it turns to one, solve their linear systems by a factorisation where that
// is less work. A factor has blocks: as many as there are springs are enough for ropes, chains and trees, 16 times as many for a
// cloth of 64 x 64. With less room than it needs, a step is refused, unless `hooke_set_workspace` allowed doing without.
size_t hooke_workspace_size(uint32_t precision,
                            uint32_t stepper,
                            uint32_t collision,
                            uint32_t particles,
                            uint32_t springs,
                            uint32_t planes,
                            uint32_t factor_blocks);

// Makes a world in `size` bytes of memory, without anything in it, at 0 s. What `hooke_size_of` leaves of the memory is
// its workspace. It steps with `HOOKE_STEPPER_SEMI_IMPLICIT_EULER` and `HOOKE_COLLISION_REFLECT`, which need none.
hooke_code hooke_create(void *memory,
                        size_t size,
                        uint32_t precision,
                        uint32_t particles,
                        uint32_t springs,
                        uint32_t planes,
                        hooke_world **world);

// Ends a world: its memory is the caller's again.
hooke_code hooke_destroy(hooke_world *world);

// The number of the particle, spring or plane that the last error of a world was about; `UINT32_MAX` if of none, and
// without `std` while another call is under way.
uint32_t hooke_culprit(const hooke_world *world);

// Gives a world another workspace; the stepper and the collisions begin anew. `without_factor` is 1 if implicit steps
// may go on by conjugate gradients where a factor has no room, else 0.
hooke_code hooke_set_workspace(hooke_world *world,
                               void *memory,
                               size_t size,
                               uint32_t without_factor);

// Adds a particle, at a position in m, with a velocity in m/s and a mass in kg. Its number is written to `number`: 0 for
// the first, one more for each that follows. `number` may be null.
hooke_code hooke_add_particle(hooke_world *world,
                              double x,
                              double y,
                              double z,
                              double vx,
                              double vy,
                              double vz,
                              double mass,
                              uint32_t hold,
                              uint32_t *number);

// Adds `count` particles: three positions (m) and three velocities (m/s) each, a mass (kg), a hold. A null pointer in
// place of velocities is 0 for all, of masses 1 kg, of holds `HOOKE_HOLD_FREE`. After an error, those before the culprit are
// there.
hooke_code hooke_add_particles(hooke_world *world,
                               uint32_t count,
                               const double *position,
                               const double *velocity,
                               const double *mass,
                               const uint32_t *hold);

// Adds a spring between two particles, with a stiffness in N/m, a damping in N s/m and a rest length in m. Its number is
// written to `number`, which may be null.
hooke_code hooke_add_spring(hooke_world *world,
                            uint32_t first,
                            uint32_t second,
                            double stiffness,
                            double damping,
                            double rest_length,
                            uint32_t *number);

// Adds `count` springs: two particles each, a stiffness (N/m), a damping (N s/m; null: 0 for all), a rest length (m).
// After an error, those before the culprit are there.
hooke_code hooke_add_springs(hooke_world *world,
                             uint32_t count,
                             const uint32_t *between,
                             const double *stiffness,
                             const double *damping,
                             const double *rest_length);

// Adds the plane through a point (m) across a normal of any length, with a restitution from 0 to 1. Particles live on
// the side that the normal points to. Its number is written to `number`, which may be null.
hooke_code hooke_add_plane(hooke_world *world,
                           double x,
                           double y,
                           double z,
                           double normal_x,
                           double normal_y,
                           double normal_z,
                           double restitution,
                           uint32_t *number);

// How many particles, springs and planes there are. Each of the pointers may be null.
hooke_code hooke_counts(hooke_world *world, uint32_t *particles, uint32_t *springs, uint32_t *planes);

// Sets the gravitational acceleration, m/s^2.
hooke_code hooke_set_gravity(hooke_world *world, double x, double y, double z);

// Puts a particle somewhere else (m).
hooke_code hooke_set_position(hooke_world *world, uint32_t particle, double x, double y, double z);

// Gives a particle another velocity (m/s). A pinned particle becomes kinematic by it.
hooke_code hooke_set_velocity(hooke_world *world, uint32_t particle, double x, double y, double z);

// Pins a particle, lets it go, or makes it kinematic. One that is pinned loses its velocity.
hooke_code hooke_set_hold(hooke_world *world, uint32_t particle, uint32_t hold);

// Puts a particle where it should be (m) with the velocity it should have (m/s), and makes it kinematic if it was free.
// Meant for every step.
hooke_code hooke_drive(hooke_world *world,
                       uint32_t particle,
                       double x,
                       double y,
                       double z,
                       double vx,
                       double vy,
                       double vz);

// Gives a spring other parameters: N/m, N s/m, m.
hooke_code hooke_set_spring(hooke_world *world,
                            uint32_t spring,
                            double stiffness,
                            double damping,
                            double rest_length);

// What a spring's parameters are: N/m, N s/m, m. Each of the pointers may be null.
hooke_code hooke_spring(hooke_world *world,
                        uint32_t spring,
                        double *stiffness,
                        double *damping,
                        double *rest_length);

// Gives all springs other parameters, by number: N/m, N s/m, m. A null pointer leaves those as they are. `count` is how many
// springs there are. It takes about as long as one `hooke_set_spring`. An error names the first spring that is refused; none
// is changed then.
hooke_code hooke_set_springs(hooke_world *world,
                             uint32_t count,
                             const double *stiffness,
                             const double *damping,
                             const double *rest_length);

// Multiplies the stiffness and the damping of all springs, as they are now.
hooke_code hooke_scale_springs(hooke_world *world, double stiffness, double damping);

// Sets the restitution of a plane, from 0 to 1.
hooke_code hooke_set_restitution(hooke_world *world, uint32_t plane, double restitution);

// Chooses the stepper, which begins anew. Implicit ones solve to `tolerance`, relative to the size of the terms of their
// equations: 1e-6, say.
hooke_code hooke_set_stepper(hooke_world *world,
                             uint32_t stepper,
                             double tolerance);

// Chooses what happens at planes; the stepper begins anew.
hooke_code hooke_set_collision(hooke_world *world, uint32_t collision);

// Writes what has been chosen, which `hooke_restore` may have changed: the stepper, its tolerance, the form of collision, and
// 1 if a ledger is open, else 0. Each of the pointers may be null.
hooke_code hooke_choices(hooke_world *world,
                         uint32_t *stepper,
                         double *tolerance,
                         uint32_t *collision,
                         uint32_t *has_ledger);

// Takes `count` steps of `dt` seconds. After an error the state is that of the last step that could be taken; the report,
// which may be null, is of those that were.
hooke_code hooke_step(hooke_world *world,
                      double dt,
                      uint32_t count,
                      hooke_report *report);

// Writes the longest time step (s) at which a stepper is stable in the present state, as far as its springs tell:
// infinite where nothing limits it. For explicit Euler it is only an upper limit.
hooke_code hooke_stable_step(hooke_world *world,
                             uint32_t stepper,
                             double *dt);

// The time of the state, s; NaN if there is no world.
double hooke_time(hooke_world *world);

// Writes the positions (m) and the velocities (m/s) of all particles, three numbers each, in the order of their
// numbers. Either pointer may be null. `length` is that of each array: three times the particles.
hooke_code hooke_read(hooke_world *world,
                      double *position,
                      double *velocity,
                      size_t length);

// The same, to single precision.
hooke_code hooke_read_single(hooke_world *world, float *position, float *velocity, size_t length);

// Opens the energy ledger, or opens it anew: from now on it is followed through every step, which costs time.
hooke_code hooke_open_ledger(hooke_world *world);

// Writes what the ledger says; if none is open, what one would that has just been opened.
hooke_code hooke_read_ledger(hooke_world *world, hooke_ledger *ledger);

// Writes one number for all positions and velocities, bit by bit: FNV-1a over them, by particle, as 64-bit numbers. It
// is the same on every machine.
hooke_code hooke_digest(hooke_world *world,
                        uint64_t *digest);

// The bytes of a snapshot of a world; 0 if there is no world.
size_t hooke_snapshot_size(hooke_world *world);

// Writes a snapshot: all that it takes to go on from here, the same on every machine. `size` is `hooke_snapshot_size`.
// What the stepper remembers of earlier steps is forgotten, here as where the snapshot is put back: both go on to the
// same bits.
hooke_code hooke_snapshot(hooke_world *world,
                          uint8_t *bytes,
                          size_t size);

// Puts a snapshot back: of a world with the same number of particles, the same springs and planes, in the same precision.
// Stepper, tolerance, form of collision and ledger are those of the snapshot then: `hooke_choices` tells them. Other bytes are
// refused, and change nothing.
hooke_code hooke_restore(hooke_world *world,
                         const uint8_t *bytes,
                         size_t size);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* HOOKE_H */
