"""Programs with an altered core: what `check` says of runs that become infinite, sweeps, and how often a run is played."""

import os
import re

import h5py

from altered import ALTERED, run_altered
from process import succeed
from program import AGREED, BAD_INPUT, DISAGREED, GOLDEN_MISSING, ProgramTest, fling
from traced import SHIPPED, traced

FIRST_FLING = "scenarios/flings/first-fling.json"
STEPS = 3000

# Constants, the order and the kind of statements, a bound alone, a setter.
CORES = ("two_constants", "drag_before_gravity", "ground_not_strict", "speed_limited", "fling_adds")
# The last throw leaves the threshold of rest, to the bit.
EVENTS = [{"step": 20, "fling": {"vx_px_per_s": 200, "vy_px_per_s": -800}}, {"step": 90, "stop": {}},
          {"step": 120, "resize": {"window": {"width_px": 1400, "height_px": 700}}},
          {"step": 298, "fling": {"vx_px_per_s": 50, "vy_px_per_s": -11.658324991658324}}]


class NonFinite(ProgramTest):
    """A core whose bounces explode."""

    def test_runs_that_become_infinite_come_first_and_are_not_blessed(self):
        of_first = "vx is infinite from step 120 of 600 (2.00 s)"
        for options, wanted in (((), f"1 of 1 scenario becomes non-finite: {of_first}.\n"), ((), "core: changed\n"), (("--verbose",), f"  not finite {of_first}\n"),
                                (("--annotate", "github"), f"::{of_first}; expect finite")):
            out = run_altered("bounce_explodes", "check", *options, FIRST_FLING, exit_code=DISAGREED).out
            self.assertIn(wanted, out)
            self.assertNotRegex(out, "bless scenarios|inf px")
        (group,) = run_altered("bounce_explodes", "check", "--json", FIRST_FLING).json["groups"]
        self.assertEqual((group["operation"], group["detail"], group["scenarios"]), ("non_finite", of_first, [FIRST_FLING]))
        run_altered("bounce_explodes", "run", FIRST_FLING, "-o", self.folder / "a.csv")
        lines = (self.folder / "a.csv").read_text().splitlines()
        self.assertEqual((len(lines), lines[-1].split(",")[:6:5]), (122, ["120", "-inf"]))
        outcome = run_altered("bounce_explodes", "bless", FIRST_FLING, "--reason", "none", exit_code=DISAGREED)
        self.assertIn(of_first, outcome.out + outcome.err)

    def test_one_without_golden_file_is_not_offered_to_bless(self):
        scenario = self.write("scenarios/fling.json", fling())
        out = run_altered("bounce_explodes", "check", self.folder / scenario, exit_code=GOLDEN_MISSING).out
        self.assertRegex(out, "fling.json: missing: v[xy] is infinite from step .*; no golden file at ")
        self.assertNotIn("hyrax-sim bless", out)


class SweepsOfTwoCores(ProgramTest):
    """A part names the core that computed it."""

    def test_parts_of_two_are_not_merged_those_of_two_headers_with_one_step_are(self):
        sweep = self.folder / self.write("sweep.json", {"format": "hyrax-sweep/1", "base": fling(), "members": 6, "seed": 2,
                                                        "vary": {"/start/vx_px_per_s": {"uniform": [-900, 900]}}})
        other = traced(SHIPPED.replace("GRAVITY = 1200.0", "GRAVITY = 1250.0"))
        own = traced(SHIPPED.replace("One frame of", "A frame of"))  # The same step.
        for part, core in enumerate((own, other, own)):
            self.assertEqual(core.run("sweep", sweep, "-o", self.folder / "sweep.h5", f"--part={part}/3").exit_code, AGREED)
        self.expect(AGREED, "sweep", "sweep.json", "--part", "1/3", "-o", "own.h5")
        parts = [f"sweep.part-{part}-of-3.h5" for part in range(3)]
        self.expect(BAD_INPUT, "sweep", "--merge", *parts, "-o", "merged.h5",
                    says=f"{parts[1]}: was computed by another core than the first file (")
        self.assertFalse((self.folder / "merged.h5").exists())
        os.rename(self.folder / "own.part-1-of-3.h5", self.folder / "sweep.part-1-of-3.h5.own")
        self.expect(AGREED, "sweep", "--merge", parts[0], "sweep.part-1-of-3.h5.own", parts[2], "-o", "merged.h5")


