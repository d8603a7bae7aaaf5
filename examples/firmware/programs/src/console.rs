//! Lines on the console of QEMU's host.

use cortex_m_semihosting::hprintln;
use hooke::StepError;
use hooke_firmware_scenes::Tell;

use crate::stack;

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

/// Tells digests there, and the most that the stack was in use, by which scene and which stepper.
#[derive(Default)]
pub struct Watching {
    most: u32,
}

impl Watching {
    /// Paints the stack.
    #[must_use]
    pub fn new() -> Self {
        stack::high_water();
        Self { most: 0 }
    }

    /// Tells the most.
    pub fn finish(&self) {
        hprintln!("stack: {} bytes", self.most);
    }
}

impl Tell for Watching {
    fn tell(&mut self, scene: &str, stepper: &str, digest: Result<u64, StepError>) {
        let used = stack::high_water();
        hprintln!("stack: {} bytes, {}, {}", used, scene, stepper);
        self.most = self.most.max(used);
        Console.tell(scene, stepper, digest);
    }
}
