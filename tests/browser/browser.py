"""Reports that hyrax-sim writes, opened in one Chromium by drive.mjs."""

import json
import os
import pathlib
import subprocess

from program import AGREED, ProgramTest

HOSTILE = "<script>alert(1)</script><img src=x onerror=alert(2)> </script><!-- \u2028 &amp; \"'"

# Texts that canvases draw on one another or beyond their edge, found while all are drawn again.
CANVAS_FAULTS = """(async () => {
  const drawn = new Map(), {prototype} = CanvasRenderingContext2D, {fillText, clearRect} = prototype;
  prototype.clearRect = function (...box) {
    drawn.delete(this.canvas);
    return clearRect.apply(this, box);
  };
  prototype.fillText = function (text, x, y, ...most) {
    const at = x, size = this.measureText(text), place = this.getTransform();
    const corners = [[at - size.actualBoundingBoxLeft, y - size.actualBoundingBoxAscent], [at + size.actualBoundingBoxRight, y + size.actualBoundingBoxDescent]]
      .map(([cornerX, cornerY]) => new DOMPoint(cornerX, cornerY).matrixTransform(place));
    const [left, right] = corners.map(each => each.x).sort((a, b) => a - b), [top, bottom] = corners.map(each => each.y).sort((a, b) => a - b);
    drawn.set(this.canvas, [...(drawn.get(this.canvas) ?? []), {text, left, right, top, bottom}]);
    return fillText.call(this, text, x, y, ...most);
  };
  dispatchEvent(new Event('beforeprint'));
  await new Promise(done => setTimeout(done, 300));
  const faults = [], meets = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
  for (const [canvas, texts] of drawn)
    texts.forEach((box, i) => {
      if (box.left < -1 || box.right > canvas.width + 1 || box.top < -1 || box.bottom > canvas.height + 1) faults.push(`cut: ${box.text}`);
      for (const other of texts.slice(0, i)) if (meets(box, other) && JSON.stringify(box) !== JSON.stringify(other)) faults.push(`overlap: ${box.text} and ${other.text}`);
    });
  return [[...drawn.values()].flat().length, faults];
})()"""


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
