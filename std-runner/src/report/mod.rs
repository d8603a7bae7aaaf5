//! Reports that people read and show: pages that need nothing but themselves.

mod bench_page;
mod looks;
mod over_time;
mod page;
mod stability;
mod stress_page;
mod stress_told;
mod told;
mod work_precision;

pub use bench_page::bench_page;
pub use over_time::{energy_over_time, error_over_time};
pub use page::{Block, Page, Section};
pub use stability::stability_maps;
pub use stress_page::stress_page;
pub use stress_told::{found, limit_rows, limits_in_words, verdict_rows, wanting};
pub use told::{advice, other_machine, reference_facts, rival_rows, run_cells};
pub use work_precision::{Work, work_precision};
