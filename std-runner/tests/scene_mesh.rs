//! Meshes: which particles and springs an OBJ file makes, and how a bad one is refused.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod scene_support;

use hooke_runner::model::{Hold, Model};
use hooke_runner::scene::{Scene, SceneError};
use scene_support::{Folder, assert_says};

const SQUARE: &str = "# two triangles\r\nv 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\ng all\r\nf 1/1/1 2/1/1 3/1/1\r\nf 1//1 3//1 4//1\r\n";

fn load(obj: &str, more: &str) -> Result<Model, SceneError> {
    let folder = Folder::new();
    folder.write("mesh.obj", obj);
    let scene = format!("[[mesh]]\nfile = \"mesh.obj\"\nmass = 0.5\nstiffness = 2\ndamping = 0.25\n{more}");
    Scene::load(&folder.write("scene.toml", scene))?.model()
}

fn between(model: &Model) -> Vec<[u32; 2]> {
    model.springs.iter().map(|spring| spring.between).collect()
}

#[track_caller]
fn refuses(obj: &str, place: &str, value: &str, remedy: &str) {
    let error = load(obj, "").err().unwrap_or_else(|| panic!("loaded:\n{obj}"));
    assert_says(&error, place, value, remedy);
}

#[test]
fn edges_are_unique_and_in_the_order_of_the_file() {
    let model = load(SQUARE, "velocity = [0, 0, 1]").unwrap();
    assert_eq!(between(&model), [[0, 1], [1, 2], [2, 0], [2, 3], [3, 0]]);
    assert_eq!(model.springs[2].rest_length, 2f64.sqrt());
    assert!(model.springs.iter().all(|spring| (spring.stiffness, spring.damping) == (2.0, 0.25)));
    assert!(model.particles.iter().all(|particle| particle.velocity == [0.0, 0.0, 1.0] && particle.mass == 0.5));
    assert_eq!(model.particles[2].position, [1.0, 1.0, 0.0]);
}

#[test]
fn bend_joins_across_shared_edges() {
    let model = load(SQUARE, "bend = { stiffness = 3 }").unwrap();
    assert_eq!(model.springs.len(), 6);
    assert_eq!(model.springs[5].between, [1, 3]);
    assert_eq!((model.springs[5].stiffness, model.springs[5].damping), (3.0, 0.0));
    assert_eq!(model.springs[5].rest_length, 2f64.sqrt());
    // Polygons do not bend, and the same triangle twice shares edges with itself only.
    let quads = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n";
    assert_eq!(load(quads, "bend = { stiffness = 3 }").unwrap().springs.len(), 7);
    let twice = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 3 1 2\n";
    assert_eq!(load(twice, "bend = { stiffness = 3 }").unwrap().springs.len(), 3);
}

#[test]
fn lines_negative_numbers_and_later_vertices_are_read() {
    let model =
        load("f 1 2 3\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nf -1 -2 -3\nv 9 9 9\nl 3 4 -4 # comment\n", "")
            .unwrap();
    assert_eq!(between(&model), [[0, 1], [1, 2], [2, 0], [2, 3], [3, 0]]);
}

#[test]
fn vertices_are_pinned_by_number() {
    let model = load(SQUARE, "pinned = [0, 3]\nvelocity = [1, 0, 0]").unwrap();
    let holds: Vec<Hold> = model.particles.iter().map(|particle| particle.hold).collect();
    assert_eq!(holds, [Hold::Pinned, Hold::Free, Hold::Free, Hold::Pinned]);
    assert_eq!((model.particles[0].velocity, model.particles[1].velocity), ([0.0; 3], [1.0, 0.0, 0.0]));
    let error = load(SQUARE, "pinned = [0, 4]").unwrap_err();
    assert_says(&error, "scene.toml:6:14: `mesh[0].pinned[1]`", "is 4: the mesh has 4 vertices", "exists");
}

#[test]
fn bad_meshes_name_the_line_and_what_is_on_it() {
    let three = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
    refuses(&format!("{three}f 1 2 4\n"), "mesh.obj:4:1", "no vertex 4: the mesh has 3", "count from 1");
    refuses(&format!("{three}f 1 2 0\n"), "mesh.obj:4:1", "no vertex 0", "count from 1");
    refuses(&format!("{three}f 1 2 -4\n"), "mesh.obj:4:1", "no vertex -4", "back from -1");
    refuses(&format!("f -1 2 3\n{three}"), "mesh.obj:1:1", "no vertex -1", "back from -1");
    refuses(&format!("{three}f 1 2 99999999999999999999\n"), "mesh.obj:4:1", "99999999999999999999", "whole numbers");
    refuses(&format!("{three}f a b c\n"), "mesh.obj:4:1", "`a` names no vertex", "whole numbers");
    refuses(
        &format!("{three}f 1 2\n"),
        "mesh.obj:4:1",
        "`f 1 2` names 2 vertices, and needs at least 3",
        "missing vertices",
    );
    refuses(&format!("{three}f 1 1 2\n"), "mesh.obj:4:1", "joins vertex 1 to itself", "repeated");
    refuses("v 0 0\n", "mesh.obj:1:1", "`v 0 0`", "v x y z");
    refuses("v 0 0 0\nv 0 zero 0\n", "mesh.obj:2:1", "`zero` is not a number", "v x y z");
    refuses("v 0 0 nan\n", "mesh.obj:1:1", "NaN", "finite");
    refuses(three, "mesh.obj", "no edges: 3 vertices", "`f` lines");
    refuses("", "mesh.obj", "no edges: 0 vertices", "`l` lines");
}

#[test]
fn mesh_files_that_cannot_be_read_point_at_the_scene() {
    let folder = Folder::new();
    let scene = |file: &str| {
        let path = folder.write("scene.toml", format!("[[mesh]]\nfile = \"{file}\"\nstiffness = 1\n"));
        Scene::load(&path).map(|_| ())
    };
    folder.write("sound.obj", SQUARE);
    scene("sound.obj").unwrap();
    let error = scene("nowhere.obj").unwrap_err();
    assert_says(&error, "scene.toml:2:8: `mesh[0].file`", "\"nowhere.obj\"", "relative to the scene's folder");
    assert!(error.to_string().contains("No such file"), "{error}");
    assert_says(&scene("sound.stl").unwrap_err(), "scene.toml:2:8: `mesh[0].file`", "\"sound.stl\"", "OBJ");
    folder.write("latin.obj", b"# caf\xe9\n");
    assert_says(&scene("latin.obj").unwrap_err(), "`mesh[0].file`", "byte 5 is 0xe9", "UTF-8");
}

#[test]
fn mesh_keys_keep_the_rules() {
    for (line, place) in [
        ("velocity = [nan, 0, 0]", "`mesh[0].velocity`"),
        ("bend = { stiffness = -1 }", "scene.toml:6:22: `mesh[0].bend.stiffness`"),
        ("bend = { stifness = 1 }", "`mesh[0].bend` has no key `stifness`"),
        ("scale = 2", "`mesh[0]` has no key `scale`"),
    ] {
        let error = load(SQUARE, line).unwrap_err();
        assert_says(&error, place, "", "");
    }
}
