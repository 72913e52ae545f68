"""`run` when something is wrong: the message, the exit code, and that no file is damaged. Killed: killed_test.py."""

from program import BAD_INPUT, CANNOT_ACCESS, ProgramTest, fling


class BadInput(ProgramTest):
    """A scenario that cannot be read is exit 2 or 3, and nothing is written."""

    def test_all_errors_are_reported_and_an_existing_output_is_left_alone(self):
        self.write("bad.json", fling(steps=-1, sprite={"width_px": 0, "height_px": 1}, name="No Name"))
        self.write("bad.h5", "what was there before")
        outcome = self.expect(BAD_INPUT, "run", "bad.json", "-o", "bad.h5",
                              says=("bad.json: /steps: ", "bad.json: /sprite/width_px: ", "bad.json: /name: "))
        self.assertEqual((outcome.out, self.names()), ("", ["bad.h5", "bad.json"]))
        self.assertEqual((self.folder / "bad.h5").read_text(), "what was there before")

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


class UnwritableOutput(ProgramTest):
    """An output that cannot be written is exit 3, and existing files are unchanged."""

    def setUp(self):
        super().setUp()
        self.scenario = self.write("fling.json", fling())

    def test_rows_that_do_not_fit_on_the_disk_leave_no_part_and_are_refused_at_once_if_that_is_certain(self):
        self.write("long.json", fling(steps=200_000, record={"every": 1}))
        self.write("endless.json", fling(steps=1_000_000_000_000))
        done = self.in_private_mount("-o size=4m", "for name in long.csv long.h5 endless.csv; do code=0",
                                     '"$1" run ${name%.*}.json -o disk/$name || code=$?',
                                     "echo exit $code, left: $(ls -A disk); done")
        self.assertEqual(done.out, 3 * "exit 3, left:\n", done.err)
        for says in ("long.csv: cannot be written: No space left on device",
                     "long.h5: cannot be written: its rows need at least 10.8 MiB (found 4.0 MiB free); "
                     "record fewer with /record/every",
                     "endless.csv: cannot be written: its rows need at least "):
            self.assertIn(f"disk/{says}", done.err)

    def test_a_picture_that_cannot_be_written_is_a_failure_of_its_run(self):
        for command, option in (("run", "--figure"), ("drift", "--figures")):
            (self.folder / f"{command}.svg").mkdir()
            self.write(f"{command}.svg/file", "in the way")
            path = f"{command}.svg{'/file' if command == 'drift' else ''}"
            entry, = self.expect(CANNOT_ACCESS, command, self.scenario, option, path, "--json", says=f"{path}: cannot be ").json["runs"]
            self.assertEqual([(key, value) for key, value in entry.items() if key == "status"], [("status", "failed")])
            self.assertTrue(entry["error"].startswith(f"{path}: cannot be "), entry["error"])

    def test_a_missing_folder_is_exit_3(self):
        for option, path in (("-o", "no/such/run.h5"), ("--figure", "no/such/run.svg"), ("--report", "no/such/run.html")):
            outcome = self.expect(CANNOT_ACCESS, "run", self.scenario, option, path,
                                  says=f"{path}: cannot be written: No such file or directory\n")
            self.assertEqual((outcome.out, self.names()), ("", ["fling.json"]))
