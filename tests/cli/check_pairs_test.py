#!/usr/bin/python3
"""`check` of changed golden pairs: one verdict by every command, and no fault hidden by a summary."""

import h5py
import xxhash

from check_program import CheckTest, nudge
from program import AGREED, DISAGREED, fling, main


class OneVerdict(CheckTest):
    """`check`, `check --quick` and `run` give the same verdict on every changed golden pair."""

    START = {"x_px": 1100, "y_px": 500, "vx_px_per_s": 1180, "vy_px_per_s": -400}

    def setUp(self):
        super().setUp()
        self.h5, self.txt = (self.folder / f"golden/third.{suffix}" for suffix in ("h5", "txt"))
        self.pair = self.h5.read_bytes(), self.txt.read_bytes()

    def scenario(self, **changes):
        """The scenario of the pair, changed."""
        self.write("scenarios/third.json", fling(**{"name": "third", "start": self.START, **changes}))

    def bless_as(self, **changes):
        """The pair is that of a changed scenario."""
        self.scenario(**changes)
        self.bless("scenarios/third.json")
        self.scenario()

    def verdicts(self):
        """Statuses and classes by the three commands; their exit codes must match them."""
        found = []
        for arguments in (("check",), ("check", "--quick")):
            outcome = self.hyrax_sim(*arguments, "--json", "scenarios/third.json")
            entry, = outcome.json["results"]
            self.assertEqual(outcome.exit_code, {"agreed": 0, "disagreed": 1, "missing": 4}[entry["status"]])
            found.append((entry["status"], entry["class"]))
        outcome = self.hyrax_sim("run", "scenarios/third.json", "--json", "-o", "now.h5")
        golden = outcome.json["runs"][0]["golden"]
        self.assertEqual(outcome.exit_code, int(golden["status"] == "disagreed"))
        return [*found, (golden["status"], golden.get("class"))]

    def assert_all_say(self, status, kind, change, *arguments, **changes):
        """After a change of the pair all three have this verdict; the pair is restored."""
        change(*arguments, **changes)
        self.assertEqual(self.verdicts(), 3 * [(status, kind)], f"{change.__name__} {arguments} {changes}")
        self.h5.write_bytes(self.pair[0])
        self.txt.write_bytes(self.pair[1])
        self.scenario()

    def edit_summary(self, old, new):
        """Changes the text of the summary."""
        text = self.txt.read_text()
        self.assertIn(old, text)
        self.txt.write_text(text.replace(old, new))

    def edit_h5(self, path, name, value):
        """Changes an attribute."""
        with h5py.File(self.h5, "r+") as file:
            file[path].attrs[name] = value

    def nudge_under_checksum(self, dataset, row):
        """The pair as a program would have blessed it that differs in one value, and has the same state hash."""
        nudge(self.h5, dataset, row)
        checksums = f"checksums: {32 * 'c'} {xxhash.xxh3_128_hexdigest(self.h5.read_bytes())}\n"
        self.txt.write_text(self.txt.read_text().partition("checksums: ")[0] + checksums)

    def test_on_the_golden_file_of_another_scenario(self):
        for changes in ({"record": {"every": 2}}, {"steps": None, "duration_s": 5}, {"clock": {"dt_s": 1 / 60}},
                        {"start": {**self.START, "y_px": 500.0000000001}}, {"steps": 299},
                        {"events": [{"step": 299, "hitch": {"dt_s": 1 / 60}}]}):
            self.assert_all_say("disagreed", "shape", self.bless_as, **changes)

    def test_on_that_of_a_scenario_that_is_the_same(self):
        for changes in ({}, {"name": "another"}, {"description": "another text"}, {"expect": {"finite": True}},
                        {"$schema": "schema.json"}, {"start": {**self.START, "x_px": 1100.0}}):
            self.assert_all_say("agreed", None, self.bless_as, **changes)

    def test_on_a_run_that_is_the_same_for_a_zero_of_either_sign(self):
        self.START = {**self.START, "vx_px_per_s": 0}
        clock = {"rate_hz": 60, "jitter": {"kind": "normal", "sigma_s": 0, "seed": 1}}
        self.scenario(clock=clock)
        self.bless("scenarios/third.json")
        clock["jitter"]["sigma_s"] = -0.0
        self.scenario(clock=clock)
        self.assertEqual(self.verdicts(), 3 * [("agreed", None)])

    def test_on_what_only_contacts_show(self):
        self.assert_all_say("disagreed", "rounding", self.nudge_under_checksum, "contacts/overshoot", 0)

    def test_on_what_only_times_show(self):
        self.assert_all_say("disagreed", "rounding", self.nudge_under_checksum, "trajectory/t", 7)

    def test_on_a_changed_summary(self):
        for old, new in (("steps: 300", "steps: 301"), ("scenario: third", "scenario: thirD"), ("ground 8\n", "ground 7\n"),
                         ("margin: any", "margin: ani"), ("nearest decision: right", "nearest decision: left"),
                         ("checksums: ", "checksums:  "), ("state hash: ", "state hash: 0"), ("reason: for", "reason for")):
            self.assert_all_say("disagreed", "shape", self.edit_summary, old, new)
        self.assert_all_say("disagreed", "shape", self.txt.write_text, "nothing\n")

    def test_on_fields_that_may_change(self):
        self.assert_all_say("agreed", None, self.edit_summary, "reason: for the test", "reason: for another test")
        self.assert_all_say("agreed", None, self.edit_h5, "provenance", "compiler", "another")

    def test_on_half_a_pair(self):
        self.assert_all_say("missing", None, self.h5.unlink)
        self.assert_all_say("missing", None, self.txt.unlink)

    def test_quick_reports_a_difference_in_full(self):
        self.scenario(steps=301)
        self.assertEqual(self.check(DISAGREED, "--quick"), self.check(DISAGREED))

    def test_quick_judges_expectations(self):
        self.scenario(expect={"contacts": {"right": 2}})
        self.assertEqual(self.check(DISAGREED, "--quick"), self.check(DISAGREED))


