//! Numerical stability, in every form.

use std::error::Error;

use super::table;
use crate::chart::ChartError;
use crate::cli::figures::Figures;
use crate::report::{stability_maps, stress_page};
use crate::stress::Stressed;

impl Figures for [Stressed] {
    fn table(&self) -> Result<Vec<u8>, Box<dyn Error>> {
        let mut text = Vec::new();
        table::write(self, &mut text)?;
        Ok(text)
    }

    fn picture(&self) -> Result<String, ChartError> {
        stability_maps(self)
    }

    fn page(&self) -> Result<String, ChartError> {
        Ok(stress_page(self)?.html())
    }
}
