"""hyrax-sim.exe under Wine: it prints what hyrax-sim prints here, with the same exit codes, and each reads what the other writes."""

import shutil

from hyrax_program import HyraxTest
from process import run, succeed
from program import AGREED, BAD_INPUT, BEFORE, CANNOT_ACCESS, DISAGREED, GOLDEN_MISSING, PROGRAM, SOURCE, fling

BUILD_S_MAX = 3600
FIRST = "scenarios/flings/first-fling.json"
# Command lines and their exit codes. The files that they write are those of the program that ran last.
COMMANDS = (
    ("check scenarios", AGREED), ("check scenarios --json -v", AGREED), ("check scenarios/flings --core", AGREED), ("check", AGREED),
    ("validate scenarios", AGREED), ("schema", AGREED), ("--help", AGREED), ("bless --help", AGREED), (f"drift {FIRST}", AGREED),
    (f"run {FIRST} -o out.h5", AGREED), (f"run {FIRST} -o -", AGREED), ("run own.json -o out.h5", AGREED), ("run fails.json -o out.h5", DISAGREED),
    ("diff golden/flings/first-fling.h5 golden/flings/corner-fling.h5", DISAGREED), ("check none.json", CANNOT_ACCESS),
    ("check own.json", GOLDEN_MISSING), ("check --golden", BAD_INPUT), ("nonsense", BAD_INPUT), ("new made --force", AGREED),
    ("shrink fails.json -o small.json --force", AGREED), ("study frame-rate --quick -o of-study", AGREED),
    ("sweep sweep.json -o out.h5", AGREED), ("sweep sweep.json --member 17 -o member.json --force", AGREED),
)


class SimExe(HyraxTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.exe = succeed(SOURCE / "tools/windows", "--yes", "hyrax-sim", env=BEFORE, timeout=BUILD_S_MAX).out.split()[-1]

    def setUp(self):
        super().setUp()
        self.folder = self.folder / "Übung mit Leerzeichen"
        self.folder.mkdir(parents=True)
        for name in ("scenarios", "golden"):
            shutil.copytree(SOURCE / name, self.folder / name)
        self.write("own.json", fling(name="own"))
        self.write("fails.json", fling(name="fails", expect={"contacts": {"top": 3}}))
        self.write("sweep.json", {"format": "hyrax-sweep/1", "base": fling(), "members": 1000, "seed": 7,
                                  "vary": {"/start/vx_px_per_s": {"uniform": [-2000, 2000]}}, "keep": ["final", "contacts"]})

    def on_windows(self, *arguments):
        return self.wine.run(self.exe, *arguments, cwd=self.folder, timeout=300)

    def here(self, *arguments):
        return run(PROGRAM, *arguments, cwd=self.folder, timeout=300)

    def test_prints_and_ends_as_here(self):
        for line, exit_code in COMMANDS:
            with self.subTest(line):
                there, here = self.on_windows(*line.split()), self.here(*line.split())
                self.assertEqual((there.exit_code, there.out, there.err), (exit_code, here.out, here.err))

    def test_finds_no_fault_in_random_scenarios(self):
        self.assertEqual(self.on_windows("fuzz", "--runs", "500").exit_code, AGREED)

    def test_each_reads_what_the_other_writes(self):
        tables = []
        for writer, reader in ((self.on_windows, self.here), (self.here, self.on_windows)):
            for name in ("ärger.csv", "now.h5"):
                self.assertEqual(writer("run", FIRST, "-o", name).exit_code, AGREED)
            tables.append((self.folder / "ärger.csv").read_bytes())
            self.assertEqual(reader("diff", "golden/flings/first-fling.h5", "now.h5").exit_code, AGREED)
            shutil.rmtree(self.folder / "golden")
            self.assertEqual(writer("bless", "scenarios", "--reason", "tried").exit_code, AGREED)
            self.assertEqual(reader("check", "scenarios").exit_code, AGREED)
        self.assertEqual(*tables)
        self.assertEqual([path.name for path in self.folder.rglob("*.part")], [])

    def test_a_damaged_golden_file_disagrees(self):
        path = self.folder / "golden/flings/first-fling.h5"
        path.write_bytes(path.read_bytes().replace(b"hyrax-trajectory/", b"hyrax-trajectorx/", 1))
        self.assertEqual(self.on_windows("check", FIRST).exit_code, BAD_INPUT)
