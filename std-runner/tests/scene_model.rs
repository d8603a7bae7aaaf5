//! What scenes are made into: numbers, places, springs and pins.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod scene_support;

use hooke_runner::model::{Hold, Model, ModelSpring};
use hooke_runner::scene::Scene;
use scene_support::{Folder, load, model};

const CLOTH: &str = "[[cloth]]\ncorner = [1, 2, 3]\nedge_u = [2, 0, 0]\nedge_v = [0, 3, 0]\nmass = 0.5\n";
const ALL_FAMILIES: &str =
    "structural = { stiffness = 1 }\nshear = { stiffness = 2, damping = 0.5 }\nbend = { stiffness = 3 }\n";

fn cloth(particles: &str, more: &str) -> Model {
    model(&format!("{CLOTH}particles = {particles}\n{more}"))
}

fn block(particles: &str, more: &str) -> Model {
    model(&format!("[[block]]\ncorner = [0, 0, 0]\nsize = [1, 2, 3]\nparticles = {particles}\nstiffness = 7\n{more}"))
}

fn pinned(model: &Model) -> Vec<usize> {
    let pinned = |(number, particle): (usize, &hooke_runner::model::ModelParticle)| {
        (particle.hold == Hold::Pinned).then_some(number)
    };
    model.particles.iter().enumerate().filter_map(pinned).collect()
}

