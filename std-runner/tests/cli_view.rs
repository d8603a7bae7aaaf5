//! `hooke view`: what it answers a browser, and how it ends.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod cli_support;

use std::io::{BufRead, BufReader, Lines, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::{Child, ChildStderr, Command, Stdio};

use cli_support::{Folder, ROPE};

/// Particles of the rope, and its frames at 60 a second: 0 to 6 sixtieths.
const PARTICLES: usize = 5;
const FRAMES: usize = 7;
/// Eight numbers of 64 bits, then positions of three of 32 bits.
const BYTES: usize = 8 * 8 + PARTICLES * 12;

struct Viewed {
    child: Child,
    address: SocketAddr,
    /// What it said before its address.
    before: Vec<String>,
    /// What it says after it.
    said: Lines<BufReader<ChildStderr>>,
}

impl Viewed {
    fn scene(folder: &Folder, flags: &[&str]) -> Self {
        let mut child = Command::new(assert_cmd::cargo::cargo_bin("hooke"))
            .current_dir(folder.path())
            .args(["view", "scene.toml", "--no-open"])
            .args(flags)
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut said = BufReader::new(child.stderr.take().unwrap()).lines();
        let mut before = Vec::new();
        let address = said.by_ref().map_while(Result::ok).find_map(|line| {
            let address = line.strip_prefix("http://").map(|address| address.trim_end_matches('/').parse().unwrap());
            before.push(line);
            address
        });
        Self { child, address: address.unwrap(), before, said }
    }

    /// The status and the body of an answer to a browser that asks for `host`, with other lines of its own.
    fn asked_as(&self, path: &str, host: &str, headers: &str) -> (u16, Vec<u8>) {
        let mut stream = TcpStream::connect(self.address).unwrap();
        write!(stream, "GET {path} HTTP/1.1\r\nHost: {host}\r\n{headers}Connection: close\r\n\r\n").unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let head = answer.windows(4).position(|four| four == b"\r\n\r\n").unwrap();
        let (headers, body) = (String::from_utf8_lossy(&answer[..head]).to_lowercase(), &answer[head + 4..]);
        let status = headers.split(' ').nth(1).unwrap().parse().unwrap();
        let is_chunked = headers.contains("transfer-encoding: chunked");
        (status, if is_chunked { unchunked(body) } else { body.to_vec() })
    }

    fn asked(&self, path: &str) -> (u16, Vec<u8>) {
        self.asked_as(path, &self.address.to_string(), "")
    }

    /// Ends it: all that it said after its address.
    fn ended(mut self) -> String {
        self.child.kill().unwrap();
        self.said.by_ref().map_while(Result::ok).collect::<Vec<_>>().join("\n")
    }
}

impl Drop for Viewed {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn unchunked(mut rest: &[u8]) -> Vec<u8> {
    let mut body = Vec::new();
    while let Some(end) = rest.windows(2).position(|two| two == b"\r\n") {
        let size = usize::from_str_radix(std::str::from_utf8(&rest[..end]).unwrap().trim(), 16).unwrap();
        body.extend_from_slice(&rest[end + 2..end + 2 + size]);
        rest = &rest[(end + 4 + size).min(rest.len())..];
    }
    body
}

#[test]
fn it_says_where_a_run_would_take_other_steps() {
    let folder = Folder::with(ROPE);
    let says =
        |flags: &[&str]| Viewed::scene(&folder, flags).before.concat().contains("stepper and time step are open");
    assert!(says(&["--time-step", "auto"]));
    assert!(!says(&[]) && !says(&["--time-step", "auto", "--stepper", "velocity-verlet"]));
}

#[test]
fn it_serves_the_page_the_scene_and_every_frame_of_the_run() {
    let viewed = Viewed::scene(&Folder::with(ROPE), &["--precision", "f32"]);
    let (status, page) = viewed.asked("/");
    assert_eq!(status, 200);
    let page = String::from_utf8(page).unwrap();
    assert!(page.contains("hooke-desktop"), "the page does not know where it comes from");
    // Everything that the page and its modules name is there.
    for file in ["style.css", "icon.svg", "js/main.js", "hooke/index.js", "hooke/hooke-simd.wasm", "wasm/scene.wasm"] {
        assert_eq!(viewed.asked(&format!("/{file}")).0, 200, "{file}");
    }
    assert_eq!(viewed.asked("/js/other.js").0, 404);

    let (_, scene) = viewed.asked("/desktop/scene.json");
    let scene: serde_json::Value = serde_json::from_slice(&scene).unwrap();
    assert_eq!((scene["name"].as_str(), scene["text"].as_str()), (Some("scene.toml"), Some(ROPE)));

    let (_, frames) = viewed.asked("/desktop/frames");
    assert_eq!(frames.len(), FRAMES * BYTES);
    let number = |frame: usize, place: usize| {
        let at = frame * BYTES + 8 * place;
        f64::from_le_bytes(frames[at..at + 8].try_into().unwrap())
    };
    for frame in 0..FRAMES {
        assert!((number(frame, 0) - (frame as f64 / 60.0).min(0.1)).abs() < 1e-12, "frame {frame}");
    }
    let first = f32::from_le_bytes(frames[64 + 12..64 + 16].try_into().unwrap());
    assert_eq!(first, 0.25, "the second of five particles on a metre");
    // Kinetic, elastic and gravitational energy are what the total is made of, and it moves by the end.
    let total: f64 = (1..4).map(|place| number(FRAMES - 1, place)).sum();
    assert!((total - number(FRAMES - 1, 7)).abs() <= 1e-12 * total.abs());
    assert!(number(FRAMES - 1, 1) > 0.0);
}

#[test]
fn a_run_that_explodes_says_where_and_when_after_its_last_frame() {
    let flags = ["--precision", "f32", "--stepper", "explicit-euler", "--time-step", "0.05", "--duration", "100"];
    let viewed = Viewed::scene(&Folder::with(&ROPE.replace("stiffness = 100.0", "stiffness = 1e9")), &flags);
    let (_, frames) = viewed.asked("/desktop/frames");
    let last = &frames[frames.len() - BYTES..];
    let number = |place: usize| f64::from_le_bytes(last[8 * place..8 * place + 8].try_into().unwrap());
    assert!(number(0).is_nan());
    assert!((0.0..PARTICLES as f64).contains(&number(1)), "particle {}", number(1));
    assert!(number(2) > 0.0 && number(2) < 100.0, "after {} s", number(2));
    // And on the terminal why, as `hooke run` does.
    let said = viewed.ended();
    assert!(said.contains("became infinite or NaN") && said.contains("explicit-euler"), "{said}");
}

/// What is shown is what was read, whatever the file has become since.
#[cfg(unix)]
#[test]
fn the_text_and_the_run_are_of_one_reading() {
    let folder = Folder::empty();
    let scene = folder.file("scene.toml");
    assert!(Command::new("mkfifo").arg(&scene).status().unwrap().success());
    let (path, other) = (scene.clone(), folder.file("other.toml"));
    std::fs::write(&other, ROPE.replace("particles = 5", "particles = 9")).unwrap();
    let writer = std::thread::spawn(move || {
        // It opens as soon as it is read; then another file has its name.
        let mut pipe = std::fs::OpenOptions::new().write(true).open(&path).unwrap();
        std::fs::rename(&other, &path).unwrap();
        pipe.write_all(ROPE.as_bytes()).unwrap();
    });
    let viewed = Viewed::scene(&folder, &[]);
    writer.join().unwrap();
    let (_, scene) = viewed.asked("/desktop/scene.json");
    let scene: serde_json::Value = serde_json::from_slice(&scene).unwrap();
    assert_eq!(scene["text"].as_str(), Some(ROPE));
    assert_eq!(viewed.asked("/desktop/frames").1.len(), FRAMES * BYTES);
}

#[test]
fn other_hosts_are_not_answered() {
    let viewed = Viewed::scene(&Folder::with(ROPE), &[]);
    let port = viewed.address.port();
    assert_eq!(viewed.asked_as("/desktop/scene.json", &format!("localhost:{port}"), "").0, 200);
    assert_eq!(viewed.asked_as("/desktop/scene.json", "example.org", "").0, 403);
    assert_eq!(viewed.asked_as("/desktop/scene.json", &format!("example.org:{port}"), "").0, 403);
}

#[test]
fn pages_of_other_sites_start_no_run() {
    let viewed = Viewed::scene(&Folder::with(ROPE), &[]);
    let here = viewed.address.to_string();
    let asked = |path, headers: &str| viewed.asked_as(path, &here, headers).0;
    for headers in ["Origin: https://example.org\r\n", "Sec-Fetch-Site: cross-site\r\n"] {
        assert_eq!(asked("/desktop/frames", headers), 403, "{headers}");
        assert_eq!(asked("/desktop/scene.json", headers), 403, "{headers}");
        // A link from elsewhere leads to the page all the same.
        assert_eq!(asked("/", headers), 200, "{headers}");
    }
    assert_eq!(asked("/desktop/frames", &format!("Origin: http://{here}\r\nSec-Fetch-Site: same-origin\r\n")), 200);
}

#[test]
fn a_port_that_is_taken_is_refused() {
    let folder = Folder::with(ROPE);
    let viewed = Viewed::scene(&folder, &[]);
    let port = viewed.address.port().to_string();
    let answer = folder.hooke(&["view", "scene.toml", "--no-open", "--port", &port]);
    answer.exits(1).tells(&[&format!("port {port}"), "leave --port out"]);
}

#[cfg(unix)]
#[test]
fn an_interrupt_ends_it() {
    let mut viewed = Viewed::scene(&Folder::with(ROPE), &[]);
    let sent = Command::new("kill").args(["-INT", &viewed.child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    assert_eq!(viewed.child.wait().unwrap().code(), Some(0));
}
