"""Help; arguments are taken literally, wherever they are; output that cannot be written is an error."""

import os
import re

from process import skip_for_lack_of
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, GOLDEN_MISSING, SOURCE, ProgramTest, fling

ESCAPE = "\x1b[31m"
HOSTILE = f"a{ESCAPE}\x7f\u009b1m\udc9b\udcff.json"  # ESC, DEL, CSI as one character, and bytes that are no UTF-8.


class Help(ProgramTest):
    def test_it_has_several_names(self):
        for names in (("--help", "-h", "help", ""), ("run --help", "run -h", "help run")):
            texts = {self.expect(AGREED, *name.split()).out for name in names}
            self.assertEqual(len(texts), 1, names)

    def test_the_schema_is_that_of_the_reader(self):
        schema = (SOURCE / "tools/files/scenario.schema.json").read_text(encoding="utf-8")
        self.assertEqual({self.expect(AGREED, "schema", *option).out for option in ((), ("--json",))}, {schema})


class Literal(ProgramTest):
    """No argument is split, unquoted or expanded."""

    def test_brackets_commas_and_the_like_are_part_of_a_path(self):
        for decoy in ("a", "b"):
            self.write(f"{decoy}/decoy.json", fling(name=f"decoy-{decoy}"))
        names = ("[a]", "[a,b]", "{}", "{a}", "a,b", "%%", "'a'", '"a"', "a b", "++", "*", "$HOME", "~", "@a", "[]")
        paths = [self.write(f"{name}/fling.json", fling()) for name in names]
        for given in (names, paths):
            results = self.expect(AGREED, "validate", "--json", *given).json["results"]
            self.assertEqual([entry["scenario"] for entry in results], paths)

    def test_a_value_may_look_like_an_option_or_be_in_brackets(self):
        self.write("fling.json", fling())
        self.expect(AGREED, "run", "fling.json", "-o", "--json.h5")
        self.expect(AGREED, "run", "fling.json", "--output=[-o].h5")
        self.expect(AGREED, "run", "fling.json", "-o-x.h5")
        self.expect(AGREED, "run", "fling.json", "-o=.h5")
        self.assertEqual(self.names(), ["--json.h5", "-x.h5", "=.h5", "[-o].h5", "fling.json"])

    def test_after_two_dashes_all_are_files(self):
        self.write("--json", fling(name="odd"))
        self.write("--", fling(name="dashes"))
        self.assertEqual(self.expect(AGREED, "validate", "--", "--json", "--").out,
                         "--json: good, 300 steps\n--: good, 300 steps\n")


class Order(ProgramTest):
    """An option takes one value, and may be before, between and after the files."""

    def test_options_with_and_without_values(self):
        files = self.project("one", "two")
        options = (["--set", "/steps=9"], ["-o", "out/"], ["--golden", "golden"], ["--drift"], ["--no-skip"])
        separate = [word for option in options for word in option]
        joined = [("=" if option[0].startswith("--") else "").join(option) for option in options]
        for before, form, after in (([], separate, files), (files[:1], joined, files[1:]), (files, separate, [])):
            self.assertEqual(self.expect(AGREED, "run", *before, *form, *after).out.count("  contacts  "), 2, f"{before} {form} {after}")

    def test_set_takes_one_value_each_time(self):
        files = [self.write(f"{name}.json", fling(name=name)) for name in ("one", "two")]
        first, second = ("--set", "/steps=9"), ("--set=/start/x_px=5",)
        for arguments in ((*files, *first, *second), (*second, *files, *first), (*first, *second, *files)):
            runs = self.expect(AGREED, "run", *arguments, "--json").json["runs"]
            self.assertEqual([(run["scenario"], run["steps"]) for run in runs], [(path, 9) for path in files])


