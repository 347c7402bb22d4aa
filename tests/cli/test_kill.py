"""label: slow. A kill in the middle of a save leaves the old file or the new one, whole."""
import http.client
import random
import subprocess
import threading
import time
import unittest

from program import PROGRAM
from editor import EditTest, drawing


class Kill(EditTest):
    def test_kill_while_saving(self):
        random.seed(5)
        versions = [drawing(x, 2000) for x in (1, 2)]
        saves = 0
        for _ in range(12):
            editor = self.start(content=versions[0])
            stop = threading.Event()

            def save():
                nonlocal saves
                tag, number = editor.tag(), 0
                while not stop.is_set():
                    number += 1
                    try:
                        tag = editor.put(versions[number % 2], tag)[1]["ETag"]
                        saves += 1
                    except (OSError, http.client.HTTPException):
                        return

            thread = threading.Thread(target=save)
            thread.start()
            time.sleep(random.uniform(0.1, 0.4))
            editor.process.kill()
            stop.set()
            thread.join()
            self.assertIn(self.path.read_bytes(), versions)
            for left in self.folder.glob(".batten-*"):  # a killed process cannot clean up
                left.unlink()
        self.assertGreater(saves, 0)

    def test_kill_while_converting(self):
        random.seed(6)
        big = self.file("big.batten", drawing(3, 3000))
        whole = self.done("convert", big, "-", "--to", "svg")
        out = self.folder / "out.svg"
        killed = 0
        for _ in range(25):
            out.write_text("old")
            process = subprocess.Popen([PROGRAM, "convert", big, out])
            time.sleep(random.uniform(0, 0.15))
            process.kill()
            killed += process.wait() != 0
            self.assertIn(out.read_bytes(), (b"old", whole))
        self.assertGreater(killed, 0)


if __name__ == "__main__":
    unittest.main()
