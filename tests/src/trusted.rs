//! Trajectories that other programs computed, from `tests/reference`.

use crate::moment::Moment;
use std::io;
use std::path::PathBuf;

/// The states of one scene at a few times.
#[derive(Clone, Debug)]
pub struct Trusted {
    /// s
    pub time: Vec<f64>,
    /// The state at each.
    pub moments: Vec<Moment>,
}

/// The path of a file in `tests/reference`, wherever the test runs.
#[must_use]
pub fn path(file: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "reference", file].iter().collect()
}

impl Trusted {
    /// Reads `name`.npz from `tests/reference`: `time` (T), `position` (T, P, 3), `velocity` (T, P, 3).
    ///
    /// # Errors
    /// There is no such file, or it does not hold these arrays in these shapes.
    pub fn read(name: &str) -> io::Result<Self> {
        let mut archive = npyz::npz::NpzArchive::open(path(&format!("{name}.npz")))?;
        let mut array = |name: &str| -> io::Result<(Vec<u64>, Vec<f64>)> {
            let file = archive.by_name(name)?.ok_or_else(|| wrong("array missing"))?;
            if file.order() != npyz::Order::C {
                return Err(wrong("array not in C order"));
            }
            Ok((file.shape().to_vec(), file.into_vec()?))
        };
        let (_, time) = array("time")?;
        let (shape, position) = array("position")?;
        let (velocity_shape, velocity) = array("velocity")?;
        let &[times, particles, 3] = shape.as_slice() else {
            return Err(wrong("positions not of shape (T, P, 3)"));
        };
        if shape != velocity_shape || times != time.len() as u64 || particles == 0 {
            return Err(wrong("arrays do not belong together"));
        }
        let frame = 3 * particles as usize;
        let moments = position.chunks(frame).zip(velocity.chunks(frame));
        let moments = moments.map(|(position, velocity)| Moment {
            position: position.as_chunks().0.to_vec(),
            velocity: velocity.as_chunks().0.to_vec(),
        });
        Ok(Self { time, moments: moments.collect() })
    }
}

fn wrong(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what)
}
