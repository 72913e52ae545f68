"""The paper's claims, measured for sim/physics/claims.md: `claims.py [CLAIM...]` prints verdicts and figures.

What the core does comes from `hyrax-sim run` and `sweep`. Other orders of the step, springs, lossless bounces and exact motions are
computed here. The page has the throws; figures are in the order of its column "measured".
"""

import copy
import functools
import json
import math
import pathlib
import re
import statistics
import sys
import tempfile

import h5py
import numpy

import clock
import flings
import replay
import sweep
from process import succeed
from program import PROGRAM, SOURCE

PAGE = SOURCE / "sim/physics/claims.md"
LAWS, RIGHT_PX, BOTTOM_PX, SPRITE_PX = flings.Laws(), flings.RIGHT_PX, flings.BOTTOM_PX, 128
SIXTIETH_S, WIDE_PX, MIDDLE_PX = 1.0 / 60.0, 1_000_000, 500_000
CLAIMS = {}  # By name: the function that returns the verdict, then the figures.


def claim(name):
    def add(measure):
        CLAIMS[name] = measure
        return measure
    return add


def holds(condition):
    return "holds" if condition else "does not hold"


def holds_when(condition, everywhere=False):
    """Of a claim that may hold on a condition of its own, or everywhere."""
    return "holds" if everywhere else "holds when" if condition else "does not hold"


def wilson(count, of):
    """The 95 % interval of a share. E. B. Wilson, J. Am. Stat. Assoc. 22:209, 1927."""
    z, part = statistics.NormalDist().inv_cdf(0.975), count / of
    middle, half = part + z * z / (2 * of), z * math.sqrt(part * (1 - part) / of + z * z / (4 * of * of))
    return (middle - half) / (1 + z * z / of), (middle + half) / (1 + z * z / of)


# --- what the core does


def played(command, document, read):
    with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
        path = pathlib.Path(folder) / "played.json"
        path.write_text(json.dumps(document), encoding="utf-8")
        succeed(PROGRAM, command, path, "-q", "-o", path.with_suffix(".h5"))
        with h5py.File(path.with_suffix(".h5")) as file:
            return read(file)


def run(start, steps=1, dt_s=SIXTIETH_S, window=(1920, 1080), **more):
    """Rows of x, y, vx, vy."""
    document = {"format": "hyrax-scenario/1", "name": "played", "window": dict(zip(("width_px", "height_px"), window)),
                "sprite": {"width_px": SPRITE_PX, "height_px": SPRITE_PX}, "clock": {"dt_s": dt_s}, "steps": steps,
                "start": dict(zip(("x_px", "y_px", "vx_px_per_s", "vy_px_per_s"), start)), **more}
    return played("run", document, lambda file: numpy.array([file["trajectory"][name][:] for name in ("x", "y", "vx", "vy")]))


def fly(vx, vy, steps=1, dt_s=SIXTIETH_S):
    """vx, vy after steps far from all walls."""
    return run((MIDDLE_PX, MIDDLE_PX, vx, vy), steps, dt_s, (WIDE_PX, WIDE_PX))[2:, -1]


