//! A parsed file of either format, with the place of every part.

use std::ops::Range;

use super::key_path::{KeyPath, Step};

/// A value and the bytes of the file that it was read from.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) span: Range<usize>,
    pub(super) value: Value,
}

/// What TOML and JSON have between them.
#[derive(Debug)]
pub(super) enum Value {
    Null,
    Boolean(bool),
    Integer(i64),
    Number(f64),
    Text(String),
    /// One of TOML's dates and times, in words: nothing in a scene is one.
    Date(String),
    List(Vec<Node>),
    Table(Vec<Entry>),
}

/// A key and its value.
#[derive(Debug)]
pub(super) struct Entry {
    pub(super) key: String,
    pub(super) key_span: Range<usize>,
    pub(super) node: Node,
}

impl Node {
    /// Where the value at `path` stands; where its table stands, if the key is not written out.
    pub(super) fn locate(&self, path: &KeyPath) -> Range<usize> {
        let mut node = self;
        for step in path.steps() {
            let inner = match (step, &node.value) {
                (Step::Key(key), Value::Table(entries)) => {
                    entries.iter().find(|entry| entry.key == *key).map(|entry| &entry.node)
                }
                (Step::Index(index), Value::List(items)) => items.get(*index),
                _ => None,
            };
            match inner {
                Some(inner) => node = inner,
                None => break,
            }
        }
        node.span.clone()
    }
}
