"""label: all (many servers at once). Two who save at once: several servers, or a server and another program. Whatever was saved and not seen by the other
is not lost. meddler.c acts as the other program, in the moment that matters."""
import fcntl
import os
import socket
import subprocess
import time
import unittest

from editor import EditTest, drawing
from program import CURVE, HANG, PROGRAM

PAIRS = 100


class Race(EditTest):
    def files(self):
        return sorted(os.listdir(self.folder))


class Servers(Race):
    def hurry(self, editors, tag, number):
        """One save to each editor over the same version, all sent but for the last byte, then that. The statuses."""
        lines = []
        for i, editor in enumerate(editors):
            body = drawing(number + i / 8)
            head = (f"PUT /document HTTP/1.1\r\nHost: {editor.host}\r\nX-Batten-Token: {editor.token}\r\n"
                    f"Content-Type: application/json\r\nIf-Match: {tag}\r\nContent-Length: {len(body)}\r\n\r\n")
            line = socket.create_connection(("127.0.0.1", editor.port), timeout=HANG)
            self.addCleanup(line.close)
            line.sendall(head.encode() + body[:-1])
            lines.append((line, body))
        for line, body in lines:
            line.sendall(body[-1:])
        statuses = [int(line.recv(4096).split()[1]) for line, _ in lines]
        winners = [body for status, (_, body) in zip(statuses, lines) if status == 204]
        self.assertEqual(sorted(statuses), [204] + [412] * (len(editors) - 1), f"round {number}")
        self.assertEqual(self.path.read_bytes(), winners[0])
        for line, _ in lines:
            line.close()

    def rounds(self, editors):
        for number in range(2, PAIRS + 2):
            self.hurry(editors, editors[number % len(editors)].tag(), number)
        self.assertEqual(self.files(), ["d.batten"])

    def test_pairs_on_one_server(self):
        editor = self.start(content=drawing())
        self.rounds([editor, editor])

    def test_pairs_on_two_servers(self):
        first = self.start(content=drawing())
        self.rounds([first, self.editor_on(self.path)])

    def test_four_servers(self):
        first = self.start(content=drawing())
        self.rounds([first] + [self.editor_on(self.path) for _ in range(3)])

    def test_pairs_on_a_file_that_is_not_there(self):
        first = self.start()
        second = self.editor_on(self.path)
        for number in range(2, PAIRS // 4):
            self.hurry([first, second], '"none"', number)
            self.path.unlink()

    def test_a_stranger_who_locks_the_folder_does_not_keep_the_user_from_saving(self):
        editor = self.start(content=drawing())
        folder = os.open(self.folder, os.O_RDONLY)
        self.addCleanup(os.close, folder)
        fcntl.flock(folder, fcntl.LOCK_EX)
        self.assertEqual(editor.put(drawing(2))[0], 204)

    def test_a_stranger_who_locks_a_file_with_two_names_does_not_either(self):
        editor = self.start(content=drawing())
        os.link(self.path, self.folder / "twin.batten")
        with open(self.path) as held:
            fcntl.flock(held, fcntl.LOCK_EX)
            self.assertEqual(editor.put(drawing(2))[0], 204)
        self.assertEqual((self.folder / "twin.batten").read_bytes(), drawing(2))


class WithMeddler(Race):
    def meddled(self, moments, content=drawing()):
        """A server whose moments are as meddler.c wants them: {"0": bytes, "1.gone": b""}."""
        meddler = self.folder / "meddler"
        meddler.mkdir()
        for name, what in moments.items():
            (meddler / name).write_bytes(what)
        (self.folder / "work").mkdir()
        environment = {"LD_PRELOAD": os.environ["BATTEN_MEDDLER"], "MEDDLER": str(meddler)}
        return self.start("work/d.batten", content, environment=environment)

    def left(self):
        return sorted(os.listdir(self.folder / "work"))


class Meddled(WithMeddler):
    """One save while something happens between its last look at the file and its end."""

    def test_nobody_else(self):
        editor = self.meddled({})
        self.assertEqual(editor.put(drawing(2))[0], 204)
        self.assertEqual((self.path.read_bytes(), self.left()), (drawing(2), ["d.batten"]))

    def test_another_program_saves_once_twice_thrice(self):
        others = [b"other", b"another", b"a third"]
        for count in (1, 2, 3):
            with self.subTest(count=count):
                editor = self.meddled({str(i): others[i] for i in range(count)})
                self.assertEqual(editor.put(drawing(2))[0], 412)
                self.assertEqual((self.path.read_bytes(), self.left()), (others[count - 1], ["d.batten"]))
                subprocess.run(["rm", "-r", self.folder / "work", self.folder / "meddler"], check=True)

    def test_another_program_removes_the_file(self):
        editor = self.meddled({"0.gone": b""})
        self.assertEqual(editor.put(drawing(2))[0], 412)
        self.assertEqual(self.left(), [])

    def test_another_program_saves_and_removes(self):
        editor = self.meddled({"0": b"other", "1.gone": b""})
        self.assertEqual(editor.put(drawing(2))[0], 412)
        self.assertEqual((self.path.read_bytes(), self.left()), (b"other", ["d.batten"]))

    def test_another_program_makes_the_new_file(self):
        editor = self.meddled({"0": b"other"}, None)
        self.assertEqual(editor.put(drawing(2))[0], 412)
        self.assertEqual((self.path.read_bytes(), self.left()), (b"other", ["d.batten"]))

    def test_file_system_that_cannot_exchange(self):
        editor = self.meddled({"0.refuse": b"", "2.refuse": b""})
        tag = editor.tag()
        self.assertEqual(editor.put(drawing(2), tag)[0], 204)
        self.assertEqual(editor.put(drawing(3), tag)[0], 412)
        self.assertEqual(editor.put(drawing(4))[0], 204)
        self.assertEqual((self.path.read_bytes(), self.left()), (drawing(4), ["d.batten"]))


class NewFiles(WithMeddler):
    """What has no version that could be exchanged: it is linked into its place, which nothing may have taken meanwhile."""

    def test_nobody_else(self):
        editor = self.meddled({}, None)
        self.assertEqual(editor.put(drawing(2))[0], 204)
        self.assertEqual((self.path.read_bytes(), self.left()), (drawing(2), ["d.batten"]))
        self.assertEqual(self.path.stat().st_nlink, 1)

    def test_file_system_without_links(self):
        editor = self.meddled({"0.nolinks": b""}, None)
        self.assertEqual(editor.put(drawing(2))[0], 204)
        self.assertEqual((self.path.read_bytes(), self.left()), (drawing(2), ["d.batten"]))

    def test_another_program_makes_it_where_there_are_no_links(self):
        editor = self.meddled({"0": b"other", "0.nolinks": b""}, None)
        self.assertEqual(editor.put(drawing(2))[0], 412)
        self.assertEqual((self.path.read_bytes(), self.left()), (b"other", ["d.batten"]))

    def test_link_that_fails(self):
        editor = self.meddled({"0.refuse": b""}, None)
        self.assertEqual(editor.put(drawing(2))[0], 500)
        self.assertEqual(self.left(), [])
        self.assertEqual(editor.put(drawing(2))[0], 204)

    def test_what_is_given_back_is_linked_or_moved(self):
        """Another program saves and removes: what it saved goes back, with or without links."""
        for how in ({}, {"2.nolinks": b""}):
            with self.subTest(how=how):
                editor = self.meddled({"0": b"other", "1.gone": b"", **how})
                self.assertEqual(editor.put(drawing(2))[0], 412)
                self.assertEqual((self.path.read_bytes(), self.left()), (b"other", ["d.batten"]))
                subprocess.run(["rm", "-r", self.folder / "work", self.folder / "meddler"], check=True)

    def test_a_copy_whose_name_is_taken_in_the_last_moment(self):
        editor = self.meddled({"0": b"other"})
        self.assertEqual(editor.post(drawing(2))[:2], (201, "d (copy 2).batten"))
        self.assertEqual((self.folder / "work" / "d (copy).batten").read_bytes(), b"other")
        self.assertEqual(self.left(), ["d (copy 2).batten", "d (copy).batten", "d.batten"])


class Leftovers(WithMeddler):
    """What a killed process leaves beside a file goes at the next start; nothing else does."""

    def killed(self):
        """The name of what a server leaves that is killed in the middle of a save."""
        editor = self.meddled({"0.kill": b""})
        with self.assertRaises(OSError):
            editor.put(drawing(2))
        editor.process.wait(HANG)
        left = [name for name in self.left() if name != "d.batten"]
        self.assertEqual(len(left), 1)
        return left[0]

    def test_what_a_kill_leaves_is_removed_at_the_next_start(self):
        self.assertTrue(self.killed().startswith(".batten-"))
        self.editor_on(self.path)
        self.assertEqual((self.path.read_bytes(), self.left()), (drawing(), ["d.batten"]))

    def test_by_a_link(self):
        self.killed()
        (self.folder / "link.batten").symlink_to("work/d.batten")
        self.editor_on(self.folder / "link.batten")
        self.assertEqual(self.left(), ["d.batten"])

    def test_nothing_else_is_removed(self):
        name = self.killed()
        work = self.folder / "work"
        (work / ".batten-backup").write_text("mine")
        (work / name[:-1]).write_text("mine")
        (work / (name + "0")).write_text("mine")
        (work / (name[:-1] + "z")).write_text("mine")
        (work / ".batten-00000000000000aa").mkdir()
        (work / ".batten-00000000000000bb").symlink_to("d.batten")
        os.mkfifo(work / ".batten-00000000000000cc")
        before = self.left()
        self.editor_on(self.path)
        self.assertEqual(self.left(), [other for other in before if other != name])

    def at_work(self, start):
        """Runs start() up to the moment of its replacement, starts a server beside it, and lets it go on."""
        start()
        meddler = self.folder / "meddler"
        limit = time.monotonic() + HANG
        while (meddler / "0.wait").exists() and time.monotonic() < limit:
            time.sleep(0.01)
        before = self.left()
        self.editor_on(self.folder / "work" / "other.batten")
        self.assertEqual(self.left(), before)
        self.assertEqual(len([name for name in before if name.startswith(".batten-")]), 1)
        (meddler / "0.go").touch()

    def test_those_of_a_live_server_stay(self):
        editor = self.meddled({"0.wait": b""})
        body, tag = drawing(2), editor.tag()
        line = socket.create_connection(("127.0.0.1", editor.port), timeout=HANG)
        self.addCleanup(line.close)
        self.at_work(lambda: line.sendall(
            f"PUT /document HTTP/1.1\r\nHost: {editor.host}\r\nX-Batten-Token: {editor.token}\r\nContent-Type: "
            f"application/json\r\nIf-Match: {tag}\r\nContent-Length: {len(body)}\r\n\r\n".encode() + body))
        self.assertEqual(line.recv(4096).split()[1], b"204")
        self.assertEqual((self.path.read_bytes(), self.left()), (body, ["d.batten"]))

    def test_those_of_a_live_command_stay(self):
        self.meddled({"0.wait": b""})
        out = self.folder / "work" / "out.svg"
        environment = {**os.environ, "LD_PRELOAD": os.environ["BATTEN_MEDDLER"], "MEDDLER": str(self.folder / "meddler")}
        command = []
        self.at_work(lambda: command.append(subprocess.Popen([PROGRAM, "convert", self.file("c.json", CURVE), out],
                                                             env=environment)))
        self.assertEqual(command[0].wait(HANG), 0)
        self.assertEqual(self.left(), ["d.batten", "out.svg"])


if __name__ == "__main__":
    unittest.main()
