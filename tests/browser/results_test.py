"""Pages of studies and sweeps in Chromium: every figure is drawn, data can be saved, text stays text."""

import itertools
import json
import math
import pathlib

import h5py
import numpy

import browser
import program
from program import AGREED, SOURCE

HOSTILE = browser.HOSTILE
FIGURES = "document.querySelectorAll('figure').length"
DRAWN = "document.querySelectorAll('.picture > :is(svg, table)').values().filter(each => each.checkVisibility()).toArray().length"

HARD, FLINGS = (str(SOURCE / "scenarios" / name) for name in ("hard", "flings"))
STUDIES = [("speed-error",), ("rest",), ("frame-rate",), ("paper",), ("bounces",), ("needs", FLINGS), ("hard-cases", HARD)]
DRAWS = {"/start/vx_px_per_s": {"uniform": [-2000, 2000]}, "/clock/rate_hz": {"choice": [60, 120]}}
GRID = {"/start/vx_px_per_s": {"grid": [-2000, 2000, 20]}, "/start/x_px": {"grid": [0, 1100, 12]}}

TONES = ["ink", "vermilion", "orange", "blue", "green", "purple", "sky-blue", "lavender"]

# What is wrong with a page: texts of pictures that overlap, leave their picture or are smaller than 11 px, pictures, texts, tables and pages
# that are wider than their place, pictures that are not drawn.
FAULTS = """(() => {
  const faults = [], meets = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 2 && b.top < a.bottom - 2;
  for (const svg of [...document.querySelectorAll('.picture > svg')].filter(each => each.checkVisibility())) {
    const whole = svg.getBoundingClientRect(), scale = whole.width / svg.viewBox.baseVal.width;
    if (svg.outerHTML.includes('NaN')) faults.push('not a number');
    const texts = [...svg.querySelectorAll('text:not([transform*=rotate])')];
    const boxes = texts.map(each => each.getBoundingClientRect());
    boxes.forEach((box, i) => {
      if (scale * texts[i].getAttribute('font-size') < 10.99) faults.push(`small: ${texts[i].textContent}`);
      if (box.left < whole.left - 2 || box.right > whole.right + 2 || box.top < whole.top - 2 || box.bottom > whole.bottom + 2) faults.push(`cut: ${texts[i].textContent}`);
      for (let j = 0; j < i; ++j) if (meets(box, boxes[j])) faults.push(`overlap: ${texts[i].textContent} and ${texts[j].textContent}`);
    });
  }
  for (const cell of document.querySelectorAll('h1, h2:not(.unseen), h3, .picture, .listing td'))
    if (cell.scrollWidth > cell.clientWidth + 1 || cell.getBoundingClientRect().right > innerWidth + 1) faults.push(`wide: ${cell.textContent}`);
  for (const table of document.querySelectorAll('.verdict .table')) if (table.scrollWidth > table.clientWidth + 1) faults.push(`scrolls: ${table.textContent}`);
  if (document.documentElement.scrollWidth > innerWidth) faults.push('scrolls: the page');
  if (document.body.innerText.includes('cannot be shown')) faults.push('cannot be shown');
  return faults;
})()"""