class NotRepeated(ProgramTest):
    """A core that does not repeat itself."""

    def test_it_is_neither_blessed_nor_accepted(self):
        scenarios = [self.folder / self.write(f"scenarios/{name}.json", fling(name=name, steps=3000)) for name in ("a", "b")]
        outcome = run_altered("hidden_state", "bless", *scenarios, "--reason", "x", exit_code=DISAGREED)
        self.assertIn("a.json: not blessed: this program does not repeat itself: played twice, the scenario gives different bits", outcome.err)
        self.assertEqual(self.names(), ["scenarios"])


class AlteredSweep(ProgramTest):
    """A sweep gives what the core gives, member by member: its kernels stand for the listing alone."""

    def test_every_member_is_its_run(self):
        base = fling(events=EVENTS, steps=300)
        # Some start on the floor, where comparisons on the bound decide: gravity takes 20 px/s in a step.
        vary = {"/start/vx_px_per_s": {"uniform": [-4000, 4000]}, "/start/y_px": {"choice": [952, 500.25]},
                "/start/vy_px_per_s": {"choice": [-20, -700]}}
        sweep = self.write("sweep.json", {"format": "hyrax-sweep/1", "base": base, "members": 6, "seed": 2, "vary": vary,
                                          "keep": ["final", "contacts"]})
        members = [self.folder / f"member-{member}.json" for member in range(6)]
        for member, path in enumerate(members):
            self.expect(AGREED, "sweep", sweep, "--member", str(member), "-o", path)
        shipped = None
        for core in ("none", *CORES):
            with self.subTest(core=core):
                out = self.folder / f"{core}.h5"
                run_altered(core, "sweep", self.folder / sweep, "-o", out, exit_code=AGREED)
                with h5py.File(out) as file:
                    columns = [file["members"][name][:].tolist() for name in ("x", "y", "vx", "vy", "contacts")]
                runs = run_altered(core, "run", *members, "--json", "-o", f"{self.folder}/{core}/").json["runs"]
                found = list(map(list, zip(*columns)))
                self.assertEqual(found, [[*entry["final"].values(), list(entry["contacts"].values())] for entry in runs])
                shipped = found if core == "none" else shipped
                self.assertEqual(found == shipped, core == "none", "no member shows what is altered")


class Replays(ProgramTest):
    """The listing, as a core that counts its updates: no run is played twice."""

    def updates(self, *arguments):
        """How many updates `hyrax-sim ARGUMENTS` makes."""
        environment = {**os.environ, "HYRAX_ALTERED_CORE": "none", "HYRAX_COUNT_UPDATES": "1"}
        err = succeed(ALTERED, *arguments, cwd=self.folder, env=environment).err
        return int(re.search(r"^updates: (\d+)$", err, re.MULTILINE).group(1))

    def scenario(self):
        """A run that never repeats, which bounds an error against the reference."""
        return self.write("fling.json", fling(steps=STEPS, expect={"implementation_px_max": 1e-3}, clock={
            "rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.5, "seed": 7}}))

    def test_a_run_is_played_once_for_all_outputs(self):
        for options in ((), ("--figure", "fling.svg"), ("--drift",), ("--drift", "--rows", "--figure", "fling.svg"),
                        ("--drift", "--reference", "gsl"), ("-o", "fling.csv", "--drift")):
            with self.subTest(options=options):
                self.assertEqual(self.updates("run", self.scenario(), *options), STEPS)
