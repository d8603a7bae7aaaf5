//! The vertices and edges of a Wavefront OBJ file.
//!
//! Written here because a refusal must name the line and what stands on it, and keep positions to 64 bits. Only `v`, `f`
//! and `l` matter to a simulation; textures, normals, groups and materials are passed over.

use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use super::checks;
use super::error::{Refusal, SceneError};
use super::spring::distance;

/// What a mesh file says about particles and springs.
#[derive(Clone, Debug, Default)]
pub(super) struct Shape {
    /// m, in file order.
    pub(super) vertices: Vec<[f64; 3]>,
    /// Each once, in the order that faces and lines first run along them.
    pub(super) edges: Vec<[u32; 2]>,
    /// The vertices across each edge that triangles share, in the order of the later triangle. Where more than two
    /// triangles share an edge, each is joined with the one before it.
    pub(super) across: Vec<[u32; 2]>,
}

impl Shape {
    /// Reads a file's text; its path is for errors only.
    pub(super) fn parse(path: &Path, text: &Arc<str>) -> Result<Self, SceneError> {
        let refused = |refusal| SceneError::in_text(path, text, refusal);
        let shape = parse(text).map_err(refused)?;
        if shape.edges.is_empty() {
            let vertices = shape.vertices.len();
            return Err(SceneError::plain(
                path.display(),
                format!("the mesh has no edges: {vertices} vertices, and no face or line that joins any two"),
                "export the mesh with its faces (`f` lines) or edges (`l` lines)".to_owned(),
            ));
        }
        Ok(shape)
    }

    /// Between two vertices, m.
    pub(super) fn length(&self, [from, to]: [u32; 2]) -> f64 {
        distance(self.vertices[from as usize], self.vertices[to as usize])
    }
}

fn parse(text: &str) -> Result<Shape, Refusal> {
    let mut shape = Shape::default();
    // First all vertices, because a face may name one that comes later.
    for statement in statements(text).filter(|statement| statement.keyword == "v") {
        shape.vertices.push(vertex(&statement)?);
    }
    let mut joins = Joins::default();
    let mut vertices_so_far = 0;
    for statement in statements(text) {
        let least = match statement.keyword {
            "v" => {
                vertices_so_far += 1;
                continue;
            }
            "f" => 3,
            "l" => 2,
            _ => continue,
        };
        let indices = indices(&statement, least, vertices_so_far, shape.vertices.len())?;
        // A face runs back to where it began.
        let closing = if least == 3 { &indices[..1] } else { &[] };
        let around: Vec<u32> = indices.iter().chain(closing).copied().collect();
        for pair in around.windows(2) {
            if pair[0] == pair[1] {
                let message = format!("this joins vertex {} to itself", pair[0] + 1);
                return Err(statement.refusal(message, "take the repeated vertex out"));
            }
            joins.edge(&mut shape, [pair[0], pair[1]]);
        }
        if let (3, &[a, b, c]) = (least, indices.as_slice()) {
            joins.triangle(&mut shape, [a, b, c]);
        }
    }
    Ok(shape)
}

/// What has been joined already.
#[derive(Default)]
struct Joins {
    edges: HashSet<[u32; 2]>,
    /// For each edge of a triangle, the vertex across it in the last triangle that has it.
    across: HashMap<[u32; 2], u32>,
}

impl Joins {
    fn edge(&mut self, shape: &mut Shape, between: [u32; 2]) {
        if self.edges.insert(either_way(between)) {
            shape.edges.push(between);
        }
    }

    fn triangle(&mut self, shape: &mut Shape, [a, b, c]: [u32; 3]) {
        for (edge, tip) in [([a, b], c), ([b, c], a), ([c, a], b)] {
            // The same triangle given twice has the same tip twice.
            if let Some(other) = self.across.insert(either_way(edge), tip)
                && other != tip
            {
                shape.across.push([other, tip]);
            }
        }
    }
}

fn either_way([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// A line of the file: its keyword, and where it and what follows stand.
struct Statement<'text> {
    text: &'text str,
    span: Range<usize>,
    keyword: &'text str,
}

fn statements(text: &str) -> impl Iterator<Item = Statement<'_>> {
    let mut next = 0;
    text.split_inclusive('\n').map(move |line| {
        let start = next;
        next += line.len();
        let text = line.split('#').next().unwrap_or_default().trim_end();
        let keyword = text.split_whitespace().next().unwrap_or_default();
        Statement { text, span: start..start + text.len(), keyword }
    })
}

impl<'text> Statement<'text> {
    fn words(&self) -> impl Iterator<Item = &'text str> {
        self.text.split_whitespace().skip(1)
    }

    fn refusal(&self, message: String, remedy: &str) -> Refusal {
        Refusal { span: Some(self.span.clone()), message, label: "on this line".to_owned(), remedy: remedy.to_owned() }
    }
}

fn vertex(statement: &Statement<'_>) -> Result<[f64; 3], Refusal> {
    let remedy = "write a vertex as `v x y z`, with three finite numbers of metres";
    let mut vertex = [0.0; 3];
    let mut words = statement.words();
    for component in &mut vertex {
        let Some(word) = words.next() else {
            return Err(statement.refusal(format!("a vertex has three numbers, this is `{}`", statement.text), remedy));
        };
        *component = word.parse().map_err(|_| statement.refusal(format!("`{word}` is not a number"), remedy))?;
    }
    match checks::vector("v", vertex, "metres") {
        Ok(()) => Ok(vertex),
        Err(problem) => Err(statement.refusal(problem.message("v"), remedy)),
    }
}

/// The vertices that a face or a line names, counted from 0.
fn indices(statement: &Statement<'_>, least: usize, so_far: i64, count: usize) -> Result<Vec<u32>, Refusal> {
    let indices: Vec<u32> =
        statement.words().map(|word| index(statement, word, so_far, count)).collect::<Result<_, _>>()?;
    if indices.len() < least {
        let message = format!("`{}` names {} vertices, and needs at least {least}", statement.text, indices.len());
        return Err(statement.refusal(message, "add the missing vertices, or take the line out"));
    }
    Ok(indices)
}

/// One of `5`, `5/1`, `5//2`, `5/1/2` and `-1`, the latest vertex so far.
fn index(statement: &Statement<'_>, word: &str, so_far: i64, count: usize) -> Result<u32, Refusal> {
    let written = word.split('/').next().unwrap_or_default();
    let Ok(number) = written.parse::<i64>() else {
        let message = format!("`{word}` names no vertex: `{written}` is not a whole number");
        return Err(statement.refusal(message, "write vertices as whole numbers from 1, or negative to count back"));
    };
    let from_zero = if number < 0 { so_far.saturating_add(number) } else { number - 1 };
    match u32::try_from(from_zero) {
        Ok(index) if (index as usize) < count => Ok(index),
        _ => {
            let message = format!(
                "there is no vertex {number}: the mesh has {count}, numbers 1 to {count}, and {so_far} before this line"
            );
            Err(statement.refusal(message, "name a vertex that exists; they count from 1, and back from -1"))
        }
    }
}
