//! The GIF's 256 colours.

use crate::draw::{Colour, palette_seeds};

/// The colours, and which of them is nearest to any other.
#[derive(Clone, Debug, Default)]
pub(super) struct Palette {
    colours: Vec<Colour>,
    /// Answers given: the colour asked for in the upper 24 bits, its number in the lower 8.
    answers: Vec<u32>,
}

/// How many answers are remembered.
const ANSWERS: usize = 1 << 16;

impl Palette {
    /// The number that leaves a pixel as it was.
    pub(super) const UNCHANGED: u8 = 255;

    /// The colours of all pictures, and the commonest others of this one that differ enough.
    pub(super) fn new(sample: &[[u8; 4]]) -> Self {
        let mut colours = palette_seeds();
        colours.truncate(usize::from(Self::UNCHANGED));
        // First those that differ most from what is there, then ever finer tones.
        let common = by_count(sample);
        for distance in [1500, 300, 80, 20, 1] {
            for &colour in &common {
                if colours.len() >= usize::from(Self::UNCHANGED) {
                    break;
                }
                if colours
                    .iter()
                    .all(|other| difference(colour, *other) >= distance)
                {
                    colours.push(colour);
                }
            }
        }
        // A number that no answer has: nothing is remembered yet.
        Self {
            colours,
            answers: vec![u32::from(Self::UNCHANGED); ANSWERS],
        }
    }

    /// Three bytes a colour, 256 of them.
    pub(super) fn bytes(&self) -> Vec<u8> {
        let mut bytes = self.colours.as_flattened().to_vec();
        bytes.resize(256 * 3, 0);
        bytes
    }

    /// The number of the colour nearest to this one.
    pub(super) fn nearest(&mut self, colour: Colour) -> u8 {
        let code = code(colour);
        let slot = (code.wrapping_mul(0x9E37_79B1) >> 16) as usize % ANSWERS;
        if let Some(answer) = self.answers.get(slot)
            && answer >> 8 == code
            && *answer as u8 != Self::UNCHANGED
        {
            return *answer as u8;
        }
        let differences = self.colours.iter().map(|other| difference(colour, *other));
        let number = differences
            .enumerate()
            .min_by_key(|(_, difference)| *difference)
            .map_or(0, |(number, _)| number);
        if let Some(answer) = self.answers.get_mut(slot) {
            *answer = code << 8 | number as u32;
        }
        number as u8
    }
}

fn code([red, green, blue]: Colour) -> u32 {
    u32::from_be_bytes([0, red, green, blue])
}

/// How different two colours look: squared, with green weighing most and red least.
fn difference(one: Colour, other: Colour) -> i32 {
    let weights = [2, 4, 3];
    (0..3)
        .map(|part| (i32::from(one[part]) - i32::from(other[part])).pow(2) * weights[part])
        .sum()
}

/// The different colours of a picture, the commonest first.
fn by_count(sample: &[[u8; 4]]) -> Vec<Colour> {
    let mut codes: Vec<u32> = sample
        .iter()
        .map(|[red, green, blue, _]| code([*red, *green, *blue]))
        .collect();
    codes.sort_unstable();
    let mut counts: Vec<(usize, u32)> = codes
        .chunk_by(|a, b| a == b)
        .filter_map(|run| Some((run.len(), *run.first()?)))
        .collect();
    counts.sort_unstable_by(|a, b| b.cmp(a));
    let colour = |code: u32| {
        let [_, red, green, blue] = code.to_be_bytes();
        [red, green, blue]
    };
    counts.into_iter().map(|(_, code)| colour(code)).collect()
}
