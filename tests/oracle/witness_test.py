"""Compares hyrax-sim with the second program: summary, rows and contacts of every scenario of moderate length, bit for bit, and
the vectors; and the second program with the formulas of the documents."""

import json
import math
import pathlib
import random
import re
import struct
import unittest

import h5py
import numpy
import xxhash

from program import AGREED, SOURCE, ProgramTest
import clock
import replay
import sweep
import vectors

FOLDERS = (SOURCE / "scenarios", SOURCE / "tests/oracle/scenarios")
STEPS_MAX = 20_000


def exact(value):
    """The value with every number as the digits of its bits, so that -0.0 and 0.0 differ."""
    if isinstance(value, dict):
        return {key: exact(inner) for key, inner in value.items()}
    return value if value is None or isinstance(value, str) else float(value).hex()


def difference(played, entry, file):
    """What the document or the file of a run has otherwise than the second program, or None."""
    summary, *groups = played
    for key, number in summary.items():
        if exact(entry[key]) != exact(number):
            return f"{key}: {entry[key]} instead of {number}"
    for group, columns in zip(("trajectory", "contacts"), groups):
        for name, numbers in columns.items():
            stored = file[group][name][:]
            wanted = numpy.array(numbers, stored.dtype)
            if stored.tobytes() != wanted.tobytes():
                places = [place for place, pair in enumerate(zip(stored, wanted)) if exact(pair[0]) != exact(pair[1])]
                return f"/{group}/{name}: {len(stored)} instead of {len(wanted)} numbers, differing at {places[:3]}"
    return None


def stated(path, *patterns):
    """What each pattern's groups have in a document."""
    text = " ".join((SOURCE / path).read_text(encoding="utf-8").split())
    return [each for pattern in patterns for each in re.search(pattern, text).groups()]


def value(formula, **names):
    """Of a document's formula."""
    return eval(formula.replace("^", "**"), {"floor": math.floor, "ceil": math.ceil}, names)  # pylint: disable=eval-used


