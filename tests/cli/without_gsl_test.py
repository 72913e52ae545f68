"""Commands that never call GSL: run, check, bless and the closed form, in a program whose solver is a trap."""

import os
import pathlib
import shutil

from program import AGREED, SOURCE, ProgramTest

ENTERED = 99

# The two bound errors against the reference.
MEASURED = ["scenarios/paper/first-order-060-hz.json", "scenarios/paper/first-order-120-hz.json"]


class WithoutGsl(ProgramTest):
    program = pathlib.Path(os.environ["HYRAX_SIM_WITHOUT_GSL"]).resolve()

    def setUp(self):
        super().setUp()
        for folder in ("scenarios", "golden"):
            shutil.copytree(SOURCE / folder, self.folder / folder)

    def test_check_plays_all_of_them(self):
        self.expect(AGREED, "check")

    def test_errors_and_margins_are_measured_by_the_closed_form(self):
        self.expect(AGREED, "run", "scenarios/flings", "scenarios/paper", "-o", "out/")
        for run in self.expect(AGREED, "run", *MEASURED, "--json").json["runs"]:
            self.assertIn("truncation_px_max", [verdict["rule"] for verdict in run["expect"]])
        self.expect(AGREED, "run", MEASURED[0], "--drift", "--rows")
        self.expect(AGREED, "bless", *MEASURED, "--golden", "new", "--reason", "for the test")
        self.expect(AGREED, "drift", *MEASURED, "--reference", "closed")

    def test_control_the_trap_is_where_gsl_is_entered(self):
        self.expect(ENTERED, "drift", MEASURED[0], says="entered GSL")
        self.expect(ENTERED, "run", MEASURED[0], "--drift", "--reference", "gsl", says="entered GSL")
