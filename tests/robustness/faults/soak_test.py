#!/usr/bin/python3
"""A billion steps with a fling every 1,250,003 of them: memory stays flat, and the bits are those of a plain loop.

HYRAX_REFERENCE_LOOP names that loop, reference_loop.cpp; HYRAX_SOAK_STEPS may ask for fewer steps. What it took is
printed, not judged.
"""

import os
import pathlib
import time

from process import succeed
from program import AGREED, ProgramTest, fling, main

LOOP = os.environ["HYRAX_REFERENCE_LOOP"]
STEPS = int(os.environ.get("HYRAX_SOAK_STEPS", "1000000000"))
FLING_EVERY = 1_250_003  # A prime, so that flings fall on every place of a block of rows.
MEGABYTE = 1 << 20
# HDF5 keeps up to a megabyte of each column of contacts at hand, which 20,000 contacts fill a tenth of. A byte lost in
# a hundred steps would be 5 MiB.
GROWTH_MAX = 4 * MEGABYTE


def resident_bytes(process):
    """Of a running process; 0 where it has ended."""
    try:
        pages = int(pathlib.Path(f"/proc/{process.id}/statm").read_text().split()[1])
    except (OSError, IndexError):
        return 0
    return pages * os.sysconf("SC_PAGESIZE")


def flings():
    """A fling each time the last one has long been at rest. Seven of eight go straight up: sideways, a speed at rest
    is subnormal soon, and a step takes ten times as long."""
    return [{"step": step, "fling": {"vx_px_per_s": 0 if number % 8 else 37 * number % 5000 - 2500,
                                     "vy_px_per_s": -(91 * number % 2500)}}
            for number, step in enumerate(range(FLING_EVERY, STEPS, FLING_EVERY))]


class Soak(ProgramTest):
    """The same run three ways."""

    def watch(self, *arguments):
        """Runs the program; returns its state hash, and the memory in the first and the last part of its run."""
        begin = time.monotonic()
        samples = []
        process = self.begin(*arguments)
        while process.is_running:
            samples.append(resident_bytes(process))
            time.sleep(0.05)
        duration_s = time.monotonic() - begin
        outcome = process.wait()
        self.assertEqual(outcome.exit_code, AGREED, outcome)
        samples = [sample for sample in samples if sample > 0]
        half = len(samples) // 2
        first, last = max(samples[:half], default=0), max(samples[half:], default=0)
        print(f"{' '.join(arguments)}: {duration_s:.1f} s, {first / MEGABYTE:.1f} MiB at most in its first half, "
              f"{last / MEGABYTE:.1f} MiB in its second")
        return outcome.out.split("state hash")[1].split()[0], first, last

    def test_memory_is_flat_and_the_bits_are_those_of_a_plain_loop(self):
        self.write("soak.json", fling(name="soak", steps=STEPS, events=flings(), record={"every": 1_000_000}))
        skipping, _, last_skipping = self.watch("run", "soak.json")
        computing, first, last = self.watch("run", "--no-skip", "soak.json", "-o", "computed.h5")
        begin = time.monotonic()
        plain = succeed(LOOP, "soak.json", cwd=self.folder, timeout=600).out.strip()
        print(f"plain loop: {time.monotonic() - begin:.1f} s")
        self.assertEqual((skipping, computing), (plain, plain))
        self.assertEqual((self.folder / "soak.h5").read_bytes(), (self.folder / "computed.h5").read_bytes())
        self.assertLess(last, first + GROWTH_MAX, "memory grows with the run")
        if not self.is_sanitized():
            self.assertLess(max(last, last_skipping), 100e6)

    def test_another_fling_is_another_hash(self):
        hashes = set()
        for speed in (100, 101):
            self.write("short.json", fling(name="short", steps=5000, events=[
                {"step": 3000, "fling": {"vx_px_per_s": speed, "vy_px_per_s": -900}}]))
            plain = succeed(LOOP, "short.json", cwd=self.folder).out.strip()
            hashes.add(plain)
            self.assertEqual(self.expect(AGREED, "run", "short.json", "--json").json["runs"][0]["state_hash"],
                             plain)
        self.assertEqual(len(hashes), 2)


if __name__ == "__main__":
    main()
