"""SciPy: DOP853 with a compiled right-hand side, and backward Euler with one sparse factorisation a step; f64."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.sparse import coo_array, eye_array
from scipy.sparse.linalg import splu

from numba_loop import spring_forces
from numpy_loop import Loop
from worker import steps, timed


class Explicit:
    """`solve_ivp` to a tolerance, relative and absolute."""

    def __init__(self, scene, method, compiled):
        if scene.planes:
            raise ValueError("it solves smooth equations: no planes")
        self.scene, self.method = scene, method
        self.inverse_mass = scene.inverse_mass[:, None]
        self.gravity = np.where(self.inverse_mass > 0, scene.gravity, 0)
        self.start = np.concatenate([scene.position.ravel(), scene.velocity.ravel()])
        self.numpy = None if compiled else Loop(scene)
        self.rate(0.0, self.start)

    def rate(self, _, y):
        scene = self.scene
        x, v = y.reshape(2, -1, 3)
        if self.numpy:
            acceleration = self.numpy.accelerations(x, v)
        else:
            force = np.zeros_like(x)
            spring_forces(x, v, scene.between, scene.stiffness, scene.damping, scene.rest_length, force)
            acceleration = force * self.inverse_mass + self.gravity
        return np.concatenate([y[y.size // 2 :], acceleration.ravel()])

    def run(self, tolerance, duration):
        def go():
            span = (0.0, duration)
            return solve_ivp(self.rate, span, self.start, self.method, [duration], rtol=tolerance, atol=tolerance)

        cpu, solution = timed(go)
        if not solution.success:
            raise RuntimeError(solution.message)
        return cpu, solution.y[: self.start.size // 2, -1]


class BackwardEuler(Loop):
    """(M − dt ∂f/∂v − dt² ∂f/∂x) Δv = dt (f + dt ∂f/∂x v), solved once a step."""

    def __init__(self, scene):
        super().__init__(scene)
        if scene.planes:
            raise ValueError("it solves smooth equations: no planes")
        count = len(scene.mass)
        free = np.setdiff1d(np.arange(count), scene.pinned)
        # The row and column of each free component; −1 for what does not move.
        number = np.full((count, 3), -1)
        number[free] = np.arange(3 * len(free)).reshape(-1, 3)
        self.free, self.number = free, number
        self.mass = eye_array(3 * len(free), format="csc") * scene.mass[free].repeat(3)
        rows, columns, signs = [], [], []
        for a, b, sign in [(self.i, self.i, -1), (self.i, self.j, 1), (self.j, self.i, 1), (self.j, self.j, -1)]:
            rows.append(np.broadcast_to(number[a][:, :, None], (len(a), 3, 3)).ravel())
            columns.append(np.broadcast_to(number[b][:, None, :], (len(a), 3, 3)).ravel())
            signs.append(np.full(9 * len(a), sign))
        rows, columns, self.signs = map(np.concatenate, (rows, columns, signs))
        self.kept = (rows >= 0) & (columns >= 0)
        self.place = rows[self.kept], columns[self.kept]

    def matrix(self, blocks):
        """Of one 3 × 3 block a spring: how its force on i changes with j."""
        values = (np.tile(blocks.ravel(), 4) * self.signs)[self.kept]
        return coo_array((values, self.place), self.mass.shape).tocsc()

    def jacobians(self, x, v):
        scene = self.scene
        d = x[self.j] - x[self.i]
        length = np.linalg.norm(d, axis=1)
        d /= length[:, None]
        w = v[self.j] - v[self.i]
        rate = np.einsum("sc,sc->s", w, d)
        tension = scene.stiffness * (length - scene.rest_length) + scene.damping * rate
        along = np.einsum("sa,sb->sab", d, d)
        across = np.eye(3) - along
        turned = np.einsum("sa,sb->sab", d, w - rate[:, None] * d)
        by_position = scene.stiffness[:, None, None] * along + (tension / length)[:, None, None] * across
        by_position += (scene.damping / length)[:, None, None] * turned
        return self.matrix(by_position), self.matrix(scene.damping[:, None, None] * along)

    def run(self, time_step, duration):
        x, v = self.scene.position.copy(), self.scene.velocity.copy()
        mass, free = self.scene.mass[:, None], self.free

        def go():
            for _ in range(steps(time_step, duration)):
                by_position, by_velocity = self.jacobians(x, v)
                system = self.mass - time_step * by_velocity - time_step**2 * by_position
                force = (mass * self.accelerations(x, v))[free].ravel()
                right = time_step * (force + time_step * (by_position @ v[free].ravel()))
                v[free] += splu(system.tocsc()).solve(right).reshape(-1, 3)
                x[:] += time_step * v

        cpu, _ = timed(go)
        return cpu, x


def peer(variant, scene):
    if variant == "backward-euler":
        return BackwardEuler(scene)
    method, right_hand_side = variant.split(":")
    return Explicit(scene, method, right_hand_side == "numba")
