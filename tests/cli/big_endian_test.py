"""Files as a big-endian machine writes them, every number in its byte order, are read right."""

import h5py
import numpy

from program import AGREED, DISAGREED, ProgramTest, fling

EVENTS = [{"step": 20, "fling": {"vx_px_per_s": -900, "vy_px_per_s": -800}}, {"step": 40, "hitch": {"dt_s": 0.25}},
          {"step": 90, "resize": {"window": {"width_px": 1280, "height_px": 720}}}]


def write_big_endian(source, target):
    """Copies a file; numbers of several bytes become big-endian, in datasets and in attributes. Returns them."""
    found = []

    def swapped(values):
        found.append(values.astype(values.dtype.newbyteorder(">")))
        return found[-1]

    def copy_attributes(item, copy):
        for name, value in item.attrs.items():
            if isinstance(value, (numpy.integer, str)):
                copy.attrs[name] = value if isinstance(value, str) else swapped(numpy.array(value))

    def copy_item(name, item):
        if isinstance(item, h5py.Group):
            copy = into.require_group(name)
        else:  # An enumeration of one byte keeps its type.
            data = swapped(item[...]) if item.dtype.itemsize > 1 else item[...]
            copy = into.create_dataset(name, data=data, dtype=data.dtype if item.dtype.itemsize > 1 else item.dtype)
        copy_attributes(item, copy)

    with h5py.File(source) as file, h5py.File(target, "w") as into:
        copy_attributes(file, into)
        file.visititems(copy_item)
    return found


class BigEndian(ProgramTest):
    """A run of every kind of input, and its double in the other byte order."""

    def test_diff_and_drift_read_the_same_numbers(self):
        self.expect(AGREED, "run", self.write("fling.json", fling(events=EVENTS)), "-o", "little.h5")
        self.assertGreater(len(write_big_endian(self.folder / "little.h5", self.folder / "big.h5")), 20)
        runs = [self.expect(AGREED, "drift", name, "--json").json["runs"][0] for name in ("little.h5", "big.h5")]
        self.assertEqual(*({key: run[key] for key in ("arcs", "contacts", "worst")} for run in runs))
        self.expect(AGREED, "diff", "little.h5", "big.h5")
        self.expect(AGREED, "diff", "big.h5", "little.h5")
        with h5py.File(self.folder / "big.h5", "r+") as file:
            file["trajectory/vy"][123] = numpy.nextafter(file["trajectory/vy"][123], numpy.inf)
        first = self.expect(DISAGREED, "diff", "little.h5", "big.h5", "--json").json["first_divergence"]
        self.assertEqual((first["step"], first["field"], first["ulps"]), (123, "vy", 1))

    def test_check_reads_the_rows_and_the_blocks_of_golden_files(self):
        goldens = []
        for name, steps in (("blocks", 9000), ("rows", 300)):
            self.bless(self.write(f"scenarios/{name}.json", fling(name=name, events=EVENTS, steps=steps)))
            goldens.append(self.folder / f"golden/{name}.h5")
            write_big_endian(goldens[-1], self.folder / "other.h5")
            goldens[-1].write_bytes((self.folder / "other.h5").read_bytes())
        # Every row agrees; of the attributes that bless writes, lists and scales are not copied.
        self.assertEqual(self.verdicts(), 2 * [("shape", None, 0)])
        for golden, dataset, place in zip(goldens, ("blocks/digest", "trajectory/x"), (16, 123)):
            with h5py.File(golden, "r+") as file:
                file[dataset][place] += 1
        self.assertEqual(self.verdicts(), [("values", (4096, "state"), None), ("values", (123, "x"), 1)])

    def verdicts(self):
        """Class, first difference and largest distance of each scenario."""
        results = self.expect(DISAGREED, "check", "--json").json["results"]
        firsts = [entry["first_divergence"] for entry in results]
        return [(entry["class"], first and (first["step"], first["field"]), entry["max_px"])
                for entry, first in zip(results, firsts)]
