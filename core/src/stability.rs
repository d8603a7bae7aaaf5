//! The largest time step that keeps an explicit stepper stable, bounded particle by particle.

use crate::Real;
use crate::vectors::{at, difference, dot, exact};
use crate::world::{Incidence, Law, State, System, View};

/// How stiff and how damped a world is in its present state, and what limits its time step.
///
/// The stiffness matrix K is bounded by its diagonal blocks: for springs between particles of masses m_i and m_j,
/// K ≼ diag(Σ_j (1 + m_i/m_j) K_ij), with K_ij = k [d̂d̂ᵀ + max(0, 1 − l_rest/l)(I − d̂d̂ᵀ)], and the damping matrix C
/// likewise with k_d d̂d̂ᵀ; a held particle counts as infinitely heavy. (Each spring's block [A −A; −A A] is at most
/// diag((1+θ) A, (1+1/θ) A) for any θ > 0; here θ = m_i/m_j, which makes it exact for two bodies.) So the largest
/// eigenvalues ω² and γ = 2ζω of one particle's blocks over its mass bound those of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StabilityBound {
    /// The highest frequency, rad/s.
    pub frequency: f64,
    /// The largest time step at which [`crate::VelocityVerlet`] is stable, s: dt²ω² + 4 dt γ = 4.
    pub velocity_verlet: f64,
    /// The largest time step at which [`crate::SemiImplicitEuler`] is stable, s: dt²ω² + 2 dt γ = 4.
    pub semi_implicit_euler: f64,
    /// The largest time step at which [`crate::ExplicitEuler`] can be stable, s: the least k_d/k of any spring, and no
    /// more than 2/γ. It is 0 where a spring is not damped, and motion across springs, which nothing damps, still grows.
    pub explicit_euler: f64,
    /// γ, the fastest rate at which anything is damped, 1/s.
    pub damping_rate: f64,
    /// The particle that limits Verlet and semi-implicit Euler.
    pub particle: u32,
    /// The stiffest spring at it, over its masses.
    pub spring: u32,
}

impl StabilityBound {
    /// The largest time step at which [`crate::Rk4`] is stable, s.
    #[must_use]
    pub fn rk4(&self) -> f64 {
        self.within_half_disc(2.615)
    }

    /// The largest time step at which [`crate::BlanesMoanS6`] is stable, s.
    #[must_use]
    pub fn blanes_moan_s6(&self) -> f64 {
        (3.13 / self.frequency).at_most(6.0 / self.damping_rate)
    }

    /// The largest time step at which [`crate::Dop853`] is stable, s.
    #[must_use]
    pub fn dop853(&self) -> f64 {
        self.within_half_disc(5.96)
    }

    /// The largest time step at which [`crate::DormandPrinceRkn8`] is stable, s.
    #[must_use]
    pub fn dormand_prince_rkn8(&self) -> f64 {
        3.139 / self.frequency
    }

    /// Where a method is stable in the left half of the disc |z| ≤ `radius`: every eigenvalue z solves z² + c z + k = 0
    /// for some c up to γ and k up to ω², so |z| is no more than the larger of ω and γ.
    fn within_half_disc(&self, radius: f64) -> f64 {
        radius / self.frequency.max(self.damping_rate)
    }
}

impl<R: Real> View<'_, R> {
    /// The bound for the current state, as far as it does not sleep; nothing where no spring pulls at a free particle.
    ///
    /// ```
    /// use hooke::{Particle, Spring, World};
    ///
    /// let mut world = World::<f64, 2, 1, 0>::new();
    /// let pin = world.add_particle(Particle::at([0.0; 3]).pinned())?;
    /// let mass = world.add_particle(Particle::at([1.0, 0.0, 0.0]).with_mass(0.25))?;
    /// world.add_spring(Spring::new([pin, mass], 100.0, 1.0))?;
    /// // ω² = k/m: 20 rad/s, and undamped ω dt = 2.
    /// let bound = world.view().stability().ok_or("no spring pulls at a free particle")?;
    /// assert!((bound.frequency - 20.0).abs() < 1e-12 && (bound.velocity_verlet - 0.1).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn stability(&self) -> Option<StabilityBound> {
        bound(&self.system, self.system.plan.awake().attached, &self.current)
    }
}

/// A symmetric matrix: xx, yy, zz, xy, xz, yz.
type Symmetric = [f64; 6];

/// What one particle contributes.
struct Blocks {
    stiffness: Symmetric,
    damping: Symmetric,
    stiffest: (f64, u32),
    /// The least k_d/k.
    relaxation: f64,
}

