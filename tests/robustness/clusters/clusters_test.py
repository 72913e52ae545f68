#!/usr/bin/python3
"""Sweeps in parts, by real schedulers: the parts join to the file of one process, whatever happens to tasks."""

import contextlib
import os
import pathlib
import signal
import time

from process import skip_for_lack_of, skip_without, succeed
from program import AGREED, GOLDEN_MISSING, PROGRAM, ProgramTest, fling, main
from slurm import Cluster

JOBS = pathlib.Path(os.environ["HYRAX_JOBS"])
TASKS = 8
DEADLINE_S = 120


def sweep(members):
    """A jittered clock leaves nothing out, and a state hash is computed member by member: 30 us each."""
    clock = {"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.2, "seed": 1}}
    return {"format": "hyrax-sweep/1", "members": members, "seed": 3, "base": fling(steps=1200, clock=clock),
            "vary": {"/start/vx_px_per_s": {"uniform": [-2000, 2000]}, "/clock/jitter/seed": {"member": True}},
            "keep": ["final", "state_hash"]}


def process_state(process):
    """The letter of a process's state in Linux: T if it is suspended."""
    return pathlib.Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0]


class Clusters(ProgramTest):
    """Parts by schedulers, against the file of one process."""

    def assert_same_as_one_process(self, parts):
        """Merged, and compared byte for byte."""
        self.expect(AGREED, "sweep", "--merge", *parts, "-o", "merged.h5")
        self.expect(AGREED, "sweep", "sweep.json", "-o", "whole.h5")
        self.assertEqual((self.folder / "merged.h5").read_bytes(), (self.folder / "whole.h5").read_bytes())

    def wait_until(self, what, condition):
        """What the condition gives, once it holds."""
        deadline = time.monotonic() + DEADLINE_S
        while (found := condition()) in (None, False):
            self.assertLess(time.monotonic(), deadline, f"{what()} after {DEADLINE_S} s")
            time.sleep(0.05)
        return found

    def computing(self):
        """(task, process) for each process of the program in this folder."""
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):
                if (entry / "exe").readlink() == PROGRAM and (entry / "cwd").readlink() == self.folder:
                    for variable in (entry / "environ").read_text(errors="replace").split("\0"):
                        if variable.startswith("SLURM_ARRAY_TASK_ID="):
                            yield int(variable.partition("=")[2]), int(entry.name)

    def suspended_at_work(self, parts):
        """(task, process) of a process that has begun its part and cannot end it; none if none is at work."""
        for task, process in self.computing():
            with contextlib.suppress(OSError):
                os.kill(process, signal.SIGSTOP)
                while (state := process_state(process)) not in "TZX":
                    time.sleep(0.001)
                if state == "T" and pathlib.Path(f"{parts[task]}.partial").exists():
                    return task, process
                os.kill(process, signal.SIGCONT)
        return None

    def test_open_mpi_runs_a_part_in_each_rank(self):
        self.write("sweep.json", sweep(2_000))
        succeed("mpirun", "--allow-run-as-root", "--oversubscribe", "-n", 4, PROGRAM, "sweep", "sweep.json", "--threads", 1,
                cwd=self.folder)
        parts = [f"sweep.part-{index}-of-4.h5" for index in range(4)]
        self.expect(GOLDEN_MISSING, "sweep", "--merge", *parts[:3], "-o", "merged.h5")
        self.assert_same_as_one_process(parts)

    def test_a_slurm_array_of_which_tasks_are_killed(self):
        """By the job file that is shipped. One task is killed, one is requeued while it runs."""
        if os.geteuid() != 0:
            skip_for_lack_of("root, which the daemons of Slurm need")
        self.write("sweep.json", sweep(320_000))
        parts = [self.folder / f"sweep.part-{index}-of-{TASKS}.h5" for index in range(TASKS)]
        with Cluster() as cluster:
            cluster.environment["PATH"] = f"{PROGRAM.parent}:{os.environ['PATH']}"
            job = cluster.command("sbatch", "--parsable", f"--array=0-{TASKS - 1}", "--cpus-per-task=1", "--mem=0",
                                  JOBS / "slurm.sh", "sweep.json", cwd=self.folder)

            def states():
                return cluster.states(job)

            first, process = self.wait_until(states, lambda: self.suspended_at_work(parts))
            os.kill(process, signal.SIGKILL)
            self.wait_until(states, lambda: first not in dict(self.computing()))  # A killed one is seen for a moment.
            second, _ = self.wait_until(states, lambda: self.suspended_at_work(parts))
            self.wait_until(states, lambda: states().get(first) == "FAILED")
            self.assertFalse(parts[first].exists())
            self.assertEqual(states()[second], "RUNNING")
            for task in (first, second):
                cluster.command("scontrol", "requeue", f"{job}_{task}")
                self.wait_until(states, lambda: states().get(task) == "PENDING")  # pylint: disable=cell-var-from-loop
                # Slurm would wait until the credential of the run before is no longer valid: two minutes.
                cluster.command("scontrol", "update", f"JobId={job}_{task}", "StartTime=now")
            self.wait_until(states, lambda: all(part.exists() for part in parts) and set(states().values()) <= {"COMPLETED"})
        self.assert_same_as_one_process(parts)


if __name__ == "__main__":
    skip_without("mpirun", "slurmctld", "slurmd", "sbatch", "munged")
    main()
