"""A scenario, read and played: every frame, one after the other, with nothing skipped."""

import decimal
import itertools
import json
import struct

import xxhash

import clock

GRAVITY_PX_PER_S2 = 1200.0
RESTITUTION = 0.6
AIR_DRAG = 0.999
GROUND_FRICTION = 0.8
REST_THRESHOLD_PX_PER_S = 5.0

LEFT, RIGHT, TOP, GROUND, REST = 1, 2, 4, 8, 16
WALLS = {"left": LEFT, "right": RIGHT, "top": TOP, "ground": GROUND}
MAX_MAGNITUDE = 1e12
MAX_STEPS = 10**12
MAX_SIDE_PX = 1_000_000

ROW = struct.Struct("<dddddB")
ROWS_PER_BLOCK = 4096


class ScenarioError(ValueError):
    """A scenario that breaks the rules of its format."""


# --- reading -----------------------------------------------------------------------------------------------------


def unique_pairs(pairs):
    """A JSON object; refuses duplicate keys."""
    if len({key for key, _ in pairs}) != len(pairs):
        raise ScenarioError("an object repeats a key")
    return dict(pairs)


def refuse_constant(text):
    """Refuses NaN and Infinity, which are not JSON although Python reads them."""
    raise ScenarioError(f"{text} is not a number")


def load(path):
    """The JSON of a file. Numbers stay decimal until it is known whether a real number or an integer is expected."""
    with open(path, encoding="utf-8") as file:
        return json.load(file, object_pairs_hook=unique_pairs, parse_constant=refuse_constant,
                         parse_float=decimal.Decimal, parse_int=decimal.Decimal)


def expect_keys(place, value, required, optional=()):
    """An object with all of the required keys and no unknown one."""
    if not isinstance(value, dict) or not set(required) <= set(value) <= set(required) | set(optional):
        raise ScenarioError(f"{place}: must be an object with {sorted(required)}, may have {sorted(optional)}")


def real(place, value, low=-MAX_MAGNITUDE, high=MAX_MAGNITUDE):
    """A real number as the nearest double; float() keeps the sign of -0."""
    if not isinstance(value, decimal.Decimal) or not low <= float(value) <= high:
        raise ScenarioError(f"{place}: must be a number from {low} to {high}, is {value}")
    return float(value)


def integer(place, value, low, high):
    """An integer in any notation: 60, 60.0 and 6e1 are the same."""
    if not isinstance(value, decimal.Decimal) or not low <= value <= high or value != value.to_integral_value():
        raise ScenarioError(f"{place}: must be a whole number from {low} to {high}, is {value}")
    return int(value)


def read_size_px(place, value, low):
    """(width, height) of a window or a sprite."""
    expect_keys(place, value, ["width_px", "height_px"])
    return tuple(integer(f"{place}/{key}", value[key], low, MAX_SIDE_PX) for key in ("width_px", "height_px"))


def read_sizes(place, value):
    """The sizes that an object gives: of the window, of the sprite, or of both."""
    return {key: read_size_px(f"{place}/{key}", value[key], low)
            for key, low in (("window", 0), ("sprite", 1)) if key in value}


class Event:
    """One input: its frame (None until a time is resolved), its time if it has one, its kind and its numbers."""

    VECTORS = {"fling": ("vx_px_per_s", "vy_px_per_s"), "release": ("vx_px_per_s", "vy_px_per_s"),
               "place": ("x_px", "y_px"), "stop": (), "grab": ()}

    def __init__(self, place, value, steps):
        expect_keys(place, value, [], ["step", "at_s", "hitch", "resize", *self.VECTORS])
        actions = [key for key in value if key not in ("step", "at_s")]
        if len(actions) != 1 or len(value) != 2:
            raise ScenarioError(f"{place}: needs one of step and at_s, and one action")
        self.place, self.kind = place, actions[0]
        self.frame = integer(f"{place}/step", value["step"], 0, steps - 1) if "step" in value else None
        self.at_s = real(f"{place}/at_s", value["at_s"]) if "at_s" in value else None
        self.numbers = self._read_numbers(f"{place}/{self.kind}", value[self.kind])

    def _read_numbers(self, place, value):
        if self.kind == "hitch":
            expect_keys(place, value, ["dt_s"])
            return real(f"{place}/dt_s", value["dt_s"], 0.0, clock.MAX_DT_S)
        if self.kind == "resize":
            expect_keys(place, value, [], ["window", "sprite"])
            return read_sizes(place, value)
        expect_keys(place, value, self.VECTORS[self.kind])
        return tuple(real(f"{place}/{key}", value[key]) for key in self.VECTORS[self.kind])


