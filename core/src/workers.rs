//! Threads, for those who have some.

use core::fmt::Debug;

/// Threads that share the work of a step. The core has none of its own; on a desktop, a thread pool can offer some
/// through [`crate::View::share_among`].
///
/// The bits of a step do not depend on how many there are, nor on who does what.
///
/// ```
/// use hooke::{Particle, Reflect, SemiImplicitEuler, Workers, World};
///
/// /// Two threads, the second one new each time.
/// #[derive(Debug)]
/// struct Two;
///
/// impl Workers for Two {
///     fn count(&self) -> u32 {
///         2
///     }
///
///     fn both(&self, first: &mut (dyn FnMut() + Send), second: &mut (dyn FnMut() + Send)) {
///         std::thread::scope(|scope| {
///             scope.spawn(first);
///             second();
///         });
///     }
/// }
///
/// let mut world = World::<f32, 1000, 0, 0>::new();
/// for number in 0..1000 {
///     world.add_particle(Particle::at([number as f32, 0.0, 0.0]))?;
/// }
/// let mut view = world.view();
/// view.share_among(&Two);
/// view.step(&mut SemiImplicitEuler, &mut Reflect, 1e-3)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Workers: Sync + Debug {
    /// How many parts the work is cut into, 1 or more.
    fn count(&self) -> u32;

    /// Calls both once, at the same time if it can, and returns when both are done.
    fn both(&self, first: &mut (dyn FnMut() + Send), second: &mut (dyn FnMut() + Send));
}
