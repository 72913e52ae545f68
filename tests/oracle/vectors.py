"""Test vectors for the parts that another program must reproduce before a complete run can agree: `vectors.py > vectors.json`."""

import itertools
import json

import numpy

import clock
import replay

SIXTIETH_S = 1.0 / 60.0
FRAMES = 16


def hexes(values):
    return [value.hex() for value in values]


def splitmix64_vectors():
    """Outputs and unit draws at small, large and extreme places."""
    seeds = [0, 1, 7, 42, 0x9E3779B97F4A7C15, 1 << 63, clock.MASK_64]
    places = [*range(8), 10**12, 12 * 10**12 + 11]
    return [{"seed": f"{seed:#018x}",
             "draws": [{"k": k, "output": f"{clock.splitmix64(seed, k):#018x}", "u": clock.unit(seed, k).hex()}
                       for k in places]} for seed in seeds]


def jitter_vectors():
    """dt of frames 0 to 15. The last cases of each kind meet its limits: no jitter, full jitter, dt of 0, dt cut at 1e9 s."""
    cases = [("uniform", dt_s, fraction, seed) for dt_s, fraction, seed in [
        (SIXTIETH_S, 0.1, 7), (1.0 / 144.0, 0.35, clock.MASK_64), (SIXTIETH_S, 0.0, 1), (SIXTIETH_S, 1.0, 0),
        (0.0, 1.0, 5), (-0.0, 1.0, 5), (9e8, 1.0, 3), (1e9, 0.5, 9)]]
    cases += [("normal", dt_s, sigma_s, seed) for dt_s, sigma_s, seed in [
        (SIXTIETH_S, 0.001, 7), (1.0 / 144.0, 0.0005, clock.MASK_64), (SIXTIETH_S, 0.0, 1), (SIXTIETH_S, 0.05, 0),
        (0.0, 0.01, 5), (-0.0, 0.0, 5), (9e8, 1e8, 3), (SIXTIETH_S, 1e9, 9)]]
    cases += [("missed_frames", dt_s, probability, seed) for dt_s, probability, seed in [
        (SIXTIETH_S, 0.05, 7), (SIXTIETH_S, 0.5, clock.MASK_64), (SIXTIETH_S, 0.0, 1), (SIXTIETH_S, 1.0, 0),
        (0.0, 0.5, 5), (-0.0, 0.5, 5), (6e8, 0.5, 3), (1e9, 0.5, 9)]]
    return [{"kind": kind, "dt_s": dt_s.hex(), clock.JITTERS[kind][0]: parameter.hex(), "seed": f"{seed:#018x}",
             "frames_dt_s": hexes(itertools.islice(clock.jittered_dts_s(kind, dt_s, parameter, seed), FRAMES))}
            for kind, dt_s, parameter, seed in cases]


def times_after(dts_s):
    timeline = clock.Timeline()
    return [timeline.advance(dt_s) for dt_s in dts_s]


def time_rule_vectors():
    """Sequences of dt with the time after every frame."""
    jittered = itertools.islice(clock.jittered_dts_s("uniform", SIXTIETH_S, 0.3, 11), 24)
    cases = {
        "equal": [0.1] * 12,
        "one frame": [SIXTIETH_S],
        "alternating": [SIXTIETH_S, 1.0 / 144.0] * 6,
        "a hitch in the middle": [SIXTIETH_S] * 6 + [0.5] + [SIXTIETH_S] * 6,
        "a hitch of the same dt opens no segment": [0.1] * 3 + [0.1] + [0.1] * 3,
        "jittered": list(jittered),
        "big, then small: the sum is the larger": [1e9, 1e9, 1e-9, 1e-9, 1e-9, 0.1, 0.3, 1e-7],
        "small, then big: the term is the larger": [1e-9, 0.1, 0.1, 1e9, 0.3, 1e9, 1e9, 1e-9, 0.7],
        "an equal term: the first branch": [0.1, 0.1, 0.2, 0.1],
        "dt of zero, of both signs": [0.0, 0.0, -0.0, 0.1, -0.0, 0.0, 0.1],
        "subnormal dt": [5e-324, 5e-324, 1e-310, 1.0, 5e-324, 5e-324],
    }
    return [{"name": name, "dts_s": hexes(dts_s), "times_s": hexes(times_after(dts_s))} for name, dts_s in cases.items()]


def counted_rows(count):
    """Rows that any language can reproduce; see the rule in the document."""
    return [(1.0 / 64.0, float(i), i * 0.5, 0.0 - i, 1000.0 - i, i % 32) for i in range(count)]


def state_hash_vectors():
    """Small row sequences in full, long ones by rule."""
    listed = {
        "one row": [(0.0, 300.0, 500.0, 2400.0, -700.0, 0)],
        "one row of zeros": [(0.0, 0.0, 0.0, 0.0, 0.0, 0)],
        "one row of zeros, one of them negative": [(0.0, 0.0, 0.0, -0.0, 0.0, 0)],
        "two rows with signed zeros, subnormals and extremes": [
            (0.0, -0.0, 5e-324, -5e-324, 2.2250738585072014e-308, 0),
            (SIXTIETH_S, 1e12, -1e12, 1.7976931348623157e308, -2.225073858507201e-308, 31)],
        "two rows in the other order": [(0.1, 1.0, 2.0, 3.0, 4.0, 9), (0.0, 1.0, 2.0, 3.0, 4.0, 0)],
    }
    rule = "row i: dt = 1/64, x = i, y = i * 0.5, vx = 0.0 - i (so +0 in row 0), vy = 1000 - i, contact = i mod 32"
    result = []
    for name, rows in listed.items():
        keys = ("dt", "x", "y", "vx", "vy")
        texts = [{**dict(zip(keys, hexes(row[:5]), strict=True)), "contact": row[5]} for row in rows]
        result.append({"name": name, "rows": texts, **hash_of(rows)})
    for count in (3, 4095, 4096, 4097, 8192, 8193):
        result.append({"name": f"{count} counted rows", "rule": rule, "count": count, **hash_of(counted_rows(count))})
    return result


