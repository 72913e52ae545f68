"""The hyrax on a desktop with a compositor, pixel by pixel: its edge is blended, transparent pixels are unchanged."""

import pathlib
import subprocess
import time

import numpy

from hyrax_program import HyraxTest, read_log
from process import Process, skip_without, succeed
from sprite_test import SPRITE, read_png
from wine import Screen

skip_without("Xvfb", "picom", "hsetroot", "import", "xdotool")

SIZE_PX = (1280, 720)
DESKTOP = (0x20, 0xA0, 0xC0)
BELOW_TRAY_PX = 100  # Where there is no taskbar, Wine shows the tray icon in a small window at the top.
LEVELS_OFF_MAX = 5  # Two roundings of 8 bits, in GDI+ and in the compositor, and one of ours.


class Desktop(Screen):
    """A screen of one colour, with a compositor."""

    def __init__(self):
        super().__init__(*SIZE_PX)
        succeed("hsetroot", "-solid", "#%02x%02x%02x" % DESKTOP, env={"DISPLAY": self.display})
        self._compositor = Process("picom", "--backend", "xrender", "--config", "/dev/null",
                                   env={"DISPLAY": self.display, "PATH": "/usr/bin:/bin"},
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def pixels(self):
        """The visible picture, as an array [row, column, channel]."""
        outcome = succeed("import", "-display", self.display, "-window", "root", "-depth", "8", "rgb:-",
                          env={"PATH": "/usr/bin:/bin", "HOME": "/nonexistent"})
        return numpy.frombuffer(outcome.out_bytes, numpy.uint8).reshape(SIZE_PX[1], SIZE_PX[0], 3).astype(int)

    def drag(self, x_px, y_px, steps):
        """Drags with the server's pointer, which ignores transparent pixels, in steps of 12 ms each."""
        arguments = ["mousemove", x_px, y_px, "mousedown", 1]
        for dx_px, dy_px in steps:
            x_px, y_px = x_px + dx_px, y_px + dy_px
            arguments += ["mousemove", x_px, y_px, "sleep", 0.012]
        arguments += ["sleep", 0.3, "mouseup", 1, "sleep", 0.3]
        succeed("xdotool", *arguments, env={"DISPLAY": self.display})

    def end(self):
        self._compositor.end()
        super().end()


def blended(picture, desktop):
    """A picture upon a desktop of one colour: c a + d (1 - a)."""
    alpha = picture[..., 3:] / 255
    return picture[..., :3] * alpha + numpy.array(desktop) * (1 - alpha)


class Picture(HyraxTest):
    """The hyrax asleep on the ground of a coloured desktop."""

    def setUp(self):
        self.screen = Desktop()
        self.addCleanup(self.screen.end)
        self.display = self.screen.display
        super().setUp()

    def screenshot(self):
        """The desktop when nothing moves any more."""
        before, now = None, self.screen.pixels()
        give_up_s = time.monotonic() + 120
        while before is None or (before != now).any():
            self.assertLess(time.monotonic(), give_up_s, "the desktop does not stop changing")
            time.sleep(0.3)
            before, now = now, self.screen.pixels()
        return now

    def test_every_pixel_is_the_pictures_blended_with_the_desktop(self):
        process = self.start()
        self.wait_for_sleep()
        seen = self.screenshot()
        flight = self.close(process)
        left, top, right, bottom = (int(side) for side in flight.frames[-1]["window_rect_px"])
        picture = read_png((SPRITE / "sleep-100.png").read_bytes())
        window = seen[top:bottom, left:right]
        difference = numpy.abs(window - blended(picture, DESKTOP)).max(axis=2)
        self.assertLessEqual(difference.max(), LEVELS_OFF_MAX)

        alpha = picture[..., 3]
        clear, edge = alpha == 0, (alpha > 64) & (alpha < 192)
        self.assertGreater(clear.sum(), 1000)
        self.assertTrue((window[clear] == DESKTOP).all(), "a clear pixel is touched")
        self.assertGreater(edge.sum(), 50)
        for wrong in (blended(picture, (0, 0, 0)), picture[..., :3]):  # Of a dark fringe, and of a hard edge.
            self.assertGreater(numpy.abs(window - wrong)[edge].max(), 10 * LEVELS_OFF_MAX)

        seen[top:bottom, left:right] = DESKTOP
        self.assertTrue((seen[BELOW_TRAY_PX:] == DESKTOP).all(), "something else is on the desktop")

    def test_a_click_beside_it_and_a_drag(self):
        process = self.start()
        self.wait_for_sleep()
        left, top, _, _ = (int(side) for side in read_log(self.folder / "flight.log")[-2]["window_rect_px"])
        picture = read_png((SPRITE / "sleep-100.png").read_bytes())
        clear, fur = (5, 5), (64, 100)
        self.assertEqual([picture[y, x, 3] for x, y in (clear, fur)], [0, 255])
        self.screen.drag(left + clear[0], top + clear[1], [])
        self.screen.drag(left + fur[0], top + fur[1], [(4, -3)] * 30)
        self.wait_for_input("release")
        flight = self.close(process)
        self.assertEqual([len(flight.events(kind)) for kind in ("grab", "release")], [1, 1])
        self.assert_is_the_model(flight)


class NoScreen(HyraxTest):
    """A display that is not there."""

    display = ":4711"

    def test_it_ends_with_a_sentence_and_an_exit_code(self):
        self.assertFalse(pathlib.Path("/tmp/.X11-unix/X4711").exists())
        flight = self.end(self.start())
        self.assertEqual(flight.exit_code, 3)
        self.assertIn("the window cannot be created", flight.err)
        self.assertFalse(flight.path.exists())
