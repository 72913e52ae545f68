"""What `check` says of scenarios that differ: causes, consequences, and the documents for CI.

HYRAX_ALTERED_SIM is a hyrax-sim whose core is changed on purpose; HYRAX_ALTERED_CORE selects the change.
"""

import json
import os
import re
import shlex
import shutil

import h5py
import numpy
import xxhash

from check_program import CheckTest
from process import run
from program import AGREED, BAD_INPUT, DISAGREED, GOLDEN_MISSING, SOURCE, fling

ALTERED = os.environ["HYRAX_ALTERED_SIM"]


class CauseTest(CheckTest):
    """The program with a changed core."""

    def altered(self, core, *arguments, exit_code=DISAGREED, command=("check",)):
        """The outcome of `check` without random flings, or of another command, with that core."""
        no_flings = ("--flings", "0") if command == ("check",) else ()
        outcome = run(ALTERED, *command, *arguments, *no_flings, cwd=self.folder, env={**os.environ, "HYRAX_ALTERED_CORE": core})
        self.assertEqual(outcome.exit_code, exit_code, outcome)
        return outcome


class Causes(CauseTest):

    def test_without_an_accepted_core_the_cause_is_unknown(self):
        shutil.rmtree(self.folder / "golden/core")
        document = self.altered("gravity_stronger", "--json").json
        group, = document["groups"]
        why = "no accepted core in golden/core; to accept this program's: hyrax-sim bless --core --reason \"...\""
        self.assertEqual((group["operation"], group["detail"], document["cores"][0]["status"]), ("unknown", why, "none"))
        out = self.altered("gravity_stronger", "--annotate", "github").out
        self.assertRegex(out, rf"\Acore: {why}\n3 of 3 scenarios differ; cause unknown: {why}\.\n  Contacts differ .*\n"
                              r"  first   step 1, field y of scenarios/\S+\n  worst   ")
        self.assertEqual(out.count(f"title=hyrax-sim check%3A disagreed::cause unknown: {why}: "), 3)
        self.assertIn(why, self.altered("gravity_stronger", "--core", exit_code=GOLDEN_MISSING).out)
        core, = self.altered("gravity_stronger", "--core", "--json", exit_code=GOLDEN_MISSING).json["cores"]
        self.assertEqual(core["why"], why)
        alone = self.write("third.json", fling(name="third", steps=10))
        out = self.expect(DISAGREED, "check", alone, "--golden", "golden").out
        self.assertIn("no accepted core in golden/core", out)
        self.assertNotIn("--core", out)  # bless refuses it there.

    def test_the_command_that_accepts_a_core_is_of_the_library_that_was_checked(self):
        shutil.copytree(self.folder / "scenarios", self.folder / "throws")
        self.bless("throws", "--golden", "accepted")
        for arguments in ((), ("scenarios/a",), ("throws", "--golden", "accepted"), ("--core", "throws", "--golden", "accepted")):
            folder = self.folder / ("accepted" if "throws" in arguments else "golden") / "core"
            kept = (folder / "step.txt").read_bytes()
            for damage in (shutil.rmtree, lambda folder: (folder / "accepted.txt").unlink())[:1 if arguments else 2]:
                damage(folder)
                out = self.hyrax_sim("check", *arguments).out
                command = re.search("^core: .* this program's(?: core)?: (.*)", out, re.MULTILINE)[1].split()
                self.assertEqual(command[0], "hyrax-sim")
                self.expect(AGREED, *command[1:])
                self.assertEqual((folder / "step.txt").read_bytes(), kept)

    def test_the_cores_of_several_folders_are_told_apart(self):
        for name in ("scenarios", "golden"):
            shutil.copytree(self.folder / name, self.folder / "other" / name)
        self.altered("gravity_stronger", "scenarios", "--reason", "x", "--accept", "contacts", command=("bless",), exit_code=AGREED)
        document = self.altered("gravity_stronger", "--json", "scenarios", "other/scenarios").json
        self.assertEqual([(core["golden"], core["status"]) for core in document["cores"]],
                         [("golden", "accepted"), ("other/golden", "changed")])
        group, = document["groups"]
        self.assertEqual((group["detail"], len(group["scenarios"])), ("GRAVITY 1200 -> 1250", 3))
        for arguments in ((), ("--core",)):
            outcome = self.altered("gravity_stronger", "scenarios", "other/scenarios", *arguments,
                                   exit_code=AGREED if arguments else DISAGREED)
            self.assertIn("core of other/golden: changed\n", outcome.out)
        self.assertIn("core of golden: the accepted one\n", outcome.out)

    def test_walls_of_which_one_step_tells_and_the_other_does_not_are_compared_by_rows(self):
        self.write("scenarios/edge.json", (SOURCE / "scenarios/flings/window-edge-dragged.json").read_text())
        self.write("scenarios/hour.json", (SOURCE / "scenarios/clocks/hour-at-60-hz.json").read_text())
        self.bless("scenarios")
        for path in ("scenarios/edge.json", "scenarios/hour.json"):
            self.altered("position_before_velocity", path, "-o", "now.h5", command=("run",))
            entry, = self.altered("position_before_velocity", path, "--json").json["results"]
            diff = self.expect(DISAGREED, "diff", path.replace("scenarios", "golden").replace("json", "h5"), "now.h5", "--json").json
            moved = sum(diff["contacts"].values())
            self.assertGreater(moved, 0)
            self.assertEqual((entry["class"], entry["contacts_moved"]), ("contacts", moved), path)
        self.altered("position_before_velocity", "scenarios/edge.json", "-o", "now.h5", command=("run",))
        documents = []
        for every in (1, 7):
            self.expect(AGREED, "run", "scenarios/edge.json", "-o", "before.h5", "--set", f"/record/every={every}")
            documents.append(self.expect(DISAGREED, "diff", "before.h5", "now.h5", "--json").json)
        self.assertEqual(documents[0]["contacts"], documents[1]["contacts"])
        entry, = self.altered("clock_and_drag", "scenarios/edge.json", "--json").json["results"]
        self.altered("clock_and_drag", "scenarios/edge.json", "-o", "now.h5", command=("run",))
        diff = self.expect(DISAGREED, "diff", "golden/edge.h5", "now.h5", "--json").json
        self.assertEqual((entry["class"], entry["max_px"], entry["contacts_moved"]),
                         (diff["class"], diff["max_px"], sum(diff["contacts"].values())))

    def test_a_damaged_accepted_core_is_a_disagreement(self):
        (self.folder / "golden/core/step.txt").unlink()
        self.assertIn("core: golden/core/step.txt: is missing; take the folder from version control, or accept this program's core: "
                      "hyrax-sim bless --core --reason \"...\"\n", self.expect(DISAGREED, "check").out)
        self.expect(AGREED, "bless", "--core", "--reason", "again")
        self.expect(AGREED, "check")
        self.assertEqual(self.expect(AGREED, "bless", "--core", "--reason", "again").out, "core: accepted already\n")
        for other in (("--filter", "a"), ("--list",), ("--last-failed",), ("--junit", "a.xml"), ("--annotate", "github"), ("--summary", "a.md"), ("--report", "a.html")):
            self.expect(BAD_INPUT, "check", "--core", *other, says="--core: not with ")
        self.assertEqual(self.expect(AGREED, "check", "scenarios/a", "--core").out, "core: the accepted one\n")
        self.assertEqual(self.expect(AGREED, "check", "--core").out, "core: the accepted one\n")

    def test_a_run_that_becomes_non_finite_does_not_agree_with_its_own_hash(self):
        run_of_it, = self.altered("bounce_explodes", self.write("x.json", fling()), "--json", command=("run",)).json["runs"]
        self.write("x.json", fling(expect={"state_hash": run_of_it["state_hash"]}))
        self.assertIn("x.json: disagreed: vx is infinite from step ", self.altered("bounce_explodes", "x.json").out)

    def test_a_core_is_accepted_with_a_library_that_agrees_only(self):
        before = self.state_of("golden/core")
        outcome = self.altered("gravity_stronger", command=("bless", "--core", "--reason", "x"))
        self.assertIn("core: not accepted in golden/core: 3 of 3 scenarios do not agree, the first is scenarios/a/first.json\n",
                      outcome.out)
        outcome = self.altered("gravity_stronger", "scenarios/third.json", "--reason", "x", "--accept", "contacts",
                               command=("bless",), exit_code=AGREED)
        self.assertIn("core: not accepted in golden/core: 2 of 3 scenarios do not agree", outcome.out)
        self.assertEqual(self.state_of("golden/core"), before)
        groups = self.altered("none", "--json").json["groups"]
        self.assertEqual({group["operation"] for group in groups}, {"unknown"})  # Another core's, put back.
        outcome = self.altered("gravity_stronger", "scenarios", "--reason", "x", "--accept", "contacts", command=("bless",),
                               exit_code=AGREED)
        self.assertIn("core: accepted in golden/core\n", outcome.out)
        self.altered("gravity_stronger", exit_code=AGREED)

    def test_the_golden_files_of_an_earlier_core_that_agreed_are_those_of_the_accepted_one(self):
        shutil.rmtree(self.folder / "golden")
        self.altered("ceiling_stops", "scenarios", "--reason", "x", command=("bless",), exit_code=AGREED)
        self.assertIn("3 of 3 scenarios differ; cause unknown: the accepted core cannot be played: altered for a test.\n",
                      self.altered("gravity_stronger").out)
        self.expect(AGREED, "bless", "--core", "--reason", "x")
        self.assertIn("3 of 3 scenarios differ: GRAVITY 1200 -> 1250; the accepted core gives all 3 golden files.",
                      self.altered("gravity_stronger").out)

    def accept(self, old, new):
        """Another core's accepted.txt, with its checksum."""
        accepted = self.folder / "golden/core/accepted.txt"
        text = accepted.read_text().partition("checksum: ")[0].replace(old, new)
        accepted.write_text(f"{text}checksum: {xxhash.xxh3_128_hexdigest(text.encode())}\n")

    def test_converted_line_ends_are_said(self):
        for path in (self.folder / "golden/core").iterdir():
            path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
        out = self.expect(DISAGREED, "check", "--core").out
        self.assertIn("golden/core/accepted.txt: its line ends were converted to CR LF; a line `golden/** -text` in .gitattributes keeps Git from it; ", out)

    def test_another_setter_that_no_scenario_calls_is_not_proved(self):
        path = self.folder / "golden/core/step.txt"
        kept = path.read_text()
        for setter, exit_code, says in (
                ("new_vy new_vx", AGREED,
                 "core: not proved equal to the accepted one: the constructor or a setter is another one, and no scenario shows it\n"),
                ("new_vx vy", DISAGREED, "core: golden/core/step.txt: is not the canonical text of a step; take the folder")):
            before, checksum = path.read_text(), 0xcbf29ce484222325
            text = kept.rpartition("checksum: ")[0].replace("= x y new_vx new_vy", f"= x y {setter}")
            for byte in text.encode():
                checksum = ((checksum ^ byte) * 0x100000001b3) % 2 ** 64
            path.write_text(f"{text}checksum: {checksum:016x}\n")
            self.accept(*(f"step: {xxhash.xxh3_128_hexdigest(each.encode())}" for each in (before, path.read_text())))
            for arguments in ((), ("--core",)):
                self.assertTrue(self.expect(exit_code, "check", *arguments).out.startswith(says), says)

    def test_an_accepted_core_of_another_class_is_replaced_by_accept_shape_only(self):
        self.accept("class: hyrax-physics/1", "class: box/1")
        why = "the accepted core is of another class (found box/1); "
        core, = self.expect(BAD_INPUT, "check", "--core", "--json").json["cores"]
        self.assertEqual((core["status"], core["why"]), ("not_proved", f"{why}this program's is hyrax-physics/1"))
        bless = ("bless", "--core", "--reason", "x", "--json", "--accept")
        for of_scenarios in ((), ("scenarios",)):
            command = [part for part in bless if part != "--core" or not of_scenarios]
            document = self.expect(DISAGREED, *command, "contacts", *of_scenarios,
                                   says=f"nothing written: golden/core: {why}--accept shape replaces it\n").json
            self.assertEqual((document["written"], document["cores"]),
                             (False, [{"golden": "golden", "accepted": False, "why_not": f"{why}--accept shape replaces it"}]))
        document = self.expect(AGREED, *bless, "shape").json
        self.assertEqual((document["written"], document["cores"]), (True, [{"golden": "golden", "accepted": True, "why_not": None}]))
        self.expect(AGREED, "check", "--core")

    def test_rows_that_the_changed_core_still_gives_are_compared(self):
        """Beyond the block with the ceiling the golden file's rows are played again, from its keyframes."""
        document = fling(name="third", window={"width_px": 1600, "height_px": 900}, duration_s=None, steps=6000,
                         start={"x_px": 700, "y_px": 300, "vx_px_per_s": 600, "vy_px_per_s": -900},
                         events=[{"step": 4500, "fling": {"vx_px_per_s": -4000, "vy_px_per_s": -900}}])
        self.write("scenarios/third.json", document)
        self.bless("scenarios")
        self.expect(AGREED, "run", "scenarios/third.json", "-o", "before.h5")
        self.altered("ceiling_stops", "scenarios/third.json", "-o", "after.h5", command=("run",))
        with h5py.File(self.folder / "before.h5") as before, h5py.File(self.folder / "after.h5") as after:
            apart_px = numpy.hypot(*(after[f"trajectory/{name}"][:] - before[f"trajectory/{name}"][:] for name in "xy"))
        self.assertGreater(apart_px[4097:].max(), apart_px[4096] + 1, "no distance is larger than a keyframe's")
        entry, = self.altered("ceiling_stops", "--json", "scenarios/third.json").json["results"]
        self.assertGreaterEqual(entry["max_px"], apart_px[4096:].max())
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            digests = file["blocks/digest"]
            digests[16:32] = 0  # No core gives the rows of the second block any more.
        self.assertIn("\n  first      step 4096, field state\n  the hash of the block of 4,096 rows from this step differs\n",
                      self.expect(DISAGREED, "check", "scenarios/third.json", "-v").out)


