"""Help, version, schema; and messages about a bad command line."""

import re

from program import AGREED, BAD_INPUT, SOURCE, ProgramTest


class Help(ProgramTest):
    def test_the_first_screen_is_also_what_no_argument_gives(self):
        text = self.expect(AGREED, "--help").out
        for arguments in ((), ("-h",), ("help",)):
            self.assertEqual(self.expect(AGREED, *arguments).out, text)

    def test_help_about_a_command_is_that_command_s(self):
        text = self.expect(AGREED, "run", "--help").out
        for arguments in (("help", "run"), ("run", "-h")):
            self.assertEqual(self.expect(AGREED, *arguments).out, text)
        self.expect(BAD_INPUT, "help", "rum", says="(did you mean run?)")

    def test_the_version_is_one_line(self):
        for option in ("--version", "-V"):
            self.assertRegex(self.expect(AGREED, option).out, r"\Ahyrax-sim \d+\.\d+\.\d+\n\Z")


class Usage(ProgramTest):
    """A bad command line is exit 2, with a one-line message that names the remedy, and no output."""

    def refuse(self, *arguments, says):
        """One line on stderr, nothing on stdout."""
        outcome = self.expect(BAD_INPUT, *arguments, says=says)
        self.assertEqual(outcome.out, "")
        self.assertEqual(outcome.err.count("\n"), 1, outcome.err)
        self.assertEqual(self.names(), [])

    def test_an_unknown_command_is_refused(self):
        self.refuse("chekc", says=("unknown command (found chekc); allowed: run, check, ", "(did you mean check?)", "--help"))

    def test_an_unknown_option_is_refused(self):
        screen = self.expect(AGREED, "--help").out
        commands = re.findall(r"^  ([a-z]+) +\S", screen[screen.index("\nCommands:\n"):], re.MULTILINE)
        self.assertGreaterEqual(len(commands), 7)
        for command in commands:
            self.refuse(command, "--colour", says=(f"hyrax-sim {command}:", "unknown option (found --colour)"))
        self.refuse("run", "a.json", "--outptu", "x.h5", says=("unknown option (found --outptu)", "(did you mean --output?)"))

    def test_a_value_that_is_no_choice_is_refused(self):
        self.refuse("drift", "a.json", "--reference", "close", says=("unknown value (found close)", "(did you mean closed?)"))


class Schema(ProgramTest):
    def test_it_is_that_of_the_reader(self):
        schema = (SOURCE / "tools/files/scenario.schema.json").read_text(encoding="utf-8")
        self.assertEqual(self.expect(AGREED, "schema").out, schema)
