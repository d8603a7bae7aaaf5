//! What can be wrong with a call, by number and in words.

use core::ffi::CStr;
use core::num::NonZero;

use crate::options::numbered;
use hooke::{AddParticleError, AddPlaneError, AddSpringError, Full, Real, SetError, StepError};

/// What a call came to. After any but `OK` what the call was to change is as it was.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HookeCode {
    /// Done.
    Ok = 0,
    /// A pointer is null that must not be.
    NullPointer = 1,
    /// A pointer is not a multiple of what it must be.
    Misaligned = 2,
    /// The memory is too small: `hooke_size_of` tells how much is needed.
    TooSmall = 3,
    /// There is no world at this address: `hooke_create` makes one.
    NotAWorld = 4,
    /// An enumeration has no such number, or this build of the library is without it.
    NoSuchOption = 5,
    /// The world has no room for another: its capacity was set when it was created.
    Full = 6,
    /// There is no particle of this number.
    NoSuchParticle = 7,
    /// There is no spring of this number.
    NoSuchSpring = 8,
    /// There is no plane of this number.
    NoSuchPlane = 9,
    /// Both ends of the spring are the same particle.
    SameParticle = 10,
    /// The mass, or its inverse, is not positive and finite.
    Mass = 11,
    /// A coordinate, a velocity, a gravity or a time is infinite or NaN, or becomes so in the world's precision.
    NotFinite = 12,
    /// The stiffness is not finite and 0 or more.
    Stiffness = 13,
    /// The damping is not finite and 0 or more.
    Damping = 14,
    /// The rest length is not finite and 0 or more.
    RestLength = 15,
    /// The normal is 0 or not finite.
    Normal = 16,
    /// The restitution is outside 0 to 1.
    Restitution = 17,
    /// The time step is not positive and finite, or too short for the time to change.
    TimeStep = 18,
    /// The tolerance is not positive and finite.
    Tolerance = 19,
    /// The stepper is for worlds without damping.
    Damped = 20,
    /// The workspace is too small for the stepper: `hooke_set_workspace` gives it a larger one.
    Workspace = 21,
    /// The step would have made a position or a velocity infinite or NaN; a shorter one, or another stepper, may not.
    NonFinite = 22,
    /// An array is not as long as it must be.
    Length = 23,
    /// The bytes are no snapshot, or that of a world with other particles, springs or planes.
    Snapshot = 24,
    /// Another call is under way: without the feature `std` there can be only one at a time.
    Busy = 25,
}

/// Where there is no particle, spring or plane to name.
pub const HOOKE_NOBODY: u32 = u32::MAX;

numbered!(HookeCode {
    Ok,
    NullPointer,
    Misaligned,
    TooSmall,
    NotAWorld,
    NoSuchOption,
    Full,
    NoSuchParticle,
    NoSuchSpring,
    NoSuchPlane,
    SameParticle,
    Mass,
    NotFinite,
    Stiffness,
    Damping,
    RestLength,
    Normal,
    Restitution,
    TimeStep,
    Tolerance,
    Damped,
    Workspace,
    NonFinite,
    Length,
    Snapshot,
    Busy
});

/// A code, and the number of the particle, spring or plane that it is about.
///
/// They are one word together, and so is an [`Outcome`]: it is handed on as it is, whatever it says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wrong(NonZero<u64>);

/// What came of something.
pub type Outcome<T = ()> = Result<T, Wrong>;

impl Wrong {
    /// The number above the code; the lowest bit makes it more than 0.
    fn of(code: u32, number: u32) -> Self {
        Self(NonZero::<u64>::MIN | (u64::from(number) << 32) | (u64::from(code) << 1))
    }

    fn code_number(self) -> u32 {
        self.0.get() as u32 >> 1
    }

    /// What is wrong.
    pub fn code(self) -> HookeCode {
        // Made of one of them.
        HookeCode::numbered(self.code_number()).unwrap_or(HookeCode::NotFinite)
    }

    /// Whom it is about.
    pub fn number(self) -> u32 {
        (self.0.get() >> 32) as u32
    }

    /// The same about another particle, spring or plane.
    pub fn about(self, number: u32) -> Self {
        Self::of(self.code_number(), number)
    }
}

