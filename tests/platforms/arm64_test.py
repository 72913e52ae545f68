"""hyrax-sim itself on arm64: built with Debian's packages for it and run by an emulator, it has the results of this machine."""

import dataclasses
import hashlib
import sys

import h5py

from building import TIMEOUT_S, build
from playing import library
from process import Failed, TimedOut, run, skip_for_lack_of, skip_without, succeed
from program import AGREED, PROGRAM
from rows import BUILDS, EMULATED_STEPS_MAX, PROJECT
from sweep_members import ALL, base
from sweep_program import NO_CLUSTER, SweepTest, document

FOLDER = PROJECT / "build/platforms/arm64"  # Kept: the next night fetches and compiles only what changed.
SYSROOT = FOLDER / "sysroot"
REPLAY = next(row for row in BUILDS if row.name == "aarch64")
ROW = dataclasses.replace(REPLAY, program="bin/hyrax-sim", settings=(
    *REPLAY.settings, "HYRAX_SIM=ON", "HYRAX_TESTS=OFF", f"HYRAX_SYSROOT={SYSROOT}"))
skip_without(ROW.compiler, *ROW.runner, "apt-get", "dpkg-deb")
JITTERS = ({}, {"kind": "uniform", "fraction": 0.1}, {"kind": "normal", "sigma_s": 0.002},
           {"kind": "missed_frames", "probability": 0.1})  # Each clock is a kernel of its own.


def digests_of(path):
    """{path of a dataset: type and SHA-256 of its bytes} of a file. The build is named in attributes, which are left out."""
    found = {}

    def take(name, item):
        if isinstance(item, h5py.Dataset):
            found[name] = (item.dtype.str, hashlib.sha256(item[()].tobytes()).hexdigest())

    with h5py.File(path) as file:
        file.visititems(take)
    return found


def apt_get(*arguments):
    """apt-get for arm64, with the system's sources and nothing else of the system: no root, nothing is installed."""
    state = FOLDER / "apt"
    state.mkdir(parents=True, exist_ok=True)
    settings = (f"Dir::State={state}", "Dir::State::status=/dev/null", f"Dir::Cache={state}", "APT::Architecture=arm64",
                "APT::Architectures=arm64", "APT::Sandbox::User=root", "Debug::NoLocking=true")
    return succeed("apt-get", "--quiet", *(f"--option={setting}" for setting in settings), *arguments, timeout=TIMEOUT_S)


def unpack_packages():
    """The libraries of tools/setup.sh for arm64, and what they need. Links to absolute paths lead out of the folder; they
    are of shared libraries, and the program is linked with static ones."""
    packages = succeed("bash", "-c", '. tools/setup.sh && echo "${packages_to_build[@]}"', cwd=PROJECT).out.split()
    apt_get("update")
    apt_get("autoclean")
    apt_get("install", "--yes", "--no-install-recommends", "--download-only",
            *(package for package in packages if package.endswith("-dev")))
    for package in sorted((FOLDER / "apt/archives").glob("*.deb")):
        succeed("dpkg-deb", "--extract", package, SYSROOT)


class Arm64(SweepTest):
    """Commands, run by the emulator."""

    @classmethod
    def setUpClass(cls):
        try:
            unpack_packages()
        except (Failed, TimedOut) as failure:
            print(failure, file=sys.stderr)
            skip_for_lack_of("arm64 packages that apt-get can fetch")
        cls.program = build(ROW, FOLDER / "build")

    def hyrax_sim(self, *arguments, **options):
        return run(*ROW.runner, self.program, *arguments, **{"cwd": self.folder, "timeout": TIMEOUT_S, **options})

    def test_every_scenario_agrees_that_is_not_too_long_for_an_emulator(self):
        scenarios = library(PROJECT / "golden")
        chosen = [path for path, known in scenarios.items() if known.steps <= EMULATED_STEPS_MAX]
        counts = self.expect(AGREED, "check", "--json", *chosen, cwd=PROJECT).json
        print(f"{counts['agreed']} of {len(chosen)} agree "
              f"({len(scenarios) - len(chosen)} too long for an emulator)", file=sys.stderr)
        self.assertEqual(counts["agreed"], len(chosen))

    def test_sweeps_have_the_bytes_of_this_machine(self):
        for number, jitter in enumerate(JITTERS):
            clock = {"rate_hz": 60, "jitter": {**jitter, "seed": 3}} if jitter else {"rate_hz": 60}
            # With state_hash the kernels would be left out.
            self.write("sweep.json", document(base=base(clock=clock), members=3000, keep=ALL[:4]))
            self.sweep("sweep.json", "-o", f"arm64-{number}.h5")
            succeed(PROGRAM, "sweep", "sweep.json", "-o", f"here-{number}.h5", cwd=self.folder, env=NO_CLUSTER)
            self.assertEqual(*(digests_of(self.folder / f"{name}-{number}.h5") for name in ("arm64", "here")))
