"""A real drag and fling: the window moves as the model does, and as the recording replays."""

import multiprocessing

from hyrax_program import HyraxTest
from program import AGREED

BURNERS = 4
ESCAPE = 27
SEEN_S = 0.03


def burn():
    """Keeps a core busy."""
    while True:
        pass


class Fling(HyraxTest):
    """Catches the bouncing hyrax, drags it, and releases it in motion."""

    def assert_was_flung(self, flight):
        """It was held, followed the hand, and left it upwards to the right."""
        self.assertEqual([len(flight.events(kind)) for kind in ("grab", "release")], [1, 1])
        self.assertGreater(len(flight.events("place")), 0)
        # On a busy machine the program may get no pointer positions for longer, and then has no speed of the hand.
        if max(frame["dt_s"] for frame in flight.frames if frame["held"]) < SEEN_S:
            velocity = flight.events("release")[0]["release"]
            self.assertGreater(velocity["vx_px_per_s"], 0)
            self.assertLess(velocity["vy_px_per_s"], 0)
        self.assert_is_the_model(flight)

    def test_the_window_goes_where_the_model_goes(self):
        flight = self.fling_and_watch(2500)
        self.assert_was_flung(flight)
        self.assert_replays_everywhere(flight)
        scenarios = self.folder / "scenarios"  # `check` takes the recording as it is.
        scenarios.mkdir()
        flight.path.rename(scenarios / "flight.json")
        self.expect(AGREED, "check", "scenarios")

    def test_escape_cancels_a_drag(self):
        process = self.start()
        self.wait_for_sleep()
        self.hand("point", 64, 64, "grab", *"by -6 -10 20 12".split(), "sleep", 100, "key", ESCAPE)
        self.wait_for_input("release")
        self.hand("release")
        self.wait_for_sleep()
        flight = self.close(process)
        self.assertEqual(flight.events("release")[0]["release"], {"vx_px_per_s": 0, "vy_px_per_s": 0})
        first, last = next(frame for frame in flight.frames if frame["held"]), flight.frames[-1]
        self.assertEqual((first["x_px"], first["y_px"]), (last["x_px"], last["y_px"]))
        self.assert_is_the_model(flight)

    def test_under_load(self):
        burners = [multiprocessing.Process(target=burn, daemon=True) for _ in range(BURNERS)]
        for burner in burners:
            burner.start()
            self.addCleanup(burner.join)
            self.addCleanup(burner.kill)
        self.assert_was_flung(self.fling_and_watch(1000))

    def test_another_path_would_be_found(self):
        flight = self.fling_and_watch(300)
        flight.frames[-3]["window_rect_px"][0] += 1
        flight.frames[-3]["window_rect_px"][2] += 1
        with self.assertRaises(AssertionError):
            self.assert_is_the_model(flight)
