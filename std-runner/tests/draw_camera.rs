//! The automatic camera shows what will happen, moves back calmly, and does as it is told.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs, dead_code)]

mod draw_scenes;

use draw_scenes::{Motion, Scene};
use hooke_runner::draw::{Picture, Scenery};
use hooke_runner::model::{CameraChoice, Hold, Model};

fn scenery(scene: &Scene, choice: &CameraChoice) -> Scenery {
    Scenery::new(&scene.model, scene.gravity, scene.name, choice)
}

fn is_inside(place: Option<[f64; 2]>, [width, height]: [u32; 2]) -> bool {
    place.is_some_and(|[x, y]| (0.0..f64::from(width)).contains(&x) && (0.0..f64::from(height)).contains(&y))
}

#[test]
fn all_particles_stay_in_the_picture() {
    for scene in draw_scenes::all() {
        let mut picture = Picture::new(scenery(&scene, &CameraChoice::default()));
        let mut motion = Motion::new(&scene);
        for frame in 0..=100 {
            picture.draw(motion.time, &motion.position);
            let camera = picture.camera();
            for (number, position) in motion.position.iter().enumerate() {
                assert!(
                    is_inside(camera.project(*position), camera.size()),
                    "{}: particle {number} is outside in frame {frame}",
                    scene.name
                );
            }
            motion.run(0.02, 50);
        }
    }
}

/// The margin is not had by looking from afar: things fill much of the picture at some time.
#[test]
fn things_are_not_tiny() {
    for scene in draw_scenes::all() {
        let mut picture = Picture::new(scenery(&scene, &CameraChoice::default()));
        let mut motion = Motion::new(&scene);
        let (mut low, mut high) = ([f64::MAX; 2], [f64::MIN; 2]);
        for _ in 0..30 {
            picture.draw(motion.time, &motion.position);
            for position in &motion.position {
                let place = picture.camera().project(*position).unwrap();
                for axis in 0..2 {
                    low[axis] = low[axis].min(place[axis]);
                    high[axis] = high[axis].max(place[axis]);
                }
            }
            motion.run(0.02, 50);
        }
        let largest = ((high[0] - low[0]) / 640.0).max((high[1] - low[1]) / 480.0);
        assert!(largest > 0.4, "{} takes only {largest} of the picture", scene.name);
    }
}

#[test]
fn calm_scenes_keep_their_camera() {
    for scene in [draw_scenes::spring(), draw_scenes::pendulum(), draw_scenes::balls(), draw_scenes::cloud(300)] {
        let mut picture = Picture::new(scenery(&scene, &CameraChoice::default()));
        let before = picture.camera();
        let mut motion = Motion::new(&scene);
        for _ in 0..50 {
            picture.draw(motion.time, &motion.position);
            motion.run(0.02, 50);
        }
        assert_eq!(picture.camera(), before, "{}", scene.name);
    }
}

#[test]
fn camera_moves_back_only_and_without_jumps() {
    let scene = Scene { gravity: [0.0; 3], ..draw_scenes::balls() };
    let mut picture = Picture::new(scenery(&scene, &CameraChoice::default()));
    let start = picture.camera();
    let mut motion = Motion::new(&scene);
    let mut last = 0.0;
    let mut largest = 0.0f64;
    for frame in 0..200 {
        // Out and back again: the camera follows out only.
        motion.position[3][2] = 2.0 + 4.0 * (f64::from(frame) * 0.03).sin();
        picture.draw(f64::from(frame) * 0.02, &motion.position);
        let camera = picture.camera();
        let back: f64 = (0..3).map(|axis| (start.eye()[axis] - camera.eye()[axis]) * start.forward()[axis]).sum();
        assert!(back >= last, "the camera came nearer in frame {frame}");
        largest = largest.max(back - last);
        last = back;
        assert!(is_inside(camera.project(motion.position[3]), camera.size()), "lost in frame {frame}");
    }
    assert!(last > 0.5, "it should have moved: {last}");
    assert!(largest < 0.15 * last, "it jumped by {largest} of {last}");
}

#[test]
fn what_flies_off_for_good_does_not_make_the_rest_invisible() {
    let scene = draw_scenes::balls();
    let mut picture = Picture::new(scenery(&scene, &CameraChoice::default()));
    let mut motion = Motion::new(&scene);
    for frame in 0..200 {
        motion.position[3][0] = 1.05f64.powi(frame);
        picture.draw(f64::from(frame) * 0.02, &motion.position);
    }
    let [left, right] = [0, 6].map(|number| picture.camera().project(motion.position[number]).unwrap()[0]);
    assert!(right - left > 80.0, "{left} to {right}");
}

#[test]
fn flat_scenes_are_seen_face_on_and_a_little_from_above() {
    for scene in [draw_scenes::spring(), draw_scenes::pendulum(), draw_scenes::balls(), draw_scenes::rope()] {
        let forward = scenery(&scene, &CameraChoice::default()).camera().forward();
        assert!(forward[0].abs() < 0.01 && forward[1] > 0.95, "{}: {forward:?}", scene.name);
        assert!(forward[2] < -0.05, "{}: {forward:?}", scene.name);
    }
    let block = scenery(&draw_scenes::cloud(300), &CameraChoice::default()).camera().forward();
    assert!(block[0].abs() > 0.2 && block[1].abs() > 0.2, "three-quarters: {block:?}");
}

#[test]
fn up_is_against_gravity() {
    let mut scene = draw_scenes::cloud(100);
    scene.gravity = [0.0, -9.81, 0.0];
    assert!(scenery(&scene, &CameraChoice::default()).camera().up()[1] > 0.8);
    scene.gravity = [0.0; 3];
    assert!(scenery(&scene, &CameraChoice::default()).camera().up()[2] > 0.8);
}

