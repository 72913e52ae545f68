"""Disturbances by the desktop, in flight and at rest: no input is lost, and the window keeps following the model."""

import os
import signal
import time

from hyrax_program import HyraxTest

SCREEN = [1024, 768]
SMALL_SCREEN = [800, 600]

WM_POWERBROADCAST, PBT_APMSUSPEND, PBT_APMRESUMEAUTOMATIC = 0x218, 4, 0x12
ASLEEP_MS = 4000

# The recording is written every second; writing it takes some time.
LOST_MAX_S = 1.5
WRITES_S = 2


class Disturbance(HyraxTest):
    """Each test does one thing to the program that no hand does."""

    def assert_resized(self, flight, size):
        """A recorded input gave the window this size."""
        sizes = [[event["resize"].get("window", {}).get(side) for side in ("width_px", "height_px")]
                 for event in flight.events("resize")]
        self.assertIn(size, sizes)

    def test_the_display_shrinks_and_grows_in_flight(self):
        process = self.start_and_fling()
        self.hand("display", *SMALL_SCREEN)
        self.wait_for_input("resize-window", 1)
        self.hand("sleep", 500, "display", *SCREEN)
        self.wait_for_input("resize-window", 2)
        self.wait_for_sleep()
        flight = self.close(process)
        self.assert_is_the_model(flight)
        self.assert_resized(flight, SMALL_SCREEN)
        self.assert_resized(flight, SCREEN)
        left, _, right, bottom = flight.frames[-1]["window_rect_px"]
        self.assertEqual(bottom, SCREEN[1], "the feet are not on the lower edge")
        self.assertTrue(0 <= left and right <= SCREEN[0])

    def test_a_sprite_larger_than_the_work_area(self):
        self.set_scaling_dpi(960)
        self.addCleanup(self.set_scaling_dpi, 96)
        flight = self.fling_and_watch(1500)
        width, height = flight.frames[-1]["sprite_px"]
        self.assertGreater(max(width / SCREEN[0], height / SCREEN[1]), 1)
        self.assert_is_the_model(flight)

    def test_the_time_that_the_machine_sleeps_in_flight_is_no_frame(self):
        process = self.start_and_fling()
        self.hand("post", WM_POWERBROADCAST, PBT_APMSUSPEND, 0, "sleep", ASLEEP_MS, "post", WM_POWERBROADCAST, PBT_APMRESUMEAUTOMATIC, 0)
        self.wait_for_sleep()
        flight = self.close(process)
        self.assert_is_the_model(flight)
        self.assertLessEqual(max(flight.document["clock"]["dt_s"]), 0.1)

    def test_killed_in_mid_recording_it_loses_at_most_a_second(self):
        for wait_ms in (100, 500, 900):
            process = self.start_and_fling()
            self.hand("sleep", wait_ms)
            give_up_s = time.monotonic() + WRITES_S
            while not self.parts() and time.monotonic() < give_up_s:
                pass
            process.send(signal.SIGKILL)  # While it writes.
            flight = self.end(process)
            self.wine.end()
            self.assertEqual(self.parts(), [])
            self.assertEqual(flight.exit_code, -signal.SIGKILL)
            recorded = flight.document["clock"]["dt_s"]
            shown = [frame["dt_s"] for frame in flight.frames]
            self.assertEqual(recorded, shown[:len(recorded)])
            self.assertLess(sum(shown[len(recorded):]), LOST_MAX_S)
            self.rows(flight.path)

    def parts(self):
        """The file that is being written."""
        return [name for name in os.listdir(self.folder) if name.endswith(".part")]

    def set_scaling_dpi(self, dpi):
        """The scaling that the user has set for the display."""
        done = self.wine.run("reg", "add", r"HKCU\Control Panel\Desktop", "/v", "LogPixels", "/t", "REG_DWORD",
                             "/d", dpi, "/f")
        self.assertEqual(done.exit_code, 0, done.err)
        self.wine.end()
