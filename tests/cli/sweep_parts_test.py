"""sweep in parts, and interrupted: the file is that of one process."""

import contextlib
import os
import pathlib
import pty
import random
import re
import resource
import select
import shutil
import signal
import time

import h5py

from process import Process, run
from program import BAD_INPUT, CANNOT_ACCESS, GOLDEN_MISSING, PROGRAM, SOURCE
from sweep_members import ALL, base
from sweep_program import NO_CLUSTER, SEED, SweepTest, document

BLOCKS_WITHOUT_ROWS = 1000  # At most, of 512 bytes.
TRIES = 20


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

    def leave(self, name, rows_done):
        """Makes of a file the partial one of a process that was stopped after so many rows."""
        with h5py.File(self.folder / name, "a") as file:
            file.attrs["rows_done"] = rows_done
        os.rename(self.folder / name, self.folder / f"{name}.partial")

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
        whole = self.whole(document(base=base(steps=1), members=2**18 + 5, vary=vary, keep=["final"]))
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

    def test_an_unfinished_part_is_refused(self):
        first, second = self.two_parts()
        self.leave(second, rows_done=7)
        self.refuse(first, f"{second}.partial", says=(f"{second}.partial", "is not complete: 7 of 50 members are done", "--resume"))
        self.sweep("sweep.json", "--part", "1/2", "-o", "out.h5", "--resume")
        self.sweep("--merge", first, second, "-o", "merged.h5")

    def test_a_part_of_another_physics_model_is_neither_merged_nor_continued_and_a_result_is_computed_again(self):
        first, second = self.two_parts()
        for name in (second, self.file("out.h5")):
            with h5py.File(self.folder / name, "a") as file:
                file.attrs["physics"] = "other-physics/9"
        self.refuse(first, second, says=(second, "was computed by the physics model other-physics/9, the first file by hyrax-physics/1"))
        self.leave(second, rows_done=7)
        self.sweep("sweep.json", "--part", "1/2", "-o", "out.h5", "--resume", exit_code=BAD_INPUT,
                   says="is of another sweep, part or physics model; `--force` starts over")
        self.assertEqual(self.sweep("sweep.json", "-o", "out.h5", "--resume", "--json").json["computed"], 100)

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

    def test_a_merged_file_replaces_no_link_of_another_name(self):
        parts = self.two_parts()
        self.write("precious.txt", "precious")
        (self.folder / "merged.h5.partial").symlink_to("precious.txt")
        self.sweep("--merge", *parts, "-o", "merged.h5")
        self.assertEqual((self.folder / "precious.txt").read_text(), "precious")

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

    def test_a_task_of_the_job_files_that_is_repeated_resumes(self):
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
            self.assertEqual(["of them done before" in outcome.out for outcome in outcomes], [False, True], outcomes)
        self.assertEqual(self.names(), ["sweep.json", "sweep.part-3-of-100.h5", "sweep.part-3-of-4.h5"])

    def test_half_of_what_names_a_part_is_reported(self):
        self.write("sweep.json", document())
        for index, count in (("SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT"),
                             ("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"), ("JOB_COMPLETION_INDEX", "--parts N")):
            self.sweep("sweep.json", "--force", env={**NO_CLUSTER, index: "1"},
                       says=f"{index} without {count} names no part; this process computes all of them")
        self.assertEqual(self.names(), ["sweep.h5", "sweep.json"])


