"""A golden file with one bit flipped anywhere, or a row dropped, doubled, swapped or made a NaN, is detected.

HYRAX_DAMAGE=all flips thousands of bits instead of a sample.
"""

import concurrent.futures
import io
import multiprocessing
import os
import random

import h5py
import numpy

from damage_test import LONG, SHORT, DamageTest

_IS_ALL = os.environ.get("HYRAX_DAMAGE") == "all"
_H5_FLIPS = 6000 if _IS_ALL else 150


def flips_of(content):
    """Golden files with one bit flipped, the same ones each time."""
    draws = random.Random(1)
    for place in draws.sample(range(len(content)), min(_H5_FLIPS, len(content))):
        yield content[:place] + bytes([content[place] ^ 1 << draws.randrange(8)]) + content[place + 1:]


def contents_of(content):
    """What an independent reader finds in a golden file, but the provenance."""
    said = []

    def value_of(value):
        value = numpy.asarray(value)
        # References between objects are addresses in this reader's memory.
        return "references" if value.dtype.hasobject else (str(value.dtype), value.tobytes())

    def take(name, item):
        said.extend((name, key, value_of(value)) for key, value in sorted(item.attrs.items()))
        if isinstance(item, h5py.Dataset):
            said.append((name, value_of(item[()])))

    try:
        with h5py.File(io.BytesIO(content)) as file:
            take("", file)
            for top in sorted(file.keys() - {"provenance"}):
                take(top, file[top])
                if isinstance(file[top], h5py.Group):
                    file[top].visititems(lambda name, item, top=top: take(f"{top}/{name}", item))
    except Exception as error:  # pylint: disable=broad-exception-caught
        return f"unreadable: {error}"
    return said


def is_another_to_a_reader(content, whole):
    """Whether a damaged file reads differently from the whole one; not if it kills its reader, who therefore runs alone."""
    with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("fork")) as reader:
        try:
            return reader.submit(contents_of, content).result(300) != whole
        except concurrent.futures.process.BrokenProcessPool:
            return False


def swapped(values, row):
    """A row and the next one exchanged."""
    return values[[*range(row), row + 1, row, *range(row + 2, len(values))]]


CHANGES = {"dropped": lambda values, row: numpy.delete(values, row, axis=0),
           "doubled": lambda values, row: numpy.insert(values, row, values[row], axis=0),
           "swapped with the next": swapped}


def damaged_rows(content):
    """(description, golden file) for every group of rows: one dropped, doubled, swapped with the next, or with a NaN."""
    with h5py.File(io.BytesIO(content)) as file:
        groups = {name: {column: dataset[...] for column, dataset in group.items()} for name, group in file.items()
                  if isinstance(group, h5py.Group) and len(group) > 0}
    for group, columns in groups.items():
        length = len(next(iter(columns.values())))
        for row in sorted({0, length // 2, length - 1} - {-1}):
            for what, change in CHANGES.items():
                if change is not swapped or (row + 1 < length and any(each[row] != each[row + 1] for each in columns.values())):
                    yield f"/{group}: row {row} {what}", with_rows(content, group, columns, change, row)
            for name, values in columns.items():
                if values.dtype.kind == "f":
                    damaged = values.copy()
                    damaged[row] = numpy.nan
                    yield f"/{group}/{name}[{row}] is a NaN", with_columns(content, group, {name: damaged})


def with_rows(content, group, columns, change, row):
    """All columns of a group changed alike; columns of another length (bytes of digests) keep their length a row."""
    length = len(next(iter(columns.values())))
    return with_columns(content, group, {name: change(values.reshape(length, -1), row).reshape(-1)
                                         for name, values in columns.items() if len(values) % length == 0})


def with_columns(content, group, columns):
    """A golden file with other values in these columns."""
    buffer = io.BytesIO(content)
    with h5py.File(buffer, "r+") as file:
        for name, values in columns.items():
            if len(values) == len(file[group][name]):
                file[group][name][...] = values
            else:
                del file[group][name]
                file[group].create_dataset(name, data=values)
    return buffer.getvalue()


class Damage(DamageTest):
    """The same for the two kinds of golden file: of rows, and of blocks."""

    def test_complete_pairs_agree_and_half_ones_are_missing(self):
        for document in (SHORT, LONG):
            h5, txt = self.blessed(document)
            self.assertEqual(self.verdicts(document, [(h5, txt), (h5, None), (None, txt)]), ["agreed", "missing", "missing"])

    def test_a_flipped_bit_anywhere_in_the_golden_file_is_found_or_noted(self):
        for document in (SHORT, LONG):
            h5, txt = self.blessed(document)
            files, whole = list(flips_of(h5)), contents_of(h5)
            verdicts = self.verdicts(document, [(file, txt) for file in files])
            self.assertNotIn("agreed", verdicts)
            self.assertEqual([number for number, (file, verdict) in enumerate(zip(files, verdicts, strict=True))
                              if verdict == "noted" and is_another_to_a_reader(file, whole)], [], document["name"])

    def test_a_row_dropped_doubled_swapped_or_made_a_nan_is_found(self):
        for document in (SHORT, LONG):
            h5, txt = self.blessed(document)
            names, files = zip(*damaged_rows(h5))
            self.assertGreater(len(names), 40)
            verdicts = self.verdicts(document, [(file, txt) for file in files])
            unseen = [(name, verdict) for name, verdict in zip(names, verdicts, strict=True)
                      if verdict in ("agreed", "noted")]
            self.assertEqual(unseen, [], document["name"])
