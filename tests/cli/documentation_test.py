#!/usr/bin/python3
"""The documentation agrees with the program: every README.md and CHANGELOG.md is read and tried out.

    documentation_test.py             tests
    documentation_test.py --update    rewrites printed outputs and pictures that differ from the program's

HYRAX_ALTERED_SIM is a hyrax-sim whose core is changed on purpose; HYRAX_ALTERED_CORE selects the change.
With HYRAX_LONG_BLOCKS set, and by --update, blocks marked `long` are run, too.

What a README may print, by the first word after the fence:

    console   `$ COMMAND` lines, each followed by its exact output (stdout and stderr). The commands of a file run
              in order, by bash, in one scratch folder with copies of some folders of the project: those of COPIED,
              and those of COPIED_IF_NAMED that the file's blocks name. After the first word:
              exit=N   exit code of the last command that fails (0 if left out)
              core=N   `hyrax-sim` is the altered program, with core N
              long     by hyrax-sim.documentation_all only; an everyday test does the same with less
              A line `<!-- varies: REGEX -->` above the block names what differs from run to run.
    json      is valid; a scenario is valid, too, and its expectations hold. A name after the first word is the
              file's name in the scratch folder.
    python    runs there without error, after the blocks above it. May be `long`.
    cmake, cpp   are lines of tests/cli/outside_project or tests/cli/own_physics, which build and run.
    sh    is not run, but its scripts exist.
    text, yaml  are not checked.

A picture whose name a file in the scratch folder has, after all blocks, says what that one says, and is as large.
"""

import collections
import dataclasses
import functools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from process import run, succeed
from program import PROGRAM, SOURCE

README_WORDS_MAX = 1300
COPIED = ("scenarios/flings", "golden/flings", "golden/core")
COPIED_IF_NAMED = ("scenarios/hard", "scenarios/recorded", "tests/robustness/fuzz/found")
FOLDERS = ("golden", "scenarios", "sim", "tests", "tools")
DOCUMENTS = sorted([*SOURCE.glob("*.md"), *(path for folder in FOLDERS for path in (SOURCE / folder).rglob("*.md"))])

BLOCK = re.compile(r"(?:^<!-- varies: (?P<varies>[^\n]*) -->\n)?"
                   r"^```(?P<info>[^\n`]+)\n(?P<body>.*?)^```$", re.MULTILINE | re.DOTALL)
RUN = {"console", "json", "python"}
# What documents name in backquotes though no source has it: how it was called before, placeholders, programs of others,
# what sources put together, and what only tests have.
NAMED_NOWHERE = set("""cost_lower_quartile cost_upper_quartile cost_low cost_high steps_astray u_i mpirun pre-commit-config
    python3-numpy my_physics-replay my_physics-sim data-core data-first-difference data-state-hash
    DCMAKE_PREFIX_PATH hyrax-figures hyrax-sim_ many-bounces fling-2 m_spin
    toy-sim NAME-sim toy_core NAME_posix NAME_windows LongPathsEnabled PROCESS spin touches_rail mt19937""".split())
NOT_RUN = {"sh", "cmake", "cpp", "text", "yaml"}
RUNS_LONG = "HYRAX_LONG_BLOCKS" in os.environ or "--update" in sys.argv


@dataclasses.dataclass(frozen=True)
class Block:
    """A fenced block: what kind it is, its attributes, and the text between the fences."""

    kind: str
    arguments: tuple
    body: str
    varies: str

    def attribute(self, name, default):
        """The value of NAME=VALUE after the fence."""
        return next((text.partition("=")[2] for text in self.arguments if text.startswith(name + "=")), default)

    @property
    def commands(self):
        """The text after `$ `."""
        return [line[2:] for line in self.body.splitlines() if line.startswith("$ ")]

    def comparable(self, text):
        """The text without the parts that differ from run to run."""
        return re.sub(self.varies, "VARIES", text, flags=re.MULTILINE) if self.varies else text


def block_of(match):
    kind, *arguments = match["info"].split()
    return Block(kind, tuple(arguments), match["body"], match["varies"] or "")


def blocks_of(document):
    return [block_of(match) for match in BLOCK.finditer(document.read_text(encoding="utf-8"))]