class Scenario:
    """One scripted fling, with its quantities as the replay needs them."""

    def __init__(self, text):
        expect_keys("", text, ["format", "window", "sprite", "start", "clock"],
                    ["$schema", "name", "description", "steps", "duration_s", "events", "record", "expect"])
        if text["format"] != "hyrax-scenario/1":
            raise ScenarioError("/format: only hyrax-scenario/1 is known")
        self.sizes = read_sizes("", text)
        start = text["start"]
        expect_keys("/start", start, ["x_px", "y_px"], ["vx_px_per_s", "vy_px_per_s"])
        self.start = tuple(real(f"/start/{key}", start.get(key, decimal.Decimal(0)))
                           for key in ("x_px", "y_px", "vx_px_per_s", "vy_px_per_s"))
        self._read_clock(text["clock"])
        self.steps = self._read_steps(text)
        self.events = [Event(f"/events/{n}", value, self.steps) for n, value in enumerate(text.get("events", []))]

    def _read_clock(self, value):
        """Sets base_dt_s (None for an array) and dts_s, a function that starts the dt sequence again."""
        expect_keys("/clock", value, [], ["rate_hz", "dt_s", "jitter"])
        if ("rate_hz" in value) == ("dt_s" in value):
            raise ScenarioError("/clock: needs exactly one of rate_hz and dt_s")
        self.trace_s = None
        if "rate_hz" in value:
            rate_hz = real("/clock/rate_hz", value["rate_hz"], 5e-324, 1e9)
            self.base_dt_s = 1.0 / rate_hz
        elif isinstance(value["dt_s"], list):
            self.base_dt_s = None
            self.trace_s = [real(f"/clock/dt_s/{n}", dt, 0.0, clock.MAX_DT_S) for n, dt in enumerate(value["dt_s"])]
        else:
            self.base_dt_s = real("/clock/dt_s", value["dt_s"], 0.0)
        if self.trace_s == [] or (self.base_dt_s is not None and self.base_dt_s > clock.MAX_DT_S):
            raise ScenarioError("/clock: needs at least one dt, none above 1e9 s")
        if "jitter" in value:
            if self.trace_s is not None:
                raise ScenarioError("/clock/jitter: does not go with an array")
            arguments = self._read_jitter(value["jitter"])
            self.dts_s = lambda: clock.jittered_dts_s(*arguments)
        elif self.trace_s is not None:
            self.dts_s = lambda: iter(self.trace_s)
        else:
            self.dts_s = lambda: itertools.repeat(self.base_dt_s)

    def _read_jitter(self, value):
        kind = value.get("kind") if isinstance(value, dict) else None
        if kind not in clock.JITTERS:
            raise ScenarioError(f"/clock/jitter/kind: must be one of {sorted(clock.JITTERS)}")
        key, highest, _ = clock.JITTERS[kind]
        expect_keys("/clock/jitter", value, ["kind", "seed", key])
        seed = integer("/clock/jitter/seed", value["seed"], 0, clock.MASK_64)
        return kind, self.base_dt_s, real(f"/clock/jitter/{key}", value[key], 0.0, highest), seed

    def _read_steps(self, text):
        if self.trace_s is not None:
            length = len(self.trace_s)
            if "duration_s" in text or integer("/steps", text.get("steps", decimal.Decimal(length)), 0, MAX_STEPS) != length:
                raise ScenarioError("/steps: an array gives the number of steps itself")
            return length
        if ("steps" in text) == ("duration_s" in text):
            raise ScenarioError("/steps: needs exactly one of steps and duration_s")
        if "steps" in text:
            return integer("/steps", text["steps"], 0, MAX_STEPS)
        duration_s = real("/duration_s", text["duration_s"], 0.0, float("inf"))
        if self.base_dt_s == 0.0 or not duration_s / self.base_dt_s <= MAX_STEPS:
            raise ScenarioError("/duration_s: needs a dt above 0 and at most 1e12 steps")
        return clock.steps_of_duration(duration_s, self.base_dt_s)


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
        if self.pending:
            raise ScenarioError(f"{self.pending[0].place}: is beyond the end")

    def _apply_events(self, frame, start_s, dt_s):
        """Apply what is due in this frame, in file order; returns the frame's dt, which a hitch replaces."""
        base_dt_s = dt_s if self.scenario.base_dt_s is None else self.scenario.base_dt_s
        # Every event is resolved at its time, even after one that is not due, so that a list out of order is detected.
        for event in self.pending:
            if event.frame is None and clock.is_due(start_s, event.at_s, base_dt_s):
                event.frame = frame
        while self.pending and self.pending[0].frame is not None and self.pending[0].frame <= frame:
            event = self.pending.pop(0)
            if event.frame < frame:
                raise ScenarioError(f"{event.place}: comes before the event above it")
            if event.kind == "hitch":
                dt_s = event.numbers
            else:
                self._apply(event)
        return dt_s

    def _apply(self, event):
        sprite = self.sprite
        if event.kind in ("grab", "release") and self.held == (event.kind == "grab"):
            raise ScenarioError(f"{event.place}: {event.kind} while {'held' if self.held else 'not held'}")
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
        """Append one row."""
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


