#!/usr/bin/python3
"""The contacts of `drift` against the published definition, evaluated independently in 50 digits on random flights
into corners with uneven clocks."""

import decimal
import random

import h5py

from drift_program import DriftTest
from program import AGREED, main

D = decimal.Decimal
decimal.getcontext().prec = 50
SEED = 20
CASES = 60
RIGHT_PX, BOTTOM_PX = 1920 - 128, 1080 - 128
GRAVITY = D(1200)
DRAG = -D(0.999).ln()
LEFT, RIGHT, TOP, GROUND = WALLS = (1, 2, 4, 8)
NAMES = {LEFT: "left", RIGHT: "right", TOP: "top", GROUND: "ground"}


def random_clock(draw, frames):
    """A recorded or a jittered clock; zero-length frames and long ones among the rest."""
    kind = draw.randrange(4)
    if kind == 0:
        return {"dt_s": [draw.choice((0, 1e-6, 0.05, 0.1)) if draw.random() < 0.2 else draw.lognormvariate(-4.1, 0.7)
                         for _ in range(frames)]}, {}
    jitter = ({"kind": "uniform", "fraction": draw.uniform(0.5, 1)}, {"kind": "normal", "sigma_s": draw.uniform(0.005, 0.02)},
              {"kind": "missed_frames", "probability": draw.uniform(0.1, 0.5)})[kind - 1]
    return {"rate_hz": draw.choice((24, 60, 144)), "jitter": {**jitter, "seed": draw.randrange(2**64)}}, {"steps": frames}


def random_corner(draw, name):
    """A fling that would meet a wall in x and one in y after the same time."""
    time_s = draw.uniform(0.02, 0.6)
    at_floor = draw.random() < 0.75
    while True:
        vx, vy = draw.choice((-1, 1)) * draw.uniform(100, 2500), draw.uniform(-1200, 1200)
        x = (RIGHT_PX if vx > 0 else 0) - vx * time_s
        y = (BOTTOM_PX if at_floor else 0) - vy * time_s - 600 * time_s**2
        if 0 <= x <= RIGHT_PX and 0 <= y <= BOTTOM_PX:
            break
    clock, length = random_clock(draw, draw.randrange(20, 80))
    return {"format": "hyrax-scenario/1", "name": name, "window": {"width_px": 1920, "height_px": 1080},
            "sprite": {"width_px": 128, "height_px": 128}, "clock": clock, **length,
            "start": {"x_px": x, "y_px": y, "vx_px_per_s": vx, "vy_px_per_s": vy}}


class Axis:
    """One axis of the matched ODE in a frame of dt: position and speed t after its begin."""

    def __init__(self, position, speed, gravity, dt):
        self.position, self.speed, self.gravity, self.rate = position, speed, gravity, DRAG / dt

    def at(self, t):
        """Position and speed; v' = g - k v."""
        lost = (1 - (-self.rate * t).exp()) / self.rate
        return (self.position + self.speed * lost + self.gravity * (t - lost) / self.rate,
                self.speed + (self.gravity - self.rate * self.speed) * lost)

    def turn(self):
        """When the speed is 0, if ever."""
        if self.gravity == 0 or self.speed == 0 or (self.speed > 0) == (self.gravity > 0):
            return None
        return (1 - self.rate * self.speed / self.gravity).ln() / self.rate

    def crossing(self, wall, outward, t_max):
        """The first time in 0 .. t_max at which it leaves the inside."""
        def past(t):
            return outward * (self.at(t)[0] - wall)
        turn = self.turn()
        times = [D(0), *([turn] if turn is not None and turn < t_max else []), t_max]
        for low, high in zip(times, times[1:]):
            if past(low) > 0 or past(high) <= 0:
                continue
            if past(low) == 0:
                return low
            for _ in range(110):
                middle = (low + high) / 2
                low, high = (low, middle) if past(middle) > 0 else (middle, high)
            return high
        return None


