"""Who is measured, on what, at which settings."""

from dataclasses import dataclass, field

SAME = "same"
"""The same equation of motion: its positions converge to the reference."""
SIMILAR = "similar"
"""Springs too, but not the same equation."""

SPRING_SCENES = ["cloth-32", "cloth-64", "cloth-256", "rope-1000", "jelly-16", "balls"]
TIME_STEP = 1e-3
"""s; stable on all of these scenes."""
FRAME = 1 / 60
"""s"""


@dataclass(frozen=True, eq=False)
class Peer:
    """`name` is what its worker calls it; `settings` are time steps (s) or tolerances, by scene or for all."""

    name: str
    label: str
    equation: str = SAME
    scheme: str = "semi-implicit Euler"
    settings: object = TIME_STEP
    missing: dict = field(default_factory=dict)
    """Scenes that it is not run on, and why."""

    @property
    def family(self):
        return self.name.split(":")[0]

    def settings_for(self, scene):
        return self.settings.get(scene, []) if isinstance(self.settings, dict) else self.settings


NO_CONTACT = {scene: "its contacts are not the plane's law" for scene in ("jelly-16", "balls")}
TOO_LARGE = {"cloth-256": "its compiler is not done with the model after four minutes"}

# Nanoseconds per spring and step (balls: per particle).
SPRINGS = [
    Peer("hooke:semi-implicit-euler:f32", "Hooke f32"),
    Peer("hooke:semi-implicit-euler:f64", "Hooke f64"),
    Peer("textbook:Vec3A", "Rust textbook, glam Vec3A f32"),
    Peer("textbook:Vec3", "Rust textbook, glam Vec3 f32"),
    Peer("textbook:DVec3", "Rust textbook, glam DVec3 f64"),
    Peer("numba:f32", "numba textbook f32"),
    Peer("numba:f64", "numba textbook f64"),
    Peer("warp:f32", "Warp kernels f32"),
    Peer("newton:semi-implicit", "Newton SolverSemiImplicit f32", missing=NO_CONTACT),
    Peer("taichi:gather", "Taichi, gather f32"),
    Peer("taichi:atomics", "Taichi, atomics f32"),
    Peer("numpy:f64", "NumPy f64"),
    Peer("mujoco:flex", "MuJoCo flex f64", missing=NO_CONTACT | TOO_LARGE),
    Peer("rapier3d:1", "rapier3d spring joints f32, 1 iteration", scheme="soft constraints"),
    Peer("cannon:springs", "cannon-es springs f64"),
]

