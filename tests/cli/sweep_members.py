"""Sweeps for the tests, drawn from a seed, and what their members give when each is run by itself."""

import math
import random
import sys

import h5py
import numpy

from program import AGREED, SOURCE, fling

sys.path.insert(0, str(SOURCE / "tests/oracle"))
import sweep as oracle  # noqa: E402 pylint: disable=wrong-import-position

ALL = ["final", "contacts", "at_rest", "extremes", "state_hash"]
KEEPS = [ALL, ALL[:4], ALL[:4], ["final"], ["contacts", "at_rest"]]
COLUMNS = {"final": ["x", "y", "vx", "vy"], "contacts": ["contacts"], "at_rest": ["at_rest_since"],
           "extremes": ["x_min", "x_max", "y_min", "y_max", "speed_max"], "state_hash": ["state_hash"]}
WALLS = ("left", "right", "top", "ground")

EVENTS = [{"step": 30, "fling": {"vx_px_per_s": 900, "vy_px_per_s": -800}}, {"step": 55, "hitch": {"dt_s": 0.25}},
          {"step": 55, "place": {"x_px": 400, "y_px": 40}}, {"step": 90, "grab": {}},
          {"step": 92, "place": {"x_px": 640, "y_px": 200}},
          {"step": 99, "release": {"vx_px_per_s": 700, "vy_px_per_s": -900}},
          {"step": 120, "resize": {"window": {"width_px": 900, "height_px": 500}}}, {"at_s": 2.5, "stop": {}}]


def base(**changes):
    """The throw of the tests, without its name."""
    return fling(**{**changes, "name": None})


def any_clock(draws):
    """A clock and the keys that can vary in it."""
    clock, vary = {"rate_hz": 60}, {"/clock/rate_hz": {"choice": [60, 120, 144, 59.94]}}
    if draws.random() < 0.3:
        clock, vary = {"dt_s": 0.016}, {"/clock/dt_s": {"uniform": [0.001, 0.05]}}
    elif draws.random() < 0.15:
        return {"dt_s": [draws.choice((0.016, 0.017, 0.033, 0.0)) for _ in range(150)]}, {}
    kind, key, high = draws.choice((("uniform", "fraction", 1), ("normal", "sigma_s", 0.01),
                                    ("missed_frames", "probability", 1)))
    if draws.random() < 0.5:
        clock["jitter"] = {"kind": kind, key: 0.1 * high, "seed": 3}
        vary["/clock/jitter/seed"] = draws.choice(({"member": True}, {"choice": [7, 2**64 - 1]},
                                                   {"uniform": [0, 1000]}))
        vary[f"/clock/jitter/{key}"] = {"uniform": [0, high]}
    return clock, vary


def any_sweep(seed):
    """A sweep of some fifty members with keys of all kinds; it prints nothing and is valid."""
    draws = random.Random(seed)
    clock, vary = any_clock(draws)
    events = [event for event in EVENTS if "at_s" not in event] if draws.random() < 0.4 else []
    steps = None if isinstance(clock.get("dt_s"), list) else draws.choice((0, 1, 2, 64, 150, 400, 700))
    if events and steps is not None:
        steps = 150
    if events and len(clock) == 1 and "rate_hz" in clock:
        vary = {}
        events = EVENTS
        steps = 300
    vary.update({
        "/start/vx_px_per_s": {"uniform": [-3000, 3000]},
        "/start/vy_px_per_s": {"uniform": [-2000, 1000]},
        "/start/x_px": {"grid": [-50, 1792.5, draws.choice((1, 3, 5))]},
        "/start/y_px": {"choice": [0, -0.0, 952, 500.25, -40, 1e12]},
        "/window/width_px": {"uniform": [100, 1920]},
        "/sprite/height_px": {"choice": [1, 128, 1080, 1200]},
    })
    if steps is not None and not events:
        vary["/steps"] = draws.choice(({"uniform": [0, steps]}, {"grid": [steps, steps, 2]}))
    if events:
        vary["/events/0/fling/vx_px_per_s"] = {"uniform": [-900, 900]}
        vary["/events/0/step"] = {"uniform": [0, 55]}
        vary["/events/1/hitch/dt_s"] = {"uniform": [0, 0.5]}
        vary["/events/6/resize/window/width_px"] = {"uniform": [100, 900]}
    kept = {key: rule for key, rule in vary.items() if draws.random() < 0.6 or "grid" in rule}
    document = {"format": "hyrax-sweep/1", "base": base(clock=clock, steps=steps, events=events),
                "seed": draws.getrandbits(64), "vary": kept, "keep": draws.choice(KEEPS)}
    product = oracle.grid_size(kept)
    document["members"] = product * math.ceil(50 / product)
    return document


