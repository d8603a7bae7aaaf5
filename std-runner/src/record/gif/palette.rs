//! The GIF's 256 colours.

use crate::draw::Colour;

/// The colours, and which of them is nearest to any other.
#[derive(Clone, Debug, Default)]
pub(super) struct Palette {
    colours: Vec<Colour>,
    /// The number of the nearest colour for each small cube of colours, once it was asked for.
    answers: Vec<u8>,
}

impl Palette {
    /// The number that leaves a pixel as it was.
    pub(super) const UNCHANGED: u8 = 255;

    /// These colours, and the commonest others of a picture that differ enough.
    pub(super) fn new(mut colours: Vec<Colour>, sample: &[[u8; 4]]) -> Self {
        colours.truncate(usize::from(Self::UNCHANGED));
        // First those that differ most from what is there, then ever finer tones.
        let common = by_count(sample);
        for distance in [1500, 300, 80, 20, 1] {
            for &colour in &common {
                if colours.len() >= usize::from(Self::UNCHANGED) {
                    break;
                }
                if colours.iter().all(|other| difference(colour, *other) >= distance) {
                    colours.push(colour);
                }
            }
        }
        // A number that no answer has: nothing is remembered yet.
        let mut answers = vec![Self::UNCHANGED; 1 << 20];
        // The colours themselves stay exact; where two share a cube, the earlier one is the commoner.
        for (number, colour) in colours.iter().enumerate().rev() {
            if let Some(answer) = answers.get_mut(cube(*colour)) {
                *answer = number as u8;
            }
        }
        Self { colours, answers }
    }

    /// Three bytes a colour, 256 of them.
    pub(super) fn bytes(&self) -> Vec<u8> {
        let mut bytes = self.colours.as_flattened().to_vec();
        bytes.resize(256 * 3, 0);
        bytes
    }

    /// The number of the colour nearest to this one.
    #[inline]
    pub(super) fn nearest(&mut self, colour: Colour) -> u8 {
        match self.answers.get(cube(colour)) {
            Some(&number) if number != Self::UNCHANGED => number,
            _ => self.search(colour),
        }
    }

    #[cold]
    fn search(&mut self, colour: Colour) -> u8 {
        // The middle of the cube, so that the answer does not depend on who asks first.
        let [red, green, blue] = colour;
        let middle = [red | 1, green | 1, (blue & !3) | 2];
        let differences = self.colours.iter().map(|other| difference(middle, *other)).enumerate();
        let number = differences.min_by_key(|(_, difference)| *difference).map_or(0, |(number, _)| number);
        if let Some(answer) = self.answers.get_mut(cube(colour)) {
            *answer = number as u8;
        }
        number as u8
    }
}

/// Which cube of colours, two by two by four tones wide, a colour is in.
fn cube([red, green, blue]: Colour) -> usize {
    usize::from(red >> 1) << 13 | usize::from(green >> 1) << 6 | usize::from(blue >> 2)
}

fn code([red, green, blue]: Colour) -> u32 {
    u32::from_be_bytes([0, red, green, blue])
}

/// How different two colours look: squared, with green weighing most and red least.
fn difference(one: Colour, other: Colour) -> i32 {
    let weights = [2, 4, 3];
    (0..3).map(|part| (i32::from(one[part]) - i32::from(other[part])).pow(2) * weights[part]).sum()
}

/// The different colours of a picture, the commonest first.
fn by_count(sample: &[[u8; 4]]) -> Vec<Colour> {
    let mut codes: Vec<u32> = sample.iter().map(|[red, green, blue, _]| code([*red, *green, *blue])).collect();
    codes.sort_unstable();
    let mut counts: Vec<(usize, u32)> =
        codes.chunk_by(|a, b| a == b).filter_map(|run| Some((run.len(), *run.first()?))).collect();
    counts.sort_unstable_by(|a, b| b.cmp(a));
    let colour = |code: u32| {
        let [_, red, green, blue] = code.to_be_bytes();
        [red, green, blue]
    };
    counts.into_iter().map(|(_, code)| colour(code)).collect()
}