class Seal(CheckTest):
    """A summary's checksums make reading the golden file unnecessary, and must never hide a fault in it."""

    def setUp(self):
        super().setUp()
        self.digest = self.folder / "golden/third.txt"
        self.text = self.digest.read_text()
        self.contents, self.file = self.text.splitlines()[-1].split()[1:]

    def test_a_damaged_file_is_found_under_valid_checksums(self):
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        first = self.check(DISAGREED)["results"][2]["first_divergence"]
        self.assertEqual((first["step"], first["field"]), (5, "y"))
        said = self.expect(DISAGREED, "check").out
        self.assertIn(": the golden file was changed since it was blessed.\n", said)
        self.assertIn("  to restore it   take golden/third.h5 from version control\n", said)

    def assert_not_as_blessed(self, text):
        """With this digest and an agreeing golden file, `check` names the digest; blessing repairs it."""
        self.digest.write_text(text)
        entry = self.check(DISAGREED)["results"][2]
        self.assertEqual((entry["class"], entry["first_divergence"]), ("shape", None))
        said = self.expect(DISAGREED, "check").out
        self.assertIn("since it was blessed: golden/third.txt: its checksums ", said)
        self.bless("scenarios/third.json")
        self.check(AGREED)

    def test_broken_checksums_disagree(self):
        for text in (self.text.replace("checksums: ", "checksum: "), self.text[:-1],
                     self.text.replace(self.contents, 32 * "0"), self.text.replace(self.file, 32 * "z")):
            self.assert_not_as_blessed(text)
        self.assert_not_as_blessed(self.text + "\n")

    def change(self, place, name, value):
        """Changes an attribute of the golden file."""
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            file[place].attrs[name] = value

    def test_another_provenance_is_reported_and_agrees(self):
        self.change("provenance", "compiler", "another")
        self.expect(AGREED, "check", says="golden/third.h5: agrees, but does not have the checksum in "
                    "golden/third.txt: its provenance or its layout differs\n")

    def test_missing_texts_disagree(self):
        for place, name in (("/", "name"), ("/", "constants"), ("trajectory/x", "units"), ("contacts/t", "long_name"),
                            ("trajectory", "signal"), ("trajectory/y", "DIMENSION_LIST")):
            with h5py.File(self.folder / "golden/third.h5", "r+") as file:
                del file[place].attrs[name]
            said = self.expect(DISAGREED, "check").out
            self.assertRegex(said, f"golden/third.h5: lacks .*@{name}.*, which bless writes; restore it")
            self.bless("scenarios/third.json")
            self.check(AGREED)

    def test_a_file_of_an_earlier_version_may_have_fewer_attributes(self):
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            del file["trajectory/x"].attrs["units"]
        found = xxhash.xxh3_128_hexdigest((self.folder / "golden/third.h5").read_bytes())
        self.digest.write_text(self.text.replace(self.file, found))
        self.check(AGREED)

    def test_changed_texts_disagree(self):
        for place, name, value in (("trajectory/x", "units", "m"), ("contacts/t", "long_name", "time"),
                                   ("trajectory", "signal", "x"), ("trajectory/y", "scale", "1")):
            self.change(place, name, value)
            said = self.expect(DISAGREED, "check").out
            self.assertIn(f"/{place}@{name}", said)
            self.bless("scenarios/third.json")
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            file["more"] = 1
        self.assertIn("/more", self.expect(DISAGREED, "check").out)


if __name__ == "__main__":
    main()
