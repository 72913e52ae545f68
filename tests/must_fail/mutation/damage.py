"""Ways to damage a golden file: single bits, and complete rows."""

import io
import random

import h5py
import numpy


def flipped(content, place, bit):
    """The bytes with one bit flipped."""
    damaged = bytearray(content)
    damaged[place] ^= 1 << bit
    return bytes(damaged)


def some_flips(content, count, seed):
    """(place, bit) of so many flips, the same for the same seed; every byte once, if so many are requested."""
    draws = random.Random(seed)
    places = draws.sample(range(len(content)), count) if count < len(content) else range(len(content))
    return [(place, draws.randrange(8)) for place in places]


def spans_of_rows(content):
    """[(begin, end)]: where a golden file holds the elements of /trajectory."""
    spans = []
    with h5py.File(io.BytesIO(content)) as file:
        for item in file["trajectory"].values():
            if item.id.get_offset() is not None:
                spans.append((item.id.get_offset(), item.id.get_offset() + item.id.get_storage_size()))
            else:
                chunks = [item.id.get_chunk_info(number) for number in range(item.id.get_num_chunks())]
                spans.extend((chunk.byte_offset, chunk.byte_offset + chunk.size) for chunk in chunks)
    return spans


def _drop(values, row):
    return numpy.delete(values, row, axis=0)


def _double(values, row):
    return numpy.insert(values, row, values[row], axis=0)


def _swap(values, row):
    swapped = values.copy()
    swapped[[row, row + 1]] = values[[row + 1, row]]
    return swapped


def damaged_rows(content):
    """(description, golden file) for every group of rows: one dropped, doubled, swapped with the next, or with a NaN."""
    with h5py.File(io.BytesIO(content)) as file:
        groups = {name: len(next(iter(group.values()))) for name, group in file.items()
                  if isinstance(group, h5py.Group) and len(group) > 0}
        floats = [dataset.name for group in file.values() if isinstance(group, h5py.Group)
                  for dataset in group.values() if dataset.dtype.kind == "f"]
        lengths = {name: len(file[name]) for name in floats}
    for name, length in groups.items():
        for row in sorted({0, length // 2, length - 1}):
            yield f"/{name}: row {row} dropped", _with_rows(content, name, length, _drop, row)
            yield f"/{name}: row {row} doubled", _with_rows(content, name, length, _double, row)
            if row + 1 < length and _differ(content, name, row):
                yield f"/{name}: row {row} swapped with the next", _with_rows(content, name, length, _swap, row)
    for name in floats:
        for row in sorted({0, lengths[name] // 2, lengths[name] - 1} - {-1}):
            yield f"{name}[{row}] is a NaN", _with_nan(content, name, row)


def _differ(content, group, row):
    with h5py.File(io.BytesIO(content)) as file:
        return any(dataset[row] != dataset[row + 1] for dataset in file[group].values())


def _with_rows(content, group, length, change, row):
    """All columns of a group changed alike; columns of another length (bytes of digests) keep their length a row."""
    buffer = io.BytesIO(content)
    with h5py.File(buffer, "r+") as file:
        for name, dataset in list(file[group].items()):
            values = dataset[...]
            if len(values) % length != 0:
                continue
            changed = change(values.reshape(length, -1), row).reshape(-1)
            kind = dataset.dtype
            del file[group][name]
            file[group].create_dataset(name, data=changed, dtype=kind)
    return buffer.getvalue()


def _with_nan(content, name, row):
    buffer = io.BytesIO(content)
    with h5py.File(buffer, "r+") as file:
        file[name][row] = numpy.nan
    return buffer.getvalue()
