"""The scripts of tools/: exit codes, options, packages, what tools/run refuses, and what the functions of setup.sh return,
print and call."""

import os
import pty
import re
import select

from process import run
from program import BAD_INPUT, PROGRAM, SOURCE, ProgramTest

SCRIPTS = ("run", "check", "test", "package")


# What stands in for a program: it writes its command line into a log, and fails if a pattern of FAILS matches.
STAND_IN = """{
  local - line="$*" fails
  set -f
  echo "$line" >> "$LOG"
  for fails in $FAILS; do case $line in $fails) return 8 ;; esac; done
  case $line in
    cpack*) mkdir -p "$7" && : > "$7/hyrax-2.deb" ;;
  esac
}"""
# As functions that bash finds in its environment, programs cost no process.
BY_NAME = {"BASH_FUNC_called%%": f"() {STAND_IN}", **{f"BASH_FUNC_{name}%%": f"() {{ called {name} \"$@\"; }}" for name in ("cmake", "cpack", "ctest", "ninja")}}
# Instead of functions of setup.sh that Scripts tests by themselves, and that start processes.
WITHOUT_PROCESSES = """
project_folder() { echo "$PWD"; }; has_apt() { :; }
missing_packages() { local list; for list in ${!packages_*}; do local -n those=$list; [[ " $* " != *" ${those[*]} "* ]] || printf '%s ' "${list#packages_}" >> "$LOG.packages"; done; }
logged() { "$@" > "$LOG.printed" 2>&1; }; say_time() { :; }; time_of_change() { :; }; flock() { :; }
can_write() { [[ $FAILS != unwritable* ]] && mkdir -p -- "$1"; }
"""
# Functions for a shell that sourced setup.sh; where it calls apt as root, it gives apt an environment first.
NO_PROGRAMS = """set -uo pipefail; project=$PWD; source tools/setup.sh
called() { echo "$*" >&3; [[ ! "$*" =~ ${FAILS:-^$} ]] || return 8; }
for name in cmake ninja apt-get; do eval "$name() { called $name \\"\\$@\\"; }"; done
as_root() { [[ $1 != env ]] || shift 2; "$@"; }; has_apt() { :; }; sudo() { :; }; flock() { :; }
mktemp() { echo printed; }; rm() { [[ $* == "-f -- printed" ]] || command rm "$@"; }; stat() { :; }
"""
PLAN, INSTALL, UPDATE = "apt-get install --print-uris --yes --no-install-recommends b c", "apt-get -qq install b c", "apt-get -qq update"
SOME = "dpkg-query() { printf 'a=installed\\nb=config-files\\n'; }; ensure_packages a b c"
CMAKE = "cmake --log-level=WARNING -S PROJECT -B PROJECT/build/x -G Ninja -DA=OFF -DB=long"
# Answers to the question of setup.sh, as typed. 4 is Ctrl-D.
ANSWERS, AGREEING = {"enter": "\n", "Yes": "Yes\n", "x": "x\n", "end": "\4"}, ["enter", "Yes"]
# Commands of setup.sh; a regex of calls that fail; then exit code, what is printed (regex), and what is called.
FUNCTIONS = (
    ("timed name true", "", 0, r"name {30} +\d\.\d s\n", []), ("timed name ninja", "ninja", 8, r"name .* s   FAILED \(exit 8\)\n", ["ninja"]),
    ("unset EPOCHREALTIME; EPOCHREALTIME=102,360000; say_time name 100000000 0", "", 0, r"name +2\.4 s\n", []),
    ("logged echo hidden", "", 0, "", []), ("log_lines=1; logged eval 'echo one; echo two >&2; ninja'", "ninja", 8, "two\n", ["ninja"]),
    ("stop because", "", 3, "because\n", []),
    *((f"is_configured build/x {settings}", "", code, "", []) for settings, code in (
        ("", 0), ("A=ON B=long", 0), ("A=O", 1), ("A=OFF", 1), ("A=ON B=lon", 1), ("C=ON", 1))),
    ("is_configured build", "", 1, "", []), ("rm build/x/CMakeCache.txt; is_configured build/x", "", 1, "", []), ("project=/other; is_configured build/x", "", 1, "", []),
    ("configure $project/build/x A=ON", "", 0, "", []), ("configure $project/build/x A=OFF B=long", "", 0, r"configure build/x .* s\n", [CMAKE]),
    ("configure $project/build/x A=OFF B=long", "cmake", 8, r"configure build/x .*FAILED \(exit 8\)\n", [CMAKE]),
    ("forget_other_source build/x; [[ -d build/x ]]", "", 0, "", []), ("project=/other; configure build/x A=ON; [[ ! -e build/x ]]", "", 0, "configure .*", ["cmake --log-level=WARNING -S /other -B build/x -G Ninja -DA=ON"]),
    ("build build/x page", "", 0, "", ["ninja --quiet -C build/x page"]), ("build build/x", "ninja", 8, "", ["ninja --quiet -C build/x"]),
    ("ninja() { echo ninja: no work to do.; echo warning; }; build build/x", "", 0, "warning\n", []),
    ("build_program build/x", "", 0, "", ["ninja --quiet -C build/x hyrax-sim"]),
    ("announces=yes; build_program build/x", "", 0, "hyrax-sim: up to date\n", ["ninja -C build/x -t inputs hyrax-sim", "ninja --quiet -C build/x hyrax-sim"]),
    ("nproc() { echo 2; }; ninja() { called ninja \"$@\"; printf '%s.o\n%s.cpp\n' {1..152}; }; : > build/x/3.o; announce build/x tests all", "", 0,
     "tests: 75 objects to compile, about 1 min 53 s on 2 processors\n", ["ninja -C build/x -t inputs all"]),
    ("nproc() { echo 2; }; ninja() { printf '%s.o\n' {1..76}; }; printf '0\t4000\t0\t%s.o\t0\n' {1..20} > build/x/.ninja_log; "
     "printf '0\t9000\t0\tprogram\t0\n' >> build/x/.ninja_log; announce build/x tests all", "", 0,
     "tests: 75 objects to compile, about 2 min 31 s on 2 processors\n", []),
    ("ninja() { echo 3.o; }; : > build/x/3.o; announce build/x hyrax-sim hyrax-sim", "", 0, "", []),
    ("project=/other; build_program build/x", "cmake", 3, r"configure .*FAILED \(exit 8\)\nCMake could not configure hyrax-sim.*", [
        "cmake --log-level=WARNING -S /other -B build/x -G Ninja -DCMAKE_BUILD_TYPE=Release -DHYRAX_TESTS=OFF"]),
    ("build_program build/x page", "page", 3, ".*The report page could not be built.*", ["ninja --quiet -C build/x page"]),
    ("dpkg-query() { echo a=installed; }; ensure_packages a", "", 0, "", []),
    (SOME, "", 0, r"Missing packages .*: b c\npackages .* s\n", [PLAN, PLAN, PLAN, INSTALL]),
    (SOME, "-uris", 3, r"package lists .*apt cannot install the missing packages.*", [PLAN, UPDATE, PLAN, PLAN]),
    (SOME, "install --yes", 3, ".*could not be installed.*", [PLAN, PLAN, PLAN, INSTALL, UPDATE, INSTALL]),
    (SOME, "update|-uris", 3, ".*could not fetch.*", [PLAN, UPDATE]),
    ("has_apt() { return 1; }; ensure_packages a b", "", 3, ".*nothing was installed.*\n  a b\n.*", []),
    ("plan_of() { echo 'Need to get 1 kB/2 MB of archives.'; echo 'After this operation, 3 MB of additional disk space will be used.'; }; agree_to a b",
     "", 0, r"Missing packages \(with what they need: 2 MB to download, 3 MB on disk\): a b\n", []),
    # On the terminal that is their input; where there is none for the question, or `assume_yes` is set, nobody is asked.
    ("assume_yes=no; plan_of() { :; }; sed() { :; }; stop() { return 3; }; for answer in " + " ".join(ANSWERS) + "; do agree_to a 2>&0 && called $answer; done", "", 3, "", AGREEING),
    ("assume_yes=no; plan_of() { :; }; sed() { :; }; agree_to a 2>&0 < /dev/null && agree_to a && assume_yes=yes && agree_to a 2>&0", "", 0, "Missing packages .*: a\n", []),
)
# A command of tools/, a pattern of the programs that fail, the exit code, what is printed, and what is called, without what
# all calls of a program have.
OF_EVERY_CALL = r" --(?:log-level=WARNING|quiet|output-on-failure|no-tests=error)| -(?:S PROJECT|G Ninja|j \d+)| (?:-B|-C|--test-dir)(?= /)"
CONFIGURED, BUILT = "cmake /tools -DCMAKE_BUILD_TYPE=Release -DHYRAX_TESTS=OFF", "ninja /tools hyrax-sim"
ANNOUNCED = f"ninja /tools -t inputs hyrax-sim, {BUILT}"
TESTS = "cmake /tools -DCMAKE_BUILD_TYPE=Release -DHYRAX_TESTS=ON -DHYRAX_WERROR=OFF"
TESTS_BUILT = "ninja /tools -t inputs all, ninja /tools"
WITH_PAGE = f"ninja /tools page_packages, ninja /tools page, cmake /tools -DHYRAX_PAGE=ON, {TESTS_BUILT}"


