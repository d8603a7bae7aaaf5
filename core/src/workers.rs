//! Threads, for those who have some.

use core::fmt::Debug;

/// Threads that share the work of a step. The core has none of its own; on a desktop, a thread pool can offer some
/// through [`crate::View::share_among`].
///
/// The bits of a step do not depend on how many there are, nor on who does what.
pub trait Workers: Sync + Debug {
    /// How many parts the work is cut into, 1 or more.
    fn count(&self) -> u32;

    /// Does both, at the same time if it can, and returns when both are done.
    fn both(&self, first: &mut (dyn FnMut() + Send), second: &mut (dyn FnMut() + Send));
}