#[test]
fn every_part_can_be_chosen() {
    let scene = draw_scenes::cloth(8);
    let choice = CameraChoice {
        position: Some([5.0, -1.0, 3.0]),
        target: Some([0.5, 0.5, 1.5]),
        up: Some([0.0, 1.0, 0.0]),
        field_of_view: Some(50.0),
        size: Some([320, 200]),
    };
    let mut picture = Picture::new(scenery(&scene, &choice));
    let far: Vec<[f64; 3]> = scene.model.particles.iter().map(|particle| particle.position.map(|x| x * 3.0)).collect();
    let canvas = picture.draw(0.0, &far);
    assert_eq!([canvas.width(), canvas.height()], [320, 200]);
    let camera = picture.camera();
    assert_eq!(camera.eye(), [5.0, -1.0, 3.0], "a chosen eye stays");
    let [x, y] = camera.project([0.5, 0.5, 1.5]).unwrap();
    assert!((x - 160.0).abs() < 1e-6 && (y - 100.0).abs() < 1e-6);
    assert!((camera.field_of_view() - 50.0).abs() < 1e-9);
    assert!(camera.up()[1] > 0.8);
}

#[test]
fn one_part_chosen_leaves_the_others_sensible() {
    let scene = draw_scenes::cloth(8);
    let choices = [
        CameraChoice { position: Some([4.0, -3.0, 2.0]), ..CameraChoice::default() },
        CameraChoice { target: Some([0.5, 0.0, 1.5]), ..CameraChoice::default() },
        CameraChoice { up: Some([1.0, 0.0, 0.0]), ..CameraChoice::default() },
        CameraChoice { field_of_view: Some(90.0), ..CameraChoice::default() },
        CameraChoice { size: Some([200, 600]), ..CameraChoice::default() },
    ];
    for choice in choices {
        let camera = scenery(&scene, &choice).camera();
        for particle in &scene.model.particles {
            assert!(is_inside(camera.project(particle.position), camera.size()), "{choice:?}");
        }
    }
}

/// The check itself: a camera that looks away shows nothing.
#[test]
fn a_camera_that_looks_away_sees_nothing() {
    let scene = draw_scenes::cloth(8);
    let choice =
        CameraChoice { position: Some([0.0, -5.0, 1.0]), target: Some([0.0, -6.0, 1.0]), ..CameraChoice::default() };
    let camera = scenery(&scene, &choice).camera();
    assert!(scene.model.particles.iter().all(|particle| !is_inside(camera.project(particle.position), camera.size())));
}

#[test]
fn nothing_is_too_odd() {
    let odd = [f64::NAN, f64::INFINITY, 1e30, -1e300, 0.0];
    let one =
        |position| Model { particles: vec![draw_scenes::particle(position, 1.0, Hold::Free)], ..Model::default() };
    let same = Model { particles: vec![draw_scenes::particle([1.0; 3], 1.0, Hold::Pinned); 9], ..Model::default() };
    let mut models = vec![Model::default(), one([0.0; 3]), same];
    models.extend(odd.map(|value| one([value, 0.0, value])));
    let mut cloth = draw_scenes::cloth(8).model;
    for (number, value) in odd.into_iter().enumerate() {
        cloth.particles[number * 7].position[number % 3] = value;
        cloth.springs[number].rest_length = value;
        cloth.springs[number + 9].stiffness = value;
    }
    cloth.springs[30].between = [0, 4_000_000_000];
    cloth.planes.push(draw_scenes::floor(f64::NAN));
    cloth.planes.push(draw_scenes::floor(0.0));
    models.push(cloth);
    for model in models {
        for gravity in [draw_scenes::GRAVITY, [0.0; 3], [f64::NAN; 3], [f64::INFINITY, 0.0, 0.0], [1e30, 0.0, 1e-30]] {
            let size = Some([64, 48]);
            let choice = CameraChoice { size, ..CameraChoice::default() };
            let mut picture = Picture::new(Scenery::new(&model, gravity, "odd\n\u{7}\u{1F600}", &choice));
            let mut position: Vec<[f64; 3]> = model.particles.iter().map(|particle| particle.position).collect();
            for (frame, value) in odd.into_iter().enumerate() {
                if let Some(last) = position.last_mut() {
                    last[frame % 3] = value;
                }
                let canvas = picture.draw(value, &position);
                assert_eq!([canvas.width(), canvas.height()], [64, 48]);
                // Fewer and more particles than the model has.
                picture.draw(0.0, &position[position.len() / 2..]);
                picture.draw(0.0, &vec![[value; 3]; position.len() + 3]);
            }
        }
    }
}

#[test]
fn odd_choices_are_survived() {
    let scene = draw_scenes::jelly();
    let nan = Some([f64::NAN; 3]);
    let choices = [
        CameraChoice { position: nan, target: nan, up: nan, field_of_view: Some(f64::NAN), size: Some([0, 0]) },
        CameraChoice { position: Some([0.0; 3]), target: Some([0.0; 3]), ..CameraChoice::default() },
        CameraChoice { position: Some([0.2, 0.2, 0.8]), size: Some([1, 5]), ..CameraChoice::default() },
        CameraChoice { up: Some([0.0; 3]), field_of_view: Some(180.0), ..CameraChoice::default() },
        CameraChoice { up: Some([0.0, 1.0, 0.0]), field_of_view: Some(1e-9), ..CameraChoice::default() },
    ];
    let position: Vec<[f64; 3]> = scene.model.particles.iter().map(|particle| particle.position).collect();
    for choice in choices {
        Picture::new(scenery(&scene, &choice)).draw(0.0, &position);
    }
}