class Text(CauseTest):
    def test_other_results_of_a_model_suggest_a_new_number_for_it(self):
        """Not rounding, nor an edited scenario or golden file."""
        says, bless = "give the physics model a new number", ("bless", "scenarios", "--reason", "x", "--dry-run")
        self.assertNotIn(says, self.altered("gravity_by_one_ulp", command=bless, exit_code=AGREED).out)
        self.write("scenarios/third.json", fling(name="third", steps=301))
        with h5py.File(self.folder / "golden/a/first.h5", "r+") as file:
            file["trajectory/x"][100] += 0.5
        self.assertNotIn(says, self.altered("none", command=bless).out)
        for path in self.folder.glob("golden/**/*.h5"):  # Its number is a new one already.
            with h5py.File(path, "r+") as file:
                file.attrs["physics"] = "hyrax-physics/2"
        out = self.altered("gravity_stronger", "--accept", "shape", command=bless, exit_code=AGREED).out
        self.assertIn("1 of 3 scenarios differs: GRAVITY 1200 -> 1250; ", out)
        self.assertNotIn(says, out)

    def expecting(self, expect):
        """Gives the third scenario these expectations."""
        path = self.folder / "scenarios/third.json"
        path.write_text(json.dumps({**json.loads(path.read_text()), "expect": expect}))

    def test_the_suggested_bless_updates_the_hashes_that_keep_it_from_working(self):
        outcome = self.expect(AGREED, "run", "scenarios/third.json", "--json", "-o", "now.h5")
        self.expecting({"state_hash": outcome.json["runs"][0]["state_hash"]})
        command = re.search("  to accept it +(.*)", self.altered("gravity_by_one_ulp").out)[1]
        self.assertEqual(command, "hyrax-sim bless scenarios --reason \"...\" --update-expect")
        others = self.state_of("scenarios/a")
        self.altered("gravity_by_one_ulp", command=shlex.split(command)[1:], exit_code=AGREED)
        self.altered("gravity_by_one_ulp", exit_code=AGREED)
        self.assertEqual(self.state_of("scenarios/a"), others)

    def test_the_command_that_accepts_a_core_writes_only_what_differs(self):
        """No pair that agrees, no hash where none was; ranges keep their digits."""
        self.write("scenarios/calm.json", fling(name="calm", steps=5))
        x_px = self.expect(AGREED, "run", "scenarios/third.json", "--json", "-o", "x.h5").json["runs"][0]["final"]["x_px"]
        self.expecting({"final_x_px": [round(x_px) - 50, round(x_px) + 50], "finite": True})
        self.bless("scenarios")
        before = self.state_of(".")
        command = re.search("  to accept it +(.*)", self.altered("restitution_softer").out)[1]
        self.assertEqual(command, "hyrax-sim bless scenarios --reason \"...\" --accept contacts --update-expect")
        self.altered("restitution_softer", command=shlex.split(command)[1:], exit_code=AGREED)
        changed = {os.path.relpath(path, self.folder) for path, state in self.state_of(".").items() if state != before.get(path)}
        self.assertEqual(changed, {*(f"golden/{name}.{kind}" for name in ("a/first", "a/second", "third") for kind in ("h5", "txt")),
                                   *(f"golden/core/{name}" for name in ("physics.h", "step.txt", "accepted.txt")), "scenarios/third.json"})
        self.assertRegex((self.folder / "scenarios/third.json").read_text(), r'"expect": {"final_x_px": \[\d+, \d+\], "finite": true}')
        self.altered("restitution_softer", exit_code=AGREED)

    def test_the_widest_class_is_suggested_whichever_cause_it_is_of(self):
        self.write("scenarios/third.json", fling(name="third", events=[{"step": 0, "grab": {}}]))
        self.bless("scenarios/third.json", "--accept", "shape")
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            file["trajectory/x"][100] += 1e-9
        outcome = self.altered("gravity_stronger").out
        self.assertEqual(re.findall(r"\(class (\w+)\)", outcome), ["contacts", "rounding"])
        self.assertIn("  to accept it    hyrax-sim bless scenarios --reason \"...\" --accept contacts\n", outcome)
        self.assertEqual(outcome.count("hyrax-sim bless "), 1)
        of_each = re.findall("  to accept it    hyrax-sim bless scenarios/(.+) --reason \"...\"(.*)\n", self.altered("gravity_stronger", "--verbose").out)
        self.assertEqual(dict(of_each), {"a/first.json": " --accept contacts", "a/second.json": " --accept contacts", "third.json": ""})

    def test_a_missing_golden_file_does_not_hide_an_expectation(self):
        self.expecting({"contacts": {"right": 7}})
        (self.folder / "golden/third.h5").unlink()
        (self.folder / "golden/third.txt").unlink()
        self.assertRegex(self.expect(GOLDEN_MISSING, "check").out,
                         "scenarios/third.json: missing: .*third.h5.*; expect contacts/right: wanted 7, measured 1\n")
        for arguments, exit_code in ((("check", "--verbose"), GOLDEN_MISSING),
                                     (("run", "scenarios/third.json", "-o", "now.h5"), DISAGREED)):
            text = self.expect(exit_code, *arguments).out
            self.assertIn("golden/third.h5", text)
            self.assertNotIn("to create it", text)

    def test_a_quiet_dry_run_says_that_it_is_one(self):
        bless = ("bless", "scenarios", "--reason", "x", "--dry-run", "--prune")
        (self.folder / "scenarios/third.json").unlink()
        self.assertEqual(self.altered("gravity_stronger", "-q", command=bless).out, "dry run: nothing written\n")


