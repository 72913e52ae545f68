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

    def test_the_exit_code_and_both_outputs_are_captured(self):
        outcome = run("sh", "-c", "cat; echo out; echo err >&2; exit 3")
        self.assertEqual((outcome.exit_code, outcome.out, outcome.err), (3, "out\n", "err\n"))
        self.assertEqual(run("sh", "-c", "kill -9 $$").exit_code, -9)

    def test_outputs_larger_than_a_pipe_are_complete(self):
        outcome = run("sh", "-c", "head -c 3000000 /dev/zero; head -c 2000000 /dev/zero >&2")
        self.assertEqual((len(outcome.out_bytes), len(outcome.err_bytes)), (3_000_000, 2_000_000))

    def test_only_success_is_success(self):
        self.assertEqual(succeed("echo", 1).out, "1\n")
        with self.assertRaisesRegex(Failed, "exit code 1"):
            succeed("false")

    def test_at_the_end_of_the_time_all_of_it_is_killed(self):
        with Process("sh", "-c", f"{LEAVES_A_CHILD}; wait") as process:
            child = int(process.line())
            with self.assertRaisesRegex(TimedOut, "still running after 0.2 s"):
                process.wait(0.2)
        self.assert_ends(child)

    def test_a_child_that_is_left_neither_delays_the_outcome_nor_survives(self):
        begin_s = time.monotonic()
        outcome = run("sh", "-c", LEAVES_A_CHILD)
        self.assertLess(time.monotonic() - begin_s, 60)
        self.assert_ends(int(outcome.out))

    def test_children_that_are_kept_survive(self):
        with Process("sh", "-c", LEAVES_A_CHILD, keeps_children=True) as process:
            child = int(process.wait().out)
        self.assertTrue(is_alive(child))
        os.kill(child, 9)
        self.assert_ends(child)

    def test_a_process_that_is_not_waited_for_is_killed(self):
        with Process("sleep", 600) as process:
            self.assertTrue(process.is_running)
        self.assertFalse(is_alive(process.id))

    def test_the_memory_of_a_program_is_measured(self):
        allocate = "bytearray(int(__import__('sys').argv[1]))"
        (_, little), (_, much) = (run_measured("/usr/bin/python3", "-S", "-E", "-c", allocate, size) for size in (1, 25_000_000))
        self.assertLess(little, 20_000_000)
        self.assertGreater(much, 25_000_000)
