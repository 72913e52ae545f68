"""Lists of documents are those of the sources and files that have them."""

import json
import re
import sys
import unittest

import h5py

from document_numbers_test import DRIFT, FILES, HYRAX, PHYSICS_CONSTANTS, TESTS
from documentation_test import text_of
from program import SOURCE

sys.path.insert(0, str(SOURCE / "tests/platforms"))
from rows import BUILDS  # noqa: E402 pylint: disable=wrong-import-position


class Lists(unittest.TestCase):
    """What a reader looks up."""

    def test_sim_has_the_folders_that_are_listed_and_neither_reads_nor_prints(self):
        listed = re.findall(r"^\| (?:\[(\w+)\]\(.*?\)|`(\w+)`) \|", text_of("sim/README.md"), re.MULTILINE)
        self.assertEqual(sorted(map("".join, listed)), sorted(path.name for path in (SOURCE / "sim").iterdir() if path.is_dir()))
        for path in (*(SOURCE / "sim").rglob("*.cpp"), *(SOURCE / "sim").rglob("*.h")):
            if path.parent != SOURCE / "sim/trace/host":
                self.assertNotRegex(text_of(path), r"\b(chrono|getenv|fstream|iostream|fopen|setlocale|printf|fputs)\b", path)

    def test_platforms_are_those_of_the_matrix(self):
        rows = re.findall(r"^\| ([^|]*) \| ([^|]*) \| ([^|]*) \| [^|]* \| \d+ of \d+ agree", text_of(TESTS), re.MULTILINE)
        flags = {builder: set(re.findall(r"`([^`]*)`", cell)) for name, builder, cell in rows if name == "x86-64"}
        by = {each: {row.flags for row in BUILDS if row.name == f"{each} {row.flags}"} for each in ("g++", "clang++", "clang++-22")}
        self.assertEqual(flags, {"g++ 12": by["g++"], "clang 14, clang 22": by["clang++"]})
        self.assertEqual(by["clang++"], by["clang++-22"])
        named = " ".join(name for name, _, _ in rows)
        self.assertEqual([row.name for row in BUILDS if row.runner and row.name.split()[0].strip(",") not in named], [])

    def test_datasets_of_a_file_are_those_of_the_table(self):
        rows = re.findall(r"^\| (`/(?:trajectory|contacts|events)/.*?) \| (?:enum )?(\w+) \[([NME])\] \|", text_of(FILES), re.MULTILINE)
        tabled = {name if name.startswith("/") else f"{names[0].rpartition('/')[0]}/{name}": (kind, length)
                  for cell, kind, length in rows for names in [re.findall("`(.*?)`", cell)] for name in names}
        found = {}
        inputs = re.search(r"`/events/kind` \| enum uint8 \[E\] \| (.*?) \|", text_of(FILES))[1]
        with h5py.File(SOURCE / "golden/flings/corner-fling.h5") as file:
            codes = {name: int(code) for name, code in re.findall(r"([a-z-]+) (\d)", inputs)}
            self.assertEqual(codes, h5py.check_enum_dtype(file["events/kind"].dtype))
            scale_name = "/trajectory/" + re.search(r"`(\w+)` is the dimension scale of the others", text_of(FILES))[1]
            self.assertIn("| `/events/frame` | int64 [E] | the frame of each input |", text_of(FILES))
            self.assertEqual([event["step"] for event in json.loads(file.attrs["scenario"])["events"][:6]], list(file["events/frame"][:6]))
            lengths = {"trajectory": "N", "contacts": "M", "events": "E"}
            for group, length in lengths.items():
                for dataset in file[group].values() if group == "trajectory" else ():
                    self.assertEqual([scale.name for scale in dataset.dims[0].values()], [] if dataset.name == scale_name else [scale_name])
                found.update({dataset.name: (dataset.dtype.name, length) for dataset in file[group].values()})
                self.assertEqual({dataset.shape for dataset in file[group].values()}, {(len(next(iter(file[group].values()))),)})
            self.assertEqual(set(re.findall(r"`(\w+)`", re.search(r"\| `/`, attributes \|.*?\n", text_of(FILES))[0])) -
                             set(PHYSICS_CONSTANTS.split(", ")), set(file.attrs) - {"default", "NX_class"} | {"core"})  # Which this file, of an earlier version, has not.
        self.assertEqual(tabled, found)

    def test_the_menu_of_hyrax_has_what_is_listed(self):
        entries = re.findall(r'\{Choice::\w+, (?:state.is_paused \? "&Go on" : )?"(.*?)"', text_of("tools/hyrax/menu.cpp"))
        listed = " ".join(re.search(r"for the menu: (.*?)\.", text_of(HYRAX), re.DOTALL)[1].split())
        self.assertEqual(listed.replace("start and save a recording", "start recording, save recording").split(", "),
                         [entry.replace("&", "").lower().removesuffix(" hyrax") for entry in entries])

    def test_every_nightly_test_is_listed(self):
        lists = "".join(text_of(path) for path in (SOURCE / "tests").rglob("CMakeLists.txt"))
        nightly = set(" ".join(re.findall(r"hyrax_label\(nightly ([^)]*)\)", lists)).split())
        self.assertGreater(len(nightly), 10)
        listed = re.search(r"^\| `nightly` \| .*", text_of(TESTS), re.MULTILINE)[0]
        self.assertLessEqual(nightly, set(re.findall(r"`([\w-]+\.[\w-]+)`", listed)))

    def test_columns_of_rows_have_their_units(self):
        columns = re.findall(r'\{"(\w+)", "([\w/]+)", "[^"]*", &Row::', text_of("sim/trajectory/columns.h"))
        names, units = re.search(r"`/trajectory/(t`.*?) \| float64 \[N\] \| `units` (.*?)\.", text_of(FILES)).groups()
        self.assertEqual(list(zip(re.findall(r"\w+", names), units.split(", "), strict=True)), columns)
        csv = [f"{name}_{unit.replace('/', '_per_')}" for name, unit in columns]
        self.assertIn(f"`{','.join(['step', *csv, 'contact'])}`", text_of(FILES))

    def test_errors_of_contacts_are_what_their_columns_are(self):
        columns = text_of("sim/reference/drift_columns.h")
        rows = re.findall(r"^\| ([a-z ]+) \| (.*) \|$", text_of(DRIFT).partition("| column | meaning |")[2].partition("\n\n")[0], re.MULTILINE)
        self.assertEqual([head for head, _ in rows], ["time error", "overshoot", "energy jump", "restitution"])
        for head, meaning in rows:
            described, = re.findall(rf'"([^"]*)",[^"]*"",\s*DriftShown\("{head}"', columns)
            self.assertTrue(meaning.startswith(described.partition(",")[0]), (meaning, described))
