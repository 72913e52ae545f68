"""new: a scenario to start from, and clocks from recorded frame times."""

import json
import os

import jsonschema

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, SOURCE, ProgramTest

PRESENTMON = ('"Application",ProcessID,MsBetweenPresents,PresentMode\r\n'
              "game.exe,42,16.6667,Hardware: Independent Flip\r\n"
              '"game.exe",42,33.25,"two\r\n""quoted"" lines"\r\n'
              "game.exe,42,0,\r\n")
SEVERAL = ("Application, ProcessID,SwapChainAddress,Dropped,msBetweenPresents\n"
           "game.exe,42,0xA,0,1\ngame.exe,42,0xB,0,2\ndwm.exe,7,0xC,0,4\ngame.exe,42,0xA,1,8\ngame.exe,43,0xA,0,16\n")

# As the tools write them, with fewer columns and rows.
FRAME_TYPES = ("Application,ProcessID,SwapChainAddress,PresentMode,FrameType,CPUStartTime,FrameTime,DisplayedTime\n"
               "game.exe,42,0xA,Hardware: Independent Flip,Application,0.0000,16.5000,8.2000\n"
               "game.exe,42,0xA,Hardware: Independent Flip,Intel XeSS,0.0000,0.0000,8.3000\n"
               "game.exe,42,0xA,Hardware: Independent Flip,Application,16.5000,17.0000,NA\n"
               "game.exe,42,0xA,Hardware: Independent Flip,AMD_AFMF,16.5000,NA,NA\n"
               "game.exe,42,0xA,Hardware: Independent Flip,Application,33.5000,33.2500,16.6000\n")
PRESENTMON_2_3 = ("Application,ProcessID,SwapChainAddress,PresentRuntime,SyncInterval,TimeInMs,MsBetweenPresents,MsBetweenDisplayChange,"
                  "MsInPresentAPI,MsUntilDisplayed\n"
                  "game.exe,42,0xA,DXGI,1,0.0000,16.5000,16.6000,0.2000,21.3000\ngame.exe,42,0xA,DXGI,1,16.5000,17.0000,NA,0.2000,NA\n")
CAPFRAMEX = ("//GameName=game.exe\r\n//ProcessName=A \"game\"\r\n//CreationDate=2019-03-30\r\n//RecordTime=25\r\n"
             "Application,ProcessID,SwapChainAddress,Runtime,Dropped,TimeInSeconds,MsBetweenPresents,MsUntilDisplayed\r\n"
             "game.exe,42,0xA,DXGI,0,0.02,16.5,21.3\r\ngame.exe,42,0xA,DXGI,1,0.04,17,0\r\n")
OCAT = ("Application,ProcessID,SwapChainAddress,Runtime,Dropped,TimeInSeconds,MsBetweenPresents,MsUntilDisplayed,Motherboard,OS,GPU\n"
        "game.exe,42,0xA,DXGI,0,0.02,16.5,21.3,\"ASUS, PRIME\",Windows 10,RX 580\n"
        "game.exe,42,0xA,DXGI,1,0.04,17,0\ngame.exe,42,0xA,DXGI,0,0.07,33.25\n")
MANGOHUD = ("os,cpu,gpu,ram,kernel,driver,cpuscheduler\nArch Linux,AMD Ryzen 9 5950X,\"GeForce \"RTX\" 3080\",32771172,6.1,,performance\n"
            "fps,frametime,cpu_load,gpu_load,elapsed\n60.6,{},20,90,16500000\n58.8,{},20,90,33500000\n0,{},20,90,66750000\n")