class Scratch:
    """Copies of the project's folders that some blocks need, where commands do no harm."""

    def __init__(self, blocks):
        named = "".join(block.body for block in blocks)
        self.copied = [*COPIED, *(folder for folder in COPIED_IF_NAMED if folder in named)]

    def __enter__(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hyrax-documentation-"))
        self.folder = self.top / "project"
        self.folder.mkdir()
        succeed("cp", "-R", "--parents", *self.copied, self.folder, cwd=SOURCE)
        (self.top / "bin").mkdir()
        (self.top / "of temporary files").mkdir()
        self.text = ""  # That the last console block printed.
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.top)

    def call(self, program, core=""):
        """Makes `hyrax-sim` call that program; returns the environment for it."""
        link = self.top / "bin/hyrax-sim"
        link.unlink(missing_ok=True)
        link.symlink_to(program)
        return {**os.environ, "PATH": f"{link.parent}:{os.environ['PATH']}", "HYRAX_ALTERED_CORE": core or "none",
                "TMPDIR": str(self.top / "of temporary files")}

    def run(self, command, environment):
        """Runs a command by bash; returns its exit code and its output."""
        done = run("bash", "-c", command, cwd=self.folder, env=environment, stderr=subprocess.STDOUT, timeout=250)
        return done.exit_code, done.out

    def print_of(self, block):
        """The expected output of the block, and its exit code."""
        core = block.attribute("core", "")
        environment = self.call(pathlib.Path(os.environ["HYRAX_ALTERED_SIM"]).resolve() if core else PROGRAM, core)
        text, exit_code = "", 0
        for command in block.commands:
            code, output = self.run(command, environment)
            exit_code = code or exit_code
            text += f"$ {command}\n{output}"
        return text, exit_code

    def write(self, block):
        """Writes a JSON block that has a name."""
        for name in block.arguments:
            (self.folder / name).write_text(block.body, encoding="utf-8")

    def try_out(self, block):
        """Runs a block of any kind; returns the promised and the actual result: output and exit code."""
        if "long" in block.arguments and not RUNS_LONG:
            return None, None
        if block.kind == "json":
            self.write(block)
        is_scenario = block.kind == "json" and json.loads(block.body).get("format") == "hyrax-scenario/1"
        if is_scenario or block.kind == "python":
            command = "hyrax-sim run - -o -" if is_scenario else "/usr/bin/python3 -"
            code, output = self.run(f"{command} << 'END'\n{block.body}END", self.call(PROGRAM))
            return ("", 0), (output if code else "", code)
        if block.kind == "console":
            self.text, code = self.print_of(block)
            promised = (block.comparable(block.body), int(block.attribute("exit", "0")))
            return promised, (block.comparable(self.text), code)
        return None, None


