//! A disk that fills up while a recording is made.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]
#![cfg(target_os = "linux")]

use std::io::ErrorKind;
use std::path::Path;
use std::process::Command;

use hooke_runner::record::{Frame, NpzRecorder, Recorder};
use npyz::npz::NpzArchive;

/// A small file system in memory, gone when dropped.
struct SmallDisk(tempfile::TempDir);

impl SmallDisk {
    fn mount() -> Option<Self> {
        let folder = tempfile::tempdir().unwrap();
        let mounted = Command::new("mount")
            .args(["-t", "tmpfs", "-o", "size=1m", "small-disk"])
            .arg(folder.path())
            .output()
            .is_ok_and(|output| output.status.success());
        mounted.then_some(Self(folder))
    }

    fn path(&self) -> &Path {
        self.0.path()
    }
}

impl Drop for SmallDisk {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(self.path()).status();
    }
}

#[test]
fn a_full_disk_is_told_and_the_frames_before_it_are_readable() {
    let Some(disk) = SmallDisk::mount() else {
        eprintln!("SKIPPED: no small file system can be mounted here");
        return;
    };
    let path = disk.path().join("frames.npz");
    let particles = 3000;
    let mut recorder = NpzRecorder::<f32>::create(&path, particles, &[], 1000).unwrap();
    let mut recorded = 0;
    let error = loop {
        let values = vec![[recorded as f32; 3]; particles];
        let frame = Frame { number: recorded, time: recorded as f64, position: &values, velocity: &values };
        match recorder.record(&frame) {
            Ok(()) => recorded += 1,
            Err(error) => break error,
        }
    };
    assert_eq!(error.source.kind(), ErrorKind::StorageFull);
    assert!(error.to_string().contains("frames.npz"));
    assert!((5..20).contains(&recorded), "{recorded} frames fit");
    Recorder::<f32>::finish(Box::new(recorder)).unwrap();

    let mut archive = NpzArchive::open(&path).unwrap();
    for name in ["time", "position", "velocity"] {
        let array = archive.by_name(name).unwrap().unwrap();
        assert_eq!(array.shape()[0], recorded);
    }
    let values = archive.by_name("velocity").unwrap().unwrap();
    let values: Vec<f32> = values.into_vec().unwrap();
    for (frame, values) in values.chunks(3 * particles).enumerate() {
        assert!(values.iter().all(|&value| value == frame as f32));
    }
}
