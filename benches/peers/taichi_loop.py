"""Taichi: forces gathered by each particle from a list of its springs, or added atomically by each spring; f32."""

import numpy as np
import taichi as ti

from worker import steps, timed

ti.init(arch=ti.cpu, cpu_max_num_threads=1, default_fp=ti.f32, log_level=ti.ERROR)


@ti.data_oriented
class Kernels:
    def __init__(self, scene, gathered):
        self.scene, self.gathered = scene, gathered
        planes = scene.plane_array()
        self.plane_count = len(planes)
        planes = np.vstack([planes, np.zeros((1, 5))])  # a field of nothing cannot be made
        self.normal, self.offset, self.restitution = (
            field(part) for part in (planes[:, :3], planes[:, 3], planes[:, 4])
        )
        self.inverse_mass = field(scene.inverse_mass)
        self.gravity = ti.math.vec3(*scene.gravity)
        self.x, self.v, self.force = (field(np.zeros_like(scene.position)) for _ in range(3))
        if len(scene.between):
            self.add_springs_of(scene)
        self.run(1e-4, 1e-4)

    def add_springs_of(self, scene):
        i, j = scene.between.T
        columns = scene.stiffness, scene.damping, scene.rest_length
        if self.gathered:
            # Each spring twice, once for each end, and where the springs of each particle end.
            order = np.argsort(np.concatenate([i, j]), kind="stable")
            j, i = np.concatenate([j, i])[order], np.concatenate([i, j])[order]
            self.end = field(np.searchsorted(i, np.arange(-1, len(scene.mass)), side="right"), ti.i32)
            columns = [np.tile(column, 2)[order] for column in columns]
        self.i, self.j = field(i, ti.i32), field(j, ti.i32)
        self.stiffness, self.damping, self.rest_length = map(field, columns)

    @ti.func
    def pull(self, i, j, s):
        d = self.x[j] - self.x[i]
        length = d.norm()
        force = ti.math.vec3(0.0)
        if length > 0.0:
            direction = d / length
            rate = (self.v[j] - self.v[i]).dot(direction)
            force = direction * (self.stiffness[s] * (length - self.rest_length[s]) + self.damping[s] * rate)
        return force

    @ti.kernel
    def add_springs(self):
        for s in self.i:
            i, j = self.i[s], self.j[s]
            force = self.pull(i, j, s)
            self.force[i] += force
            self.force[j] -= force

    @ti.kernel
    def gather_springs(self):
        for p in self.x:
            force = ti.math.vec3(0.0)
            for s in range(self.end[p], self.end[p + 1]):
                force += self.pull(p, self.j[s], s)
            self.force[p] = force

    @ti.kernel
    def move(self, dt: ti.f32):
        for p in self.x:
            if self.inverse_mass[p] > 0.0:
                velocity = self.v[p] + (self.force[p] * self.inverse_mass[p] + self.gravity) * dt
                position = self.x[p] + velocity * dt
                for k in ti.static(range(self.plane_count)):
                    depth = self.offset[k] - position.dot(self.normal[k])
                    speed = velocity.dot(self.normal[k])
                    if depth > 0.0 and speed < 0.0:
                        velocity -= self.normal[k] * ((1.0 + self.restitution[k]) * speed)
                        position += self.normal[k] * depth
                self.v[p] = velocity
                self.x[p] = position
            self.force[p] = ti.math.vec3(0.0)

    def run(self, time_step, duration):
        self.x.from_numpy(self.scene.position.astype(np.float32))
        self.v.from_numpy(self.scene.velocity.astype(np.float32))
        self.force.fill(0.0)
        forces = self.gather_springs if self.gathered else self.add_springs

        def go():
            for _ in range(steps(time_step, duration)):
                if len(self.scene.between):
                    forces()
                self.move(time_step)
            ti.sync()

        cpu, _ = timed(go)
        return cpu, self.x.to_numpy()


def field(values, real=ti.f32):
    made = ti.Vector.field(3, real, len(values)) if values.ndim == 2 else ti.field(real, len(values))
    made.from_numpy(np.ascontiguousarray(values, np.int32 if real == ti.i32 else np.float32))
    return made


def peer(variant, scene):
    return Kernels(scene, variant == "gather")
