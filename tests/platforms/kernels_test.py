"""The kernels of sweeps on other processors' vectors: their unit test, cross-compiled and run by an emulator."""

import os
import pathlib
import tempfile
import unittest

from process import skip_without, succeed
from rows import PROJECT

GOOGLETEST = pathlib.Path("/usr/src/googletest/googletest")  # libgtest-dev has a library for this machine only.
PROCESSORS = ("aarch64-linux-gnu", "powerpc64le-linux-gnu", "riscv64-linux-gnu", "s390x-linux-gnu")
LIBRARIES = ("ensemble", "replay", "shipped", "core_record", "core", "physics", "trajectory", "trace", "scenario")


def emulator_of(triple):
    """For example qemu-ppc64le."""
    return "qemu-" + triple.split("-")[0].replace("powerpc64", "ppc64")


skip_without(*(f"{triple}-g++" for triple in PROCESSORS), *map(emulator_of, PROCESSORS))


class Kernels(unittest.TestCase):
    """sim/ensemble/kernels.cpp against physics::update of the same processor."""

    def test_have_the_bits_of_update(self):
        for triple in PROCESSORS:
            with self.subTest(triple), tempfile.TemporaryDirectory(prefix="hyrax-kernels-") as name:
                folder = pathlib.Path(name)
                succeed("cmake", "--log-level=WARNING", "-S", PROJECT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        f"-DCMAKE_TOOLCHAIN_FILE={PROJECT}/tools/cmake/cross.cmake", f"-DHYRAX_TRIPLE={triple}",
                        "-DHYRAX_SIM=OFF", "-DHYRAX_ENSEMBLE=ON", f"-DHYRAX_CORE_RECORD={os.environ['HYRAX_CORE_RECORD']}")
                succeed("ninja", "-C", folder, "hyrax_ensemble", "hyrax_replay", "hyrax_shipped", timeout=600)
                tests = PROJECT / "tests/unit/sim/ensemble/kernels_test.cpp"
                succeed(f"{triple}-g++", "-static", "-std=c++20", "-O1", "-w", "-ffp-contract=off", f"-I{PROJECT}",
                        f"-isystem{GOOGLETEST}/include", f"-isystem{GOOGLETEST}", tests, GOOGLETEST / "src/gtest-all.cc",
                        GOOGLETEST / "src/gtest_main.cc", "-Wl,--start-group",
                        *(f"{folder}/sim/libhyrax_{each}.a" for each in LIBRARIES), "-Wl,--end-group", "-o",
                        folder / "kernels_test", timeout=600)
                self.assertIn("[  PASSED  ]", succeed(emulator_of(triple), folder / "kernels_test", timeout=600).out)
