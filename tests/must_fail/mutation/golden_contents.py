#!/usr/bin/python3
"""The contents of golden files as an independent reader finds them: two hashes per file, one line each.

The first is of all that a comparison is about; the second of everything that can be read at all, but the
provenance. It runs
alone because a damaged file may kill its reader.
"""

import hashlib
import json
import sys

import h5py
import numpy

_WORDS = ("name", "description", "expect", "$schema")
_COMPARED_ATTRIBUTES = ("format", "physics", "steps", "state_hash")
_COMPARED_GROUPS = ("trajectory", "contacts", "events", "blocks")


def _value(read):
    try:
        value = read()
        if isinstance(value, numpy.ndarray) and value.dtype.hasobject:
            return "references"  # Between objects: addresses in this reader's memory.
        return value.tobytes().hex() + str(value.dtype) if isinstance(value, (numpy.ndarray, numpy.generic)) else (
            repr(value))
    except Exception as error:  # pylint: disable=broad-exception-caught
        return f"unreadable: {type(error).__name__}"


def _attributes(place, item, say):
    for name in _names(item.attrs):
        say(f"{place}@{name}", _value(lambda name=name: item.attrs[name]))


def _names(mapping):
    try:
        return sorted(mapping)
    except Exception:  # pylint: disable=broad-exception-caught
        return ["unreadable"]


def _everything(item, place, say):
    _attributes(place, item, say)
    if isinstance(item, h5py.Dataset):
        say(place, _value(lambda: item[...]))
        return
    for name in _names(item):
        if (place, name) == ("", "provenance"):
            continue
        try:
            _everything(item[name], f"{place}/{name}", say)
        except Exception:  # pylint: disable=broad-exception-caught
            say(f"{place}/{name}", "unreadable")


def _compared(file):
    scenario = json.loads(file.attrs["scenario"])
    yield {key: value for key, value in scenario.items() if key not in _WORDS}
    yield [_value(lambda name=name: file.attrs[name]) for name in _COMPARED_ATTRIBUTES]
    yield _value(lambda: file["contacts"].attrs["total"])
    for group in _COMPARED_GROUPS:
        if group in file:
            yield [(name, _value(lambda: dataset[...])) for name, dataset in sorted(file[group].items())]


def _hashes(path):
    said = []
    try:
        with h5py.File(path) as file:
            try:
                compared = repr(list(_compared(file)))
            except Exception as error:  # pylint: disable=broad-exception-caught
                compared = f"unreadable: {type(error).__name__}"
            _everything(file, "", lambda *entry: said.append(entry))
    except OSError:
        return "none", "none"
    return tuple(hashlib.sha256(text.encode()).hexdigest()[:16] for text in (compared, repr(said)))


if __name__ == "__main__":
    for each in sys.argv[1:]:
        print(*_hashes(each), flush=True)