class Arc:
    """The matched ODE from one row to another, and on from there."""

    def __init__(self, rows, first, last):
        self.rows, self.first, self.last = rows, first, last
        self.states = [tuple(D(float(rows[name][first])) for name in ("x", "y", "vx", "vy"))]
        for dt in rows["dt"][first + 1:last + 1]:
            self.states.append(self.flown(self.states[-1], D(float(dt))))

    @staticmethod
    def axes(state, dt):
        x, y, vx, vy = state
        return Axis(x, vx, D(0), dt), Axis(y, vy, GRAVITY, dt)

    def flown(self, state, dt):
        """The state a frame later; a zero-length frame only damps."""
        if dt == 0:
            return state[:2] + tuple(D(0.999) * speed for speed in state[2:])
        (x, vx), (y, vy) = (axis.at(dt) for axis in self.axes(state, dt))
        return x, y, vx, vy

    def largest_energy(self):
        return max(((vx**2 + vy**2) / 2 + GRAVITY * (BOTTOM_PX - y) for _, y, vx, vy in self.states), default=D(0))

    def impact(self, wall):
        """Time before the clamped row at which it crosses the wall, and the speed there."""
        index = 0 if wall in (LEFT, RIGHT) else 1
        place, outward = {LEFT: (0, -1), RIGHT: (RIGHT_PX, 1), TOP: (0, -1), GROUND: (BOTTOM_PX, 1)}[wall]
        frames = [D(float(dt)) for dt in self.rows["dt"][self.first + 1:self.last + 2]]
        clamped = frames.pop()
        rate_dt = next((dt for dt in reversed(frames) if dt > 0), clamped)
        frames = [(dt, dt) for dt in frames] + [(rate_dt, clamped + 2 * rate_dt)]
        left = sum(dt for dt, _ in frames[:-1]) + clamped
        for state, (dt, t_max) in zip(self.states, frames, strict=True):
            if dt > 0:
                axis = self.axes(state, dt)[index]
                t = axis.crossing(place, outward, t_max)
                if t is not None:
                    return left - t, abs(axis.at(t)[1])
            left -= dt
        return None


class Contacts(DriftTest):
    """Every one."""

    def test_those_of_corners_on_uneven_clocks_are_as_defined(self):
        draw = random.Random(SEED)
        for case in range(CASES):
            self.write(f"cases/{case:03}.json", random_corner(draw, f"c{case:03}"))
        self.write("out/keep", "")
        self.expect(AGREED, "run", "cases", "-o", "out/")
        runs = self.drift("cases")
        self.assertEqual(len(runs), CASES)
        corners = short = 0
        for case, run in enumerate(runs):
            with self.subTest(seed=SEED, case=case), h5py.File(self.folder / f"out/c{case:03}.h5") as file:
                self.assertEqual(run["reference_faults"], 0)
                found = self.check_run(run, file)
                corners += found[0]
                short += found[1]
        self.assertGreater(corners, CASES // 10)
        self.assertGreater(short, CASES // 10)

    def check_run(self, run, file):
        rows = {name: file[f"trajectory/{name}"][:] for name in ("dt", "x", "y", "vx", "vy", "contact")}
        stored = {(step, wall): index for index, (step, wall)
                  in enumerate(zip(file["contacts/step"], file["contacts/wall"], strict=True))}
        clamped = [step for step, contact in enumerate(rows["contact"]) if contact]
        ends = list(zip([0, *clamped], clamped))
        expected = [(begin, end, wall) for begin, end in ends for wall in WALLS
                    if rows["contact"][end] & wall and not (end - begin == 1 and rows["contact"][begin] & wall)]
        self.assertEqual([(end, wall) for _, end, wall in expected], list(stored))
        self.assertEqual([(contact["step"], contact["wall"]) for contact in run["contacts"]],
                         [(end, NAMES[wall]) for _, end, wall in expected])
        for contact, (begin, end, wall) in zip(run["contacts"], expected, strict=True):
            self.check_contact(contact, Arc(rows, begin, end - 1), wall, file["contacts"], stored[end, wall])
        return (sum(bin(rows["contact"][end] & 15).count("1") > 1 for _, end in ends),
                sum(end - begin <= 2 for begin, end, _ in expected))

    def check_contact(self, contact, arc, wall, stored, index):
        self.assertEqual(contact["overshoot_px"], stored["overshoot"][index])
        change = self.energy(arc.rows, arc.last + 1) - self.energy(arc.rows, arc.last)
        self.assert_near(contact["energy_jump_rel"], change / max(arc.largest_energy(), D(1200)), D("1e-9"))
        impact = arc.impact(wall)
        if impact is None:
            self.assertIsNone(contact["time_error_s"])
            self.assertIsNone(contact["effective_restitution"])
            return
        time_error, speed = impact
        self.assert_near(contact["time_error_s"], time_error, D("1e-9") / max(speed, 1))
        if speed == 0:  # It starts on the wall.
            self.assertIsNone(contact["effective_restitution"])
            return
        name = "vx" if wall in (LEFT, RIGHT) else "vy"
        self.assert_near(contact["effective_restitution"], abs(D(float(stored[f"{name}_after"][index]))) / speed,
                         D("1e-7"))

    @staticmethod
    def energy(rows, row):
        y, vx, vy = (D(float(rows[name][row])) for name in ("y", "vx", "vy"))
        return (vx**2 + vy**2) / 2 + GRAVITY * (BOTTOM_PX - y)

    def assert_near(self, actual, expected, tolerance):
        self.assertLessEqual(abs(D(actual) - expected), tolerance, (actual, float(expected)))


if __name__ == "__main__":
    main()
