"""The command report, and run --report, in a program that was built without the page: usage, inputs, outputs.

The numbers in the page are those of the file. What the page shows is tested in a browser: tests/browser.
"""

import base64
import json
import os
import pathlib
import re
import shlex
import shutil
import struct

import h5py

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, ProgramTest, fling, needs_page
from sweep_members import base
from sweep_program import document


class ReportTest(ProgramTest):
    """A run, and what cannot be reported of it."""

    program = pathlib.Path(os.environ["HYRAX_SIM_WITHOUT_PAGE"]).resolve()

    def setUp(self):
        super().setUp()
        self.write("fling.json", fling())
        self.expect(AGREED, "run", "fling.json")

    def test_refused_it_says_why_in_one_sentence_and_writes_nothing(self):
        self.write("text.h5", "text")
        before = self.state_of(".")
        for exit_code, says, *arguments in (
                (CANNOT_ACCESS, ("tools/run", "HYRAX_PAGE"), "report", "fling.h5", "-o", "fling.html"),
                (CANNOT_ACCESS, "HYRAX_PAGE", "run", "fling.json", "-o", "new.h5", "--report", "new.html"),
                (BAD_INPUT, "allowed: .html", "report", "fling.h5", "-o", "fling.txt"),
                (BAD_INPUT, "allowed: .html", "run", "fling.json", "-o", "a.h5", "--report", "a.htm"),
                (BAD_INPUT, "text.h5: is not an HDF5 file", "report", "text.h5", "-o", "a.html"),
                (BAD_INPUT, "text.h5: is not an HDF5 file", "report", "fling.h5", "--against", "text.h5", "-o", "a.html"),
                (CANNOT_ACCESS, "none.h5: cannot be read", "report", "none.h5", "-o", "a.html")):
            self.assertEqual(self.expect(exit_code, *arguments, says=says).err.count("\n"), 1, arguments)
            self.assertEqual(self.state_of("."), before, arguments)

    def test_refuses_studies_and_damaged_sweeps(self):
        self.expect(AGREED, "study", "frame-rate", "--quick", "--no-figures")
        self.expect(BAD_INPUT, "report", "frame-rate.h5", "-o", "a.html",
                    says="frame-rate.h5: is a file of a study; its page: hyrax-sim study NAME --report FILE.html\n")
        self.write("sweep.json", document(members=3))
        self.expect(AGREED, "sweep", "sweep.json")
        self.expect(CANNOT_ACCESS, "report", "sweep.h5", "-o", "a.html", says="HYRAX_PAGE")
        for other in ("fling.h5", "frame-rate.h5"):
            self.expect(BAD_INPUT, "report", "sweep.h5", other, "-o", "a.html", says=f"{other}: is not a sweep's file, as sweep.h5 is; ")
        for says, *arguments in (("--against: allowed for trajectories only (found sweep.h5)\n", "sweep.h5", "--against", "fling.h5"), ("frame-rate.h5: ", "fling.h5", "frame-rate.h5")):
            self.expect(BAD_INPUT, "report", *arguments, "-o", "a.html", says=says)
        whole = (self.folder / "sweep.h5").read_bytes()
        (self.folder / "sweep.h5").write_bytes(whole[:len(whole) // 2])
        self.expect(BAD_INPUT, "report", "sweep.h5", "-o", "a.html", says="sweep.h5")
        self.assertFalse((self.folder / "a.html").exists())

    def test_replaces_neither_input_nor_golden_file_nor_scenario(self):
        shutil.copy(self.folder / "fling.h5", self.folder / "page.html")
        (self.folder / "link.html").symlink_to("page.html")
        self.expect(BAD_INPUT, "report", "page.html", "-o", "page.html", says="would overwrite an input")
        self.expect(BAD_INPUT, "report", "fling.h5", "--against", "page.html", "-o", "link.html", says="would overwrite")
        self.project("a")
        before = self.state_of(".")
        self.expect(BAD_INPUT, "report", "fling.h5", "-o", "golden/a.html", says="golden")
        self.expect(BAD_INPUT, "run", "scenarios/a.json", "-o", "a.h5", "--report", "golden/a.html", says="golden")
        self.write("scenario.html", fling())
        self.expect(BAD_INPUT, "report", "fling.h5", "-o", "scenario.html", says="would overwrite a scenario")
        (self.folder / "scenario.html").unlink()
        self.assertEqual(self.state_of("."), before)


@needs_page
class Numbers(ProgramTest):
    """Columns in the page, by the program with it."""

    def page_by(self, *arguments, exit_code=AGREED):
        """The document in page.html, which the command writes."""
        out = self.expect(exit_code, *arguments).out
        self.assertIn({"report": "written: page.html", "run": "\n  written        page.html"}[arguments[0]], out)
        return json.loads(re.search('id="data">(.*?)</script>', (self.folder / "page.html").read_text(), re.DOTALL)[1])

    def test_are_those_of_the_file_bit_for_bit(self):
        for steps in (10, 11, 12):  # Of any length modulo three bytes.
            self.write("fling.json", fling(steps=steps))
            self.expect(AGREED, "run", "fling.json")
            page = self.page_by("report", "fling.h5", "--against", "fling.h5", "-o", "page.html")
            self.assertEqual(page["command"], "hyrax-sim report fling.h5 --against fling.h5 -o page.html")
            with h5py.File(self.folder / "fling.h5") as file:
                for name, text in page["runs"][0]["rows"].items():
                    wanted = file[f"trajectory/{name}"][:].astype("<f8").tobytes()
                    self.assertEqual(base64.b64decode(text, validate=True), wanted, name)
        self.assertEqual(self.expect(AGREED, "report", "fling.h5", "-o", "page.html", "--json").out, '{ "output": "page.html" }\n')

    def test_of_a_sweep_of_billions_a_sample_is_read(self):
        self.write("sweep.json", document(members=3, keep=["final"], vary={"/start/vx_px_per_s": {"choice": [0]}}))
        self.expect(AGREED, "sweep", "sweep.json")
        with h5py.File(self.folder / "sweep.h5", "a") as file:
            members = 3_000_000_000
            file.attrs["members"] = members
            file.attrs["sweep"] = file.attrs["sweep"].replace('"members": 3', f'"members": {members}')
            for name in [f"members/{each}" for each in file["members"]] + ["inputs/start.vx_px_per_s"]:
                del file[name]
                file.create_dataset(name, (members,), "<f8")
        self.assertNotEqual(self.hyrax_sim("report", "sweep.h5", "-o", "read.html").exit_code, BAD_INPUT)
        self.page_by("report", "sweep.h5", "-o", "page.html")
        self.assertRegex((self.folder / "page.html").read_text(), r"<p>All numbers are those of a sample: 1 of every [\d,]+ of 3,000,000,000 members\.</p>\n")

    def test_members_of_a_part_are_those_of_the_sweep(self):
        self.write("sweep.json", document(members=5, vary={"/start/vx_px_per_s": {"uniform": [900, 1100]}}, base=base(steps=600)))
        self.expect(AGREED, "sweep", "sweep.json", "--part", "1/2", "-o", "sweep.h5")
        sweep, = self.page_by("report", "sweep.part-1-of-2.h5", "-o", "page.html")["sweeps"]
        for sentence in ("Part 1 of 2 of the sweep: 2 members.", "2 of 2 members have settled by the end.", "The same in all members: y 952 px, vx 0 px/s (rounding), "
                         "vy -7.49531 px/s, contacts.left 0, contacts.right 1, contacts.top 0, contacts.ground 8."):
            self.assertIn(f"<p>{sentence}</p>\n", (self.folder / "page.html").read_text())
        with h5py.File(self.folder / "sweep.part-1-of-2.h5") as file:
            wanted = file["inputs/start.vx_px_per_s"][:].astype("<f8").tobytes()
        self.assertEqual(base64.b64decode(sweep["members"]), struct.pack("<2d", 1, 3))
        self.assertEqual(base64.b64decode(sweep["inputs"][0]["values"]), wanted)

    def test_the_command_in_the_page_writes_it_again(self):
        self.write("scenarios/fling.json", fling())
        self.expect(AGREED, "bless", "scenarios/fling.json", "--golden", "accepted", "--reason", "first")
        for options in (("--set", "/steps=20", "--set", "/clock/rate_hz=144"), ("--golden", "accepted")):
            page = self.page_by("run", "scenarios/fling.json", *options, "--report", "page.html")
            called, *arguments = shlex.split(page["command"])
            self.assertEqual(called, "hyrax-sim")
            self.assertEqual(self.page_by(*arguments), page)
        self.assertTrue(page["runs"][0]["golden"]["agrees"])
        self.assertIn("\n<p>Agrees with the golden file, bit for bit.</p>\n", (self.folder / "page.html").read_text())
