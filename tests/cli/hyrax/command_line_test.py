"""The command line of hyrax.exe: its output, and the exit codes that a script can rely on."""

from hyrax_program import HYRAX, HYRAX_REPLAY, HyraxTest, read_log
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, fling

HASH_OF_FLING = "0" * 32  # Of another run.


class CommandLine(HyraxTest):
    """Command lines that show no window."""

    def expect_of_hyrax(self, exit_code, *arguments, says=""):
        """Runs the program to its end; its message is on stdout if it agreed, else on stderr."""
        done = self.wine.run(HYRAX, *arguments, cwd=self.folder)
        self.assertEqual(done.exit_code, exit_code, str(done))
        self.assertIn(says, done.out if exit_code == AGREED else done.err)
        # Wine reports crashes of its own programs on stderr; a crash of this one changes its exit code.
        of_hyrax = [line for line in done.err.splitlines() if not line.startswith("wine: ")]
        self.assertEqual(of_hyrax if exit_code == AGREED else done.out.splitlines(), [])

    def test_help_and_version(self):
        self.expect_of_hyrax(AGREED, "--help", says="hyrax --record my-fling.json")
        self.expect_of_hyrax(AGREED, "/?", says="hyrax --record my-fling.json")
        self.expect_of_hyrax(AGREED, "--version", says="hyrax ")

    def test_what_cannot_be_used_is_reported(self):
        self.expect_of_hyrax(BAD_INPUT, "--recrod", "x", says="(did you mean --record?); see `hyrax --help`")
        path = self.write("wrong.json", fling(steps=-1))
        self.expect_of_hyrax(BAD_INPUT, "--replay", path, "--exit", says="wrong.json: /steps")
        self.expect_of_hyrax(CANNOT_ACCESS, "--replay", "missing.json", "--exit", says="missing.json: cannot be read")
        self.expect_of_hyrax(CANNOT_ACCESS, "--replay", "missing.json", "--log", "new.log", says="missing.json: cannot be read")
        self.assertFalse((self.folder / "new.log").exists())
        self.expect_of_hyrax(CANNOT_ACCESS, "--record", "nowhere/fling.json", says="nowhere/fling.json: cannot be written")
        self.expect_of_hyrax(CANNOT_ACCESS, "--log", "nowhere/fling.log", says="nowhere/fling.log: cannot be written")

    def test_an_existing_file_is_left_unchanged(self):
        path = self.write("mine.json", fling())
        mine = (self.folder / path).read_bytes()
        for options in (["--record", path], ["--log", path], ["--replay", path, "--log", path]):
            self.expect_of_hyrax(BAD_INPUT, *options, says="mine.json: exists already; name another file")
            self.assertEqual((self.folder / path).read_bytes(), mine)

    def test_a_replay_in_the_window_gives_the_same_verdict(self):
        other = self.write("short.json", fling(steps=30, expect={"state_hash": HASH_OF_FLING}))
        self.expect_of_hyrax(DISAGREED, other, says="differs")
        self.expect_of_hyrax(DISAGREED, "--replay", other, "--seconds", "0", says="ended at step ")

    def test_a_replay_logs_no_frame_twice(self):
        slow = self.write("slow.json", fling(clock={"rate_hz": 10}, steps=10))
        self.expect_of_hyrax(AGREED, "--replay", slow, "--log", "slow.log")
        frames = [line["frame"] for line in read_log(self.folder / "slow.log")]
        self.assertEqual(frames[-1], 9)
        self.assertEqual(frames, sorted({*frames}))

    def test_a_window_larger_than_the_screen_is_scaled_down(self):
        large = self.write("large.json", fling(window={"width_px": 4096, "height_px": 1080}, steps=120,
                                               start={"x_px": 3968, "y_px": 500, "vx_px_per_s": 0, "vy_px_per_s": 0}))
        self.expect_of_hyrax(AGREED, large, "--log", "large.log")
        for frame in read_log(self.folder / "large.log"):
            left, top, right, bottom = frame["window_rect_px"]
            self.assertEqual((left, right - left, bottom - top), (992, 32, 32))
            self.assertLessEqual(abs(top - frame["y_px"] / 4), 0.5)

    def test_a_file_may_have_any_name_and_a_long_path(self):
        folder = "/".join(["Ein sehr weiter Flug über Ærø mit vielen Landungen und ohne Eile"] * 5)
        (self.folder / folder).mkdir(parents=True)
        for name in ("Ein Flug über Ærø.json", f"{folder}/Flug.json"):
            self.expect_of_hyrax(AGREED, "--record", name, "--log", f"{name}.log", "--seconds", "0.5")
            self.expect(AGREED, "run", name, "-o", "flight.h5")
            done = self.wine.run(HYRAX_REPLAY, name, cwd=self.folder)
            self.assertEqual((done.exit_code, done.out[32:]), (AGREED, f"  {name}\n"), str(done))
            self.expect_of_hyrax(AGREED, name, "--exit", says="agrees")
