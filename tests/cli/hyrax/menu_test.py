"""The menu of the hyrax, by a right click and a key: its entries are inputs of the scene, or write files that replay."""

import time

from hyrax_program import FLING, FOLDER, HYRAX, HyraxTest
from program import AGREED, fling

ESCAPE, RETURN = 27, 13
TRAY_MESSAGE, RIGHT_BUTTON_UP = 0x8001, 0x205
OPENS_MS = 800
TRIES = 8
WAIT_S = 5


class Menu(HyraxTest):
    """The entries of the menu, each chosen while the hyrax is at rest."""

    def setUp(self):
        super().setUp()
        for path in self.saved():
            path.unlink()

    # --- doing

    def start_without_recording(self):
        """Starts the program as a user does who has not thought of recording."""
        process = self.wine.start(HYRAX, "--log", "flight.log", "--seconds", 600, cwd=self.folder)
        self.addCleanup(process.end)
        return process

    def choose(self, letters, has_come):
        """Opens the menu for each letter and chooses by it, again if the menu was not open in time on a busy machine."""
        for _ in range(TRIES):
            self.wait_for_sleep()
            for letter in letters:
                self.hand("point", 64, 90, "right", "sleep", OPENS_MS, "key", ord(letter))
            give_up_s = time.monotonic() + WAIT_S
            while time.monotonic() < give_up_s:
                if has_come():
                    return
                time.sleep(0.05)
            self.hand("key", ESCAPE, "sleep", 100)
        self.fail(f"{letters}: nothing came of it")

    @staticmethod
    def saved(name=""):
        """Files among the user's documents, by the beginning of their name."""
        return sorted(FOLDER.glob(f"prefix/drive_c/users/*/Documents/Hyrax/{name}*.json"))

    # --- judging

    def test_a_recording_is_begun_and_saved(self):
        process = self.start_without_recording()
        self.choose("CT", lambda: self.saved("recording"))
        self.choose("S", lambda: True)
        self.choose("Q", lambda: not process.is_running)
        path, = self.saved("recording")
        self.expect(AGREED, "run", path, "-o", self.folder / "recorded.h5")
        self.assertIn('"fling"', path.read_text())

    def test_beside_the_about_box_the_hyrax_is_grabbed_and_its_menu_opens(self):
        process = self.start_without_recording()
        self.wait_for_sleep()
        self.hand("point", 64, 90, "right", "sleep", OPENS_MS, "key", ord("A"), "sleep", OPENS_MS)
        self.hand(*FLING)
        self.wait_for_input("release")
        self.hand("post", TRAY_MESSAGE, 1, RIGHT_BUTTON_UP, "sleep", OPENS_MS, "key", ord("T"))
        self.wait_for_input("fling")
        self.hand("key", RETURN)
        self.choose("Q", lambda: not process.is_running)

    def test_a_replay_that_ends_below_the_about_box_has_one_verdict(self):
        process = self.wine.start(HYRAX, "--replay", self.write("short.json", fling(steps=300)), cwd=self.folder)
        self.addCleanup(process.end)
        self.hand("point", 64, 90, "right", "sleep", OPENS_MS, "key", ord("A"), "sleep", 7000, "key", RETURN)
        self.assertEqual(process.wait(WAIT_S).out.count("state hash"), 1)