/// For the slots from 0 to `attached`.
pub(crate) fn bound<R: Real>(system: &System<'_, R>, attached: u32, state: &State<'_, R>) -> Option<StabilityBound> {
    let mut bound = StabilityBound {
        frequency: 0.0,
        damping_rate: 0.0,
        velocity_verlet: f64::INFINITY,
        semi_implicit_euler: f64::INFINITY,
        explicit_euler: f64::INFINITY,
        particle: 0,
        spring: 0,
    };
    let mut any = false;
    for (slot, incidences) in system.springs.by_slot(attached) {
        if !system.is_dynamic(slot) {
            continue;
        }
        let blocks = blocks(system, state, slot, incidences);
        let (squared, gamma) = (largest_eigenvalue(blocks.stiffness), largest_eigenvalue(blocks.damping));
        let verlet = limit(squared, 4.0 * gamma);
        if !any || verlet < bound.velocity_verlet {
            bound.particle = at(system.particle_at, slot);
            bound.spring = blocks.stiffest.1;
        }
        any = true;
        bound.velocity_verlet = bound.velocity_verlet.at_most(verlet);
        bound.semi_implicit_euler = bound.semi_implicit_euler.at_most(limit(squared, 2.0 * gamma));
        bound.damping_rate = bound.damping_rate.at_least(gamma);
        bound.frequency = bound.frequency.at_least(Real::sqrt(squared));
        bound.explicit_euler = bound.explicit_euler.at_most(blocks.relaxation).at_most(2.0 / gamma);
    }
    any.then_some(bound)
}

/// The dt that solves dt²·a + dt·b = 4.
fn limit(a: f64, b: f64) -> f64 {
    8.0 / (b + Real::sqrt(b * b + 16.0 * a))
}

fn blocks<R: Real>(system: &System<'_, R>, state: &State<'_, R>, slot: u32, incidences: &[Incidence]) -> Blocks {
    let springs = system.springs;
    let position = |slot: u32| exact(state.position_of(slot));
    let here = position(slot);
    let inverse_mass = at(system.inverse_mass, slot).to_f64();
    let mut blocks = Blocks { stiffness: [0.0; 6], damping: [0.0; 6], stiffest: (-1.0, 0), relaxation: f64::INFINITY };
    for &Incidence { neighbour, spring } in incidences {
        let Law { stiffness, damping, rest_length } = springs.exact_law(spring);
        let both = inverse_mass + at(system.inverse_mass, neighbour).to_f64();
        let d = difference(position(neighbour), here);
        let length = Real::sqrt(dot(d, d));
        let (axis, across) = if length > 0.0 {
            let [x, y, z] = d;
            ([x / length, y / length, z / length], (1.0 - rest_length / length).at_least(0.0))
        } else {
            // Whatever direction it takes next, it is no stiffer than k in all of them.
            (const { [0.0; 3] }, 1.0)
        };
        add(&mut blocks.stiffness, both * stiffness, axis, across);
        add(&mut blocks.damping, both * damping, axis, 0.0);
        if both * stiffness > blocks.stiffest.0 {
            blocks.stiffest = (both * stiffness, at(springs.number, spring));
        }
        if stiffness > 0.0 {
            blocks.relaxation = blocks.relaxation.at_most(damping / stiffness);
        }
    }
    blocks
}

/// m += s [n nᵀ + t (I − n nᵀ)]
fn add(m: &mut Symmetric, s: f64, [x, y, z]: [f64; 3], t: f64) {
    let along = s * (1.0 - t);
    let across = s * t;
    let [xx, yy, zz, xy, xz, yz] = m;
    *xx += along * x * x + across;
    *yy += along * y * y + across;
    *zz += along * z * z + across;
    *xy += along * x * y;
    *xz += along * x * z;
    *yz += along * y * z;
}

/// By Jacobi rotations: each annuls one entry beside the diagonal, and four rounds of the three are far past what
/// `f64` can tell (Golub and Van Loan, *Matrix Computations*, §8.5).
fn largest_eigenvalue(matrix: Symmetric) -> f64 {
    let [mut xx, mut yy, mut zz, mut xy, mut xz, mut yz] = matrix;
    for _ in 0..6 {
        rotate(&mut xx, &mut yy, &mut xy, &mut xz, &mut yz);
        rotate(&mut xx, &mut zz, &mut xz, &mut xy, &mut yz);
        rotate(&mut yy, &mut zz, &mut yz, &mut xy, &mut xz);
    }
    xx.max(yy).max(zz)
}

/// Annuls the entry `pq` between the diagonal entries `pp` and `qq`; `pr` and `qr` are their entries with the third.
fn rotate(pp: &mut f64, qq: &mut f64, pq: &mut f64, pr: &mut f64, qr: &mut f64) {
    if *pq == 0.0 {
        return;
    }
    let theta = (*qq - *pp) / (2.0 * *pq);
    let sign = if theta >= 0.0 { 1.0 } else { -1.0 };
    let t = sign / (theta.abs() + Real::sqrt(theta * theta + 1.0));
    let c = 1.0 / Real::sqrt(t * t + 1.0);
    let s = t * c;
    *pp -= t * *pq;
    *qq += t * *pq;
    *pq = 0.0;
    (*pr, *qr) = (c * *pr - s * *qr, s * *pr + c * *qr);
}
