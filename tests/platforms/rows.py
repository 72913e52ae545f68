"""The rows of the matrix: which builds there are, what each needs, and what must come of it."""

import dataclasses
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[1]

# Soaks take too long on an emulated processor: there, scenarios of more steps are left out, and the table says so.
EMULATED_STEPS_MAX = 10_000_000

NOT_STRICT = 5  # The exit code where arithmetic is not strict IEEE-754.


@dataclasses.dataclass(frozen=True)
class Needs:
    """What a row cannot do without: a command, or a file (a pattern), and the Debian package that has it."""

    what: str
    package: str


@dataclasses.dataclass(frozen=True)
class Verdict:
    """What must come of a row: `agrees`, `differs`, or refused with that sentence while it `compiles` or `starts`."""

    kind: str
    sentence: str = ""


AGREES = Verdict("agrees")
DIFFERS = Verdict("differs")
FUSED = Verdict("starts", "multiply-adds are fused")
FLUSHED = Verdict("starts", "subnormal numbers are flushed to zero")
EXCESS = Verdict("starts", "intermediate results carry excess precision")
ROUNDED = Verdict("starts", "not rounded to nearest")


@dataclasses.dataclass(frozen=True)
class Variant:
    """An existing build, run in another way."""

    name: str
    environment: tuple = ()  # NAME=VALUE; {NAME} is replaced by a library or folder of building.py.
    is_reversed: bool = False  # The scenarios in the opposite order.
    must: Verdict = AGREES
    needs: tuple = ()
    cpu: tuple = ()


@dataclasses.dataclass(frozen=True)
class Row:
    """One build, of hyrax-replay where `program` names no other."""

    name: str
    compiler: str = "g++"
    flags: str = "-O2"
    last_flags: str = ""  # After the project's flags, which they override; only controls have any.
    source: pathlib.Path = PROJECT
    toolchain: str = ""
    settings: tuple = ()  # More CMake settings, NAME=VALUE.
    more_flags: str = ""  # No part of what the row is about, and not shown.
    program: str = "bin/hyrax-replay"
    runner: tuple = ()  # What runs the program where this processor does not.
    runs_on: str = "this machine"
    needs: tuple = ()
    cpu: tuple = ()  # Flags of /proc/cpuinfo without which the program cannot run here.
    must: Verdict = AGREES
    is_blind: bool = False  # The self-test is removed.
    is_nightly: bool = False  # By day another row stands for it, or platforms.this_build plays it.
    variants: tuple = ()

    @property
    def folder(self):
        return "".join(c if c.isalnum() else "-" for c in self.name.lower().replace("+", "p"))


V2 = ("ssse3", "sse4_2", "popcnt")
V3 = (*V2, "avx2", "bmi2", "fma")
V4 = (*V3, "avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl")

# Names as glibc 2.36 has them. Its own choice of functions follows the mask, as a processor without them would have it.
MASKED = "glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX2,-FMA,-FMA4,-AVX,-BMI2,-SSE4_2,-SSSE3,-ERMS"

THIS_BUILD = (
    Variant("processor features masked", (f"GLIBC_TUNABLES={MASKED}",), cpu=("lm",)),
    Variant("decimal comma", ("LD_PRELOAD={locale}", "LOCPATH={locales}", "LC_ALL=de_DE"),
            needs=(Needs("/usr/share/i18n/locales/de_DE", "locales"),)),
    Variant("scenarios in reverse order", is_reversed=True),
    Variant("a library linked with -ffast-math is loaded", ("LD_PRELOAD={fast_math}",), must=FLUSHED),
    Variant("a library that rounds upwards is loaded", ("LD_PRELOAD={rounding}",), must=ROUNDED),
)

GXX = Needs("g++", "g++")
IN_32_BITS = Needs("/usr/lib/gcc/*/*/32/libstdc++.a", "g++-12-multilib")
# The package g++-multilib, which would have the headers of Linux where -m32 looks, excludes all cross compilers.
HEADERS_OF_32_BITS = "-idirafter /usr/include/x86_64-linux-gnu"
WITHOUT_GUARDS = "-DHYRAX_CONTROL_WITHOUT_GUARDS"


def native(compiler, package, all_flags, daily=None):
    """A compiler for this processor, with each of these flags; by day with those named."""
    return [Row(f"{compiler} {flags}", compiler, flags, needs=(Needs(compiler, package),), is_nightly=flags != daily)
            for flags in all_flags]


def level(number, cpu):
    """A microarchitecture level of x86-64."""
    name = "x86-64" if number == 1 else f"x86-64-v{number}"
    return Row(f"x86-64-v{number}", "g++", f"-O3 -march={name}", needs=(GXX,), cpu=("lm", *cpu), is_nightly=True)


