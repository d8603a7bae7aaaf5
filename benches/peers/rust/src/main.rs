//! A worker of `benches/peers/run`: one peer on one scene.
//!
//! `hooke-peers SCENE PEER` prepares, prints a line that says so, then answers requests, one JSON object a line:
//! `{"setting": s, "duration": t}` starts the scene anew, runs it to `t` with that time step (s) or tolerance, and gives
//! the processor time and the positions. `hooke-peers SCENE flat` prints the scene for the workers in other languages.

mod diffsol;
mod flat;
mod hooke;
mod ode_solvers;
mod peer;
mod rapier;
mod right_hand_side;
mod textbook;

use std::error::Error;
use std::io::{BufRead, Write, stdin, stdout};
use std::path::Path;
use std::process::ExitCode;

use glam::{DVec3, Vec3, Vec3A};
use hooke_runner::scene::Scene;

use crate::peer::{Peer, Request};

fn peer(name: &str, scene: &Scene) -> Result<Box<dyn Peer>, Box<dyn Error>> {
    let (family, variant) = name.split_once(':').ok_or("a peer is written family:variant")?;
    Ok(match (family, variant) {
        ("textbook", "Vec3") => Box::new(textbook::new::<Vec3>(scene)?),
        ("textbook", "Vec3A") => Box::new(textbook::new::<Vec3A>(scene)?),
        ("textbook", "DVec3") => Box::new(textbook::new::<DVec3>(scene)?),
        ("hooke", stepper) => hooke::new(stepper, scene)?,
        ("ode_solvers", method) => Box::new(ode_solvers::new(method, scene)?),
        ("diffsol", method) => Box::new(diffsol::new(method, scene)?),
        ("rapier3d", iterations) => Box::new(rapier::new(iterations, scene)?),
        _ => return Err(format!("no peer is called {name}").into()),
    })
}

fn main() -> ExitCode {
    match serve() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn serve() -> Result<(), Box<dyn Error>> {
    let [_, path, name] =
        std::env::args().collect::<Vec<_>>().try_into().map_err(|_| "usage: hooke-peers SCENE PEER")?;
    let scene = Scene::load(Path::new(&path))?;
    let mut out = stdout().lock();
    if name == "flat" {
        serde_json::to_writer(&mut out, &flat::Flat::new(&scene)?)?;
        return Ok(());
    }
    let mut peer = peer(&name, &scene)?;
    writeln!(out, "{{\"ready\": true}}")?;
    out.flush()?;
    for line in stdin().lock().lines() {
        let request: Request = serde_json::from_str(&line?)?;
        let answer = match peer.run(&request) {
            Ok(mut outcome) => {
                if !request.state {
                    outcome.position = Vec::new();
                }
                serde_json::to_value(outcome)?
            }
            Err(error) => serde_json::json!({ "error": error.to_string() }),
        };
        writeln!(out, "{answer}")?;
        out.flush()?;
    }
    Ok(())
}
