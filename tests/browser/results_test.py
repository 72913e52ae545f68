"""Pages of studies, drift, checks and sweeps in Chromium: every figure is drawn, text stays text."""

import json
import pathlib
import re

import browser
import program
from program import AGREED, BAD_INPUT, DISAGREED, SOURCE

HOSTILE = browser.HOSTILE
FIGURES = "document.querySelectorAll('figure').length"
OPENED = ["evaluate", "document.querySelectorAll('details').forEach(each => (each.open = true))"]
DRAWN = "document.querySelectorAll('.picture > svg').values().filter(each => each.checkVisibility()).toArray().length"

HARD, FLINGS = (str(SOURCE / "scenarios" / name) for name in ("hard", "flings"))
STUDIES = [("speed-error",), ("frame-rate",), ("needs", FLINGS), ("hard-cases", HARD)]
DRAWS = {"/start/vx_px_per_s": {"uniform": [-2000, 2000]}, "/clock/rate_hz": {"choice": [60, 120]}}
GRID = {"/start/vx_px_per_s": {"grid": [-2000, 2000, 20]}, "/start/x_px": {"grid": [0, 1100, 12]}}

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
  for (const cell of document.querySelectorAll('h1, h2, h3, .picture'))
    if (cell.scrollWidth > cell.clientWidth + 1 || cell.getBoundingClientRect().right > innerWidth + 1) faults.push(`wide: ${cell.textContent}`);
  if (document.documentElement.scrollWidth > innerWidth) faults.push('scrolls: the page');
  return faults;
})()"""


class ResultsTest(browser.BrowserTest):
    """Reports of studies and sweeps, opened in a browser."""

    def study(self, name, *arguments):
        """Runs a study; returns a task that opens its page."""
        self.expect(AGREED, "study", name, *arguments, "--quick", "--no-figures", "--report", f"{name}.html")
        return {"file": str(self.folder / f"{name}.html")}

    def sweep(self, name, vary, members, **changed):
        """Plays a sweep; returns a task that opens its report."""
        self.write(f"{name}.json", {"format": "hyrax-sweep/1", "base": program.fling(**changed), "members": members, "seed": 1, "vary": vary})
        self.expect(AGREED, "sweep", f"{name}.json")
        return self.report(name)

    def grid(self):
        """Plays a sweep over two grids; returns a task that opens its report."""
        return self.sweep("grid", GRID, members=240)

    def drift(self):
        """Measures a fling and an uneven one; returns a task that opens their page."""
        self.expect(AGREED, "drift", *(f"{FLINGS}/{name}.json" for name in ("first-fling", "corner-fling")), "--report", "drift.html")
        return {"file": str(self.folder / "drift.html")}

    def test_every_figure_is_whole_at_every_width_and_the_test_sees_it(self):
        tasks = [self.study(*study) for study in STUDIES] + [self.drift(), self.sweep("draws", DRAWS, members=300), self.grid()]
        wide, narrow = {"size": (1400, 900)}, {"size": (375, 844), "scheme": "dark"}
        looks = [wide, *({"size": (width, 900)} for width in (1100, 800, 700)), narrow]
        actions = [OPENED, ["wait", f"{FIGURES} > 0 && {DRAWN} >= {FIGURES}"], ["axe"],
                   *(action for look in looks for action in (["look", look], ["evaluate", FAULTS])), ["axe"]]
        for task, page in zip(tasks, self.open(*({**task, "actions": actions} for task in tasks))):
            self.assertEqual([found for found in page["values"][2:] if found], [], task["file"])
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
                  ("scrolls", narrow, "document.querySelectorAll('.table').forEach(each => (each.style.overflow = 'visible'))")]
        (page,) = self.open({**tasks[0], "actions": [OPENED, *(action for _, look, fault in spoilt for action in (["look", look], ["evaluate", fault], ["evaluate", FAULTS]))]})
        for (kind, _, _), faults in zip(spoilt, page["values"][3::3]):
            self.assertIn(kind, {fault.split(":")[0] for fault in faults})

    def test_a_cell_replays_its_member_and_saves_it_as_a_scenario(self):
        down = self.folder / "cell.json"
        (page,) = self.open({**self.grid(), "actions": [
            ["mouse", ".u-over", [[5.5 / 20, 1 - 3.5 / 12]] * 2], ["wait", "!document.getElementById('member').hidden"],
            ["evaluate", "document.getElementById('member-heading').textContent"],
            ["evaluate", "document.getElementById('member-note').textContent"], ["download", "#download-member", str(down)],
            ["evaluate", "(({top, bottom}) => top >= 0 && bottom <= innerHeight)(document.getElementById('member').getBoundingClientRect())"], ["look", {"size": (390, 844)}],
            ["evaluate", "['member', 'replay'].map(id => document.getElementById(id).getBoundingClientRect().right)"]]})
        self.assertEqual(page["errors"], [])
        *_, is_in_view, _, (frame, canvas) = page["values"]
        self.assertTrue(is_in_view)
        self.assertLess(canvas, frame)
        member = 5 * 12 + 3
        self.assertEqual(page["values"][2], f"Member {member}")
        self.assertIn("4 neighbours", page["values"][3])
        self.expect(AGREED, "sweep", "grid.json", "--member", str(member), "-o", "member.json")
        state_hash = self.hash_of("member.json", "member.h5")
        self.assertEqual(json.loads(down.read_text(encoding="utf-8"))["expect"]["state_hash"], state_hash)
        self.assertEqual(self.hash_of("cell.json", "cell.h5"), state_hash)

    def test_a_member_of_varied_parameters_replays_with_them(self):
        down = self.folder / "cell.json"
        vary = {"/parameters/GRAVITY": {"grid": [300, 1500, 5]}, "/parameters/RESTITUTION": {"grid": [0.25, 0.75, 4]}}
        (page,) = self.open({**self.sweep("moons", vary, members=20, parameters={"REST_THRESHOLD": 30}), "actions": [
            ["mouse", ".u-over", [[1.5 / 5, 1 - 2.5 / 4]] * 2], ["wait", "!document.getElementById('member').hidden"],
            ["download", "#download-member", str(down)], ["evaluate", "document.getElementById('member-heading').textContent"]]})
        self.assertEqual((page["errors"], page["values"][-1]), ([], "Member 6"))
        self.expect(AGREED, "sweep", "moons.json", "--member", "6", "-o", "member.json")
        state_hash = self.hash_of("member.json", "member.h5")
        self.assertEqual(json.loads(down.read_text(encoding="utf-8"))["expect"]["state_hash"], state_hash)
        self.assertEqual(self.hash_of("cell.json", "cell.h5"), state_hash)

    def test_members_of_two_sweeps_have_numbers_of_their_own(self):
        for name, count in (("first", 3), ("second", 5)):
            self.sweep(name, {"/start/vx_px_per_s": {"grid": [0, 1000, count]}}, members=count)
        self.expect(AGREED, "report", "first.h5", "second.h5", "-o", "both.html")
        number = "(input => { input.value = 4; input.dispatchEvent(new Event('change')); })(document.querySelectorAll('input[type=number]')[1])"
        (page,) = self.open({"file": str(self.folder / "both.html"), "actions": [["evaluate", number], ["wait", "!document.getElementById('member').hidden"],
                             ["evaluate", "[...document.querySelectorAll('input[type=number]'), document.getElementById('member-heading')].map(each => each.value ?? each.textContent)"], ["axe"]]})
        self.assertEqual((page["errors"], page["values"][2:]), ([], [["", "4", "Member 4"], []]))

    def test_a_long_name_does_not_widen_the_page(self):
        names = ["short", "long" * 40]
        for name in names:
            self.write(f"scenarios/{name}.json", program.fling())
        self.expect(AGREED, "bless", "scenarios", "--reason", "test")
        for name, speed in zip(names, (600, 1190)):  # The picture of the worst is open, that of the other folded.
            self.write(f"scenarios/{name}.json", program.fling(start={**program.FLING["start"], "vx_px_per_s": speed}))
        self.expect(DISAGREED, "check", "--report", "check.html")
        (page,) = self.open({"file": str(self.folder / "check.html"), "actions": [["evaluate", f"[...document.querySelectorAll('summary')].some(each => each.textContent.includes('{names[1]}'))"], ["evaluate", FAULTS]]})
        self.assertEqual(page["values"], [True, []])

    def test_the_pointer_reads_the_nearest_value_and_pictures_are_saved(self):
        task, svg, png = self.drift(), self.folder / "drift.svg", self.folder / "drift.png"
        pointed = """(() => { const svg = [...document.querySelectorAll('.picture > svg')].find(each => each.checkVisibility()), plot = svg.querySelector('[data-x]'), box = plot.getBoundingClientRect();
          svg.dispatchEvent(new PointerEvent('pointermove', { clientX: box.left + %s * box.width, clientY: box.top + 5 }));
          return [document.querySelector('.picture output').textContent, svg.querySelector('.cross').getAttribute('d')]; })()"""
        huge = "document.querySelectorAll('[data-x]').forEach(each => (each.dataset.y = 'even|0 1 0 -1e300|px'))"
        (page,) = self.open({**task, "actions": [["evaluate", pointed % 0.5], ["evaluate", pointed % 5], ["evaluate", huge], ["evaluate", pointed % 0.5], ["download", ".picture > button:nth-of-type(1)", str(svg)],
                                                 ["download", ".picture > button:nth-of-type(2)", str(png)]]})
        self.assertEqual(page["errors"], [])
        (text, cross), (_, none), _, (far, _) = page["values"][:4]
        self.assertRegex(far, r"; px: −[\d.]+e\d+$")
        self.assertRegex(cross, r"^M[\d.]+,[\d.]+v[\d.]+M[\d.]+,[\d.]+h[\d.]+$")
        self.assertEqual(none, "")
        # It is farthest in the last row before the first bounce on the ground.
        found = re.fullmatch(r"distance from the exact fling; time, s: ([\d.]+); distance from the exact fling, px: [\d.]+", text)
        arcs = self.expect(AGREED, "drift", f"{FLINGS}/first-fling.json", "--json").json["runs"][0]["arcs"]
        self.assertAlmostEqual(float(found[1]), next(arc["last_step"] for arc in arcs if arc["ended_by"] == "ground") / 60, delta=0.005)
        self.assertTrue(svg.read_text(encoding="utf-8").startswith("<svg "))
        self.assertEqual(png.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_carries_only_what_it_shows(self):
        results = pathlib.Path(self.study("frame-rate")["file"]).read_text(encoding="utf-8")
        self.played("fling", program.fling(steps=600))
        runs = pathlib.Path(self.report("fling")["file"]).read_text(encoding="utf-8")
        for text in ("uplot\n", 'id="core"'):
            self.assertEqual((text in runs, text in results), (True, False), text)
        self.assertLess(len(runs), 420_000)
        self.assertLess(len(results), 1_000_000)

    def test_the_answer_and_its_picture_come_first_and_all_is_on_paper(self):
        tasks = [self.study("frame-rate"), self.grid()]
        ink = "getComputedStyle(document.querySelector('.picture text')).fill"
        tables = "[...document.querySelectorAll('.table')].map(each => each.checkVisibility({contentVisibilityAuto: true, visibilityProperty: true}) && each.getBoundingClientRect().height > 0)"
        for task in tasks:
            looks = {**task, "scheme": "dark", "actions": [["evaluate", DRAWN], ["evaluate", ink], ["evaluate", tables], ["paper"], ["evaluate", DRAWN], ["evaluate", ink], ["evaluate", tables]]}
            plain, page = self.open({**looks, "plain": True}, looks)
            self.assertEqual(plain["values"], page["values"])
            shown, dark, folded, _, printed, light, whole = plain["values"]
            self.assertEqual((shown, any(folded)), (1, False))
            self.assertGreater(printed, 0)
            self.assertTrue(all(whole) and whole)
            self.assertNotEqual(light, dark)
        places = "['h1', '.picture', 'details', '.good'].map(each => document.querySelector(each).getBoundingClientRect().top)"
        for size, most in (((1400, 900), 300), ((390, 844), 400)):
            (page,) = self.open({**tasks[0], "plain": True, "size": size, "actions": [["evaluate", places], ["evaluate", "document.body.innerText"]]})
            self.assertEqual(page["values"][0], sorted(page["values"][0]))
            self.assertLess(page["values"][0][1], most)
            self.assertIn("No rule of the study is broken.", page["values"][1])

    def test_hostile_text_stays_text(self):
        self.sweep("sweep", DRAWS, members=300, description=HOSTILE)
        (self.folder / "sweep.h5").rename(self.folder / "<img src=x onerror=alert(3)>.h5")
        self.expect(AGREED, "report", "<img src=x onerror=alert(3)>.h5", "-o", "sweep.html")
        self.write("scenarios/<img src=x onerror=alert(4)>.json", "{")
        self.expect(BAD_INPUT, "check", "--report", "check.html")
        for name in ("sweep", "check"):
            (page,) = self.open({"file": str(self.folder / f"{name}.html"), "bypass_csp": True, "actions": [["evaluate", "document.querySelectorAll('main img, main script').length"], ["evaluate", "document.querySelector('main').textContent"]]})
            self.assertEqual((page["values"][0], page["errors"], page["requests"]), (0, [], []))
            self.assertIn("<img src=x onerror=alert(", page["values"][1])
