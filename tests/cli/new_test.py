"""new: a scenario to start from, and clocks from recorded frame times."""

import json
import os

import jsonschema

from program import AGREED, CANNOT_ACCESS, ProgramTest

PRESENTMON = ('"Application",ProcessID,MsBetweenPresents,PresentMode\r\n'
              "game.exe,42,16.6667,Hardware: Independent Flip\r\n"
              '"game.exe",42,33.25,"two\r\n""quoted"" lines"\r\n'
              "game.exe,42,0,\r\n")
SEVERAL = ("Application, ProcessID,SwapChainAddress,Dropped,msBetweenPresents\n"
           "game.exe,42,0xA,0,1\ngame.exe,42,0xB,0,2\ndwm.exe,7,0xC,0,4\ngame.exe,42,0xA,1,8\ngame.exe,43,0xA,0,16\n")


class New(ProgramTest):
    def scenario(self):
        """The file that was written, as a document."""
        return json.loads((self.folder / "my-fling.json").read_text())

    def assert_good(self):
        """It is valid by the reader and by the schema, its expectations hold."""
        jsonschema.validate(self.scenario(), json.loads(self.expect(AGREED, "schema").out))
        self.expect(AGREED, "run", "my-fling.json", "-o", "out/")

    def test_it_is_a_valid_scenario(self):
        outcome = self.expect(AGREED, "new", "my-fling")
        self.assertTrue(outcome.out.startswith("written: my-fling.json (600 steps)"), outcome)
        self.assertEqual([self.scenario()[key] for key in ("name", "clock", "steps", "events", "expect")], [
            "my-fling", {"rate_hz": 60}, 600, [{"step": 120, "fling": {"vx_px_per_s": -1500, "vy_px_per_s": -900}}], {"in_bounds": True, "finite": True}])
        self.assert_good()

    # --- recorded frame times as the clock

    def new(self, text, *options):
        """The clock made from a CSV file. `dropped`: how many of its frames were."""
        (self.folder / "frames.csv").write_bytes(text.encode())
        written = self.expect(AGREED, "new", "my-fling", "--clock-from", "frames.csv", *options, "--force", "--json").json
        scenario = self.scenario()
        self.dropped = written.pop("dropped", None)
        self.assertEqual(written, {"scenario": "my-fling.json", "steps": scenario["steps"]})
        self.assertEqual(scenario["steps"], len(scenario["clock"]["dt_s"]))
        return scenario["clock"]["dt_s"]

    def test_clocks_of_both_versions_of_presentmon_and_of_other_columns_and_units(self):
        dt_s, text = [16.6667 / 1000, 33.25 / 1000, 0], 'n,"dt, s"\n1,0.5\n2,"1e-3"\n'
        for recorded, options, found in (
                *((each, (), dt_s) for each in ("\ufeff" + PRESENTMON, PRESENTMON.replace("\r\n", "\n"), PRESENTMON.removesuffix("\r\n"),
                                                PRESENTMON + "\r\n\n")),
                (PRESENTMON, ("--unit", "s"), [16.6667, 33.25, 0]),
                *((f"n,{header}\n1,16\n", (), [0.016]) for header in (
                    "msBetweenPresents", "MsBetweenPresents", "FrameTime", "frametime", " Frame Time ")),
                *((f"{header}\n16\n", ("--column", header.lower()), [0.016]) for header in ("FrameTime", "MsBetweenPresents")),
                ("n,FrameTime\n1,16\n", ("--column", "N", "--unit", "s"), [1]), (text, ("--column", "dt, s", "--unit", "s"), [0.5, 0.001]),
                (text, ("--column", "n", "--unit", "ms"), [0.001, 0.002]), (PRESENTMON, (), dt_s)):
            self.assertEqual(self.new(recorded, *options), found, (recorded, options))
        self.assert_good()

    def test_one_of_several_sources_has_to_be_picked(self):
        for picked, dt_s, dropped in ((("--application", "DWM.exe"), [0.004], 0), (("--process", "43"), [0.016], 0), (
                ("--application", "game.exe", "--process", "42", "--swap-chain", "0xa"), [0.001, 0.008], 1)):
            self.assertEqual((self.new(SEVERAL, *picked), self.dropped), (dt_s, dropped))
        self.assertEqual((self.new("FrameTime,DisplayedTime\n5,5\n6,NA\n"), self.dropped), ([0.005, 0.006], 1))
        self.assertEqual((self.new("FrameTime\n5\n"), self.dropped), ([0.005], None))

    def test_no_file_and_a_pipe_are_not_waited_for(self):
        self.expect(CANNOT_ACCESS, "new", "my-fling", "--clock-from", "none.csv", says="none.csv: cannot be read")
        os.mkfifo(self.folder / "frames.csv")
        for arguments in (("new", "a", "--clock-from"), ("run",), ("validate",), ("sweep",)):
            self.expect(CANNOT_ACCESS, *arguments, "frames.csv", says="frames.csv: cannot be read: is a pipe or a device")

    def test_many_frames_keep_the_event_where_it_is(self):
        self.assertEqual(len(self.new("MsBetweenPresents\n" + "7\n" * 500)), 500)
        self.assert_good()
        self.assertEqual(self.scenario()["events"][0]["step"], 120)
