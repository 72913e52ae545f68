"""The commands for `git bisect run` in golden/README.md find the commits that changed a result.

They run in a repository whose commits differ in a file, `core`: the name of the altered core that tools/check "builds".
"""

import os
import re
import shlex
import shutil

from altered import ALTERED
from process import skip_unless_installed, succeed
from program import SOURCE, ProgramTest

SCENARIO = "flings/first-fling"
# Core and message of each commit, from the good one on.
COMMITS = (("none", "Good"),
           ("friction_before_restitution", "Another order, the same bits"),
           ("gravity_by_one_ulp", "Changes the bits"),
           ("broken", "Does not build"),
           ("gravity_by_one_ulp", "Describes it"),
           ("gravity_stronger", "Moves a contact"),
           ("friction_stronger", "Moves others"))

CHECK = """#!/bin/sh
core=$(cat core)
if [ "$core" = broken ]; then echo 'cannot be built' >&2; exit 3; fi
HYRAX_ALTERED_CORE=$core exec {program} check "$@"
"""


def recipe():
    """The commands of the section: to keep the golden files, to find changed bits, to find a moved contact."""
    text = (SOURCE / "golden/README.md").read_text(encoding="utf-8")
    section = text[text.index("## Which commit changed a result"):]
    return re.findall(r"^```sh\n(.*?)^```$", section[:section.index("\n## ", 3)], re.MULTILINE | re.DOTALL)


class Bisect(ProgramTest):
    """A repository of seven commits."""

    def test_the_first_commit_that_changes_the_bits_and_that_moves_a_contact(self):
        skip_unless_installed("git")
        keep, bits, contact = recipe()
        repository = self.folder / "project"
        for name in (f"scenarios/{SCENARIO}.json", f"golden/{SCENARIO}.h5", f"golden/{SCENARIO}.txt"):
            (repository / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / name, repository / name)
        (repository / "tools").mkdir()
        (repository / "tools/check").write_text(CHECK.format(program=shlex.quote(str(ALTERED))))
        (repository / "tools/check").chmod(0o755)
        self.sh("set -e\ngit init -q\n" + "".join(
            f"echo {core} >core && echo {number} >number && git add . && git commit -qm {shlex.quote(message)}\n"
            for number, (core, message) in enumerate(COMMITS)) + f"git tag v0.1.0 HEAD~{len(COMMITS) - 1}\n" + keep)
        for commands, message in ((bits, "Changes the bits"), (contact, "Moves a contact")):
            out = self.sh(commands)
            self.assertRegex(out, rf"[0-9a-f]{{40}} is the first bad commit(\n.*)*\n    {message}\n")
            self.assertIn(COMMITS[-1][1], self.sh("git log -1 --format=%s"), "bisect reset has come back")

    def sh(self, commands):
        """Runs the commands in the repository, by a user who has no settings of his own."""
        variables = {"HOME": str(self.folder), "GIT_CONFIG_NOSYSTEM": "1"}
        for who in ("AUTHOR", "COMMITTER"):
            variables |= {f"GIT_{who}_NAME": "A", f"GIT_{who}_EMAIL": "a@example.org"}
        return succeed("bash", "-c", commands, cwd=self.folder / "project", env={**os.environ, **variables}).out
