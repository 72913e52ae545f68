#!/usr/bin/python3
"""`run` when something is wrong: the message, the exit code, and that no file is damaged."""

import shutil
import signal
import time

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, ProgramTest, fling, main


class BadInput(ProgramTest):
    """A scenario that cannot be read is exit 2 or 3, and nothing is written."""

    def refuse(self, content, *messages, exit_code=BAD_INPUT):
        """The program refuses the scenario with these messages and leaves an existing output alone."""
        self.write("bad.json", content)
        self.write("bad.h5", "what was there before")
        outcome = self.expect(exit_code, "run", "bad.json", "-o", "bad.h5", says=messages)
        self.assertEqual(outcome.out, "")
        self.assertEqual(self.names(), ["bad.h5", "bad.json"])
        self.assertEqual((self.folder / "bad.h5").read_text(), "what was there before")

    def test_all_errors_are_reported_at_once(self):
        self.refuse(fling(steps=-1, sprite={"width_px": 0, "height_px": 1}, name="No Name"), "bad.json: /steps: ",
                    "bad.json: /sprite/width_px: ", "bad.json: /name: ")

    def test_with_one_bad_scenario_the_others_still_run(self):
        self.write("1-good.json", fling(name="one"))
        self.write("2-bad.json", "{")
        self.write("3-unexpected.json", fling(name="three", expect={"final_x_px": [0, 1]}))
        outcome = self.expect(BAD_INPUT, "run", ".", "--json", "-o", "out", says="2-bad.json: line 1")
        one, two, three = outcome.json["runs"]
        self.assertEqual(self.names("out"), ["one.h5", "three.h5"])
        self.assertEqual((one["status"], three["status"]), ("played", "disagreed"))
        self.assertEqual(sorted(two), ["error", "scenario", "status"])
        self.assertEqual((two["scenario"], two["status"]), ("./2-bad.json", "failed"))
        self.assertIn("2-bad.json: line 1", two["error"])

    def test_the_most_serious_outcome_wins(self):
        self.write("good.json", fling(name="good"))
        self.write("unexpected.json", fling(name="unexpected", expect={"final_x_px": [0, 1]}))
        self.write("bad.json", "{")
        for exit_code, paths in ((AGREED, ["good.json"]), (DISAGREED, ["unexpected.json", "good.json"]),
                                 (BAD_INPUT, ["bad.json", "unexpected.json"]),
                                 (CANNOT_ACCESS, ["none.json", "bad.json", "good.json"])):
            self.expect(exit_code, "run", *paths, "-o", "out/")


class UnwritableOutput(ProgramTest):
    """An output that cannot be written is exit 3, and existing files are unchanged."""

    def setUp(self):
        super().setUp()
        self.scenario = self.write("fling.json", fling())

    def test_a_full_disk_leaves_the_old_file_and_no_part(self):
        done = self.in_private_mount("-o size=40k", "printf before > disk/fling.h5", "code=0",
                                     '"$1" run fling.json -o disk/fling.h5 --json || code=$?', "echo",
                                     "echo exit $code: $(cat disk/fling.h5): $(ls -A disk)")
        self.assertIn("exit 3: before: fling.h5\n", done.out, done.err)
        self.assertIn('"status": "failed"', done.out)
        self.assertIn("disk/fling.h5: cannot be written: No space left on device", done.err)

    def test_a_disk_that_fills_up_under_a_long_run_leaves_no_part(self):
        self.write("long.json", fling(steps=200_000, record={"every": 1}))
        done = self.in_private_mount("-o size=4m", "code=0", '"$1" run long.json -o disk/long.h5 || code=$?', "echo",
                                     "echo exit $code, left: $(ls -A disk)")
        self.assertIn("exit 3, left:\n", done.out, done.err)
        self.assertIn("disk/long.h5: cannot be written: its rows need 10.8 MiB (found 4.0 MiB free)", done.err)

    def test_a_missing_folder_is_exit_3(self):
        for option, path in (("-o", "no/such/run.h5"), ("--figure", "no/such/run.svg"), ("--report", "no/such/run.html")):
            outcome = self.expect(CANNOT_ACCESS, "run", self.scenario, option, path,
                                  says=f"{path}: cannot be written: No such file or directory\n")
            self.assertEqual((outcome.out, self.names()), ("", ["fling.json"]))

    def test_rows_that_do_not_fit_on_the_disk_are_refused_at_once(self):
        if shutil.disk_usage(self.folder).free >= 16e12:
            self.skipTest("this disk has room for the rows")
        self.write("endless.json", fling(steps=1_000_000_000_000))
        for name in ("out.h5", "out.csv"):
            self.expect(CANNOT_ACCESS, "run", "endless.json", "-o", name,
                        says=(f"{name}: cannot be written: its rows need ", "record fewer with /record/every"))
        self.assertEqual([name for name in self.names() if "out" in name], [])

    def test_a_killed_run_leaves_no_file_that_looks_finished(self):
        self.write("fling.h5", "what was there before")
        self.write("endless.json", fling(steps=1_000_000_000_000, record={"every": 1_000_000_000}))
        process = self.begin("run", "--no-skip", "endless.json", "-o", "fling.h5")
        while not any(name.endswith(".part") for name in self.names()):
            time.sleep(0.01)
        process.send(signal.SIGKILL)
        process.wait()
        self.assertEqual((self.folder / "fling.h5").read_text(), "what was there before")
        left = [name for name in self.names() if name not in ("fling.h5", "fling.json", "endless.json")]
        self.assertEqual(left, [".fling.h5.part"])
        self.expect(AGREED, "run", "fling.json")
        self.assertEqual(self.names(), ["endless.json", "fling.h5", "fling.json"])


if __name__ == "__main__":
    main()
