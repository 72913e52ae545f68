"""The workflows of .github, which have not been run there: what can be checked of them here."""

import pathlib
import re
import sys
import unittest

from program import SOURCE

sys.path.insert(0, str(SOURCE / "tests/platforms"))
from rows import BUILDS, CONTROLS  # pylint: disable=wrong-import-position

WORKFLOWS = sorted((SOURCE / ".github/workflows").glob("*.yml"))
PINNED = re.compile(r"[\w-]+/[\w-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+")
RELEASE = (SOURCE / ".github/workflows/release.yml").read_text()


def unpinned(text):
    """The actions that are not named by the hash of a commit, with the version beside it."""
    return [used for used in re.findall(r"uses: (.*)", text) if not PINNED.fullmatch(used)]


def jobs_of(text):
    """Each from its name on."""
    return re.split(r"^  (?=\w+:$)", text.partition("jobs:\n")[2], flags=re.MULTILINE)[1:]


def writers(text):
    """The jobs that may write, and "" if all may."""
    header = text.partition("jobs:\n")[0]
    found = [job.split(":")[0] for job in jobs_of(text) if re.search(r": write|write-all", job)]
    return found if re.search(r"^permissions:\n  contents: read\n(?! )", header, re.MULTILINE) else ["", *found]


def rows_without_job(text):
    """The rows of the platforms that no job of the release runs."""
    expressions = [each.replace("\\\\", "\\") for each in
                   re.findall(r'"([^"]*)"', re.search(r"only: \[(.*?)\]\n", text, re.DOTALL)[1])]
    return [row.name for row in (*BUILDS, *CONTROLS) if not any(re.search(each, row.name) for each in expressions)]


class Workflows(unittest.TestCase):
    """Each rule, and a change of a workflow that breaks it."""

    def test_actions_are_pinned_by_commit(self):
        for path in WORKFLOWS:
            self.assertEqual(unpinned(path.read_text()), [], path)
        self.assertEqual(unpinned(re.sub("@[0-9a-f]{40} # v4.6.2", "@v4", RELEASE)), ["actions/upload-artifact@v4"])

    def test_only_the_upload_may_write(self):
        for path in WORKFLOWS:
            self.assertEqual(writers(path.read_text()), ["publish"] if path.name == "release.yml" else [], path)
        self.assertEqual(writers(RELEASE.replace("permissions:\n  contents: read\n", "")), ["", "publish"])

    def test_jobs_that_run_the_tests_may_mount_file_systems(self):
        for path in WORKFLOWS:
            for job in jobs_of(path.read_text()):
                if re.search(r"run: (tools/test|\.ci/run)", job):
                    self.assertIn("options: --privileged", job, path)

    def test_every_platform_has_a_job(self):
        self.assertEqual(rows_without_job(RELEASE), [])
        self.assertEqual(rows_without_job(RELEASE.replace('"^s390x", ', "")), ["s390x, big-endian"])

    def test_the_scripts_exist_and_know_the_options(self):
        for path in WORKFLOWS:
            for script in re.findall(r"tools/\w+|tests/\w+/run", path.read_text()):
                self.assertTrue((SOURCE / script).exists() or (SOURCE / f"{script}.sh").exists(), script)

    def test_each_says_that_it_has_not_been_run(self):
        for path in WORKFLOWS:
            self.assertIn("has not been run on GitHub yet.", path.read_text().splitlines()[0], path)
        readme = " ".join(pathlib.Path(SOURCE / "README.md").read_text().split())
        self.assertIn("The GitHub workflows in `.github/` have not been run there.", readme)
