//! Generators that cannot make what they ask for are refused with the place, the value and the remedy.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod scene_support;

use scene_support::{SOUND, assert_says, load, refuses};

#[test]
fn generators_need_two_particles_a_side() {
    let rope = |n: &str| format!("[[rope]]\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nparticles = {n}\nstiffness = 1");
    refuses(&rope("1"), ":4:13: `rope[0].particles`", "is 1", "2 or more");
    refuses(&rope("-3"), ":4:13: `rope[0].particles`", "-3", "a whole number");
    refuses(&rope("2.5"), ":4:13: `rope[0].particles`", "2.5", "a whole number");
    let cloth =
        |n: &str| format!("[[cloth]]\ncorner = [0, 0, 0]\nedge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\nparticles = {n}");
    refuses(&cloth("[1, 5]"), ":5:13: `cloth[0].particles`", "[1, 5]", "2 whole numbers, each 2 or more");
    refuses(&cloth("[5, 0]"), "`cloth[0].particles`", "[5, 0]", "2 or more");
    let block = |n: &str| format!("[[block]]\ncorner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = {n}\nstiffness = 1");
    refuses(&block("[2, 2, 1]"), ":4:13: `block[0].particles`", "[2, 2, 1]", "3 whole numbers, each 2 or more");
    let cloud = |n: &str| format!("[[cloud]]\ncorner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = {n}");
    refuses(&cloud("0"), ":4:13: `cloud[0].particles`", "is 0", "1 or more");
    for sound in [rope("2"), cloth("[2, 2]"), block("[2, 2, 2]"), cloud("1")] {
        load("scene.toml", &sound).unwrap();
    }
}

#[test]
fn generators_keep_the_rules_of_what_they_make() {
    let tables = [
        ("rope", "from = [0, 0, 0]\nto = [1, 0, 0]\nparticles = 2\nstiffness = 1"),
        ("cloth", "corner = [0, 0, 0]\nedge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\nparticles = [2, 2]"),
        ("block", "corner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = [2, 2, 2]\nstiffness = 1"),
        ("cloud", "corner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = 2"),
    ];
    for (key, lines) in tables {
        let with = |line: &str| format!("[[{key}]]\n{lines}\n{line}");
        load("scene.toml", &with("mass = 2\nvelocity = [1, 2, 3]")).unwrap();
        refuses(&with("mass = 0"), &format!("`{key}[0].mass`"), "0.0", "more than 0");
        refuses(&with("velocity = [nan, 0, 0]"), &format!("`{key}[0].velocity`"), "NaN", "three finite");
        refuses(&with("sped = 1"), &format!("`{key}[0]`"), "`sped`", "The keys here are");
        let broken = with("").replace("[0, 0, 0]", "[0, inf, 0]");
        refuses(&broken, &format!("`{key}[0]."), "inf", "three finite");
    }
    for (key, lines) in [tables[0], tables[2]] {
        refuses(&format!("[[{key}]]\n{lines}\ndamping = -1"), &format!("`{key}[0].damping`"), "-1.0", "0 or more");
        let negative = lines.replace("stiffness = 1", "stiffness = -1");
        refuses(&format!("[[{key}]]\n{negative}"), &format!("`{key}[0].stiffness`"), "-1.0", "0 or more");
    }
    for family in ["structural", "shear", "bend"] {
        let cloth = format!("[[cloth]]\n{}\n{family} = {{ stiffness = 1, damping = nan }}", tables[1].1);
        refuses(
            &cloth,
            &format!("scene.toml:6:{}: `cloth[0].{family}.damping`", family.len() + 31),
            "NaN",
            "0 or more",
        );
    }
}

#[test]
fn pins_are_in_the_grid() {
    let rope = "[[rope]]\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nparticles = 4\nstiffness = 1\n";
    refuses(&format!("{rope}pinned = [\"frist\"]"), ":6:11: `rope[0].pinned[0]`", "\"frist\"", "Did you mean `first`?");
    refuses(&format!("{rope}pinned = \"first\""), "`rope[0].pinned`", "\"first\"", "write a list");
    let cloth = "[[cloth]]\ncorner = [0, 0, 0]\nedge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\nparticles = [4, 5]\n";
    refuses(&format!("{cloth}pinned = [\"u0\", \"u2v0\"]"), ":6:17: `cloth[0].pinned[1]`", "\"u2v0\"", "\"u0v0\"");
    refuses(
        &format!("{cloth}pinned = [[0, 5]]"),
        ":6:11: `cloth[0].pinned[0]`",
        "[0, 5]: the places go from [0, 0] to [3, 4]",
        "exists",
    );
    refuses(&format!("{cloth}pinned = [[0, 1, 2]]"), "`cloth[0].pinned[0]`", "a list of 3", "2 whole numbers");
    refuses(&format!("{cloth}pinned = [[0]]"), "`cloth[0].pinned[0]`", "a list of 1", "2 numbers");
    refuses(&format!("{cloth}pinned = [true]"), "`cloth[0].pinned[0]`", "`true`", "a name in double quotes or a list");
    let block = "[[block]]\ncorner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = [2, 3, 4]\nstiffness = 1\n";
    refuses(&format!("{block}pinned = [\"w0\"]"), "`block[0].pinned[0]`", "\"w0\"", "\"x0\", \"x1\"");
    refuses(&format!("{block}pinned = [[1, 2, 4]]"), "`block[0].pinned[0]`", "[1, 2, 4]", "exists");
    load("scene.toml", &format!("{block}pinned = [[1, 2, 3], \"z1\"]")).unwrap();
}

#[test]
fn scenes_larger_than_memory_are_refused_before_they_are_made() {
    let cloud = "[[cloud]]\ncorner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = 4_000_000_000\n";
    let error = load("scene.toml", cloud).unwrap().model().unwrap_err();
    assert_says(&error, "scene.toml", "4000000000 particles", "fewer");
    assert!(error.to_string().contains("640 GB"), "{error}");

    let too_many = load("scene.toml", &format!("{cloud}{cloud}")).unwrap();
    assert_says(&too_many.model().unwrap_err(), "scene.toml", "8000000000 particles, and at most 4294967295", "fewer");

    let block = "[[block]]\ncorner = [0, 0, 0]\nsize = [1, 1, 1]\nparticles = [4_000_000_000, 4_000_000_000, 4_000_000_000]\nstiffness = 1";
    let error = load("scene.toml", block).unwrap().model().unwrap_err();
    assert_says(&error, "scene.toml", "64000000000000000000000000000 particles", "fewer");

    // 3e8 particles can be numbered, the springs between them cannot.
    let springs = block.replace("[4_000_000_000, 4_000_000_000, 4_000_000_000]", "[1000, 1000, 400]");
    let error = load("scene.toml", &springs).unwrap().model().unwrap_err();
    assert_says(&error, "scene.toml", "springs, and at most 4294967295", "fewer");

    let small = load("scene.toml", SOUND).unwrap();
    assert_eq!(small.model_within(320).unwrap().particles.len(), 2);
    let error = small.model_within(319).unwrap_err();
    assert_says(&error, "scene.toml", "need 320 bytes of memory, and 319 bytes are available", "memory");
}
