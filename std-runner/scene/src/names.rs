//! What a scene, or a flag, chooses by name.

/// Declares a choice whose names are the same in scenes, in flags and in print.
macro_rules! choice {
    (
        $(#[$about:meta])*
        $choice:ident: $what:literal {
            $($(#[doc = $doc:literal])+ $(#[$default:ident])? $variant:ident = $name:literal,)+
        }
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
        pub enum $choice {
            $($(#[doc = $doc])+ $(#[$default])? #[serde(rename = $name)] $variant,)+
        }

        impl $choice {
            /// Every one of them.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// As scenes and flags write it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)+
                }
            }
        }

        impl std::fmt::Display for $choice {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.pad(self.name())
            }
        }

        impl std::str::FromStr for $choice {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                Self::ALL.iter().copied().find(|choice| choice.name() == text).ok_or_else(|| {
                    let names: Vec<&str> = Self::ALL.iter().map(|choice| choice.name()).collect();
                    format!("{text:?} is no {}: the names are {}", $what, names.join(", "))
                })
            }
        }

        #[cfg(feature = "desktop")]
        impl clap::ValueEnum for $choice {
            fn value_variants<'a>() -> &'a [Self] {
                Self::ALL
            }

            fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
                let help = match self {
                    $(Self::$variant => concat!($($doc),+).trim(),)+
                };
                Some(clap::builder::PossibleValue::new(self.name()).help(help))
            }
        }
    };
}
pub(super) use choice;

choice! {
    /// How velocities and positions are carried from one moment to the next.
    #[derive(Default)]
    StepperName: "stepper" {
        /// Position and velocity both from the old state: the simplest, and unstable on undamped springs.
        ExplicitEuler = "explicit-euler",
        /// Velocity first, then position from the new velocity: cheap, and keeps energy bounded.
        SemiImplicitEuler = "semi-implicit-euler",
        /// The forces of the new state, solved to the tolerance: stable at any step.
        ImplicitEuler = "implicit-euler",
        /// Implicit Euler with one linearisation instead of a full solve.
        ImplicitEulerLinearised = "implicit-euler-linearised",
        /// The forces half-way, solved to the tolerance: second order, stable at any step, and damps nothing.
        ImplicitMidpoint = "implicit-midpoint",
        /// Trapezoidal rule, then backward differentiation: second order, stable at any step, damps what is too fast for it.
        TrBdf2 = "tr-bdf2",
        /// Half a kick, a drift, half a kick: second order, and keeps energy bounded.
        VelocityVerlet = "velocity-verlet",
        /// The classical Runge-Kutta method: fourth order, four force evaluations a step.
        Rk4 = "rk4",
        /// Drifts and kicks by turns: fourth order, six force evaluations a step, and keeps energy bounded.
        BlanesMoanS6 = "blanes-moan-s6",
        /// Runge-Kutta of eighth order, twelve force evaluations a step: for errors below a millionth.
        Dop853 = "dop853",
        /// Runge-Kutta-Nyström of eighth order, eight force evaluations a step, for scenes without damping.
        DormandPrinceRkn8 = "dormand-prince-rkn8",
        /// Whatever is cheapest while stable and accurate enough for the scene.
        #[default]
        Auto = "auto",
    }
}

impl StepperName {
    /// Whether it can step scenes with damping.
    #[must_use]
    pub fn knows_damping(self) -> bool {
        self != Self::DormandPrinceRkn8
    }

    /// Whether it can choose the lengths of its steps itself, by estimates of their errors.
    #[must_use]
    pub fn estimates_errors(self) -> bool {
        matches!(self, Self::Dop853 | Self::DormandPrinceRkn8)
    }
}

choice! {
    /// The numbers that a run computes with.
    #[derive(Default)]
    Precision: "precision" {
        /// 32-bit: fastest, about 7 digits.
        #[default]
        F32 = "f32",
        /// 32-bit, with the rounding of positions and velocities kept: errors like those of 64-bit, for machines without it.
        F32Compensated = "f32-compensated",
        /// 64-bit: about 16 digits.
        F64 = "f64",
    }
}

choice! {
    /// What happens to a particle that meets a plane.
    #[derive(Default)]
    CollisionForm: "collision form" {
        /// The velocity is turned round; the particle stays where the step took it.
        Reflect = "reflect",
        /// The velocity is turned round, and the particle is put back on the plane.
        Project = "project",
        /// The hit is found inside the step, and the rest of the step is flown from there.
        #[default]
        TimeOfImpact = "time-of-impact",
    }
}
