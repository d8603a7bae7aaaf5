//! Where measurements go: the ending picks the form.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::outputs::{check_place, is_standard_output};
use super::print;
use crate::chart::ChartError;

/// Measurements in every form that they can be written in.
pub(super) trait Figures {
    /// As CSV.
    fn table(&self) -> Result<Vec<u8>, Box<dyn Error>>;
    /// As SVG.
    fn picture(&self) -> Result<String, ChartError>;
    /// As HTML.
    fn page(&self) -> Result<String, ChartError>;
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// A row for each figure.
    Table,
    /// What is to be seen at a glance.
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

    /// Whether anything is written that shows everything.
    pub(super) fn has_page(&self) -> bool {
        self.files.iter().any(|(_, form)| *form == Form::Page)
    }

    /// Whether anything is written that shows pictures.
    pub(super) fn has_pictures(&self) -> bool {
        self.files.iter().any(|(_, form)| *form != Form::Table)
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
    pub(super) fn write(&self, figures: &(impl Figures + ?Sized)) -> Result<(), Failure> {
        for (path, form) in &self.files {
            let text = match form {
                Form::Table => table(figures)?,
                Form::Picture => figures.picture().map_err(|error| undrawn(&error))?.into_bytes(),
                Form::Page => figures.page().map_err(|error| undrawn(&error))?.into_bytes(),
            };
            fs::write(path, text).map_err(|error| {
                let message = format!("cannot write {}: {error}", path.display());
                Failure::failed(message, "make room there, or write to another place")
            })?;
        }
        Ok(())
    }

    /// The table, where it was asked for.
    pub(super) fn write_to_standard_output(&self, figures: &(impl Figures + ?Sized)) -> Result<(), Failure> {
        if self.to_standard_output {
            print::data(table(figures)?)?;
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

fn table(figures: &(impl Figures + ?Sized)) -> Result<Vec<u8>, Failure> {
    figures.table().map_err(|error| Failure::failed(error.to_string(), "tell the authors of Hooke"))
}

fn undrawn(error: &ChartError) -> Failure {
    Failure::failed(error.to_string(), "write the table alone: --out figures.csv")
}
