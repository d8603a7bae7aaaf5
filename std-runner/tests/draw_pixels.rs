//! What the colours of the pixels say.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs, dead_code)]

mod draw_scenes;

use draw_scenes::{floor, join, particle};
use hooke_runner::draw::{BACKGROUND, Canvas, Colour, Picture, Scenery, StrainScale, strain_colour};
use hooke_runner::model::{CameraChoice, Hold, Model};

const SIZE: [u32; 2] = [320, 240];

/// Face on, without a slope: a metre is 60 pixels at the depth of the origin.
fn face_on() -> CameraChoice {
    CameraChoice {
        position: Some([0.0, -10.0, 0.0]),
        target: Some([0.0; 3]),
        field_of_view: Some(2.0 * 0.2f64.atan().to_degrees()),
        size: Some(SIZE),
        ..CameraChoice::default()
    }
}

/// A row of springs, and its particles' positions when all are this many times as long as at rest.
fn stretched(times: f64) -> (Model, Vec<[f64; 3]>) {
    let mut model = Model::default();
    for number in 0..10 {
        // Half a pixel high, so that a thin line fills its row.
        let (x, z) = ((f64::from(number) - 4.5) * 0.3, 0.5 / 60.0);
        model.particles.push(particle([x, 0.0, z], 1.0, Hold::Free));
    }
    for number in 0..9 {
        join(&mut model, number, number + 1, 10.0, 0.0);
    }
    let position = model.particles.iter().map(|particle| particle.position.map(|x| x * times)).collect();
    (model, position)
}

fn draw(model: &Model, position: &[[f64; 3]], choice: &CameraChoice) -> Canvas {
    Picture::new(Scenery::new(model, draw_scenes::GRAVITY, "test", choice)).draw(0.0, position).clone()
}

/// The pixel in the middle of the fifth spring.
fn middle_pixel(canvas: &Canvas) -> Colour {
    canvas.at(SIZE[0] / 2, SIZE[1] / 2 - 1).unwrap()
}

fn difference(one: Colour, other: Colour) -> u8 {
    (0..3).map(|part| one[part].abs_diff(other[part])).max().unwrap()
}

#[test]
fn strain_is_seen_as_colour() {
    // The scale starts at 5 %: 4 % is four fifths of it.
    for (times, expected) in [(1.04, 0.8), (0.96, -0.8), (1.0, 0.0)] {
        let (model, position) = stretched(times);
        let pixel = middle_pixel(&draw(&model, &position, &face_on()));
        for share in [-0.8f32, 0.0, 0.8] {
            let apart = difference(pixel, strain_colour(share));
            assert_eq!(apart < 24, share == expected, "{times} is {apart} from {share}: {pixel:?}");
        }
    }
}

#[test]
fn a_spring_of_no_rest_length_is_stretched_or_at_rest() {
    for length in [1.0, 0.0] {
        let mut model = Model::default();
        model.particles.push(particle([0.0, 0.0, -0.5], 1.0, Hold::Free));
        model.particles.push(particle([0.0, 0.0, 0.5], 1.0, Hold::Free));
        join(&mut model, 0, 1, 10.0, 0.0);
        model.springs[0].rest_length = 0.0;
        let mut picture = Picture::new(Scenery::new(&model, [0.0; 3], "", &face_on()));
        let canvas = picture.draw(0.0, &[[0.0, 0.0, -0.5 * length], [0.0, 0.0, 0.5 * length]]);
        if length > 0.0 {
            let rows = (60..180).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y)));
            let is_red = |pixel: Colour| pixel[0] > pixel[2].saturating_add(100);
            assert!(rows.filter_map(|(x, y)| canvas.at(x, y)).any(is_red));
        }
        assert_eq!(picture.strain_scale().end(), 0.05, "no finite scale has room for it");
        assert_eq!(picture.strain_scale().is_passed(), length > 0.0);
    }
}

