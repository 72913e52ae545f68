"""How much is printed (--quiet, --verbose), colour and progress on a terminal, and scenarios on standard input."""

import json
import os

from program import AGREED, BAD_INPUT, DISAGREED, ProgramTest, fling

GREEN, RED = "\x1b[32m", "\x1b[31m"


class Detail(ProgramTest):
    """-q prints errors and verdicts only, -v more, and neither changes a document or an exit code."""

    def setUp(self):
        super().setUp()
        self.path, = self.project("fling")
        self.expect(AGREED, "run", self.path)

    def printed(self, *arguments):
        """What is printed by default, with -q and with -v."""
        return [self.expect(AGREED, *arguments, *option).out for option in ((), ("-q",), ("--verbose",))]

    def test_of_more_than_three_scenarios_a_line_each(self):
        names = [self.write(f"many/{name}.json", fling(name=name)) for name in "abcd"]
        self.assertEqual(self.expect(AGREED, "run", "many", "-o", "out/").out,
                         "".join(f"{name}: played; no golden file and no expect; written: out/{name}.h5\n" for name in "abcd"))
        for arguments in ((*names[:3],), ("many", "-v")):
            self.assertIn("  state hash ", self.expect(AGREED, "run", *arguments, "-o", "out/").out)

    def test_a_document_is_the_same_but_a_verbose_one_of_run_has_the_margin_too(self):
        normal, quiet, verbose = self.printed("diff", "fling.h5", "fling.h5", "--json")
        self.assertEqual((quiet, verbose), (normal, normal))
        normal, quiet, verbose = map(json.loads, self.printed("run", self.path, "--json"))
        margin = verbose["runs"][0].pop("margin")
        self.assertEqual((quiet, verbose), (normal, normal))
        drift = self.expect(AGREED, "drift", self.path, "--json").json["runs"][0]["margin"]
        self.assertEqual(margin, drift)


class Width(ProgramTest):
    """A table has the columns that the terminal has room for."""

    def test_a_narrow_terminal_shows_the_answer_and_the_columns_that_fit(self):
        study = "study", "frame-rate", self.write("own.json", fling(name="own")), "--quick", "--no-figures"
        plain = self.expect(AGREED, *study).out
        narrow, wide, verbose = (self.on_terminal("stdout", *study, *option, columns=columns)[1]
                                 for columns, option in ((40, ()), (400, ()), (40, ("--verbose",))))
        self.assertEqual((wide, verbose), (plain, plain))
        self.assertRegex(narrow, r"\AFrom the run at its own clock, 144 Hz is up to [\d.]+ px away, 240 Hz up to [\d.]+ px\.\n")
        self.assertLess(max(len(line) for line in narrow.splitlines() if line.startswith("  ")), 41)
        self.assertRegex(narrow, r"\n  \d+ more columns? with --verbose\n")


class Colour(ProgramTest):
    """Verdicts have a colour on a terminal."""

    def shown(self, *arguments, **variables):
        """What a terminal shows as standard output."""
        environment = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "TERM")}
        outcome, shown = self.on_terminal("stdout", *arguments, env={**environment, "TERM": "xterm", **variables})
        return outcome.exit_code, shown

    def test_only_the_verdict_has_it(self):
        path, = self.project("fling")
        plain = self.expect(AGREED, "run", path).out
        exit_code, shown = self.shown("run", path)
        self.assertEqual(exit_code, AGREED)
        self.assertEqual(shown, plain.replace("agrees bit", f"{GREEN}agrees\x1b[0m bit"))
        self.write(path, fling(start={"x_px": 1, "y_px": 2}))
        exit_code, shown = self.shown("check")
        self.assertEqual(exit_code, DISAGREED)
        self.assertTrue(shown.startswith(f"1 of 1 scenario {RED}differs\x1b[0m: "), shown)
        self.assertEqual(shown.count("\x1b"), 2)
        self.assertTrue(self.shown("check", "--verbose")[1].startswith(f"{path}: {RED}disagreed\x1b[0m\n"))

    def test_without_a_colour_terminal_there_is_none(self):
        path, = self.project("fling")
        plain = self.expect(AGREED, "run", path).out
        for variables in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            self.assertEqual(self.shown("run", path, **variables), (AGREED, plain))
        self.assertIn(GREEN, self.shown("run", path, NO_COLOR="")[1], "an empty NO_COLOR is not set")

    def test_a_path_cannot_add_it(self):
        path = self.write("a\x1b[31mb.json", fling())
        exit_code, shown = self.shown("validate", path)
        self.assertEqual((exit_code, shown), (AGREED, f"a\\u001b[31mb.json: {GREEN}good\x1b[0m, 300 steps\n"))