class New(ProgramTest):
    def scenario(self):
        """The file that was written, as a document."""
        return json.loads((self.folder / "my-fling.json").read_text())

    def test_a_core_that_describes_itself_is_written_with_its_lines(self):
        written = self.expect(AGREED, "new", "--core", "pool_core.h").out
        self.assertEqual((self.folder / "pool_core.h").read_text(), (SOURCE / "tools/own_core/new_core.h.in").read_text())
        self.assertIn("\nhyrax_add_scenarios(scenarios CORE pool_core.h)\n", written)
        self.assertIn("`pool-sim new first`", written)
        self.expect(BAD_INPUT, "new", "--core", "pool_core.h", says="pool_core.h: exists; `--force` replaces it")
        self.expect(AGREED, "new", "--core", "pool_core.h", "--force")
        self.expect(BAD_INPUT, "new", "--core", "pool_core.json", says=".h")
        self.expect(BAD_INPUT, "new", "pool", "--core", "pool2_core.h", says="--core writes a header")
        self.assertFalse((self.folder / "pool2_core.h").exists())

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
        """The clock made from a CSV file. `dropped`, `left_out`: how many of its frames were; `doubt`: what is said of them."""
        (self.folder / "frames.csv").write_bytes(text.encode())
        outcome = self.expect(AGREED, "new", "my-fling", "--clock-from", "frames.csv", *options, "--force", "--json")
        written, self.doubt = outcome.json, outcome.err
        scenario = self.scenario()
        self.dropped, self.left_out = (written.pop(name, None) for name in ("dropped", "left_out"))
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

    def test_files_of_each_tool_are_read_as_it_writes_them(self):
        dt_s = [0.0165, 0.017, 0.03325]
        for recorded, found, dropped, left_out in (
                (FRAME_TYPES, dt_s, 1, 2), (PRESENTMON_2_3, dt_s[:2], 1, None), (CAPFRAMEX, dt_s[:2], 1, None), (OCAT, dt_s, 1, None),
                (MANGOHUD.format(16500, 17000, 33250), dt_s, None, None), (MANGOHUD.format(16.5, 17, 33.25), dt_s, None, None),
                (MANGOHUD.format(0.0165, 0.017, 0.03325), dt_s, None, None)):
            self.assertEqual((self.new(recorded), self.dropped, self.left_out, self.doubt), (found, dropped, left_out, ""), recorded)
        self.assertEqual(self.new(MANGOHUD.format(16.5, 17, 33.25), "--unit", "s"), [16.5, 17, 33.25])
        self.write("frames.csv", MANGOHUD.format(16500, 17000, 33250))
        said = self.expect(AGREED, "new", "my-fling", "--clock-from", "frames.csv", "--force").out
        self.assertIn("frame times in microseconds, as the column fps says\n", said)
        self.write("frames.csv", FRAME_TYPES)
        said = self.expect(AGREED, "new", "my-fling", "--clock-from", "frames.csv", "--force").out
        self.assertIn("2 rows left out: FrameType is not Application, as of generated frames\n", said)
        self.assert_good()

    def test_frames_of_seconds_or_of_microseconds_are_doubted(self):
        for times, unit, says in (("16500,17000,33250", "ms", "half of the frames take 17 s or more (read in ms)"), ("16.5,3,17", "s", "half of the frames take 16.5 s or more (read in s)"),
                                  ("0.0165,0.017,0.0165", "ms", "half of the frames take 1.65e-05 s or less (read in ms)")):
            self.new("FrameTime\n" + times.replace(",", "\n"), "--unit", unit)
            self.assertEqual(self.doubt, f"frames.csv: {says}; is that the column's unit? --unit s|ms sets it\n")
        self.new("FrameTime\n" + "16\n" * 3 + "5000\n" * 2)
        self.assertEqual(self.doubt, "")

    def test_what_is_saved_in_another_way_is_refused_with_its_cause(self):
        header, row = PRESENTMON_2_3.splitlines()[:2]
        for text, says in ((f"{header}\n{row}\n".replace(",", ";").replace(".0", ",0"), "line 1: its columns are separated by semicolons; save it with commas"),
                           (f"{header}\n{row}\n".replace(",", "\t"), "line 1: its columns are separated by tabs; save it with commas"),
                           (f"sep=;\n{header}\n{row}\n", "line 1: begins with sep=, as Excel writes it; save it with commas"),
                           (f"{header}\n{row.replace('16.5000', '16,5000')}\n", "line 2: must have 10 fields, as the header (found 11); a decimal comma separates fields, too"),
                           ('n,FrameTime\n1,"16,5"\n', "line 2, column 2 (FrameTime): must be a number 0 .. 1000000000000 (found 16,5); write a decimal point"),
                           ('// a\r\n// b\r\nn,FrameTime\r\n"1\r\n2",16\r\n1,x\r\n', "line 6, column 2 (FrameTime): must be a number"),
                           (f"{OCAT[:-3]}", "line 4: must have 11 fields, as the header (found 7)"),
                           (FRAME_TYPES.replace(",Application,", ",Repeated,"), "no frame of FrameType Application (left out: 5 others)"),
                           *((f"{header}\n{row}\n".encode(encoding), "is UTF-16; save it as UTF-8") for encoding in ("utf-16-le", "utf-16-be", "utf-16"))):
            (self.folder / "frames.csv").write_bytes(text if isinstance(text, bytes) else text.encode())
            self.expect(BAD_INPUT, "new", "my-fling", "--clock-from", "frames.csv", says=f"frames.csv: {says}")
        self.assertFalse((self.folder / "my-fling.json").exists())

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
