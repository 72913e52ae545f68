"""The numbers of `drift` against their published definitions: of arcs and contacts in 50 digits, on random flights into
corners with uneven clocks; of the whole run by the exact fling of tests/oracle, on random throws that settle, too."""

import collections
import decimal
import math
import random
import re
import statistics
import sys

import h5py

from drift_test import DriftTest
from program import AGREED, DISAGREED, SOURCE, fling

sys.path.insert(0, str(SOURCE / "tests/oracle"))
import flings  # noqa: E402 pylint: disable=wrong-import-position

D = decimal.Decimal
decimal.getcontext().prec = 50
SEED = 20
CASES = 20
THROWS = 4
ARCS_FITTED = 3  # Fitted in 50 digits only where a run has no more.
RIGHT_PX, BOTTOM_PX = 1920 - 128, 1080 - 128
GRAVITY = D(1200)
KEPT = D(0.999)  # The binary64 number.
DRAG = -KEPT.ln()
LEFT, RIGHT, TOP, GROUND = WALLS = (1, 2, 4, 8)
NAMES = {LEFT: "left", RIGHT: "right", TOP: "top", GROUND: "ground"}


def scenario(name, begin, clock, steps=None, **length):
    start = dict(zip(("x_px", "y_px", "vx_px_per_s", "vy_px_per_s"), begin))
    return fling(name=name, start=start, clock=clock, steps=steps, **length)


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
    return scenario(name, (x, y, vx, vy), clock, **length)


DEFINITIONS = " ".join((SOURCE / "sim/reference/README.md").read_text(encoding="utf-8").split())


def documented(pattern, formula=False):
    """What the pattern's groups have in the document; a formula is compiled."""
    groups = re.search(pattern, DEFINITIONS).groups()
    if not formula:
        return groups
    return compile(re.sub(r"(?<=\w) (?=[\w(])|(?<=\))(?=\()", " * ", groups[0].replace("²", "**2")), pattern, "eval")


ENERGY = documented(r"Specific energy is e = (.*?) in px", True)
DIFFERENCE = documented(r"Differences are computed as (.*?), with w and z the speed and position of the ODE", True)
PER_FRAME = documented(r"\| gravity once a step \| (.*?) per frame", True)
OF, FROM, LARGEST = documented(r"\*\*Drift\*\* is e of the (\w+) minus e of the (\w+) .*?, divided by the arc's (\w+) energy")
AGAINST = dict(re.findall(r"\| (implementation|truncation|model) \| (.*?)(?:,.*?)? \|", DEFINITIONS))
AFTER = {"once": 1, "twice": 2}[documented(r"is not crossed within the clamped frame plus (\w+) the last dt")[0]]
LIFTS = {wall: 1 if sign == "+" else -1 for wall, sign in zip((8, 4), documented(
    r"\| ([+-]) G times the overshoot at the ground, ([+-]) G times it at the top"))}  # By wall.
PARTS = [re.findall(r"\w+", part) for part in documented(r"`energy_parts` of each arc \((.*?);.*?order of its operations \((.*?);")]


def energy_of(_, y, vx, vy):
    """Specific energy, 0 at rest on the floor."""
    return eval(ENERGY, {}, {"G": GRAVITY, "B": BOTTOM_PX, "y": y, "vx": vx, "vy": vy})  # pylint: disable=eval-used


def least_squares(points):
    """Sums of squares of a line with intercept: slope = second / first."""
    t_mean, e_mean = (sum(each) / len(points) for each in zip(*points))
    return sum((t - t_mean) ** 2 for t, _ in points), sum((t - t_mean) * (e - e_mean) for t, e in points)


