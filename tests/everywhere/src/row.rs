//! What is stepped, and how: a row of the table.

use core::fmt;

use crate::names::named;

named! {
    /// A world to start from.
    Scene {
        /// A damped rope, swung against a slope: along one diagonal.
        Rope = "rope",
        /// An undamped rope far too stiff for its time step, so that its linear systems are factorised.
        Stiff = "stiff",
        /// A damped cloth of more than one tile, so that threads share it.
        Cloth = "cloth",
        /// An undamped block that falls on a slope.
        Block = "block",
        /// Balls between planes of several restitutions; no springs.
        Balls = "balls",
        /// A damped graph without any order to it, next to a floor.
        Mesh = "mesh",
        /// Pinned, kinematic, free and attached particles, masses and springs of all kinds, one without length, two planes.
        Everything = "everything",
        /// A rope that rests, and may sleep, beside one that swings.
        Sleepers = "sleepers",
    }
}

named! {
    /// A stepper, as scenes call it.
    StepperName {
        /// As it is called.
        ExplicitEuler = "explicit-euler",
        /// As it is called.
        SemiImplicitEuler = "semi-implicit-euler",
        /// As it is called.
        ImplicitEuler = "implicit-euler",
        /// As it is called.
        ImplicitEulerLinearised = "implicit-euler-linearised",
        /// As it is called.
        ImplicitMidpoint = "implicit-midpoint",
        /// As it is called.
        TrBdf2 = "tr-bdf2",
        /// As it is called.
        VelocityVerlet = "velocity-verlet",
        /// As it is called.
        Rk4 = "rk4",
        /// As it is called.
        BlanesMoanS6 = "blanes-moan-s6",
        /// As it is called.
        Dop853 = "dop853",
        /// The same, with parts of steps of its own choice.
        AdaptiveDop853 = "dop853-adaptive",
        /// As it is called.
        DormandPrinceRkn8 = "dormand-prince-rkn8",
        /// The same, with parts of steps of its own choice.
        AdaptiveDormandPrinceRkn8 = "dormand-prince-rkn8-adaptive",
        /// As it is called.
        Auto = "auto",
    }
}

named! {
    /// What a world is made of.
    Precision {
        /// Single.
        F32 = "f32",
        /// Single, with its rounding kept.
        F32Compensated = "f32-compensated",
        /// Double.
        F64 = "f64",
    }
}

named! {
    /// How collisions are answered.
    Form {
        /// Velocities turn round after the step.
        Reflect = "reflect",
        /// Particles are put back on the plane as well.
        Project = "project",
        /// Hits are found within the step.
        TimeOfImpact = "time-of-impact",
    }
}

/// One way to step one world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The world.
    pub scene: Scene,
    /// The stepper.
    pub stepper: StepperName,
    /// The precision.
    pub precision: Precision,
    /// The form of collision.
    pub form: Form,
}

impl Row {
    /// All there are.
    pub fn all() -> impl Iterator<Item = Self> {
        let forms = |scene, stepper, precision| {
            Form::ALL.iter().map(move |form| Self { scene, stepper, precision, form: *form })
        };
        let precisions =
            move |scene, stepper| Precision::ALL.iter().flat_map(move |precision| forms(scene, stepper, *precision));
        let steppers = move |scene| StepperName::ALL.iter().flat_map(move |stepper| precisions(scene, *stepper));
        Scene::ALL.iter().flat_map(move |scene| steppers(*scene))
    }

    /// The row of these four names, in the order in which a row is told.
    pub fn of<'a>(mut words: impl Iterator<Item = &'a str>) -> Option<Self> {
        Some(Self {
            scene: Scene::named(words.next()?)?,
            stepper: StepperName::named(words.next()?)?,
            precision: Precision::named(words.next()?)?,
            form: Form::named(words.next()?)?,
        })
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { scene, stepper, precision, form } = self;
        write!(f, "{} {} {} {}", scene.name(), stepper.name(), precision.name(), form.name())
    }
}
