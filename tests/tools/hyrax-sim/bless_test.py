#!/usr/bin/python3
"""`bless`: the one way in which golden files change, on purpose and with a reason."""

import h5py

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, GOLDEN_MISSING, ProgramTest, fling, main

ANOTHER_START = {"x_px": 1000, "y_px": 500, "vx_px_per_s": 1200, "vy_px_per_s": -400}


class Bless(ProgramTest):
    """A project with two throws, and one without golden file."""

    def setUp(self):
        super().setUp()
        self.project("fling", "a/other")
        self.write("scenarios/new.json", fling(name="new"))
        self.before = self.state_of("golden")

    def assert_golden_untouched(self):
        """Not a byte and not a time stamp has changed."""
        self.assertEqual(self.state_of("golden"), self.before)

    def test_it_makes_a_golden_file_that_check_agrees_with(self):
        self.expect(GOLDEN_MISSING, "check")
        outcome = self.expect(AGREED, "bless", "scenarios/new.json", "--reason", "a first one")
        self.assertIn("scenarios/new.json: new golden file", outcome.out)
        self.assertIn("golden/new.h5", outcome.out)
        self.assertEqual(self.names("golden"), ["a", "fling.h5", "fling.txt", "new.h5", "new.txt"])
        self.expect(AGREED, "check")
        self.expect(AGREED, "check", "--quick")

    def test_the_digest_tells_the_run_and_the_reason(self):
        self.expect(AGREED, "bless", "scenarios/new.json", "--reason", "because of the\ntest")
        text = (self.folder / "golden/new.txt").read_text()
        run = self.expect(AGREED, "run", "scenarios/new.json", "--json").json["runs"][0]
        for words in ("scenario: new\n", "physics: hyrax-physics/1\n", "steps: 300\n",
                      f"state hash: {run['state_hash']}\n", "contacts: left 0, right 1, top 0, ground 8\n",
                      "  36 right\n", "  223 .. 300 ground\n", "  y  952 px  0x1.dcp+9\n", "at rest since: 4 s\n",
                      "reason: because of the test\n"):
            self.assertIn(words, text)
        with h5py.File(self.folder / "golden/new.h5") as file:
            self.assertEqual(file.attrs["state_hash"], run["state_hash"])

    def test_it_refuses_without_a_reason(self):
        for arguments in ((), ("--reason", ""), ("--reason", " \t\n ")):
            outcome = self.expect(BAD_INPUT, "bless", "scenarios/new.json", *arguments, says="--reason")
            self.assertEqual(outcome.out, "")
        self.assert_golden_untouched()

    def test_it_shows_what_changes(self):
        self.write("scenarios/fling.json", fling(start=ANOTHER_START))
        outcome = self.expect(AGREED, "bless", "scenarios/fling.json", "--reason", "further left")
        for words in ("scenarios/fling.json: changes golden/fling.h5", "class      shape", "first      step 0, field x",
                      "expected   1100 ", "actual     1000 ", "moved      right step 36"):
            self.assertIn(words, outcome.out)
        self.expect(AGREED, "check", "scenarios/fling.json")

    def test_it_refuses_a_run_whose_expectations_do_not_hold(self):
        self.write("scenarios/fling.json", fling(start=ANOTHER_START, expect={"final_x_px": [0, 1], "finite": True}))
        self.expect(DISAGREED, "bless", "scenarios/fling.json", "--reason", "wishful",
                    says=("scenarios/fling.json: not blessed", "final_x_px: wanted 0 .. 1, measured "))
        self.write("scenarios/new.json", fling(name="new", expect={"contacts": {"top": 1}}))
        self.expect(DISAGREED, "bless", "scenarios/new.json", "--reason", "wishful", says="contacts/top")
        self.assert_golden_untouched()

    def test_what_agrees_already_is_left_as_it_is(self):
        outcome = self.expect(AGREED, "bless", "scenarios/fling.json", "scenarios/a", "--reason", "once more")
        self.assertEqual(outcome.out.count("agrees with golden/"), 2)
        self.assert_golden_untouched()

    def test_it_takes_folders_and_goes_on_after_a_bad_one(self):
        self.write("scenarios/a/bad.json", "{")
        outcome = self.expect(BAD_INPUT, "bless", "scenarios", "--reason", "all", says="scenarios/a/bad.json: line 1")
        self.assertIn("scenarios/new.json: blessed", outcome.out)
        self.assertNotIn("bad.h5", self.names("golden/a"))

    def test_a_scenario_with_no_place_for_a_golden_file_is_refused(self):
        self.write("alone.json", fling(name="alone"))
        self.expect(BAD_INPUT, "bless", "alone.json", "--reason", "x", says="--golden DIR")
        self.expect(AGREED, "bless", "alone.json", "--reason", "x", "--golden", "some/where")
        self.assertEqual(self.names("some/where"), ["alone.h5", "alone.txt"])
        self.expect(AGREED, "check", "alone.json", "--golden", "some/where")

    def test_it_repairs_a_damaged_golden_file(self):
        whole = (self.folder / "golden/fling.h5").read_bytes()
        (self.folder / "golden/fling.h5").write_text("damaged")
        outcome = self.expect(AGREED, "bless", "scenarios/fling.json", "--reason", "repaired")
        self.assertIn("replaces a golden file that cannot be read", outcome.out)
        self.assertEqual((self.folder / "golden/fling.h5").read_bytes(), whole)

    def test_it_repairs_a_damaged_digest(self):
        text = (self.folder / "golden/fling.txt").read_text()
        for damaged in ("nothing\n", text.replace("state hash: ", "state hash: 0"),
                        text.replace(text.split("state hash: ")[1][:32], 32 * "0"), None):
            if damaged is None:
                (self.folder / "golden/fling.txt").unlink()
            else:
                self.write("golden/fling.txt", damaged)
            self.expect(AGREED, "bless", "scenarios/fling.json", "--reason", "for the test")
            self.assertEqual((self.folder / "golden/fling.txt").read_text(), text)

    def test_the_same_run_gives_the_same_bytes(self):
        self.expect(AGREED, "bless", "scenarios/new.json", "--reason", "x")
        self.expect(AGREED, "bless", "scenarios/new.json", "--reason", "x", "--golden", "again")
        for name in ("new.h5", "new.txt"):
            self.assertEqual((self.folder / "golden" / name).read_bytes(), (self.folder / "again" / name).read_bytes())

    def test_what_cannot_be_written_is_exit_3_and_leaves_no_part(self):
        (self.folder / "golden/new.txt").mkdir()
        self.expect(CANNOT_ACCESS, "bless", "scenarios/new.json", "--reason", "x", says="golden/new.txt")
        self.assertEqual(self.names("golden"), ["a", "fling.h5", "fling.txt", "new.txt"])
        self.write("file", "in the way")
        self.expect(CANNOT_ACCESS, "bless", "scenarios/new.json", "--reason", "x", "--golden", "file")

    def test_a_long_run_keeps_blocks_and_stays_small(self):
        self.write("scenarios/soak.json", fling(name="soak", steps=1_000_000))
        self.expect(AGREED, "bless", "scenarios/soak.json", "--reason", "x")
        with h5py.File(self.folder / "golden/soak.h5") as file:
            self.assertIn("blocks", file)
        self.assertLess((self.folder / "golden/soak.h5").stat().st_size, 500_000)
        self.expect(AGREED, "check", "scenarios/soak.json")


if __name__ == "__main__":
    main()