def throw(number, begin, rate_hz):
    """A random throw that settles, on a steady clock."""
    return scenario(f"throw-{number:02}", begin, {"rate_hz": rate_hz}, duration_s=6)


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
            return state[:2] + tuple(KEPT * speed for speed in state[2:])
        (x, vx), (y, vy) = (axis.at(dt) for axis in self.axes(state, dt))
        return x, y, vx, vy

    def largest_energy(self):
        return {"largest": max, "smallest": min}[LARGEST](energy_of(*state) for state in self.states)

    def errors(self):
        """What `drift --json` has of it, distances and energies of all rows: the run against the three exact flights."""
        a, phi1 = KEPT, (1 - KEPT) / DRAG
        eta_s = (a - (a / phi1) ** 2 * (1 - phi1) / DRAG) * GRAVITY  # eta / dt.
        x, y, vx, vy = begin = self.states[0]
        t, gravity, apart, points = D(0), D(0), [(D(0), D(0), D(0))], [(D(0), D(0))]
        model = self.axes(begin, D(1) / 60)
        for row, matched in zip(range(self.first + 1, self.last + 1), self.states[1:], strict=True):
            dt, *run = (D(float(self.rows[name][row])) for name in ("dt", "x", "y", "vx", "vy"))
            vx, vy = vx * a, (vy + GRAVITY * dt) * a
            x, y, t = x + vx * dt, y + vy * dt, t + dt
            gravity += eval(PER_FRAME, {}, {"G": GRAVITY, "eta": eta_s * dt, "dt": dt})  # pylint: disable=eval-used
            flown = (x, y), matched, [axis.at(t)[0] for axis in model]
            apart.append([((run[0] - other[0]) ** 2 + (run[1] - other[1]) ** 2).sqrt() for other in flown])
            states = {"run": run, "matched": matched}
            (_, y_of, *of), (_, z, *ode) = states[OF], states[FROM]
            points.append((t, sum(eval(DIFFERENCE, {}, {"G": GRAVITY, "v": v, "w": w, "y": each * y_of, "z": each * z})  # pylint: disable=eval-used
                                  for v, w, each in zip(of, ode, (0, 1)))))
        drifts = [drift for _, drift in points]
        (tt, te), largest = least_squares(points), max(self.largest_energy(), GRAVITY)
        far = dict(zip(("the closed form of the step's own recurrence", "the ODE with the drag of each frame", "the same ODE with the drag of 60 Hz"),
                       (max(each) for each in zip(*apart))))
        return {"duration_s": t, **{f"{name}_px": far[against] for name, against in AGAINST.items()},
                "energy_drift_max": max(map(abs, drifts)), "energy_drift_end": drifts[-1],
                "energy_drift_rel_max": max(map(abs, drifts)) / largest, "energy_drift_rel_end": drifts[-1] / largest,
                "energy_drift_slope_px_per_s": te / tt / GRAVITY if tt else None,
                "energy_drift_slope_per_s": te / tt / largest if tt else None,
                "energy_parts": {"gravity": gravity, "drag": drifts[-1] - gravity}}, (tt, te)

    def contact_parts(self):
        """Energy changes of the clamped step, operation by operation."""
        dt, x, y, vx, vy = (D(float(self.rows[name][self.last + (name == "dt")])) for name in ("dt", "x", "y", "vx", "vy"))
        contact, end = int(self.rows["contact"][self.last + 1]), D(float(self.rows["y"][self.last + 1]))
        energies = [energy_of(x, y, vx, vy)]
        vx, vy = vx * KEPT, (vy + GRAVITY * dt) * KEPT
        for change in ((y + vy * dt, vx, vy), (end, vx, vy), (end, vx := vx * (D(0.6) if contact & 3 else 1), vy := vy * (D(0.6) if contact & 12 else 1)),
                       (end, vx := vx * (D(0.8) if contact & 8 else 1), vy), (end, vx, D(0) if contact & 16 else vy)):
            energies.append(energy_of(x, *change))
        return dict(zip(("flight", "lift", "bounce", "friction", "rest"), (after - before for before, after in zip(energies, energies[1:]))))

    def impact(self, wall):
        """Time before the clamped row at which it crosses the wall, and the speed there."""
        index = 0 if wall in (LEFT, RIGHT) else 1
        place, outward = {LEFT: (0, -1), RIGHT: (RIGHT_PX, 1), TOP: (0, -1), GROUND: (BOTTOM_PX, 1)}[wall]
        frames = [D(float(dt)) for dt in self.rows["dt"][self.first + 1:self.last + 2]]
        clamped = frames.pop()
        rate_dt = next((dt for dt in reversed(frames) if dt > 0), clamped)
        frames = [(dt, dt) for dt in frames] + [(rate_dt, clamped + AFTER * rate_dt)]
        left = sum(dt for dt, _ in frames[:-1]) + clamped
        for state, (dt, t_max) in zip(self.states, frames, strict=True):
            if dt > 0:
                axis = self.axes(state, dt)[index]
                t = axis.crossing(place, outward, t_max)
                if t is not None:
                    return left - t, abs(axis.at(t)[1])
            left -= dt
        return None


