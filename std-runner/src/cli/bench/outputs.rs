//! Where measurements go: the ending picks the form.

use std::fs;
use std::path::{Path, PathBuf};

use crate::bench::{Bench, write_rows};
use crate::chart::ChartError;
use crate::cli::failure::Failure;
use crate::cli::outputs::{check_place, is_standard_output};
use crate::cli::print;
use crate::report::{Work, bench_page, work_precision};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// A row for each run.
    Table,
    /// The work-precision diagram.
    Picture,
    /// Everything, to show.
    Page,
}

/// All places that measurements are written to.
pub(super) struct Outputs {
    files: Vec<(PathBuf, Form)>,
    to_standard_output: bool,
}

impl Outputs {
    /// Refuses what cannot be written to, and what would overwrite a scene.
    pub(super) fn check(paths: &[PathBuf], scenes: &[PathBuf]) -> Result<Self, Failure> {
        let mut outputs = Self { files: Vec::new(), to_standard_output: false };
        for path in paths {
            if is_standard_output(path) {
                outputs.to_standard_output = true;
                continue;
            }
            let shown = path.display();
            let Some(form) = form(path) else {
                let message = format!("--out {shown}: the known endings are .csv, .svg and .html");
                let remedy = "end the file's name in one of them, or use - for CSV to standard output";
                return Err(Failure::input(message, remedy));
            };
            if scenes.contains(path) {
                return Err(Failure::input(format!("--out {shown} is a scene"), "write to another file"));
            }
            if outputs.files.iter().any(|(other, _)| other == path) {
                return Err(Failure::input(format!("--out {shown} is given twice"), "give it once"));
            }
            check_place(path, "--out")?;
            outputs.files.push((path.clone(), form));
        }
        Ok(outputs)
    }

    pub(super) fn has_page(&self) -> bool {
        self.files.iter().any(|(_, form)| *form == Form::Page)
    }

    /// A report, beside the data.
    pub(super) fn tell(&self, report: &str) -> Result<(), Failure> {
        if self.to_standard_output {
            print::message(report);
        } else {
            print::data(format!("{report}\n"))?;
        }
        Ok(())
    }

    /// Every file, with what there is.
    pub(super) fn write(&self, benches: &[Bench]) -> Result<(), Failure> {
        for (path, form) in &self.files {
            let text = match form {
                Form::Table => table(benches)?,
                Form::Picture => {
                    work_precision(benches, Work::Time).svg().map_err(|error| undrawn(&error))?.into_bytes()
                }
                Form::Page => bench_page(benches).map_err(|error| undrawn(&error))?.html().into_bytes(),
            };
            fs::write(path, text).map_err(|error| {
                let message = format!("cannot write {}: {error}", path.display());
                Failure::failed(message, "make room there, or write to another place")
            })?;
        }
        Ok(())
    }

    pub(super) fn write_to_standard_output(&self, benches: &[Bench]) -> Result<(), Failure> {
        if self.to_standard_output {
            print::data(table(benches)?)?;
        }
        Ok(())
    }
}

fn form(path: &Path) -> Option<Form> {
    match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
        "csv" => Some(Form::Table),
        "svg" => Some(Form::Picture),
        "html" => Some(Form::Page),
        _ => None,
    }
}

fn table(benches: &[Bench]) -> Result<Vec<u8>, Failure> {
    let mut text = Vec::new();
    write_rows(benches, &mut text).map_err(|error| Failure::failed(error.to_string(), "tell the authors of Hooke"))?;
    Ok(text)
}

fn undrawn(error: &ChartError) -> Failure {
    Failure::failed(error.to_string(), "write the table alone: --out runs.csv")
}
