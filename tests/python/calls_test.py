"""Long calls tell how far they are, let other threads run, and end soon when asked to."""
import os
import signal
import threading
import time
import unittest

from support import Case, ball, glisson, np


class Calls(Case):
    def test_progress_is_told_and_grows(self):
        told = []
        glisson.mesh_labels(ball(), target_cells=2000, progress=lambda fraction, stage: told.append((fraction, stage)))
        self.assertTrue(told)
        fractions = [fraction for fraction, _ in told]
        self.assertEqual(fractions, sorted(fractions))
        self.assertTrue(all(0 <= fraction <= 1 for fraction in fractions))
        self.assertTrue(all(isinstance(stage, str) and stage for _, stage in told))

    def test_what_progress_raises_cancels_and_is_raised(self):
        class Enough(Exception):
            pass

        def stop(fraction, stage):
            raise Enough(stage)

        with self.assertRaises(Enough):
            glisson.mesh_labels(ball(64, 60.0), target_cells=100000, progress=stop)

    def test_keyboard_interrupt_ends_a_long_call_soon(self):
        pressed = []

        def press():
            time.sleep(0.3)
            pressed.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)  # what Ctrl-C sends

        surface = glisson.mask_surface(ball(48, 40.0))
        presser = threading.Thread(target=press)
        presser.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                glisson.match_surfaces(surface, surface, points=160, solver="trws")  # some seconds
        finally:
            presser.join()
        self.assertLess(time.monotonic() - pressed[0], 5.0)  # hundredths of a second, but for a busy machine

    def test_other_threads_run_meanwhile(self):
        ticks = []
        done = threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.005)

        ticker = threading.Thread(target=tick)
        ticker.start()
        begin = time.monotonic()
        glisson.mesh_labels(ball(48, 40.0), target_cells=8000)
        lasted = time.monotonic() - begin
        done.set()
        ticker.join()
        self.assertGreater(len([t for t in ticks if t >= begin]), lasted / 0.005 / 20)

    def test_calls_run_beside_each_other(self):
        answers = [None, None]

        def mesh(n):
            answers[n] = glisson.mesh_labels(ball(), target_cells=2000).body

        threads = [threading.Thread(target=mesh, args=(n,)) for n in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        np.testing.assert_array_equal(answers[0].points_mm, answers[1].points_mm)

    def test_bad_threads_are_refused(self):
        self.assertRefused("threads-invalid", glisson.set_thread_count, -1)
        glisson.set_thread_count(0)


if __name__ == "__main__":
    unittest.main()
