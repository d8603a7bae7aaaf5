//! Sorting by depth, far to near, in time that grows with the number of things only.

/// How finely depth is told apart. Things closer together than this keep the order they were added in.
const BUCKETS: usize = 8192;

/// Things to draw, told apart by a number.
#[derive(Clone, Debug, Default)]
pub(super) struct DepthOrder {
    things: Vec<(f32, u32)>,
    starts: Vec<u32>,
    sorted: Vec<u32>,
}

impl DepthOrder {
    pub(super) fn clear(&mut self) {
        self.things.clear();
    }

    /// Adds a thing; the depth must be finite.
    pub(super) fn push(&mut self, depth: f32, number: u32) {
        self.things.push((depth, number));
    }

    /// The numbers, farthest first; of equal depth, first added first.
    pub(super) fn far_to_near(&mut self) -> &[u32] {
        let depths = self.things.iter().map(|thing| thing.0);
        let farthest = depths.clone().fold(f32::MIN, f32::max);
        let nearest = depths.fold(f32::MAX, f32::min);
        let scale = (BUCKETS - 1) as f32 / (farthest - nearest).max(f32::MIN_POSITIVE);
        let bucket = |depth: f32| (((farthest - depth) * scale) as usize).min(BUCKETS - 1);
        self.starts.clear();
        self.starts.resize(BUCKETS + 1, 0);
        for &(depth, _) in &self.things {
            self.starts[bucket(depth) + 1] += 1;
        }
        for index in 0..BUCKETS {
            self.starts[index + 1] += self.starts[index];
        }
        self.sorted.clear();
        self.sorted.resize(self.things.len(), 0);
        for &(depth, number) in &self.things {
            let place = &mut self.starts[bucket(depth)];
            if let Some(slot) = self.sorted.get_mut(*place as usize) {
                *slot = number;
            }
            *place += 1;
        }
        &self.sorted
    }
}
