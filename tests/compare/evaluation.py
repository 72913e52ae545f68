"""The lines of the card once more, in Python: cores as changes of the oracle (tests/oracle/replay.py), the contact rule,
closed forms of flight. Shares no code with the program.
"""

import math
import types
import unittest.mock

import clock
import flings
import replay

LEFT, RIGHT, TOP, GROUND, REST = replay.LEFT, replay.RIGHT, replay.TOP, replay.GROUND, replay.REST
G, K = 1200.0, -60.0 * math.log(0.999)  # The paper's gravity, and its drag as a rate at 60 Hz.
RATES = [24, 25, 30, 48, 50, 60, 72, 75, 90, 100, 120, 144, 165, 200, 240, 360, 500, 1000]
RIGHT_PX, BOTTOM_PX = flings.RIGHT_PX, flings.BOTTOM_PX


class PositionFirst(replay.Sprite):
    """The position moves with the speed of the frame before. Contacts are noted as walls are met."""

    def update(self, dt_s, right_px, bottom_px):
        contact = 0
        self.x, self.y = self.x + self.vx * dt_s, self.y + self.vy * dt_s
        self.vx, self.vy = self.vx * 0.999, (self.vy + G * dt_s) * 0.999
        if self.x < 0.0 or self.x > right_px:
            contact = LEFT if self.x < 0.0 else RIGHT
            self.x = 0.0 if self.x < 0.0 else right_px
            self.vx = -self.vx * 0.6
        if self.y < 0.0:
            contact |= TOP
            self.y, self.vy = 0.0, -self.vy * 0.6
        elif self.y > bottom_px:
            contact |= GROUND
            self.y, self.vy, self.vx = bottom_px, -self.vy * 0.6, self.vx * 0.8
            if abs(self.vy) < 5.0:
                self.vy = 0.0
        return contact | (REST if contact & GROUND and self.vy == 0.0 else 0)


# Candidates by name: constants of the oracle, or another step.
CORES = {
    "same": (replay.Sprite, {}),
    "gravity_by_one_ulp": (replay.Sprite, {"GRAVITY_PX_PER_S2": 1200.0000000000002}),
    "bounce_softer": (replay.Sprite, {"RESTITUTION": 0.55}),
    "no_rest_rule": (replay.Sprite, {"REST_THRESHOLD_PX_PER_S": 0.0}),
    "position_first": (PositionFirst, {}),
}


def core(name):
    """While it lasts, the oracle plays this core."""
    sprite, constants = CORES[name]
    return unittest.mock.patch.multiple(replay, Sprite=sprite, **constants)


def play(scenario):
    """All rows (t, dt, x, y, vx, vy, contact) by the core in use."""
    return list(replay.Replay(scenario).rows())


# --- comparison


def contacts(rows):
    """{wall: {(first row, row after the last)}}"""
    found = {}
    for wall in (LEFT, RIGHT, TOP, GROUND):
        met = [False, *(bool(row[6] & wall) for row in rows), False]
        ends = [step for step in range(len(rows) + 1) if met[step] != met[step + 1]]
        found[wall] = set(zip(ends[::2], ends[1::2]))
    return found


def is_rounding(a, b):
    """Whether two rows differ by rounding alone."""
    return (a[6] == b[6] and all(abs(a[n] - b[n]) <= 1e-6 for n in (2, 3)) and
            all(abs(a[n] - b[n]) <= 1e-6 + 1e-12 * max(abs(a[n]), abs(b[n])) for n in (4, 5)))


def compare(before, after):
    """How two runs of a scenario differ: class (None: same bits), contacts, distances."""
    a, b = contacts(before), contacts(after)
    gone = {wall: len(a[wall] - b[wall]) for wall in a}
    come = {wall: len(b[wall] - a[wall]) for wall in a}
    moved = sum(min(gone[wall], come[wall]) for wall in a)
    distances = [math.hypot(p[2] - q[2], p[3] - q[3]) for p, q in zip(before, after)]
    same = all(p[:6] == q[:6] for p, q in zip(before, after))
    has_other_walls = any((p[6] ^ q[6]) & ~REST for p, q in zip(before, after))
    if same:
        kind = None
    elif sum(gone.values()) + sum(come.values()) or has_other_walls:
        kind = "contacts"
    else:
        kind = "rounding" if all(map(is_rounding, before, after)) else "values"
    return types.SimpleNamespace(
        kind=kind, moved=moved, only_before=sum(gone.values()) - moved, only_after=sum(come.values()) - moved,
        max_px=max(distances), end_px=distances[-1], contacts=(sum(map(len, a.values())), sum(map(len, b.values()))))


