"""Random flings, by the listing and by the fixed laws, for the numbers of `drift` and of the studies.

Written from the READMEs alone: frame methods step many flings at once by numpy, the exact fling goes from impact to impact.
"""

import dataclasses
import math

import numpy

import clock
import sweep

RIGHT_PX, BOTTOM_PX = 1792.0, 952.0
STILL_PX = 0.5
LEFT, RIGHT, TOP, GROUND = range(4)


@dataclasses.dataclass(frozen=True)
class Laws:
    """Constants of the listing."""

    gravity: float = 1200.0
    restitution: float = 0.6
    drag: float = 0.999
    friction: float = 0.8
    threshold: float = 5.0


def starts(count):
    """x, y, vx, vy of the flings of seed 77."""
    ranges = {"x_px": [0.0, RIGHT_PX], "y_px": [0.0, BOTTOM_PX], "vx_px_per_s": [-2000.0, 2000.0], "vy_px_per_s": [-2000.0, 500.0]}
    drawn = {"seed": 77, "vary": {f"/start/{key}": {"uniform": each} for key, each in ranges.items()}}
    return numpy.array([[sweep.inputs(drawn, member)[f"/start/{key}"] for key in ranges] for member in range(count)]).T


def starts_like(x, y, vx, vy, count):
    """x, y, vx, vy of one fling and of others of seed 13 within 20 px and 5 % of it."""
    near = [[x, y, vx, vy]]
    for first in range(0, 4 * (count - 1), 4):
        a, b, c, d = (2.0 * clock.unit(13, first + k) - 1.0 for k in range(4))
        near.append([min(max(x + 20.0 * a, 0.0), RIGHT_PX), min(max(y + 20.0 * b, 0.0), BOTTOM_PX),
                     vx * (1.0 + 0.05 * c), vy * (1.0 + 0.05 * d)])
    return numpy.array(near).T


def band(values):
    """Median, 10 and 90 %."""
    return tuple(numpy.quantile(values, (0.5, 0.1, 0.9)))


class Flings:
    """Flings at one rate. `by_time`: drag and friction as rates of 60 Hz."""

    def __init__(self, begin, laws, rate_hz, by_time=False):
        self.x, self.y, self.vx, self.vy = (numpy.array(each) for each in begin)
        self.laws, self.dt_s = laws, 1.0 / rate_hz
        self.by_time = by_time
        self.drag = laws.drag ** (60.0 / rate_hz) if by_time else laws.drag
        self.lasting_friction = laws.friction ** (60.0 / rate_hz) if by_time else laws.friction
        self.frames = 0
        self.on = numpy.zeros((4, self.x.size), bool)  # The walls that the last step clamped at.
        self.contacts = numpy.zeros((4, self.x.size), int)
        self.anchor_x, self.anchor_y, self.anchor_s = self.x.copy(), self.y.copy(), numpy.zeros(self.x.size)

    def step(self):
        self.vy = (self.vy + self.laws.gravity * self.dt_s) * self.drag
        self.vx = self.vx * self.drag
        self.x = self.x + self.vx * self.dt_s
        self.y = self.y + self.vy * self.dt_s
        on = numpy.array([self.x < 0.0, self.x > RIGHT_PX, self.y < 0.0, self.y > BOTTOM_PX])
        self.vx = numpy.where(on[LEFT] | on[RIGHT], -self.vx * self.laws.restitution, self.vx)
        self.vy = numpy.where(on[TOP] | on[GROUND], -self.vy * self.laws.restitution, self.vy)
        self.x, self.y = numpy.clip(self.x, 0.0, RIGHT_PX), numpy.clip(self.y, 0.0, BOTTOM_PX)
        friction = numpy.where(self.on[GROUND], self.lasting_friction, self.laws.friction)
        self.vx = numpy.where(on[GROUND], self.vx * friction, self.vx)
        self.vy = numpy.where(on[GROUND] & (abs(self.vy) < self.laws.threshold), 0.0, self.vy)
        self.contacts += on & ~self.on
        self.on = on
        self.frames += 1

    def play(self, duration_s):
        for _ in range(math.ceil(duration_s / self.dt_s)):
            self.step()
            moved = (abs(self.x - self.anchor_x) > STILL_PX) | (abs(self.y - self.anchor_y) > STILL_PX)
            self.anchor_x, self.anchor_y = numpy.where(moved, self.x, self.anchor_x), numpy.where(moved, self.y, self.anchor_y)
            self.anchor_s = numpy.where(moved, self.frames * self.dt_s, self.anchor_s)
        return self

    def energy(self):
        """Specific energy, 0 at rest on the floor."""
        return (self.vx**2 + self.vy**2) / 2 + self.laws.gravity * (BOTTOM_PX - self.y)