class Numbers(DriftTest):
    def play(self, cases):
        """Each scenario, what `drift` has of it, the file of its run and the rows."""
        for case in cases:
            self.write(f"cases/{case['name']}.json", case)
        self.write("out/keep", "")
        self.expect(AGREED, "run", "cases", "-o", "out/")
        for case, run in zip(cases, self.drift("cases"), strict=True):
            self.assertEqual(run["reference_faults"], 0)
            with h5py.File(self.folder / f"out/{case['name']}.h5") as file:
                yield case, run, file, {name: file[f"trajectory/{name}"][:] for name in ("t", "dt", "x", "y", "vx", "vy", "contact")}

    def test_those_of_corners_on_uneven_clocks_are_as_defined(self):
        draw = random.Random(SEED)
        corners = short = 0
        for case, run, file, rows in self.play([random_corner(draw, f"c{case:03}") for case in range(CASES)]):
            with self.subTest(case=case):
                found = self.check_contacts(run, file, rows)
                corners += found[0]
                short += found[1]
                self.check_arcs(run, rows)
                self.check_whole(case, run, rows)
        self.assertGreater(corners, CASES // 10)
        self.assertGreater(short, CASES // 10)

    def test_those_of_whole_runs_are_as_defined(self):
        differing = 0
        for case, run, _, rows in self.play([throw(number, begin, rate_hz) for number, (begin, rate_hz) in enumerate(
                zip(flings.starts(THROWS).T.tolist(), (24, 60, 144, 1000) * THROWS))]):
            with self.subTest(case=case):
                self.check_whole(case, run, rows)
                self.check_summary(run, rows)
            differing += run["whole"]["contacts_differ_from"] is not None
        self.assertTrue(0 < differing < THROWS)
        self.assertEqual(self.drift_of({**case, "clock": {"rate_hz": 2000}}, "--reference", "closed")["worst"], run["half_dt"]["worst"])

    def test_those_of_another_step_are_as_defined(self):
        """Drag before gravity in a flight: its implementation error is no longer rounding, and all else is of its own rows."""
        case = throw(0, (100.0, 500.0, 300.0, -900.0), 60)
        (_, run, _, rows), = self.play([{**case, "duration_s": 1}])
        with h5py.File(self.folder / "out/throw-00.h5", "r+") as file:
            for row in range(1, 61):
                rows["vx"][row], rows["vy"][row] = rows["vx"][row - 1] * 0.999, rows["vy"][row - 1] * 0.999 + 1200 / 60
                rows["x"][row], rows["y"][row] = (rows[name][row - 1] + rows[f"v{name}"][row] / 60 for name in ("x", "y"))
            for name in ("x", "y", "vx", "vy"):
                file[f"trajectory/{name}"][:] = rows[name]
        other, = self.expect(DISAGREED, "drift", "out/throw-00.h5", "--json").json["runs"]
        self.check_arcs(other, rows)
        self.check_whole(case, other, rows)
        for key in ("implementation_px", "truncation_px", "model_px", "energy_drift_max", "energy_drift_slope_px_per_s", "exact_law_px"):
            self.assertGreater(abs(other["worst"][key] - run["worst"][key]), 1e-3, key)
        for key in ("end_px", "max_px", "energy_end_px", "energy_max_px", "secular_px_per_s"):
            self.assertGreater(abs(other["whole"][key] - run["whole"][key]), 1e-3, key)
        self.assertEqual((run["differing_steps"], other["differing_steps"]), (0, 60))

    @staticmethod
    def bounces(run, rows):
        """Its contacts without the resting contacts, of a run without inputs."""
        def rests(contact):
            step = contact["step"]
            return contact["wall"] == "ground" and step < len(rows["y"]) - 1 and (abs(rows["y"][step:] - BOTTOM_PX) <= 0.5).all()
        return [contact for contact in run["contacts"] if not rests(contact)]

    def check_summary(self, run, rows):
        bounces = self.bounces(run, rows)
        self.assertLess(len(bounces), len(run["contacts"]))
        ratios = [contact["effective_restitution"] for contact in bounces
                  if contact["effective_restitution"] is not None and not (contact["wall"] == "ground" and rows["contact"][contact["step"]] & 16)]
        self.assertEqual(run["effective_restitution"], {"median": statistics.median(ratios), "smallest": min(ratios), "largest": max(ratios),
                                                        "contacts": len(ratios)})
        for key, worst in run["worst"].items():
            listed = [(abs(each[key]), -each.get("step", each.get("first_step")), each[key]) for each in (*run["arcs"], *bounces)
                      if each.get(key) is not None]
            self.assertEqual((worst, run["worst_step"][key]), (max(listed)[2], -max(listed)[1]), key)

    def check_whole(self, case, run, rows):
        """Distances are hypot of the differences, energies heights; 1e-6 px is far below each, and above rounding."""
        exact = flings.ExactFling(*case["start"].values())
        at = [exact.at(t) for t in rows["t"]]
        here = list(zip(*(rows[name].tolist() for name in ("x", "y", "vx", "vy"))))
        apart = [math.hypot(a[0] - b[0], a[1] - b[1]) for a, b in zip(here, at)]
        high = [((a[2] ** 2 + a[3] ** 2 - b[2] ** 2 - b[3] ** 2) / 2400 + b[1] - a[1]) for a, b in zip(here, at)]
        whole = run["whole"]
        aligned = self.aligned(rows, exact)
        energies = {is_aligned: max((abs(each) for each, one in zip(high, aligned) if one == is_aligned), default=0) for is_aligned in (True, False)}
        for key, value in (("end_px", apart[-1]), ("max_px", max(apart)), ("energy_end_px", high[-1]), ("energy_max_px", energies[True]),
                           ("energy_phase_px", energies[False])):
            self.assertAlmostEqual(whole[key], value, delta=1e-6, msg=key)
        self.assertAlmostEqual(apart[whole["max_px_step"]], max(apart), delta=1e-6)
        fits = [Arc(rows, arc["first_step"], arc["last_step"]).errors()[1] for arc in run["arcs"][:ARCS_FITTED]]
        if len(run["arcs"]) <= ARCS_FITTED and sum(tt for tt, _ in fits):
            self.assert_near(whole["secular_px_per_s"], sum(te for _, te in fits) / sum(tt for tt, _ in fits) / GRAVITY, D("1e-7"))
        self.assertEqual(whole["contacts_differ_from"], self.first_other(rows["contact"], exact))

    @staticmethod
    def aligned(rows, exact):
        """Of each row whether both have had the same number of contacts at each wall, before the resting contact."""
        contacts, last, counts, met = rows["contact"], len(rows["t"]) - 1, collections.Counter(), collections.Counter()
        near = [abs(y - BOTTOM_PX) <= 0.5 for y in rows["y"]]
        impacts, aligned, resting = list(zip(exact.times, exact.impacts)), [], False
        for row, t in enumerate(rows["t"]):
            for wall in WALLS:
                begins = row > 0 and contacts[row] & wall and not contacts[row - 1] & wall
                counts[wall] += bool(begins)
                resting = resting or bool(begins) and wall == GROUND and row < last and all(near[row:])
            while impacts and impacts[0][0] <= t:
                met[WALLS[impacts.pop(0)[1]]] += 1
            aligned.append(not resting and all(counts[wall] == met[wall] for wall in WALLS))
        return aligned

    @staticmethod
    def first_other(contacts, exact):
        """The row of the first contact, in order, whose wall is not the exact impact's."""
        met = [[row, wall] for row in range(1, len(contacts)) for index, wall in enumerate(WALLS)
               if contacts[row] & wall and not contacts[row - 1] & wall]
        impacts = [WALLS[wall] for wall in exact.impacts]
        while exact.slides and impacts[-1] != GROUND:
            impacts.pop()
        for number, wall in enumerate(impacts[:len(met)]):
            later = met[number + 1:number + 2]
            if met[number][1] != wall and later and later[0][0] == met[number][0]:  # A corner.
                met[number], met[number + 1] = met[number + 1], met[number]
            if met[number][1] != wall:
                return met[number][0]
        return None

    def check_arcs(self, run, rows):
        last = len(rows["contact"]) - 1
        clamped = [step for step, contact in enumerate(rows["contact"]) if contact]
        ends = [*zip([0, *clamped], (step - 1 for step in clamped)), ([0, *clamped][-1], last)]
        self.assertEqual([(arc["first_step"], arc["last_step"]) for arc in run["arcs"]],
                         [(begin, end) for begin, end in ends if end - begin >= 2])
        for arc in run["arcs"]:
            self.assertEqual(list(arc["energy_parts"]), PARTS[0])
            self.assert_near(arc["exact_law_px"], D(arc["implementation_px"]), D("1e-9"))
            for key, value in Arc(rows, arc["first_step"], arc["last_step"]).errors()[0].items():
                self.check_number(arc[key], value, key)

    def check_number(self, printed, value, key):
        """To nine digits."""
        if isinstance(value, dict):
            for part, number in value.items():
                self.check_number(printed[part], number, part)
        elif value is None:
            self.assertIsNone(printed, key)
        else:
            self.assert_near(printed, value, D("1e-9") * (1 + abs(value)))

    def check_contacts(self, run, file, rows):
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
        parts = arc.contact_parts()
        self.assertEqual([list(contact["energy_parts"]), list(parts)], [PARTS[1], PARTS[1]])
        self.check_number(contact["energy_parts"], parts, "energy_parts")
        if wall in LIFTS:
            self.assert_near(LIFTS[wall] * contact["overshoot_px"], parts["lift"] / GRAVITY, D("1e-6"))
        self.assert_near(contact["energy_jump_rel"], sum(parts.values()) / max(arc.largest_energy(), GRAVITY), D("1e-9"))
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

    def assert_near(self, actual, expected, tolerance):
        self.assertLessEqual(abs(D(actual) - expected), tolerance, (actual, float(expected)))
