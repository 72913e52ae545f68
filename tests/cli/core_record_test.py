"""What the build records of a core's header: tools/cmake/record_core.cmake, with the settings of this build.

The cases that need no compiler of their own are in tests/unit/sim/trace/host.
"""

import os
import pathlib
import re

from process import skip_unless_installed, succeed
from program import SOURCE, ProgramTest

SETTINGS = pathlib.Path(os.environ["HYRAX_RECORD_SETTINGS"])
LISTING = (SOURCE / "sim/physics/physics.h").read_text(encoding="utf-8")
MOVE = "m_x += m_vx * dt;"

VEC2 = """#pragma once
#include <ostream>
struct vec2 {
  double x = 0, y = 0;
  bool operator==(const vec2&) const = default;
};
constexpr vec2 operator+(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr vec2 operator*(vec2 a, double s) { return {a.x * s, a.y * s}; }
inline std::ostream& operator<<(std::ostream& stream, const vec2&) { return stream; }
"""


class CoreRecord(ProgramTest):
    """Headers, and what is recorded of them."""

    def record(self, header, **changed):
        """The step's text, or why there is none."""
        settings = SETTINGS.read_text(encoding="utf-8")
        for key, value in {"folder": self.folder, "header": self.folder / self.write("core.h", header), **changed}.items():
            settings, found = re.subn(rf"set\({key} \[==\[.*\]==\]\)", f"set({key} [==[{value}]==])", settings)
            self.assertEqual(found, 1, key)
        path = self.folder / self.write("settings.cmake", settings)
        succeed("cmake", "-D", f"settings={path}", "-P", SOURCE / "tools/cmake/record_core.cmake")
        source = (self.folder / "core_record.cpp").read_text(encoding="utf-8")
        self.assertIn("".join(f"\\x{byte:02x}" for byte in header.encode()), source)
        why = self.folder / "why_incomplete.txt"
        return (why if why.exists() else self.folder / "step.txt").read_text(encoding="utf-8")

    def changed(self, old, new, text=LISTING):
        """The listing with one change."""
        self.assertEqual(text.count(old), 1)
        return text.replace(old, new)

    def test_what_does_not_change_the_step_does_not_change_its_text(self):
        step = self.record(LISTING)
        self.assertEqual(step, (SETTINGS.parent / "step.txt").read_text(encoding="utf-8"))
        macros = "#define Real Whole\n#define trace hyrax\n#define record 3\n#define value 4\n"
        self.assertEqual(self.record(macros + LISTING), step)
        self.write("vec2.h", VEC2)
        with_vectors = self.changed(MOVE, "m_x = (vec2{m_x, 0} + vec2{m_vx, 0} * dt).x;",
                                    LISTING.replace("#pragma once", '#pragma once\n#include "vec2.h"'))
        self.assertEqual(self.record(with_vectors), step)
        self.assertIn("vec2.h", (self.folder / "core_record.d").read_text(encoding="utf-8"))

    def test_without_a_compiler_it_says_why(self):
        for compiler, why in (("", "no compiler of this machine"), ("/bin/false", "does not compile when traced: 1")):
            self.assertEqual(self.record(LISTING, compiler=compiler), why)

    def test_definitions_are_those_of_the_compiled_core(self):
        header = self.changed("GRAVITY = 1200.0", "GRAVITY = G")
        self.assertIn("dt * 980{", self.record(header, definitions="G=980.0"))
        self.assertIn("does not compile when traced: core.h:", self.record(header))

    def test_what_is_traced_wrongly_is_noticed_by_the_compiled_core(self):
        size = self.changed(MOVE, MOVE + " m_x += sizeof(m_x) - 8;")
        compiled, rest, traced, rest_of_traced = re.fullmatch(
            r"the traced step does not give the compiled core's bits: update of \([\d.]+, 0, 0, 0\)(?: \d+){4} from \(.*\) "
            r"is \((\S+), (.*)\), traced \((\S+), (.*)\)", self.record(size)).groups()
        self.assertAlmostEqual(float(traced) - float(compiled), 8)  # A recording number has 16 bytes.
        self.assertEqual(rest, rest_of_traced)

    def test_a_variable_whose_numbers_never_meet_the_state_is_memory_outside_the_body(self):
        asks = "if (++calls > 1000000000) m_x = 0.0;"
        headers = {"function": self.changed(MOVE, f"static double calls = 0.0; {asks} {MOVE}"),
                   "thread": self.changed(MOVE, f"static thread_local int calls = 0; {asks} {MOVE}"),
                   "class": self.changed(MOVE, f"{asks} {MOVE}").replace("public:", "public:\n  static inline int calls = 0;", 1),
                   "namespace": self.changed(MOVE, f"{asks} {MOVE}").replace("class physics", "static float calls;\nclass physics", 1)}
        constant = self.changed(MOVE, f"static const double kOne = 1.0; static constexpr double kTwo[] = {{1.0, 2.0}}; {MOVE}")
        for compiler in ("g++", "clang++"):
            skip_unless_installed(compiler)
            options = {"compiler": compiler, "flags": "-std=c++20;-O2;-ffp-contract=off"}
            for kind, header in headers.items():
                with self.subTest(compiler=compiler, kind=kind):
                    self.assertRegex(self.record(header, **options), r"^memory outside the body: (physics::.*)?calls$")
            self.assertEqual(self.record(constant, **options), (SETTINGS.parent / "step.txt").read_text(encoding="utf-8"))