def preset(name, one_build, left_out):
    """Calls that test a preset."""
    return (f"cmake --preset {name} -DHYRAX_WERROR=OFF -DHYRAX_ONE_BUILD={one_build}, ninja /{name}, hyrax-sim check scenarios, "
            f"ctest /{name} -LE {left_out}")


CALLS = (
    ("run", "", 0, "Replaying first-fling; writing first-fling.h5 and", f"{CONFIGURED}, {ANNOUNCED}, hyrax-sim run PROJECT/scenarios/flings/first-fling.json --figure first-fling.svg"),
    *((f"run --yes a.json --report{page}", "hyrax-sim*", 8, "", f"{CONFIGURED}, ninja /tools page, cmake /tools -DHYRAX_PAGE=ON, "
       f"{ANNOUNCED}, hyrax-sim run a.json --report{page}") for page in (" x.html", "=x.html")),
    ("check a.json --golden g", "hyrax-sim*", 8, "", f"{CONFIGURED}, {BUILT}, hyrax-sim check a.json --golden g"), ("check", "ninja*", 3, "hyrax-sim could not be built", f"{CONFIGURED}, {BUILT}"),
    ("run a.json", "unwritable hyrax-sim*", 8, "running the existing hyrax-sim without building it", "hyrax-sim run a.json"),
    *((script, "unwritable", 3, "build/tools: cannot be written; change its permissions, or", "") for script in ("check", "test")),
    ("test", "ctest*", 1, "", f"{TESTS}, {TESTS_BUILT}, ctest /tools -LE long"),
    ("test --all --yes -R unit", "ctest*asan* run*", 1, "FAILED: asan-clang fuzz\n",
     f"{TESTS} -DHYRAX_BENCHMARKS=ON, {WITH_PAGE}, ctest /tools -LE nightly -R unit, {preset('asan-clang', 'OFF', 'long|one_build -R unit')}, run 30"),
    ("test --nightly", "*page_packages", 0, "its tests in a browser are left out", ", ".join((
        f"{TESTS} -DHYRAX_BENCHMARKS=ON, ninja /tools page_packages, cmake /tools -DHYRAX_PAGE=OFF, {TESTS_BUILT}, ctest /tools",
        *(preset(name, "ON", "long") for name in ("asan-clang", "clang", "asan", "debug")), "cmake --preset tsan -DHYRAX_WERROR=OFF",
        r"ninja /tsan hyrax-sim racy, ctest /tsan -R ^faults\.threads$, run 3600, mutation.py --build /tools --count 10 --seed DATE --minutes 60"))),
    ("package deb", "cpack*", 3, "could not be built", "cmake --preset package -DHYRAX_PAGE=no, ninja /package, "
     "cpack --config /package/CPackConfig.cmake -G DEB /package/packages"),
    ("package --page deb", "ninja*page", 3, "could not be built", "cmake --preset package -DHYRAX_PAGE=ON, ninja /package page"),
    ("package tar", "", 2, "(found tar)", ""),
)

