"""process.py, which runs the programs of all tests: captures output, ends in time, and leaves no process running."""

import os
import time
import unittest

from process import Failed, Process, TimedOut, is_alive, run, run_measured, succeed

# Starts a process that sleeps with the outputs open, prints its id and ends.
LEAVES_A_CHILD = "sleep 600 & echo $!"


class Running(unittest.TestCase):
    """Programs of the shell."""

    def assert_ends(self, process_id):
        """A process that was sent a signal is gone soon."""
        give_up_s = time.monotonic() + 60
        while is_alive(process_id):
            self.assertLess(time.monotonic(), give_up_s, "still running")
            time.sleep(0.01)

    def test_only_success_is_success(self):
        with self.assertRaisesRegex(Failed, "exit code -9"):
            succeed("sh", "-c", "kill -9 $$")

    def test_at_the_end_of_the_time_all_of_it_is_killed(self):
        with Process("sh", "-c", f"{LEAVES_A_CHILD}; wait") as process:
            child = int(process.line())
            with self.assertRaisesRegex(TimedOut, "still running after 0.2 s"):
                process.wait(0.2)
        self.assert_ends(child)

    def test_a_child_that_is_left_neither_delays_the_outcome_nor_survives_unless_it_is_kept(self):
        begin_s = time.monotonic()
        outcome = run("sh", "-c", LEAVES_A_CHILD)
        self.assertLess(time.monotonic() - begin_s, 60)
        self.assert_ends(int(outcome.out))
        child = int(run("sh", "-c", LEAVES_A_CHILD, keeps_children=True).out)
        self.assertTrue(is_alive(child))
        os.kill(child, 9)

    def test_the_most_memory_is_measured(self):
        size = 100_000_000
        outcome, peak_bytes, faults = run_measured("/usr/bin/python3", "-c", f"text = b'x' * {size}")
        self.assertEqual(outcome.exit_code, 0)
        self.assertTrue(size < peak_bytes < 2 * size, peak_bytes)
        self.assertGreater(faults, 0)
