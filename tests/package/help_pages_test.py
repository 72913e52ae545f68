#!/usr/bin/python3
"""The man page and the bash completion: each command and option that the program's help names is in both."""

import gzip
import pathlib
import re
import shlex
import tempfile

from process import run, skip_without, succeed
from program import PROGRAM, SOURCE, ProgramTest, main

MAKER = SOURCE / "tools/cmake/help_pages.py"

# hyrax-sim with another command alone, which has an option of its own.
OTHER = r"""#!/bin/sh
case "$*" in
  --help) {program} --help | sed 's/^  info .*/  juggle    throw several at once/; /^  juggle /! { /^  [a-z]* \{2,\}[a-z]/d }' ;;
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

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory(prefix="hyrax-test-")
        cls.addClassCleanup(folder.cleanup)
        cls.pages = cls.made(PROGRAM, pathlib.Path(folder.name, "pages"))
        cls.options = options_in_help(PROGRAM)

    @staticmethod
    def made(program, folder):
        """The folder with both files of that program."""
        succeed("/usr/bin/python3", "-B", MAKER, program, folder)
        return folder

    def page(self, pages):
        """The man page as a reader sees it; the formatter must have no complaint."""
        source = gzip.decompress((pages / "hyrax-sim.1.gz").read_bytes()).decode()
        outcome = succeed("groff", "-man", "-ww", "-Tascii", "-P-cbou", self.file("page.1", source))
        self.assertEqual(outcome.err, "")
        return outcome.out

    def file(self, name, text):
        """A file in the folder."""
        return pathlib.Path(self.folder / self.write(name, text))

    def completed(self, pages, *lines):
        """What bash offers for the last word of each line."""
        asked = "".join(f"COMP_WORDS=({shlex.join(words)}); COMP_CWORD={len(words) - 1}; unset COMPREPLY; _hyrax_sim; "
                        "printf '%s ' \"${COMPREPLY[@]}\"; echo\n" for words in lines)
        script = f"source {shlex.quote(str(pages))}/hyrax-sim\n{asked}"
        return [set(line.split()) for line in succeed("bash", "-euc", script).out.splitlines()]

    def assert_complete(self, pages, options):
        """Every command and option is in the man page, and is completed."""
        page = self.page(pages)
        self.assertEqual(options_in_page(page), options)
        commands, *offered = self.completed(pages, ("hyrax-sim", ""), *(("hyrax-sim", command, "-") for command in options))
        self.assertEqual(commands, {*options, "--help", "--version"})
        self.assertEqual(dict(zip(options, offered, strict=True)), options)
        return page

    def test_every_command_and_option_is_in_both(self):
        page = " ".join(self.assert_complete(self.pages, self.options).split())
        for part in ("EXIT STATUS 0 agreed or done, 1 disagreed,", "70 internal error",
                     "hyrax-sim check scenarios/flings --junit check.xml", "/usr/share/hyrax-sim/golden"):
            self.assertIn(part, page)

    def test_a_new_command_and_option_is_in_both(self):
        other = self.file("other", OTHER.replace("{program}", shlex.quote(str(PROGRAM))))
        other.chmod(0o755)
        options = options_in_help(other)
        self.assertEqual(list(options), ["juggle"])
        self.assertIn("--how-many", options["juggle"])
        self.assert_complete(self.made(other, self.folder / "pages"), options)

    def test_words_are_completed_from_their_beginning(self):
        lines = {("hyrax-sim", "sch"): {"schema"}, ("hyrax-sim", "check", "--ju"): {"--junit"},
                 ("hyrax-sim", "run", "--reference", ""): {"closed", "gsl"},
                 ("hyrax-sim", "run", "scen"): set()}  # bash completes file names.
        self.assertEqual(self.completed(self.pages, *lines), list(lines.values()))

    def test_a_program_that_fails_gives_no_pages(self):
        outcome = run("/usr/bin/python3", "-B", MAKER, "/bin/false", self.folder / "none")
        self.assertNotEqual(outcome.exit_code, 0)
        self.assertFalse((self.folder / "none").exists())


if __name__ == "__main__":
    skip_without("groff")
    main()
