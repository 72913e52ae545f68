"""The card of a candidate core as a page in Chromium."""

import os
import pathlib
import shutil

import browser
import program
from process import succeed
from program import SOURCE

BUILD = pathlib.Path(os.environ["HYRAX_BUILD"])
NAME = "<img src=x onerror=alert(2)>.h"


class CardTest(browser.BrowserTest):
    """hyrax-compare --report."""

    @classmethod
    def setUpClass(cls):
        succeed("cmake", "--build", BUILD, "--target", "hyrax-compare", timeout=600)
        super().setUpClass()

    def setUp(self):
        super().setUp()
        for name in ("flings/first-fling", "recorded/caught-in-flight", "hard/window-of-no-size"):
            target = self.folder / "library" / f"{name}.json"
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / "scenarios" / f"{name}.json", target)
        shipped = (SOURCE / "sim/physics/physics.h").read_text(encoding="utf-8")
        self.write(NAME, shipped.replace("GROUND_FRICTION = 0.8;", "GROUND_FRICTION = 0.7;"))

    def test_shows_every_line_and_figure(self):
        text = succeed(BUILD / "bin/hyrax-compare", NAME, "--scenarios", "library", "--flings", "20", "--report", "card.html",
                       cwd=self.folder).out
        (page,) = self.open({"file": str(self.folder / "card.html"), "actions": [
            ["evaluate", "document.body.innerText"], ["evaluate", "document.querySelectorAll('figure > .picture').length"]]})
        shown, figures = page["values"]
        self.assertEqual((page["errors"], page["requests"], figures), ([], [], 5))
        for line in text.splitlines()[2:]:
            self.assertIn(" ".join(line[18:].split()), " ".join(shown.split()))
        self.assertIn(NAME, shown)


if __name__ == "__main__":
    program.main()