# What the references in tests/reference must agree with: two methods, each with a right-hand side of its own.
REFERENCES = [
    Peer("scipy:DOP853:numba", "SciPy DOP853, numba right-hand side", scheme="DOP853", settings=[1e-12]),
    Peer("ode_solvers:rk4", "ode_solvers RK4", scheme="RK4", settings=[2.5e-5]),
]
TOLERANCES = [10 ** (-half / 2) for half in range(4, 21)]
# CPU time to t = 1 s against the largest position error.
ACCURACY_SCENES = ["cloth-32", "rope-100"]
DOP853_STEPS = {
    "cloth-32": [1 / round(72 * 2 ** (eighth / 8)) for eighth in range(23)],
    "rope-100": [1 / round(236 * 2 ** (eighth / 8)) for eighth in range(23)],
}
"""s; from the longest that is stable, each 1.09 times shorter than the one before."""
ACCURACY = [
    Peer(
        "hooke:semi-implicit-euler:f32",
        "Hooke semi-implicit Euler f32",
        settings={"cloth-32": [4e-3, 2e-3, 1e-3, 2.5e-4, 1e-4], "rope-100": [2.5e-3, 1e-3, 5e-4, 2.5e-4, 1e-4]},
    ),
    Peer(
        "hooke:velocity-verlet:f32",
        "Hooke velocity Verlet f32",
        scheme="velocity Verlet",
        settings={"cloth-32": [4e-3, 2e-3, 1e-3, 2.5e-4, 1e-4], "rope-100": [2e-3, 1e-3, 5e-4, 2.5e-4, 1e-4]},
    ),
    Peer(
        "hooke:velocity-verlet:f64",
        "Hooke velocity Verlet f64",
        scheme="velocity Verlet",
        settings=[1e-3, 2.5e-4, 1e-4, 5e-5],
    ),
    Peer(
        "hooke:blanes-moan-s6:f64",
        "Hooke Blanes-Moan S6 f64",
        scheme="Blanes-Moan S6",
        settings=[4e-3, 2e-3, 1e-3, 5e-4],
    ),
    Peer("hooke:dop853:f32", "Hooke DOP853 f32, fixed step", scheme="DOP853", settings=DOP853_STEPS),
    Peer(
        "hooke:dop853:f32-compensated",
        "Hooke DOP853 f32-compensated, fixed step",
        scheme="DOP853",
        settings=DOP853_STEPS,
    ),
    Peer("hooke:dop853:f64", "Hooke DOP853 f64, fixed step", scheme="DOP853", settings=DOP853_STEPS),
    Peer("textbook:Vec3A", "Rust textbook, glam Vec3A f32", settings=[1e-3, 2.5e-4, 1e-4]),
    Peer("textbook:DVec3", "Rust textbook, glam DVec3 f64", settings=[1e-3, 2.5e-4, 1e-4]),
    Peer("ode_solvers:dop853", "ode_solvers DOP853", scheme="DOP853", settings=TOLERANCES),
    Peer("scipy:DOP853:numba", "SciPy DOP853, numba right-hand side", scheme="DOP853", settings=TOLERANCES),
    Peer("diffsol:tsit45", "diffsol Tsit45", scheme="Tsitouras 5(4)", settings=TOLERANCES),
    Peer("ode_solvers:rk4", "ode_solvers RK4", scheme="RK4", settings=[2e-3, 1e-3, 5e-4, 2.5e-4]),
    Peer("mujoco:flex", "MuJoCo flex", settings=[1e-3, 2.5e-4]),
    Peer("rapier3d:4", "rapier3d spring joints, 4 iterations", scheme="soft constraints", settings=[4e-3, 1e-3]),
]

# Milliseconds per frame of 1/60 s on cloth-32, with steps as long as a frame or a tolerance.
FRAME_SCENE = "cloth-32"
FRAMES = [
    Peer("hooke:implicit-euler:f64", "Hooke implicit Euler, solved", scheme="implicit Euler", settings=[FRAME]),
    Peer(
        "hooke:implicit-euler-linearised:f64",
        "Hooke implicit Euler, one linearisation",
        scheme="implicit Euler, linearised",
        settings=[FRAME],
    ),
    Peer("hooke:tr-bdf2:f64", "Hooke TR-BDF2", scheme="TR-BDF2", settings=[FRAME]),
    Peer(
        "scipy:backward-euler",
        "SciPy sparse backward Euler, one linearisation",
        scheme="implicit Euler, linearised",
        settings=[FRAME],
    ),
    Peer("newton:vbd-10", "Newton VBD, 10 iterations", scheme="implicit Euler, unconverged", settings=[FRAME]),
    Peer("newton:vbd-50", "Newton VBD, 50 iterations", scheme="implicit Euler, unconverged", settings=[FRAME]),
    Peer("newton:vbd-200", "Newton VBD, 200 iterations", scheme="implicit Euler", settings=[FRAME]),
    Peer("newton:xpbd-10", "Newton XPBD, 10 iterations", SIMILAR, scheme="position-based", settings=[FRAME]),
    Peer("diffsol:bdf", "diffsol BDF", scheme="BDF, variable", settings=[1e-4]),
    Peer("diffsol:esdirk34", "diffsol ESDIRK34", scheme="ESDIRK 3(4)", settings=[1e-3]),
    Peer("mujoco:flex", "MuJoCo flex, one step a frame", settings=[FRAME]),
    Peer("rapier3d:4", "rapier3d spring joints, 4 iterations", scheme="soft constraints", settings=[FRAME]),
    Peer("ode_solvers:dop853", "ode_solvers DOP853, explicit, for scale", scheme="DOP853", settings=[1e-3]),
]
