//! `hooke stress` from the command line.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

mod cli_support;

use std::fs;

use cli_support::Folder;

const PAIR: &str = "duration = 0.5\n\
    [[particle]]\nposition = [0.0, 0.0, 0.0]\npinned = true\n\
    [[particle]]\nposition = [1.1, 0.0, 0.0]\n\
    [[spring]]\nbetween = [0, 1]\nstiffness = 40.0\nrest_length = 1.0\n";

#[test]
fn it_tells_limits_and_verdicts_and_writes_all_forms() {
    let folder = Folder::with(PAIR);
    let arguments = ["stress", "scene.toml", "--stepper", "semi-implicit-euler", "--longest", "5"];
    let outputs = ["--out", "all.csv", "--out", "map.svg", "--out", "page.html"];
    let answer = folder.hooke(&[&arguments[..], &outputs[..]].concat()).exits(0);
    // 2/√40 = 0.31623 s; what is found lies up to 5e-4 below.
    answer.prints(&["316.2 ms", "largest stable time step", "battery: the scene made hard", "wedges"]);
    let table = fs::read_to_string(folder.file("all.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0][..5], ["scene", "kind", "stepper", "precision", "group"]);
    let found = rows.iter().find(|row| row[1] == "limit" && row[4] == "found").expect("a limit");
    let limit: f64 = found[10].parse().unwrap();
    assert!((limit * 40.0_f64.sqrt() / 2.0 - 1.0).abs() < 1e-3, "{limit}");
    assert!(rows.iter().any(|row| row[1] == "run") && rows.iter().any(|row| row[1] == "cell"));
    // Of the cells: at the scene's stiffness and without damping, all below the limit are stable, and none above.
    let cells = rows.iter().filter(|row| row[1] == "cell" && row[4] == "undamped");
    for cell in cells {
        let [time_step, stiffness] = [7, 8].map(|column| cell[column].parse::<f64>().unwrap());
        let h = time_step * (40.0 * stiffness).sqrt();
        assert!((h - 2.0).abs() < 0.05 || (h < 2.0) == (cell[9] == "stable"), "{h}: {}", cell[9]);
    }
    let svg = fs::read_to_string(folder.file("map.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("exploded") && svg.contains("time step"));
    let page = fs::read_to_string(folder.file("page.html")).unwrap();
    assert!(page.contains("<svg") && page.contains("Largest stable time step") && !page.contains("http://localhost"));
}

#[test]
fn what_cannot_be_written_to_is_refused_before_anything_is_measured() {
    let folder = Folder::with(PAIR);
    folder.hooke(&["stress", "scene.toml", "--out", "x.png"]).exits(2).tells(&[".csv, .svg and .html"]);
    folder.hooke(&["stress", "scene.toml", "--out", "no/x.csv"]).exits(2).tells(&["no folder"]);
    folder.hooke(&["stress", "none.toml"]).exits(2);
    folder.hooke(&["stress"]).exits(2);
    folder.hooke(&["stress", "scene.toml", "--longest", "-1"]).exits(2);
}
