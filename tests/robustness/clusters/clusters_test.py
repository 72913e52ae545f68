"""Sweeps in parts, by real schedulers: the parts join to the file of one process, whatever happens to tasks."""

import os
import pathlib
import time

from process import skip_for_lack_of, skip_without, succeed
from program import AGREED, GOLDEN_MISSING, PROGRAM, ProgramTest, fling
from slurm import Cluster

skip_without("mpirun", "slurmctld", "slurmd", "sbatch", "munged")

JOBS = pathlib.Path(os.environ["HYRAX_JOBS"])
TASKS, KILLED = 8, 3
DEADLINE_S = 120
KILLED_ONCE = """#!/bin/sh
if [ "$SLURM_ARRAY_TASK_ID" = {task} ] && mkdir killed; then
  {program} "$@" &
  while [ ! -e {part} ]; do sleep 0.001; done
  kill -KILL $!
  exit 1
fi
exec {program} "$@"
"""


def sweep(members):
    """A jittered clock leaves nothing out, and a state hash is computed member by member: 30 us each."""
    clock = {"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.2, "seed": 1}}
    return {"format": "hyrax-sweep/1", "members": members, "seed": 3, "base": fling(steps=1200, clock=clock),
            "vary": {"/start/vx_px_per_s": {"uniform": [-2000, 2000]}, "/clock/jitter/seed": {"member": True}},
            "keep": ["final", "state_hash"]}


class Clusters(ProgramTest):
    """Parts by schedulers, against the file of one process."""

    def assert_same_as_one_process(self, parts):
        """Merged, and compared byte for byte."""
        self.expect(AGREED, "sweep", "--merge", *parts, "-o", "merged.h5")
        self.expect(AGREED, "sweep", "sweep.json", "-o", "whole.h5")
        self.assertEqual((self.folder / "merged.h5").read_bytes(), (self.folder / "whole.h5").read_bytes())

    def wait_until(self, what, condition):
        deadline = time.monotonic() + DEADLINE_S
        while not condition():
            self.assertLess(time.monotonic(), deadline, f"{what()} after {DEADLINE_S} s")
            time.sleep(0.05)

    def test_open_mpi_runs_a_part_in_each_rank(self):
        self.write("sweep.json", sweep(2_000))
        succeed("mpirun", "--allow-run-as-root", "--oversubscribe", "-n", 4, PROGRAM, "sweep", "sweep.json", "--threads", 1,
                cwd=self.folder)
        parts = [f"sweep.part-{index}-of-4.h5" for index in range(4)]
        self.expect(GOLDEN_MISSING, "sweep", "--merge", *parts[:3], "-o", "merged.h5")
        self.assert_same_as_one_process(parts)

    def test_a_slurm_array_of_which_a_task_is_killed(self):
        """By the job file that is shipped. One task is killed once it has begun its part, and requeued."""
        if os.geteuid() != 0:
            skip_for_lack_of("root, which the daemons of Slurm need")
        self.write("sweep.json", sweep(160_000))
        parts = [self.folder / f"sweep.part-{index}-of-{TASKS}.h5" for index in range(TASKS)]
        unfinished = parts[KILLED].with_name(f".{parts[KILLED].name}.part")
        self.write("bin/hyrax-sim", KILLED_ONCE.format(program=PROGRAM, part=unfinished, task=KILLED))
        (self.folder / "bin/hyrax-sim").chmod(0o755)
        with Cluster() as cluster:
            cluster.environment["PATH"] = f"{self.folder}/bin:{os.environ['PATH']}"
            job = cluster.command("sbatch", "--parsable", f"--array=0-{TASKS - 1}", "--cpus-per-task=1", "--mem=0",
                                  JOBS / "slurm.sh", "sweep.json", cwd=self.folder)

            def states():
                return cluster.states(job)

            self.wait_until(states, lambda: states().get(KILLED) == "FAILED")
            self.assertFalse(parts[KILLED].exists())
            self.assertTrue(unfinished.exists())
            cluster.command("scontrol", "requeue", f"{job}_{KILLED}")
            self.wait_until(states, lambda: states().get(KILLED) == "PENDING")
            # Slurm would wait until the credential of the run before is no longer valid: two minutes.
            cluster.command("scontrol", "update", f"JobId={job}_{KILLED}", "StartTime=now")
            self.wait_until(states, lambda: all(part.exists() for part in parts) and set(states().values()) <= {"COMPLETED"})
        self.assert_same_as_one_process(parts)