class ExactFling:
    """One fling by the fixed laws: drag and friction at the rates of 60 Hz, each impact at its exact time."""

    def __init__(self, x, y, vx, vy, laws=Laws()):
        self.laws, self.rate, self.sliding = laws, -60.0 * math.log(laws.drag), -60.0 * math.log(laws.friction)
        self.begin_s, self.x, self.y, self.vx, self.vy = 0.0, x, y, vx, vy
        self.slides, self.impacts, self.times = False, [], []
        self.next_s, self.next_wall = self.next_impact()

    def way(self, t):
        """What a speed of 1 px/s flies in t, and what gravity adds to the way."""
        rate = self.rate + (self.sliding if self.slides else 0.0)
        lost = -math.expm1(-rate * t) / rate
        return lost, 0.0 if self.slides else self.laws.gravity * (t - lost) / rate

    def fly(self, t):
        """x, y, vx, vy after t from the last impact."""
        (lost, fallen), rate = self.way(t), self.rate + (self.sliding if self.slides else 0.0)
        gained = 0.0 if self.slides else self.laws.gravity * lost
        return (self.x + self.vx * lost, self.y + self.vy * lost + fallen, self.vx - rate * self.vx * lost,
                self.vy - rate * self.vy * lost + gained)

    def next_impact(self):
        """Time after the last impact, and the wall."""
        found = [(math.inf, None)]
        if self.vx != 0.0:
            rate, wall = self.rate + (self.sliding if self.slides else 0.0), RIGHT if self.vx > 0.0 else LEFT
            part = rate * ((RIGHT_PX if wall == RIGHT else 0.0) - self.x) / self.vx
            if part < 1.0:
                found.append((-math.log1p(-part) / rate, wall))
        if not self.slides:
            turn = max(0.0, math.log1p(-self.rate * self.vy / self.laws.gravity) / self.rate) if self.vy < 0.0 else 0.0
            if self.fly(turn)[1] < 0.0:
                found.append((self.crossing(lambda t: -self.fly(t)[1], 0.0, turn), TOP))
            later = turn + 1.0
            while self.fly(later)[1] <= BOTTOM_PX:
                later += 1.0
            found.append((self.crossing(lambda t: self.fly(t)[1] - BOTTOM_PX, turn, later), GROUND))
        return min(found, key=lambda each: each[0])

    @staticmethod
    def crossing(past, low, high):
        """Where it becomes positive."""
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if past(middle) > 0.0 else (middle, high)
        return high

    def at(self, t):
        """x, y, vx, vy at a time not before the last one asked for."""
        while t >= self.begin_s + self.next_s:
            self.x, self.y, self.vx, self.vy = self.fly(self.next_s)
            self.begin_s += self.next_s
            self.bounce(self.next_wall)
            self.next_s, self.next_wall = self.next_impact()
        return self.fly(t - self.begin_s)

    def bounce(self, wall):
        self.impacts.append(wall)
        self.times.append(self.begin_s)
        if wall in (LEFT, RIGHT):
            self.x, self.vx = (RIGHT_PX if wall == RIGHT else 0.0), -self.vx * self.laws.restitution
            return
        self.y, self.vy = (BOTTOM_PX if wall == GROUND else 0.0), -self.vy * self.laws.restitution
        if wall == GROUND:
            self.vx *= self.laws.friction
            self.slides = abs(self.vy) < self.laws.threshold
            self.vy = 0.0 if self.slides else self.vy
