"""NumPy: whole-array operations, forces summed by `bincount`; f64."""

import numpy as np

from worker import steps, timed


class Loop:
    def __init__(self, scene):
        self.scene = scene
        self.i, self.j = (np.ascontiguousarray(end, np.intp) for end in scene.between.T)
        self.planes = scene.plane_array()
        self.inverse_mass = scene.inverse_mass[:, None]

    def forces(self, x, v):
        """What the springs do, N."""
        scene, i, j, count = self.scene, self.i, self.j, len(x)
        if len(i) == 0:
            return np.zeros_like(x)
        d = x[j] - x[i]
        length = np.sqrt(np.einsum("sc,sc->s", d, d))
        rate = np.einsum("sc,sc->s", v[j] - v[i], d) / length
        force = d * ((scene.stiffness * (length - scene.rest_length) + scene.damping * rate) / length)[:, None]
        summed = [np.bincount(i, f, count) - np.bincount(j, f, count) for f in force.T]
        return np.stack(summed, axis=1)

    def accelerations(self, x, v):
        a = self.forces(x, v) * self.inverse_mass + self.scene.gravity
        a[self.scene.pinned] = 0
        return a

    def run(self, time_step, duration):
        x, v = self.scene.position.copy(), self.scene.velocity.copy()

        def go():
            for _ in range(steps(time_step, duration)):
                v[:] += self.accelerations(x, v) * time_step
                x[:] += v * time_step
                self.collide(x, v)

        cpu, _ = timed(go)
        return cpu, x

    def collide(self, x, v):
        for *normal, offset, restitution in self.planes:
            depth, speed = offset - x @ normal, v @ normal
            hit = np.flatnonzero((depth > 0) & (speed < 0))
            v[hit] -= np.outer((1 + restitution) * speed[hit], normal)
            x[hit] += np.outer(depth[hit], normal)


def peer(_, scene):
    return Loop(scene)
