"""hyrax.exe as a file: its dependencies, contents and protections. package.packages builds it twice."""

import os
import pathlib
import re
import struct
import tempfile
import unittest

from hyrax_program import FOLDER, HYRAX, HYRAX_REPLAY
from process import skip_without, succeed

SOURCE = pathlib.Path(__file__).resolve().parents[3]
TOOLS = "x86_64-w64-mingw32-"
skip_without(TOOLS + "objdump", TOOLS + "g++-posix")

# Parts of every Windows 10, of the compiler's nothing.
WINDOWS_DLLS = {"advapi32.dll", "gdi32.dll", "gdiplus.dll", "kernel32.dll", "msvcrt.dll", "ole32.dll", "shcore.dll",
                "shell32.dll", "shlwapi.dll", "user32.dll", "version.dll", "winmm.dll"}
SIZE_MAX_BYTES = 1_000_000
HIGH_ENTROPY, DYNAMIC_BASE, NX_COMPATIBLE = 0x20, 0x40, 0x100

HYRAX_SIM = pathlib.Path(os.environ.get("HYRAX_SIM", "hyrax-sim"))

RT_ICON, RT_RCDATA, RT_GROUP_ICON, RT_VERSION, RT_MANIFEST = 3, 10, 14, 16, 24


def headers(path):
    """Of a program, as text."""
    return succeed(TOOLS + "objdump", "-p", path).out


def resources(path):
    """Its resources, as {type: {name: bytes}}. They lie in the section .rsrc as a tree of three levels."""
    sections = succeed(TOOLS + "objdump", "-h", path).out
    size, address = (int(text, 16) for text in re.search(r"\.rsrc\s+(\w+)\s+(\w+)", sections).groups())
    base = int(re.search(r"ImageBase\s+(\w+)", headers(path)).group(1), 16)
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder, "rsrc")
        succeed(TOOLS + "objcopy", "-O", "binary", "--only-section=.rsrc", "--set-section-flags",
            ".rsrc=alloc,load,contents", path, copy)
        tree = copy.read_bytes()[:size]

    def entries(place):
        named, numbered = struct.unpack_from("<HH", tree, place + 12)
        for entry in range(named + numbered):
            yield struct.unpack_from("<II", tree, place + 16 + 8 * entry)

    found = {}
    for kind, names in entries(0):
        for name, languages in entries(names & 0x7FFFFFFF):
            for _, leaf in entries(languages & 0x7FFFFFFF):
                place, length = struct.unpack_from("<II", tree, leaf)
                begin = place - (address - base)
                found.setdefault(kind, {})[name] = tree[begin:begin + length]
    return found


class Executable(unittest.TestCase):
    def test_it_needs_only_what_every_windows_has_and_is_protected(self):
        for program, shows in ((HYRAX, "Windows GUI"), (HYRAX_REPLAY, "Windows CUI")):
            head = headers(program)
            imports = {name.lower() for name in re.findall(r"DLL Name: (\S+)", head)}
            self.assertLessEqual(imports, WINDOWS_DLLS)
            self.assertEqual("gdiplus.dll" in imports, program == HYRAX)
            flags = int(re.search(r"DllCharacteristics\s+(\w+)", head).group(1), 16)
            for flag in (HIGH_ENTROPY, DYNAMIC_BASE, NX_COMPATIBLE):
                self.assertTrue(flags & flag, f"{flags:#x} lacks {flag:#x}")
            self.assertIn("[.reloc]", head)
            self.assertIn(shows, head)  # A console, or none.

    def test_it_is_small(self):
        self.assertLess(HYRAX.stat().st_size, SIZE_MAX_BYTES)

    def test_the_step_of_its_core_is_known(self):
        record = FOLDER / "mingw/sim/hyrax_core_record"
        self.assertFalse((record / "why_incomplete.txt").exists())
        self.assertTrue((record / "is_listing.txt").exists())

    def test_it_has_icon_version_manifest_and_sprites(self):
        found = resources(HYRAX)
        self.assertEqual(len(found[RT_ICON]), 7)
        self.assertEqual(len(found[RT_GROUP_ICON]), 1)
        for program in (HYRAX, HYRAX_REPLAY):
            manifest, = resources(program)[RT_MANIFEST].values()
            # The last: Windows 10.
            for text in (b"PerMonitorV2", b"asInvoker", b">UTF-8<", b"longPathAware", b"{8e0f7a12-bfb3-4fe8-b9a5-48fd50a15a9a}"):
                self.assertIn(text, manifest)
        version, = found[RT_VERSION].values()
        project = re.search(r"VERSION (\d+\.\d+\.\d+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
        self.assertIn(project.encode("utf-16-le"), version)
        pictures = sorted(path.read_bytes() for path in (SOURCE / "tools/hyrax/sprite").glob("*.png"))
        self.assertEqual(sorted(found[RT_RCDATA].values()), pictures)

    def test_no_gpl_library_is_linked(self):
        files = (FOLDER / "mingw/build.ninja").read_text()
        link = re.findall(r"build bin/hyrax(?:-replay)?\.exe:(.*?)\n\n", files, re.DOTALL)
        self.assertEqual(len(link), 2)
        for line in link:
            self.assertNotRegex(line, r"(?i)gsl|hdf5|mpfr|gmp")
        for program in (HYRAX, HYRAX_REPLAY):
            self.assertNotRegex(program.read_bytes(), rb"gsl_(odeiv2|error|strerror)")
        self.assertRegex(HYRAX_SIM.read_bytes(), rb"gsl_(odeiv2|error|strerror)")  # Control: found where GSL is linked.
