"""One flipped bit in any dataset of a golden file is found by `check`. Attributes: check_pairs_test, and the store's refusals."""

import json
import shutil

import h5py
import numpy

from program import AGREED, ProgramTest, fling

# Rows and all inputs; and blocks, of a jittered run too long for rows.
SHORT = fling(events=[
    {"step": 20, "fling": {"vx_px_per_s": -900, "vy_px_per_s": -900}},
    {"step": 40, "hitch": {"dt_s": 0.25}},
    {"step": 60, "grab": {}},
    {"step": 61, "place": {"x_px": 640, "y_px": 200}},
    {"step": 70, "release": {"vx_px_per_s": 700, "vy_px_per_s": -1200}},
    {"step": 90, "resize": {"window": {"width_px": 1280, "height_px": 720}}},
    {"step": 90, "resize": {"sprite": {"width_px": 64, "height_px": 64}}},
    {"step": 200, "stop": {}}])
LONG = fling(name="long", steps=9000, clock={"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.3, "seed": 5}},
             events=[{"step": 5000, "fling": {"vx_px_per_s": 900, "vy_px_per_s": -2500}}])


def flip_element(dataset, index, bit):
    values = dataset[...]
    values.view(numpy.uint8).reshape(len(values), -1)[index, bit // 8] ^= 1 << bit % 8
    dataset[...] = values


def damages(path):
    """Places of a golden file: a dataset, an element of it, and a bit of that."""
    with h5py.File(path) as file:
        datasets = []
        file.visititems(lambda name, item: datasets.append(item) if isinstance(item, h5py.Dataset) else None)
        for dataset in datasets:
            bits = 8 * dataset.dtype.itemsize
            for index, bit in {0: 0, len(dataset) // 2: bits - 1 if bits > 8 else 3, len(dataset) - 1: 0}.items():
                yield dataset.name, index, bit


class Damage(ProgramTest):
    """Many copies of a scenario, each with a golden file that is damaged in one place."""

    def find_all(self, document):
        """All copies are checked in one run of the program; only the undamaged one agrees."""
        name = document["name"]
        self.write(f"scenarios/{name}/intact.json", document)
        self.bless("scenarios")
        golden = self.folder / "golden" / name
        wanted = {f"scenarios/{name}/intact.json": "nothing"}
        for number, place in enumerate(damages(golden / "intact.h5")):
            for suffix in (".h5", ".txt"):
                shutil.copyfile((golden / "intact").with_suffix(suffix), golden / f"{number:04}{suffix}")
            with h5py.File(golden / f"{number:04}.h5", "r+") as copy:
                flip_element(copy[place[0]], *place[1:])
            wanted[self.write(f"scenarios/{name}/{number:04}.json", document)] = place
        self.assertGreater(len(wanted), 60)
        outcome = self.hyrax_sim("check", "--json")
        self.assertNotEqual(outcome.exit_code, AGREED)
        self.assertIn(outcome.exit_code, (1, 2), outcome.err)
        agreed = {entry["scenario"] for entry in json.loads(outcome.out)["results"] if entry["status"] == "agreed"}
        self.assertEqual([wanted[path] for path in sorted(agreed)], ["nothing"])

    def test_in_the_golden_file_of_a_short_run(self):
        self.find_all(SHORT)

    def test_in_the_golden_file_of_a_long_run(self):
        self.find_all(LONG)
