//! What a caller chooses by number.

/// The one of a number, of those that are listed.
macro_rules! numbered {
    ($name:ident { $($variant:ident),* }) => {
        impl $name {
            pub(crate) fn numbered(number: u32) -> Option<Self> {
                match number {
                    $(number if number == Self::$variant as u32 => Some(Self::$variant),)*
                    _ => None,
                }
            }
        }
    };
}
pub(crate) use numbered;

/// What a world's numbers are.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HookePrecision {
    /// 32 bits.
    F32 = 0,
    /// 64 bits.
    F64 = 1,
}

numbered!(HookePrecision { F32, F64 });

/// The rule that makes a step. h = w dt, where w is the highest frequency of the world.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HookeStepper {
    /// v' = v + dt a(x, v), x' = x + dt v. First order; grows without damping.
    ExplicitEuler = 0,
    /// v' = v + dt a(x, v), x' = x + dt v'. First order, stable up to h = 2.
    SemiImplicitEuler = 1,
    /// v' = v + dt a(x', v'), x' = x + dt v', solved to the tolerance. First order, stable.
    ImplicitEuler = 2,
    /// The same, by one linear solve. First order, stable on linear springs.
    ImplicitEulerLinearised = 3,
    /// Second order, stable up to h = 2.
    VelocityVerlet = 4,
    /// The classical Runge-Kutta method. Fourth order, stable up to h = 2.6.
    Rk4 = 5,
    /// Blanes and Moan's splitting. Fourth order, stable up to h = 3.1.
    BlanesMoanS6 = 6,
    /// Dormand and Prince's Runge-Kutta method. Eighth order, stable up to h = 5.9.
    Dop853 = 7,
    /// Their Nystroem method. Eighth order, stable up to h = 3.1; refuses springs with damping.
    DormandPrinceRkn8 = 8,
    /// Second order, stable, damps nothing; solved to the tolerance.
    ImplicitMidpoint = 9,
    /// Second order, stable, damps what is too fast; solved to the tolerance.
    TrBdf2 = 10,
    /// Free particles fly exactly; the rest by velocity Verlet, semi-implicit Euler or implicit Euler, the first of
    /// them that is stable.
    Auto = 11,
}

numbered!(HookeStepper {
    ExplicitEuler,
    SemiImplicitEuler,
    ImplicitEuler,
    ImplicitEulerLinearised,
    VelocityVerlet,
    Rk4,
    BlanesMoanS6,
    Dop853,
    DormandPrinceRkn8,
    ImplicitMidpoint,
    TrBdf2,
    Auto
});

/// What happens when a step takes particles through planes.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HookeCollision {
    /// The velocity is turned round after the step.
    Reflect = 0,
    /// The same, and the particle is put back on the plane.
    Project = 1,
    /// The hit is found inside the step, and the rest of the step is taken from there.
    TimeOfImpact = 2,
}

numbered!(HookeCollision { Reflect, Project, TimeOfImpact });

/// How a particle is held.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HookeHold {
    /// It moves as the forces on it say.
    Free = 0,
    /// It stays where it is.
    Pinned = 1,
    /// It moves with the velocity that it is given.
    Kinematic = 2,
}

numbered!(HookeHold { Free, Pinned, Kinematic });

impl HookeStepper {
    /// Whether it may solve linear systems by a factorisation.
    pub(crate) fn may_factor(self) -> bool {
        matches!(
            self,
            Self::ImplicitEuler | Self::ImplicitEulerLinearised | Self::ImplicitMidpoint | Self::TrBdf2 | Self::Auto
        )
    }
}
