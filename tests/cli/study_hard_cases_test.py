#!/usr/bin/python3
"""`study hard-cases`: the cases it judges, its output, and its exit codes."""

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, SOURCE, ProgramTest, fling, main

HARD = SOURCE / "scenarios/hard"
CALM = fling(name="calm", steps=900)


class HardCases(ProgramTest):
    """The study, on scenarios of the project and on the user's own."""

    def study(self, exit_code, *arguments, **options):
        """Runs the study without figures; its output goes into out/."""
        return self.expect(exit_code, "study", "hard-cases", "--quick", "--no-figures", "-o", "out", *arguments, **options)

    def test_a_scenario_of_the_users_own_is_a_case(self):
        document = self.study(AGREED, self.write("calm.json", CALM), "--gate", "--json").json
        self.assertEqual([case["case"] for case in document["cases"]], ["calm"])
        self.assertEqual(document["cases"][0]["invariants"]["mirror"]["verdict"], "held")
        self.assertEqual(document["broken"], [])

    def test_a_failed_expectation_breaks_it_and_only_the_gate_changes_the_exit_code(self):
        self.write("calm.json", {**CALM, "expect": {"final_y_px": [0, 1]}})
        self.study(AGREED, "calm.json")
        self.study(DISAGREED, "calm.json", "--gate", says="calm: expectations: final_y_px: wanted 0 .. 1")

    def test_long_cases_are_left_out_of_the_quick_study(self):
        document = self.study(AGREED, HARD / "a-fling-a-minute.json", "--json").json
        names = [case["case"] for case in document["cases"]]
        self.assertEqual(names, ["a-fling-a-minute", "a-fling-a-minute/an-hour"])
        self.study(BAD_INPUT, HARD / "ten-million-steps.json", says="no case is left with --quick")

    def test_bad_input_is_reported(self):
        self.study(CANNOT_ACCESS, says="scenarios/hard")
        self.study(BAD_INPUT, self.write("bad.json", fling(steps=-1)), says="/steps")
        self.write("one/calm.json", CALM)
        self.write("two/calm.json", CALM)
        self.study(BAD_INPUT, "one/calm.json", "two/calm.json", says="two/calm.json: /name: duplicate scenario name (found calm)")
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    main()
