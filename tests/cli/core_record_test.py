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
        self.assertEqual(self.record(with_vectors, project=self.folder), step)
        record = (self.folder / "core_record.cpp").read_text(encoding="utf-8")
        self.assertIn('.path = R"__(core.h)__"sv', record)
        self.assertIn('{R"__(vec2.h)__"sv, "' + "".join(f"\\x{byte:02x}" for byte in VEC2.encode()) + '"sv, true}', record)
        self.assertIn("vec2.h", (self.folder / "core_record.d").read_text(encoding="utf-8"))

    def test_without_a_compiler_it_says_why(self):
        for compiler, why in (("", "no compiler of this machine"), ("/bin/false", "does not compile when traced: 1")):
            self.assertEqual(self.record(LISTING, compiler=compiler), why)

    def test_definitions_are_those_of_the_compiled_core(self):
        header = self.changed("GRAVITY = 1200.0", "GRAVITY = G")
        self.assertIn("dt * 980{", self.record(header, definitions="G=980.0"))
        self.assertIn("does not compile when traced: core.h:", self.record(header))

    def test_a_finding_of_a_sanitizer_is_no_limit(self):
        flags = re.search(r"set\(flags \[==\[(.*)\]==\]\)", SETTINGS.read_text(encoding="utf-8"))[1]
        wrong = {"address": ("char* p = new char[4]; if (m_vx > 0) p[9] = 1; delete[] p;", "AddressSanitizer: heap-buffer-overflow"),
                 "undefined": ("long most = 9223372036854775807; if (m_vx > 0) most += 1; if (most == 3) m_x = 0;",
                               "runtime error: signed integer overflow: 9223372036854775807 + 1 cannot be represented in type 'long int'")}
        for sanitizer, (statements, finding) in wrong.items():
            sanitized = f"{flags};-fsanitize={sanitizer};-fno-sanitize-recover=all"
            why = self.record(self.changed(MOVE, statements + MOVE), flags=sanitized)
            self.assertEqual(f"ends by a finding of a sanitizer: {finding}", why)
        self.assertEqual(self.record(LISTING, flags=sanitized.replace(sanitizer, "address")), self.record(LISTING))

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
        headers["hyrax"] = self.changed(MOVE, f"{asks} {MOVE}").replace("class physics", "namespace hyrax { inline int calls; }\nusing hyrax::calls;\nclass physics", 1)
        constant = self.changed(MOVE, f"static const double kOne = 1.0; static constexpr double kTwo[] = {{1.0, 2.0}}; {MOVE}")
        for compiler in ("g++", "clang++"):
            skip_unless_installed(compiler)
            options = {"compiler": compiler, "flags": "-std=c++20;-O2;-ffp-contract=off"}
            for kind, header in headers.items():
                with self.subTest(compiler=compiler, kind=kind):
                    self.assertRegex(self.record(header, **options), r"^memory outside the body: (physics::.*|hyrax::)?calls$")
            self.assertEqual(self.record(constant, **options), (SETTINGS.parent / "step.txt").read_text(encoding="utf-8"))

    def test_what_the_recording_numbers_do_not_see_is_no_step(self):
        bits = "unsigned long long bits = 0;"
        headers = {
            "the step calls rand": ("<cstdlib>", "if (std::rand() % 1000000 == 0) m_vx += 300.0;"),
            "the step calls clock": ("<ctime>", "if (clock() < 0) m_vx += 300.0;"),
            "the step calls std::chrono::_V2::steady_clock::now": ("<chrono>", "if (std::chrono::steady_clock::now() == std::chrono::steady_clock::time_point()) m_vx = 0.0;"),
            "the step calls fesetround": ("<cfenv>", "std::fesetround(FE_TONEAREST);"),
            "the step uses _mm_setcsr": ("<immintrin.h>", "_mm_setcsr(_mm_getcsr() | 0x8040);"),
            "the step uses __builtin_ia32_rdtsc": ("<cmath>", "if (__builtin_ia32_rdtsc() == 0) m_vx = 0.0;"),
            "the step uses asm": ("<cmath>", "asm(\"\");"),
            "the step uses volatile": ("<cmath>", "volatile char none = 0; if (none) m_vx = 0.0;"),
            "the step uses memcpy": ("<cstring>", f"{bits} std::memcpy(&bits, &m_x, 8); if (bits == 7) m_vx = 0.0;"),
            "the step uses union": ("<cmath>", "union { double number; unsigned long long bits; } m{m_x}; if (m.bits == 7) m_vx = 0.0;"),
            "the step uses reinterpret_cast": ("<cmath>", "if (reinterpret_cast<unsigned long long&>(m_x) == 7) m_vx = 0.0;"),
            "the step uses a cast to a pointer or a reference": ("<cmath>", "if (*(unsigned long long*)&m_x == 7) m_vx = 0.0;"),
            "its text depends on how it is compiled: `1e9`, where it is traced `2e9`":
                ("<cmath>", "\n#ifdef __OPTIMIZE__\nif (m_x == 1e9)\n#else\nif (m_x == 2e9)\n#endif\nm_vx = 0.0;\n"),
            "its text depends on how it is compiled: `m_x`, where it is traced `m_vx`":
                ("<cmath>", "\n#ifdef HYRAX_CORE_PRELUDE\nm_vx = 0.0;\n#endif\n")}
        allowed = ("<cassert>", "assert(static_cast<double>(2) > 1); int _step = 1; auto _mm_own = [&](int i) { return _step * i; };"
                                "double pair[2] = {m_x, m_y}; for (const double* each : {&pair[0]}) m_x = *each + 0.0 * _mm_own(0);")
        for number, (why, (include, statements)) in enumerate({**headers, "": allowed, "hyrax-step/1": allowed}.items()):
            compiler = ("clang++", "g++")[number % 2]
            skip_unless_installed(compiler)
            options = {"compiler": compiler, "flags": "-std=c++20;-O2;-ffp-contract=off"}
            with self.subTest(compiler=compiler, why=why):
                header = self.changed(MOVE, statements + MOVE).replace("#pragma once", f"#pragma once\n#include {include}", 1)
                recorded = self.record(header, **options)
                self.assertEqual(recorded.splitlines()[0], why or "hyrax-step/1", recorded)
