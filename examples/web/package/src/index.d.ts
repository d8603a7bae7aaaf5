/** SI units everywhere: m, s, kg, N/m, N·s/m, J. */
export type Vector = readonly [number, number, number];

export type StepperName =
  | "explicit-euler" | "semi-implicit-euler" | "implicit-euler" | "implicit-euler-linearised" | "velocity-verlet"
  | "rk4" | "blanes-moan-s6" | "dop853" | "dormand-prince-rkn8" | "implicit-midpoint" | "tr-bdf2" | "auto";
export type CollisionForm = "reflect" | "project" | "time-of-impact";
export type Hold = "free" | "pinned" | "kinematic";

/** Fetches the module and makes it ready. */
export function load(options?: {
  /** Where the module is; beside this package if left out. */
  url?: string | URL;
  /** The module itself. */
  bytes?: BufferSource;
  /** Whether to load the build with 128-bit vectors; left out: if the machine has them. The bits are the same. */
  simd?: boolean;
}): Promise<Hooke>;

/** A module that has been loaded. All its worlds share one memory. */
export class Hooke {
  private constructor();
  /**
   * A world of what a model has, or an empty one with room for so much. It steps with `auto`, `time-of-impact`, a
   * tolerance of 1e-6 and a time step of 1 ms.
   */
  world(model: Model | Capacity): World;
  readonly simd: boolean;
}

export interface Capacity {
  particles: number;
  springs?: number;
  planes?: number;
}

export interface Particle {
  position: Vector;
  /** Default 0. */
  velocity?: Vector;
  /** Default 1 kg. */
  mass?: number;
  pinned?: boolean;
}

export interface Spring {
  between: readonly [number, number];
  stiffness: number;
  /** Default 0. */
  damping?: number;
  /** Default: the distance at the start. */
  restLength?: number;
}

export interface Plane {
  point: Vector;
  /** Of any length; particles live on the side that it points to. */
  normal: Vector;
  /** From 0 to 1, the default. */
  restitution?: number;
}

type Reals = ArrayLike<number> & { slice(start?: number, end?: number): ArrayLike<number> };
type Words = ArrayLike<number> & { slice(start?: number, end?: number): ArrayLike<number> };

/** Particles in arrays, by number. */
export interface FlatParticles {
  /** Three a particle. */
  position: Reals;
  /** Three a particle. */
  velocity?: Reals;
  mass?: Reals;
  /** -1 free, -2 pinned, 0 or more (the number of a track) kinematic. */
  hold?: Words;
}

/** Springs in arrays, by number. */
export interface FlatSprings {
  /** Two a spring. */
  between: Words;
  stiffness: Reals;
  damping?: Reals;
  restLength?: Reals;
}

export interface Model {
  gravity?: Vector;
  particles: readonly Particle[] | FlatParticles;
  springs?: readonly Spring[] | FlatSprings;
  planes?: readonly Plane[];
}

/** What happened in some steps. */
export interface Report {
  /** The time after them, s. */
  time: number;
  steps: number;
  /** Whether every equation was solved to the tolerance; true for explicit steppers. */
  converged: boolean;
  /** Of Newton's method. */
  iterations: number;
  linearIterations: number;
  factorisations: number;
  /** The largest remaining residual, relative to the size of its terms. */
  residual: number;
  forceEvaluations: number;
  /** Bounces on planes. */
  hits: number;
  /** Particles with too many hits to follow one by one. */
  capped: number;
  /** Springs of length 0, which exert no force. */
  degenerateSprings: number;
}

/** Where the energy is, and where it went, J. */
export interface Energy {
  kinetic: number;
  elastic: number;
  gravitational: number;
  /** Of those three. */
  total: number;
  lostToDamping: number;
  lostInImpacts: number;
  workOfPins: number;
  /** The total when the ledger was opened. */
  openedWith: number;
  /**
   * What the stepper itself has added or lost: 0 for the exact solution. Whatever is changed from outside counts into it, until
   * the ledger is opened anew.
   */
  remainder: number;
}

export class World {
  private constructor();
  /** All of these can be set at any time. */
  stepper: StepperName;
  collision: CollisionForm;
  /** s */
  timeStep: number;
  /** The residual at which an implicit step counts as solved, relative to the size of its terms. */
  tolerance: number;
  readonly particles: number;
  readonly springs: number;
  readonly planes: number;
  /** s */
  readonly time: number;
  /**
   * Views of the module's memory, three numbers a particle, by number, fit for a BufferAttribute. They are refreshed by
   * whatever changes them. When the memory grows, which a new world, another stepper, a snapshot, or a change of all
   * springs may make it do, they are made anew: get them again after that.
   */
  readonly positions: Float32Array;
  readonly velocities: Float32Array;
  /** Between the last two steps, after `advance`; the positions, after anything else. */
  readonly interpolated: Float32Array;

  addParticle(particle: Particle): number;
  addSpring(spring: Spring): number;
  addPlane(plane: Plane): number;

  /** Takes steps of `timeStep`. A step that cannot be taken throws, and leaves the state as it was before it. */
  step(count?: number): Report;
  /** Takes as many steps as are due after another so many seconds, no more than `maxSteps`; what is past those is dropped. */
  advance(seconds: number, maxSteps?: number): Report;

  /** m/s² */
  setGravity(gravity: Vector): void;
  setPosition(particle: number, position: Vector): void;
  /** A pinned particle becomes kinematic by it. */
  setVelocity(particle: number, velocity: Vector): void;
  setHold(particle: number, hold: Hold): void;
  /** Puts a particle where it should be; it moves on with that velocity, whatever pulls at it, until its hold is set. */
  drive(particle: number, position: Vector, velocity: Vector): void;
  spring(spring: number): { stiffness: number; damping: number; restLength: number };
  setSpring(spring: number, changes: { stiffness?: number; damping?: number; restLength?: number }): void;
  /**
   * Gives all springs other parameters at once, by number; what is left out stays. It takes about as long as one `setSpring`.
   * Where one is refused none is changed.
   */
  setSprings(columns: { stiffness?: ArrayLike<number>; damping?: ArrayLike<number>; restLength?: ArrayLike<number> }): void;
  /**
   * Makes the stiffness and the damping of all springs so many times what they were given when they were added, or by
   * `setSpring` and `setSprings` since: the factors of an earlier call do not count. What is left out stays.
   */
  scaleSprings(factors: { stiffness?: number; damping?: number }): void;
  setRestitution(plane: number | "all", restitution: number): void;

  /** Opens the energy ledger, or opens it anew: it is followed through every step, which costs time. */
  openLedger(): void;
  /** What the ledger says; the first call opens it. */
  energy(): Energy;
  /** The longest time step (s) at which a stepper is stable in the present state; infinite where nothing limits it. */
  stableStep(stepper?: StepperName): number;

  /** All that it takes to go on from here, to the bit. */
  snapshot(): Uint8Array;
  /**
   * Puts a snapshot back: of a world with the same particles, springs and planes. Stepper, form of collision, tolerance and
   * energy ledger are those of the snapshot then; the time step stays.
   */
  restore(bytes: Uint8Array): void;
  /** One number for all positions and velocities: 16 hexadecimal digits, the same on every machine. */
  digest(): string;
  /** Gives its memory back; after that it throws. */
  free(): void;
}

/** What is wrong, by name, and whose. */
export class HookeError extends Error {
  readonly code: string;
  readonly particle?: number;
  readonly spring?: number;
  readonly plane?: number;
}
