#!/usr/bin/python3
"""The packages, as tools/package builds them: twice from two folders, then unpacked, used and installed in a bare Debian."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile

from process import run, skip_without, succeed
from program import AGREED, BEFORE, DISAGREED, GOLDEN_MISSING, SOURCE

EPOCH = 1_700_000_000
BUILD_S_MAX = 1800
CHECK_S_MAX = 20
ENVIRONMENT = {**BEFORE, "SOURCE_DATE_EPOCH": str(EPOCH), "CCACHE_DISABLE": "1"}
DEB, ZIP = "*.deb", "*.zip"


def copy_of_source(folder):
    """The tracked files in another folder, without Git."""
    names = subprocess.run(["git", "-C", SOURCE, "ls-files", "-z"], check=True, capture_output=True).stdout
    folder.mkdir(parents=True)
    subprocess.run(["cp", "--parents", "--no-dereference", "-t", folder, *names.decode().rstrip("\0").split("\0")],
                   check=True, cwd=SOURCE)
    return folder


def mirror():
    """(suite, address) of the Debian that apt installs from."""
    targets = succeed("apt-get", "indextargets", "--format", "$(LABEL)|$(COMPONENT)|$(CODENAME)|$(REPO_URI)").out
    return re.search(r"^Debian\|main\|([a-z]+)\|(\S+)$", targets, re.MULTILINE).groups()


def in_namespace(*command, **options):
    """Runs a command with mounts and processes of its own, which end with it."""
    return run("unshare", "--mount", "--pid", "--fork", "--kill-child", *command, **options)


def bare_debian(folder):
    suite, address = mirror()
    bare = in_namespace("debootstrap", "--variant=minbase", suite, folder, address, timeout=600)
    assert bare.exit_code == 0, str(bare)
    return folder


class Packages(unittest.TestCase):
    """Both packages, built in two folders."""

    @classmethod
    def setUpClass(cls):
        cls.work = pathlib.Path(tempfile.mkdtemp(prefix="hyrax-package-"))
        cls.addClassCleanup(shutil.rmtree, cls.work)
        cls.sources = [copy_of_source(cls.work / name) for name in ("one", "another/deeper")]
        for source in cls.sources:
            succeed(source / "tools/package", "--yes", env=ENVIRONMENT, timeout=BUILD_S_MAX)
        cls.folders = [source / "build/packages" for source in cls.sources]
        cls.deb, cls.zip = (next(cls.folders[0].glob(pattern)) for pattern in (DEB, ZIP))
        cls.unpacked = cls.work / "unpacked"
        succeed("dpkg-deb", "-x", cls.deb, cls.unpacked)

    def test_the_same_source_gives_the_same_bytes(self):
        first, second = ({path.name: path.read_bytes() for path in folder.iterdir()} for folder in self.folders)
        self.assertEqual(sorted(first), sorted([self.deb.name, self.zip.name, "SHA256SUMS"]))
        self.assertEqual(first.keys(), second.keys())
        for name, content in first.items():
            self.assertTrue(content == second[name], f"{name} differs")
        succeed("sha256sum", "--check", "--strict", "SHA256SUMS", cwd=self.folders[0])
        self.assertEqual((self.folders[0] / "SHA256SUMS").read_text().count("\n"), 2)

    def test_the_debian_package_has_all_parts(self):
        names = {str(path.relative_to(self.unpacked)) for path in self.unpacked.rglob("*") if path.is_file()}
        library = succeed("dpkg-architecture", "-qDEB_HOST_MULTIARCH").out.strip()
        for name in ("bin/hyrax-sim", f"lib/{library}/libhyrax_physics.a", f"lib/{library}/cmake/hyrax/hyrax-config.cmake",
                     "include/hyrax/sim/physics/physics.h", "share/doc/hyrax-sim/copyright", "share/man/man1/hyrax-sim.1.gz",
                     "share/bash-completion/completions/hyrax-sim"):
            self.assertIn(f"usr/{name}", names)
        for folder in ("scenarios", "golden"):
            tracked = {f"usr/share/hyrax-sim/{name}" for name in succeed("git", "-C", SOURCE, "ls-files", folder).out.split()}
            self.assertEqual({name for name in names if name.startswith(f"usr/share/hyrax-sim/{folder}/")}, tracked)
        self.assertIn("GPL, version 3", (self.unpacked / "usr/share/doc/hyrax-sim/copyright").read_text())
        listed = succeed("dpkg-deb", "-c", self.deb).out.splitlines()
        self.assertEqual({line.split()[1] for line in listed}, {"root/root"})
        self.assertEqual({line[:10] for line in listed}, {"drwxr-xr-x", "-rwxr-xr-x", "-rw-r--r--"})
        self.assertEqual(succeed("dpkg-deb", "-f", self.deb, "Depends").out.split()[0], "libc6")

    def test_no_file_names_the_folder_in_which_it_was_built(self):
        with zipfile.ZipFile(self.zip) as archive:
            archive.extractall(self.work / "unzipped")
        for folder in (self.unpacked, self.work / "unzipped"):
            self.assertEqual(run("grep", "-rlF", self.work, folder).out, "")
        self.assertIn("CMakeCache.txt", run("grep", "-rlF", self.work, self.sources[0] / "build/package").out)  # Control.

    def test_the_archive_for_windows_has_programs_licence_and_help(self):
        with zipfile.ZipFile(self.zip) as archive:
            content = {name.partition("/")[2]: archive.read(name) for name in archive.namelist() if not name.endswith("/")}
            times = {member.date_time for member in archive.infolist()}
        tracked = succeed("git", "-C", SOURCE, "ls-files", "scenarios", "golden").out.split()
        licences = sorted(name for name in content if name.startswith("licences/"))
        self.assertEqual(sorted(content), sorted(["HELP.txt", "LICENSE.txt", "README.txt", "hyrax-replay.exe", "hyrax-sim.exe", "hyrax.exe",
                                                  *tracked, *licences]))
        self.assertEqual([name for name in licences if re.search("GPL|libgsl|libhdf5|libz", name)],
                         ["licences/GPL-3.txt", "licences/libgsl.txt", "licences/libhdf5.txt", "licences/libz-mingw-w64.txt"])
        self.assertEqual(times, {time.gmtime(EPOCH)[:6]})
        for program in ("hyrax", "hyrax-replay"):
            text = (SOURCE / f"tools/{program}/help.txt").read_bytes().replace(b"\n", b"\r\n")
            self.assertIn(text, content["HELP.txt"])
            self.assertIn(text.replace(b"\r\n", b"\n"), content[f"{program}.exe"])
        self.assertEqual(content["LICENSE.txt"].replace(b"\r\n", b"\n"), (SOURCE / "LICENSE").read_bytes())

    def test_the_cmake_package_serves_an_outside_project(self):
        folder = self.work / "outside"
        succeed("cmake", "-S", SOURCE / "tests/cli/outside_project", "-B", folder, "-G", "Ninja",
                f"-DCMAKE_PREFIX_PATH={self.unpacked}/usr", "-DCMAKE_CXX_FLAGS=-O3 -march=native")
        succeed("ninja", "-C", folder, "fling")
        succeed(folder / "fling")
        # Control: nothing else on this machine is found in its place.
        (self.unpacked / "usr").rename(self.unpacked / "elsewhere")
        self.addCleanup((self.unpacked / "elsewhere").rename, self.unpacked / "usr")
        outcome = run("cmake", "-S", SOURCE / "tests/cli/outside_project", "-B", self.work / "none",
                      f"-DCMAKE_PREFIX_PATH={self.unpacked}/usr")
        self.assertIn('package configuration file provided by "hyrax"', outcome.err)

    def test_it_works_in_a_bare_debian_without_a_compiler(self):
        system = bare_debian(self.work / "debian")
        shutil.copy(self.deb, system / "hyrax-sim.deb")

        def inside(*command):
            return in_namespace("chroot", system, *command)

        self.assertNotEqual(inside("which", "cc", "gcc", "g++", "c++", "clang", "hyrax-sim").exit_code, 0)
        installed = inside("dpkg", "--install", "/hyrax-sim.deb")
        self.assertEqual(installed.exit_code, 0, str(installed))
        begin_s = time.monotonic()
        check = inside("env", "--chdir=/usr/share/hyrax-sim", "hyrax-sim", "check")
        self.assertLess(time.monotonic() - begin_s, CHECK_S_MAX)
        count = len(list((SOURCE / "scenarios").rglob("*.json")))
        self.assertEqual((check.exit_code, check.out), (AGREED, f"{count} checked: {count} agreed, 0 disagreed, 0 without "
                                                        "golden file, 0 failed\n"), str(check))
        scenario = system / "usr/share/hyrax-sim/scenarios/flings/first-fling.json"  # Control: a change is noticed.
        scenario.write_text(scenario.read_text().replace('"vx_px_per_s": ', '"vx_px_per_s": 1', 1))
        changed = inside("env", "--chdir=/usr/share/hyrax-sim", "hyrax-sim", "check")
        self.assertEqual(changed.exit_code, DISAGREED, str(changed))
        removed = inside("dpkg", "--purge", "hyrax-sim")
        self.assertEqual(removed.exit_code, 0, str(removed))
        self.assertFalse((system / "usr/bin/hyrax-sim").exists())


class WorkflowOfOwnCore(unittest.TestCase):
    """The workflow that tools/own_core/ci.md offers, its steps as they stand there, for a project with a core of its own."""

    def setUp(self):
        work = pathlib.Path(tempfile.mkdtemp(prefix="hyrax-workflow-"))
        self.addCleanup(shutil.rmtree, work)
        self.system = bare_debian(work / "debian")
        shutil.copytree("/etc/apt", self.system / "etc/apt", dirs_exist_ok=True)
        self.project = self.system / "project"
        shutil.copytree(SOURCE / "tests/cli/own_physics", self.project)
        copy_of_source(self.project / "hyrax")
        self.steps = re.findall(r"^      - run: (.*)$", (SOURCE / "tools/own_core/ci.md").read_text(), re.MULTILINE)

    def inside(self, *command):
        return in_namespace(f"--mount-proc={self.system}/proc", "chroot", self.system, "env", "--chdir=/project",
                            "GITHUB_STEP_SUMMARY=/project/summary.md", *command, env=ENVIRONMENT, timeout=BUILD_S_MAX)

    def play(self, steps):
        """The outcome of each step."""
        return [self.inside("sh", "-e", "-c", step) for step in steps]

    def test_its_steps_build_test_and_report(self):
        first = self.play(self.steps)
        self.assertEqual([step.exit_code for step in first[:-2]], [0] * (len(self.steps) - 2), "\n".join(map(str, first)))
        self.assertEqual([step.exit_code for step in first[-2:]], [8, GOLDEN_MISSING])
        blessed = self.inside("build/elastic_box-sim", "bless", "scenarios", "--reason", "first results")
        self.assertEqual(blessed.exit_code, AGREED, str(blessed))
        packed = self.steps.index(next(step for step in self.steps if "tools/package" in step))
        self.assertEqual([step.exit_code for step in self.play(self.steps[packed:])], [0] * (len(self.steps) - packed))
        header = self.project / "elastic_box.h"
        header.write_text(header.read_text().replace("m_x += m_vx * dt;", "m_x += m_vx * dt + 1e-9;"))
        *_, build, tests, check = self.play(self.steps[packed:])
        self.assertEqual((build.exit_code, tests.exit_code, check.exit_code), (0, 8, DISAGREED), str(check))
        self.assertRegex(check.out, "(?m)^::error file=")
        self.assertIn("## hyrax-sim check: not agreed", (self.project / "summary.md").read_text())
        self.assertIn("</html>", (self.project / "check.html").read_text())


if __name__ == "__main__":
    skip_without("debootstrap", "unshare", "dpkg-shlibdeps", "x86_64-w64-mingw32-g++-posix")
    if os.geteuid() != 0:
        print("debootstrap needs root", file=sys.stderr)
        sys.exit(77)
    unittest.main()
