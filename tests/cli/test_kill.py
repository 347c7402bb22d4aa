"""label: slow. A kill in the middle of a save leaves the old file or the new one, whole. When to kill is counted in saves
and in the processor's time, not in seconds: a busy machine takes longer to come as far."""
import http.client
import os
import random
import subprocess
import threading
import time
import unittest

from editor import EditTest, drawing
from program import HANG, PROGRAM

KILLS = int(os.environ.get("BATTEN_KILLS", 25))  # docs/reliability.md says what came of more


def processor_time(process):
    """Seconds that a running process has had of the processor."""
    return time.clock_gettime((~process.pid << 3) | 2)  # its clock, as clock_getcpuclockid() makes it


class Kill(EditTest):
    def test_kill_while_saving(self):
        random.seed(5)
        versions = [drawing(x, 2000) for x in (1, 2)]
        for wanted in range(KILLS // 2):
            editor = self.start(content=versions[0])
            saves = threading.Semaphore(0)

            def save():
                number = 0
                try:
                    tag = editor.tag()
                    while True:
                        number += 1
                        tag = editor.put(versions[number % 2], tag)[1]["ETag"]
                        saves.release()
                except (OSError, http.client.HTTPException):
                    return

            thread = threading.Thread(target=save)
            thread.start()
            for _ in range(wanted % 4):
                self.assertTrue(saves.acquire(timeout=HANG))
            until = processor_time(editor.process) + random.uniform(0, 0.05)
            while processor_time(editor.process) < until:
                time.sleep(0.001)
            editor.process.kill()
            thread.join()
            self.assertIn(self.path.read_bytes(), versions)
            for left in self.folder.glob(".batten-*"):  # a killed process cannot clean up
                left.unlink()

    def test_kill_while_converting(self):
        self.kill_conversions()

    def test_kill_while_writing_in_place(self):
        """A file with two names: it is whole, or the copy from before is there, whole."""
        self.kill_conversions(linked=True)

    def kill_conversions(self, linked=False):
        random.seed(6)
        big = self.file("big.batten", drawing(3, 3000))
        out, copy, old = self.folder / "out.svg", self.folder / "out.svg.before-save", b"old " * 100000

        def convert(limit):
            """Kills the program when it has had so much of the processor. Its time, and whether it came to its end."""
            process = subprocess.Popen([PROGRAM, "convert", big, out])
            had = 0
            while process.poll() is None and had < limit:
                had = processor_time(process)
                time.sleep(0.001)
            process.kill()
            return had, process.wait(HANG) == 0

        whole_time, done = convert(float("inf"))
        whole = out.read_bytes()
        self.assertTrue(done and whole.startswith(b"<?xml"))
        if linked:
            os.link(out, self.folder / "twin.svg")
        killed = 0
        for _ in range(KILLS):
            copy.unlink(missing_ok=True)
            out.write_bytes(old)
            done = convert(whole_time * random.uniform(0, 1))[1]
            killed += not done
            self.assertIn((copy if copy.exists() else out).read_bytes(), (whole,) if done else (old, whole))
            self.assertFalse(copy.exists() and (done or not linked))
        self.assertGreater(killed, 0)


if __name__ == "__main__":
    unittest.main()
