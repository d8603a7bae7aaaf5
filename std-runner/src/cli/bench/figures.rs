//! Run time against error, in every form.

use std::error::Error;

use crate::bench::{Bench, write_rows};
use crate::chart::ChartError;
use crate::cli::figures::Figures;
use crate::report::{Work, bench_page, work_precision};

impl Figures for [Bench] {
    fn table(&self) -> Result<Vec<u8>, Box<dyn Error>> {
        let mut text = Vec::new();
        write_rows(self, &mut text)?;
        Ok(text)
    }

    fn picture(&self) -> Result<String, ChartError> {
        work_precision(self, Work::Time).svg()
    }

    fn page(&self) -> Result<String, ChartError> {
        Ok(bench_page(self)?.html())
    }
}
