//! Times that can be compared on a machine that others use too: contenders take turns, and each one's best round counts.

use std::time::Instant;

/// Something to be timed: what it is called, and so many steps of it.
pub type Contender<'a> = (String, Box<dyn FnMut(u32) + 'a>);

/// The least time of a step of each contender, ns, over `rounds` rounds of `steps` steps each in turn.
pub fn least_times(contenders: &mut [Contender<'_>], rounds: u32, steps: u32) -> Vec<f64> {
    let mut least = vec![f64::INFINITY; contenders.len()];
    for round in 0..=rounds {
        for ((_, step), least) in contenders.iter_mut().zip(&mut least) {
            let began = Instant::now();
            step(steps);
            let each = began.elapsed().as_secs_f64() * 1e9 / f64::from(steps);
            // The first round fetches code and data.
            if round > 0 {
                *least = least.min(each);
            }
        }
    }
    least
}