fn distance(model: &Model, spring: &ModelSpring) -> f64 {
    let [a, b] = spring.between.map(|number| model.particles[number as usize].position);
    a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn generators_make_the_counts_that_geometry_says() {
    for (n, springs) in [(32, 5_826), (64, 23_938)] {
        let model = cloth(&format!("[{n}, {n}]"), ALL_FAMILIES);
        assert_eq!(model.particles.len(), n * n);
        assert_eq!(model.springs.len(), springs);
    }
    assert_eq!(block("[16, 16, 16]", "").springs.len(), 46_620);
    // The smallest: a corner joined with every other.
    assert_eq!(block("[2, 2, 2]", "").springs.len(), 8 * 7 / 2);
    // Too narrow for a second neighbour along u: only the other family of bend.
    assert_eq!(cloth("[2, 3]", "bend = { stiffness = 1 }").springs.len(), 2);
    assert_eq!(cloth("[5, 5]", "").springs.len(), 0);
}

#[test]
fn no_spring_is_made_twice_and_all_start_at_rest() {
    let rope = "[[rope]]\nfrom = [0.1, 0.2, 0.3]\nto = [1.3, -2, 3.1]\nparticles = 17\nstiffness = 1\n";
    for model in [cloth("[7, 9]", ALL_FAMILIES), block("[4, 5, 6]", ""), model(rope)] {
        let mut pairs: Vec<[u32; 2]> = model
            .springs
            .iter()
            .map(|spring| [spring.between[0].min(spring.between[1]), spring.between[0].max(spring.between[1])])
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        assert_eq!(pairs.len(), model.springs.len());
        for spring in &model.springs {
            let distance = distance(&model, spring);
            assert!((spring.rest_length - distance).abs() <= 1e-14 * (1.0 + distance), "{spring:?} {distance}");
        }
    }
}

#[test]
fn springs_of_one_direction_rest_at_one_length_to_the_bit() {
    let model = block("[11, 12, 13]", "");
    let mut lengths: Vec<(u32, u64)> = model
        .springs
        .iter()
        .map(|spring| (spring.between[1].abs_diff(spring.between[0]), spring.rest_length.to_bits()))
        .collect();
    lengths.sort_unstable();
    lengths.dedup();
    assert_eq!(lengths.len(), 13);
}

#[test]
fn cloth_is_numbered_along_u_first() {
    let model = cloth("[3, 4]", "structural = { stiffness = 1 }\nvelocity = [0, 0, 9]");
    assert_eq!(model.particles[0].position, [1.0, 2.0, 3.0]);
    assert_eq!(model.particles[1].position, [2.0, 2.0, 3.0]);
    assert_eq!(model.particles[3 * 2 + 1].position, [2.0, 4.0, 3.0]);
    assert_eq!(model.particles[11].position, [3.0, 5.0, 3.0]);
    assert!(model.particles.iter().all(|particle| particle.mass == 0.5 && particle.velocity == [0.0, 0.0, 9.0]));
    let between: Vec<[u32; 2]> = model.springs.iter().map(|spring| spring.between).collect();
    let along_u = [[0, 1], [1, 2], [3, 4], [4, 5], [6, 7], [7, 8], [9, 10], [10, 11]];
    let along_v = [[0, 3], [1, 4], [2, 5], [3, 6], [4, 7], [5, 8], [6, 9], [7, 10], [8, 11]];
    assert_eq!(between, [&along_u[..], &along_v[..]].concat());
}

#[test]
fn cloth_springs_come_structural_then_shear_then_bend() {
    let model = cloth("[3, 3]", ALL_FAMILIES);
    let laws: Vec<(f64, f64)> = model.springs.iter().map(|spring| (spring.stiffness, spring.damping)).collect();
    assert_eq!(laws, [vec![(1.0, 0.0); 12], vec![(2.0, 0.5); 8], vec![(3.0, 0.0); 6]].concat());
    let shear: Vec<[u32; 2]> = model.springs[12..20].iter().map(|spring| spring.between).collect();
    assert_eq!(shear, [[0, 4], [1, 5], [3, 7], [4, 8], [1, 3], [2, 4], [4, 6], [5, 7]]);
    let bend: Vec<[u32; 2]> = model.springs[20..].iter().map(|spring| spring.between).collect();
    assert_eq!(bend, [[0, 2], [3, 5], [6, 8], [0, 6], [1, 7], [2, 8]]);
}

#[test]
fn block_is_numbered_along_x_then_y_then_z() {
    let model = block("[2, 3, 4]", "");
    for (place, position) in [([1, 0, 0], [1.0, 0.0, 0.0]), ([0, 1, 0], [0.0, 1.0, 0.0]), ([1, 2, 3], [1.0, 2.0, 3.0])]
    {
        let [x, y, z]: [usize; 3] = place;
        assert_eq!(model.particles[(z * 3 + y) * 2 + x].position, position);
    }
}

#[test]
fn pins_hold_what_they_name_and_nothing_else() {
    let rope = |pins: &str| {
        pinned(&model(&format!(
            "[[rope]]\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nparticles = 4\nstiffness = 1\nvelocity = [1, 0, 0]\npinned = {pins}"
        )))
    };
    assert_eq!(rope("[]"), [] as [usize; 0]);
    assert_eq!(rope("[\"first\"]"), [0]);
    assert_eq!(rope("[\"last\", \"first\"]"), [0, 3]);
    for (pins, numbers) in [
        ("\"u0v0\"", vec![0]),
        ("\"u1v0\"", vec![2]),
        ("\"u0v1\"", vec![6]),
        ("\"u1v1\"", vec![8]),
        ("\"u0\"", vec![0, 3, 6]),
        ("\"u1\"", vec![2, 5, 8]),
        ("\"v0\"", vec![0, 1, 2]),
        ("\"v1\"", vec![6, 7, 8]),
        ("[1, 2], \"u0v0\"", vec![0, 7]),
    ] {
        assert_eq!(pinned(&cloth("[3, 3]", &format!("pinned = [{pins}]"))), numbers, "{pins}");
    }
    for (pins, numbers) in [
        ("\"x0\"", vec![0, 2, 4, 6]),
        ("\"x1\"", vec![1, 3, 5, 7]),
        ("\"y0\"", vec![0, 1, 4, 5]),
        ("\"y1\"", vec![2, 3, 6, 7]),
        ("\"z0\"", vec![0, 1, 2, 3]),
        ("\"z1\"", vec![4, 5, 6, 7]),
        ("[1, 0, 1]", vec![5]),
    ] {
        assert_eq!(pinned(&block("[2, 2, 2]", &format!("pinned = [{pins}]"))), numbers, "{pins}");
    }
    let moving = cloth("[3, 3]", "pinned = [\"u0\"]\nvelocity = [1, 2, 3]");
    for particle in &moving.particles {
        let expected = if particle.hold == Hold::Pinned { [0.0; 3] } else { [1.0, 2.0, 3.0] };
        assert_eq!(particle.velocity, expected);
    }
}

#[test]
fn ropes_land_on_round_numbers_and_on_their_ends() {
    let rope =
        |from: &str, to: &str| model(&format!("[[rope]]\nfrom = {from}\nto = {to}\nparticles = 11\nstiffness = 1"));
    let across: Vec<f64> =
        rope("[0, 0, 3]", "[1, 0, 3]").particles.iter().map(|particle| particle.position[0]).collect();
    assert_eq!(across, [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]);
    let slanted = rope("[0.1, 0.7, -3.3]", "[12.3, 0.3, 1e-3]");
    assert_eq!(slanted.particles[0].position, [0.1, 0.7, -3.3]);
    assert_eq!(slanted.particles[10].position, [12.3, 0.3, 1e-3]);
}

#[test]
fn clouds_are_where_the_formula_says() {
    let model = model("[[cloud]]\ncorner = [0, 10, 1]\nsize = [100, 200, 9]\nparticles = 1000\nvelocity = [1, 0, 0]");
    let p: f64 = "1.22074408460575947536".parse().unwrap();
    assert_eq!(model.particles.len(), 1000);
    for (number, particle) in model.particles.iter().enumerate() {
        let along = |corner: f64, size: f64, power: f64| corner + size * (0.5 + (number as f64 + 1.0) / power).fract();
        let expected = [along(0.0, 100.0, p), along(10.0, 200.0, p * p), along(1.0, 9.0, p * p * p)];
        assert_eq!(particle.position, expected);
        assert_eq!((particle.velocity, particle.hold), ([1.0, 0.0, 0.0], Hold::Free));
    }
    // Evenly: an eighth of the box holds an eighth of the cloud, within a hundredth of the cloud.
    let low = |particle: &&hooke_runner::model::ModelParticle| {
        particle.position[0] < 50.0 && particle.position[1] < 110.0 && particle.position[2] < 5.5
    };
    let count = model.particles.iter().filter(low).count();
    assert!((115..=135).contains(&count), "{count}");
}

#[test]
fn kinds_are_numbered_in_the_order_of_the_format_not_of_the_file() {
    let folder = Folder::new();
    folder.write("line.obj", "v 6 0 0\nv 7 0 0\nl 1 2\n");
    let scene = folder.write(
        "scene.toml",
        r#"
[[mesh]]
file = "line.obj"
stiffness = 5
[[cloud]]
corner = [5, 0, 0]
size = [0, 0, 0]
particles = 1
[[block]]
corner = [4, 0, 0]
size = [0.1, 0.1, 0.1]
particles = [2, 2, 2]
stiffness = 4
[[cloth]]
corner = [3, 0, 0]
edge_u = [0.1, 0, 0]
edge_v = [0, 0.1, 0]
particles = [2, 2]
structural = { stiffness = 3 }
[[rope]]
from = [1, 0, 0]
to = [1.5, 0, 0]
particles = 2
stiffness = 1
[[rope]]
from = [2, 0, 0]
to = [2.5, 0, 0]
particles = 2
stiffness = 2
[[spring]]
between = [17, 0]
stiffness = 0.5
[[particle]]
position = [0, 0, 0]
"#,
    );
    let model = Scene::load(&scene).unwrap().model().unwrap();
    let kinds: Vec<u32> = model.particles.iter().map(|particle| particle.position[0] as u32).collect();
    assert_eq!(kinds, [0, 1, 1, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 6, 7]);
    let stiffness: Vec<f64> = model.springs.iter().map(|spring| spring.stiffness).collect();
    assert_eq!(stiffness, [vec![0.5, 1.0, 2.0], vec![3.0; 4], vec![4.0; 28], vec![5.0]].concat());
    assert_eq!(model.springs[0].rest_length, 5.0);
    assert_eq!(model.springs.last().unwrap().between, [18, 19]);
    assert_eq!(model.springs[2].between, [3, 4]);
}

#[test]
fn springs_rest_at_the_start_unless_told() {
    let two = "[[particle]]\nposition = [0, 0, 0]\n[[particle]]\nposition = [3, 4, 0]\nmass = 2\n";
    let model = model(&format!(
        "{two}[[spring]]\nbetween = [1, 0]\nstiffness = 1\n[[spring]]\nbetween = [1, 0]\nstiffness = 1\nrest_length = 0\n"
    ));
    assert_eq!(model.springs.len(), 2);
    assert_eq!(model.springs[0], ModelSpring { between: [1, 0], stiffness: 1.0, damping: 0.0, rest_length: 5.0 });
    assert_eq!(model.springs[1].rest_length, 0.0);
    assert_eq!((model.particles[0].mass, model.particles[1].mass), (1.0, 2.0));
}

#[test]
fn keyframed_particles_start_where_their_track_is_at_time_zero() {
    let particle = |lines: &str| {
        let model = model(&format!("[[particle]]\n{lines}"));
        assert_eq!(model.particles[0].hold, Hold::Track(0));
        (model.particles[0].position, model.particles[0].velocity, model.tracks[0].keys.len())
    };
    let on_a_key = "keyframes = [[0, 1, 2, 3], [2, 1, 2, 4]]";
    assert_eq!(particle(on_a_key), ([1.0, 2.0, 3.0], [0.0, 0.0, 0.5], 2));
    assert_eq!(particle(&format!("position = [1, 2, 3]\n{on_a_key}")), ([1.0, 2.0, 3.0], [0.0, 0.0, 0.5], 2));
    assert_eq!(particle("keyframes = [[-1, 0, 0, 0], [1, 4, 0, 0]]"), ([2.0, 0.0, 0.0], [2.0, 0.0, 0.0], 2));
    assert_eq!(particle("keyframes = [[1, 7, 0, 0], [2, 8, 0, 0]]"), ([7.0, 0.0, 0.0], [0.0; 3], 2));
    assert_eq!(particle("keyframes = [[-2, 7, 0, 0], [-1, 8, 0, 0]]"), ([8.0, 0.0, 0.0], [0.0; 3], 2));
    let model = model(&format!("[[particle]]\n{on_a_key}"));
    assert_eq!(model.tracks[0].keys, [(0.0, [1.0, 2.0, 3.0]), (2.0, [1.0, 2.0, 4.0])]);
}

#[test]
fn normals_become_unit() {
    for normal in ["[0, 0, 5]", "[0, 0, 1e-300]", "[0, 0, 1e150]"] {
        let model = model(&format!("[[plane]]\npoint = [1, 2, 3]\nnormal = {normal}"));
        assert_eq!((model.planes[0].normal, model.planes[0].restitution), ([0.0, 0.0, 1.0], 1.0));
    }
    let slanted = model("[[plane]]\npoint = [0, 0, 0]\nnormal = [3, 0, 4]\nrestitution = 0");
    assert_eq!((slanted.planes[0].normal, slanted.planes[0].restitution), ([0.6000000000000001, 0.0, 0.8], 0.0));
}

#[test]
fn toml_and_json_make_the_same_model() {
    let toml = format!(
        "name = \"both\"\ngravity = [0, 0, -9.81]\ntime_step = 1e-3\n[[particle]]\nposition = [0, 0.25, 1]\nkeyframes = [[0, 0, 0.25, 1]]\n{CLOTH}particles = [3, 4]\npinned = [\"u0\", [1, 2]]\n{ALL_FAMILIES}"
    );
    let json = r#"{
        "name": "both", "gravity": [0, 0, -9.81], "time_step": 1e-3,
        "particle": [{ "position": [0, 0.25, 1], "keyframes": [[0, 0, 0.25, 1]] }],
        "cloth": [{
            "corner": [1, 2, 3], "edge_u": [2, 0, 0], "edge_v": [0, 3, 0], "mass": 0.5, "particles": [3, 4],
            "pinned": ["u0", [1, 2]],
            "structural": { "stiffness": 1 }, "shear": { "stiffness": 2, "damping": 0.5 }, "bend": { "stiffness": 3 }
        }]
    }"#;
    let toml = load("scene.toml", &toml).unwrap();
    let json = load("scene.json", json).unwrap();
    assert_eq!(toml.settings(), json.settings());
    assert_eq!(toml.model().unwrap(), json.model().unwrap());
    assert_eq!(toml.model().unwrap(), toml.model().unwrap());
}

#[test]
fn whole_numbers_serve_where_any_number_does() {
    let whole = model("[[particle]]\nposition = [1, -2, 0x10]\nmass = 1_000\n");
    let point = model("[[particle]]\nposition = [1.0, -2.0, 16.0]\nmass = 1000.0\n");
    assert_eq!(whole, point);
}
