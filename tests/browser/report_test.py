"""The report page in Chromium: it replays what hyrax-sim played, bit for bit, and shows where a file differs."""

import json
import os
import pathlib
import shutil
import subprocess

import h5py

import program
from program import AGREED, DISAGREED, SOURCE, ProgramTest

HERE = pathlib.Path(__file__).parent

# Fixed, jittered and recorded clocks, inputs, resizes, hard cases.
SCENARIOS = ["flings/first-fling", "flings/sprite-grows-and-shrinks", "flings/grab-and-throw", "flings/signed-zeros",
             "clocks/jitter-uniform", "clocks/jitter-normal", "clocks/missed-frames-ten-minutes",
             "clocks/trace-144-hz", "clocks/hour-at-60-hz", "recorded/throw-to-the-right",
             "recorded/shaken-and-dropped", "edges/times-after-steps", "edges/no-frame", "hard/any-jitter",
             "hard/window-of-no-size", "hard/sprite-far-larger-than-window", "hard/trace-of-extremes"]

HOSTILE = "<script>alert(1)</script><img src=x onerror=alert(2)> </script><!-- \u2028 &amp; \"'"


def number(name):
    """The value of a readout, as JavaScript."""
    return f"Number(document.querySelector('[data-name={name}]').textContent.replace('−', '-'))"


