//! A bounded queue between two threads, whose items go round: what was taken comes back to be filled again.
//!
//! A channel wakes a thread for each item, which takes longer than many a frame takes to be made or written. Here a
//! thread that has to wait is woken when half of the queue is there for it: the giver when half is empty, and the taker,
//! once it has had something, when half is full, or after a moment.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// How long the taker waits for more before it takes what there is.
const MOMENT: Duration = Duration::from_millis(1);

/// A queue for at most `limit` items, which is more than 0, those that were taken and not given back among them.
pub(super) fn queue<T: Default>(limit: usize) -> (Giver<T>, Taker<T>) {
    let state = State {
        full: VecDeque::new(),
        empty: Vec::new(),
        made: 0,
        giver: Rest::None,
        taker: Rest::None,
        closed: false,
    };
    let queue = Queue {
        state: Mutex::new(state),
        filled: Condvar::new(),
        emptied: Condvar::new(),
        given_up: AtomicBool::new(false),
        limit,
    };
    let queue = Arc::new(queue);
    (Giver { queue: Arc::clone(&queue), spare: Vec::new() }, Taker(queue))
}

/// The end that items go in at. Dropping it closes the queue.
pub(super) struct Giver<T> {
    queue: Arc<Queue<T>>,
    /// Empty items.
    spare: Vec<T>,
}

/// The end that items come out of. Dropping it tells the giver that nobody takes them any more.
pub(super) struct Taker<T>(Arc<Queue<T>>);

/// Nobody takes items from the queue any more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stopped;

struct Queue<T> {
    state: Mutex<State<T>>,
    /// For the taker.
    filled: Condvar,
    /// For the giver.
    emptied: Condvar,
    /// The taker is gone.
    given_up: AtomicBool,
    limit: usize,
}

struct State<T> {
    full: VecDeque<T>,
    empty: Vec<T>,
    /// All items there are.
    made: usize,
    giver: Rest,
    taker: Rest,
    closed: bool,
}

/// What a thread waits for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Rest {
    /// It is at work.
    None,
    /// Half of all items.
    UntilHalf,
    /// The first one.
    UntilOne,
}

impl<T> Queue<T> {
    fn lock(&self) -> MutexGuard<'_, State<T>> {
        // Nothing that could panic is done under the lock.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn is_given_up(&self) -> bool {
        self.given_up.load(Ordering::Relaxed)
    }

    fn half(&self) -> usize {
        self.limit.div_ceil(2)
    }
}

impl<T: Default> Giver<T> {
    /// An item to be filled, as it was left when it was taken; waits where all are on their way.
    pub(super) fn empty(&mut self) -> Result<T, Stopped> {
        if self.is_stopped() {
            return Err(Stopped);
        }
        if let Some(item) = self.spare.pop() {
            return Ok(item);
        }
        let queue = &*self.queue;
        let mut state = queue.lock();
        if state.empty.is_empty() && state.made < queue.limit {
            state.made += 1;
            return Ok(T::default());
        }
        if state.empty.is_empty() {
            state.giver = Rest::UntilHalf;
            let waits = |state: &mut State<T>| state.empty.len() < queue.half() && !queue.is_given_up();
            state = queue.emptied.wait_while(state, waits).unwrap_or_else(PoisonError::into_inner);
            state.giver = Rest::None;
        }
        self.spare.append(&mut state.empty);
        self.spare.pop().ok_or(Stopped)
    }

    /// Puts a filled item into the queue.
    pub(super) fn give(&self, item: T) {
        let queue = &*self.queue;
        let mut state = queue.lock();
        state.full.push_back(item);
        let wake = match state.taker {
            Rest::None => false,
            Rest::UntilHalf => state.full.len() >= queue.half(),
            Rest::UntilOne => true,
        };
        if wake {
            queue.filled.notify_one();
        }
    }

    /// Whether nobody takes items any more.
    pub(super) fn is_stopped(&self) -> bool {
        self.queue.is_given_up()
    }
}

impl<T> Drop for Giver<T> {
    fn drop(&mut self) {
        self.queue.lock().closed = true;
        self.queue.filled.notify_one();
    }
}

impl<T> Taker<T> {
    /// Gives back what is in `items`, and takes up to half of what the queue holds, so that the giver fills the other
    /// half meanwhile; nothing once the queue is closed and empty.
    pub(super) fn take(&self, items: &mut Vec<T>) {
        let queue = &*self.0;
        let mut state = queue.lock();
        let had_some = !items.is_empty();
        state.empty.append(items);
        if state.giver == Rest::UntilHalf && state.empty.len() >= queue.half() {
            queue.emptied.notify_one();
        }
        if had_some {
            state.taker = Rest::UntilHalf;
            let waits = |state: &mut State<T>| state.full.len() < queue.half() && !state.closed;
            let waited = queue.filled.wait_timeout_while(state, MOMENT, waits);
            (state, _) = waited.unwrap_or_else(PoisonError::into_inner);
        }
        state.taker = Rest::UntilOne;
        let waits = |state: &mut State<T>| state.full.is_empty() && !state.closed;
        state = queue.filled.wait_while(state, waits).unwrap_or_else(PoisonError::into_inner);
        state.taker = Rest::None;
        let some = state.full.len().min(queue.half());
        items.extend(state.full.drain(..some));
    }
}

impl<T> Drop for Taker<T> {
    fn drop(&mut self) {
        let state = self.0.lock();
        self.0.given_up.store(true, Ordering::Relaxed);
        drop(state);
        self.0.emptied.notify_one();
    }
}