def closest(colors):
    """The smallest distance of two colours #rrggbb in CIELAB."""
    def lab(color):
        red, green, blue = ((each / 12.92 if each <= 0.04045 else ((each + 0.055) / 1.055) ** 2.4)
                            for each in (int(color[at:at + 2], 16) / 255 for at in (1, 3, 5)))
        x = (0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.95047
        y = 0.2126 * red + 0.7152 * green + 0.0722 * blue
        z = (0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.08883
        x, y, z = (each ** (1 / 3) if each > 0.008856 else 7.787 * each + 16 / 116 for each in (x, y, z))
        return 116 * y - 16, 500 * (x - y), 200 * (y - z)
    return min(math.dist(lab(a), lab(b)) for a, b in itertools.combinations(colors, 2))


class ResultsTest(browser.BrowserTest):
    """Reports of studies and sweeps, opened in a browser."""

    def study(self, name, *arguments):
        """Runs a study; returns a task that opens its report."""
        self.expect(AGREED, "study", name, *arguments, "--quick", "--no-figures")
        return self.report(name)

    def sweep(self, name, vary, members, **changed):
        """Plays a sweep; returns a task that opens its report."""
        self.write(f"{name}.json", {"format": "hyrax-sweep/1", "base": program.fling(**changed), "members": members, "seed": 1, "vary": vary})
        self.expect(AGREED, "sweep", f"{name}.json")
        return self.report(name)

    def grid(self):
        """Plays a sweep over two grids; returns a task that opens its report."""
        return self.sweep("grid", GRID, members=240)

    def test_every_figure_is_whole_at_every_width_and_the_test_sees_it(self):
        tasks = [self.study(*study) for study in STUDIES] + [self.sweep("draws", DRAWS, members=300), self.grid()]
        wide, narrow = {"size": (1400, 900)}, {"size": (375, 844), "scheme": "dark"}
        looks = [wide, *({"size": (width, 900)} for width in (1100, 800, 700)), narrow]
        actions = [["wait", f"{FIGURES} > 0 && {DRAWN} >= {FIGURES}"], ["axe"],
                   *(action for look in looks for action in (["look", look], ["evaluate", FAULTS])), ["axe"]]
        for task, page in zip(tasks, self.open(*({**task, "actions": actions} for task in tasks))):
            self.assertEqual([found for found in page["values"][1:] if found], [], task["file"])
            self.assertEqual((page["errors"], page["requests"]), ([], []), task["file"])
        (page,) = self.open({**tasks[-1], "actions": [["look", wide], ["evaluate", browser.CANVAS_FAULTS], ["look", narrow], ["evaluate", browser.CANVAS_FAULTS]]})
        for count, faults in page["values"][1::2]:
            self.assertGreater(count, 10)
            self.assertEqual(faults, [])

        texts = "[...document.querySelectorAll('.picture > .wide text')]"
        spoilt = [("overlap", wide, f"(texts => ['x', 'y'].forEach(name => texts[1].setAttribute(name, texts[0].getAttribute(name))))({texts})"),
                  ("cut", wide, f"{texts}[0].setAttribute('x', '-40')"),
                  ("wide", wide, "document.querySelector('.picture > .wide').style.width = '2000px'"),
                  ("small", narrow, "document.querySelectorAll('.picture > .narrow').forEach(each => (each.style.width = '250px'))"),
                  ("scrolls", narrow, "document.querySelectorAll('.folded').forEach(each => each.classList.remove('folded'))")]
        (page,) = self.open({**tasks[0], "actions": [action for _, look, fault in spoilt for action in (["look", look], ["evaluate", fault], ["evaluate", FAULTS])]})
        for (kind, _, _), faults in zip(spoilt, page["values"][2::3]):
            self.assertIn(kind, {fault.split(":")[0] for fault in faults})

    def test_colours_differ_to_the_eye_light_and_dark(self):
        read = f"(style => {json.dumps(TONES)}.map(name => style.getPropertyValue('--' + name).trim()))(getComputedStyle(document.documentElement))"
        shared = "document.documentElement.style.setProperty('--green', getComputedStyle(document.documentElement).getPropertyValue('--blue'))"
        (page,) = self.open({**self.study("rest"), "actions": [["evaluate", read], ["look", {"scheme": "dark"}], ["evaluate", read], ["evaluate", shared], ["evaluate", read]]})
        light, _, dark, _, control = page["values"]
        self.assertNotEqual(light, dark)
        self.assertGreater(min(closest(light), closest(dark)), 18)
        self.assertEqual(closest(control), 0)

    def test_a_cell_replays_its_member_and_saves_it_as_a_scenario(self):
        down = self.folder / "cell.json"
        (page,) = self.open({**self.grid(), "actions": [
            ["mouse", ".u-over", [[5.5 / 20, 1 - 3.5 / 12]] * 2], ["wait", "!document.getElementById('member').hidden"],
            ["evaluate", "document.getElementById('member-heading').textContent"],
            ["evaluate", "document.getElementById('member-note').textContent"], ["download", "#download-member", str(down)]]})
        self.assertEqual(page["errors"], [])
        member = 5 * 12 + 3
        self.assertEqual(page["values"][2], f"Member {member}")
        self.assertIn("4 neighbours", page["values"][3])
        self.expect(AGREED, "sweep", "grid.json", "--member", str(member), "-o", "member.json")
        state_hash = self.hash_of("member.json", "member.h5")
        self.assertEqual(json.loads(down.read_text(encoding="utf-8"))["expect"]["state_hash"], state_hash)
        self.assertEqual(self.hash_of("cell.json", "cell.h5"), state_hash)

    def test_carries_only_what_it_shows(self):
        results = pathlib.Path(self.study("rest")["file"]).read_text(encoding="utf-8")
        self.played("fling", program.fling(steps=600))
        runs = pathlib.Path(self.report("fling")["file"]).read_text(encoding="utf-8")
        for text in ("uplot\n", 'id="core"'):
            self.assertEqual((text in runs, text in results), (True, False), text)
        self.assertLess(len(runs), 400_000)
        self.assertLess(len(results), 1_000_000)

    def test_has_its_pictures_without_javascript_and_on_paper(self):
        tasks = [self.study("rest"), self.grid()]
        boxes = "[...document.querySelectorAll('.picture > svg')].filter(each => each.checkVisibility()).map(each => each.getBoundingClientRect().height > 100 && each.querySelectorAll('text').length > 5)"
        ink = "getComputedStyle(document.querySelector('.picture text')).fill"
        for task in tasks:
            looks = {**task, "scheme": "dark", "actions": [["evaluate", boxes], ["evaluate", ink], ["paper"], ["evaluate", boxes], ["evaluate", ink]]}
            plain, page = self.open({**looks, "plain": True}, looks)
            self.assertEqual(plain["values"], page["values"])
            shown, dark, _, printed, light = plain["values"]
            self.assertGreater(len(shown), 0)
            self.assertTrue(all(shown + printed))
            self.assertNotEqual(light, dark)
        (page,) = self.open({**tasks[0], "plain": True, "size": (375, 844), "actions": [
            ["evaluate", "document.body.innerText"], ["evaluate", "document.documentElement.scrollWidth <= innerWidth"]]})
        self.assertIn("no rule of the study is broken", page["values"][0])
        self.assertTrue(page["values"][1])

    def test_hostile_text_stays_text(self):
        self.sweep("sweep", DRAWS, members=300, description=HOSTILE)
        (self.folder / "sweep.h5").rename(self.folder / "<img src=x onerror=alert(3)>.h5")
        self.expect(AGREED, "report", "<img src=x onerror=alert(3)>.h5", "-o", "sweep.html")
        task = self.study("rest")
        with h5py.File(self.folder / "rest.h5") as file:
            figures = json.loads(file["report/figures"][0])
        for figure in figures:
            figure.update(title=HOSTILE, subtitle=HOSTILE, note=HOSTILE, remarks=[HOSTILE])
            figure["legend"][0]["text"] = HOSTILE
            figure["body"]["plots"][0]["x"]["label"] = HOSTILE
            figure["body"]["plots"][0]["series"][0].update(name=HOSTILE)
            figure["body"]["plots"][0]["texts"] = [{"x": 100, "y": 1, "text": HOSTILE, "tone": "ink"}]
        with h5py.File(self.folder / "rest.h5", "r+") as file:
            del file["report/figures"]
            file["report/figures"] = numpy.array([json.dumps(figures).encode()])
            file.attrs["study"] = HOSTILE
        self.report("rest")
        looks = [["evaluate", "document.querySelectorAll('main img, main script').length"],
                 ["evaluate", "document.querySelector('h1').textContent"]]
        pages = self.open({"file": str(self.folder / "sweep.html"), "bypass_csp": True, "actions": looks},
                                          {**task, "bypass_csp": True, "actions": looks})
        self.assertEqual(pages[1]["values"][1], HOSTILE)
        for page in pages:
            self.assertEqual(page["values"][0], 0)
            self.assertEqual((page["errors"], page["requests"]), ([], []))


if __name__ == "__main__":
    program.main()
