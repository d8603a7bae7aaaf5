"""Numba: the textbook loop, compiled; f32 or f64, without fast-math."""

import numpy as np
from numba import njit

from worker import steps, timed


@njit(cache=True)
def spring_forces(x, v, between, stiffness, damping, rest_length, force):
    zero = x.dtype.type(0)
    for s in range(len(between)):
        i, j = between[s, 0], between[s, 1]
        dx, dy, dz = x[j, 0] - x[i, 0], x[j, 1] - x[i, 1], x[j, 2] - x[i, 2]
        length = np.sqrt(dx * dx + dy * dy + dz * dz)
        if length == zero:
            continue
        rate = ((v[j, 0] - v[i, 0]) * dx + (v[j, 1] - v[i, 1]) * dy + (v[j, 2] - v[i, 2]) * dz) / length
        q = (stiffness[s] * (length - rest_length[s]) + damping[s] * rate) / length
        force[i, 0] += q * dx
        force[i, 1] += q * dy
        force[i, 2] += q * dz
        force[j, 0] -= q * dx
        force[j, 1] -= q * dy
        force[j, 2] -= q * dz


@njit(cache=True)
def run(count, dt, x, v, inverse_mass, gravity, between, stiffness, damping, rest_length, planes, force):
    zero, one = x.dtype.type(0), x.dtype.type(1)
    for _ in range(count):
        force[:] = zero
        spring_forces(x, v, between, stiffness, damping, rest_length, force)
        for p in range(len(x)):
            if inverse_mass[p] == zero:
                continue
            for c in range(3):
                v[p, c] += dt * (force[p, c] * inverse_mass[p] + gravity[c])
                x[p, c] += dt * v[p, c]
            for k in range(len(planes)):
                nx, ny, nz, offset, restitution = planes[k]
                depth = offset - (x[p, 0] * nx + x[p, 1] * ny + x[p, 2] * nz)
                speed = v[p, 0] * nx + v[p, 1] * ny + v[p, 2] * nz
                if depth > zero and speed < zero:
                    impulse = (one + restitution) * speed
                    v[p, 0] -= impulse * nx
                    v[p, 1] -= impulse * ny
                    v[p, 2] -= impulse * nz
                    x[p, 0] += depth * nx
                    x[p, 1] += depth * ny
                    x[p, 2] += depth * nz


class Loop:
    def __init__(self, scene, real):
        self.scene, self.real = scene, real
        columns = scene.stiffness, scene.damping, scene.rest_length
        self.constant = [
            scene.inverse_mass.astype(real),
            scene.gravity.astype(real),
            scene.between,
            *(column.astype(real) for column in columns),
            scene.plane_array().astype(real),
        ]
        # Compiles, or reads what was compiled before.
        self.run(0.0001, 0.0001)

    def run(self, time_step, duration):
        x, v = (array.astype(self.real) for array in (self.scene.position, self.scene.velocity))
        count = steps(time_step, duration)
        cpu, _ = timed(lambda: run(count, self.real(time_step), x, v, *self.constant, np.empty_like(x)))
        return cpu, x


def peer(precision, scene):
    return Loop(scene, {"f32": np.float32, "f64": np.float64}[precision])