class Number(ProgramTest):
    """A number is a decimal number in its range, and nothing else."""

    def test_values_out_of_range_are_refused(self):
        for number in ("99999999999999999999", "-99999999999999999999", "9223372036854775808", "1e3", "0x10", " 1", "1 ",
                       "+1", "1,0", "", "inf"):
            self.expect(BAD_INPUT, "check", "--jobs", number, says="--jobs")
        for number in ("9223372036854775808", "1e3", "-1"):
            self.expect(BAD_INPUT, "diff", "a.h5", "b.h5", "--ulps", number, says="--ulps")
        for number in ("1e999", "-1e-999", "nan", "inf", "0x1p3", "1px", "1,5"):
            self.expect(BAD_INPUT, "diff", "a.h5", "b.h5", "--abs", number, says="--abs")

    def test_a_limit_is_allowed_and_the_next_number_is_not(self):
        self.write("fling.json", fling())
        self.write("sweep.json", {"format": "hyrax-sweep/1", "base": fling(), "vary": {"/start/x_px": {"grid": [0, 9, 2]}}})
        self.expect(AGREED, "run", "fling.json")
        same = "diff", "fling.h5", "fling.h5"
        for arguments, limit, past in ((same + ("--abs",), "0", "-1e-300"), (same + ("--rel",), "0", "-1e-300"),
                                       (same + ("--ulps",), "0", "-1"), (("drift", "fling.json", "--tolerance"), "0.1", "0.11"),
                                       (("drift", "fling.json", "--tolerance"), "1e-14", "9e-15"),
                                       (("fuzz", "--runs"), "1", "0"), (("fuzz", "--runs", "1", "--seed"), "0", "-1"),
                                       (("sweep", "sweep.json", "--threads"), "1", "0"),
                                       (("sweep", "sweep.json", "-o", "m.json", "--member"), "1", "2"),
                                       (("sweep", "sweep.json", "-o", "n.json", "--member"), "0", "-1")):
            self.expect(AGREED, *arguments[:-1], f"{arguments[-1]}={limit}")
            self.expect(BAD_INPUT, *arguments[:-1], f"{arguments[-1]}={past}", says=arguments[-1])


class OneDocument(ProgramTest):
    """--json gives one JSON document on stdout, for every command."""

    def test_every_command_takes_it(self):
        files = self.project("one")
        self.expect(AGREED, "run", *files)
        screen = self.expect(AGREED, "--help").out
        sweep = {"format": "hyrax-sweep/1", "base": fling(), "vary": {"/start/x_px": {"grid": [0, 9, 3]}}}
        commands = {"run": files, "check": files, "diff": ["one.h5", "one.h5"], "drift": files, "validate": files,
                    "study": ["needs", *files, "--quick", "--no-figures"], "info": [], "new": ["fresh"], "schema": [],
                    "bless": [*files, "--reason", "x"], "sweep": [self.write("sweep.json", sweep)],
                    "fuzz": ["--runs", "1"],
                    "shrink": [self.write("wrong.json", fling(expect={"finite": False})), "-o", "small.json"]}
        with_page = ["report"]  # Its --json is tested where the page is built: tests/browser.
        listed = re.findall(r"^  ([a-z]+) +\S", screen.split("\nCommands:\n")[1], re.M)
        self.assertEqual(sorted([*commands, *with_page]), sorted(listed))
        for command, arguments in commands.items():
            self.assertIsInstance(self.expect(AGREED, command, *arguments, "--json").json, dict, command)
            outcome = self.expect(BAD_INPUT, command, "--colour", says=f"hyrax-sim {command}: unknown option (found --colour)")
            self.assertEqual((outcome.out, outcome.err.count("\n")), ("", 1), command)

    def test_a_path_of_bad_utf_8_leaves_it_well_formed(self):
        path = self.write(HOSTILE, fling(name="fling"))
        for command in ("run", "validate", "drift", "check"):
            document = self.expect(GOLDEN_MISSING if command == "check" else AGREED, command, path, "--json").json
            entry = next(value for value in document.values() if isinstance(value, list))[0]
            self.assertEqual(entry["scenario"], f"a{ESCAPE}\x7f\u009b1m\ufffd\ufffd.json")