@functools.cache
def throws_of_the_page():
    return json.loads(re.search(r"```json throws.json\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)[1])


@functools.cache
def throws():
    """Starts: x, y, vx, vy, a column a throw."""
    document = throws_of_the_page()
    keys = [f"/start/{key}" for key in ("x_px", "y_px", "vx_px_per_s", "vy_px_per_s")]
    return numpy.array([[sweep.inputs(document, member)[key] for key in keys] for member in range(document["members"])]).T


def throw(clock_, members=None, vary=None, **base):
    """Numbers of the members of the page's sweep, with another clock and other starts."""
    document = copy.deepcopy(throws_of_the_page())
    document["base"].update(base, clock=clock_)
    if "steps" in base:
        document["base"].pop("duration_s")
    document["vary"].update({f"/start/{key}": rule for key, rule in (vary or {}).items()})
    document["members"] = members or document["members"]
    return played("sweep", document, lambda file: {name: each[:] for name, each in file["members"].items()})


def flights(rate_hz, duration_s=1.0):
    """y and vy after flights from y = 0, begun as the throws, far from all walls."""
    wide = {"width_px": WIDE_PX, "height_px": WIDE_PX}
    middle = {key: {"uniform": [MIDDLE_PX, MIDDLE_PX]} for key in ("x_px", "y_px")}
    ends = throw({"rate_hz": rate_hz}, vary=middle, window=wide, steps=round(duration_s * rate_hz))
    return ends["y"] - MIDDLE_PX, ends["vy"]


def exact_flights(rate_hz, duration_s=1.0):
    """The same by v' = G - k v, k that of the drag of frames at this rate."""
    rate_per_s = -math.log(LAWS.drag) * rate_hz
    ends, lost = LAWS.gravity / rate_per_s, -math.expm1(-rate_per_s * duration_s)
    return ends * duration_s + (throws()[3] - ends) * lost / rate_per_s, ends + (throws()[3] - ends) * (1.0 - lost)


def one_by_one(steps, speed=1.0):
    """Events of a run of all throws, so many frames each."""
    return [{"step": steps * k, **event} for k, (x, y, vx, vy) in enumerate(throws().T) for event in (
        {"place": {"x_px": x, "y_px": y}}, {"fling": {"vx_px_per_s": speed * vx, "vy_px_per_s": speed * vy}})]


@functools.cache
def all_throws():
    """One run of all throws, 200 jittered frames each: the scenario, rows and contacts."""
    scenario = {**throws_of_the_page()["base"], "steps": 200 * throws().shape[1], "events": one_by_one(200, 2.0),
                "clock": {"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.5, "seed": 7}}}
    scenario.pop("duration_s")
    return scenario, *played("run", scenario, lambda file: [
        {name: each[:] for name, each in file[group].items()} for group in ("trajectory", "contacts")])


def bounces(*walls):
    """Contacts of all throws at these walls alone."""
    _, _, contacts = all_throws()
    return {name: each[numpy.isin(contacts["wall"], walls)] for name, each in contacts.items()}


def rows_after(is_wanted):
    """Rows of all throws, those after an event left out, and the rows before them."""
    _, rows, _ = all_throws()
    wanted = is_wanted(rows["contact"]) & (rows["step"] % 200 != 1) & (rows["step"] > 0)
    return ({name: each[numpy.flatnonzero(wanted) - back] for name, each in rows.items()} for back in (1, 0))


# --- other steps


def stepped(order, state, dt_s=SIXTIETH_S):
    """The parts of a step in another order: gravity, drag, position, walls of x and of y."""
    x, y, vx, vy = state
    for part in order:
        if part == "g":
            vy = vy + LAWS.gravity * dt_s
        elif part == "d":
            vx, vy = vx * LAWS.drag, vy * LAWS.drag
        elif part == "p":
            x, y = x + vx * dt_s, y + vy * dt_s
        elif part == "x":
            out, x = (x < 0.0) | (x > RIGHT_PX), numpy.clip(x, 0.0, RIGHT_PX)
            vx = numpy.where(out, -vx * LAWS.restitution, vx)
        else:
            out, ground, y = (y < 0.0) | (y > BOTTOM_PX), y > BOTTOM_PX, numpy.clip(y, 0.0, BOTTOM_PX)
            vy = numpy.where(out, -vy * LAWS.restitution, vy)
            vx = numpy.where(ground, vx * LAWS.friction, vx)
            vy = numpy.where(ground & (abs(vy) < LAWS.threshold), 0.0, vy)
    return numpy.array([x, y, vx, vy])


def path(order, start, steps):
    states = [numpy.array(start)]
    for _ in range(steps):
        states.append(stepped(order, states[-1]))
    return numpy.array(states).T


@functools.cache
def lossless_changes(seconds):
    """Largest relative change of each throw's energy in bounces without loss, by the paper's step and by explicit Euler: since vx
    only turns, in y alone."""
    _, y, vx, vy = (numpy.tile(each, (2, 1)) for each in throws())
    kept, gain, worst, found = vx**2 / 2, LAWS.gravity * SIXTIETH_S, 0.0, []
    first = kept + vy**2 / 2 + LAWS.gravity * (BOTTOM_PX - y)
    for frame in range(1, 60 * seconds[-1] + 1):
        moving = numpy.array([vy[0] + gain, vy[1]])
        vy = vy + gain
        y = y + moving * SIXTIETH_S
        vy = numpy.where((y < 0.0) | (y > BOTTOM_PX), -vy, vy)
        y = numpy.minimum(numpy.maximum(y, 0.0), BOTTOM_PX)
        worst = numpy.maximum(worst, abs(kept + vy * vy / 2 + LAWS.gravity * (BOTTOM_PX - y) - first))
        if frame in [60 * each for each in seconds]:
            found.append(worst / first)
    return found


def swings(angles, phases):
    """Growth of springs' amplitudes from the first to the last hundred of 500 steps, beside drag; the spring pulls in the place of
    gravity. By the paper's step and by explicit Euler."""
    w, drag = numpy.tile(angles, (2, 1)) / SIXTIETH_S, LAWS.drag
    y, v = numpy.cos(phases) + 0.0 * w, w * numpy.sin(phases)
    largest = [0.0, 0.0]
    for step in range(500):
        before = v
        v = (v - w * w * y * SIXTIETH_S) * drag
        y = y + numpy.array([v[0], before[1]]) * SIXTIETH_S
        for late in ([0] if step < 100 else [1] if step >= 400 else []):
            largest[late] = numpy.maximum(largest[late], numpy.hypot(y, v / w))
    return largest[1] / largest[0] / drag**200


def missed_impacts(rate_hz):
    """Impacts of exact motion in the frames of throws of 3 s, each frame begun from the run's own state: those that the step does not
    show, which has one in x and one in y, and all."""
    missed, of, dt_s, steps = 0, 0, 1.0 / rate_hz, round(3.0 * rate_hz)
    rows = run((0, 0, 0, 0), steps * throws().shape[1], dt_s, events=one_by_one(steps))[:, 1:].T
    for first, start in zip(range(0, len(rows), steps), throws().T):
        for before, after in zip((start, *rows[first:]), rows[first:first + steps]):
            x, y, vx, vy = before
            reach_x, reach_y = (x + vx * dt_s * part for part in (0, 1)), (y + vy * dt_s * part for part in (0, 1))
            if all(0.0 < each < RIGHT_PX for each in reach_x) and all(0.0 < each < BOTTOM_PX - LAWS.gravity * dt_s**2 for each in reach_y):
                continue  # Nowhere near a wall.
            fling = flings.ExactFling(*before)
            fling.at(dt_s)
            at_sides = sum(wall in (flings.LEFT, flings.RIGHT) for wall in fling.impacts)
            of += len(fling.impacts)
            missed += max(0, at_sides - (after[0] in (0.0, RIGHT_PX))) + max(0, len(fling.impacts) - at_sides - (after[1] in (0.0, BOTTOM_PX)))
    return missed, of


# --- claims on flight


@claim("1-axes")
def axes():
    (x, y), (right, down) = run((500, 300, 1, 0))[:2].T
    return holds(right > x and down > y), down - y


@claim("2.1-gravity")
def gravity():
    gained = [(fly(0, vy, 1, dt_s)[1] / LAWS.drag - vy) / dt_s for vy in (-900, 0, 900) for dt_s in (1e-3, SIXTIETH_S, 0.1)]
    return holds(max(gained) - min(gained) < 1e-6 and min(gained) > 0.0), min(gained)


@claim("2.2-both-components")
def both_components():
    x_factor, y_factor = (fly(1000, 1000) - fly(500, 500)) / 500
    return holds(abs(x_factor - y_factor) < 1e-12 and x_factor < 1.0), x_factor


@claim("2.2-stokes")
def stokes():
    rates_hz = 30, 240
    slow, fast = (-math.log(fly(900, 0, rate_hz, 1.0 / rate_hz)[0] / 900) for rate_hz in rates_hz)
    is_linear = abs(fly(1, 0)[0] * 5000 / fly(5000, 0)[0] - 1.0) < 1e-12
    return holds_when(is_linear, is_linear and abs(fast / slow - 1.0) < 0.01), 1, fast / slow, *rates_hz[::-1], fast, slow


@claim("2.2-exponential")
def exponential():
    speeds, limit, steps = run((500, 300, 1000, 0), 800_000, 1e-6)[2], 1e-12, 5000
    factor = speeds[1] / speeds[0]
    off = max(abs(speeds[:steps + 1] / 1000 / factor ** numpy.arange(steps + 1) - 1.0))
    return holds(off < limit and factor < 1.0), limit, steps, speeds[-1], speeds[-1] * factor


@claim("2.2-terminal")
def terminal():
    """The speed that a step keeps, which others approach."""
    ends = {rate_hz: LAWS.drag * LAWS.gravity / rate_hz / (1.0 - LAWS.drag) for rate_hz in (60, 240)}
    kept = all(abs(fly(0, end, 1, 1.0 / rate_hz)[1] / end - 1.0) < 1e-12 and fly(0, 2 * end, 1, 1.0 / rate_hz)[1] < 2 * end
               for rate_hz, end in ends.items())
    return holds(kept), *(each for rate_hz, end in ends.items() for each in (end, rate_hz))


@claim("2.3-new-velocity")
def new_velocity():
    before, after = rows_after(lambda contact: contact == 0)
    off = max(numpy.max(abs(after[place] - (before[place] + after[speed] * after["dt"]))) for place, speed in (("x", "vx"), ("y", "vy")))
    return holds(off == 0.0), off


@claim("2.3-energy")
def energy_is_conserved():
    (changes, _), (_, vy) = lossless_changes((60, 600))[0], fly(0, 0) / LAWS.drag
    return holds(max(changes) < 1e-9), 1, 60, *flings.band(changes), LAWS.gravity * vy * SIXTIETH_S - vy**2 / 2


@claim("2.3-oscillators")
def oscillators():
    count, slowest, fastest, beyond = 100, 0.05, 1.99, 2.01
    draws = numpy.array([[clock.unit(7, 2 * k + which) for k in range(count)] for which in (0, 1)])
    paper, euler = swings(slowest + (fastest - slowest) * draws[0], 6.283 * draws[1])
    return (holds(max(paper) < 1.1 and all(paper < euler)), count, slowest, fastest, 400, *flings.band(paper), *flings.band(euler)[1:],
            beyond, swings([beyond], 0.0)[0][0])


@claim("2.4-explicit")
def better_than_explicit():
    paper, euler = lossless_changes((60, 600))[1]
    better = sum(paper < euler)
    low, high = wilson(better, len(paper))
    return holds_when(low > 0.5, low > 0.95), better / len(paper), low, high


@claim("2.4-first-order")
def first_order():
    def error_px(rate_hz, drag_of_hz):
        return math.sqrt(numpy.mean((flights(rate_hz)[0] - exact_flights(drag_of_hz)[0])**2))

    rates_hz, fixed_hz = (15, 30, 60, 120, 240), (60, 960)
    off, fixed = [error_px(rate_hz, rate_hz) for rate_hz in rates_hz], [error_px(rate_hz, fixed_hz[0]) for rate_hz in fixed_hz]
    orders = numpy.log2(numpy.array(off[:-1]) / off[1:])
    verdict = holds_when(abs(numpy.median(orders) - 1.0) < 0.2, fixed[1] < fixed[0])
    return verdict, numpy.median(orders), min(orders), max(orders), 1, rates_hz[0], rates_hz[-1], fixed[0], fixed_hz[0], fixed[1], fixed_hz[1]


# --- on walls


@claim("3-centre")
def centre():
    ends = throw({"rate_hz": 60})
    least, most = ends["x_min"].min(), ends["x_max"].max()
    out = max(SPRITE_PX / 2 - least, most + SPRITE_PX / 2 - (RIGHT_PX + SPRITE_PX))
    return holds(out <= 0.0), least, most, out


@claim("3-x-first")
def x_first():
    draws = numpy.array([[clock.unit(3, 4 * k + which) for k in range(1000)] for which in range(4)])
    corners = numpy.array([RIGHT_PX - 20 * draws[0], BOTTOM_PX - 20 * draws[1], 1500 + 7500 * draws[2], 1500 + 7500 * draws[3]])
    one, other = stepped("gdpxy", corners), stepped("gdpyx", corners)
    inside = all((0.0 <= each[0]).all() and (each[0] <= RIGHT_PX).all() and (each[1] <= BOTTOM_PX).all() for each in (one, other))
    apart = numpy.max(abs(one[2:] / other[2:] - 1.0))
    return holds(apart > 1e-9 or not inside), 1000, apart


@claim("3-exact-position")
def exact_position():
    _, rows, _ = all_throws()
    bounds = {replay.LEFT: ("x", 0.0), replay.RIGHT: ("x", RIGHT_PX), replay.TOP: ("y", 0.0), replay.GROUND: ("y", BOTTOM_PX)}
    clamped = [abs(rows[name] - bound)[rows["contact"] & wall != 0] for wall, (name, bound) in bounds.items()]
    return holds(all(map(len, clamped)) and max(map(max, clamped)) == 0.0), max(map(max, clamped)), sum(map(len, clamped))


@claim("3-restitution")
def restitution():
    ratios = [-each[f"v{axis}_after"] / each[f"v{axis}_before"] for axis, each in (("x", bounces(replay.LEFT, replay.RIGHT)), ("y", bounces(replay.TOP)))]
    ratios = numpy.concatenate(ratios)
    return holds(0.0 < min(ratios) and max(ratios) < 1.0 and numpy.ptp(ratios) < 1e-12), min(ratios), len(ratios)


@claim("3.1-no-friction")
def no_friction():
    sides = bounces(replay.LEFT, replay.RIGHT)
    change = max(abs(sides["vy_after"] - sides["vy_before"]))
    return holds(change == 0.0), change


@claim("3.2.1-top")
def top():
    ratios = bounces(replay.TOP)["vy_after"] / bounces(replay.TOP)["vy_before"]
    return holds(numpy.ptp(ratios) < 1e-12 and max(ratios) < 0.0), min(ratios)


@claim("3.2.2-friction")
def friction():
    ground = bounces(replay.GROUND)
    factors = ground["vx_after"] / ground["vx_before"]
    return holds(numpy.ptp(factors) < 1e-12 and max(factors) < 1.0), min(factors)


@claim("3.2.2-signed")
def signed():
    _, rows = rows_after(lambda contact: contact & replay.GROUND != 0)
    up, bounced = rows["vy"][rows["vy"] < 0.0], run((500, 950, 0, 800))[3, -1]
    return holds(bounced == 0.0), 800, bounced, min(-up, default=math.nan)


@claim("3.2.2-only-on-ground")
def only_on_ground():
    before, after = rows_after(lambda contact: contact & ~replay.TOP == 0)
    change = max(abs(after["vx"] - before["vx"] * LAWS.drag))
    return holds(change == 0.0), change


@claim("3.2.2-infinite-bounce")
def infinite_bounce():
    """Two rows, for the two-cycle passes 0 in every other one."""
    drops = {"vx_px_per_s": {"grid": [0, 0, 1]}, "vy_px_per_s": {"grid": [0, 0, 1]}, "x_px": {"grid": [900, 900, 1]}, "y_px": {"grid": [0, 900, 12]}}

    def ends(rate_hz):
        rows = [throw({"rate_hz": rate_hz}, 12, drops, steps=math.ceil(12 * rate_hz) + more) for more in (0, 1)]
        return all((each["vy"] == 0.0).all() for each in rows), all((each["y"] == BOTTOM_PX).all() for each in rows)

    low_hz, high_hz = 143.85, 143.86
    are_still = all(ends(rate_hz)[1] for rate_hz in (20, 24, 60, 120))
    return holds_when(are_still and ends(high_hz)[0] and not ends(low_hz)[0], ends(20)[0] and ends(60)[0]), high_hz, low_hz, 12


@claim("5-energy-retention")
def energy_retention():
    sides = bounces(replay.LEFT, replay.RIGHT)
    ratios = (sides["vx_after"] / sides["vx_before"])**2
    return holds(max(abs(ratios - LAWS.restitution)) < 1e-9), min(ratios)


# --- on time steps


@claim("4.1-energy-drift")
def energy_drift():
    drifts = []
    for rate_hz in (60, 5):
        (y, vy), (exact_y, exact_vy) = flights(rate_hz), exact_flights(rate_hz)
        drifts.append((vy - exact_vy) * (vy + exact_vy) / 2 - LAWS.gravity * (y - exact_y))
    ratios = drifts[1] / drifts[0]
    return holds(numpy.quantile(ratios, 0.1) > 6.0), 0.2, *flings.band(ratios), 1, 60, *map(numpy.median, drifts[::-1])


@claim("4.1-missed")
def missed():
    (long_missed, of), (short_missed, of_short) = missed_impacts(4), missed_impacts(60)
    low, high = wilson(long_missed, of)
    return holds(low > wilson(short_missed, of_short)[1]), 0.25, long_missed / of, low, high, of, 3, 60, short_missed, of_short


@claim("4.1-stable-dt")
def stable_dt():
    largest = 0.0
    for dt_s in (0.001, 0.005, 0.01, 0.02, 0.03, 0.05, 0.1, 0.3, 1.0, 10.0, 1e3, 1e6):
        ends = throw({"dt_s": dt_s}, steps=500)
        # The fixed point of |v| <- a (|v| + G dt), turned, beyond the throws' own speed.
        limit = 3000.0 + LAWS.gravity * dt_s / (1.0 - LAWS.restitution)
        if min(ends["x_min"].min(), ends["y_min"].min()) < 0.0 or ends["x_max"].max() > RIGHT_PX or ends["y_max"].max() > BOTTOM_PX or ends["speed_max"].max() > limit:
            break
        largest = dt_s
    return holds(0.02 <= largest <= 0.05), largest


def corner_throws(least, most):
    """Of throws that cross both walls in a frame: those that came out, and all."""
    out = of = 0
    for (x, y, sign) in ((RIGHT_PX - 20, BOTTOM_PX - 20, 1), (0, 0, -1)):
        speed = {"uniform": sorted((sign * least, sign * most))}
        ends = throw({"rate_hz": 60}, 10_000, {"x_px": {"uniform": [x, x + 20]}, "y_px": {"uniform": [y, y + 20]}, "vx_px_per_s": speed, "vy_px_per_s": speed}, steps=1)
        both = (ends["contacts"].sum(axis=1) == 2)
        of += both.sum()
        out += (both & ((ends["x"] < 0) | (ends["x"] > RIGHT_PX) | (ends["y"] < 0) | (ends["y"] > BOTTOM_PX))).sum()
    return out, of


@claim("4.2-tunnel")
def tunnel(speeds=(2000, 100_000)):
    out, of = corner_throws(*speeds)
    return holds(out > 0), out, of, *speeds


@claim("4.2-rare")
def rare(speeds=(100, 2000)):
    out, of = corner_throws(*speeds)
    return holds(out < 0.01 * of), out, of, *speeds


# --- on order


@claim("4.3-damps-gain")
def damps_gain():
    part = fly(0, 0)[1] / (LAWS.gravity * SIXTIETH_S)
    return holds(part < 1.0), part


@claim("4.3-not-stuck")
def not_stuck():
    start = (300.0, 500.0, 3000.0, -2000.0)
    outside = [((x < 0) | (x > RIGHT_PX) | (y < 0) | (y > BOTTOM_PX)).sum() for x, y, _, _ in (run(start, 2000), path("xygdp", start, 2000))]
    return holds(outside[0] == 0 < outside[1]), outside[0], 2000, outside[1]


@claim("4.3-order-alters")
def order_alters():
    start = (100.0, 500.0, 2400.0, -700.0)
    paper = run(start, 60)
    apart = [numpy.hypot(*(path(order, start, 60) - paper)[:2]).max() for order in ("dgpxy", "pgdxy", "xygdp")]
    return holds(min(apart) > 0.0), apart[0], 1, *apart[1:]


@claim("6-exactly")
def exactly():
    scenario, rows, _ = all_throws()
    _, own, _ = replay.play(replay.Scenario(scenario))
    differing = sum(any(pair[0] != pair[1] for pair in each) for each in zip(*(zip(rows[name], own[name]) for name in ("x", "y", "vx", "vy"))))
    return holds(differing == 0), differing, scenario["steps"], scenario["clock"]["jitter"]["seed"]


# --- on constants and use


def constant(place, wanted):
    def measure():
        value = played("run", {**throws_of_the_page()["base"], "duration_s": 0}, lambda file: file.attrs["constants"][place])
        return holds(value == wanted), value
    return measure


for _place, (_name, _wanted) in enumerate((("gravity", 1200.0), ("restitution", 0.6), ("air-drag", 0.999), ("ground-friction", 0.8), ("rest-threshold", 5.0))):
    CLAIMS[f"5-{_name}"] = constant(_place, _wanted)


@claim("6.1-frame-rate")
def frame_rate():
    rates_hz = 24, 30, 60, 75, 120, 144, 165, 240
    spreads = numpy.ptp([throw({"rate_hz": rate_hz})["x"] for rate_hz in rates_hz], axis=0)
    near = sum(spreads <= RIGHT_PX / 20)
    return holds(wilson(near, len(spreads))[1] >= 0.5), rates_hz[0], rates_hz[-1], *flings.band(spreads), near, len(spreads)


@claim("6.1-sizes")
def sizes():
    height = 80
    jump = numpy.max(abs(numpy.diff(run((-10, -20, 1, 1), 600, window=(100, height))[:2])))
    return holds_when(jump <= SPRITE_PX - height, jump <= 30.0), SPRITE_PX - height, jump


@claim("6.1-reset")
def reset():
    rows = run((900, 100, 700, -300), 60, window=(WIDE_PX, WIDE_PX), events=[{"step": 0, "stop": {}}])
    moved = math.hypot(*(rows[:2, -1] - rows[:2, 0]))
    return holds_when((rows[0] == rows[0, 0]).all() and rows[3, 1] == fly(0, 0)[1], moved == 0.0), moved, 1


@claim("6.2-drawing")
def drawing():
    least = run((500, 300, -2000, 0), 60)[0].min() - SPRITE_PX / 2
    return holds(least >= 0.0), least


def main():
    for name in sys.argv[1:] or CLAIMS:
        verdict, *figures = CLAIMS[name]()
        print(f"{name}: {verdict}; {', '.join(f'{each:.6g}' for each in figures)}")


if __name__ == "__main__":
    main()
