//! How much a scene takes, known before it is made.

use std::ops::Add;

use super::error::SceneError;

/// Particles and springs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Size {
    pub(super) particles: u128,
    pub(super) springs: u128,
}

impl Add for Size {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { particles: self.particles + other.particles, springs: self.springs + other.springs }
    }
}

/// For each particle: the flat model, the stepped state, a frame, and room to prepare them.
const BYTES_PER_PARTICLE: u128 = 160;
/// For each spring: the flat model, the prepared constants, and room to order them.
const BYTES_PER_SPRING: u128 = 110;

impl Size {
    /// What a run of that many takes, bytes.
    pub(super) const fn bytes(self) -> u128 {
        self.particles * BYTES_PER_PARTICLE + self.springs * BYTES_PER_SPRING
    }

    /// Refuses more than can be numbered, or than `available` bytes hold.
    pub(super) fn check(self, place: &str, available: u64) -> Result<(), SceneError> {
        let Self { particles, springs } = self;
        let most = u128::from(u32::MAX);
        let fewer = "ask for fewer particles: half as many along each side of a block make an eighth of it".to_owned();
        for (count, what) in [(particles, "particles"), (springs, "springs")] {
            if count > most {
                let message = format!("the scene makes {count} {what}, and at most {most} can be numbered");
                return Err(SceneError::plain(place, message, fewer));
            }
        }
        let needed = self.bytes();
        if needed > u128::from(available) {
            let message = format!(
                "the scene makes {particles} particles and {springs} springs, which need {} of memory, and {} are available",
                in_units(needed),
                in_units(available.into()),
            );
            return Err(SceneError::plain(place, message, format!("{fewer}; or free some memory")));
        }
        Ok(())
    }
}

/// Bytes that this process may still take; as good as endless where the system does not say.
#[cfg(feature = "desktop")]
pub(super) fn available_memory() -> u64 {
    let refresh = sysinfo::RefreshKind::nothing().with_memory(sysinfo::MemoryRefreshKind::nothing().with_ram());
    let Ok(system) = sysinfo::System::new_with_specifics(refresh) else {
        return u64::MAX;
    };
    // A container may allow less than its machine has.
    let allowed = system.cgroup_limits().map_or(u64::MAX, |limits| limits.free_memory);
    match system.available_memory() {
        0 => allowed,
        available => available.min(allowed),
    }
}

/// `1.5 GB`, by thousands.
fn in_units(bytes: u128) -> String {
    let mut amount = bytes as f64;
    for unit in ["bytes", "kB", "MB", "GB", "TB"] {
        if amount < 1000.0 {
            return format!("{amount:.3} {unit}").replace(".000 ", " ");
        }
        amount /= 1000.0;
    }
    format!("{amount:.3} PB")
}