def windows(flags, **options):
    """MinGW, under Wine."""
    return Row(f"Windows {flags}", "x86_64-w64-mingw32-g++-posix", flags, toolchain="mingw.cmake",
               program="bin/hyrax-replay.exe", runs_on="Wine",
               needs=(Needs("x86_64-w64-mingw32-g++-posix", "g++-mingw-w64-x86-64-posix"), Needs("wine", "wine")), **options)


def emulated(name, triple, emulator, **options):
    """Another processor, under qemu-user."""
    return Row(name, f"{triple}-g++", "-O2", toolchain="cross.cmake", settings=(f"HYRAX_TRIPLE={triple}",),
               runner=(emulator,), runs_on=emulator,
               needs=(Needs(f"{triple}-g++", f"g++-{triple}"), Needs(emulator, "qemu-user")), **options)


BUILDS = (
    Row("g++ -O3", "g++", "-O3", needs=(GXX,), variants=THIS_BUILD, is_nightly=True),
    *native("g++", "g++", ("-O0", "-O2", "-O2 -flto", "-O3 -march=native"), daily="-O3 -march=native"),
    *native("clang++", "clang", ("-O0", "-O2", "-O3 -march=native")),
    *native("clang++-22", "clang-22", ("-O0", "-O2", "-O3 -march=native")),
    level(1, ()), level(2, V2), level(3, V3), level(4, V4),
    # Under qemu-user, for not every kernel of 64 bits runs programs of 32.
    Row("i386 with SSE2", "g++", "-O2 -m32", more_flags=HEADERS_OF_32_BITS, runner=("qemu-i386",), runs_on="qemu-i386",
        needs=(GXX, IN_32_BITS, Needs("qemu-i386", "qemu-user")), cpu=("lm",), is_nightly=True),
    windows("-O2"), windows("-O0", is_nightly=True),
    emulated("aarch64", "aarch64-linux-gnu", "qemu-aarch64"),
    emulated("riscv64", "riscv64-linux-gnu", "qemu-riscv64", is_nightly=True),
    emulated("s390x, big-endian", "s390x-linux-gnu", "qemu-s390x"),
    emulated("ppc64el", "powerpc64le-linux-gnu", "qemu-ppc64le", is_nightly=True),
    emulated("armhf", "arm-linux-gnueabihf", "qemu-arm", is_nightly=True),
    # All by V8's optimising compiler, and nothing in the background when the program ends: node has crashed there.
    Row("WebAssembly", "clang++-19", "-O2", source=HERE / "wasm", toolchain="wasi.cmake",
        program="hyrax/bin/hyrax-replay", runs_on="node",
        runner=("node", "--no-warnings", "--no-liftoff", "--single-threaded", str(HERE / "wasm/run.mjs")),
        needs=(Needs("clang++-19", "clang-19"), Needs("wasm-ld-19", "lld-19"), Needs("node", "nodejs"),
               Needs("/usr/lib/wasm32-wasi/libc.a", "wasi-libc"),
               Needs("/usr/lib/wasm32-wasi/libc++.a", "libc++-19-dev-wasm32"),
               Needs("/usr/lib/wasm32-wasi/libc++abi.a", "libc++abi-19-dev-wasm32"),
               Needs("/usr/lib/llvm-19/lib/clang/19/lib/wasi/*.a", "libclang-rt-19-dev-wasm32"))),
)

# What must be refused, and one build that must differ: it shows that the matrix would notice, as platforms.controls do by day.
CONTROLS = (
    Row("-ffast-math", flags="-O2 -ffast-math", needs=(GXX,), must=Verdict("compiles", "-ffast-math changes the bits")),
    Row("x87 on i386", flags="-O2 -m32", last_flags="-mfpmath=387", more_flags=HEADERS_OF_32_BITS,
        needs=(GXX, IN_32_BITS), cpu=("lm",), must=Verdict("compiles", "excess precision (x87)")),
    Row("-ffast-math, guards lifted", flags="-O1 -ffast-math", more_flags=WITHOUT_GUARDS, needs=(GXX,), cpu=("lm",),
        must=FLUSHED, is_nightly=True),
    Row("x87 on i386, guards lifted", flags="-O1 -m32", last_flags="-mfpmath=387",
        more_flags=f"{HEADERS_OF_32_BITS} {WITHOUT_GUARDS}", needs=(GXX, IN_32_BITS), cpu=("lm",), must=EXCESS,
        is_nightly=True),
    Row("fused", flags="-O2 -march=native", last_flags="-ffp-contract=fast", needs=(GXX,), cpu=("fma",), must=FUSED,
        is_nightly=True),
    Row("fused, self-test taken out", flags="-O2 -march=native", last_flags="-ffp-contract=fast", is_blind=True,
        needs=(GXX,), cpu=("fma",), must=DIFFERS, is_nightly=True),
)