impl HookeCode {
    /// In words.
    pub fn message(code: i32) -> &'static CStr {
        match code {
            0 => c"done",
            1 => c"a pointer is null",
            2 => c"a pointer is misaligned",
            3 => c"the memory is too small: hooke_size_of tells how much is needed",
            4 => c"there is no world at this address: hooke_create makes one",
            5 => c"an enumeration has no such number, or this build of the library is without it",
            6 => c"the world has no room for another: its capacity was set when it was created",
            7 => c"there is no particle of this number",
            8 => c"there is no spring of this number",
            9 => c"there is no plane of this number",
            10 => c"both ends of the spring are the same particle",
            11 => c"the mass, or its inverse, is not positive and finite",
            12 => c"a number is infinite or NaN, or becomes so in the world's precision",
            13 => c"the stiffness is not finite and 0 or more",
            14 => c"the damping is not finite and 0 or more",
            15 => c"the rest length is not finite and 0 or more",
            16 => c"the normal is 0 or not finite",
            17 => c"the restitution is outside 0 to 1",
            18 => c"the time step is not positive and finite, or too short for the time to change",
            19 => c"the tolerance is not positive and finite",
            20 => c"the stepper is for worlds without damping",
            21 => c"the workspace is too small for the stepper: hooke_set_workspace gives it a larger one",
            22 => c"a position or a velocity would become infinite or NaN: take shorter steps or another stepper",
            23 => c"an array is not as long as it must be",
            24 => c"the bytes are no snapshot, or that of a world with other particles, springs or planes",
            25 => c"another call is under way",
            _ => c"there is no such code",
        }
    }

    /// About a particle, a spring or a plane.
    pub fn about(self, number: u32) -> Wrong {
        Wrong::of(self as u32, number)
    }
}

impl From<HookeCode> for Wrong {
    fn from(code: HookeCode) -> Self {
        code.about(HOOKE_NOBODY)
    }
}

impl From<Full> for Wrong {
    fn from(_: Full) -> Self {
        HookeCode::Workspace.into()
    }
}

impl<R: Real> From<AddParticleError<R>> for Wrong {
    fn from(error: AddParticleError<R>) -> Self {
        match error {
            AddParticleError::Mass(_) => HookeCode::Mass,
            AddParticleError::NotFinite => HookeCode::NotFinite,
            _ => HookeCode::Full,
        }
        .into()
    }
}

impl<R> From<AddSpringError<R>> for Wrong {
    fn from(error: AddSpringError<R>) -> Self {
        match error {
            AddSpringError::NoSuchParticle(number) => return HookeCode::NoSuchParticle.about(number),
            AddSpringError::SameParticle(number) => return HookeCode::SameParticle.about(number),
            AddSpringError::Stiffness(_) => HookeCode::Stiffness,
            AddSpringError::Damping(_) => HookeCode::Damping,
            AddSpringError::RestLength(_) => HookeCode::RestLength,
            _ => HookeCode::Full,
        }
        .into()
    }
}

impl<R> From<AddPlaneError<R>> for Wrong {
    fn from(error: AddPlaneError<R>) -> Self {
        match error {
            AddPlaneError::Normal => HookeCode::Normal,
            AddPlaneError::Point => HookeCode::NotFinite,
            AddPlaneError::Restitution(_) => HookeCode::Restitution,
            _ => HookeCode::Full,
        }
        .into()
    }
}

impl From<SetError> for Wrong {
    fn from(error: SetError) -> Self {
        match error {
            SetError::NoSuchParticle(number) => HookeCode::NoSuchParticle.about(number),
            SetError::NoSuchPlane(number) => HookeCode::NoSuchPlane.about(number),
            SetError::Restitution => HookeCode::Restitution.into(),
            _ => HookeCode::NotFinite.into(),
        }
    }
}

impl From<StepError> for Wrong {
    fn from(error: StepError) -> Self {
        match error {
            StepError::Damped => HookeCode::Damped.into(),
            StepError::Tolerance => HookeCode::Tolerance.into(),
            StepError::Workspace(_) => HookeCode::Workspace.into(),
            StepError::NonFinite { particle } => HookeCode::NonFinite.about(particle),
            _ => HookeCode::TimeStep.into(),
        }
    }
}
