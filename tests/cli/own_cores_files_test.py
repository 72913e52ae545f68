"""Files, golden files and commands of a core that describes itself, in a project that uses the package."""

import json
import re
import shutil

import h5py
import numpy as np

from installed_package import PLAIN, InstalledPackage
from process import succeed
from program import AGREED, BAD_INPUT, DISAGREED, GOLDEN_MISSING, PROGRAM, SOURCE

CTEST_FAILED = 8

# A constant in an included header, a default, a value that can be added.
TUNING = "#pragma once\nconstexpr double bounce = 0.5;\n"
CORE = """#pragma once
#include "tuning.h"
enum class mood : signed char { calm, wild };
struct hyrax_core {
  double x = 10, y = 20, vx = 30, vy = 0, gravity = 900;
  float charge = 0.1F;
  int hits = 0;
  mood now = mood::calm;
  bool floor = false;
  void step(double dt) {
    vy += gravity * dt;
    x += vx * dt;
    y += vy * dt;
    charge *= 0.75F;
    floor = y > 300;
    if (floor) y = 300, vy = -bounce * vy, ++hits;
    now = floor ? mood::wild : mood::calm;
  }
  template <class See> void state(See&& see) {
    see("x_px", x), see("y_px", y), see("vx_px_per_s", vx), see("vy_px_per_s", vy);
    see("charge", charge), see("hits", hits), see("now", now, {"calm", "wild"});  // MORE
  }
  template <class See> void parameters(See&& see) { see("gravity_px_per_s2", gravity, {0.0, 5000.0}); }
  template <class See> void actions(See&& see) { see("kick", [&](double up) { vy = -up; }, {"up_px_per_s"}); }
  template <class See> void contacts(See&& see) const { see("floor", floor); }
  template <class See> void outputs(See&& see) const { see("energy_px2_per_s2", 0.5 * vy * vy - gravity * y); }
  template <class See> void properties(See&& see) const {
    see.always("stays above the floor", y <= 300);
    see.sometimes("flies high", y < 10);
  }
};
"""
# Which no run of the tests reaches.
HIDDEN_TIMER = "if (++age > 100000) x = 0;\n    x += vx * dt;"


def scenario(steps=200, **changes):
    return {"format": "hyrax-scenario/1", "core": "toy", "clock": {"rate_hz": 60}, "steps": steps, **changes}


KICKED = scenario(events=[{"step": 60, "kick": {"up_px_per_s": 800}}], expect={"final": {"hits": 2, "y_px": [0, 300]}, "finite": True})