class Documents(unittest.TestCase):
    """Who computes by the documents gets the numbers of the second program."""

    def test_the_generator_and_the_jitter(self):
        state, *mix, unit, uniform, normal, first, last, missed, kept = stated(
            "scenarios/README.md", r"k of seed s is `mix\((.*?)\)` modulo 2\^64, where `mix` shifts by (\d+), (\d+), (\d+) and multiplies by (0x\w+) and (0x\w+);",
            r"; u_k = (.*?)\. The", r"\| `uniform` [^`]*`fraction`[^`]* `(.*?)` \|",
            r"\| `normal` [^`]*`sigma_s`[^`]* `(.*?)`, S the sum of u_(\d+)i \.\. u_12i\+(\d+) from left to right.*?; a result <= 0 becomes 0\.0 ",
            r"\| `missed_frames` [^`]*`probability`[^`]* `(.*?)` if u_i < probability, else (\w+) \|")
        for seed, i in ((7, 0), (clock.MASK_64, 5), (1 << 63, 12345)):
            z = value(state, s=seed, k=i) % 2**64
            for shift, factor in zip(mix[:3], (*mix[3:], "1")):
                z = (z ^ z >> int(shift)) * int(factor, 0) % 2**64
            self.assertEqual((z, value(unit, output=z)), (clock.splitmix64(seed, i), clock.unit(seed, i)))
            total = sum(clock.unit(seed, int(first) * i + k) for k in range(int(last) + 1))
            names = {"dt": 1 / 60, "fraction": 0.35, "sigma_s": 0.35, "u_i": clock.unit(seed, i), "S": total}
            self.assertEqual([value(uniform, **names), max(0.0, value(normal, **names)), value(missed, **names), value(kept, **names)],
                             [rule(1 / 60, parameter, seed, i) for rule, parameter in (
                                 (clock.uniform_dt_s, 0.35), (clock.normal_dt_s, 0.35), (clock.missed_frames_dt_s, 1), (clock.missed_frames_dt_s, 0))])

    def test_the_inputs_of_a_sweep(self):
        draw, real, whole, entry, place, between = stated(
            "sim/ensemble/README.md", r"sorted by their bytes, k = 0 \.\. K-1, member i draws u = `u_\((.*?)\)` of", r"\| `uniform` \| `(.*?)`; of a whole number `(.*?)` \|",
            r"\| `choice` \| entry `(.*?)` \|", r"\| `grid` \| with j = \((.*?)\) mod n: `(.*?)`, and `high` at the end")
        place = place.replace("/", "//").replace("product of the n of all later grids", "later")
        vary = {"/e": {"uniform": [-7, 11]}, "/a": {"choice": [0, 1, 2]}, "/b": {"grid": [-2, 5, 3]}, "/d/steps": {"uniform": [3, 9]}, "/c": {"grid": [0, 7, 4]}}

        def by(formula, i, k, low, high, n=3, later=1):
            j = value(place, i=i, later=later) % n
            u = clock.unit(7, value(draw, i=i, k=k, K=len(vary)))
            return high if formula == between and j == n - 1 else value(formula, low=low, high=high, n=n, j=j, u=u)

        for i in range(24):
            self.assertEqual(sweep.inputs({"vary": vary, "seed": 7}, i), {
                "/a": by(entry, i, 0, 0, 2), "/b": by(between, i, 1, -2, 5, later=4), "/c": by(between, i, 2, 0, 7, n=4),
                "/d/steps": by(whole, i, 3, 3, 9), "/e": by(real, i, 4, -7, 11)})

    def test_the_step(self):
        steps = stated("sim/physics/README.md", "does in this order: (1. Gravity.*?) \\| constant")[0]
        draw = random.Random(5)
        starts = [[draw.choice((0, -1e-9, 250, high, high + 1e-9, draw.uniform(-20, high + 20))) for high in bounds] +
                  [draw.choice((0, -5, -15, draw.uniform(-900, 900))) for _ in range(2)] + list(bounds)
                  for bounds in ((500, 400), (-20, 400), (500, -30)) for _ in range(300)]
        for *start, right, bottom in starts:
            names = {"dt": 1 / 60, **dict(zip(("x", "y", "vx", "vy"), start)), "W": right + 128, "w": 128, "H": bottom + 64, "h": 64}
            holds = True
            for words, formula in re.findall("([^`]*)`(.*?)`", steps):
                formula = re.sub(r"(?<=[\dvxy]) (?=[dv])", " * ", re.sub(r"\|(\w+)\|", r"abs(\1)", formula))
                if re.search(r"\bif $", words):  # "and if" and "else" refer to the condition before.
                    before = holds if "and if" in words else not holds if re.search(r"\b[Ee]lse\b", words) else True
                    holds = before and eval(formula, {}, names)  # pylint: disable=eval-used
                elif re.match(r"\.|\d", words.strip()):
                    holds = True
                if holds and not re.search(r"\bif $", words):
                    exec(formula, {}, names)  # pylint: disable=exec-used
            sprite = replay.Sprite(*start)
            sprite.update(1 / 60, right, bottom)
            self.assertEqual([names[key] for key in ("x", "y", "vx", "vy")], [sprite.x, sprite.y, sprite.vx, sprite.vy], (start, right, bottom))

    def test_the_speed_at_a_wall(self):
        formulas = stated("golden/README.md", r"after gravity and drag: by the paper's step `(.*?)`, `(.*?)` of the row before")
        with h5py.File(SOURCE / "golden/flings/first-fling.h5") as file:
            rows, contacts = ({name: file[group][name][:] for name in file[group]} for group in ("trajectory", "contacts"))
        self.assertGreater(len(contacts["step"]), 5)
        for place, step in enumerate(contacts["step"]):
            names = {"AIR_DRAG": 0.999, "GRAVITY": 1200, "dt": rows["dt"][step], "vx": rows["vx"][step - 1], "vy": rows["vy"][step - 1]}
            self.assertEqual([contacts["vx_before"][place], contacts["vy_before"][place]],
                             [value(re.sub(r"(?<=[A-Z]) (?=[a-z(])", " * ", each), **names) for each in formulas])

    def test_the_time(self):
        base, comp, start, time, length, frames, relation, allowance = stated(
            "scenarios/README.md", r"With \(base, comp\) = \((\d), (\d)\) at the beginning and s the (first|last) frame of the current segment, the time after frame i "
            r"is t = (.*?)\. When dt changes, (.*?) of the old segment of n frames is added to \(base", r"`duration_s` .*? steps = (.*?);",
            r"the first frame that starts at t (\S+) at_s - (.*?) \(dt of the clock")
        timeline, base, s, before = clock.Timeline(), float(base), 0, []
        for i, dt in enumerate([0.1, 0.1, 0.1, 0.25, 0.25, 0.1, 1 / 3, 1 / 3]):
            if before and before[-1] != dt:
                base += value(length, n=len(before), dt=before[-1])
                s, before = i, []
            before.append(dt)
            self.assertAlmostEqual(value(time, base=base, comp=float(comp), i=i, s={"first": s, "last": i}[start], dt=dt), timeline.advance(dt), delta=1e-12)
        for duration_s, dt in ((1.0, 1 / 60), (1.0, 0.3), (0.0, 0.1), (2 + 1e-12, 0.5), (2 + 1e-6, 0.5)):
            self.assertEqual(value(frames, duration_s=duration_s, dt=dt), clock.steps_of_duration(duration_s, dt))
            for t in (duration_s, duration_s - 1e-9 * dt, duration_s - 1e-8 * dt, duration_s + dt):
                self.assertEqual(value(f"t {relation} at_s - {allowance.replace(' ', ' * ')}", t=t, at_s=duration_s, dt=dt), clock.is_due(t, duration_s, dt))

    def test_what_a_file_and_its_summary_hold(self):
        """Words of the documents choose the row, the order or the number."""
        order, *corner, row, after, second, of_second, first, of_first, least, apex, height, at_second, until, met = stated(
            "golden/README.md", r"first and last row of each contact, in order of the (first|last); in a corner ([xy]) before ([xy]) ", r"`/contacts/t`, `x`, `y` \| float64 \[M\] \| of the (first|last) row",
            r"vx_after`, `vy_after` \| float64 \[M\] \| velocity (after|before) the contact", r"In a corner the (first|second) contact's `(before|after)` is the (first|second) one's `(before|after)`",
            r"how far past the wall the position was before the clamp, px, (>=|<=) 0", r"the apex \(the (first|last) of the (highest|lowest) rows\), the position at each second of the first ten \(the (first|last) row (up to|from) that time\)", r"and speed as the sprite (met|left) it")
        anchor, far = stated("scenarios/README.md", r"Settled: row (\d) is the first anchor; a row whose x (or|and) y is more than 0\.5 px from the anchor becomes the anchor\. If the last row .* settled since the anchor's time")
        place_of, corners, settled = {"first": 0, "last": -1, "second": 1}, 0, 0
        for path in sorted((SOURCE / "golden").rglob("*.h5")):
            with h5py.File(path) as file:
                if "trajectory" not in file or len(file["trajectory/x"]) != file.attrs["steps"] + 1:
                    continue
                rows, contacts = ({name: file[group][name][:] for name in file[group]} for group in ("trajectory", "contacts"))
            summary, steps = path.with_suffix(".txt").read_text(encoding="utf-8"), {"first": contacts["step"], "last": contacts["last_step"]}
            placed = list(zip(steps[order], (corner.index("x" if wall < 4 else "y") for wall in contacts["wall"])))
            self.assertEqual(sorted(placed), placed, path)
            for name in ("t", "x", "y"):
                self.assertEqual(contacts[name].tobytes(), rows[name][steps[row]].tobytes(), path)
            self.assertTrue((contacts["overshoot"] * {">=": 1, "<=": -1}[least] >= 0).all(), path)
            for place in numpy.flatnonzero(numpy.diff(contacts["step"]) == 0):
                corners += 1
                for name in ("vx", "vy"):
                    self.assertEqual(*(contacts[f"{name}_{when}"][place + place_of[which]] for which, when in ((second, of_second), (first, of_first))), path)
                    self.assertEqual(contacts[f"{name}_{after}"][place + 1], rows[name][contacts["step"][place]], path)
            for place, speed in enumerate(re.findall(r"^  \d.* at ([\d.]+) px/s$", summary, re.MULTILINE)):
                if len(placed) <= 40:
                    self.assertAlmostEqual(float(speed), math.hypot(*(contacts[f"{name}_{ {'met': 'before', 'left': 'after'}[met] }"][place] for name in ("vx", "vy"))), delta=1e-6 + 1e-9 * float(speed))
            highest = numpy.flatnonzero(rows["y"] == {"highest": min, "lowest": max}[height](rows["y"]))[place_of[apex]]
            self.assertIn(f"y {rows['y'][highest]:.6f} px, step {highest}\n", summary)
            for seconds, step in re.findall(r"^  (\d+) s  x .*, step (\d+)$", summary, re.MULTILINE):
                late = rows["t"] - int(seconds)
                self.assertEqual(int(step), numpy.flatnonzero(late <= 1e-9 if until == "up to" else late >= -1e-9)[place_of[at_second]], path)
            at = int(anchor)
            for place in range(len(rows["t"])):
                if {"or": any, "and": all}[far](abs(rows[name][place] - rows[name][at]) > 0.5 for name in ("x", "y")):
                    at = place
            for since in re.findall(r"^settled since: (\S+) s$", summary, re.MULTILINE):
                settled += 1
                self.assertEqual(float(since), rows["t"][at], path)
        self.assertGreater(min(corners, settled), 50)

    def test_the_exact_motions(self):
        v_n, s_n, y_n, slope, moved, phi1, speed, phi2, law_slope, kappa, same_kappa, law_speed, eta, loss, ode_loss = (
            re.sub(r"(?<=[\w)]) (?=[A-Za-z(])", "*", formula.replace("²", "^2")) for formula in stated(
                "sim/reference/README.md", r"v_n = (.*?) S_n = (.*?) y_n = (.*?) This is",
                r"The ODE is v' = (.*?)\. With z = -k t, displacement = (.*?) phi1\(z\) = (.*?) speed = (.*?) phi2\(z\) = (.*?) phi1 and",
                r"With L = -ln a, k = L / h and .*? v' = (.*?) kappa = (.*?) = (.*?) = [\d.]+ y' = (kappa v \+ eta) eta = (.*?) = [\d.]+ px/s",
                r"Along it de/dt = (.*?)\. The ODE without eta loses (.*?) only"))
        a, h, v_0, y_0 = 0.999, 1 / 60, -700.0, 300.0
        v, y, k = v_0, y_0, -math.log(a) / h

        def first(z):
            return value(phi1, z=z, e=math.e)

        def second(z):
            return value(phi2, z=z, phi1=first)

        def flown(v, t, gravity):
            """Displacement and speed by the document."""
            return [value(each, v=v, t=t, G=gravity, z=-k * t, phi1=first, phi2=second) for each in (moved, speed)]
        for n in range(1, 8):
            v = a * (v + 1200 * h)
            y += h * v
            names = {"a": a, "n": n, "v_0": v_0, "y_0": y_0, "G": 1200, "h": h}
            names["S_n"] = value(s_n, **names)
            ends, t = 1200 / k, n * h
            law = {"a": a, "L": k * h, "phi1": first(-k * h), "phi2": second(-k * h), "G": 1200, "h": h}
            law["kappa"] = value(kappa, **law)
            way, last = flown(v_0, t, law["kappa"] * 1200)
            law["eta"] = value(eta, **law)
            now = {"v": v, "k": k, "G": 1200, **law}
            rise, fall = (value(each, **now) for each in (law_slope, law_speed))
            ahead, behind = (flown(v_0, t + each, 1200)[1] for each in (1e-4, -1e-4))
            for found, wanted in ((value(slope, **{**now, "v": flown(v_0, t, 1200)[1]}), (ahead - behind) / 2e-4),
                                  (value(loss, **now), v * rise - 1200 * fall), (-value(ode_loss, **now), v * value(slope, **now) - 1200 * v),
                                  (value(v_n, **names), v), (value(y_n, **names), y), (law["kappa"], value(same_kappa, **law)),
                                  (flown(v_0, t, 1200)[1], ends + (v_0 - ends) * math.exp(-k * t)),
                                  (flown(v_0, t, 1200)[0], ends * t - (v_0 - ends) * math.expm1(-k * t) / k),
                                  (last, v), (y_0 + law["kappa"] * way + law["eta"] * t, y)):
                self.assertAlmostEqual(found, wanted, delta=1e-6)

    def test_the_state_hash(self):
        order, fields, block, kind, seed, of_blocks = stated(
            "golden/README.md", r"A row is 41 bytes: (\w+)-endian binary64 ([\w, ]*?), and the contact byte\.",
            r"Each block of ([\d,]+) rows .*? is hashed with XXH(\w+-\d+), seed (\d+), in canonical big-endian", r"`state_hash` is the XXH(\w+-\d+) of these hashes in order, as 32 lower-case")
        state_hash, packed = replay.StateHash(), []
        for i in range(5000):
            row = {"t": i / 60, "dt": 1 / 60, "x": i, "y": -i, "vx": 3.5, "vy": 1e-9 * i}
            names = fields.split(", ")
            packed.append(struct.pack(("<" if order == "little" else ">") + "d" * len(names) + "B", *map(row.get, names), i % 32))
            state_hash.add(row["dt"], row["x"], row["y"], row["vx"], row["vy"], i % 32)
        hashed = {name: getattr(xxhash, f"xxh{name.replace('-', '_')}_digest") for name in (kind, of_blocks)}
        rows = int(block.replace(",", ""))
        digests = [hashed[kind](b"".join(packed[i:i + rows]), seed=int(seed)) for i in range(0, len(packed), rows)]
        self.assertEqual(hashed[of_blocks](b"".join(digests)).hex(), state_hash.hexdigest())


