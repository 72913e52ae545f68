#!/usr/bin/python3
"""Help, version, schema and validate; and messages about a bad command line."""

import json
import re

import jsonschema

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, ProgramTest, fling, main


class CommandTest(ProgramTest):
    """Tests of every command."""

    def commands(self):
        """The commands that the first help screen names."""
        screen = self.expect(AGREED, "--help").out
        commands = re.findall(r"^  ([a-z]+) +\S", screen[screen.index("\nCommands:\n"):], re.MULTILINE)
        self.assertGreaterEqual(len(commands), 7)
        return commands


class Help(CommandTest):
    """Everything has help, with an example."""

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


class Usage(CommandTest):
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
        for command in self.commands():
            self.refuse(command, "--colour", says=(f"hyrax-sim {command}:", "unknown option (found --colour)"))
        self.refuse("run", "a.json", "--outptu", "x.h5", says=("unknown option (found --outptu)", "(did you mean --output?)"))

    def test_a_value_that_is_no_choice_is_refused(self):
        self.refuse("drift", "a.json", "--reference", "close", says=("unknown value (found close)", "(did you mean closed?)"))


class Schema(ProgramTest):
    """The schema is for editors."""

    def test_it_is_a_json_schema_that_knows_a_good_scenario(self):
        schema = json.loads(self.expect(AGREED, "schema").out)
        self.assertEqual(schema["$id"], "urn:hyrax-scenario:1")
        validator = jsonschema.validators.validator_for(schema)
        validator.check_schema(schema)
        validator(schema).validate(fling())
        self.assertFalse(validator(schema).is_valid(fling(steps=-1)))


class Validate(ProgramTest):
    """Reads scenarios without playing them."""

    def test_a_dash_is_standard_input(self):
        for document, exit_code in ((fling(), AGREED), (fling(steps=-1), BAD_INPUT)):
            source = self.write("fling.json", document)
            with open(self.folder / source, "rb") as stream:
                outcome = self.expect(exit_code, "validate", "-", stdin=stream)
            self.assertTrue((outcome.out + outcome.err).startswith("-: "), outcome)

    def test_a_missing_file_cannot_be_read(self):
        self.expect(CANNOT_ACCESS, "validate", "none.json", says="none.json: cannot be read")


if __name__ == "__main__":
    main()