def anchors_of(document):
    """Anchors of a document's headings, as GitHub makes them."""
    text = re.sub(r"^```.*?^```$", "", document.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    titles = re.findall(r"^#+ +(.*)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def words_outside_blocks(document):
    return BLOCK.sub("", document.read_text(encoding="utf-8"))


@functools.cache
def text_of(path):
    return (SOURCE / path).read_text(encoding="utf-8")


def names_in(text):
    return set(re.findall(r"\b[A-Za-z_]\w{2,}(?:-\w+)*", text))


def names_of_sources(folders):
    """Names in sources, and of files and folders."""
    names = {word for path in SOURCE.glob("*.*") if path.suffix in (".txt", ".json") for word in names_in(path.read_text(encoding="utf-8"))}
    for folder, folders_in, files in (each for top in folders for each in os.walk(SOURCE / top)):
        names.update(folders_in, *(name.split(".") for name in files))
        for path in (pathlib.Path(folder, name) for name in files if not re.search(r"\.(md|h5|svg|png|pyc)$", name)):
            if not re.search("/(golden|found|scenarios)/|documentation_test.py$", str(path)):
                names |= names_in(path.read_text(encoding="utf-8", errors="replace"))
    return names


def dead_links_of(document):
    """Targets of links within the project that do not exist, or have no such heading."""
    dead = []
    for target in re.findall(r"\]\(([^)\s]+)\)", words_outside_blocks(document)):
        path, _, anchor = target.partition("#")
        file = (document.parent / path).resolve() if path else document
        if not re.match(r"[a-z]+:", target) and (not file.exists() or anchor and anchor not in anchors_of(file)):
            dead.append(target)
    return dead


def pictures_of(document, scratch):
    """(picture of the document, the same as the program drew it) for those that its blocks draw."""
    for target in re.findall(r"!\[[^\]]*\]\(([^)]+\.svg)\)", document.read_text(encoding="utf-8")):
        picture = (document.parent / target).resolve()
        for drawn in scratch.folder.rglob(picture.name):
            yield picture, drawn


def said_by(picture):
    """Size, texts and style of a picture. Points, and so the ends of axes, differ by a rounding from machine to machine."""
    parts = re.findall(r"\A<svg[^>]*>|<(?:title|text|style)\b[^>]*>[^<]*", picture.read_text(encoding="utf-8"))
    parts = [re.sub(r"^<text[^>]*>", "<text>", part) for part in parts]
    return [part for part in parts if not re.fullmatch(r"<text>[\d.,−⁰¹²³⁴-⁹⁻ ]+", part)]


class Documents(unittest.TestCase):
    """Every document, one subtest each."""

    maxDiff = None

    def on_each(self, document):
        return self.subTest(document=str(document.relative_to(SOURCE)))

    def test_what_each_names_exists(self):
        """Kinds of blocks, targets of links, paths, scripts, presets; and the lines about embedding, which a test builds."""
        listed = json.loads((SOURCE / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]
        presets = {preset["name"] for preset in listed if not preset.get("hidden")}
        projects = [SOURCE / "tests/cli/outside_project", SOURCE / "tests/cli/own_physics", SOURCE / "tests/cli/own_cores"]
        built = {kind: "".join(file.read_text(encoding="utf-8") for project in projects for file in project.glob(pattern))
                 for kind, pattern in (("cmake", "CMakeLists.txt"), ("cpp", "*.cpp"))}
        built["cpp"] += text_of("tools/own_core/new_core.h.in")
        built["cpp"] += re.sub("^    ", "", text_of("tests/unit/sim/study/swept_physics.h"), flags=re.MULTILINE)
        for document in DOCUMENTS:
            text, blocks = document.read_text(encoding="utf-8"), blocks_of(document)
            with self.on_each(document):
                self.assertEqual(len(re.findall(r"^```", text, re.MULTILINE)), 2 * len(blocks), "a fence without a kind")
                self.assertLessEqual({block.kind for block in blocks}, RUN | NOT_RUN)
                self.assertEqual(dead_links_of(document), [])
                for path in re.findall(r"`((?:\.ci|sim|tools|tests|scenarios|golden)/[\w./-]*)`", words_outside_blocks(document)):
                    self.assertTrue("FOLDER/" in path or (SOURCE / path).exists(), f"no such file in the project: {path}")
                self.assertLessEqual(set(re.findall(r"--preset ([a-z-]+)", text)), presets)
                for block in blocks:
                    for script in re.findall(r"^((?:\.ci|tools|tests)/\S+)", block.body, re.MULTILINE):
                        self.assertTrue(block.kind != "sh" or os.access(SOURCE / script, os.X_OK), script)
                    for line in block.body.splitlines() if block.kind in built else ():
                        self.assertIn(line, built[block.kind])

    def test_every_block_prints_what_the_program_prints(self):
        """A scenario is valid, and its expectations hold."""
        seen, pictures = collections.Counter(), 0
        for document in DOCUMENTS:
            blocks = [block for block in blocks_of(document) if block.kind in RUN]
            if not blocks:
                continue
            with self.on_each(document), Scratch(blocks) as scratch:
                for block in blocks:
                    seen[block.kind] += 1
                    with self.subTest(block="; ".join(block.commands)):
                        self.assertEqual(*scratch.try_out(block))
                for picture, drawn in pictures_of(document, scratch):
                    pictures += 1
                    self.assertEqual(said_by(picture), said_by(drawn), picture)
                if document == SOURCE / "README.md":
                    self.try_the_task_table(document, scratch)
        self.assertTrue(seen["console"] > 10 and seen["json"] > 1 and pictures > 1, "blocks or pictures were not found")

    def try_the_task_table(self, document, scratch):
        """Every command of the table works after the document's blocks."""
        rows = re.findall(r"^\|[^|]*\|([^|]*)\|$", document.read_text(encoding="utf-8"), re.MULTILINE)
        commands = [command for row in rows for command in re.findall(r"`(hyrax-sim [^`]*)`", row)
                    if not re.search("sweep.json|study", command)]  # Pages of their own have these.
        self.assertGreater(len(commands), 8, "README.md: the task table was not found")
        for command in commands:
            with self.subTest(command=command):
                code, output = scratch.run(command, scratch.call(PROGRAM))
                if command.startswith("hyrax-sim shrink"):  # Of a scenario that is good.
                    self.assertIn("my.json: nothing to keep", output)
                else:
                    self.assertEqual(code, 0, output)

    def test_every_name_exists(self):
        """A key, column, option, file, command or program in backquotes; of the changelog, in its newest version."""
        everywhere = names_of_sources(("sim", "tools", "scenarios", "golden", ".ci", ".github"))
        in_tests, missing = names_of_sources(("tests",)), set()
        for document in DOCUMENTS:
            text = words_outside_blocks(document)
            text = text.split("\n## ")[1] if document.name == "CHANGELOG.md" else text
            known = everywhere | (in_tests if document.is_relative_to(SOURCE / "tests") else set())
            known = known.union(*(names_in(f"{block.arguments} {block.body}") for block in blocks_of(document) if block.kind != "text"))
            missing |= names_in("\n".join(re.findall("`([^`]+)`", text))) - known
        self.assertEqual(missing, NAMED_NOWHERE)

    def test_the_readme_is_short_and_links_to_every_other_one(self):
        text = (SOURCE / "README.md").read_text(encoding="utf-8")
        self.assertLessEqual(len(text.split()), README_WORDS_MAX)
        for document in DOCUMENTS:
            folder = document.parent.relative_to(SOURCE)
            if document.name == "README.md" and folder.parts:
                self.assertRegex(text, rf"\]\({folder}(/README\.md)?[)#]", f"README.md: no link to {folder}")


class Controls(unittest.TestCase):
    """Every kind of wrong document is detected, and updated."""

    WRONG = ("# A title\n[a](none.md) [b](#a-title) [c](#no-title)\n"
             "```console\n$ echo yes; false\nno\n```\n"
             "<!-- varies: \\d+ s -->\n```console\n$ echo 12 s\n7 s\n```\n"
             "```python\nraise SystemExit(1)\n```\n"
             "![old](old.svg) ![same](same.svg)\n```console\n$ echo '<text>new' | tee old.svg > same.svg\n```\n")

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="hyrax-documentation-")
        self.addCleanup(folder.cleanup)
        self.document = pathlib.Path(folder.name) / "README.md"
        self.document.write_text(self.WRONG, encoding="utf-8")
        self.document.with_name("old.svg").write_text("<text>old", encoding="utf-8")
        self.document.with_name("same.svg").write_text("<text>new\n<", encoding="utf-8")

    def test_what_is_wrong_is_detected_and_an_update_rewrites_only_what_differs(self):
        with Scratch(()) as scratch:
            tried = [scratch.try_out(block) for block in blocks_of(self.document)]
            pictures = [said_by(picture) == said_by(drawn) for picture, drawn in pictures_of(self.document, scratch)]
        self.assertEqual([promised == came for promised, came in tried], [False, True, False, True])
        self.assertEqual(pictures, [False, True])
        self.assertEqual(dead_links_of(self.document), ["none.md", "#no-title"])
        update(self.document)
        self.assertEqual(self.document.read_text(encoding="utf-8"), self.WRONG.replace("\nno\n", "\nyes\n"))
        self.assertEqual(self.document.with_name("old.svg").read_text(encoding="utf-8"), "<text>new\n")
        self.assertEqual(self.document.with_name("same.svg").read_text(encoding="utf-8"), "<text>new\n<")


def update(document):
    """Replaces the output of each console block that differs from the program's; returns a line about each."""
    changes = []
    with Scratch(blocks_of(document)) as scratch:

        def renewed(match):
            block = block_of(match)
            promised, came = scratch.try_out(block)
            if block.kind != "console" or promised == came:
                return match[0]
            changes.append(f"{document}: {'; '.join(block.commands)}: "
                           + (f"exit code {came[1]}, expected {promised[1]}" if promised[1] != came[1] else "updated"))
            return match[0].replace(block.body, scratch.text, 1)

        text = BLOCK.sub(renewed, document.read_text(encoding="utf-8"))
        for picture, drawn in pictures_of(document, scratch):
            if said_by(picture) != said_by(drawn):
                shutil.copyfile(drawn, picture)
                changes.append(f"{picture}: updated")
    document.write_text(text, encoding="utf-8")
    return changes


if __name__ == "__main__":
    if "--update" in sys.argv:
        for one in DOCUMENTS:
            for change in update(one):
                print(change)
    else:
        unittest.main()
