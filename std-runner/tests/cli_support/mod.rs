//! What the tests of the command line share.
#![allow(dead_code, reason = "every test file uses some of it")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use assert_cmd::Command;
use npyz::npz::NpzArchive;
use tempfile::TempDir;

/// A rope of a few particles that falls.
pub const ROPE: &str = r#"
gravity = [0.0, 0.0, -9.81]
duration = 0.1
time_step = 1e-3
[[rope]]
from = [0.0, 0.0, 1.0]
to = [1.0, 0.0, 1.0]
particles = 5
mass = 0.01
stiffness = 100.0
damping = 0.01
pinned = ["first"]
"#;

/// A folder with one scene in it.
pub struct Folder(TempDir);

impl Folder {
    pub fn with(scene: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("scene.toml"), scene).unwrap();
        Self(folder)
    }

    pub fn empty() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    pub fn file(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// The names of all files but the scene.
    pub fn made(&self) -> Vec<String> {
        let names = fs::read_dir(self.0.path()).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> = names.filter(|name| name != "scene.toml").collect();
        names.sort();
        names
    }

    /// What `hooke` answers in this folder.
    pub fn hooke(&self, arguments: &[&str]) -> Answer {
        Answer(Command::cargo_bin("hooke").unwrap().current_dir(self.path()).args(arguments).output().unwrap())
    }
}

pub struct Answer(Output);

impl Answer {
    #[track_caller]
    pub fn exits(self, code: i32) -> Self {
        assert_eq!(self.0.status.code(), Some(code), "{}", self.error());
        self
    }

    pub fn output(&self) -> String {
        String::from_utf8(self.0.stdout.clone()).unwrap()
    }

    pub fn error(&self) -> String {
        String::from_utf8(self.0.stderr.clone()).unwrap()
    }

    /// Standard error says all of this.
    #[track_caller]
    pub fn tells(self, parts: &[&str]) -> Self {
        for part in parts {
            assert!(self.error().contains(part), "{part:?} is not in\n{}", self.error());
        }
        self
    }

    /// Standard output says all of this.
    #[track_caller]
    pub fn prints(self, parts: &[&str]) -> Self {
        for part in parts {
            assert!(self.output().contains(part), "{part:?} is not in\n{}", self.output());
        }
        self
    }

    #[track_caller]
    pub fn prints_nothing(self) -> Self {
        assert_eq!(self.output(), "");
        self
    }
}

/// The frames of a CSV recording, every row of which is whole and finite.
pub fn csv_frames(path: &Path) -> usize {
    let text = fs::read_to_string(path).unwrap();
    assert!(text.ends_with('\n'));
    let mut rows = text.lines();
    assert_eq!(rows.next(), Some("frame,time,particle,x,y,z,vx,vy,vz"));
    let mut frames = 0;
    for row in rows {
        let values: Vec<f64> = row.split(',').map(|value| value.parse().unwrap()).collect();
        assert_eq!(values.len(), 9);
        assert!(values.iter().all(|value| value.is_finite()), "{row}");
        frames = values[0] as usize + 1;
    }
    frames
}

/// The frames of an NPZ recording, every array of which is as long.
pub fn npz_frames(path: &Path) -> usize {
    let mut archive = NpzArchive::open(path).unwrap();
    let lengths = ["time", "position", "velocity"].map(|name| archive.by_name(name).unwrap().unwrap().shape()[0]);
    assert_eq!(lengths, [lengths[0]; 3]);
    lengths[0] as usize
}
