"""Folders of scenarios, and where their golden files are: with links and unreadable entries."""

import os

from program import AGREED, CANNOT_ACCESS, ProgramTest, fling


class Folders(ProgramTest):
    """A folder as argument means every *.json below it; nothing is left out silently."""

    def setUp(self):
        super().setUp()
        self.write("scenarios/a/one.json", fling(name="one"))
        self.write("elsewhere/two.json", fling(name="two"))

    def link(self, target, path):
        os.symlink(target, self.folder / path)

    def listed(self, exit_code=AGREED, folder="scenarios", says=()):
        """The scenarios that a command finds."""
        results = self.expect(exit_code, "validate", folder, "--json", says=says).json["results"]
        return [entry["scenario"] for entry in results]

    def test_a_linked_folder_is_followed(self):
        self.link("../elsewhere", "scenarios/b")
        self.assertEqual(self.listed(), ["scenarios/a/one.json", "scenarios/b/two.json"])
        self.bless("scenarios")
        self.assertEqual(self.names("golden/b"), ["two.h5", "two.txt"])
        self.assertEqual(self.expect(AGREED, "check", "--json").json["agreed"], 2)

    def test_linked_files_and_folders_named_like_scenarios_are_found_and_schemas_and_other_links_are_none(self):
        self.link("../elsewhere/two.json", "scenarios/linked.json")
        self.write("scenarios/c.json/three.json", fling(name="three"))
        self.write("scenarios/two.schema.json", fling(name="two"))
        self.write("scenarios/Makefile", "all:")
        self.write("scenarios/scenario.schema.json", self.expect(AGREED, "schema").out)
        self.link("nowhere", "scenarios/notes.txt")
        self.link("scenarios", "link")
        self.assertEqual(self.listed(folder="link"),
                         ["link/a/one.json", "link/c.json/three.json", "link/linked.json", "link/two.schema.json"])

    def test_the_golden_folder_is_beside_the_nearest_folder_named_scenarios(self):
        self.write("scenarios/part/scenarios/three.json", fling(name="three"))
        self.bless("scenarios")
        self.assertEqual(self.names("scenarios/part/golden"), ["three.h5", "three.txt"])
        for command in (("check",), ("check", "scenarios")):
            self.assertEqual(self.expect(AGREED, *command, "--json").json["agreed"], 2)

    def test_links_in_a_circle_come_to_an_end(self):
        self.link(".", "scenarios/self")
        self.link("../..", "scenarios/a/root")
        self.link("a", "scenarios/again")
        self.assertEqual([path for path in self.listed() if "elsewhere" not in path],
                         ["scenarios/a/one.json", "scenarios/again/one.json"])

    def test_a_dangling_link_is_exit_3(self):
        for name, target in (("gone.json", "nowhere.json"), ("gone", "/no/such/folder"), ("loop.json", "loop.json")):
            self.link(target, f"scenarios/{name}")
            self.assertEqual(self.listed(CANNOT_ACCESS, says=f"scenarios/{name}: cannot be read"),
                             ["scenarios/a/one.json", f"scenarios/{name}"])
            for command in (("run",), ("check",), ("drift",)):
                outcome = self.expect(CANNOT_ACCESS, *command, "scenarios", *(("-o", "out/") if command == ("run",) else ()))
                self.assertIn(f"scenarios/{name}: cannot be read", outcome.out + outcome.err)
            (self.folder / f"scenarios/{name}").unlink()

    def test_what_cannot_be_read_does_not_keep_the_others_from_being_played(self):
        self.write("scenarios/locked/two.json", fling(name="two"))
        self.bless("scenarios")
        (self.folder / "scenarios/locked").chmod(0)
        self.addCleanup((self.folder / "scenarios/locked").chmod, 0o755)
        os.mkfifo(self.folder / "scenarios/pipe.json")
        says = ["scenarios/pipe.json: cannot be read: is a pipe or a device"]
        if not os.access(self.folder / "scenarios/locked", os.R_OK):
            says.append("scenarios/locked: cannot be read: Permission denied")
        self.expect(CANNOT_ACCESS, "validate", "scenarios", says=says)
        outcome = self.expect(CANNOT_ACCESS, "check")
        for part in (*says, f"{3 - len(says)} agreed, 0 disagreed"):
            self.assertIn(part, outcome.out)
        self.expect(CANNOT_ACCESS, "run", "scenarios", "-o", "out/", says=says)
        self.assertIn("one.h5", self.names("out"))
        self.expect(CANNOT_ACCESS, "bless", "scenarios", "--reason", "x", says=["nothing written", *says])
