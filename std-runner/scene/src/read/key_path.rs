//! Where in a scene something stands, as a person writes it: `spring[3].stiffness`.

use std::fmt;

/// One step from a table or a list to what it holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    Key(String),
    Index(usize),
}

/// The steps from the top of a scene to a value in it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct KeyPath {
    /// Innermost first, because paths are built while an error travels outwards.
    inner_first: Vec<Step>,
}

impl KeyPath {
    /// The value of a key at the top.
    pub(crate) fn key(key: &str) -> Self {
        Self::default().inside_key(key)
    }

    /// The same place, seen from the table that holds it under `key`.
    pub(crate) fn inside_key(mut self, key: &str) -> Self {
        self.inner_first.push(Step::Key(key.to_owned()));
        self
    }

    /// The same place, seen from the list that holds it at `index`.
    pub(crate) fn inside_index(mut self, index: usize) -> Self {
        self.inner_first.push(Step::Index(index));
        self
    }

    /// From the outermost step inwards.
    pub(super) fn steps(&self) -> impl Iterator<Item = &Step> {
        self.inner_first.iter().rev()
    }

    /// Whether this is the whole scene.
    pub(super) fn is_top(&self) -> bool {
        self.inner_first.is_empty()
    }

    /// The flag that sets this key from the command line.
    #[cfg(feature = "desktop")]
    pub(crate) fn flag(&self) -> String {
        format!("--{}", self.to_string().replace('_', "-"))
    }
}

impl fmt::Display for KeyPath {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (depth, step) in self.steps().enumerate() {
            match step {
                Step::Key(key) if depth == 0 => formatter.write_str(key)?,
                Step::Key(key) => write!(formatter, ".{key}")?,
                Step::Index(index) => write!(formatter, "[{index}]")?,
            }
        }
        Ok(())
    }
}
