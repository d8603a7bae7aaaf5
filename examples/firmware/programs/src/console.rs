//! Lines on the console of QEMU's host.

use cortex_m_semihosting::hprintln;
use hooke::StepError;
use hooke_firmware_scenes::Tell;

/// Tells digests there.
pub struct Console;

impl Tell for Console {
    fn tell(&mut self, scene: &str, stepper: &str, digest: Result<u64, StepError>) {
        match digest {
            Ok(digest) => hprintln!("{}, {}: {:016x}", scene, stepper, digest),
            Err(error) => hprintln!("{}, {}: {}", scene, stepper, error),
        }
    }
}
