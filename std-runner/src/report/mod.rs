//! Reports that people read and show: pages that need nothing but themselves.

mod bench_page;
mod looks;
mod over_time;
mod page;
mod told;
mod work_precision;

pub use bench_page::bench_page;
pub use over_time::{energy_over_time, error_over_time};
pub use page::{Block, Page, Section};
pub use told::{advice, other_machine, reference_facts, rival_rows};
pub use work_precision::{Work, work_precision};