class Terminal(ProgramTest):
    """Control characters are printed escaped."""

    SHOWN = r"a\u001b[31m\u007f\u009b1m\x9b\xff.json"

    def test_paths_in_tables_and_messages(self):
        good = self.write(f"scenarios/{HOSTILE}", fling(name="fling", expect={"final_x_px": [0, 1]}))
        bad = self.write(f"bad-{HOSTILE}", "{")
        text = lambda outcome: outcome.out + outcome.err
        for exit_code, arguments in ((DISAGREED, ("run", good, "-o", f"{HOSTILE}.h5")), (AGREED, ("validate", good)),
                                     (GOLDEN_MISSING, ("check", good)), (DISAGREED, ("bless", good, "--reason", "x")),
                                     (BAD_INPUT, ("run", bad)), (BAD_INPUT, ("validate", bad)), (BAD_INPUT, ("drift", bad)),
                                     (BAD_INPUT, ("bless", bad, "--reason", "x", "--golden", "g")),
                                     (BAD_INPUT, ("check", bad)), (BAD_INPUT, ("diff", bad, bad)),
                                     (CANNOT_ACCESS, ("run", f"no-{HOSTILE}")), (BAD_INPUT, ("study", HOSTILE)),
                                     (BAD_INPUT, ("study", "needs", bad)), (BAD_INPUT, (HOSTILE,)),
                                     (BAD_INPUT, ("check", f"--{HOSTILE}"))):
            outcome = self.expect(exit_code, *arguments)
            self.assertIn(self.SHOWN, text(outcome), str(arguments))
            for obeyed in ("\x1b", "\x7f", "\u009b"):
                self.assertNotIn(obeyed, text(outcome), str(arguments))


class Streams(ProgramTest):
    """Standard streams that are full or closed."""

    def setUp(self):
        super().setUp()
        for number in range(40):
            self.write(f"many/a-name-that-takes-its-room-in-every-line-{number}.json", fling(name=None, steps=40))
        one_scenario = self.write("scenarios/one.json", fling(name="one", steps=40))
        self.write("bad.json", "{")
        self.expect(AGREED, "run", "scenarios", "-o", "out/")
        self.one = self.folder / "out/one.h5"
        self.loud = (("validate", "many"), ("validate", "many", "--json"), ("run", "scenarios", "-o", "now/"),
                     ("run", "scenarios", "-o", "now/", "--json"), ("check", "scenarios"), ("check", "scenarios", "--json"),
                     ("drift", "scenarios", "--reference", "closed"), ("schema",), ("run", "--help"), ("--help",),
                     ("info",), ("info", "--json"), ("diff", self.one, self.one),
                     ("study", "needs", one_scenario, "--quick", "--no-figures", "--json"),
                     ("bless", "scenarios", "--reason", "x", "--golden", "g"))

    def test_a_full_standard_output_is_exit_3(self):
        if not os.path.exists("/dev/full"):
            skip_for_lack_of("/dev/full")
        for arguments in self.loud:
            with open("/dev/full", "wb") as full:
                outcome = self.expect(CANNOT_ACCESS, *arguments, stdout=full)
            self.assertTrue(outcome.err.endswith("hyrax-sim: standard output cannot be written\n"), outcome)

    def closed(self, number, exit_code, *arguments):
        self.expect(exit_code, *arguments, preexec_fn=lambda: os.close(number))

    def test_a_closed_standard_output_is_exit_3(self):
        for arguments in self.loud[3:7]:  # They open files, which must not be in the place of the stream.
            self.closed(1, CANNOT_ACCESS, *arguments)
        written = (self.folder / "now/one.h5").read_bytes()
        self.assertEqual(written, self.one.read_bytes(), "something is printed into a file in the place of the stream")

    def test_a_closed_standard_error_changes_no_verdict(self):
        for exit_code, arguments in ((BAD_INPUT, ("validate", "bad.json")), (BAD_INPUT, ("run", "bad.json")),
                                     (BAD_INPUT, ("drift", "bad.json")), (BAD_INPUT, ("chekc",)),
                                     (BAD_INPUT, ("bless", "bad.json", "--reason", "x", "--golden", "g")),
                                     (AGREED, ("validate", "many"))):
            self.closed(2, exit_code, *arguments)
