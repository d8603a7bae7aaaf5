"""Warp: one kernel over springs that adds atomically to both ends, one over particles; f32, on the processor."""

import numpy as np
import warp as wp

from worker import steps, timed

wp.config.quiet = True


@wp.kernel
def add_springs(
    x: wp.array[wp.vec3],
    v: wp.array[wp.vec3],
    between: wp.array[wp.vec2i],
    stiffness: wp.array[float],
    damping: wp.array[float],
    rest_length: wp.array[float],
    force: wp.array[wp.vec3],
):
    s = wp.tid()
    i, j = between[s][0], between[s][1]
    d = x[j] - x[i]
    length = wp.length(d)
    if length > 0.0:
        direction = d / length
        rate = wp.dot(v[j] - v[i], direction)
        pull = direction * (stiffness[s] * (length - rest_length[s]) + damping[s] * rate)
        wp.atomic_add(force, i, pull)
        wp.atomic_sub(force, j, pull)


@wp.kernel
def move(
    dt: float,
    gravity: wp.vec3,
    inverse_mass: wp.array[float],
    normal: wp.array[wp.vec3],
    offset: wp.array[float],
    restitution: wp.array[float],
    x: wp.array[wp.vec3],
    v: wp.array[wp.vec3],
    force: wp.array[wp.vec3],
):
    p = wp.tid()
    if inverse_mass[p] > 0.0:
        velocity = v[p] + (force[p] * inverse_mass[p] + gravity) * dt
        position = x[p] + velocity * dt
        for k in range(normal.shape[0]):
            depth = offset[k] - wp.dot(position, normal[k])
            speed = wp.dot(velocity, normal[k])
            if depth > 0.0 and speed < 0.0:
                velocity = velocity - normal[k] * ((1.0 + restitution[k]) * speed)
                position = position + normal[k] * depth
        v[p] = velocity
        x[p] = position
    force[p] = wp.vec3(0.0)


class Kernels:
    def __init__(self, scene):
        self.scene = scene
        planes = scene.plane_array()
        self.gravity = wp.vec3(*scene.gravity)
        self.springs = [
            wp.array(scene.between, dtype=wp.vec2i, device="cpu"),
            *map(self.column, (scene.stiffness, scene.damping, scene.rest_length)),
        ]
        self.inverse_mass = self.column(scene.inverse_mass)
        self.planes = [self.vectors(planes[:, :3]), self.column(planes[:, 3]), self.column(planes[:, 4])]
        self.run(1e-4, 1e-4)

    @staticmethod
    def column(values):
        return wp.array(values.astype(np.float32), dtype=float, device="cpu")

    @staticmethod
    def vectors(values):
        return wp.array(values.astype(np.float32), dtype=wp.vec3, device="cpu")

    def run(self, time_step, duration):
        x, v = self.vectors(self.scene.position), self.vectors(self.scene.velocity)
        force = wp.zeros_like(x)
        springs, particles = len(self.scene.stiffness), len(self.scene.mass)

        def go():
            for _ in range(steps(time_step, duration)):
                wp.launch(add_springs, springs, [x, v, *self.springs, force], device="cpu")
                moved = [time_step, self.gravity, self.inverse_mass, *self.planes, x, v, force]
                wp.launch(move, particles, moved, device="cpu")

        cpu, _ = timed(go)
        return cpu, x.numpy()


def peer(_, scene):
    return Kernels(scene)
