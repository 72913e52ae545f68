"""The man page and the bash completion: each command and option that the program's help names is in both."""

import gzip
import pathlib
import re
import shlex
import tempfile

from process import run, skip_without, succeed
from program import PROGRAM, SOURCE, ProgramTest

skip_without("groff")

MAKER = SOURCE / "tools/cmake/help_pages.py"


def help_screens():
    """{command: its help}."""
    screen = succeed(PROGRAM, "--help").out
    commands = re.findall(r"^  ([a-z]+) +\S", screen[screen.index("\nCommands:\n"):], re.MULTILINE)
    return {command: succeed(PROGRAM, command, "--help").out for command in commands}


def options_in(text):
    return {name for names in re.findall(r"^  (-\S+)", text, re.MULTILINE) for name in names.split(",")}


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
        cls.pages = pathlib.Path(folder.name, "pages")
        succeed("/usr/bin/python3", "-B", MAKER, PROGRAM, cls.pages)

    def page(self):
        """The man page as a reader sees it; the formatter must have no complaint."""
        source = gzip.decompress((self.pages / "hyrax-sim.1.gz").read_bytes()).decode()
        outcome = succeed("groff", "-man", "-ww", "-Tascii", "-P-cbou", self.folder / self.write("page.1", source))
        self.assertEqual(outcome.err, "")
        return outcome.out

    def completed(self, *lines):
        """What bash offers for the last word of each line."""
        asked = "".join(f"COMP_WORDS=({shlex.join(words)}); COMP_CWORD={len(words) - 1}; unset COMPREPLY; _hyrax_sim; "
                        "printf '%s ' \"${COMPREPLY[@]}\"; echo\n" for words in lines)
        script = f"source {shlex.quote(str(self.pages))}/hyrax-sim\n{asked}"
        return [set(line.split()) for line in succeed("bash", "-euc", script).out.splitlines()]

    def test_every_command_and_option_is_in_both_and_all_of_its_help_in_the_page(self):
        screens = help_screens()
        options = {command: options_in(text) for command, text in screens.items()}
        page = self.page()
        self.assertEqual(options_in_page(page), options)
        commands, *offered = self.completed(("hyrax-sim", ""), *(("hyrax-sim", command, "-") for command in options))
        self.assertEqual(commands, {*options, "--help", "--version"})
        self.assertEqual(dict(zip(options, offered, strict=True)), options)
        page = " ".join(page.split())
        for part in ("EXIT STATUS 0 agreed or done, 1 disagreed,", "70 internal error", "/usr/share/hyrax-sim/golden Their golden files."):
            self.assertIn(part, page)
        letters = re.sub(r"[\s-]", "", page)  # Words are divided at ends of lines.
        for command, text in screens.items():
            for part in re.split(r" {2,}|\n", re.sub(r"^(Usage: |[A-Z][a-z]+:$)", "", text, flags=re.MULTILINE)):
                self.assertIn(re.sub(r"[\s-]", "", part), letters, command)

    def test_words_are_completed_from_their_beginning(self):
        lines = {("hyrax-sim", "sch"): {"schema"}, ("hyrax-sim", "check", "--ju"): {"--junit"},
                 ("hyrax-sim", "run", "--reference", ""): {"closed", "gsl"},
                 ("hyrax-sim", "run", "scen"): set()}  # bash completes file names.
        self.assertEqual(self.completed(*lines), list(lines.values()))

    def test_a_program_that_fails_gives_no_pages(self):
        outcome = run("/usr/bin/python3", "-B", MAKER, "/bin/false", self.folder / "none")
        self.assertNotEqual(outcome.exit_code, 0)
        self.assertFalse((self.folder / "none").exists())