def summarise(scenario):
    """Play a scenario; returns what `run --json` says about the run itself."""
    state_hash = StateHash()
    steps_by_byte, starts_by_byte = [0] * 32, [0] * 32
    anchor_x, anchor_y, anchor_t_s = scenario.start[0], scenario.start[1], 0.0
    previous = 0
    for t_s, dt_s, x, y, vx, vy, contact in Replay(scenario).rows():
        state_hash.add(dt_s, x, y, vx, vy, contact)
        if contact:
            steps_by_byte[contact] += 1
            starts_by_byte[contact & ~previous] += 1
        previous = contact
        if abs(x - anchor_x) > 0.5 or abs(y - anchor_y) > 0.5:
            anchor_x, anchor_y, anchor_t_s = x, y, t_s

    def with_bit(counts, bit):
        return sum(count for byte, count in enumerate(counts) if byte & bit)

    return {
        "steps": scenario.steps,
        "simulated_s": t_s,
        "contacts": {name: with_bit(starts_by_byte, bit) for name, bit in WALLS.items()},
        "clamped_steps": {name: with_bit(steps_by_byte, bit) for name, bit in (*WALLS.items(), ("rest", REST))},
        "final": {"x_px": x, "y_px": y, "vx_px_per_s": vx, "vy_px_per_s": vy},
        "at_rest_since_s": anchor_t_s if t_s - anchor_t_s >= 1.0 else None,
        "state_hash": state_hash.hexdigest(),
    }


def all_rows(scenario):
    """Play a short scenario; returns every row and every contact, each double as exact hexadecimal text."""
    replay = Replay(scenario)
    rows, contacts, running = [], [], {}
    for step, (t_s, dt_s, x, y, vx, vy, contact) in enumerate(replay.rows()):
        named = zip(("t", "dt", "x", "y", "vx", "vy"), (t_s, dt_s, x, y, vx, vy), strict=True)
        rows.append({"step": step, **{key: value.hex() for key, value in named}, "contact": contact})
        for wall in WALLS.values():  # In this order, so that in a corner x comes before y.
            if not contact & wall:
                running.pop(wall, None)
                continue
            if wall not in running:
                met = replay.sprite.met_x if wall in (LEFT, RIGHT) else replay.sprite.met_y
                keys = ("t", "x", "y", "vx_before", "vy_before", "vx_after", "vy_after", "overshoot")
                running[wall] = {"step": step, "last_step": step, "wall": wall,
                                 **{key: value.hex() for key, value in zip(keys, (t_s, x, y, *met), strict=True)}}
                contacts.append(running[wall])
            running[wall]["last_step"] = step
    return {"rows": rows, "contacts": contacts}
