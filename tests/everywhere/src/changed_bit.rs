//! An operation that is not what it should be: what the comparison is held against.

use hooke::Real;

use crate::build::Room;
use crate::row::Row;

/// The row, the step and the particle whose velocity along y is then the next larger number.
pub const ROW: &str = "cloth velocity-verlet f32 project";
/// From 1.
pub const STEP: u32 = 3;
/// By number.
pub const PARTICLE: u32 = 100;

/// Changes the bit, if it is time.
pub fn after_step<R: Real>(row: Row, step: u32, world: &mut Room<R>) {
    if Row::of(ROW.split(' ')) != Some(row) || step != STEP {
        return;
    }
    let Some(velocity) = world.velocity(PARTICLE) else { return };
    let [x, y, z]: [R::Coordinate; 3] = velocity.into();
    let larger = R::Coordinate::from_f64(f64::from((y.to_f64() as f32).next_up()));
    // There is such a particle, and the number is finite.
    let _ = world.set_velocity(PARTICLE, [x, larger, z]);
}
