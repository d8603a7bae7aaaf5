//! A pool of threads that share the work of a step.

use hooke::{Plan, Workers};

/// Springs that are worth a second thread: a cloth of 5,826 gains nothing by it, one of 23,938 takes 1.1 to
/// 1.7 times less, by how busy the machine is otherwise.
const WORTH_SHARING: u32 = 20_000;

/// A pool of threads.
#[derive(Debug)]
pub struct Threads {
    pool: rayon::ThreadPool,
}

impl Threads {
    /// As many as are asked for, or as the machine can run at once where a world is large enough to gain by it; nothing
    /// if that is one.
    ///
    /// # Errors
    /// If the system has no more threads to give.
    pub fn of(asked: Option<u32>, plan: &Plan) -> Result<Option<Self>, rayon::ThreadPoolBuildError> {
        let count = match asked {
            Some(count) => count as usize,
            None if plan.springs >= WORTH_SHARING => std::thread::available_parallelism().map_or(1, usize::from),
            None => 1,
        };
        if count < 2 {
            return Ok(None);
        }
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build()?;
        Ok(Some(Self { pool }))
    }
}

impl Threads {
    /// Does something on one of them, so that none has to be woken for each step of it.
    pub fn during<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        self.pool.install(work)
    }
}

impl Workers for Threads {
    fn count(&self) -> u32 {
        self.pool.current_num_threads().try_into().unwrap_or(u32::MAX)
    }

    fn both(&self, first: &mut (dyn FnMut() + Send), second: &mut (dyn FnMut() + Send)) {
        self.pool.install(|| rayon::join(first, second));
    }
}
