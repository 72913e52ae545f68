"""The committed pictures are the rendered drawings, in the form that the program expects."""

import pathlib
import struct
import tempfile
import unittest

import numpy

from process import skip_without, succeed

skip_without("rsvg-convert", "convert")

SPRITE = pathlib.Path(__file__).resolve().parents[3] / "tools/hyrax/sprite"
POSES = ("stand", "fly", "held", "sleep")
SIDES_PX = {100: 128, 125: 160, 150: 192, 175: 224, 200: 256}

# `render` keeps 56 of 256 levels, and another version of the renderer may place an edge a little otherwise.
LEVELS_OFF_MAX = 24
SHARE_OFF_MAX = 0.002


def read_png(data):
    """The pixels of a picture as an array [row, column, channel], of red, green, blue and opacity."""
    width, height = struct.unpack(">II", data[16:24])
    with tempfile.NamedTemporaryFile(suffix=".png") as file:
        file.write(data)
        file.flush()
        pixels = succeed("convert", file.name, "-depth", 8, "rgba:-").out_bytes
    return numpy.frombuffer(pixels, numpy.uint8).reshape(height, width, 4).astype(int)


def premultiplied(pixels):
    """The visible picture: colours weighted by their opacity."""
    alpha = pixels[..., 3:]
    return numpy.concatenate([pixels[..., :3] * alpha // 255, alpha], axis=2)


def share_off(left, right):
    """The share of pixels that differ visibly."""
    difference = numpy.abs(premultiplied(left) - premultiplied(right)).max(axis=2)
    return float((difference > LEVELS_OFF_MAX).mean())


class Sprite(unittest.TestCase):
    """Four poses at five scales."""

    def committed(self, pose, scale):
        """A picture as the program has it."""
        return read_png((SPRITE / f"{pose}-{scale}.png").read_bytes())

    def rendered(self, pose, side_px):
        """The drawing as rsvg-convert renders it here."""
        with tempfile.NamedTemporaryFile("w", suffix=".css") as style:
            style.write(f".pose {{ display: none }} #{pose} {{ display: inline }}")
            style.flush()
            outcome = succeed("rsvg-convert", "--stylesheet", style.name, "--width", side_px, "--height", side_px,
                              SPRITE / "hyrax.svg")
        return read_png(outcome.out_bytes)

    def test_every_picture_is_its_drawing(self):
        for pose in POSES:
            for scale, side_px in SIDES_PX.items():
                with self.subTest(pose=pose, scale=scale):
                    picture = self.committed(pose, scale)
                    self.assertEqual(picture.shape, (side_px, side_px, 4))
                    self.assertLess(share_off(picture, self.rendered(pose, side_px)), SHARE_OFF_MAX)

    def test_another_pose_and_a_shift_would_be_found(self):
        picture = self.committed("stand", 100)
        self.assertGreater(share_off(picture, self.rendered("fly", 128)), SHARE_OFF_MAX)
        self.assertGreater(share_off(picture, numpy.roll(picture, 1, axis=1)), SHARE_OFF_MAX)

    def test_it_stands_on_the_ground_and_fills_its_square(self):
        for pose in ("stand", "sleep"):
            opaque = self.committed(pose, 100)[..., 3] > 128
            self.assertTrue(opaque[126].any(), "the feet are above the ground")
            self.assertGreater(opaque.any(axis=0).sum(), 0.9 * 128)
        for pose in POSES:
            alpha = self.committed(pose, 200)[..., 3]
            self.assertEqual(alpha[0, 0], 0, "the corner is not clear")
            edge = ((alpha > 0) & (alpha < 255)).sum()
            self.assertGreater(edge, 500, "the edge is not smooth")

    def test_the_icon_has_every_size(self):
        data = (SPRITE / "hyrax.ico").read_bytes()
        reserved, kind, count = struct.unpack("<HHH", data[:6])
        sides = [data[6 + 16 * entry] or 256 for entry in range(count)]
        self.assertEqual((reserved, kind, sides), (0, 1, [16, 20, 24, 32, 48, 64, 256]))
