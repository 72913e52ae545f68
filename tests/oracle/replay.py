"""A scenario, read and played: every frame, one after the other, with nothing skipped.

`replay.py SCENARIO.json...` prints the part of `hyrax-sim run --json` that concerns the runs themselves.
"""

import itertools
import json
import struct
import sys

import xxhash

import clock

GRAVITY_PX_PER_S2 = 1200.0
RESTITUTION = 0.6
AIR_DRAG = 0.999
GROUND_FRICTION = 0.8
REST_THRESHOLD_PX_PER_S = 5.0

LEFT, RIGHT, TOP, GROUND, REST = 1, 2, 4, 8, 16
WALLS = {"left": LEFT, "right": RIGHT, "top": TOP, "ground": GROUND}
ROW = struct.Struct("<dddddB")
ROWS_PER_BLOCK = 4096


# --- reading -----------------------------------------------------------------------------------------------------


def load(path):
    """The JSON of a file that is a good scenario. `-0` keeps its sign, which json would take for the integer 0."""
    with open(path, encoding="utf-8") as file:
        return json.load(file, parse_int=lambda text: -0.0 if text == "-0" else int(text))


def sizes_of(value):
    """(width, height) of what an object gives: of the window, of the sprite, or of both."""
    return {key: tuple(int(value[key][side]) for side in ("width_px", "height_px"))
            for key in ("window", "sprite") if key in value}


class Event:
    """One input: its frame, or its time, its kind and its numbers."""

    NUMBERS = ("x_px", "y_px", "vx_px_per_s", "vy_px_per_s", "dt_s")

    def __init__(self, value):
        self.frame = int(value["step"]) if "step" in value else None
        self.at_s = float(value["at_s"]) if "at_s" in value else None
        (self.kind, action), = ((key, each) for key, each in value.items() if key not in ("step", "at_s"))
        self.numbers = sizes_of(action) if self.kind == "resize" else tuple(
            float(action[key]) for key in self.NUMBERS if key in action)

    def is_due(self, frame, start_s, dt_s):
        """Whether it acts in a frame at the latest."""
        return self.frame <= frame if self.at_s is None else clock.is_due(start_s, self.at_s, dt_s)


class Scenario:
    """One scripted fling, with its quantities as the replay needs them."""

    def __init__(self, text):
        self.sizes = sizes_of(text)
        self.start = tuple(float(text["start"].get(key, 0)) for key in ("x_px", "y_px", "vx_px_per_s", "vy_px_per_s"))
        self._read_clock(text["clock"])
        self.steps = self._read_steps(text)
        self.events = [Event(value) for value in text.get("events", [])]

    def _read_clock(self, value):
        """Sets base_dt_s or, for an array, trace_s; the other is None. dts_s() gives every dt from the first on."""
        self.base_dt_s = self.trace_s = None
        if isinstance(value.get("dt_s"), list):
            self.trace_s = list(map(float, value["dt_s"]))
            self.dts_s = lambda: iter(self.trace_s)
            return
        self.base_dt_s = 1.0 / float(value["rate_hz"]) if "rate_hz" in value else float(value["dt_s"])
        if jitter := value.get("jitter"):
            parameter = float(jitter[clock.JITTERS[jitter["kind"]][0]])
            self.dts_s = lambda: clock.jittered_dts_s(jitter["kind"], self.base_dt_s, parameter, int(jitter["seed"]))
        else:
            self.dts_s = lambda: itertools.repeat(self.base_dt_s)

    def _read_steps(self, text):
        if self.trace_s is not None:
            return len(self.trace_s)
        return int(text["steps"]) if "steps" in text else clock.steps_of_duration(float(text["duration_s"]), self.base_dt_s)


# --- playing -----------------------------------------------------------------------------------------------------


class Sprite:
    """The state, and the published step. Each operation is one rounded binary64 operation, in the published order."""

    __slots__ = ("x", "y", "vx", "vy", "met_x", "met_y")

    def __init__(self, x, y, vx, vy):
        self.x, self.y, self.vx, self.vy = x, y, vx, vy
        self.met_x = self.met_y = None  # (vx before, vy before, vx after, vy after, overshoot) of the last clamp.

    def update(self, dt_s, right_px, bottom_px):
        """One step; returns the contact byte. Each clamp is recorded when applied, not inferred from the result."""
        vy = (self.vy + GRAVITY_PX_PER_S2 * dt_s) * AIR_DRAG
        vx = self.vx * AIR_DRAG
        x = self.x + vx * dt_s
        y = self.y + vy * dt_s
        contact = 0

        if x < 0.0:
            before, overshoot, contact = vx, -x, LEFT
            x = 0.0
            vx = -vx * RESTITUTION
            self.met_x = (before, vy, vx, vy, overshoot)
        elif x > right_px:
            before, overshoot, contact = vx, x - right_px, RIGHT
            x = right_px
            vx = -vx * RESTITUTION
            self.met_x = (before, vy, vx, vy, overshoot)

        if y < 0.0:
            before, overshoot = vy, -y
            contact |= TOP
            y = 0.0
            vy = -vy * RESTITUTION
            self.met_y = (vx, before, vx, vy, overshoot)
        elif y > bottom_px:
            vx_before, vy_before, overshoot = vx, vy, y - bottom_px
            contact |= GROUND
            y = bottom_px
            vy = -vy * RESTITUTION
            vx *= GROUND_FRICTION
            if abs(vy) < REST_THRESHOLD_PX_PER_S:
                contact |= REST
                vy = 0.0
            self.met_y = (vx_before, vy_before, vx, vy, overshoot)

        self.x, self.y, self.vx, self.vy = x, y, vx, vy
        return contact