class Progress(ProgramTest):
    """Of runs long enough for it to cut them into pieces, and of a search."""

    def assert_same_when_watched(self, **scenario):
        """The same summary and the same file."""
        path = self.write("long.json", fling(**scenario))
        unwatched = self.expect(AGREED, "run", path, "-o", "run.h5", "--json").out
        rows = (self.folder / "run.h5").read_bytes()
        outcome, shown = self.on_terminal("stderr", "run", path, "-o", "run.h5", "--json")
        self.assertEqual((outcome.exit_code, outcome.out), (AGREED, unwatched), shown)
        self.assertEqual((self.folder / "run.h5").read_bytes(), rows)
        return unwatched

    def test_a_run_that_repeats_and_one_that_is_computed_are_the_same(self):
        out = self.assert_same_when_watched(steps=10**8, record={"every": 10**6})
        self.assertNotIn('"periodic_from_step": null', out)
        self.assert_same_when_watched(
            steps=300_000, record={"every": 1000}, events=[{"step": 70_000, "stop": {}}],
            clock={"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.5, "seed": 1}})

    def test_fuzz_shows_how_far_it_is(self):
        outcome, shown = self.on_terminal("stderr", "fuzz", "--time", "0.7s", "--json")
        self.assertEqual(outcome.exit_code, AGREED, outcome)
        self.assertRegex(shown, r"\d+ runs, [\d.e+]+ per second, 0 s left")


class StandardInput(ProgramTest):
    """`-` is a scenario on standard input."""

    def piped(self, exit_code, *arguments, document=fling()):
        """Runs the program with a document as its standard input."""
        read, write = os.pipe()
        self.addCleanup(os.close, read)
        os.write(write, json.dumps(document).encode())
        os.close(write)
        return self.expect(exit_code, *arguments, stdin=read)

    def test_a_run_is_that_of_the_file(self):
        self.expect(AGREED, "run", self.write("fling.json", fling()), "-o", "file.h5")
        outcome = self.piped(AGREED, "run", "-", "-o", "piped.h5", "--golden", "golden")
        self.assertEqual(outcome.err, "")
        self.assertIn("written        piped.h5 (301 rows)", outcome.out)
        self.assertIn("comparison with a golden file (standard input)", outcome.out)
        self.assertEqual((self.folder / "piped.h5").read_bytes(), (self.folder / "file.h5").read_bytes())

    def test_without_o_and_name_it_says_where_it_writes(self):
        outcome = self.piped(AGREED, "run", "-", "--set", "/steps=9", document=fling(name=None))
        self.assertIn("written        stdin.h5 (10 rows)", outcome.out)
        self.assertEqual(self.names(), ["stdin.h5"])

    def test_drift_measures_it(self):
        path = self.write("fling.json", fling())
        wanted = self.expect(AGREED, "drift", path, "--json").json["runs"][0]
        outcome = self.piped(AGREED, "drift", "-", "--json")
        run = outcome.json["runs"][0]
        self.assertEqual((run["scenario"], run["arcs"], outcome.err), ("-", wanted["arcs"], ""))

    def test_it_is_validated(self):
        self.assertEqual(self.piped(AGREED, "validate", "-").out, "-: good, 300 steps\n")
        for command in ("run", "drift", "validate"):
            err = self.piped(BAD_INPUT, command, "-", document=fling(steps=-1)).err
            self.assertTrue(err.startswith("-: /steps: "), err)

    def test_it_cannot_be_read_again_by_processes_that_measure_costs(self):
        self.assertEqual(self.piped(BAD_INPUT, "study", "needs", "-", "--quick", "--no-figures").err,
                         "-: processes that measure costs cannot read standard input again; name a scenario file\n")
        self.assertEqual(self.piped(AGREED, "study", "hard-cases", "-", "--no-figures", "-q").out, "hard-cases: all rules hold\n")

    def test_it_has_no_golden_file(self):
        for arguments in (("check", "-"), ("bless", "-", "--reason", "x", "--golden", "golden")):
            outcome = self.piped(BAD_INPUT, *arguments)
            self.assertIn("-: standard input has no golden file", outcome.out + outcome.err)
        self.assertEqual(self.names(), [])
