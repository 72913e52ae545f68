"""sweep: every number equals that of the member's own run, whatever the threads; what is refused, and what is written."""

import json
import re

import h5py
import numpy

from program import AGREED, BAD_INPUT, SOURCE, few_threads, fling
from sweep_members import ALL, COLUMNS, WALLS, any_sweep, assert_same_bits, base, columns_of_runs, datasets
from sweep_program import NO_CLUSTER, SEED, SweepTest, document


class EveryMember(SweepTest):
    """Against `run`, column by column."""

    def test_random_sweeps_equal_the_runs_of_their_members(self):
        for number in range(3):
            seed = f"{SEED}-{number}"
            sweep = any_sweep(seed)
            with self.subTest(f"HYRAX_SEED={SEED}, sweep {number}: {json.dumps(sweep)}"):
                found = self.computed(sweep, f"--threads={1 + number}")
                assert_same_bits(self, found, columns_of_runs(self, sweep), f"seed {seed}")

    def test_without_any_other_thread_the_numbers_are_the_same(self):
        threads = self.computed(document(members=300, base=base(steps=1_100_000)), "--threads=3")  # In chunks of 64.
        for allowed in (0, 1):
            self.sweep("sweep.json", "-o", "few.h5", "--threads=3", env=few_threads(allowed, NO_CLUSTER))
            assert_same_bits(self, datasets(self.folder / "few.h5"), threads, f"{allowed} threads")

    def test_members_at_every_end_of_lanes_and_chunks_are_their_runs(self):
        members = [0, 1, 7, 8, 9, 31, 32, 33, 63, 64, 65, 1023, 1024, 1025, 4096, 16_383, 16_384, 16_385, 32_768, 32_771]
        sweep = document(members=32_772, keep=ALL, base=base(steps=100))
        found = self.computed(sweep)
        assert_same_bits(self, {name: values[members] for name, values in found.items()},
                         columns_of_runs(self, sweep, members), "alone")
        self.assertEqual(len(numpy.unique(found["members/state_hash"], axis=0)), 32_772, "a member is another one")
        kept = self.computed(document(members=32_772, keep=ALL[:4], base=base(steps=100)))  # By kernels, which hash nothing.
        assert_same_bits(self, kept, {name: found[name] for name in kept}, "without hashes")
        for member in (0, 16_385):
            self.sweep("sweep.json", "--member", str(member), "-o", f"m{member}.json")
            document_of_member = json.loads((self.folder / f"m{member}.json").read_text())
            self.assertIn(str(member), document_of_member["name"])
            run = self.expect(AGREED, "run", f"m{member}.json", "--json").json["runs"][0]
            self.assertEqual(bytes(found["members/state_hash"][member]).hex(), run["state_hash"])

    def test_each_number_of_a_clock_moves_the_event_of_a_time(self):
        clock = {"rate_hz": 60, "jitter": {"kind": "normal", "sigma_s": 0.004, "seed": 1}}
        events = [{"at_s": 1.5, "fling": {"vx_px_per_s": 900, "vy_px_per_s": -800}}]
        for key, rule in (("seed", {"member": True}), ("sigma_s", {"uniform": [0, 0.008]}), ("rate_hz", {"uniform": [50, 70]})):
            vary = {f"/clock/{'' if key == 'rate_hz' else 'jitter/'}{key}": rule}
            sweep = document(members=8, keep=ALL[:4], vary=vary, base=base(clock=clock, events=events, steps=120))
            assert_same_bits(self, self.computed(sweep), columns_of_runs(self, sweep), key)

    def test_what_is_not_kept_is_not_there(self):
        row = re.search(r"^\| `keep` \| (.*)\. The first three if left out \|$", (SOURCE / "sim/ensemble/README.md").read_text(encoding="utf-8"), re.MULTILINE)[1]
        said = dict(re.findall(r"`(\w+)`(?: \((.*?)\))?", row))
        self.assertEqual(said["contacts"].split(", "), list(WALLS))
        self.assertEqual({keep: re.findall(r"`(\w+)`", said[keep]) or [keep] for keep in said}, COLUMNS)
        for keep in (["final"], ["extremes"], None):
            found = self.computed(document(keep=keep))
            self.assertEqual(sorted(name for name in found if name.startswith("members/")),
                             sorted(f"members/{column}" for each in keep or list(said)[:3] for column in COLUMNS[each]))

    def test_members_default_to_the_combinations_of_the_grids(self):
        vary = {"/start/x_px": {"grid": [0, 1792, 5]}, "/start/y_px": {"grid": [0, 3, 4]}}
        found = self.computed(document(members=None, seed=None, vary=vary))
        self.assertEqual(list(found["inputs/start.x_px"][:5]), [0, 0, 0, 0, 448])
        self.assertEqual(list(found["inputs/start.y_px"][:5]), [0, 1, 2, 3, 0])
        self.assertEqual(len(found["members/x"]), 20)

    def test_seeds_are_exact_to_the_largest(self):
        clock = {"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.2, "seed": 3}}
        most = 2**64 - 1
        for rule in ({"uniform": [2**53 + 1, 2**53 + 3]}, {"uniform": [most - 1, most]}, {"uniform": [0, most]}, {"choice": [most, 2**63 + 1]},
                     {"grid": [most - 30, most, 4]}, {"grid": [2**53 + 1, 2**53 + 9, 2]}):
            sweep = document(members=8, base=base(clock=clock, steps=90), keep=["final"], vary={"/clock/jitter/seed": rule})
            found = self.computed(sweep)
            assert_same_bits(self, found, columns_of_runs(self, sweep), rule)
            self.sweep("sweep.json", "--part", "0/1", "-o", "part.h5")
            self.sweep("--merge", "part.part-0-of-1.h5", "-o", "merged.h5")
            self.sweep("sweep.json", "--member", "3", "-o", "member.json", "--force")
            seed = json.loads((self.folder / "member.json").read_text())["clock"]["jitter"]["seed"]
            self.assertEqual(seed, found["inputs/clock.jitter.seed"][3])
        for rule, says in (({"uniform": [0, 2**64]}, "whole numbers, as the key holds"), ({"grid": [0, most, 7]}, "must give whole numbers only")):
            self.write("sweep.json", document(members=14, base=base(clock=clock), vary={"/clock/jitter/seed": rule}))
            self.sweep("sweep.json", exit_code=BAD_INPUT, says=says)

    def test_the_base_may_be_a_file_beside_the_sweep(self):
        self.write("deep/base.json", fling(expect={"in_bounds": True}))
        self.write("deep/sweep.json", document(base="base.json"))
        self.sweep("deep/sweep.json", "-o", "beside.h5")
        self.computed(document())
        assert_same_bits(self, datasets(self.folder / "beside.h5"), datasets(self.folder / "sweep.h5"), "base")
        with h5py.File(self.folder / "beside.h5") as file:
            self.assertNotIn("expect", json.loads(file.attrs["sweep"])["base"])
            self.assertIn("program", file["provenance"].attrs)
        self.write("deep/base.json", fling(name=None))
        self.sweep("deep/sweep.json", "--member", "7", "-o", "member.json")
        self.assertEqual(json.loads((self.folder / "member.json").read_text())["name"], "base-member-7")


class Outputs(SweepTest):
    def test_the_mode_of_a_replaced_result_is_kept(self):
        self.write("sweep.json", document())
        self.sweep("sweep.json")
        (self.folder / "sweep.h5").chmod(0o440)
        self.sweep("sweep.json", "--force", exit_code=BAD_INPUT, says="--force: only with --member; results are always replaced")
        self.sweep("sweep.json")
        self.assertEqual((self.folder / "sweep.h5").stat().st_mode & 0o777, 0o440)

    def test_memory_does_not_grow_with_the_members(self):
        self.write("sweep.json", document(members=400_000, base=base(steps=1)))
        self.expect_below(100e6, AGREED, "sweep", "sweep.json")
