"""Reports that hyrax-sim writes, opened in one Chromium by drive.mjs."""

import json
import os
import pathlib
import subprocess

from program import AGREED, ProgramTest

HOSTILE = "<script>alert(1)</script><img src=x onerror=alert(2)> </script><!-- \u2028 &amp; \"'"


class BrowserTest(ProgramTest):
    """Opens report pages in a browser."""

    @classmethod
    def setUpClass(cls):
        cls.browser = subprocess.Popen(["node", pathlib.Path(__file__).parent / "drive.mjs", os.environ["HYRAX_PAGE_PACKAGES"]], text=True,
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