class ReportTest(ProgramTest):
    """Reports of runs, opened in a browser."""

    @classmethod
    def setUpClass(cls):
        cls.browser = subprocess.Popen(["node", HERE / "drive.mjs", os.environ["HYRAX_PAGE_PACKAGES"]], text=True,
                                       stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    @classmethod
    def tearDownClass(cls):
        cls.browser.communicate(timeout=30)

    def open(self, *tasks):
        """Performs the tasks of drive.mjs; fails if one of them does."""
        print(json.dumps(tasks), file=self.browser.stdin, flush=True)
        results = json.loads(self.browser.stdout.readline())
        for task, result in zip(tasks, results):
            self.assertNotIn("failed", result, task["file"])
        return results

    def report(self, name, *options):
        """Writes the report of a trajectory in the folder; returns a task that opens it."""
        outcome = self.expect(AGREED, "report", f"{name}.h5", *options, "-o", f"{name}.html", "--json")
        self.assertEqual(outcome.json, {"output": f"{name}.html"})
        return {"file": str(self.folder / f"{name}.html")}

    def played(self, name, document):
        """Runs a scenario; returns its state hash."""
        path = self.write(f"{name}.json", document)
        return self.hash_of(path, f"{name}.h5")

    def hash_of(self, scenario, output):
        """Runs a scenario file; returns its state hash."""
        return self.expect(AGREED, "run", scenario, "-o", output, "--json").json["runs"][0]["state_hash"]

    def test_replays_the_bits_of_every_kind_of_scenario_without_errors_or_requests(self):
        tasks, hashes = [], []
        for scenario in SCENARIOS:
            name = scenario.replace("/", "-")
            hashes.append(self.hash_of(str(SOURCE / f"scenarios/{scenario}.json"), f"{name}.h5"))
            tasks.append(self.report(name))
        for scenario, state_hash, page in zip(SCENARIOS, hashes, self.open(*tasks)):
            self.assertEqual(page["attributes"]["replay"], "agrees", scenario)
            self.assertEqual(page["attributes"]["stateHash"], state_hash, scenario)
            self.assertEqual((page["errors"], page["requests"]), ([], []), scenario)

    def test_asks_for_nothing_where_no_policy_forbids_it(self):
        self.played("fling", program.fling())
        (page,) = self.open({**self.report("fling"), "bypass_csp": True})
        self.assertEqual((page["errors"], page["requests"]), ([], []))

    def test_a_changed_row_differs_at_its_step(self):
        self.played("fling", program.fling())
        tasks = []
        for step, column in ((123, "x"), (0, "vy"), (300, "dt"), (77, "t")):
            name = f"changed-{step}"
            shutil.copy(self.folder / "fling.h5", self.folder / f"{name}.h5")
            with h5py.File(self.folder / f"{name}.h5", "r+") as file:
                values = file[f"trajectory/{column}"]
                values[step] = float.fromhex((values[step] + 2 ** -40).hex())
            tasks.append(self.report(name))
        for step, page in zip((123, 0, 300, 77), self.open(*tasks)):
            self.assertEqual(page["attributes"]["replay"], "differs", step)
            self.assertEqual(page["attributes"]["firstDifference"], str(step))

    def test_a_changed_row_of_a_long_run_differs_at_its_step(self):
        self.played("long", program.fling(name="long", steps=20_000))
        task = self.report("long")
        with h5py.File(self.folder / "long.h5", "r+") as file:
            file["trajectory/y"][9_001] += 1e-9
        shutil.copy(self.folder / "long.h5", self.folder / "changed.h5")
        same, changed = self.open(task, self.report("changed"))
        self.assertEqual(same["attributes"]["replay"], "agrees")
        self.assertEqual(changed["attributes"]["replay"], "differs")
        self.assertEqual(changed["attributes"]["firstDifference"], "9001")
        self.assertLess((self.folder / "long.html").stat().st_size, 1_000_000)

    def test_a_changed_hash_alone_differs_at_no_step(self):
        self.played("fling", program.fling())
        with h5py.File(self.folder / "fling.h5", "r+") as file:
            file.attrs["state_hash"] = "0" * 32
        (page,) = self.open(self.report("fling"))
        self.assertEqual(page["attributes"]["replay"], "differs")
        self.assertNotIn("firstDifference", page["attributes"])

    def test_a_difference_from_the_golden_file_is_marked(self):
        self.played("golden", program.fling())
        self.played("fling", program.fling(start={**program.FLING["start"], "vx_px_per_s": 1201}))
        task = {**self.report("fling", "--against", "golden.h5"), "actions": [
            ["evaluate", "document.querySelector('.verdicts').innerText"],
            ["evaluate", "document.querySelectorAll('.divergence').length"]]}
        (page,) = self.open(task)
        self.assertEqual(page["attributes"]["replay"], "agrees")
        self.assertIn("from step 0 in vx", page["values"][0])
        self.assertEqual(page["values"][1], 5)

    def test_a_failed_check_has_a_page_of_the_worst_run(self):
        path, = self.project("fling")
        self.write(path, program.fling(start={**program.FLING["start"], "vx_px_per_s": 1201}))
        self.expect(DISAGREED, "check", "--summary", "check.md")
        self.assertIn("](<check.html>)", (self.folder / "check.md").read_text())
        (page,) = self.open({"file": str(self.folder / "check.html"), "actions": [
            ["evaluate", "document.querySelector('.verdicts').innerText"]]})
        self.assertEqual(page["attributes"]["replay"], "agrees")
        self.assertIn("from step 0 in vx", page["values"][0])

    def test_plays_steps_scrubs_and_opens_a_link(self):
        self.played("fling", program.fling())
        row = "document.querySelector('[data-name=row]').textContent"
        (page,) = self.open({**self.report("fling"), "hash": "#step=120", "actions": [
            ["evaluate", row], ["press", "ArrowRight"], ["evaluate", row], ["press", "Shift+ArrowLeft"],
            ["evaluate", row], ["press", "["], ["evaluate", row], ["press", "End"], ["evaluate", row],
            ["evaluate", "time.value = 40; time.dispatchEvent(new Event('input'))"], ["evaluate", row],
            ["press", "Space"], ["wait", f"Number({row}) > 50"], ["press", "Space"],
            ["wait", "/^#step=\\d+$/.test(location.hash) && location.hash !== '#step=120'"]]})
        values = page["values"]
        self.assertEqual([values[at] for at in (0, 2, 4, 6, 8, 10)], ["120", "121", "111", "76", "300", "40"])
        self.assertEqual(page["errors"], [])

    def test_what_is_flung_by_mouse_replays_to_the_same_hash(self):
        self.played("fling", program.fling())
        down = str(self.folder / "flung.json")
        (page,) = self.open({**self.report("fling"), "actions": [
            ["click", "#mode-fling"],
            ["wait", f"{number('y')} > 951.5 && Math.abs({number('vy')}) < 30"],
            ["mouse", [[0.5, 0.95], [0.45, 0.7], [0.4, 0.5], [0.5, 0.4], [0.7, 0.35]]],
            ["wait", f"window.released ??= {number('row')}, {number('row')} > window.released + 20"],
            ["download", "#download-scenario", down]]})
        self.assertEqual(page["errors"], [])
        document = json.loads(pathlib.Path(down).read_text(encoding="utf-8"))
        kinds = {kind for event in document["events"] for kind in event if kind != "step"}
        self.assertEqual(kinds, {"grab", "place", "release"})
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

    def test_saves_a_chart_as_csv(self):
        self.played("fling", program.fling())
        target = self.folder / "position.csv"
        self.open({**self.report("fling"), "actions": [["download", "#chart-position button", str(target)]]})
        lines = target.read_text(encoding="utf-8").splitlines()
        self.assertEqual(len(lines), 302)
        self.assertEqual(lines[:2], ['"step","t_s","x (px)","y (px)"', "0,0,1100,500"])


if __name__ == "__main__":
    program.main()