# --- random flings


def fling(seed, number):
    """x, y, vx, vy of a random fling."""
    return tuple(low + (high - low) * clock.unit(seed, 4 * number + which)
                 for which, (low, high) in enumerate([(0.0, RIGHT_PX), (0.0, BOTTOM_PX), (-2000.0, 2000.0),
                                                      (-2000.0, 500.0)]))


def play_fling(start, rate_hz=60.0, steps=1200):
    """Rows of a fling on the paper's desktop by the core in use."""
    sprite, dt_s = replay.Sprite(*start), 1.0 / rate_hz
    rows = [(0.0, 0.0, *start, 0)]
    for step in range(1, steps + 1):
        contact = sprite.update(dt_s, RIGHT_PX, BOTTOM_PX)
        rows.append((step * dt_s, dt_s, sprite.x, sprite.y, sprite.vx, sprite.vy, contact))
    return rows


def settles_at(rows):
    """Since when the sprite has not been more than half a pixel from its anchor; None: it settled less than a second
    before the end."""
    anchor = rows[0]
    for row in rows:
        if abs(row[2] - anchor[2]) > 0.5 or abs(row[3] - anchor[3]) > 0.5:
            anchor = row
    return anchor[0] if rows[-1][0] - anchor[0] >= 1.0 else None


def spread_px(start):
    """Largest minus smallest x where a fling lands on all displays; None where it does not settle on one."""
    landings = []
    for rate_hz in RATES:
        rows = play_fling(start, rate_hz, int(19.0 * rate_hz) + int(rate_hz))
        earlier, end = rows[int(19.0 * rate_hz)], rows[-1]
        if math.hypot(end[2] - earlier[2], end[3] - earlier[3]) > 0.5:
            return None
        landings.append(end[2])
    return max(landings) - min(landings)


def moved_px(rate_hz):
    """How far a sprite still moves up and down in the 20th second after it was dropped from 100 px."""
    ys = [row[3] for row in play_fling((RIGHT_PX / 2.0, BOTTOM_PX - 100.0, 0.0, 0.0), rate_hz, 20 * rate_hz)]
    return max(ys[19 * rate_hz:]) - min(ys[19 * rate_hz:])


# --- the exact flight


def flown(speed, acceleration, rate, t_s):
    """(displacement, speed) after t_s of v' = acceleration - rate v."""
    lost = -math.expm1(-rate * t_s)
    limit = acceleration / rate
    return limit * t_s + (speed - limit) * lost / rate, speed + (limit - speed) * lost


def energy(vx, vy, y):
    """Specific energy over the floor, px²/s²."""
    return (vx * vx + vy * vy) / 2.0 + G * (BOTTOM_PX - y)


def drift(rows):
    """Energy of the run minus that of the exact flight from the same start, at the end of each arc of at least two
    steps, summed."""
    clamped = [step for step, row in enumerate(rows) if row[6]]
    starts = [0] + clamped
    ends = [step - 1 for step in clamped] + [len(rows) - 1]
    total = 0.0
    for first, last in zip(starts, ends):
        if last - first < 2:
            continue
        _, _, _, y, vx, vy, _ = rows[first]
        t_s = (last - first) / 60.0
        dy, vy_exact = flown(vy, G, K, t_s)
        total += energy(*rows[last][4:6], rows[last][3]) - energy(flown(vx, 0.0, K, t_s)[1], vy_exact, y + dy)
    return total


def at_walls(rows):
    """(lift, bounce, friction): energy of rows that touch a wall minus that of the exact flight from the row before,
    until the fling settles."""
    lift = bounce = friction = 0.0
    end_s = settles_at(rows)
    for (_, _, _, y0, vx0, vy0, _), (t_s, dt_s, _, y, vx, vy, contact) in zip(rows, rows[1:]):
        if end_s is not None and t_s > end_s:
            break
        if not contact:
            continue
        _, vx_exact = flown(vx0, 0.0, K, dt_s)
        dy_exact, vy_exact = flown(vy0, G, K, dt_s)
        lift += G * (y0 + dy_exact - y)
        for gain, walls in ((vx**2 - vx_exact**2, LEFT | RIGHT), (vy**2 - vy_exact**2, TOP | GROUND)):
            if contact & walls:
                bounce += gain / 2.0
            else:
                friction += gain / 2.0
    return lift, bounce, friction
