//! What a measurement holds for: this scene, this program, this machine.

use std::fmt::{Display, Formatter};
use std::sync::LazyLock;

use super::point::Compared;
use crate::model::Model;
use crate::scene::Settings;

/// Two measurements with the same stamp may be put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stamp {
    scene: u32,
    /// The program's own bytes, and the processor.
    program: u32,
}

impl Stamp {
    /// Of a scene that is measured here and now: everything in it that changes a run, with what generators and meshes made of it.
    #[must_use]
    pub fn of(model: &Model, settings: &Settings, compared: Compared) -> Self {
        let Settings { gravity, duration, tolerance, sleep_speed, collision, .. } = settings;
        let said =
            format!("{model:?} {gravity:?} {duration:?} {tolerance:?} {sleep_speed:?} {collision:?} {compared:?}");
        Self { scene: crc32fast::hash(said.as_bytes()), program: *PROGRAM }
    }
}

impl Display for Stamp {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{:08x}-{:08x}", self.scene, self.program)
    }
}

static PROGRAM: LazyLock<u32> = LazyLock::new(|| {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(env!("CARGO_PKG_VERSION").as_bytes());
    hasher.update(machine().as_bytes());
    // Where it cannot read itself, the version has to do.
    let own = std::env::current_exe().and_then(std::fs::read).unwrap_or_default();
    hasher.update(&own);
    hasher.finalize()
});

const UNKNOWN: &str = "unknown processor";

/// The processor's name.
#[must_use]
pub fn machine() -> String {
    let refresh = sysinfo::RefreshKind::nothing().with_cpu(sysinfo::CpuRefreshKind::nothing());
    let Ok(system) = sysinfo::System::new_with_specifics(refresh) else { return UNKNOWN.to_owned() };
    let name = system.cpus().first().map(|core| core.brand().trim().to_owned()).filter(|name| !name.is_empty());
    name.unwrap_or_else(|| UNKNOWN.to_owned())
}
