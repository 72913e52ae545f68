#!/usr/bin/python3
"""Files as a big-endian machine writes them, every number in its byte order, are read right."""

import h5py
import numpy
import xxhash

from program import AGREED, DISAGREED, ProgramTest, fling, main

EVENTS = [{"step": 20, "fling": {"vx_px_per_s": -900, "vy_px_per_s": -800}}, {"step": 40, "hitch": {"dt_s": 0.25}},
          {"step": 90, "resize": {"window": {"width_px": 1280, "height_px": 720}}}]


def swapped(values):
    """The same numbers, in big-endian order."""
    return values.astype(values.dtype.newbyteorder(">"))


def write_big_endian(source, target):
    """Copies a file; numbers of several bytes become big-endian, in datasets and in attributes. Returns how many did."""
    count = 0

    def copy_attributes(item, copy):
        nonlocal count
        for name, value in item.attrs.items():
            if isinstance(value, numpy.integer):
                copy.attrs.create(name, swapped(numpy.array(value)))
                count += 1
            elif isinstance(value, str):
                copy.attrs[name] = value

    def copy_item(name, item):
        nonlocal count
        if isinstance(item, h5py.Group):
            copy = into.require_group(name)
        elif item.dtype.itemsize > 1:
            copy = into.create_dataset(name, data=swapped(item[...]))
            count += 1
        else:
            copy = into.create_dataset(name, data=item[...], dtype=item.dtype)
        copy_attributes(item, copy)

    with h5py.File(source) as file, h5py.File(target, "w") as into:
        copy_attributes(file, into)
        file.visititems(copy_item)
    return count


class BigEndian(ProgramTest):
    """A run of every kind of input, and its double in the other byte order."""

    def test_diff_and_drift_read_the_same_numbers(self):
        self.expect(AGREED, "run", self.write("fling.json", fling(events=EVENTS)), "-o", "little.h5")
        self.assertGreater(write_big_endian(self.folder / "little.h5", self.folder / "big.h5"), 20)
        runs = [self.expect(AGREED, "drift", name, "--json").json["runs"][0] for name in ("little.h5", "big.h5")]
        self.assertEqual(*({key: run[key] for key in ("arcs", "contacts", "worst")} for run in runs))
        self.expect(AGREED, "diff", "little.h5", "big.h5")
        self.expect(AGREED, "diff", "big.h5", "little.h5")
        with h5py.File(self.folder / "big.h5", "r+") as file:
            file["trajectory/vy"][123] = numpy.nextafter(file["trajectory/vy"][123], numpy.inf)
        first = self.expect(DISAGREED, "diff", "little.h5", "big.h5", "--json").json["first_divergence"]
        self.assertEqual((first["step"], first["field"], first["ulps"]), (123, "vy", 1))

    def test_check_compares_a_run_with_golden_files_of_rows_and_of_blocks(self):
        paths = [self.write("scenarios/rows.json", fling(name="rows", events=EVENTS)),
                 self.write("scenarios/blocks.json", fling(name="blocks", events=EVENTS, steps=9000))]
        self.bless("scenarios")
        for path in paths:
            golden = self.folder / path.replace("scenarios", "golden").replace(".json", ".h5")
            write_big_endian(golden, self.folder / "other.h5")
            golden.write_bytes((self.folder / "other.h5").read_bytes())
            digest = golden.with_suffix(".txt")
            text = digest.read_text(encoding="utf-8")
            digest.write_text(text[:text.rindex(" ") + 1] + xxhash.xxh3_128_hexdigest(golden.read_bytes()) + "\n",
                              encoding="utf-8")
        self.expect(AGREED, "check")
        for path, dataset in zip(paths, ("trajectory/x", "blocks/time_base"), strict=True):
            golden = self.folder / path.replace("scenarios", "golden").replace(".json", ".h5")
            with h5py.File(golden, "r+") as file:
                file[dataset][-1] += 1
        self.expect(DISAGREED, "check")


if __name__ == "__main__":
    main()