class Witness(ProgramTest):
    """The second program's opinion of the first."""

    def run_of(self, scenarios):
        """The entries of `run --json`, with every row in a file, out/NAME.h5 ("output")."""
        return self.expect(AGREED, "run", *scenarios, "--set", "/record/every=1", "--json", "-o", "out/").json["runs"]

    def test_every_row_and_contact_agrees(self):
        for folder in FOLDERS:
            scenarios = {path: replay.Scenario(replay.load(path)) for path in sorted(folder.rglob("*.json"))}
            scenarios = {path: scenario for path, scenario in scenarios.items() if scenario.steps <= STEPS_MAX}
            self.assertGreaterEqual(len(scenarios), 80 if folder == FOLDERS[0] else 3)
            for entry, scenario in zip(self.run_of(scenarios), scenarios.values(), strict=True):
                with h5py.File(self.folder / entry["output"]) as file:
                    self.assertIsNone(difference(replay.play(scenario), entry, file), entry["scenario"])

    def test_a_difference_of_one_bit_is_detected(self):
        path = FOLDERS[0] / "flings/first-fling.json"
        entry, = self.run_of([path])
        played = replay.play(replay.Scenario(replay.load(path)))
        with h5py.File(self.folder / entry["output"]) as file:
            self.assertIsNone(difference(played, entry, file))
            for columns, name in ((played[0]["final"], "x_px"), (played[1]["y"], 6), (played[2]["overshoot"], 0)):
                kept, columns[name] = columns[name], math.nextafter(columns[name], math.inf)
                self.assertIn("final" if name == "x_px" else f"at [{name}]", difference(played, entry, file))
                columns[name] = kept

    def test_the_vectors_are_what_the_second_program_makes(self):
        stored = pathlib.Path(__file__).with_name("vectors.json").read_text(encoding="utf-8")
        self.assertTrue(json.dumps(vectors.all_vectors(), indent=1) + "\n" == stored, "vectors.json is not what `vectors.py` prints")