class Documents(CauseTest):
    """JUnit XML, annotations, Markdown: their text is in outputs.md."""

    def test_a_summary_may_have_any_name(self):
        self.expect(AGREED, "check", "--summary", "step_summary_1f2e")  # As $GITHUB_STEP_SUMMARY is.
        self.assertEqual((self.folder / "step_summary_1f2e").read_text(),
                         "## hyrax-sim check: agreed\n\n3 checked: 3 agreed, 0 disagreed, 0 without golden file, 0 failed\n\n")

    def test_every_form_has_what_the_text_has(self):
        """Paragraphs in Markdown, entries in Markdown, annotations and JUnit."""
        self.write("scenarios/new.json", fling(name="new"))
        self.write("scenarios/bad.json", "{")
        outcome = self.altered("gravity_stronger", "--annotate", "github", "--summary", "check.md", "--junit", "check.xml", exit_code=BAD_INPUT)
        text, annotations = outcome.out.split("::error", 1)
        markdown, junit = (self.folder / "check.md").read_text(), (self.folder / "check.xml").read_text()
        for line in text.splitlines():
            self.assertIn(line, markdown)
        entries = re.findall("^- `(.*)`: (.*): `(.*)`$", markdown, re.MULTILINE)
        self.assertEqual({name for name, *_ in entries}, {f"scenarios/{name}.json" for name in ("a/first", "a/second", "third", "new", "bad")})
        for name, kind, sentence in entries:
            is_of_core = kind == "disagreed"
            place, subject = ("sim/physics/physics.h,line=" + re.search(r"\n  line (\d+)", text)[1], f"{name}: ") if is_of_core else (name, "")
            self.assertIn(f"file={place},title=hyrax-sim check%3A {kind}::{subject}{sentence}\n", annotations)
            self.assertIn(f'message="{kind}: {sentence}"'.replace(">", "&#62;"), junit.replace("&#34;...&#34;", '"..."'))

    def test_the_page_has_the_report_and_the_paths_of_diffs_picture(self):
        self.altered("gravity_stronger", "--report", "check.html")
        page = (self.folder / "check.html").read_text()
        self.assertIn("3 of 3 scenarios differ: GRAVITY 1200 -> 1250; the accepted core gives all 3 golden files.", page)
        name = re.search(r"<h2>scenarios/(.*)\.json</h2>", page)[1]
        self.altered("gravity_stronger", f"scenarios/{name}.json", "-o", "now.h5", command=("run",))
        self.expect(DISAGREED, "diff", f"golden/{name}.h5", "now.h5", "--figure", "diff.svg")
        checked, compared = (dict(re.findall(r'<g data-series="([^"]*)"><title>[^<]*</title>\n<path d="M(.*?)"', svg))
                             for svg in (page, (self.folder / "diff.svg").read_text()))

        def whole(paths, *names):
            """The paths' points, in parts of what both take: the picture of a page has another size."""
            points = [[float(number) for number in re.split("[ ,M]+", paths[name])] for name in names]
            return [(each - min(axis)) / (max(axis) - min(axis)) for at in (0, 1) for axis in [[*points[0][at::2], *points[1][at::2]]] for each in axis]

        both = whole(checked, "golden file", "this program"), whole(compared, f"{os.path.basename(name)}.h5", "now.h5")
        self.assertEqual(*map(len, both))
        self.assertLess(max(abs(a - b) for a, b in zip(*both)), 1e-3)
        self.assertNotEqual(checked["golden file"], checked["this program"])
        self.expect(BAD_INPUT, "check", "--report", "check.htm", says="--report: unknown suffix (found check.htm); allowed: .html")

    def test_hostile_names_stay_in_their_place(self):
        names = ("per%cent", "com,ma", "co:lon", "line\nbreak", "tick`s``", "<b>&\"", "::error file=x::y", "\x1b[31mred")
        for name in names:
            self.write(f"scenarios/{name}.json", "{")
        outcome = self.altered("none", "--annotate", "github", "--summary", "check.md", exit_code=BAD_INPUT)
        annotations = [line for line in outcome.out.splitlines() if line.startswith("::")]
        self.assertEqual(len(annotations), len(names))
        files = {re.match(r"::error file=([^:,]*),title=[^:,]*::", line)[1] for line in annotations}
        self.assertIn("scenarios/per%25cent.json", files)
        self.assertIn("scenarios/com%2Cma.json", files)
        self.assertIn("scenarios/co%3Alon.json", files)
        self.assertIn("scenarios/line%0Abreak.json", files)
        self.assertEqual([line for line in annotations if ".json: line 1, column " not in line], [])
        self.assertNotIn("\x1b", outcome.out)
        text = (self.folder / "check.md").read_text()
        self.assertNotIn("\x1b", text)
        self.assertIn("- ```scenarios/tick`s``.json```: failed", text)
        self.assertIn("- `scenarios/line\\u000abreak.json`: failed", text)
