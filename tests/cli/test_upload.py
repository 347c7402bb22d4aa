"""label: slow. A save goes to the disk as it arrives: memory does not grow with it, and what breaks off changes nothing."""
import os
import re
import resource
import shutil
import signal
import socket
import subprocess
import time
import unittest

from editor import EditTest, drawing
from program import HANG, PROGRAM, SANITIZED

MIB = 1 << 20
SVG = "image/svg+xml"


def svg(size):
    """A drawing of about so many bytes, most of which make no picture."""
    head = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">'
    line = b"<!--" + b"0123456789abcdef" * 64 + b"-->\n"
    return head + line * (size // len(line)) + b'<path d="M1 1L8 8"/></svg>'


def memory(process, what):
    """Bytes: VmRSS, RssAnon, VmHWM ... as the kernel counts them."""
    with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
        return int(re.search(rf"{what}:\s*(\d+) kB", status.read())[1]) << 10


class Upload(EditTest):
    def files(self):
        return sorted(os.listdir(self.folder))

    def begin(self, editor, tag, size, part, kind="application/json"):
        """A connection that has sent the head of a save and a part of its body."""
        connection = socket.create_connection(("127.0.0.1", editor.port), timeout=HANG)
        self.addCleanup(connection.close)
        connection.sendall((f"PUT /document HTTP/1.1\r\nHost: {editor.host}\r\nX-Batten-Token: {editor.token}\r\nContent-Type: {kind}\r\n"
                            f"If-Match: {tag}\r\nContent-Length: {size}\r\n\r\n").encode() + part)
        return connection

    def beside(self, count):
        """Waits until so many files that are being written are beside the drawing."""
        until = time.monotonic() + HANG
        while len(list(self.folder.glob(".batten-*"))) != count:
            self.assertLess(time.monotonic(), until)
            time.sleep(0.01)

    @unittest.skipIf(SANITIZED, "the sanitizer keeps what is freed")
    @unittest.skipUnless(shutil.which("curl"), "curl is not installed")
    def test_100_mib_by_curl_with_little_memory(self):
        body = self.folder / "body.svg"
        body.write_bytes(svg(100 * MIB))
        self.assertGreater(body.stat().st_size, 99 * MIB)
        editor = self.start("d.svg", svg(100))
        before = memory(editor.process, "RssAnon")
        tag = editor.tag()
        done = subprocess.run(["curl", "-sS", "-o", self.folder / "answer", "-w", "%{http_code}", "-T", body, "-H", f"X-Batten-Token: {editor.token}",
                               "-H", f"Content-Type: {SVG}", "-H", f"If-Match: {tag}", f"http://{editor.host}/document"],
                              stdout=subprocess.PIPE, timeout=HANG, check=True)
        self.assertEqual(done.stdout, b"204", (self.folder / "answer").read_bytes())
        self.assertTrue(self.path.read_bytes() == body.read_bytes())
        self.assertLess(memory(editor.process, "RssAnon") - before, MIB)
        reader = subprocess.Popen([PROGRAM, "info", body], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, used = os.wait4(reader.pid, 0)
        reader.returncode = status
        self.assertEqual(status, 0)
        # Reading it once, as the check does, is all that takes memory.
        self.assertLess(memory(editor.process, "VmHWM"), 1.05 * (used.ru_maxrss << 10))

    @unittest.skipIf(SANITIZED, "the sanitizer keeps what is freed")
    def test_memory_does_not_grow_as_it_arrives(self):
        editor = self.start("d.svg", svg(100))
        old, tag = self.path.read_bytes(), editor.tag()
        body = svg(16 * MIB)
        editor.put(svg(MIB), tag, kind=SVG)
        self.path.write_bytes(old)
        before = memory(editor.process, "RssAnon")
        connection = self.begin(editor, tag, len(body), body[:-1], SVG)
        self.beside(1)
        while next(self.folder.glob(".batten-*")).stat().st_size < len(body) - 1:
            time.sleep(0.01)
        self.assertLess(memory(editor.process, "RssAnon") - before, MIB)
        self.assertEqual(self.path.read_bytes(), old)
        connection.sendall(body[-1:])
        self.assertIn(b" 204 ", connection.recv(4096))
        self.assertTrue(self.path.read_bytes() == body)
        self.beside(0)

    def test_killed_while_it_arrives(self):
        editor = self.start(content=drawing())
        body = drawing(2, 4000)
        self.begin(editor, editor.tag(), len(body), body[:-1])
        self.beside(1)
        editor.end(signal.SIGKILL)
        self.assertEqual(self.path.read_bytes(), drawing())
        editor = self.editor_on(self.path)  # the next start clears up
        self.beside(0)
        self.assertEqual(self.path.read_bytes(), drawing())

    def test_a_body_cut_short(self):
        editor = self.start(content=drawing())
        body, tag = drawing(2, 4000), editor.tag()
        for share in (0, 1, len(body) // 2, len(body) - 1):
            connection = self.begin(editor, tag, len(body), body[:share])
            self.beside(1)
            connection.close()
            self.beside(0)
            self.assertEqual((self.files(), self.path.read_bytes()), (["d.batten"], drawing()))
        self.assertEqual(editor.put(body, tag)[0], 204)
        self.assertEqual((self.files(), self.path.read_bytes()), (["d.batten"], body))

    def test_two_at_once(self):
        """Each has a file of its own; the first to be whole is saved, the other had another version before it."""
        editor = self.start(content=drawing())
        bodies, tag = [drawing(2, 400), drawing(3, 500)], editor.tag()
        connections = [self.begin(editor, tag, len(body), body[:-1]) for body in bodies]
        self.beside(2)
        for connection, body, status in zip(reversed(connections), reversed(bodies), (b" 204 ", b" 412 ")):
            connection.sendall(body[-1:])
            self.assertIn(status, connection.recv(4096))
        self.beside(0)
        self.assertEqual((self.files(), self.path.read_bytes()), (["d.batten"], bodies[1]))

    def test_a_disk_that_fills_up_meanwhile(self):
        """All of the body is taken before the answer, so that a page hears it."""
        editor = self.start(content=drawing())
        body, tag = drawing(2, 40000), editor.tag()
        for limit in (len(body) // 2, 1):
            connection = self.begin(editor, tag, len(body), body[:1000])
            if limit > 1:
                self.beside(1)
            resource.prlimit(editor.process.pid, resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY))
            connection.sendall(body[1000:])
            self.assertIn(b" 507 ", connection.recv(4096))
            connection.close()
            self.beside(0)
        self.assertEqual((self.files(), self.path.read_bytes()), (["d.batten"], drawing()))
        resource.prlimit(editor.process.pid, resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        self.assertEqual(editor.put(body, tag)[0], 204)

    @unittest.skipIf(os.geteuid() != 0, "as root")
    def test_a_file_of_others_and_one_with_two_names(self):
        """What cannot be exchanged is written over; nothing stays beside it."""
        editor = self.start(content=drawing())
        os.link(self.path, self.folder / "twin.batten")
        self.assertEqual(editor.put(drawing(2, 400))[0], 204)
        self.assertEqual(self.files(), ["d.batten", "twin.batten"])
        self.assertTrue(self.path.read_bytes() == (self.folder / "twin.batten").read_bytes() == drawing(2, 400))


if __name__ == "__main__":
    unittest.main()
