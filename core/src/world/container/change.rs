//! Changes to what is in a world already, and what is there to be read back.

use super::Container;
use crate::Real;
use crate::compiled::HotLoops;
use crate::types::{Plane, SetError, Spring};
use crate::vectors::{at, put};
use crate::world::clock::Clock;
use crate::world::layout::{SpringColumns, StateColumns};
use crate::world::storage::{Column, Storage};
use crate::world::view::states_of;

impl<R: Real, M: Storage> Container<R, M> {
    /// How many particles there are.
    #[must_use]
    pub fn particle_count(&self) -> u32 {
        self.particles.count()
    }

    /// The state now.
    pub(super) fn current(&self) -> &StateColumns<R, M> {
        let [a, b] = &self.particles.state;
        if self.front == 0 { a } else { b }
    }

    /// Where all particles are (m) and how fast they move (m/s), in the order of their numbers.
    pub fn states(&self) -> impl Iterator<Item = (R::Vec3, R::Vec3)> {
        let state = self.current();
        states_of(state.position(), state.velocity(), self.particles.slot_of.items())
    }

    /// Writes where particles are, m, in the order of their numbers, each coordinate rounded to `f32` as graphics take them; as
    /// many as there is room for.
    ///
    /// ```
    /// use hooke::{Particle, World};
    ///
    /// let mut world = World::<f64, 2, 1, 0>::new();
    /// world.add_particle(Particle::at([0.5, 0.0, -2.0]))?;
    /// world.add_particle(Particle::at([0.1, 0.0, 0.0]))?;
    /// let mut buffer = [[0.0; 3]; 2];
    /// world.write_positions(&mut buffer);
    /// assert_eq!(buffer, [[0.5, 0.0, -2.0], [0.1, 0.0, 0.0]]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn write_positions(&self, to: &mut [[f32; 3]]) {
        R::Loops::tell(self.current().position(), self.particles.slot_of.items(), to);
    }

    /// Writes how fast particles move, m/s, likewise.
    pub fn write_velocities(&self, to: &mut [[f32; 3]]) {
        R::Loops::tell(self.current().velocity(), self.particles.slot_of.items(), to);
    }

    /// All springs with their numbers, in no particular order.
    pub fn springs(&self) -> impl ExactSizeIterator<Item = (u32, Spring<R>)> {
        (0..self.springs.count()).map(|place| self.spring_in(place))
    }

    fn spring_in(&self, place: u32) -> (u32, Spring<R>) {
        let columns = &self.springs;
        let particle_at = self.particles.particle_at.items();
        let spring = Spring {
            between: at(columns.ends.items(), place).map(|slot| at(particle_at, slot)),
            stiffness: at(columns.stiffness.items(), place),
            damping: at(columns.damping.items(), place),
            rest_length: at(columns.rest_length.items(), place),
        };
        (at(columns.number.items(), place), spring)
    }

    /// All planes, in the order of their numbers.
    #[must_use]
    pub fn planes(&self) -> &[Plane<R>] {
        self.planes.items()
    }

    /// The gravitational acceleration, m/s².
    #[must_use]
    pub fn gravity(&self) -> [R; 3] {
        self.gravity
    }

    /// Whether a particle is pinned or kinematic; nothing if there is no such particle.
    #[must_use]
    pub fn is_held(&self, particle: u32) -> Option<bool> {
        let slot = self.slot(particle).ok()?;
        Some(at(self.particles.inverse_mass.items(), slot) == R::ZERO)
    }

    /// Gives every spring the parameters that `change` makes of its number and of what it is now; between which particles
    /// it is stays as it is.
    ///
    /// # Errors
    /// Naming the first spring whose new stiffness, damping or rest length is negative or not finite; none is changed then.
    pub fn change_springs(&mut self, change: impl Fn(u32, Spring<R>) -> Spring<R>) -> Result<(), SetError> {
        let mut refused = None;
        for place in 0..self.springs.count() {
            let (number, spring) = self.spring_in(place);
            if change(number, spring).wrong().is_some() && refused.is_none_or(|refused| number < refused) {
                refused = Some(number);
            }
        }
        if let Some(number) = refused {
            return Err(SetError::Spring(number));
        }
        for place in 0..self.springs.count() {
            let (number, spring) = self.spring_in(place);
            let changed = change(number, spring);
            let SpringColumns { stiffness, damping, rest_length, .. } = &mut self.springs;
            put(stiffness.items_mut(), place, changed.stiffness);
            put(damping.items_mut(), place, changed.damping);
            put(rest_length.items_mut(), place, changed.rest_length);
        }
        self.change_for_all();
        Ok(())
    }

    /// Sets the restitution of a plane, from 0 to 1.
    ///
    /// # Errors
    /// If there is no such plane, or it is outside 0…1.
    pub fn set_restitution(&mut self, plane: u32, restitution: R) -> Result<(), SetError> {
        let found = self.planes.items_mut().get_mut(plane as usize).ok_or(SetError::NoSuchPlane(plane))?;
        if !(restitution >= R::ZERO && restitution <= R::ONE) {
            return Err(SetError::Restitution);
        }
        found.restitution = restitution;
        self.change_for_all();
        Ok(())
    }

    /// Sets the time of the state, s: to go on from one that was kept.
    ///
    /// # Errors
    /// If it is not finite.
    pub fn set_time(&mut self, seconds: f64) -> Result<(), SetError> {
        if !seconds.is_finite() {
            return Err(SetError::NotFinite);
        }
        self.clock = Clock::at(seconds);
        self.disturb();
        Ok(())
    }
}
