#!/usr/bin/python3
"""The command study: the files, output and errors of speed-error and needs."""

import h5py

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, SOURCE, ProgramTest, fling, main


class Needs(ProgramTest):
    """study needs. What the files of a study hold is in outputs.md."""

    def test_files_go_into_the_folder_that_is_named_and_are_named_in_the_end(self):
        self.write("fling.json", fling())
        study = ("study", "needs", "fling.json", "--quick", "--no-figures")
        self.assertIn("written: new/folder/needs.h5, new/folder/needs.csv", self.expect(AGREED, *study, "-o", "new/folder").out)
        self.assertEqual(self.names("new/folder"), ["needs.csv", "needs.h5"])
        with h5py.File(self.folder / "new/folder/needs.h5") as file:
            self.assertIn("hyrax-sim", file["provenance"].attrs["program"])
        document = self.expect(AGREED, *study, "--json").json
        self.assertEqual((document["study"], document["files"], document["broken"]), ("needs", ["needs.h5", "needs.csv"], []))

    def verdicts(self, *arguments):
        """{part: verdict} of one scene."""
        document = self.expect(AGREED, "study", "needs", *arguments, "--quick", "--no-figures", "--json").json
        return {part["part"]: part["verdict"] for part in document["scenes"][0]["parts"]}

    def test_what_counts_depends_on_the_tolerance(self):
        path = self.write("fling.json", fling())
        self.assertEqual(self.verdicts(path, "--within", "100000")["drag"], "below the tolerance")
        self.assertEqual(self.verdicts(path, "--within", "0.001 px")["drag"], "needed")

    def test_a_scene_without_exact_solution_says_so(self):
        path = SOURCE / "scenarios/hard/sprite-larger-than-window.json"
        self.assertIn("its window cannot hold its sprite",
                      self.expect(AGREED, "study", "needs", path, "--quick", "--no-figures").out)


class SpeedError(ProgramTest):
    def test_scenarios_are_studied_too_and_drawn(self):
        self.write("mine.json", fling(name="mine", events=[{"step": 100, "fling": {"vx_px_per_s": -900, "vy_px_per_s": -900}}]))
        document = self.expect(AGREED, "study", "speed-error", "mine.json", "--quick", "--json").json
        self.assertIn("mine", {answer["problem"] for answer in document["cheapest"]})
        self.assertEqual([name for name in self.names() if name.endswith(".svg")],
                         [f"speed-error{part}.svg" for part in ("-fling-starts", "-long-arc", "-mine-starts", "-mine", "")])
        text = (self.folder / "speed-error-long-arc.svg").read_text(encoding="utf-8")
        for part in ("Pareto front", "rk8pd", "cost, ns"):
            self.assertNotEqual(part in text, "not measured: clock unsteady" in text, part)

    def test_one_that_has_no_exact_solution_is_refused(self):
        self.write("large.json", fling(sprite={"width_px": 4000, "height_px": 128}))
        self.expect(BAD_INPUT, "study", "speed-error", "large.json", "--quick",
                    says="large.json: cannot be studied for speed against error: its window cannot hold its sprite")
        self.assertEqual(self.names(), ["large.json"])

    def test_a_name_that_is_taken_is_refused(self):
        self.write("mine.json", fling())
        self.expect(BAD_INPUT, "study", "speed-error", "mine.json", "--quick", says="must differ from the other problems' (found fling)")


class Usage(ProgramTest):
    """Bad usage is refused before anything is written."""

    def test_an_unknown_study_lists_the_known_ones(self):
        self.expect(BAD_INPUT, "study", "speed", says=("unknown study (found speed)", "speed-error", "needs"))
        self.expect(BAD_INPUT, "study", says="study")

    def test_options_without_use_are_refused(self):
        self.write("fling.json", fling())
        for arguments, words in ((("speed-error", "--within", "1px"), "speed-error: takes no --within"),
                                 (("speed-error", "--expect", "x.json"), "speed-error: takes no --expect"),
                                 (("needs",), "a scenario must be given"),
                                 (("needs", "fling.json", "--within", "1 mm"), "--within: must be a length of at least 0, "
                                                                               "as 1px (found '1 mm')"),
                                 (("needs", "fling.json", "--within=-1px"), "--within"),
                                 (("needs", "fling.json", "--within", "nan"), "--within"),
                                 (("needs", "fling.json", "fling.json"), "fling.json: /name: duplicate scenario name (found fling)")):
            self.expect(BAD_INPUT, "study", *arguments, says=words)
        self.assertEqual(self.names(), ["fling.json"])

    def test_bad_scenarios_leave_nothing_behind(self):
        self.write("bad.json", fling(steps=-1))
        self.expect(BAD_INPUT, "study", "needs", "bad.json", "-o", "out", says="bad.json: /steps")
        self.expect(CANNOT_ACCESS, "study", "needs", "none.json", says="none.json: cannot be read")
        self.assertEqual(self.names(), ["bad.json"])

    def test_a_folder_that_cannot_be_created_is_reported(self):
        self.write("fling.json", fling())
        self.expect(CANNOT_ACCESS, "study", "needs", "fling.json", "--quick", "--no-figures", "-o", "fling.json",
                    says="fling.json: ")

    def test_in_a_checkout_version_control_ignores_them(self):
        ignored = (SOURCE / ".gitignore").read_text(encoding="utf-8").split()
        for suffix in (".csv", ".h5", ".svg", ".html"):
            self.assertIn("/*" + suffix, ignored)


if __name__ == "__main__":
    main()
