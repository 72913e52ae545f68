"""Sweeps of cores that describe themselves: every number of a member is that of its run, in a project that uses the package."""

import csv
import math
import shutil
import sys

import h5py
import numpy as np

import own_cores_test
from process import succeed
from program import AGREED, BAD_INPUT, DISAGREED, GOLDEN_MISSING, PROGRAM, SOURCE, fling
from sweep_program import NO_CLUSTER

sys.path.insert(0, str(SOURCE / "tests/oracle"))
import sweep as oracle  # noqa: E402 pylint: disable=wrong-import-position

ALL = ["final", "contacts", "at_rest", "extremes", "state_hash"]


def scenario(steps, **changes):
    return {"format": "hyrax-scenario/1", "clock": {"rate_hz": 60}, "steps": steps, **changes}


def sweep(base, vary, members=12, **changes):
    return {"format": "hyrax-sweep/1", "base": base, "members": members, "seed": 2**64 - 5, "vary": vary, "keep": ALL, **changes}


BALLS = sweep(scenario(200, inputs={"height_px": 500}, events=[{"step": 100, "strike": {"vx_px_per_s": -90, "vy_px_per_s": 0}},
                                                               {"at_s": 2, "stop": {}}], expect={"finite": True}),
              {"/start/a.vx_px_per_s": {"uniform": [200, 500]}, "/inputs/width_px": {"grid": [400, 801, 4]}, "/steps": {"grid": [130, 170, 3]},
               "/parameters/restitution": {"uniform": [0, 1]}, "/events/0/strike/vy_px_per_s": {"choice": [-600, 0.5]},
               "/clock/rate_hz": {"choice": [60, 59.94]}, "/events/0/step": {"uniform": [0, 100]}})
SWEEPS = {
    "balls": BALLS,
    "pet": sweep(scenario(200), {"/start/bounces": {"uniform": [0, 2**32 - 1]}, "/start/pose": {"choice": ["sit", 2, "fly"]},
                                 "/start/spin_rad_per_s": {"grid": [-2, 2, 3]}, "/parameters/floor_px": {"choice": [300, 500]}}),
    "platform": sweep(scenario(60, inputs={"move": [0.5] * 60}),
                      {"/inputs/jump": {"choice": [True, False]}, "/start/on_ground": {"choice": [False, True]},
                       "/parameters/gravity_px_per_s2": {"uniform": [900, 2000.1]}, "/start/player_y_px": {"grid": [-0.7, 0.1, 4]},
                       "/inputs/move/7": {"uniform": [-1, 1]}}),
    "fixed": sweep(scenario(40), {"/start/big": {"uniform": [0, 2**64 - 1]}, "/start/low": {"uniform": [-2**63, 2**63 - 1]},
                                  "/start/ticks": {"member": True}, "/start/s": {"grid": [-5, 5, 6]}, "/clock/jitter/seed": {"member": True}})}
SWEEPS["fixed"]["base"]["clock"]["jitter"] = {"kind": "uniform", "fraction": 0.2, "seed": 0}
WHOLE = {"/start/bounces", "/start/big", "/start/low", "/start/ticks", "/start/s"}
# The type of each that is no float64.
TYPES = {"bounces": "<u4", "pose": "|u1", "player_x_px": "<f4", "player_y_px": "<f4", "vy_px_per_s": "<f4", "platform_x_px": "<f4", "on_ground": "|u1",
         "x": "<i4", "v": "<i4", "ticks": "|u1", "s": "<i2", "big": "<u8", "low": "<i8", "up": "|u1"}
NAMES = ["sit", "fly", "land"]


def datasets(path):
    """All below /members and /inputs, by path."""
    found = {}
    with h5py.File(path) as file:
        for group in ("members", "inputs"):
            file[group].visititems(lambda name, item, group=group: found.update({f"{group}/{name}": item[()]})
                                   if isinstance(item, h5py.Dataset) else None)
    return found


