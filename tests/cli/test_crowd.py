"""label: all (hundreds of connections). More connections than the editor's server has places for."""
import concurrent.futures
import http.client
import socket
import unittest

from editor import EditTest, drawing
from program import HANG


class Crowd(EditTest):
    """Others who connect, however many, do not keep the user out: nobody has to wait for their time to be up."""

    def crowd(self, editor, count, said=b""):
        lines = []
        for _ in range(count):
            line = socket.create_connection(("127.0.0.1", editor.port), timeout=HANG)
            self.addCleanup(line.close)
            line.sendall(said)
            lines.append(line)
        return lines

    def still_open(self, line):
        line.setblocking(False)
        try:
            return bool(line.recv(1))
        except BlockingIOError:
            return True
        except ConnectionResetError:
            return False

    def test_idle_connections(self):
        editor = self.start(content=drawing())
        for said in (b"", b"GET", b"GET / HTTP/1.1\r\nX: "):
            with self.subTest(said=said):
                lines = self.crowd(editor, 200, said)
                self.assertEqual(editor.get("/")[0], 200)
                self.assertTrue(self.still_open(lines[-1]))  # so it was not their time that was up
                self.assertEqual(editor.put(drawing(2), editor.tag())[0], 204)

    def test_whoever_has_shown_the_token_stays(self):
        editor = self.start(content=drawing())
        mine = http.client.HTTPConnection("127.0.0.1", editor.port, timeout=HANG)
        self.addCleanup(mine.close)
        for _ in range(2):
            mine.request("GET", "/document", headers={"X-Batten-Token": editor.token})
            self.assertEqual(mine.getresponse().read(), drawing())
            socket_then = mine.sock
            self.crowd(editor, 200)
            self.assertEqual(editor.get("/")[0], 200)
        self.assertIs(mine.sock, socket_then)  # one connection all the time
        self.assertTrue(self.still_open(mine.sock))

    def test_a_silent_stranger_is_not_kept(self):
        editor = self.start(content=drawing())
        for line in self.crowd(editor, 1) + self.crowd(editor, 1, b"GET / HTTP/1.1\r\n"):
            self.assertNotIn(b" 200 ", line.recv(4096))  # its time is up, or there would be nothing to read

    def test_visitors_that_wait_for_their_answers(self):
        """More requests at once than places: those who are shown out come again, and all are served."""
        editor = self.start(content=drawing())
        with concurrent.futures.ThreadPoolExecutor(16) as pool:
            self.assertEqual(set(pool.map(lambda _: editor.get("/document")[0], range(200))), {200})


if __name__ == "__main__":
    unittest.main()
