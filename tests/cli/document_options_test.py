"""Options that documents and help texts name are those of the programs and scripts, and what is said of one is not of another."""

import collections
import functools
import itertools
import json
import re
import unittest

from documentation_test import DOCUMENTS, text_of
from process import run
from program import PROGRAM, SOURCE

FORMAT = "scenarios/README.md"


@functools.cache
def help_screens():
    """Of every command."""
    commands = re.findall(r"^  ([a-z]+) {2,}", run(PROGRAM, "--help", "--all").out or run(PROGRAM, "--help").out, re.MULTILINE)
    return [run(PROGRAM, command, "--help").out for command in commands]


def stems(text):
    """How words begin, without names and what every sentence has."""
    words = re.findall(r"[a-z]{4,}", re.sub(r"`[^`]*`", "", text).lower())
    return {word[:5] for word in words if word not in ("each", "file", "files", "from", "left", "than", "that", "this", "where", "what", "which", "with")}


def keys_of(schema):
    """(key, its title and description), of all keys of a schema."""
    for key, inner in schema.items() if isinstance(schema, dict) else ():
        if isinstance(inner, dict):
            yield key, f"{inner.get('title', '')} {inner.get('description', '')}"
        for each in inner if isinstance(inner, list) else [inner]:
            yield from keys_of(each)


def options_of(text):
    """(option or key, stems of what is said after it), of each table of them; options of each sentence, too."""
    text = re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)
    option = re.compile(r"`(?:[a-z-]+ )?(--[a-z-]+)[^`]*`")
    for table in text.split("\n\n"):
        yield [(row[1], stems(row[2])) for row in re.finditer(r"^\| `(--[a-z-]+|[a-z_]+)(.*)\|$", table, re.MULTILINE)]
    for sentence in re.split(r"(?<=[.:;])\s|\n\n|\n- |\n\|.*", text):
        _, *parts = option.split(sentence)
        yield [(name, stems(re.split("[,)]", said)[0])) for name, said in zip(parts[::2], parts[1::2])]


class Options(unittest.TestCase):
    def test_every_option_in_a_document_is_one_of_the_programs(self):
        known = set(re.findall(r"--[a-z][a-z-]+", "".join(help_screens())))
        self.assertGreater(len(known), 40)
        for document in DOCUMENTS:
            for line in re.findall(r"hyrax-sim [a-z]+[^`\n|;]*", document.read_text(encoding="utf-8")):
                with self.subTest(document=str(document.relative_to(SOURCE)), line=line):
                    self.assertLessEqual(set(re.findall(r"(?<=\s)--[a-z][a-z-]+", line)), known)

    def test_each_task_has_its_command_and_each_core_its_commands(self):
        tasks = re.findall(r"^\| [a-z][^|]*\| [^|]*?`hyrax-sim (\w+)", text_of("README.md"), re.MULTILINE)
        self.assertEqual(tasks, "run study check bless diff drift study study fuzz shrink sweep new".split())
        for target, description in re.findall(r"^\| \[[^]]*\]\(([\w/.]+)\) \| ([^|[]*)", text_of("README.md"), re.MULTILINE):
            self.assertLessEqual(stems(description), stems(text_of(target)) | {"sourc", "layou"}, target)
        others = re.search(r"^\| any other \| (.*) \|$", text_of("tools/own_core/README.md"), re.MULTILINE)[1]
        needing = {path.stem for path in (SOURCE / "tools/hyrax-sim").glob("*.cpp") if "needs_paper_step = true" in path.read_text(encoding="utf-8")}
        self.assertEqual(set(re.findall(r"`(\w+)`", others)), set(re.findall(r"\bCOMMAND\((\w+)\)", text_of("tools/hyrax-sim/program.cpp"))) - needing - {"schema"})

    def test_every_option_of_a_script_in_a_document_is_one_of_its_own_or_of_its_program(self):
        of_programs = set(re.findall(r"--[a-z][a-z-]+", "".join(help_screens())))
        for document in DOCUMENTS:
            for script, line in re.findall(r"(tools/(?:run|check|test|package)|tests/\w+/run|\.ci/run)\b([^`\n|;#]*)", document.read_text(encoding="utf-8")):
                with self.subTest(document=str(document.relative_to(SOURCE)), script=script, line=line):
                    known = set(re.findall(r"--[a-z][a-z-]+", text_of(script))) | (of_programs if re.search("run|check", script) else set())
                    self.assertLessEqual(set(re.findall(r"(?<=\s)--[a-z][a-z-]+", line)), known)

    def test_every_variable_for_cmake_in_a_document_is_one_that_it_reads(self):
        options = re.findall(r"option\((\w+)", text_of("CMakeLists.txt") + text_of("tools/CMakeLists.txt"))
        known = {"CMAKE_PREFIX_PATH", "NDEBUG", *options,
                 *(path.name.replace("-config.cmake", "_DIR") for path in (SOURCE / "tools/cmake").glob("*-config.cmake"))}
        for document in DOCUMENTS:
            self.assertLessEqual(set(re.findall(r"(?<=\s)-D(\w+)", document.read_text(encoding="utf-8"))), known, document)

    def test_every_option_of_a_help_text_is_parsed_and_every_one_that_is_parsed_is_in_it(self):
        for program, sources in (("hyrax", ("options.cpp",)), ("hyrax-replay", ("main.cpp", "check.cpp"))):
            parsed = set(re.findall('"(--[a-z]+)"', "".join(text_of(f"tools/{program}/{source}") for source in sources)))
            self.assertEqual(set(re.findall("--[a-z]+", text_of(f"tools/{program}/help.txt"))) | {"--help"}, parsed)

    def test_no_two_options_and_no_two_keys_are_exchanged(self):
        """What is said after each of two has not more words of the other's help, or description in the schema, than of its own."""
        helps = collections.defaultdict(set)
        for option, text in re.findall(r"^  (?:-\w,)?(--[a-z-]+)((?:.*\n)(?: {10,}.*\n)*)", "".join((*help_screens(), text_of("tools/hyrax/help.txt"))), re.MULTILINE):
            helps[option] |= stems(text)
        for key, meaning in keys_of(json.loads(text_of("tools/files/scenario.schema.json"))):
            helps[key] |= stems(meaning)
        settled = 0
        for document in DOCUMENTS:
            for said in options_of(document.read_text(encoding="utf-8")):
                said = [(name, words) for name, words in said if name.startswith("--") or document == SOURCE / FORMAT]
                for (one, of_one), (other, of_other) in itertools.combinations(said, 2):
                    only_one, only_other = helps[one] - helps[other], helps[other] - helps[one]
                    right, wrong = (len(of_one & left) + len(of_other & right)
                                    for left, right in ((only_one, only_other), (only_other, only_one)))
                    settled += right > wrong
                    self.assertGreaterEqual(right, wrong, (str(document.relative_to(SOURCE)), one, other))
        self.assertGreater(settled, 100)
