"""Newton: its springs between particles by its own solvers; f32, on the processor."""

import newton
import numpy as np
import warp as wp

from worker import steps, timed

wp.config.quiet = True


# m; so small that particles do not meet.
RADIUS = 1e-5


class Solver:
    def __init__(self, scene, make, grid):
        if scene.planes:
            raise ValueError("its contacts are not the plane's law")
        self.scene = scene
        builder = newton.ModelBuilder(gravity=tuple(scene.gravity))
        mass = scene.mass.copy()
        mass[scene.pinned] = 0
        builder.add_particles(
            [wp.vec3(*x) for x in scene.position],
            [wp.vec3(*v) for v in scene.velocity],
            mass.tolist(),
            radius=[RADIUS] * len(mass),
        )
        for (i, j), stiffness, damping in zip(scene.between.tolist(), scene.stiffness, scene.damping):
            builder.add_spring(i, j, stiffness, damping, 0.0)
        builder.color()
        self.model = builder.finalize(device="cpu")
        self.model.spring_rest_length.assign(scene.rest_length.astype(np.float32))
        if not grid:
            self.model.particle_grid = None
        self.make = make
        self.run(1e-4, 1e-4)

    def run(self, time_step, duration):
        solver = self.make(self.model)
        now, after = self.model.state(), self.model.state()
        control = self.model.control()

        def go():
            nonlocal now, after
            for _ in range(steps(time_step, duration)):
                now.clear_forces()
                solver.step(now, after, control, None, time_step)
                now, after = after, now

        cpu, _ = timed(go)
        return cpu, now.particle_q.numpy()


def peer(variant, scene):
    method, _, iterations = variant.rpartition("-")
    make = {
        "semi": lambda model: newton.solvers.SolverSemiImplicit(model),
        "vbd": lambda model: newton.solvers.SolverVBD(model, iterations=int(iterations)),
        "xpbd": lambda model: newton.solvers.SolverXPBD(model, iterations=int(iterations)),
    }[method]
    # XPBD refuses to run without the grid in which particles find each other.
    return Solver(scene, make, grid=method == "xpbd")
