//! The colours, and what they mean.

/// Red, green and blue, 0 to 255 each, sRGB.
pub type Colour = [u8; 3];

/// Behind everything.
pub const BACKGROUND: Colour = [246, 247, 250];
/// Text and marks.
pub(super) const INK: Colour = [44, 50, 62];
/// What shadows are made of.
pub(super) const SHADOW: Colour = [64, 72, 96];
/// A level floor's tiles.
pub(super) const TILES: [Colour; 2] = [[236, 238, 243], [222, 226, 234]];
/// Kinematic particles.
pub(super) const TRACK: Colour = [20, 140, 110];
/// Particles that springs hold.
pub(super) const JOINT: Colour = [88, 98, 118];
/// Particles that nothing holds; neighbours get different ones.
pub(super) const BALLS: [Colour; 6] =
    [[240, 158, 30], [38, 160, 164], [146, 98, 200], [226, 96, 112], [66, 128, 220], [120, 174, 64]];

/// From most compressed to most stretched.
const STRAIN: [Colour; 7] =
    [[16, 66, 200], [52, 118, 224], [110, 150, 206], [118, 124, 136], [214, 136, 112], [230, 84, 52], [204, 22, 30]];

/// The colour that lies at `share` (0 to 1) of the way from one colour to another.
#[must_use]
pub fn blend(from: Colour, to: Colour, share: f32) -> Colour {
    let share = if share > 0.0 { share.min(1.0) } else { 0.0 };
    let mut result = from;
    for (value, goal) in result.iter_mut().zip(to) {
        *value = (f32::from(*value) + (f32::from(goal) - f32::from(*value)) * share + 0.5) as u8;
    }
    result
}

/// The colour of a strain that is this part of the scale's end: −1 most compressed, 0 at rest, 1 most stretched.
#[must_use]
pub fn strain_colour(share: f32) -> Colour {
    let last = STRAIN.len() - 1;
    let place = if share.is_nan() { 0.0 } else { share.clamp(-1.0, 1.0) };
    let place = (place * 0.5 + 0.5) * last as f32;
    let below = (place as usize).min(last - 1);
    blend(STRAIN[below], STRAIN[below + 1], place - below as f32)
}

/// How much strain the ends of the colour scale stand for. It widens and never narrows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrainScale {
    end: f64,
    is_passed: bool,
}

impl Default for StrainScale {
    fn default() -> Self {
        Self { end: 0.05, is_passed: false }
    }
}

impl StrainScale {
    /// The widest scale: at a diverged spring, the colours of the others say nothing anyway.
    const WIDEST: f64 = 10.0;
    /// One spring in this many may go beyond the scale: a few at a cloth's corners would make the rest grey.
    const ONE_IN: usize = 50;

    /// The strain at the scale's end, more than 0.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The strain at the scale's other end: no spring gets shorter than 0, a strain of -1.
    #[must_use]
    pub fn start(&self) -> f64 {
        -self.end.min(1.0)
    }

    /// Whether some spring of the last frame is beyond the scale's end; it has the end's colour.
    #[must_use]
    pub fn is_passed(&self) -> bool {
        self.is_passed
    }

    /// Makes room for these strains but the largest fiftieth: 5 %, 10 %, 20 %, 50 % and so on, up to 1000 %.
    pub fn include(&mut self, strains: &[f64]) {
        loop {
            let beyond = strains.iter().filter(|strain| strain.abs() > self.end).count();
            self.is_passed = beyond > 0;
            let endless = strains.iter().filter(|strain| strain.is_infinite()).count();
            if beyond - endless <= strains.len() / Self::ONE_IN || self.end >= Self::WIDEST {
                return;
            }
            // 5, 10, 20, 50: the step after a 2 is two and a half, the others are two.
            let leading = self.end / 10f64.powf(self.end.log10().floor());
            let factor = if (1.5..3.0).contains(&leading) { 2.5 } else { 2.0 };
            self.end = (self.end * factor * 1e6).round() / 1e6;
        }
    }
}

/// Colours that any picture may come to be made of, whatever its first frame shows: what a palette should hold.
pub(super) fn seeds(has_springs: bool) -> Vec<Colour> {
    let mut seeds = vec![BACKGROUND, INK, TRACK];
    for step in 1..6 {
        seeds.push(blend(INK, BACKGROUND, step as f32 / 6.0));
    }
    for tile in TILES {
        // Steps as fine as eyes see: they make up large areas.
        seeds.extend((0..8).map(|step| blend(tile, BACKGROUND, step as f32 / 8.0)));
    }
    let strains = (0..=16).map(|step| strain_colour(step as f32 / 8.0 - 1.0));
    for colour in strains.filter(|_| has_springs) {
        seeds.extend((0..5).map(|fade| blend(colour, BACKGROUND, fade as f32 * 0.19)));
    }
    seeds
}