def columns_of_runs(test, sweep, members=None):
    """The columns of a sweep's result file, from `run` of each member, without help of the command sweep."""
    members = range(oracle.member_count(sweep)) if members is None else members
    paths = [test.write(f"alone/member-{member}.json", oracle.scenario(sweep, member)) for member in members]
    runs = test.expect(AGREED, "run", *paths, "-o", "alone/", "--json").json["runs"]
    columns = {}
    kept = {f"members/{name}" for keep in sweep["keep"] for name in COLUMNS[keep]}
    for member, run in zip(members, runs, strict=True):
        row = expected_row(run, test.folder / f"alone/member-{member}.h5")
        row = {name: value for name, value in row.items() if name in kept}
        for key, value in oracle.inputs(sweep, member).items():
            row["inputs/" + key[1:].replace("/", ".")] = value
        for name, value in row.items():
            columns.setdefault(name, []).append(value)
    return columns


def expected_row(run, path):
    """The numbers of /members of one run."""
    with h5py.File(path) as file:
        rows = {name: file["trajectory"][name][()] for name in ("x", "y", "vx", "vy")}
    row = {f"members/{name}": values[-1] for name, values in rows.items()}
    row["members/contacts"] = [run["contacts"][wall] for wall in WALLS]
    row["members/at_rest_since"] = math.nan if run["at_rest_since_s"] is None else float(run["at_rest_since_s"])
    row["members/state_hash"] = list(bytes.fromhex(run["state_hash"]))
    squared = rows["vx"] * rows["vx"] + rows["vy"] * rows["vy"]
    row["members/speed_max"] = math.sqrt(squared.max())
    for name in ("x", "y"):
        row[f"members/{name}_min"] = first_of(rows[name], rows[name].min())
        row[f"members/{name}_max"] = first_of(rows[name], rows[name].max())
    return row


def first_of(values, extreme):
    """The first value that equals the extreme: of 0 and -0, the one that came first."""
    return float(values[numpy.argmax(values == extreme)])


def datasets(path):
    """All datasets of a result file below /members and /inputs, by path."""
    with h5py.File(path) as file:
        return {f"{group}/{name}": file[group][name][()] for group in ("members", "inputs") for name in file[group]}


def assert_same_bits(test, found, expected, note):
    """Two sets of columns are equal in names, types and bits; one NaN equals another."""
    test.assertEqual(sorted(found), sorted(expected), note)
    for name, values in expected.items():
        wanted = numpy.array(values, dtype=found[name].dtype)
        test.assertEqual(found[name].shape, wanted.shape, f"{note}: {name}")
        if wanted.dtype == numpy.float64:
            same = (found[name].view(numpy.uint64) == wanted.view(numpy.uint64)) | (
                numpy.isnan(found[name]) & numpy.isnan(wanted))
        else:
            same = found[name] == wanted
        test.assertTrue(same.all(), f"{note}: {name}: first at {numpy.argwhere(~same)[:1].tolist()}: "
                                    f"{found[name][~same][:3]} instead of {wanted[~same][:3]}")