class Interrupted(FilesTest):
    def test_after_kills_at_random_moments_the_file_is_the_same(self):
        draws = random.Random(SEED)
        begin = time.monotonic()
        whole = self.whole(document(members=66_000, keep=["final", "contacts"]))
        duration_s = time.monotonic() - begin
        kills = 0
        while kills < 5 and not (self.folder / "out.h5").exists():
            with Process(PROGRAM, "sweep", "sweep.json", "--resume", "-o", "out.h5", cwd=self.folder,
                         env=NO_CLUSTER) as process:
                time.sleep(draws.uniform(0.02, max(0.05, duration_s / 3)))
                process.send(signal.SIGKILL)
                process.wait()
            kills += 1
        self.sweep("sweep.json", "--resume", "-o", "out.h5")
        self.assertTrue((self.folder / "out.h5").read_bytes() == whole, f"HYRAX_SEED={SEED}")
        self.assertEqual(self.names(), ["out.h5", "sweep.h5", "sweep.json"])

    def test_a_killed_sweep_leaves_nobody_who_holds_its_file(self):
        """Not the child process either that looks whether the file is damaged; this one it would read for as many seconds as its size allows."""
        self.write("sweep.json", document())
        shutil.copyfile(SOURCE / "tests/robustness/fuzz/found/trajectory/endless-heap.h5", self.folder / "out.h5.partial")
        os.truncate(self.folder / "out.h5.partial", 20 << 20)
        with Process(PROGRAM, "sweep", "sweep.json", "--resume", "-o", "out.h5", cwd=self.folder, env=NO_CLUSTER,
                     keeps_children=True) as process:
            children = pathlib.Path(f"/proc/{process.id}/task/{process.id}/children")
            while process.is_running and not children.read_text():
                time.sleep(0.001)
            child = os.pidfd_open(int(children.read_text()))
            self.addCleanup(os.close, child)
            process.send(signal.SIGKILL)
            self.assertEqual(process.wait().exit_code, -signal.SIGKILL)
        self.assertEqual(select.select([child], [], [], 5)[0], [child])
        self.sweep("sweep.json", "--force", "-o", "out.h5")

    def partial(self, sweep, *part, name="out.h5"):
        """The partial file that a signal leaves of it, and what the signal prints; on a busy machine it may come too late."""
        self.write("sweep.json", sweep)
        for _ in range(TRIES):
            process = self.begin("sweep", "sweep.json", "-o", "out.h5", *part, "--threads=1", env=NO_CLUSTER)
            while process.is_running and self.blocks(f"{name}.partial") <= BLOCKS_WITHOUT_ROWS:
                time.sleep(0.001)
            process.send(signal.SIGINT)
            outcome = process.wait()
            if not (self.folder / name).exists() and not re.search(r": (\d+) of \1 members", outcome.err):
                break
            for left in (name, f"{name}.partial"):
                (self.folder / left).unlink(missing_ok=True)
        self.assertEqual(outcome.exit_code, -signal.SIGINT)
        self.assertEqual(self.names(), [f"{name}.partial", "sweep.json"])
        return outcome.err

    def blocks(self, name):
        """Blocks of 512 bytes that a file takes; none if it is not there."""
        with contextlib.suppress(FileNotFoundError):
            return (self.folder / name).stat().st_blocks
        return 0

    def test_a_signal_says_what_is_left_and_a_resumed_file_of_many_columns_is_the_same(self):
        flings = [{"step": step, "fling": {"vx_px_per_s": 1, "vy_px_per_s": -3.5}} for step in range(1, 290, 20)]
        vary = {f"/events/{each}/fling/vx_px_per_s": {"uniform": [-500, 500]} for each in range(12)}
        sweep = document(base=base(events=flings), members=24_000, vary=vary, keep=ALL)
        name = "out.part-0-of-2.h5"
        said = self.partial(sweep, "--part=0/2", name=name)
        for arguments in (("--resume", "-o", "out.h5"), ("-o", "whole.h5")):
            self.sweep("sweep.json", "--part=0/2", *arguments)
        self.assertTrue((self.folder / name).read_bytes() == (self.folder / "whole.part-0-of-2.h5").read_bytes())
        done, size, unit = re.fullmatch(rf"{name}.partial: (\d+) of 12000 members are done, ([\d.]+) ([KM])iB; the same command "
                                        r"with `--resume` continues\n", said).groups()
        of_rows = int(done) / 12000 * (self.folder / name).stat().st_size
        self.assertTrue(0 < float(size) * 1024 ** " KM".index(unit) - of_rows < 200 * 1024, said)

    def test_the_progress_of_a_resumed_sweep_is_of_what_is_left(self):
        self.partial(document(members=400_000, keep=ALL))
        with h5py.File(self.folder / "out.h5.partial", "a") as file:
            file.attrs["rows_done"] = 250_000
        keeper, terminal = pty.openpty()
        self.addCleanup(os.close, keeper)
        process = self.begin("sweep", "sweep.json", "--resume", "-o", "out.h5", "--threads=1", env=NO_CLUSTER, stderr=terminal)
        os.close(terminal)
        shown = b""
        while b" members, " not in shown:
            shown += os.read(keeper, 65536)
        process.end()
        done, members = map(int, re.search(r"(\d+) of (\d+) members, ", shown.decode()).groups())
        self.assertEqual(members, 150_000)
        self.assertLess(done, members)

    def test_only_the_same_sweep_is_resumed(self):
        self.leave(self.file("out.h5"), rows_done=0)
        (self.folder / "other.h5.partial").write_bytes((self.folder / "out.h5.partial").read_bytes())
        self.write("other.json", document(seed=8))
        self.sweep("other.json", "--resume", exit_code=BAD_INPUT, says=("other.h5.partial", "another sweep"))
        (self.folder / "other.h5.partial").write_text("no HDF5")
        self.sweep("other.json", "--resume", exit_code=BAD_INPUT,
                   says="other.h5.partial: is no sweep's file that can be continued; `--force` starts over")
        self.assertEqual(self.sweep("sweep.json", "--resume", "-o", "out.h5", "--json").json["resumed"], 0)

    def test_a_part_with_fewer_than_no_rows_or_more_than_all_is_damaged(self):
        os.rename(self.folder / self.file("out.h5"), self.folder / "sweep.h5.partial")
        for rows, column in ((-1, "x"), (101, "x"), (0, "z")):
            with h5py.File(self.folder / "sweep.h5.partial", "a") as file:
                file.attrs["rows_done"] = rows
                file.move("members/x", f"members/{column}")
            self.sweep("sweep.json", "--resume", exit_code=BAD_INPUT, says="is damaged; `--force` starts over")
            self.assertEqual(self.names(), ["sweep.h5.partial", "sweep.json"])
        with h5py.File(self.folder / "sweep.h5.partial", "a") as file:
            file.attrs["rows_done"] = 100
            file.move("members/z", "members/x")
        self.assertEqual(self.sweep("sweep.json", "--resume", "--json").json["computed"], 0)