class OwnCoresFiles(InstalledPackage):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.source = cls.root / "toy"
        (cls.source / "scenarios").mkdir(parents=True)
        (cls.source / "CMakeLists.txt").write_text(PLAIN.format(language="CXX", arguments="scenarios CORE toy_core.h"), encoding="utf-8")
        for name, document in (("kicked", KICKED), ("falls", scenario())):
            (cls.source / f"scenarios/{name}.json").write_text(json.dumps(document), encoding="utf-8")
        cls.programs = {}
        for name, core, tuning in (("first", CORE, TUNING), ("default", CORE.replace("gravity = 900", "gravity = 950"), TUNING),
                                   ("included", CORE, TUNING.replace("0.5", "0.625")),
                                   ("lively", CORE.replace("// MORE", "").replace("hits = 0", "hits = 0, age = 0").replace("x += vx * dt;", HIDDEN_TIMER).replace("y <= 300);", 'y <= 300);\n    see.always("slow", vy < 600);'), TUNING),
                                   ("rewritten", CORE.replace("gravity * dt", "dt * gravity").replace("y > 300", "300 < y"), TUNING),
                                   ("longer", CORE.replace("// MORE", 'see("spin", spin);').replace("hits = 0", "hits = 0, spin = 0"), TUNING)):
            (cls.source / "toy_core.h").write_text(core, encoding="utf-8")
            (cls.source / "tuning.h").write_text(tuning, encoding="utf-8")
            if not cls.programs:
                outcome = cls.configure(cls.source, "-DCMAKE_BUILD_TYPE=Quick", "-DCMAKE_CXX_FLAGS_QUICK=-O0")
                assert outcome.exit_code == 0, outcome
            succeed("cmake", "--build", cls.source / "build")
            cls.programs[name] = cls.root / name / "toy-sim"
            cls.programs[name].parent.mkdir()
            shutil.copy(cls.source / "build/toy-sim", cls.programs[name])

    def setUp(self):
        super().setUp()
        self.use("first")
        shutil.copytree(self.source / "scenarios", self.folder / "scenarios")

    def use(self, name):
        self.program = self.programs[name]

    def check(self, exit_code, *arguments):
        return self.expect(exit_code, "check", "--json", *arguments).json

    def test_a_trajectory_file_has_types_units_and_axes(self):
        self.expect(AGREED, "run", "scenarios/kicked.json", "--golden", "none", "-o", "a.h5")
        self.expect(AGREED, "run", "scenarios/kicked.json", "--golden", "none", "-o", "b.h5")
        self.assertEqual((self.folder / "a.h5").read_bytes(), (self.folder / "b.h5").read_bytes())
        self.expect(AGREED, "run", "scenarios/kicked.json", "--golden", "none", "-o", "a.csv")
        with h5py.File(self.folder / "a.h5") as file:
            rows = file["trajectory"]
            types = {name: dataset.dtype.str for name, dataset in rows.items()}
            self.assertEqual(types, {
                "step": "<i8", "t": "<f8", "dt": "<f8", "x_px": "<f8", "y_px": "<f8", "vx_px_per_s": "<f8", "vy_px_per_s": "<f8",
                "charge": "<f4", "hits": "<i4", "now": "|i1", "floor": "|u1", "energy_px2_per_s2": "<f8"})
            self.assertEqual(h5py.check_enum_dtype(rows["now"].dtype), {"calm": 0, "wild": 1})
            self.assertEqual(rows["vy_px_per_s"].attrs["units"], "px/s")
            self.assertNotIn("units", rows["hits"].attrs)
            self.assertEqual((rows.attrs["NX_class"], rows.attrs["signal"], rows.attrs["axes"]), ("NXdata", "x_px", "t"))
            self.assertEqual(rows["y_px"].dims[0][0], rows["t"])
            self.assertEqual(len(rows["t"]), 201)
            contacts = file["contacts"]
            self.assertEqual(h5py.check_enum_dtype(contacts["contact"].dtype), {"floor": 0})
            self.assertEqual(contacts.attrs["total"], len(contacts["step"]))
            flags = rows["floor"][:]
            self.assertTrue(all(flags[first] and flags[last] for first, last in zip(contacts["step"], contacts["last_step"])))
            self.assertEqual((file["events/frame"][0], json.loads(file["events/event"][0])), (60, {"kick": {"up_px_per_s": 800}}))
            self.assertEqual((file.attrs["physics"], file.attrs["core_name"], file.attrs["steps"]), ("hyrax-core/1", "toy", 200))
            description = json.loads(file.attrs["description"])
            self.assertEqual(description, self.expect(AGREED, "info", "--json").json["description"])
            table = np.genfromtxt(self.folder / "a.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
            for name in ("y_px", "charge", "hits", "now", "floor", "energy_px2_per_s2"):
                np.testing.assert_array_equal(table[name].astype(rows[name].dtype), rows[name][:], name)

    def test_run_says_what_happened(self):
        entry = self.expect(AGREED, "run", "scenarios/kicked.json", "--golden", "none", "--json", "-o", "a.h5").json["runs"][0]
        self.assertEqual(entry["final"]["now"], "calm")
        self.assertEqual(entry["contacts"]["floor"], entry["final"]["hits"])
        self.assertEqual([(each["name"], each["kind"], each["holds"]) for each in entry["properties"]],
                         [("stays above the floor", "always", True), ("flies high", "sometimes", True)])
        self.assertTrue(all(each["holds"] for each in entry["expect"]), entry["expect"])
        self.assertIsNone(entry["periodic_from_step"])
        text = self.expect(AGREED, "run", "scenarios/kicked.json", "--set", "/parameters={\"gravity_px_per_s2\": 700}", "--set", "/expect={}", "-o", "b.h5")
        self.assertIn("with           gravity_px_per_s2 700, not the core's own 900", text.out)

    def test_golden_files_are_missing_blessed_and_agree(self):
        self.assertEqual(self.check(GOLDEN_MISSING)["missing"], 2)
        command = re.search(r'toy-sim (.*) "\.\.\."', self.expect(GOLDEN_MISSING, "check", "--core").out)[1].split()
        self.assertEqual(command, ["bless", "scenarios", "--reason"])  # `bless --core` would be refused.
        self.expect(AGREED, *command, "first")
        document = self.check(AGREED)
        self.assertEqual((document["agreed"], document["cores"][0]["status"], document["never_shown"]), (2, "accepted", []))
        self.expect(AGREED, "check", "--core")
        accepted = sorted(path.name for path in (self.folder / "golden/core").rglob("*") if path.is_file())
        self.assertEqual(accepted, ["accepted.txt", "description.json", "step.txt", "toy_core.h", "tuning.h"])
        shutil.rmtree(self.source / "golden", ignore_errors=True)
        shutil.copytree(self.folder / "golden", self.source / "golden")
        shutil.copy(self.programs["first"], self.source / "build/toy-sim")
        succeed("ctest", "--test-dir", self.source / "build", "--output-on-failure")
        (self.folder / "scenarios/falls.json").unlink()
        document = self.check(DISAGREED)
        self.assertEqual((document["unreferenced"], document["never_shown"]), (1, []))
        self.expect(AGREED, "bless", "--prune")
        self.check(AGREED)

    def test_a_changed_default_is_named_and_tried_alone(self):
        self.expect(AGREED, "bless", "scenarios", "--reason", "first")
        self.use("default")
        document = self.check(DISAGREED)
        group = document["groups"][0]
        self.assertEqual((group["operation"], group["detail"], len(group["scenarios"])), ("core", "gravity_px_per_s2 900 -> 950", 2))
        change = next(each for each in document["cores"][0]["changes"] if each["detail"].startswith("gravity_px_per_s2"))
        self.assertEqual((change["from"], change["to"], change["scenarios"]), (900, 950, 2))
        self.assertGreater(document["results"][0]["max_px"], 1)
        self.assertEqual(set(document["results"][0]["max"]), {"px", "px/s", ""})
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "heavier", says="--accept contacts")

    def test_rows_that_a_golden_file_does_not_hold_are_played_by_the_accepted_step(self):
        short = scenario(1900)
        for length, name in ((1900, "short"), (3000, "long")):
            self.write(f"scenarios/{name}.json", {**short, "steps": length})
        self.expect(AGREED, "bless", "scenarios", "--reason", "first")
        for program_of in ("longer", "included"):  # A further value; another constant.
            self.use(program_of)
            results = {result["scenario"]: result for result in self.check(DISAGREED)["results"]}
            of_short, of_long = results["scenarios/short.json"], results["scenarios/long.json"]
            for key in ("first_divergence", "class"):
                self.assertEqual(of_long[key], of_short[key])
            self.assertEqual(of_long["max_px"], of_short["max_px"], "the ball is at rest when the short run ends")
            self.expect(DISAGREED, "run", "scenarios/long.json", "-o", "now.h5")
            document = self.expect(DISAGREED, "diff", "golden/long.h5", "now.h5", "--json").json
            for key in ("first_divergence", "class", "max_px"):
                self.assertEqual(document[key], of_long[key])

    def test_differences_of_two_steps_are_named_with_their_values_and_the_constant_of_an_included_file(self):
        self.expect(AGREED, "bless", "scenarios", "--reason", "first")
        self.use("default")  # In the start, not in the step.
        self.assertEqual(self.check(DISAGREED)["cores"][0]["differences"], [])
        self.use("included")
        core = self.check(DISAGREED)["cores"][0]
        speed = "(vy_px_per_s + dt * gravity_px_per_s2) * "
        self.assertEqual((core["status"], core["why"], core["paths"]), ("changed", None, 2))
        self.assertEqual(core["differences"], [{"function": "step", "values": ["vy_px_per_s"], "before": [speed + "0.5"], "after": [speed + "0.625"]}])
        change = core["changes"][0]
        self.assertEqual((change["detail"], change["from"], change["to"], change["scenarios"]), ("bounce 0.5 -> 0.625", 0.5, 0.625, 2))
        text = self.expect(DISAGREED, "check").out
        self.assertIn("constant: bounce 0.5 -> 0.625 (tuning.h); alone reproduces 2\n", text)
        self.assertIn(f"  step: vy_px_per_s: `{speed}0.5` -> `{speed}0.625`\n", text)
        self.assertEqual(text.count("  to accept it "), 1)  # The core with its scenarios.
        self.assertNotIn("to accept it", self.expect(AGREED, "check", "--core").out)  # It would be refused.
        self.expect(AGREED, "bless", "scenarios/falls.json", "--accept", "contacts", "--reason", "bouncier")
        self.assertEqual(self.check(DISAGREED)["agreed"], 1)

    def test_an_equal_rewrite_is_proved_equal(self):
        self.expect(AGREED, "bless", "scenarios", "--reason", "first")
        self.use("rewritten")
        self.assertEqual(self.check(AGREED)["cores"][0]["status"], "proved_equal")
        self.assertIn("changed in text only: proved equal to the accepted core", self.expect(AGREED, "check").out)
        self.assertIn("proved equal", self.expect(AGREED, "check", "--core").out)
        self.expect(AGREED, "bless", "--core", "--reason", "the same")
        self.assertEqual(self.check(AGREED)["cores"][0]["status"], "accepted")

    def test_a_hidden_timer_that_no_run_reaches_is_not_proved_equal(self):
        self.use("lively")
        self.assertEqual(self.expect(AGREED, "info", "--json").json["step"],
                         "not complete: a member that is not declared changes, and decides what the step does")
        self.use("first")
        self.expect(AGREED, "bless", "scenarios", "--reason", "first")
        self.use("lively")
        core = self.check(DISAGREED)["cores"][0]
        self.assertEqual((core["status"], core["paths"], core["differences"]), ("changed", None, []))

    def test_a_change_that_no_scenario_shows_is_accepted_by_the_command_that_check_prints(self):
        shutil.rmtree(self.folder / "scenarios")
        self.write("scenarios/short.json", scenario(20))  # Without a bounce.
        self.expect(AGREED, "bless", "scenarios", "--reason", "first")
        self.use("included")
        command = re.search(r'to accept it    \S*toy-sim (.*) "\.\.\."', self.expect(DISAGREED, "check", "--core").out)[1].split()
        self.assertIn("core: accepted in golden/core", self.expect(AGREED, *command, "second").out)

    def test_another_description_is_another_shape(self):
        self.expect(AGREED, "bless", "scenarios", "--reason", "first")
        self.use("longer")
        result = self.check(DISAGREED)["results"][0]
        self.assertEqual((result["class"], result["sentence"]),
                         ("shape", "value spin was added: bless --accept shape; no position differs, no contact moved"))
        self.assertEqual(result["max_px"], 0)
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "spin", says="--accept shape")
        self.expect(AGREED, "bless", "scenarios", "--reason", "spin", "--accept", "shape")
        self.check(AGREED)

    def test_a_property_that_is_broken_is_told_beside_what_differs(self):
        self.expect(AGREED, "bless", "scenarios", "--reason", "first")
        self.use("lively")
        outcome = self.expect(DISAGREED, "check", "--annotate", "github")
        self.assertIn('  fault   scenarios/falls.json: property "slow" does not hold at step 40 (', outcome.out)
        # What the core is the cause of is marked where its header changed.
        self.assertIn("::error file=toy_core.h,line=", outcome.out)

    def test_diff_reads_files_of_an_older_description(self):
        self.use("longer")
        for name in ("a", "b"):
            self.expect(AGREED, "run", "scenarios/falls.json", "--golden", "none", "--set", f"/start/spin={ord(name)}", "-o", f"{name}.h5")
        self.use("first")
        self.assertIn("/start/spin 97 -> 98", self.expect(DISAGREED, "diff", "a.h5", "b.h5").out)

    def test_expect_is_updated_and_reports_are_written(self):
        self.expect(AGREED, "bless", "scenarios", "--reason", "first")
        self.write("scenarios/falls.json", scenario(expect={"final": {"y_px": [10, 11]}, "contacts": {"floor": [90, 91]}}))
        outcome = self.expect(DISAGREED, "check", "--junit", "a.xml", "--annotate", "github", "--summary", "a.md")
        self.assertIn('failures="1"', (self.folder / "a.xml").read_text(encoding="utf-8"))
        self.assertIn("not agreed", (self.folder / "a.md").read_text(encoding="utf-8"))
        self.assertIn("::error file=scenarios/falls.json", outcome.out)
        self.assertIn('bless scenarios/falls.json --reason "..." --update-expect', outcome.out)
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "first")
        self.expect(AGREED, "bless", "scenarios/falls.json", "--reason", "first", "--update-expect")
        self.check(AGREED)

    def test_a_page_shows_files_and_says_whether_they_agree_with_another(self):
        self.expect(AGREED, "run", "scenarios/falls.json", "--golden", "none", "-o", "a.h5", "--report", "run.html")
        self.expect(AGREED, "run", "scenarios/falls.json", "--golden", "none", "--set", "/start={\"charge\": 0.5}", "-o", "b.h5")
        self.expect(AGREED, "report", "a.h5", "b.h5", "--against", "a.h5", "-o", "files.html")
        page = (self.folder / "files.html").read_text(encoding="utf-8")
        _, a, b = page.split("<article")[1:]  # The first is the contact sheet.
        self.assertIn("Agrees with a.h5, bit for bit.", a)
        self.assertIn("differs from a.h5: ", b)
        self.assertNotIn("golden file", a)
        self.assertIn("golden file", b)  # Its path, in the legend.
        # The same picture, rows, contacts and end as of the run that wrote it.
        run = (self.folder / "run.html").read_text(encoding="utf-8")
        for part in (r"<path[^>]*>", r"<td[^>]*>[^<]*", r"<p>(?:Contacts|End): [^<]*"):
            self.assertEqual(re.findall(part, a), re.findall(part, run), part)
        self.assertIn("<p>End: ", a)
        self.expect(BAD_INPUT, "report", "a.h5", "-o", "a.h5", says="a.h5")
        self.expect(BAD_INPUT, "report", "scenarios/falls.json", "-o", "page.html", says="scenarios/falls.json: ")
        self.program = PROGRAM
        self.expect(BAD_INPUT, "report", "a.h5", "-o", "page.html", says="toy-sim")
        self.assertFalse((self.folder / "page.html").exists())

    def test_files_of_other_cores_are_refused_with_their_programs(self):
        self.expect(AGREED, "run", "scenarios/falls.json", "--golden", "none", "-o", "a.h5")
        fling = SOURCE / "golden/flings/first-fling.h5"
        self.expect(BAD_INPUT, "diff", "a.h5", fling, says="read it with hyrax-sim")
        self.program = PROGRAM
        self.expect(BAD_INPUT, "diff", fling, "a.h5", says="a.h5: is of the core toy, which describes itself: read it with toy-sim")
        self.expect(BAD_INPUT, "run", "scenarios/falls.json", says="is a scenario of the core toy: play it with toy-sim")
