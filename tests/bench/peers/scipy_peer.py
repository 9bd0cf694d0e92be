"""The towers by SciPy's DOP853 and LSODA with event location: every touch and release is an event, and the solver
starts again there.  usage: scipy_peer.py SCENE.json [SECONDS_OF_MOTION]"""
import sys

import numpy as np
from scipy.integrate import solve_ivp

from peer import clock, row, scene_from_arguments

INSIDE = 24  # looks into a step whose ends come near the largest value yet


class Problem:
    def __init__(self, scene):
        n = scene.floors
        self.scene = scene
        self.n = n
        inverse = 1 / scene.mass[:, None]
        self.linear = np.hstack([-inverse * scene.stiffness, -inverse * scene.damping])  # total acceleration of a state
        self.push = scene.reach.T * inverse  # (floors x contacts): what a force does
        self.closed = np.zeros(len(scene.contacts), dtype=bool)

    def ground(self, t):
        at = t / self.scene.dt
        i = int(at)
        if i + 1 >= len(self.scene.ground):
            return 0.0
        a = self.scene.ground
        return a[i] + (at - i) * (a[i + 1] - a[i])

    def force(self, y):
        s = self.scene
        d = s.reach @ y[: self.n] - s.clearance
        return d, s.k * d + s.c * (s.reach @ y[self.n :])

    def total(self, y):
        a = self.linear @ y
        if self.closed.any():
            _, f = self.force(y)
            a -= self.push @ np.where(self.closed, np.maximum(f, 0), 0)
        return a

    def totals(self, states):
        """Total accelerations (times x floors) of states (2 floors x times)."""
        s = self.scene
        f = s.k[:, None] * (s.reach @ states[: self.n] - s.clearance[:, None])
        f += s.c[:, None] * (s.reach @ states[self.n :])
        f = np.where(self.closed[:, None], np.maximum(f, 0), 0)
        return (self.linear @ states - self.push @ f).T

    def slope(self, t, y):
        return np.concatenate([y[self.n :], self.total(y) - self.ground(t)])

    def events(self):
        """The first contact to touch, or to let go."""

        def make(c, closed):
            def event(_, y):
                d, f = self.force(y)
                return f[c] if closed else d[c]

            event.terminal = True
            event.direction = -1 if closed else 1
            return event

        return [make(c, closed) for c, closed in enumerate(self.closed)]


def vertex(a, b, c):
    """The largest of values at equal steps, or of the parabolas through three."""
    bend = a - 2 * b + c
    rise = 0.5 * (c - a)
    most = np.maximum(np.abs(a), np.maximum(np.abs(b), np.abs(c)))
    with np.errstate(divide="ignore", invalid="ignore"):
        top = np.abs(b - 0.5 * rise * rise / bend)
    return np.where(np.abs(rise) < np.abs(bend), np.maximum(most, top), most)


def look(problem, solution, peaks):
    """Peaks of a piece: the ends of its steps, and the inside of those that come near the largest yet."""
    ends = problem.totals(solution.y)
    np.maximum(peaks, np.max(np.abs(ends), axis=0), out=peaks)
    for i in range(len(solution.t) - 1):
        if not (np.maximum(np.abs(ends[i]), np.abs(ends[i + 1])) > 0.7 * peaks).any():
            continue
        t = np.linspace(solution.t[i], solution.t[i + 1], INSIDE + 1)
        a = problem.totals(solution.sol(t))
        np.maximum(peaks, np.max(vertex(a[:-2], a[1:-1], a[2:]), axis=0), out=peaks)


def integrate(scene, method, tolerance, end):
    problem = Problem(scene)
    t, y = 0.0, np.zeros(2 * scene.floors)
    peaks = np.zeros(scene.floors)
    while t < end:
        piece = solve_ivp(problem.slope, (t, end), y, method=method, rtol=tolerance, atol=0.01 * tolerance,
                          events=problem.events(), max_step=scene.dt, dense_output=True)
        if piece.status < 0:
            raise RuntimeError(piece.message)
        look(problem, piece, peaks)
        if piece.status == 0:
            break
        t, y = piece.t[-1], piece.y[:, -1]
        for c, times in enumerate(piece.t_events):
            if len(times):
                problem.closed[c] = not problem.closed[c]
        np.maximum(peaks, np.abs(problem.total(y)), out=peaks)  # the other side of the jump
    return peaks


def main():
    scene = scene_from_arguments()
    end = min(scene.end, float(sys.argv[2])) if len(sys.argv) > 2 else scene.end
    for method in ("DOP853", "LSODA"):
        for tolerance in (1e-4, 1e-6, 1e-8, 1e-10):
            start = clock()
            peaks = integrate(scene, method, tolerance, end)
            row(f"scipy-{method.lower()}", tolerance, clock() - start, scene.error(peaks))


if __name__ == "__main__":
    main()
