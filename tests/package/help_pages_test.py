#!/usr/bin/python3
"""The man page and the bash completion: each command and option that the program's help names is in both."""

import gzip
import pathlib
import re
import shlex

from process import run, skip_without, succeed
from program import PROGRAM, SOURCE, ProgramTest, main

MAKER = SOURCE / "tools/cmake/help_pages.py"

# hyrax-sim with one more command, which has an option of its own.
LONGER = r"""#!/bin/sh
case "$*" in
  --help) {program} --help | sed 's/^  info .*/&\n  juggle    throw several at once/' ;;
  'juggle --help') {program} new --help | sed 's/hyrax-sim new/hyrax-sim juggle/; s/--column/--how-many/' ;;
  *) exec {program} "$@" ;;
esac
"""


def options_in_help(program):
    """{command: its options}, as its help lists them."""
    screen = succeed(program, "--help").out
    commands = re.findall(r"^  ([a-z]+) +\S", screen[screen.index("\nCommands:\n"):], re.MULTILINE)
    found = {}
    for command in commands:
        text = succeed(program, command, "--help").out
        found[command] = {name for names in re.findall(r"^  (-\S+)", text, re.MULTILINE) for name in names.split(",")}
    return found


def options_in_page(page):
    """{command: its options}, as the rendered man page shows them."""
    parts = re.split(r"^   (\w+)\n", page[page.index("\nCOMMANDS\n"):page.index("\nEXAMPLES\n")], flags=re.MULTILINE)
    return {command: {name for names in re.findall(r"^       (-\S+)", text, re.MULTILINE) for name in names.split(",")}
            for command, text in zip(parts[1::2], parts[2::2], strict=True)}


class HelpPages(ProgramTest):
    """The files that tools/cmake/help_pages.py makes."""

    def setUp(self):
        super().setUp()
        self.program = PROGRAM
        self.make()

    def make(self):
        """Makes both files."""
        succeed("/usr/bin/python3", "-B", MAKER, self.program, self.folder / "pages")

    def page(self):
        """The man page as a reader sees it; the formatter must have no complaint."""
        source = gzip.decompress((self.folder / "pages/hyrax-sim.1.gz").read_bytes()).decode()
        outcome = succeed("groff", "-man", "-ww", "-Tascii", "-P-cbou", self.file("page.1", source))
        self.assertEqual(outcome.err, "")
        return outcome.out

    def file(self, name, text):
        """A file in the folder."""
        return pathlib.Path(self.folder / self.write(name, text))

    def completed(self, *words):
        """What bash offers for the last word."""
        line = " ".join(map(shlex.quote, words))
        script = (f"source {shlex.quote(str(self.folder))}/pages/hyrax-sim; COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; "
                  "_hyrax_sim; printf '%s\\n' \"${COMPREPLY[@]}\"")
        return set(succeed("bash", "-euc", script).out.split())

    def test_every_command_and_option_is_in_the_man_page(self):
        self.assertEqual(options_in_page(self.page()), options_in_help(self.program))

    def test_every_command_and_option_is_completed(self):
        expected = options_in_help(self.program)
        self.assertEqual(self.completed("hyrax-sim", ""), {*expected, "--help", "--version"})
        for command, options in expected.items():
            self.assertEqual(self.completed("hyrax-sim", command, "-"), options, command)

    def test_a_new_command_and_option_is_in_both(self):
        self.program = self.file("longer", LONGER.replace("{program}", shlex.quote(str(PROGRAM))))
        self.program.chmod(0o755)
        self.assertIn("--how-many", options_in_help(self.program)["juggle"])
        self.assertNotEqual(options_in_page(self.page()), options_in_help(self.program))  # Made without it.
        self.make()
        self.test_every_command_and_option_is_in_the_man_page()
        self.test_every_command_and_option_is_completed()

    def test_words_are_completed_from_their_beginning(self):
        self.assertEqual(self.completed("hyrax-sim", "sch"), {"schema"})
        self.assertEqual(self.completed("hyrax-sim", "check", "--ju"), {"--junit"})
        self.assertEqual(self.completed("hyrax-sim", "run", "--reference", ""), {"closed", "gsl"})
        self.assertEqual(self.completed("hyrax-sim", "run", "scen"), set())  # bash completes file names.

    def test_the_page_has_examples_and_exit_codes(self):
        page = " ".join(self.page().split())
        for part in ("EXIT STATUS 0 agreed or done, 1 disagreed,", "70 internal error",
                     "hyrax-sim check scenarios/flings --junit check.xml", "/usr/share/hyrax-sim/golden"):
            self.assertIn(part, page)

    def test_the_same_program_gives_the_same_bytes(self):
        def state():
            return {path.name: path.read_bytes() for path in (self.folder / "pages").iterdir()}

        before = state()
        self.make()
        self.assertEqual(state(), before)

    def test_a_program_that_fails_gives_no_pages(self):
        outcome = run("/usr/bin/python3", "-B", MAKER, "/bin/false", self.folder / "none")
        self.assertNotEqual(outcome.exit_code, 0)
        self.assertFalse((self.folder / "none").exists())


if __name__ == "__main__":
    skip_without("groff")
    main()
