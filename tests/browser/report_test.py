"""The report page in Chromium: it replays what hyrax-sim played, bit for bit, and shows where a file differs."""

import json
import pathlib
import re

import h5py

import browser
import program
from altered import SAME_BITS, changed_steps, run_altered
from browser import HOSTILE
from program import AGREED, DISAGREED, SOURCE

# Fixed, jittered and recorded clocks, inputs, resizes, hard cases.
SCENARIOS = ["flings/first-fling", "flings/sprite-grows-and-shrinks", "flings/grab-and-throw", "flings/signed-zeros",
             "clocks/jitter-uniform", "clocks/jitter-normal", "clocks/missed-frames-ten-minutes",
             "clocks/trace-144-hz", "clocks/hour-at-60-hz", "recorded/throw-to-the-right",
             "recorded/shaken-and-dropped", "edges/times-after-steps", "edges/no-frame", "hard/any-jitter",
             "hard/window-of-no-size", "hard/sprite-far-larger-than-window", "hard/trace-of-extremes"]

# Of each run: the state hash of this browser, and how the replay came out.
EACH_RUN = """(async found => {
  const texts = selector => [...document.querySelectorAll(selector)].map(each => each.textContent);
  for (const index of document.querySelectorAll('#runs a').keys()) {
    const panel = document.querySelector(`#runs a[href='#run=${index}']`);
    panel.click();
    while (!panel.hasAttribute('aria-current')) await new Promise(requestAnimationFrame);
    await new Promise(requestAnimationFrame);
    found.push([texts('#made code').at(-1), ...texts('.verdicts .tile:first-child > :not(.label)')]);
  }
  return found;
})([])"""


def number(name):
    """The value of a readout, as JavaScript."""
    return f"Number(document.querySelector('[data-name={name}]').textContent.replace('−', '-').replaceAll(',', ''))"


# A display of 60 Hz that never waits, and the playground on it.
FAST = ["evaluate", "window.frameTime = performance.now(), window.requestAnimationFrame = f => setTimeout(() => f(frameTime += 1000 / 60))"]
PLAYGROUND = [FAST, ["click", "#mode-fling"]]
THROW = [[0.5, 0.95], [0.45, 0.7], [0.4, 0.5], [0.5, 0.4], [0.7, 0.35]]
LANDED = f"{number('y')} > 951.5 && Math.abs({number('vy')}) < 30"
AT_REST = "!('live' in document.documentElement.dataset)"
FLIGHTS = "[...document.querySelectorAll('#flights li')].map(each => each.textContent)"


