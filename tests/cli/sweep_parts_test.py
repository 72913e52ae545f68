"""sweep in parts: the file is that of one process; and interrupted: it leaves nothing that looks finished."""

import contextlib
import os
import pathlib
import re
import resource
import select
import shutil
import signal
import time

import h5py

from process import Process, run
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, GOLDEN_MISSING, PROGRAM, SOURCE, fling
from sweep_members import ALL, base
from sweep_program import NO_CLUSTER, SweepTest, document

BLOCKS_WITHOUT_ROWS = 1000  # At most, of 512 bytes.


class FilesTest(SweepTest):
    """Files of the usual sweep."""

    def file(self, name, *arguments):
        """Writes the file that it gives with these arguments; returns its name."""
        self.write("sweep.json", document())
        self.sweep("sweep.json", "-o", "out.h5", *arguments)
        return name

    def two_parts(self):
        """The names of the sweep's two parts."""
        return tuple(self.file(f"out.part-{part}-of-2.h5", "--part", f"{part}/2") for part in (0, 1))

    def whole(self, sweep):
        """The file of one process."""
        self.write("sweep.json", sweep)
        self.sweep("sweep.json")
        return (self.folder / "sweep.h5").read_bytes()


class Parts(FilesTest):
    def merged(self, parts):
        """The file of a sweep in that many parts, more than the files that may be open unless a program asks."""
        for part in range(parts):
            self.sweep("sweep.json", "--part", f"{part}/{parts}", "-o", "out.h5")
        names = [f"out.part-{part}-of-{parts}.h5" for part in reversed(range(parts))]
        limits = 10, resource.getrlimit(resource.RLIMIT_NOFILE)[1]
        self.sweep("--merge", *names, "-o", f"merged-{parts}.h5",
                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, limits))
        return (self.folder / f"merged-{parts}.h5").read_bytes()

    def test_parts_give_the_file_of_one_process(self):
        whole = self.whole(document(members=70, keep=ALL))
        for parts in (1, 8):
            self.assertTrue(self.merged(parts) == whole, f"{parts} parts")

    def test_many_members_are_merged_in_pieces(self):
        vary = {"/start/vx_px_per_s": {"uniform": [-2000, 2000]}}
        whole = self.whole(document(base=base(steps=1), members=2**16 + 5, vary=vary, keep=["final"]))
        self.assertTrue(self.merged(3) == whole)

    def refuse(self, *parts, says, exit_code=BAD_INPUT):
        """They are not merged, and nothing is written."""
        before = self.names()
        self.sweep("--merge", *parts, "-o", "merged.h5", exit_code=exit_code, says=says)
        self.assertEqual(self.names(), before)

    def test_parts_that_are_missing_or_of_another_sweep_are_refused(self):
        self.write("other.json", document(seed=8))
        self.sweep("other.json", "--part", "1/2", "-o", "other.h5")
        for part in ("0/4", "2/4", "0/2", "1/3"):
            self.file("", "--part", part)
        self.file("out.h5")
        self.refuse("out.part-0-of-4.h5", "out.part-2-of-4.h5", exit_code=GOLDEN_MISSING,
                    says=[f"out.part-{part}-of-4.h5: is missing; nothing was written\n" for part in (1, 3)])
        os.rename(self.folder / "out.part-0-of-4.h5", self.folder / "first.h5")
        self.refuse("first.h5", exit_code=GOLDEN_MISSING, says="part-1-of-4: is missing")
        for other, says in (("other.part-1-of-2.h5", "is a part of another sweep"),
                            ("out.part-1-of-3.h5", "is one of 3 parts"), ("out.part-0-of-2.h5", "given twice"),
                            ("out.h5", "is no part of a sweep"), ("sweep.json", "is no result file")):
            self.refuse("out.part-0-of-2.h5", other, says=(other, says))
        self.refuse("out.part-0-of-2.h5", "nowhere.h5", exit_code=CANNOT_ACCESS, says="nowhere.h5")

    def test_a_part_that_is_not_complete_is_refused(self):
        first, second = self.two_parts()
        with h5py.File(self.folder / second, "a") as file:
            file.attrs["rows_done"] = 7
        self.refuse(first, second, says=f"{second}: is not complete: an older version was stopped while it wrote it; run the sweep again")

    def test_a_part_of_another_physics_model_is_not_merged(self):
        first, second = self.two_parts()
        with h5py.File(self.folder / second, "a") as file:
            file.attrs["physics"] = "other-physics/9"
        self.refuse(first, second, says=(second, "was computed by the physics model other-physics/9, the first file by hyrax-physics/1"))

    def test_parts_of_two_cores_or_of_one_that_is_not_named_are_not_merged(self):
        first, second = self.two_parts()
        accepted, = re.findall(r"(?m)^step: (\w+)$", (SOURCE / "golden/core/accepted.txt").read_text())
        self.file("whole.h5")
        self.expect(AGREED, "run", self.write("fling.json", fling()), "-o", "fling.h5", "-q")
        for name in (first, second, "out.h5", "fling.h5"):
            with h5py.File(self.folder / name) as file:
                self.assertEqual(file.attrs["core"], accepted, name)
        other = 32 * "7"
        for core, found in ((other, other), (None, "not named")):
            with h5py.File(self.folder / second, "a") as file:
                del file.attrs["core"]
                if core:
                    file.attrs["core"] = core
            self.refuse(first, second, says=f"{second}: was computed by another core than the first file ({found}, the first file: {accepted})")
            self.refuse(second, first, says=f"{first}: was computed by another core than the first file ({accepted}, the first file: {found})")
        with h5py.File(self.folder / first, "a") as file:
            del file.attrs["core"]
        self.sweep("--merge", first, second, "-o", "merged.h5")  # As earlier versions wrote them.
        with h5py.File(self.folder / "merged.h5") as file:
            self.assertNotIn("core", file.attrs)

    def test_altered_inputs_are_refused(self):
        first, second = self.two_parts()
        rule = re.search(r"plays every member i with\s+(.*?) into", (SOURCE / "sim/ensemble/README.md").read_text())[1]
        members = [i for i in range(100) if eval(rule.replace("mod", "%").replace("=", "=="), {}, {"i": i, "N": 2, "I": 1})]  # pylint: disable=eval-used
        vx = "inputs/start.vx_px_per_s"
        for change, says in ((lambda file: file[vx].write_direct(file[vx][:] + [0, 0, 0, 0, 1, *45 * [0]]),
                              f"{vx}: the input of member {members[4]} is not the sweep's"),
                             (lambda file: file.move("members/x", "members/z"), "is damaged: a column is missing, or has another length"),
                             (lambda file: file.attrs.update(part=2), "is no result file of a sweep")):
            with h5py.File(self.folder / second, "a") as file:
                change(file)
            self.refuse(first, second, says=f"{second}: {says}")

    def test_a_part_whose_seeds_go_to_the_largest_is_read_again(self):
        clock = {"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.2, "seed": 3}}
        self.write("sweep.json", document(base=base(clock=clock), vary={"/clock/jitter/seed": {"uniform": [0, 2 ** 64 - 1]}}))
        self.sweep("sweep.json", "--part", "0/1", "-o", "out.h5")
        self.sweep("--merge", "out.part-0-of-1.h5", "-o", "merged.h5")

    def test_a_scheduler_names_the_part(self):
        self.write("sweep.json", document())
        for variables, arguments, part in (
                ({"SLURM_ARRAY_TASK_ID": "11", "SLURM_ARRAY_TASK_MIN": "10", "SLURM_ARRAY_TASK_COUNT": "4"}, (),
                 "1-of-4"),
                ({"SLURM_ARRAY_TASK_ID": "3", "SLURM_ARRAY_TASK_COUNT": "4"}, (), "3-of-4"),
                ({"SLURM_ARRAY_TASK_ID": "7", "SLURM_ARRAY_TASK_MIN": "1", "SLURM_ARRAY_TASK_STEP": "3",
                  "SLURM_ARRAY_TASK_COUNT": "4"}, (), "2-of-4"),
                ({"OMPI_COMM_WORLD_RANK": "2", "OMPI_COMM_WORLD_SIZE": "3"}, (), "2-of-3"),
                ({"JOB_COMPLETION_INDEX": "0"}, ("--parts", "2"), "0-of-2")):
            outcome = self.sweep("sweep.json", "-o", "out.h5", *arguments, env={**NO_CLUSTER, **variables})
            self.assertIn(next(iter(variables)), outcome.err)
            self.assertIn(f"out.part-{part}.h5", self.names())
        self.sweep("sweep.json", "-o", "out.h5", "--part", "0/9",
                   env={**NO_CLUSTER, "OMPI_COMM_WORLD_RANK": "2", "OMPI_COMM_WORLD_SIZE": "3"})
        self.assertIn("out.part-0-of-9.h5", self.names())

    def test_a_task_of_the_job_files_can_be_repeated(self):
        self.write("sweep.json", document())
        jobs = SOURCE / "sim/ensemble/jobs"
        job = (jobs / "kubernetes.yaml").read_text()
        command = re.search(r"command: \[(.*)\]", job)[1].replace('"', "").split(", ")
        self.assertEqual(re.findall(r"(?:completions|parallelism): (\d+)\n", job), 2 * [command[command.index("--parts") + 1]])
        self.assertEqual(re.findall(r'cpu: "(\d+)"', job), [command[command.index("--threads") + 1]])
        for text, repeats in ((job, "      restartPolicy: OnFailure"), ((jobs / "slurm.sh").read_text(), "#SBATCH --requeue")):
            self.assertIn(repeats, text.splitlines())
        for task, variables in ((("bash", jobs / "slurm.sh", "sweep.json"), {"SLURM_ARRAY_TASK_ID": "3", "SLURM_ARRAY_TASK_COUNT": "4"}),
                                (command, {"JOB_COMPLETION_INDEX": "3"})):
            environment = {**NO_CLUSTER, **variables, "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}
            outcomes = [run(*task, cwd=self.folder, env=environment) for _ in range(2)]
            self.assertEqual([outcome.exit_code for outcome in outcomes], [0, 0], outcomes)
        self.assertEqual(self.names(), ["sweep.json", "sweep.part-3-of-100.h5", "sweep.part-3-of-4.h5"])

    def test_half_of_what_names_a_part_is_reported(self):
        self.write("sweep.json", document())
        for index, count in (("SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT"),
                             ("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"), ("JOB_COMPLETION_INDEX", "--parts N")):
            self.sweep("sweep.json", env={**NO_CLUSTER, index: "1"},
                       says=f"{index} without {count} names no part; this process computes all of them")
        self.assertEqual(self.names(), ["sweep.h5", "sweep.json"])


class Interrupted(FilesTest):
    def test_what_a_kill_leaves_is_no_result_and_goes_with_the_next_sweep(self):
        self.write("sweep.json", document(members=40_000, keep=ALL))
        with Process(PROGRAM, "sweep", "sweep.json", "--part=0/1", "-o", "out.h5", "--threads=1", cwd=self.folder, env=NO_CLUSTER) as process:
            while process.is_running and self.blocks(".out.part-0-of-1.h5.part") <= BLOCKS_WITHOUT_ROWS:
                time.sleep(0.001)
            process.send(signal.SIGKILL)
            self.assertEqual(process.wait().exit_code, -signal.SIGKILL)
        self.assertEqual(self.names(), [".out.part-0-of-1.h5.part", "sweep.json"])
        self.sweep("--merge", ".out.part-0-of-1.h5.part", "-o", "merged.h5", exit_code=BAD_INPUT, says=".out.part-0-of-1.h5.part: is ")
        self.file("", "--part=0/1")
        self.assertEqual(self.names(), ["out.part-0-of-1.h5", "sweep.json"])

    def blocks(self, name):
        """Blocks of 512 bytes that a file takes; none if it is not there."""
        with contextlib.suppress(FileNotFoundError):
            return (self.folder / name).stat().st_blocks
        return 0

    def test_a_killed_process_leaves_no_child_that_reads_for_it(self):
        """The child process looks whether the file is damaged; this one it would read for as many seconds as its size allows."""
        shutil.copyfile(SOURCE / "tests/robustness/fuzz/found/trajectory/endless-heap.h5", self.folder / "part.h5")
        os.truncate(self.folder / "part.h5", 20 << 20)
        with Process(PROGRAM, "sweep", "--merge", "part.h5", "-o", "out.h5", cwd=self.folder, env=NO_CLUSTER,
                     keeps_children=True) as process:
            children = pathlib.Path(f"/proc/{process.id}/task/{process.id}/children")
            while process.is_running and not children.read_text():
                time.sleep(0.001)
            child = os.pidfd_open(int(children.read_text()))
            self.addCleanup(os.close, child)
            process.send(signal.SIGKILL)
            self.assertEqual(process.wait().exit_code, -signal.SIGKILL)
        self.assertEqual(select.select([child], [], [], 5)[0], [child])

    def test_a_sweep_is_not_resumed(self):
        self.write("sweep.json", document())
        self.sweep("sweep.json", "--resume", exit_code=BAD_INPUT,
                   says="hyrax-sim sweep: --resume: was removed; use --part and --merge: a part that was stopped is computed again")
        self.assertEqual(self.names(), ["sweep.json"])