class OwnCoresSweep(own_cores_test.OwnCoresProject):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        header = cls.project / "balls_core.h"  # With one value more, and with a constant changed.
        text = header.read_text(encoding="utf-8")
        for name, changed in (("longer", text.replace('see("b", b);', 'see("b", b);\n    see("width", width);')),
                              ("other", text.replace("0.5 * (1 + restitution)", "0.25 * (1 + restitution)"))):
            assert changed != text
            shutil.copy(cls.project / "build/balls-sim", cls.project / "build/first-sim")
            header.write_text(changed, encoding="utf-8")
            succeed("cmake", "--build", cls.project / "build", "--target", "balls-sim")
            (cls.project / "build/balls-sim").rename(cls.project / f"build/{name}-sim")
            (cls.project / "build/first-sim").rename(cls.project / "build/balls-sim")

    def sweep(self, *arguments, exit_code=AGREED, **options):
        return self.expect(exit_code, "sweep", *arguments, env=NO_CLUSTER, **options)

    def refused(self, document, says):
        self.write("sweep.json", document)
        self.sweep("sweep.json", exit_code=BAD_INPUT, says=says)
        self.assertFalse((self.folder / "sweep.h5").exists())

    def row_of_run(self, core, document):
        """What each dataset has of a member, from its run."""
        self.write("one.json", document)
        (run,) = self.expect(AGREED, "run", "one.json", "-o", "one.csv", "--json").json["runs"]
        with open(self.folder / "one.csv", encoding="utf-8") as file:
            columns, *rows = csv.reader(file)
        row = {"members/at_rest_since": math.nan if run["at_rest_since_s"] is None else float(run["at_rest_since_s"]),
               "members/state_hash": list(bytes.fromhex(run["state_hash"]))}
        for name, value in run["final"].items():
            row[f"members/final/{name}"] = NAMES.index(value) if value in NAMES else value
            if name in ("pose", "on_ground", "up"):
                continue
            is_whole = core == "fixed" or name == "bounces"
            values = [(int if is_whole else float)(each[columns.index(name)]) for each in rows]
            row[f"members/min/{name}"], row[f"members/max/{name}"] = min(values), max(values)
        return {**row, **{f"members/contacts/{name}": count for name, count in run["contacts"].items()}}

    def test_every_number_of_a_member_is_that_of_its_run(self):
        for core, document in SWEEPS.items():
            with self.subTest(core):
                self.use(core)
                self.write("sweep.json", document)
                self.sweep("sweep.json")
                found = datasets(self.folder / "sweep.h5")
                expected = {}
                for member in range(12):
                    alone = oracle.scenario(document, member, WHOLE)
                    row = self.row_of_run(core, alone)
                    for key, value in oracle.inputs(document, member, WHOLE).items():
                        row[f"inputs/{key[1:].replace('/', '.')}"] = NAMES.index(value) if value in NAMES else value
                    for name, value in row.items():
                        expected.setdefault(name, []).append(value)
                    self.sweep("sweep.json", "--member", str(member), "-o", "member.json", "--force")
                    (run,) = self.expect(AGREED, "run", "member.json", "-o", "member.csv", "--json").json["runs"]
                    self.assertEqual(list(bytes.fromhex(run["state_hash"])), row["members/state_hash"])
                self.assertEqual(sorted(found), sorted(expected))
                for name, values in expected.items():
                    np.testing.assert_array_equal(found[name], np.array(values, dtype=found[name].dtype), name)
                    value = name.rsplit("/", 1)[-1].removeprefix("start.")
                    if name.startswith(("members/final", "members/min", "inputs/start")):
                        self.assertEqual(found[name].dtype.str, TYPES.get(value, "<f8") if core != "pet" or value[0] != "v" else "<f8", name)
                self.assertGreater(len({tuple(code) for code in found["members/state_hash"]}), 6)

    def test_threads_and_parts_change_no_byte(self):
        self.use("balls")
        self.write("sweep.json", BALLS)
        for threads in ("1", "2"):
            self.sweep("sweep.json", "--threads", threads, "-o", f"of-{threads}.h5")
        for part in range(3):
            self.sweep("sweep.json", "--part", f"{part}/3", "-o", "p.h5")
        parts = [f"p.part-{part}-of-3.h5" for part in (2, 0, 1)]
        self.sweep("--merge", *parts[1:], "-o", "of-merge.h5", exit_code=GOLDEN_MISSING)
        self.sweep("--merge", *parts, "-o", "of-merge.h5")
        first, *others = ((self.folder / f"of-{name}.h5").read_bytes() for name in ("1", "2", "merge"))
        self.assertEqual([other == first for other in others], [True, True])

    def test_the_file_says_what_its_numbers_are(self):
        self.use("pet")
        self.write("base.json", SWEEPS["pet"]["base"])
        self.write("sweep.json", {**SWEEPS["pet"], "base": "base.json", "keep": ["final", "extremes"]})
        self.sweep("sweep.json")
        with h5py.File(self.folder / "sweep.h5") as file:
            self.assertEqual((file.attrs["format"], file.attrs["physics"], file.attrs["core_name"]), ("hyrax-ensemble/1", "hyrax-core/1", "pet"))
            self.assertEqual(sorted(file["members"]), ["final", "max", "min"])
            for values in (file["members/final/pose"], file["inputs/start.pose"]):
                self.assertEqual(h5py.check_enum_dtype(values.dtype), {"sit": 0, "fly": 1, "land": 2})
            self.assertEqual((file["members/min/y_px"].attrs["units"], file["inputs/parameters.floor_px"].attrs["units"]), ("px", "px"))
            self.assertNotIn("units", file["members/final/bounces"].attrs)
            self.assertNotIn("pose", file["members/max"])
            self.assertEqual(file["members/final/x_px"].dims[0][0], file["member"])

    def test_wrong_keys_are_refused_with_their_place(self):
        self.use("balls")
        base = scenario(100, events=[{"step": 90, "stop": {}}])
        for vary, says in (
                ({"/start/a.x_pz": {"uniform": [0, 1]}}, "(did you mean a.x_px?)"),
                ({"/inputs/width_px": {"grid": [4000, 4097, 12]}}, "sweep.json: member 11: /inputs/width_px: must be a number 320 .. 4096 (found 4097)"),
                ({"/steps": {"grid": [100, 80, 12]}}, "must be [low, high, n] with low <= high"),
                ({"/steps": {"grid": [80, 102, 12]}}, "sweep.json: member 0: /events/0/step: must be below the number of steps, 80 (found 90)"),
                ({"/clock/rate_hz": {"choice": [60, -1]}}, "/clock/rate_hz: must be greater than 0"),
                ({"/start/a.x_px": {"choice": ["left"]}}, "sweep.json: /vary/~1start~1a.x_px/choice/0: must be a number (found \"left\")")):
            self.refused(sweep(base, vary), says)
        for core, vary, says in (
                ("platform", {"/inputs/jump": {"choice": [True, 1]}}, "sweep.json: /vary/~1inputs~1jump/choice/1: must be true or false (found 1)"),
                ("platform", {"/start/player_x_px": {"uniform": [0, 1e39]}}, "/start/player_x_px: must be a number -3.4028235e+38 .. 3.4028235e+38 (found "),
                ("fixed", {"/start/ticks": {"member": True}}, "sweep.json: member 256: /start/ticks: must be a whole number 0 .. 255 (found 256)"),
                ("fixed", {"/inputs/x": {"member": True}}, "/inputs/x: unknown key (found x)")):
            self.use(core)
            self.refused(sweep(scenario(10), vary, members=300), says)
        self.refused(sweep(scenario(10, core="pool"), {}), "is a scenario of the core pool: play it with pool-sim")

    def test_parts_of_other_cores_and_descriptions_are_not_merged(self):
        self.write("sweep.json", BALLS)
        for part, core in enumerate(("balls", "longer", "other")):
            self.use(core)
            self.sweep("sweep.json", "--part", f"{part}/3")
        self.use("balls")
        first, longer, other = (f"sweep.part-{part}-of-3.h5" for part in range(3))
        self.sweep("--merge", first, longer, other, "-o", "all.h5", exit_code=BAD_INPUT,
                   says=f"{longer}: was computed with another description of the core balls (value width was added)")
        self.sweep("--merge", first, other, "-o", "all.h5", exit_code=BAD_INPUT, says=f"{other}: was computed by another core than the first file")
        self.use("pet")
        self.sweep("--merge", first, "-o", "all.h5", exit_code=BAD_INPUT, says="is a sweep of the core balls: join its parts with balls-sim")
        self.expect(BAD_INPUT, "report", first, "-o", "a.html", says=f"{first}: ")
        self.program = PROGRAM
        says = f"{first}: is a sweep of the core balls, which describes itself: balls-sim joins its parts; no page shows it"
        self.sweep("--merge", first, "-o", "all.h5", exit_code=BAD_INPUT, says=says)
        self.expect(BAD_INPUT, "report", first, "-o", "a.html", says=says)
        self.write("paper.json", {"format": "hyrax-sweep/1", "base": fling(), "vary": {}})
        self.sweep("paper.json", "--part", "0/1")
        self.use("balls")
        self.sweep("--merge", "paper.part-0-of-1.h5", "-o", "all.h5", exit_code=BAD_INPUT, says="join its parts with hyrax-sim")

    def test_a_member_that_ends_early_keeps_what_it_came_to(self):
        self.use("faulty")
        self.write("sweep.json", sweep(scenario(60), {"/parameters/fault": {"grid": [0, 3, 4]}}, members=4))  # none, step_throws, property_throws, nan
        outcome = self.sweep("sweep.json", exit_code=DISAGREED)
        self.assertIn("sweep.json: 3 members ended early; member 1: row 32: out of fuel", outcome.err)
        self.assertEqual(self.sweep("sweep.json", "--json", exit_code=DISAGREED).json["ended_early"], 3)
        found = datasets(self.folder / "sweep.h5")
        for member in range(1, 4):
            self.sweep("sweep.json", "--member", str(member), "-o", "member.json", "--force")
            (run,) = self.expect(DISAGREED, "run", "member.json", "-o", "member.csv", "--json").json["runs"]
            self.assertEqual(str(found["members/final/x_px"][member]), str(float(run["final"]["x_px"])))
            self.assertEqual(bytes(found["members/state_hash"][member]).hex(), run["state_hash"])
        shutil.copy(self.folder / "sweep.h5", self.folder / "before.h5")
        self.write("sweep.json", sweep(scenario(60, parameters={"fault": "property_throws"}), {"/start/x_px": {"grid": [0, 1, 2]}}, members=2))
        self.sweep("sweep.json", exit_code=DISAGREED, says="sweep.json: member 1: row 0: lost; nothing written")
        self.assertEqual((self.folder / "sweep.h5").read_bytes(), (self.folder / "before.h5").read_bytes())