class ReportTest(browser.BrowserTest):
    """Reports of runs, opened in a browser."""

    def test_replays_the_bits_of_every_kind_of_scenario_and_sees_what_was_changed_in_a_file(self):
        expected = {}
        for scenario in SCENARIOS:
            name = scenario.replace("/", "-")
            expected[name] = [self.hash_of(str(SOURCE / f"scenarios/{scenario}.json"), f"{name}.h5"), "same bits"]
        for name, document in (("start", program.fling()), ("long", program.fling(steps=20_000)), ("hash", program.fling())):
            expected[name] = [self.played(name, document), "differs"]
        for name, column, step in (("start", "vy", 0), ("long", "y", 9_001)):
            with h5py.File(self.folder / f"{name}.h5", "r+") as file:
                file[f"trajectory/{column}"][step] += 1e-9
            expected[name].append(f"first at step {step}")
        with h5py.File(self.folder / "hash.h5", "r+") as file:
            file.attrs["state_hash"] = "0" * 32
        expected["hash"].append("the state hash differs; no stored row does")
        self.expect(AGREED, "report", *(f"{name}.h5" for name in expected), "-o", "all.html")
        third = "document.querySelectorAll('#runs a')[2]"
        page, plain = self.open({"file": str(self.folder / "all.html"), "actions": [["evaluate", EACH_RUN], ["axe"], ["evaluate", f"{third}.focus()"], ["press", "Enter"], ["wait", f"{third}.hasAttribute('aria-current')"]]},
                                {"file": str(self.folder / "all.html"), "plain": True, "actions": [["evaluate", f"[{third}, document.getElementById('run=2')].map(each => each.checkVisibility())"]]})
        shown, faults, *_ = page["values"]
        self.assertEqual((faults, plain["values"]), ([], [[True, True]]))
        self.assertEqual(len(shown), len(expected))
        for (name, (state_hash, *verdict)), (found_hash, *found) in zip(expected.items(), shown):
            self.assertEqual([found_hash, *found[:len(verdict)]], [state_hash, *verdict], name)
        self.assertEqual((page["attributes"]["replay"], page["errors"], page["requests"]), ("differs", [], []))

    def test_a_page_of_another_core_plays_the_step_that_it_carries_or_says_why_not(self):
        self.played("fling", program.fling())
        by_its_own = re.compile(r'"no_replay": null,\s+"core_fingerprint": "\w+",\s+"core_step": null')
        for core in changed_steps():
            with self.subTest(core=core):
                page = self.folder / f"{core}.html"
                outcome = run_altered(core, "report", self.folder / "fling.h5", "-o", page)
                self.assertEqual(outcome.exit_code, AGREED, outcome)
                self.assertEqual(by_its_own.search(page.read_text(encoding="utf-8")) is not None, core in SAME_BITS)
        verdict = {"actions": [["evaluate", "document.getElementById('verdict').innerText"]]}
        pages = self.open(*({"file": str(self.folder / f"{core}.html"), **verdict} for core in ("gravity_by_one_ulp", "fling_adds")))
        self.assertEqual([page["attributes"]["replay"] for page in pages], ["differs", "none"])
        self.assertIn("is not complete", pages[1]["values"][0])

    def test_texts_of_charts_and_replay_keep_apart_and_the_test_sees_it(self):
        events = [{"step": step, "fling": {"vx_px_per_s": 900, "vy_px_per_s": -900}} for step in (30, 31, 90)]
        self.played("fling", program.fling(events=events))
        task = self.report("fling")
        sizes = ((1400, 900), (1100, 900), (800, 900), (375, 844))
        is_cut = ["evaluate", "(place => place.scrollWidth > place.clientWidth)(document.getElementById('contacts'))"]
        (page,) = self.open({**task, "actions": [action for size in sizes for action in (["look", {"size": size}], is_cut, ["evaluate", browser.CANVAS_FAULTS])]})
        for size, is_cut, (count, faults) in zip(sizes, page["values"][1::3], page["values"][2::3]):
            self.assertGreater(count, 20)
            self.assertEqual((is_cut, faults), (False, []), size)
        for place in ("3", "-30"):
            (page,) = self.open({**task, "actions": [["evaluate", browser.CANVAS_FAULTS.replace("at = x", f"at = {place}")]]})
            self.assertNotEqual(page["values"][0][1], [])

    def test_a_run_that_becomes_non_finite_says_so(self):
        run_altered("bounce_explodes", "run", "scenarios/flings/first-fling.json", "-o", self.folder / "broken.h5",
                    "--report", self.folder / "broken.html")
        (page,) = self.open({"file": str(self.folder / "broken.html"), "actions": [["evaluate", "document.querySelector('.cause').textContent"]]})
        self.assertEqual(page["values"], ["vx is infinite from step 120 of 600 (2.00 s); the run ended there"])
        self.assertEqual(page["errors"], [])

    def test_what_is_flung_has_the_bits_verdict_charts_and_flights_of_its_file(self):
        self.played("fling", program.fling())
        flung, again, touched, rows = (self.folder / name for name in ("flung.json", "again.json", "touched.json", "rows.csv"))
        stage = ["evaluate", "document.querySelector('.columns').offsetTop"]
        task, row = self.report("fling"), number("row")
        page, by_touch = self.open({**task, "actions": [
            *PLAYGROUND, stage, ["wait", LANDED], ["evaluate", FLIGHTS], ["mouse", "#replay", THROW], ["wait", AT_REST], stage,
            ["evaluate", FLIGHTS], ["download", "#download-scenario", str(flung)], ["download", "#chart-position button", str(rows)],
            ["evaluate", "document.getElementById('verdict').innerText"], ["evaluate", "document.querySelectorAll('#contacts tbody tr').length"],
            ["press", "a"], ["wait", f"{row} > 20 && {number('t')} < 3"], ["download", "#download-scenario", str(again)]]}, {**task, "actions": [
            *PLAYGROUND, ["wait", LANDED], ["touch", "#replay", THROW], ["wait", f"window.released ??= {row}, {row} > window.released + 20"],
            ["download", "#download-scenario", str(touched)]]})
        self.assertEqual((page["errors"], by_touch["errors"]), ([], []))
        _, _, stage_before, _, flights_before, _, _, stage_after, flights, _, _, verdict, contacts, *_ = page["values"]
        self.assertEqual((stage_after, flights_before), (stage_before, []))

        documents = {path: json.loads(path.read_text(encoding="utf-8")) for path in (flung, again, touched)}
        for path, document in documents.items():
            self.assertEqual(self.hash_of(path.name, f"{path.stem}.h5"), document["expect"]["state_hash"])
        for document in (documents[flung], documents[touched]):
            self.assertEqual({kind for event in document["events"] for kind in event if kind != "step"}, {"grab", "place", "release"})
            release, = (event["release"] for event in document["events"] if "release" in event)
            for key, (start, end), side in zip(release, zip(THROW[0], THROW[-1]), document["window"].values()):
                self.assertAlmostEqual(release[key], (end - start) * side * 10, delta=20)  # In 100 ms, to whole pixels.
        thrown, release = documents[again], next(event["release"] for event in documents[flung]["events"] if "release" in event)
        self.assertEqual({name: thrown["start"][name] for name in release}, release)

        (played,) = self.expect(AGREED, "run", flung, "-o", "flung.h5", "--json").json["runs"]
        total, bounces = (sum(played[counts].values()) for counts in ("contacts", "bounces"))
        self.assertGreater(total, 1)
        self.assertEqual(contacts, total)
        self.assertIn(f"Bounces\n{bounces}\n", verdict.replace("\n\n", "\n"))
        self.assertIn("same bits", verdict)
        self.assertNotIn("Golden", verdict)
        error = self.expect(AGREED, "drift", "flung.h5", "--json").json["runs"][0]["worst"]["truncation_px"]
        shown = float(re.search(r"Truncation error\s+([\d.,]+) px", verdict)[1].replace(",", ""))
        self.assertAlmostEqual(shown / error, 1, delta=0.006)
        with h5py.File(self.folder / "flung.h5") as file:
            last = [file[f"trajectory/{axis}"][-1] for axis in "xy"]
        self.assertEqual([float(each) for each in rows.read_text(encoding="utf-8").splitlines()[-1].split(",")[2:4]], last)

        distances = dict(re.fullmatch(r"(.+) ([\d.,]+) px", text).groups() for text in flights)
        self.assertEqual(list(distances), ["24 Hz", "60 Hz", "144 Hz", "240 Hz", "exact", "yours"])
        self.assertEqual(distances["exact"], "0.0")
        self.played("same", {**thrown, "clock": {"rate_hz": 144}, "duration_s": 20, "expect": {}})
        whole = self.expect(AGREED, "drift", "same.h5", "--json").json["runs"][0]["whole"]
        self.assertAlmostEqual(float(distances["144 Hz"].replace(",", "")), whole["end_px"], delta=0.06)

    def test_what_sliders_change_is_drawn_and_saved_as_a_scenario_of_the_same_bits(self):
        events = [{"step": 30, "fling": {"vx_px_per_s": 900, "vy_px_per_s": -900}}, {"at_s": 1.5, "hitch": {"dt_s": 0.2}},
                  {"step": 150, "resize": {"window": {"width_px": 1500, "height_px": 900}}}, {"step": 200, "grab": {}},
                  {"step": 210, "release": {"vx_px_per_s": -900, "vy_px_per_s": -900}}, {"step": 299, "stop": {}}]
        clocks = {"fixed": {"rate_hz": 60}, "jittered": {"dt_s": 1 / 75, "jitter": {"kind": "normal", "sigma_s": 0.002, "seed": 2**64 - 1}},
                  "trace": {"dt_s": [0.01, 0.02, 0.03] * 100}}
        change = "for (const [key, value] of %s) { const slider = document.getElementById(`what-if-${key}`); slider.value = value; slider.dispatchEvent(new Event('input')); }"
        shown = "document.getElementById('not-the-file').checkVisibility() && document.getElementById('what-if-note').textContent"
        for name, clock in clocks.items():
            self.played(name, program.fling(name=name, clock=clock, events=events, parameters={"GRAVITY": 700, "REST_THRESHOLD": 30}))
            saved = [self.folder / f"{name}-{part}.json" for part in ("own", "slower", "moon")]
            (page,) = self.open({**self.report(name), "actions": [
                ["evaluate", "document.getElementById('what-if').open = true"], ["download", "#save-scenario", str(saved[0])], ["evaluate", shown],
                ["evaluate", change % '[["rate", 41], ["speed", 1234], ["angle", 61]]'], ["wait", shown], ["download", "#save-scenario", str(saved[1])],
                ["evaluate", change % '[["GRAVITY", 320], ["RESTITUTION", 0.75], ["AIR_DRAG", 0.9995], ["GROUND_FRICTION", 0.5]]'],
                ["evaluate", "new Promise(requestAnimationFrame)"], ["evaluate", shown], ["download", "#save-scenario", str(saved[2])],
                ["axe"], ["click", "#file-run"], ["evaluate", shown]]})
            self.assertEqual((page["attributes"]["replay"], page["errors"], page["values"][2], page["values"][-3:]), ("agrees", [], False, [[], None, False]), name)
            documents = [json.loads(path.read_text(encoding="utf-8")) for path in saved]
            for path, document in zip(saved, documents):
                self.expect(AGREED, "validate", path)
                self.assertEqual(self.hash_of(path.name, f"{path.stem}.h5"), document["expect"]["state_hash"], path)
            own, slower, moon = documents
            self.assertEqual([own["parameters"], own["clock"], len(own["events"])], [{"GRAVITY": 700, "REST_THRESHOLD": 30}, clock, 6])
            self.assertEqual([slower["parameters"], slower["clock"]["rate_hz"]], [own["parameters"], 41])
            self.assertEqual(moon["parameters"], {"GRAVITY": 320, "REST_THRESHOLD": 30, "RESTITUTION": 0.75, "AIR_DRAG": 0.9995, "GROUND_FRICTION": 0.5})
            with h5py.File(self.folder / f"{name}-moon.h5") as changed, h5py.File(self.folder / f"{name}.h5") as file:
                ends = [[run[f"trajectory/{axis}"][-1] for axis in "xy"] for run in (changed, file)]
            away, error = (float(each.replace(",", "")) for each in re.search(r"px, ([\d.,]+) px from.*error ([\d.,]+) px,", page["values"][8]).groups())
            self.assertAlmostEqual(away, sum((a - b) ** 2 for a, b in zip(*ends)) ** 0.5, delta=0.006 * away)
            worst = self.expect(AGREED, "drift", f"{name}-moon.h5", "--json").json["runs"][0]["worst"]["truncation_px"]
            self.assertAlmostEqual(error, worst, delta=0.006 * worst)

    def test_a_fling_in_a_page_of_a_run_with_parameters_has_them(self):
        self.write("moon.json", program.fling(parameters={"GRAVITY": 300}))
        self.expect(AGREED, "run", "moon.json", "--report", "moon.html")
        flung = self.folder / "flung.json"
        (page,) = self.open({"file": str(self.folder / "moon.html"), "actions": [*PLAYGROUND, ["wait", f"{number('row')} > 30"], ["download", "#download-scenario", str(flung)],
                                                                ["evaluate", "document.getElementById('name').textContent"]]})
        document = json.loads(flung.read_text(encoding="utf-8"))
        self.assertEqual((page["attributes"]["replay"], page["attributes"].get("core"), page["values"][-1], document["parameters"]), ("agrees", None, "Your fling", {"GRAVITY": 300}))
        self.assertEqual(self.hash_of("flung.json", "flung.h5"), document["expect"]["state_hash"])

    def test_names_and_descriptions_are_text(self):
        self.played("fling", program.fling(description=HOSTILE))
        (self.folder / "fling.h5").rename(self.folder / "<img src=x onerror=alert(3)>.h5")
        self.expect(AGREED, "report", "<img src=x onerror=alert(3)>.h5", "-o", "page.html")
        (page,) = self.open({"file": str(self.folder / "page.html"), "bypass_csp": True, "actions": [
            ["evaluate", "document.getElementById('description').textContent"],
            ["evaluate", "document.querySelectorAll('body img').length"]]})
        self.assertEqual(page["values"], [HOSTILE, 0])
        self.assertEqual((page["errors"], page["requests"]), ([], []))

    def test_a_million_rows(self):
        self.played("long", program.fling(name="long", steps=1_000_000, clock={
            "rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.2, "seed": 3}}))
        frames = """(async () => {
            const times = [], slider = document.getElementById('time');
            for (let i = 0; i < 120; ++i) {
              slider.value = Math.round(slider.max * i / 119);
              const begin = performance.now();
              slider.dispatchEvent(new Event('input'));
              await new Promise(requestAnimationFrame);
              times.push(performance.now() - begin);
            }
            times.sort((a, b) => a - b);
            return [times[60], times[114]];
          })()"""
        zoomed = ["evaluate", "[...document.querySelectorAll('.u-select')].map(each => each.style.width)"]
        task = self.report("long")
        # Of a page that never gets its turn again, what it shows first: the picture.
        text = pathlib.Path(task["file"]).read_text(encoding="utf-8")
        stopped = self.write("stopped.html", text.replace("<body>", "<body><script>setTimeout = () => 0; document.documentElement.dataset.ready = '';</script>", 1))
        (still,) = self.open({"file": str(self.folder / stopped), "actions": [["evaluate", "[...document.querySelectorAll('#verdict > svg')].map(each => each.getBoundingClientRect().height > 100)"]]})
        self.assertEqual(still["values"], [[True]])
        (page,) = self.open({**task, "actions": [
            ["wait", "performance.getEntriesByName('ready').length > 0"],
            ["evaluate", "performance.getEntriesByName('first-contentful-paint')[0].startTime"],
            ["evaluate", "performance.getEntriesByName('ready')[0].startTime"], ["evaluate", frames],
            zoomed, ["mouse", "#chart-overview-speed .u-over", [[0.3, 0.5], [0.4, 0.5], [0.6, 0.5]]], zoomed]})
        _, first, ready, (median, late), before, _, after = page["values"]
        print(f"1,000,001 rows: first paint {first:.0f} ms, all drawn {ready:.0f} ms, scrub: median {median:.1f} ms, 95 % {late:.1f} ms")
        self.assertEqual(page["attributes"]["replay"], "agrees")
        self.assertLess(first, 0.65 * ready)
        self.assertNotEqual(before, after)

    def test_of_a_core_that_is_not_its_own_it_plays_the_step_that_it_carries(self):
        self.played("fling", program.fling())
        task = self.report("fling")
        page = pathlib.Path(task["file"]).read_text(encoding="utf-8")
        step = (SOURCE / "golden/core/step.txt").read_text(encoding="utf-8")
        tasks = []
        for name, text in (("whole", step), ("damaged", step.replace("1200", "1201"))):
            carrying = page.replace('"core_step": null', f'"core_step": {json.dumps(text)}')
            self.assertNotEqual(carrying, page)
            self.write(f"{name}.html", carrying)
            tasks.append({**task, "file": str(self.folder / f"{name}.html"), "actions": [
                ["evaluate", "document.getElementById('stage-note').textContent"], ["evaluate", "document.getElementById('mode-fling').disabled"]]})
        whole, damaged = self.open(*tasks)
        self.assertEqual((whole["attributes"]["replay"], *whole["values"]), ("agrees", "", False))
        self.assertEqual((damaged["attributes"]["replay"], damaged["values"][1]), ("none", True))
        self.assertIn("No replay: this browser calculates the step of the core", damaged["values"][0])

    def test_without_javascript_it_shows_name_verdict_and_path(self):
        self.played("golden", program.fling())
        self.write("fling.json", program.fling(description=HOSTILE, start={**program.FLING["start"], "vx_px_per_s": 1201}, expect={"final_x_px": [0, 1]}))
        self.expect(DISAGREED, "run", "fling.json", "-o", "fling.h5")
        looks = {"plain": True, "actions": [["evaluate", "document.body.innerText"], ["evaluate", "document.querySelectorAll('[data-series=\"path of the centre\"]').length"],
                                            ["evaluate", "getComputedStyle(document.querySelector('main')).display"]]}
        (page,) = self.open({**self.report("fling", "--against", "golden.h5"), **looks})
        text, paths, main = page["values"]
        self.assertEqual((paths, main), (1, "none"))
        for line in ("fling", "Differs from the golden file: ", "does not hold: final_x_px", "300 steps"):
            self.assertIn(line, text)

    def test_on_paper_it_is_light_and_whole(self):
        self.played("fling", program.fling())
        shade = """(() => { const canvas = document.getElementById('replay'), [r] = canvas.getContext('2d').getImageData(canvas.width / 2, 3, 1, 1).data;
                     return [r, Number(getComputedStyle(document.body).backgroundColor.match(/\\d+/)[0])]; })()"""
        widths = "[...document.querySelectorAll('.u-wrap, #replay')].map(each => each.getBoundingClientRect()).every(box => box.right <= 690)"
        (page,) = self.open({**self.report("fling"), "scheme": "dark", "actions": [
            ["evaluate", shade], ["paper"], ["evaluate", shade], ["evaluate", widths]]})
        dark, _, light, fits = page["values"]
        self.assertLess(max(dark), 60)
        self.assertGreater(min(light), 200)
        self.assertTrue(fits)

    def test_a_page_that_differs_begins_with_why_both_runs_and_their_distance(self):
        self.played("golden", program.fling())
        self.played("fling", program.fling(start={**program.FLING["start"], "vx_px_per_s": 1201}))
        order = """['.cause', '#replay', '#chart-distance', '.verdicts', '.details'].map(each => document.querySelector(each)?.getBoundingClientRect())
                   .map(box => box && [box.top, box.left])"""
        wide, narrow = {"size": (1400, 900)}, {"size": (375, 844)}
        actions = [["look", wide], ["evaluate", order], ["look", narrow], ["evaluate", order]]
        same, differs = self.open({**self.report("golden"), "actions": actions}, {**self.report("fling", "--against", "golden.h5"), "actions": [
            *actions, ["evaluate", "document.querySelectorAll('.divergence').length === document.querySelectorAll('figure.chart').length"],
            ["download", "#chart-distance button", str(self.folder / "distance.csv")], ["evaluate", "document.getElementById('farthest').innerText"]]})
        farthest = float(re.match(r"Farthest: ([\d.]+) px at", differs["values"][-1])[1])
        measured = self.hyrax_sim("diff", "golden.h5", "fling.h5", "--json").json["max_px"]
        self.assertAlmostEqual(farthest, measured, delta=0.006 * measured)
        _, beside, _, below = same["values"]
        self.assertEqual((beside[0], below[0]), (None, None))
        self.assertLess(beside[3][0], beside[1][0])
        for places in (differs["values"][1], differs["values"][3]):
            tops = [top for top, _ in places]
            self.assertLess(max(tops[:3]), tops[3])
            self.assertLess(tops[3], tops[4])
        self.assertTrue(differs["values"][4])
        rows = (self.folder / "distance.csv").read_text(encoding="utf-8").splitlines()
        self.assertAlmostEqual(float(rows[2].split(",")[2]), 1 / 60, delta=1e-3)

    def test_accessibility_rules_hold_and_fail_on_a_control(self):
        self.played("golden", program.fling())
        self.played("fling", program.fling(start={**program.FLING["start"], "vx_px_per_s": 1201}))
        looks = ({"scheme": "dark", "size": (390, 844)}, {"scheme": "dark"}, {"scheme": "light"})
        spoilt = "play.removeAttribute('aria-label'), play.removeAttribute('title'), title.style.color = '#ccc'"
        (page,) = self.open({**self.report("fling", "--against", "golden.h5"), "actions": [
            *(action for look in looks for action in (["look", look], ["axe"])), ["evaluate", spoilt], ["axe"]]})
        self.assertEqual((page["values"][1:6:2], page["errors"]), ([[]] * 3, []))
        self.assertEqual({fault.split(":")[0] for fault in page["values"][-1]}, {"button-name", "color-contrast"})

    def test_tab_goes_through_the_controls_in_order(self):
        self.played("fling", program.fling())
        (page,) = self.open({**self.report("fling"), "actions": [["tab", 10]]})
        self.assertEqual(page["values"][0], ["mode-replay", "mode-fling", "replay", "first", "back", "play", "forward",
                                             "speed", "time", "Change frame rate, start and parameters"])
