"""A worker of `run`: one peer on one scene, in Python.

`worker.py SCENE FAMILY:VARIANT` reads the flat scene, prepares, prints a line that says so, then answers requests as
`hooke-peers` does: each starts the scene anew, and only its running is timed, in processor time of this process.
"""

import importlib
import json
import sys
import time
from dataclasses import dataclass

import numpy as np

# Where each family is, and with it what has to be installed.
MODULES = {
    "numpy": "numpy_loop",
    "scipy": "scipy_solvers",
    "numba": "numba_loop",
    "taichi": "taichi_loop",
    "warp": "warp_loop",
    "newton": "newton_solvers",
    "mujoco": "mujoco_flex",
}


@dataclass
class Scene:
    """SI units, f64; `between` holds the particles i and j of each spring."""

    gravity: np.ndarray
    position: np.ndarray
    velocity: np.ndarray
    mass: np.ndarray
    pinned: np.ndarray
    between: np.ndarray
    stiffness: np.ndarray
    damping: np.ndarray
    rest_length: np.ndarray
    planes: list

    @classmethod
    def load(cls, path):
        with open(path) as file:
            flat = json.load(file)

        def array(key, *shape, dtype=np.float64):
            return np.array(flat[key], dtype).reshape(shape)

        return cls(
            gravity=array("gravity", 3),
            position=array("position", -1, 3),
            velocity=array("velocity", -1, 3),
            mass=array("mass", -1),
            pinned=array("pinned", -1, dtype=np.int64),
            between=array("between", -1, 2, dtype=np.int32),
            stiffness=array("stiffness", -1),
            damping=array("damping", -1),
            rest_length=array("rest_length", -1),
            planes=flat["planes"],
        )

    @property
    def inverse_mass(self):
        """1/kg; 0 where pinned."""
        inverse = 1 / self.mass
        inverse[self.pinned] = 0
        return inverse

    def plane_array(self):
        """A row for each plane: its normal, its offset, its restitution."""
        rows = [[*p["normal"], np.dot(p["normal"], p["point"]), p["restitution"]] for p in self.planes]
        return np.array(rows).reshape(-1, 5)


def steps(setting, duration):
    """Of a peer whose setting is a time step."""
    return round(duration / setting)


def timed(work):
    """The processor time that `work` takes, s, and what it gives."""
    start = time.process_time_ns()
    made = work()
    return (time.process_time_ns() - start) * 1e-9, made


def main():
    path, name = sys.argv[1:]
    # What a library prints must not end up among the answers.
    answers, sys.stdout = sys.stdout, sys.stderr

    def answer(values):
        print(json.dumps(values), file=answers, flush=True)

    family, variant = name.split(":", 1)
    peer = importlib.import_module(MODULES[family]).peer(variant, Scene.load(path))
    answer({"ready": True})
    for line in sys.stdin:
        request = json.loads(line)
        try:
            cpu, position = peer.run(request["setting"], request["duration"])
            wanted = request.get("state")
            answer({"cpu": cpu, "position": np.asarray(position, float).ravel().tolist() if wanted else []})
        except Exception as error:  # whatever a peer fails with is its row in the table
            answer({"error": f"{type(error).__name__}: {error}"})


if __name__ == "__main__":
    main()