#[test]
fn the_scale_widens_to_round_numbers_and_never_narrows() {
    let mut scale = StrainScale::default();
    for (strain, end) in [(0.01, 0.05), (0.06, 0.1), (-0.15, 0.2), (0.3, 0.5), (-0.9, 1.0), (0.0, 1.0), (1e9, 10.0)] {
        scale.include(&[strain]);
        assert_eq!(scale.end(), end, "{strain}");
    }
    scale = StrainScale::default();
    scale.include(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
    assert_eq!(scale.end(), 0.05);
    // A few extremes among many do not make the rest grey, but are admitted to.
    let mut strains = vec![0.01; 1000];
    strains[7] = 0.8;
    scale.include(&strains);
    assert_eq!((scale.end(), scale.is_passed()), (0.05, true));
    strains.fill(0.8);
    scale.include(&strains);
    assert_eq!((scale.end(), scale.is_passed()), (1.0, false));
}

#[test]
fn the_scale_says_nothing_of_springs_shorter_than_0() {
    let mut scale = StrainScale::default();
    for (strain, start) in [(0.01, -0.05), (0.9, -1.0), (4.0, -1.0), (1e9, -1.0)] {
        scale.include(&[strain]);
        assert_eq!(scale.start(), start, "{strain}");
    }
    assert_eq!(scale.end(), 10.0);
}

#[test]
fn strain_colours_are_blue_grey_and_red() {
    let [compressed, rest, stretched] = [-1.0, 0.0, 1.0].map(strain_colour);
    assert!(compressed[2] > compressed[0] + 100);
    assert!(stretched[0] > stretched[2] + 100);
    assert!(rest.iter().max().unwrap() - rest.iter().min().unwrap() < 30);
    assert_eq!(strain_colour(f32::NAN), rest);
    assert_eq!(strain_colour(9.0), stretched);
}

#[test]
fn a_floor_is_below_the_horizon() {
    let mut model = Model::default();
    model.planes.push(floor(-1.0));
    model.particles.push(particle([0.0, 0.0, -0.9], 1.0, Hold::Free));
    model.particles.push(particle([40.0, 0.0, -0.9], 1.0, Hold::Pinned));
    let canvas = draw(&model, &[], &face_on());
    // The eye looks along the level: the horizon is at half the height.
    let shown = |rows: std::ops::Range<u32>| {
        let pixels = rows.flat_map(|y| (0..SIZE[0]).map(move |x| (x, y)));
        pixels.filter(|(x, y)| canvas.at(*x, *y) != Some(BACKGROUND)).count()
    };
    assert!(shown(150..240) > 60 * 320, "{}", shown(150..240));
    assert_eq!(shown(30..119), 0);
    model.planes.clear();
    let canvas = draw(&model, &[], &face_on());
    assert_eq!(canvas.at(160, 230), Some(BACKGROUND), "no plane, no floor");
}

#[test]
fn a_plane_before_things_lets_them_be_seen() {
    let mut model = Model::default();
    model.particles.push(particle([0.0; 3], 1.0, Hold::Free));
    model.particles.push(particle([1.0, 0.0, 0.0], 1.0, Hold::Free));
    let without = draw(&model, &[[0.0; 3]], &face_on()).at(160, 120).unwrap();
    model.planes.push(hooke_runner::model::ModelPlane {
        point: [0.0, -1.0, 0.0],
        normal: [0.0, 1.0, 0.0],
        restitution: 1.0,
    });
    let canvas = draw(&model, &[[0.0; 3]], &face_on());
    let (ball, wall) = (canvas.at(160, 120).unwrap(), canvas.at(150, 100).unwrap());
    assert_ne!(ball, without, "the plane tints it");
    assert_ne!(ball, wall, "and it shines through");
    assert_ne!(wall, BACKGROUND);
}

#[test]
fn nearer_things_cover_farther_ones() {
    let mut model = Model::default();
    for y in [-2.0, 2.0] {
        model.particles.push(particle([0.0, y, 0.0], 1.0, Hold::Free));
    }
    let front = |position: &[[f64; 3]]| draw(&model, position, &face_on()).at(160, 120).unwrap();
    let one = front(&[[0.0, -2.0, 0.0], [0.0, 2.0, 0.0]]);
    let other = front(&[[0.0, 2.0, 0.0], [0.0, -2.0, 0.0]]);
    let alone = front(&[[0.0, -2.0, 0.0], [f64::NAN; 3]]);
    assert_eq!(one, alone);
    assert_ne!(one, other);
}

#[test]
fn holds_are_marked() {
    let pixel = |hold| {
        let model = Model { particles: vec![particle([0.0; 3], 1.0, hold); 2], ..Model::default() };
        draw(&model, &[[0.0; 3], [1.0, 0.0, 0.0]], &face_on()).at(160, 120).unwrap()
    };
    let (free, pinned, tracked) = (pixel(Hold::Free), pixel(Hold::Pinned), pixel(Hold::Track(0)));
    assert!(free != pinned && pinned != tracked && tracked != free);
}

#[test]
fn a_shadow_lies_below() {
    let mut model = Model::default();
    model.particles.push(particle([0.0, 0.0, 0.0], 1.0, Hold::Free));
    model.particles.push(particle([1.0, 0.0, 0.0], 1.0, Hold::Free));
    model.planes.push(floor(-1.0));
    let choice = CameraChoice { position: Some([0.0, -10.0, 4.0]), ..face_on() };
    let with = draw(&model, &[[0.0; 3]], &choice);
    let without = draw(&model, &[], &choice);
    let scenery = Scenery::new(&model, draw_scenes::GRAVITY, "", &choice);
    let [x, y] = scenery.camera().project([0.0, 0.0, -1.0]).unwrap();
    let at = |canvas: &Canvas| (0..3).map(|rows| canvas.at(x as u32, y as u32 + rows).unwrap()[0]).min().unwrap();
    assert!(at(&with) + 20 < at(&without), "{} {}", at(&with), at(&without));
}

#[test]
fn time_and_name_are_written() {
    let model = stretched(1.0).0;
    let blank = |name: &str, time: f64| {
        let mut picture = Picture::new(Scenery::new(&model, [0.0; 3], name, &face_on()));
        picture.draw::<f64>(time, &[]).clone()
    };
    let (one, other) = (blank("one", 0.0), blank("another", 1.0));
    let differs = |columns: std::ops::Range<u32>| {
        columns.flat_map(|x| (0..30).map(move |y| (x, y))).any(|(x, y)| one.at(x, y) != other.at(x, y))
    };
    assert!(differs(0..100), "the name");
    assert!(differs(200..320), "the time");
    assert!(!differs(120..180), "and nothing between");
}

#[test]
fn single_and_double_precision_look_the_same() {
    let (model, position) = stretched(1.03);
    let single: Vec<[f32; 3]> = position.iter().map(|point| point.map(|x| x as f32)).collect();
    let mut picture = Picture::new(Scenery::new(&model, [0.0; 3], "", &face_on()));
    let double = picture.draw(0.0, &position).clone();
    let single = picture.draw(0.0, &single);
    let apart = double.data().iter().zip(single.data()).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
    assert!(apart <= 3, "{apart}");
}

#[test]
fn six_neighbouring_balls_have_colours_of_their_own() {
    let mut model = Model::default();
    for number in 0..6 {
        model.particles.push(particle([(f64::from(number) - 2.5) * 0.8, 0.0, 0.0], 1.0, Hold::Free));
    }
    let position: Vec<[f64; 3]> = model.particles.iter().map(|particle| particle.position).collect();
    let canvas = draw(&model, &position, &face_on());
    let middle = |number: u32| canvas.at(SIZE[0] / 2 - 120 + 48 * number, SIZE[1] / 2).unwrap();
    for one in 0..6 {
        assert!(difference(middle(one), BACKGROUND) > 24);
        for other in 0..one {
            assert!(difference(middle(one), middle(other)) > 24, "{one} and {other}");
        }
    }
}
