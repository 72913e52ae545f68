"""Shared by the tests of `drift`: a flight, and how it is run."""

from program import AGREED, ProgramTest, fling


def flight(rate_hz, steps=None, **changes):
    """A second of flight from vy = -900 px/s that meets nothing."""
    return fling(window={"width_px": 100000, "height_px": 100000},
                 start={"x_px": 4000, "y_px": 50000, "vx_px_per_s": 0, "vy_px_per_s": -900},
                 clock={"rate_hz": rate_hz}, steps=steps or rate_hz, **changes)


class DriftTest(ProgramTest):
    """The commands that the tests share."""

    def drift(self, *arguments):
        return self.expect(AGREED, "drift", *arguments, "--json").json["runs"]

    def drift_of(self, document, *arguments):
        return self.drift(self.write("scenario.json", document), *arguments)[0]

    def errors(self, run):
        """The part that does not depend on the machine's speed."""
        return {key: run[key] for key in ("whole", "arcs", "contacts", "skipped_arcs", "worst", "effective_restitution",
                                          "margin", "differing_steps", "reference_energy", "unlisted_energy")}
