"""Shared by the tests of `drift`: the shape of its document, a flight, and how it is run."""

from program import AGREED, NUMBER, Maybe, ProgramTest, fling

ARC = {
    "first_step": int, "last_step": int, "duration_s": NUMBER, "ended_by": str, "implementation_px": NUMBER,
    "truncation_px": NUMBER, "model_px": NUMBER, "energy_drift_rel_max": NUMBER,
    "energy_drift_rel_end": NUMBER, "energy_drift_slope_px_per_s": Maybe(NUMBER), "energy_drift_slope_per_s": Maybe(NUMBER), "energy_drift_max": NUMBER,
    "energy_drift_end": NUMBER, "exact_law_px": NUMBER,
    "energy_parts": {"gravity": NUMBER, "drag": NUMBER}, "gsl_vs_closed_px": Maybe(NUMBER),
}
WHOLE = {
    "end_px": NUMBER, "max_px": NUMBER, "max_px_step": int, "energy_end_px": NUMBER, "energy_max_px": NUMBER,
    "secular_px_per_s": Maybe(NUMBER), "contacts_differ_from": Maybe(int), "reference": str,
}
CONTACT = {
    "step": int, "wall": str, "time_error_s": Maybe(NUMBER), "overshoot_px": NUMBER, "energy_jump_rel": NUMBER,
    "effective_restitution": Maybe(NUMBER),
    "energy_parts": {"flight": NUMBER, "lift": NUMBER, "bounce": NUMBER, "friction": NUMBER, "rest": NUMBER},
}


def flight(rate_hz, steps=None, **changes):
    """A second of flight from vy = -900 px/s that meets nothing."""
    return fling(window={"width_px": 100000, "height_px": 100000},
                 start={"x_px": 4000, "y_px": 50000, "vx_px_per_s": 0, "vy_px_per_s": -900},
                 clock={"rate_hz": rate_hz}, steps=steps or rate_hz, **changes)


class DriftTest(ProgramTest):
    """The commands that the tests share."""

    def drift(self, *arguments):
        """The measured runs, as JSON."""
        return self.expect(AGREED, "drift", *arguments, "--json").json["runs"]

    def drift_of(self, document, *arguments):
        """The one measured run of a document."""
        return self.drift(self.write("scenario.json", document), *arguments)[0]

    def errors(self, run):
        """The part that does not depend on the machine's speed."""
        return {key: run[key] for key in ("whole", "arcs", "contacts", "skipped_arcs", "worst", "effective_restitution",
                                          "margin", "differing_steps", "reference_energy", "unlisted_energy")}