def hash_of(rows):
    """The digests and the hash of a row sequence."""
    state_hash = replay.StateHash()
    for row in rows:
        state_hash.add(*row)
    final = state_hash.hexdigest()
    return {"block_digests": [digest.hex() for digest in state_hash.digests], "state_hash": final}


def steps_vectors():
    """Durations near a whole number of frames, on both sides of the allowance."""
    cases = [(0.0, SIXTIETH_S), (1e-12, SIXTIETH_S), (1e-10, SIXTIETH_S), (1.0, SIXTIETH_S), (10.0, SIXTIETH_S),
             (15.0, 1.0 / 144.0), (0.3, 0.1), (0.7, 0.1), (1.1, 0.1), (3.0000000005, 1.0), (3.000000001, 1.0),
             (3.0000000011, 1.0), (3.000000002, 1.0), (2.9999999995, 1.0), (2.5, 1.0), (3600.0, 1.0 / 59.94),
             (1e-9, 1.0), (1.0000000000000002e-9, 1.0), (1e6, SIXTIETH_S), (1e6, 0.001), (5e-324, 5e-324)]
    return [{"duration_s": duration_s.hex(), "dt_s": dt_s.hex(), "steps": clock.steps_of_duration(duration_s, dt_s)}
            for duration_s, dt_s in cases]


def at_s_vectors():
    """Times of events and the frames they fall in; null is beyond the end."""
    fixed = [(SIXTIETH_S, 900, at_s) for at_s in (
        0.0, -1.0, 1e-12, 1e-10, 0.01, 0.5, 9.5, 14.983333333333333, 14.983333333333334, 14.99, 15.0)]
    fixed += [(0.1, 20, at_s) for at_s in (0.3, 0.7, 1.1, 0.30000000005, 0.3000000001, 0.30000000011, 1.9, 1.95)]
    fixed += [(1.0, 5, 2.000000001), (1.0, 5, 2.0000000010000005), (0.0, 4, 0.0), (0.0, 4, 1e-9)]
    result = [{"clock": "fixed", "dt_s": dt_s.hex(), "steps": steps, "at_s": at_s.hex(),
               "frame": clock.first_frame_due([dt_s] * steps, at_s, dt_s)} for dt_s, steps, at_s in fixed]
    # In an array the allowance is that of the frame's own dt: a long frame reaches back further than a short one.
    arrays = [([0.1, 0.2, 0.3, 0.1], at_s) for at_s in (0.0, 0.1, 0.15, 0.3, 0.6, 0.61, 0.7)]
    arrays += [([1.0, 1e-3, 1.0, 1.0], 1.0000000005), ([1.0, 1.0, 1.0], 1.0000000005), ([1.0, 1.0, 1.0], 1.000000002),
               ([0.0, 0.0, 0.5, 0.0, 0.5], 0.0), ([0.0, 0.0, 0.5, 0.0, 0.5], 0.5), ([0.25], 0.25)]
    result += [{"clock": "array", "dts_s": hexes(dts_s), "at_s": at_s.hex(),
                "frame": clock.first_frame_due(dts_s, at_s)} for dts_s, at_s in arrays]
    # With jitter or a hitch the frames differ, but the allowance stays that of the clock's base.
    hitched = [SIXTIETH_S] * 5 + [0.5] + [SIXTIETH_S] * 5
    result += [{"clock": "base with other frames", "dt_s": SIXTIETH_S.hex(), "dts_s": hexes(hitched), "at_s": at_s.hex(),
                "frame": clock.first_frame_due(hitched, at_s, SIXTIETH_S)} for at_s in (0.05, 0.3, 0.6, 0.65, 2.0)]
    return result


def rounded(value):
    """To 12 digits: the last ones depend on the version of numpy."""
    return float(f"{value:.12g}")


def statistics_vectors():
    """Samples with quantiles, mean and histogram by numpy. The histogram has 40 bins from the smallest to the largest."""
    parts = [0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0]
    result = []
    for seed, size in enumerate((2, 3, 10, 41, 200)):
        values = [1000.0 * clock.unit(seed, k) ** 3 - 50.0 for k in range(size)]
        result.append({"values": hexes(values), "parts": hexes(parts), "quantiles": hexes(map(rounded, numpy.quantile(values, parts))),
                       "mean": rounded(numpy.mean(values)).hex(), "counts": numpy.histogram(values, 40)[0].tolist()})
    return result


def all_vectors():
    return {
        "format": "hyrax-vectors/1",
        "about": "Made by `vectors.py`. Every double is exact hexadecimal text; seeds and outputs are 64 bits.",
        "splitmix64": splitmix64_vectors(),
        "jitter": jitter_vectors(),
        "time_rule": time_rule_vectors(),
        "state_hash": state_hash_vectors(),
        "steps": steps_vectors(),
        "at_s": at_s_vectors(),
        "statistics": statistics_vectors(),
    }


if __name__ == "__main__":
    print(json.dumps(all_vectors(), indent=1))
