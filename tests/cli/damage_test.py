"""One flipped bit in any dataset of a golden file is found by `check`. Attributes: check_pairs_test, and the store's refusals."""

import io
import shutil

import h5py
import numpy

from program import ProgramTest, fling

_BATCH = 250
# The allowed exit codes for a damaged golden file; a signal is not allowed.
EXIT_CODES = {0, 1, 2, 3, 4}

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


def damages(content):
    """A dataset of a golden file, an element of it and a bit of that; the file in which it is flipped."""
    names = []
    with h5py.File(io.BytesIO(content)) as file:
        file.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
        sizes = {name: (len(file[name]), 8 * file[name].dtype.itemsize) for name in names}
    for name, (length, bits) in sizes.items():
        for index, bit in {0: 0, length // 2: bits - 1 if bits > 8 else 3, length - 1: 0}.items():
            buffer = io.BytesIO(content)
            with h5py.File(buffer, "r+") as file:
                values = file[name][...]
                values.view(numpy.uint8).reshape(length, -1)[index, bit // 8] ^= 1 << bit % 8
                file[name][...] = values
            yield (name, index, bit), buffer.getvalue()


class DamageTest(ProgramTest):
    """Many copies of a scenario, each with a golden file that is damaged in one place."""

    def empty_folders(self):
        for name in ("scenarios", "golden"):
            shutil.rmtree(self.folder / name, ignore_errors=True)
            (self.folder / name).mkdir()

    def blessed(self, document):
        """The bytes of a scenario's golden file, and its digest."""
        self.empty_folders()
        self.write("scenarios/whole.json", document)
        self.bless("scenarios")
        return [(self.folder / f"golden/whole.{suffix}").read_bytes() for suffix in ("h5", "txt")]

    def verdicts(self, document, damaged):
        """The verdict of `check` on each (.h5 file or None, summary or None): "agreed", "noted" (it agrees, with a note
        that its bytes differ from the blessed ones), a class, "missing" or "failed"; a batch by one process."""
        if len(damaged) > _BATCH:
            return self.verdicts(document, damaged[:_BATCH]) + self.verdicts(document, damaged[_BATCH:])
        self.empty_folders()
        for number, files in enumerate(damaged):
            self.write(f"scenarios/{number:04}.json", document)
            for suffix, content in zip(("h5", "txt"), files):
                if content is not None:
                    (self.folder / f"golden/{number:04}.{suffix}").write_bytes(content)
        outcome = self.hyrax_sim("check", "--json")
        self.assertIn(outcome.exit_code, EXIT_CODES)
        self.assertTrue(outcome.out, outcome)  # A sanitizer's exit code is 1.
        noted = {line.partition(": agrees, but ")[0] for line in outcome.err.splitlines()}
        return ["noted" if f"golden/{number:04}.h5" in noted else entry["class"] or entry["status"]
                for number, entry in enumerate(outcome.json["results"])]


class Bits(DamageTest):
    def test_one_in_any_dataset_is_found(self):
        for document in (SHORT, LONG):
            h5, txt = self.blessed(document)
            places, files = zip(*damages(h5))
            self.assertGreater(len(places), 60)
            verdicts = self.verdicts(document, [(file, txt) for file in files])
            self.assertEqual([place for place, verdict in zip(places, verdicts) if verdict in ("agreed", "noted")], [])
