//! `hooke bench` on the command line: what it writes, what it takes up again, whom it measures itself against.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

mod cli_support;

use std::fs;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use cli_support::{Folder, ROPE};

/// The rows of a table, cell by cell; the head first.
fn rows(folder: &Folder, name: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(folder.file(name)).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

fn column(rows: &[Vec<String>], name: &str) -> Vec<String> {
    let column = rows[0].iter().position(|head| head == name).expect(name);
    rows[1..].iter().map(|row| row[column].clone()).collect()
}

#[test]
fn several_scenes_make_one_report_in_every_form() {
    let folder = Folder::with(ROPE);
    fs::write(folder.file("ball.toml"), "duration = 1.0\ngravity = [0.0, 0.0, -9.81]\n[[particle]]\nposition = [0.0, 0.0, 1.0]\n[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\nrestitution = 0.5\n").unwrap();
    let outs = ["--out", "a.csv", "--out", "a.svg", "--out", "a.html", "--longest", "0.0001"];
    folder.hooke(&[&["bench", "scene.toml", "ball.toml"], &outs[..]].concat()).exits(0).prints(&[
        "scene\n",
        "ball\n",
        "closed form: agrees to",
        "take ",
    ]);
    let rows = rows(&folder, "a.csv");
    let (scenes, forms) = (column(&rows, "scene"), column(&rows, "collision"));
    assert!(scenes.iter().zip(&forms).all(|(scene, form)| (scene == "scene") == form.is_empty()));
    for form in ["reflect", "project", "time-of-impact"] {
        assert!(forms.iter().any(|found| found == form), "{form}");
    }
    // Who chooses steps has a tolerance, and nobody else; of the forms of collision only the one within steps is tried.
    let (steppers, tolerances) = (column(&rows, "stepper"), column(&rows, "tolerance"));
    for (tolerance, (stepper, form)) in tolerances.iter().zip(steppers.iter().zip(&forms)) {
        let is_known = ["dop853", "dormand-prince-rkn8"].contains(&stepper.as_str());
        assert!(tolerance.is_empty() || is_known && !["reflect", "project"].contains(&form.as_str()));
    }
    assert!(tolerances.iter().any(|tolerance| tolerance.parse() == Ok(0.01)), "{tolerances:?}");
    // Diverged runs have times, and no errors.
    let (errors, survived) = (column(&rows, "error"), column(&rows, "survived"));
    let ended = |survived: &String| survived.parse::<f64>().unwrap() < 1.0;
    assert!(errors.iter().zip(&survived).all(|(error, survived)| !ended(survived) || error.is_empty()));
    let page = fs::read_to_string(folder.file("a.html")).unwrap();
    assert!(page.starts_with("<!DOCTYPE html>") && page.matches("<h2").count() == 2, "{page}");
    // Two diagrams of the rope and six of the ball in four figures, and two over time for each.
    assert_eq!(page.matches("<svg").count(), 8);
    assert!(fs::read_to_string(folder.file("a.svg")).unwrap().starts_with("<svg"));
}

#[test]
fn a_measurement_is_taken_up_again_where_it_still_holds() {
    let folder = Folder::with(ROPE);
    let go = ["bench", "scene.toml", "--longest", "0.0001", "--out", "runs.csv"];
    folder.hooke(&go).exits(0);
    let before = rows(&folder, "runs.csv");
    let again = [&go[..], &["--resume", "runs.csv"]].concat();
    folder.hooke(&again).exits(0).tells(&[&format!("{} runs of runs.csv still hold", before.len() - 1)]);
    // The times too, to the last digit: nothing was measured again. A run that came out a little shorter than --longest when
    // it was repeated may be followed by one more.
    let holds = |kept: &[Vec<String>], after: &[Vec<String>]| kept.iter().all(|row| after.contains(row));
    assert!(holds(&before, &rows(&folder, "runs.csv")));

    // Half of them lost: the other half is kept as it is. That half is read back, as runs that were added above moved the rest.
    let text = fs::read_to_string(folder.file("runs.csv")).unwrap();
    let half: Vec<&str> = text.lines().take(2 + before.len() / 2).collect();
    fs::write(folder.file("half.csv"), half.join("\n") + "\n").unwrap();
    let kept = rows(&folder, "half.csv");
    assert!(kept.len() > 1);
    folder.hooke(&[&go[..], &["--resume", "half.csv"]].concat()).exits(0);
    let after = rows(&folder, "runs.csv");
    assert!(holds(&kept, &after));
    assert!(!holds(&before, &after), "times of runs that were measured anew");

    // Another scene: nothing of it holds.
    let other = [&again[..], &["--duration", "0.11"]].concat();
    folder.hooke(&other).exits(0).tells(&["0 runs of runs.csv still hold", "of another scene, program or machine"]);
    assert_ne!(column(&before, "stamp")[0], column(&rows(&folder, "runs.csv"), "stamp")[0]);
    folder.hooke(&["bench", "scene.toml", "--resume", "none.csv"]).exits(2).tells(&["--resume none.csv"]);
    folder.hooke(&["bench", "scene.toml", "--resume", "scene.toml"]).exits(2).tells(&["--out FILE.csv"]);
}

/// What was measured before Ctrl-C is told and written, the runs of the contender that it came in too; and it can be taken up
/// again.
#[test]
fn interrupting_keeps_what_is_done() {
    let folder = Folder::with(&ROPE.replace("duration = 0.1", "duration = 1.0"));
    let child = Command::new(env!("CARGO_BIN_EXE_hooke"))
        .current_dir(folder.path())
        // Seconds for each contender.
        .args(["bench", "scene.toml", "--longest", "1", "--out", "a.csv"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Its reference takes some hundredths of that.
    thread::sleep(Duration::from_secs(2));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    let told = String::from_utf8(output.stdout).unwrap();
    assert!(told.contains("interrupted: not all has been measured"), "{told}");
    let made = rows(&folder, "a.csv").len() - 1;
    assert!(made > 0);
    let again = ["bench", "scene.toml", "--longest", "0.0001", "--resume", "a.csv"];
    folder.hooke(&again).exits(0).tells(&[&format!("{made} run"), "of a.csv still hold"]);
}

#[test]
fn peers_are_put_on_the_same_axes() {
    let folder = Folder::with(&ROPE.replace("duration = 0.1", "duration = 1.0"));
    fs::write(
        folder.file("peers.csv"),
        "date,machine,table,scene,peer,name,version,equation,scheme,setting,steps,repeats,unit,minimum,median,error_m,order,note\n\
         d,m,accuracy,scene,Hooke,hooke:velocity-verlet:f64,v,same,Verlet,0.001,,7,ms,1e9,1e9,1e-5,,\n\
         d,m,accuracy,scene,\"Other, f64\",other,v,same,RK4,0.001,,7,ms,2e9,2e9,1e-5,,\n\
         d,m,springs,scene,Not this,x,v,same,RK4,0.001,,7,ns,5,5,1e-5,,\n\
         d,m,accuracy,elsewhere,Nor this,x,v,same,RK4,0.001,,7,ms,5,5,1e-5,,\n",
    )
    .unwrap();
    let go = ["bench", "scene.toml", "--longest", "0.0001", "--against", "peers.csv", "--out", "a.svg"];
    let answer =
        folder.hooke(&go).exits(0).prints(&["fastest of others", "Other, f64", "2000000 s", "times as long there"]);
    assert!(!answer.output().contains("Not this") && !answer.output().contains("Nor this"));
    let picture = fs::read_to_string(folder.file("a.svg")).unwrap();
    assert!(picture.contains("Other, f64") && !picture.contains("Not this"));
    // They ran for a second.
    folder.hooke(&[&go[..], &["--duration", "0.5"]].concat()).exits(2).tells(&["--duration 1"]);
    folder.hooke(&["bench", "scene.toml", "--against", "scene.toml"]).exits(2).tells(&["benches/peers/run"]);
}

#[test]
fn places_that_cannot_be_written_are_refused_before_anything_runs() {
    let folder = Folder::with(ROPE);
    for (out, said) in [
        ("runs.gif", ".csv, .svg and .html"),
        ("runs", ".csv, .svg and .html"),
        ("scene.toml", ".csv"),
        ("no/a.csv", "mkdir -p no"),
    ] {
        folder.hooke(&["bench", "scene.toml", "--out", out]).exits(2).tells(&[said]);
    }
    folder.hooke(&["bench", "scene.toml", "--out", "a.csv", "--out", "a.csv"]).exits(2).tells(&["given twice"]);
    folder.hooke(&["bench"]).exits(2);
    assert!(folder.made().is_empty());
}