class Replay:
    """A run in progress: the sprite, the sizes in force, whether it is held, and the events still to come."""

    def __init__(self, scenario):
        self.scenario = scenario
        self.sprite = Sprite(*scenario.start)
        self.sizes = dict(scenario.sizes)
        self.held = False
        self.pending = list(scenario.events)
        self._set_bounds()

    def _set_bounds(self):
        self.bounds_px = tuple(float(w - s) for w, s in zip(self.sizes["window"], self.sizes["sprite"], strict=True))

    def rows(self):
        """Yields (t, dt, x, y, vx, vy, contact): the start, then the state after every frame."""
        sprite, timeline, t_s = self.sprite, clock.Timeline(), 0.0
        yield 0.0, 0.0, sprite.x, sprite.y, sprite.vx, sprite.vy, 0
        for frame, dt_s in zip(range(self.scenario.steps), self.scenario.dts_s()):
            if self.pending:
                dt_s = self._apply_events(frame, t_s, dt_s)
            contact = 0 if self.held else sprite.update(dt_s, *self.bounds_px)
            t_s = timeline.advance(dt_s)
            yield t_s, dt_s, sprite.x, sprite.y, sprite.vx, sprite.vy, contact

    def _apply_events(self, frame, start_s, dt_s):
        """Apply what is due in this frame, in file order; returns the frame's dt, which a hitch replaces."""
        base_dt_s = dt_s if self.scenario.base_dt_s is None else self.scenario.base_dt_s
        while self.pending and self.pending[0].is_due(frame, start_s, base_dt_s):
            event = self.pending.pop(0)
            if event.kind == "hitch":
                dt_s, = event.numbers
            else:
                self._apply(event)
        return dt_s

    def _apply(self, event):
        sprite = self.sprite
        if event.kind in ("fling", "release"):
            sprite.vx, sprite.vy = event.numbers
        elif event.kind in ("stop", "grab"):
            sprite.vx = sprite.vy = 0.0
        elif event.kind == "place":
            sprite.x, sprite.y = event.numbers
        elif event.kind == "resize":
            self.sizes.update(event.numbers)
            self._set_bounds()
        if event.kind in ("grab", "release"):
            self.held = event.kind == "grab"


# --- results -----------------------------------------------------------------------------------------------------


class StateHash:
    """The hash over every row: a digest per block of rows, then a digest over those."""

    def __init__(self):
        self.block = bytearray(ROW.size * ROWS_PER_BLOCK)
        self.used = 0
        self.digests = []

    def add(self, dt_s, x, y, vx, vy, contact):
        ROW.pack_into(self.block, self.used, dt_s, x, y, vx, vy, contact)
        self.used += ROW.size
        if self.used == len(self.block):
            self._close_block()

    def _close_block(self):
        self.digests.append(xxhash.xxh3_128_digest(memoryview(self.block)[:self.used]))
        self.used = 0

    def hexdigest(self):
        """The hash as 32 hex digits. Ends the last block, so that no row may follow."""
        if self.used:
            self._close_block()
        return xxhash.xxh3_128_hexdigest(b"".join(self.digests))


def play(scenario):
    """What `run --json` says about the run itself; rows and contacts, column by column, as a trajectory file has them."""
    replay, state_hash = Replay(scenario), StateHash()
    rows, contacts, running = [], [], {}
    steps_by_byte, starts_by_byte = [0] * 32, [0] * 32
    anchor_x, anchor_y, anchor_t_s = scenario.start[0], scenario.start[1], 0.0
    previous = 0
    for step, row in enumerate(replay.rows()):
        t_s, dt_s, x, y, vx, vy, contact = row
        rows.append((step, *row))
        state_hash.add(dt_s, x, y, vx, vy, contact)
        if contact:
            steps_by_byte[contact] += 1
            starts_by_byte[contact & ~previous] += 1
        previous = contact
        if abs(x - anchor_x) > 0.5 or abs(y - anchor_y) > 0.5:
            anchor_x, anchor_y, anchor_t_s = x, y, t_s
        for wall in WALLS.values() if contact or running else ():  # In this order, so that in a corner x comes before y.
            if not contact & wall:
                running.pop(wall, None)
                continue
            if wall not in running:
                met = replay.sprite.met_x if wall in (LEFT, RIGHT) else replay.sprite.met_y
                running[wall] = [step, step, wall, t_s, x, y, *met]
                contacts.append(running[wall])
            running[wall][1] = step

    def with_bit(counts, bit):
        return sum(count for byte, count in enumerate(counts) if byte & bit)

    def columns(names, entries):
        return {name: [entry[place] for entry in entries] for place, name in enumerate(names.split())}

    return {
        "steps": scenario.steps,
        "simulated_s": t_s,
        "contacts": {name: with_bit(starts_by_byte, bit) for name, bit in WALLS.items()},
        "clamped_steps": {name: with_bit(steps_by_byte, bit) for name, bit in (*WALLS.items(), ("rest", REST))},
        "final": {"x_px": x, "y_px": y, "vx_px_per_s": vx, "vy_px_per_s": vy},
        "at_rest_since_s": anchor_t_s if t_s - anchor_t_s >= 1.0 else None,
        "state_hash": state_hash.hexdigest(),
    }, columns("step t dt x y vx vy contact", rows), columns(
        "step last_step wall t x y vx_before vy_before vx_after vy_after overshoot", contacts)


if __name__ == "__main__":
    print(json.dumps({"runs": [{"scenario": path, **play(Scenario(load(path)))[0]} for path in sys.argv[1:]]}, indent=2))
