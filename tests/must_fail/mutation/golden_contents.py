#!/usr/bin/python3
"""The contents of golden files as an independent reader finds them: a hash per file, one line each.

It is of everything that can be read at all, but the provenance. It runs alone because a damaged file may kill its reader.
"""

import hashlib
import sys

import h5py
import numpy


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


def _hash(path):
    said = []
    try:
        with h5py.File(path) as file:
            _everything(file, "", lambda *entry: said.append(entry))
    except OSError:
        return "none"
    return hashlib.sha256(repr(said).encode()).hexdigest()


if __name__ == "__main__":
    for each in sys.argv[1:]:
        print(_hash(each), flush=True)
