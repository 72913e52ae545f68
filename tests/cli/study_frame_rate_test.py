#!/usr/bin/python3
"""`study frame-rate`: the end position of one fling on every display, and the score."""

import h5py

from program import AGREED, ProgramTest, fling, main

RATES = (24, 60, 144, 240)


class FrameRate(ProgramTest):
    """The study and its files."""

    def study(self, *arguments):
        """Runs the quick study without figures; its output goes into out/."""
        return self.expect(AGREED, "study", "frame-rate", "--quick", "--no-figures", "--gate", "-o", "out", *arguments)

    def test_the_papers_resting_places_are_those_of_run(self):
        places = {landing["rate_hz"]: landing["x_px"] for landing in self.study("--json").json["landings"]
                  if (landing["method"], landing["clock"]) == ("paper", "steady")}
        self.assertEqual(tuple(places), RATES)
        for rate_hz, x_px in places.items():
            start = {"x_px": 100, "y_px": 100, "vx_px_per_s": 900, "vy_px_per_s": -1200}
            self.write("fling.json", fling(start=start, clock={"rate_hz": rate_hz}, steps=16 * rate_hz))
            run = self.expect(AGREED, "run", "fling.json", "--json").json["runs"][0]
            self.assertAlmostEqual(run["final"]["x_px"], x_px, delta=1e-9)

    def test_the_score_is_what_its_definition_says(self):
        scores = self.study("--json").json["scores"]
        self.assertEqual(len(scores), 6)
        with h5py.File(self.folder / "out/frame-rate.h5") as file:
            table = {name: file[f"landings/{name}"][:] for name in ("method", "clock", "rate", "fling", "x", "across")}
        for score in scores:
            here = (table["method"] == score["method"].encode()) & (table["clock"] == score["clock"].encode())
            flings = set(table["fling"][here])
            spread = way = 0.0
            for number in flings:
                one = here & (table["fling"] == number)
                spread += (table["x"][one].max() - table["x"][one].min()) / len(flings)
                way += table["across"][one & (table["rate"] == 60)][0] / len(flings)
            self.assertAlmostEqual(score["score"], 100 * max(0, 1 - spread / way), delta=1e-9)

    def test_by_time_it_depends_less_on_the_display(self):
        scores = {(score["method"], score["clock"]): score["score"] for score in self.study("--json").json["scores"]}
        for clock in ("steady", "jittered", "missing"):
            self.assertGreater(scores["normalised-drag", clock], scores["paper", clock])

    def test_it_is_the_same_every_time(self):
        for name in ("a", "b"):
            self.expect(AGREED, "study", "frame-rate", "--quick", "--no-figures", "-o", name)
        self.assertEqual((self.folder / "a/frame-rate.h5").read_bytes(), (self.folder / "b/frame-rate.h5").read_bytes())

    def test_four_pictures(self):
        self.expect(AGREED, "study", "frame-rate", "--quick", "-o", "out")
        self.assertEqual([name for name in self.names("out") if name.endswith(".svg")],
                         ["frame-rate-fan-by-time.svg", "frame-rate-fan.svg", "frame-rate-flings.svg", "frame-rate.svg"])
        self.assertIn("240 Hz", (self.folder / "out/frame-rate-fan.svg").read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