# The lists of packages that each needs, of which others are parts.
NEEDED = {"run": "to_build", **dict.fromkeys(("run --yes a.json --report x.html", "run --yes a.json --report=x.html"), "for_page to_build"), "test": "to_build to_test",
          "test --all --yes -R unit": "for_all for_clusters for_page for_platforms for_wine to_browse to_build to_test",
          "test --nightly": "for_all for_clusters for_page for_platforms for_wine to_browse to_build to_install to_package to_test", "package deb": "to_build to_package", "package --page deb": "for_page to_build to_package"}


def shown_on(keyboard):
    """All that programs printed on a terminal; one reading gives a part of it."""
    parts = []
    while select.select([keyboard], [], [], 0.2)[0]:
        parts.append(os.read(keyboard, 1 << 16))
    return b"".join(parts)


class Scripts(ProgramTest):
    """Scripts of tools/ in a copy of the folder, where they find stand-ins for all programs that they call."""

    def setUp(self):
        super().setUp()
        for script in (*SCRIPTS, "setup.sh"):
            self.write(f"tools/{script}", (SOURCE / "tools" / script).read_text())

    def add_stand_ins(self):
        """Of the programs that build and test, and of what they build."""
        self.write("tools/setup.sh", (SOURCE / "tools/setup.sh").read_text() + WITHOUT_PROCESSES)
        for path in (*(f"build/{build}/bin/hyrax-sim" for build in ("tools", "asan-clang", "clang", "asan", "debug")),
                     "tests/robustness/fuzz/run", "tests/must_fail/mutation/mutation.py"):
            self.write(path, f'#!/bin/sh\ncalled() {STAND_IN}\ncalled "${{0##*/}}" "$@"\n')
            (self.folder / path).chmod(0o755)

    def call(self, command, fails=""):
        """Runs one of the scripts; returns the outcome and the command lines of the stand-ins."""
        self.write("log", "")
        self.write("log.packages", "")
        script, *arguments = f"tools/{command}".split()
        outcome = run("bash", script, *arguments, cwd=self.folder,
                      env={**os.environ, **BY_NAME, "CI": "", "FAILS": fails, "LOG": f"{self.folder}/log"})
        return outcome, (self.folder / "log").read_text().splitlines()

    def test_what_is_called_and_exit_codes(self):
        """A build that fails is 3, a program's own code is passed on, a failed test is 1; the usage names each."""
        self.add_stand_ins()
        for command, fails, exit_code, part, calls in CALLS:
            with self.subTest(command=command, fails=fails):
                outcome, log = self.call(command, fails)
                self.assertEqual(outcome.exit_code, exit_code, outcome)
                self.assertIn(part, outcome.err)
                self.assertEqual((self.folder / "log.packages").read_text().split(), NEEDED.get(command, "to_build" if command == "run a.json" else "").split())
                stated = re.search(r"Exit code: [^.]*", (self.folder / f"tools/{command.split()[0]}").read_text())[0]
                self.assertRegex(stated, r"that of `?hyrax-" if exit_code == 8 or command == "run" else rf"\b{exit_code}\b")
                text = re.sub(r"--seed \d{8} ", "--seed DATE ", ", ".join(log).replace(str(self.folder.resolve()), "PROJECT"))
                self.assertEqual(re.sub(OF_EVERY_CALL, "", text.replace("PROJECT/build/", "/")), calls)
        (self.folder / "build/tools/bin/hyrax-sim").unlink()
        outcome, log = self.call("run a.json", "unwritable")
        self.assertEqual((outcome.exit_code, log), (3, []), "neither built nor there")

    def test_a_header_is_built_in_a_folder_of_its_own_and_all_other_arguments_are_those_of_check(self):
        self.add_stand_ins()
        header = self.folder.resolve() / self.write("my physics.hpp", "")
        number = run("bash", "-c", 'cksum <<< "$1"', "-", header).out.split()[0]
        folder = self.write(f"build/check/{header.name}-{number}/hyrax-sim", (self.folder / "build/tools/bin/hyrax-sim").read_text())
        (self.folder / folder).chmod(0o755)
        self.write("log", "")
        outcome = run("bash", "tools/check", "a.json", header.name, "b.h", "--json", cwd=self.folder,
                      env={**os.environ, **BY_NAME, "CI": "", "FAILS": "hyrax-sim*", "LOG": f"{self.folder}/log"})
        self.assertEqual(outcome.exit_code, 8, outcome)
        called = (self.folder / "log").read_text().replace(str(self.folder.resolve()), "PROJECT").splitlines()[2:]
        own = f"PROJECT/build/check/{header.name}-{number}"
        self.assertEqual(called, [
            "ninja --quiet -C PROJECT/build/tools hyrax_program",
            f"cmake --log-level=WARNING -S PROJECT/tools/own_core/check -B {own} -G Ninja -DCMAKE_BUILD_TYPE=Release "
            f"-DHEADER=PROJECT/{header.name} -Dhyrax_DIR=PROJECT/build/tools/check_package",
            f"ninja --quiet -C {own} hyrax-sim", "hyrax-sim check a.json b.h --json"])
        outcome, log = self.call("check none.h")
        self.assertEqual((outcome.exit_code, log), (BAD_INPUT, []))
        self.assertIn("tools/check: HEADER: no such file (found ", outcome.err)

    def test_a_missing_scenario_is_reported_before_anything_is_built(self):
        usage = run(PROGRAM, "run", "--help").out
        options, flags = (",".join(re.findall(rf"^  (-\S+) {value}", usage, re.MULTILINE)).split(",") for value in (r"\S", " "))
        self.assertTrue("--golden" in options and "--drift" in flags, usage)
        of_run = re.search(r"^names_scenario.*?^}$", (self.folder / "tools/run").read_text(), re.DOTALL | re.MULTILINE)[0]
        taken_for_options = run("bash", "-c", f'{of_run}\nfor flag; do names_scenario "$flag" x || echo "$flag"; done', "-", *flags).out
        self.assertEqual(taken_for_options, "")
        with_values = [word for option in options for word in (option, "x")]
        outcome = run("bash", "tools/run", "--yes", *with_values, "--figure", cwd=self.folder)
        self.assertEqual((outcome.exit_code, outcome.out), (BAD_INPUT, ""), outcome)
        self.assertIn("tools/run: SCENARIO is missing", outcome.err)
        self.assertFalse((self.folder / "build").exists())

    def test_every_option_of_a_usage_is_read_and_every_one_that_is_read_is_in_it(self):
        for script in SCRIPTS:
            with self.subTest(script=script):
                outcome, log = self.call(f"{script} --help")
                self.assertEqual((outcome.exit_code, log, outcome.out[:6 + len(script)]), (0, [], f"tools/{script}"))
                usage, code = re.search(r"<< 'END'\n(.*?)\nEND\n(.*)", (self.folder / "tools" / script).read_text(), re.DOTALL).groups()
                read = set(re.findall(r"^    (--[a-z-]+)\)", code, re.MULTILINE))
                of_programs = {"--figure", "--report", "--set", "--verbose", "--json", "--help"}  # To which a script passes them.
                self.assertEqual(set(re.findall(r"--[a-z-]+", usage)) - of_programs, read)
                for listed in re.findall("; allowed: (.*)\"", code):
                    self.assertEqual(set(re.findall("--[a-z-]+", listed)), read | {"--help"})

    def test_old_packages_are_neither_copied_nor_listed(self):
        self.add_stand_ins()
        for path in ("build/package/packages/hyrax-1.deb", "build/packages/hyrax-1.deb", "build/packages/SHA256SUMS"):
            self.write(path, "")
        outcome, _ = self.call("package deb")
        self.assertEqual((outcome.exit_code, outcome.out.split()[1:]), (0, ["hyrax-2.deb"]), outcome)
        self.assertEqual(self.names("build/packages"), ["SHA256SUMS", "hyrax-2.deb"])

    def test_a_debian_package_needs_no_compiler_for_another_system(self):
        needed = run("bash", "-c", '. tools/setup.sh; echo "${packages_to_build[@]}" "${packages_to_package[@]}"', cwd=self.folder).out.split()
        self.assertEqual([package for package in needed if package.startswith(("g++", "clang"))], ["g++"])

    def test_functions_of_setup(self):
        """What each returns, prints and calls."""
        cache = f"CMAKE_HOME_DIRECTORY:INTERNAL={self.folder.resolve()}\nA:BOOL=ON\nB:STRING=long\n"
        again = f"[[ -d build/x ]] || mkdir -p build/x; : > build/x/build.ninja; printf %s '{cache}' > build/x/CMakeCache.txt\n"
        cases = "".join(f"{again * ('/x' in command)}{begin} FAILS='{fails}'; {command}; {end} 2> err.{number} 3> called.{number}; echo $?\n"
                        for number, (command, fails, exit_code, *_) in enumerate(FUNCTIONS)
                        for begin, end in ["()" if exit_code == 3 or re.search(r"=|\(\)", command) else "{}"])
        keyboard, terminal = pty.openpty()
        os.write(keyboard, "".join(ANSWERS.values()).encode())
        codes = run("bash", "-c", NO_PROGRAMS + cases, cwd=self.folder, env={**os.environ, "assume_yes": "yes"}, stdin=terminal).out.split()
        self.assertEqual(shown_on(keyboard).count(b"Install them?"), len(ANSWERS))
        progress = run("bash", "-c", NO_PROGRAMS + "ninja() { echo progress; }; build build/x", cwd=self.folder, stderr=terminal)
        self.assertEqual(progress.out, "")
        self.assertEqual(shown_on(keyboard), b"progress\r\n")
        os.close(keyboard)
        os.close(terminal)
        for number, (command, fails, exit_code, err, called) in enumerate(FUNCTIONS):
            with self.subTest(command=command, fails=fails):
                printed, calls = ((self.folder / f"{name}.{number}").read_text() for name in ("err", "called"))
                self.assertEqual(codes[number], str(exit_code), printed)
                self.assertRegex(printed, rf"(?s)\A{err}\Z")
                calls = [re.sub(r"(?<=^apt-get -qq install ).*=300 ", "", line.replace(str(self.folder.resolve()), "PROJECT")) for line in calls.splitlines()]
                self.assertEqual(calls, called)
