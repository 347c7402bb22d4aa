"""label: slow. What a save keeps of a file besides its content: owner, group, mode, attributes, names; and what is left when it breaks off.
The users and groups are numbers that no machine has; meddler.c acts as a file system that fails."""
import errno
import os
import re
import resource
import shutil
import stat
import struct
import subprocess
import tempfile
import threading
import time
import unittest

from editor import EditTest, drawing
from program import CURVE, HANG, PROGRAM

OWNER, MEMBER, STRANGER, GROUP = 61001, 61002, 61003, 65000
ACL = "system.posix_acl_access"
NOBODY = 0xffffffff
USER, GROUP_OF, MASK, OTHER = 2, 4, 16, 32
OLD = drawing(1, 300)
as_root = unittest.skipUnless(os.geteuid() == 0, "only the superuser can act as others")


def acl(*entries, owner=6, group=4, other=0, mask=6):
    """An access control list as the kernel keeps it. entries: users with their rights."""
    rows = [(1, owner, NOBODY), *((USER, rights, user) for user, rights in entries), (GROUP_OF, group, NOBODY),
            (MASK, mask, NOBODY), (OTHER, other, NOBODY)]
    return struct.pack("<I", 2) + b"".join(struct.pack("<HHI", *row) for row in rows)


def attributes(path):
    return {name: os.getxattr(path, name) for name in os.listxattr(path)}


def owners(path):
    about = os.stat(path)
    return about.st_uid, about.st_gid, stat.S_IMODE(about.st_mode)


class Saving(EditTest):
    @classmethod
    def setUpClass(cls):
        """The program and the meddler where every user can run them."""
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        os.chmod(folder.name, 0o755)
        cls.program, cls.meddler = (shutil.copy(name, folder.name) for name in (PROGRAM, os.environ["BATTEN_MEDDLER"]))

    def setUp(self):
        super().setUp()
        self.folder.chmod(0o755)
        self.source = self.file("c.json", CURVE)
        self.work = self.folder / "work"
        self.work.mkdir()
        self.work.chmod(0o777)
        self.path = self.work / "d.batten"
        self.path.write_bytes(OLD)
        self.new = self.done("convert", self.source, "-", "--to", "batten")

    def given(self, user, group, mode, path=None):
        os.chown(path or self.path, user, group)
        os.chmod(path or self.path, mode)

    def how(self, user=None, groups=(), orders=None):
        """How to run it as somebody, and in the company of the meddler with these orders."""
        how = {} if user is None else {"user": user, "group": user, "extra_groups": groups}
        if orders is not None:
            folder = self.folder / "orders"
            folder.mkdir(exist_ok=True)
            folder.chmod(0o777)
            for name in orders:
                (folder / name).touch()
            how["env"] = {**os.environ, "LD_PRELOAD": self.meddler, "MEDDLER": str(folder)}
        return how

    def save(self, *who, path=None, **how):
        """Status and what is said of a conversion to the file."""
        result = subprocess.run([self.program, "convert", self.source, path or self.path], capture_output=True, timeout=HANG,
                                text=True, **self.how(*who, **how))
        return result.returncode, result.stderr

    def saved(self, *who, **how):
        self.assertEqual(self.save(*who, **how), (0, ""))
        self.assertEqual(self.path.read_bytes(), self.new)
        self.assertEqual(self.left(), ["d.batten"])

    def refused_save(self, *who, **how):
        """What is said; the file is as it was, and nothing is left."""
        status, said = self.save(*who, **how)
        self.assertEqual((status, said.count("\n")), (1, 1), said)
        self.assertEqual((self.path.read_bytes(), self.left()), (OLD, ["d.batten"]))
        return said

    def left(self):
        return sorted(os.listdir(self.work))


@as_root
class Owners(Saving):
    def test_a_member_of_the_group(self):
        for folder in (0o777, 0o1777, 0o2777, 0o3777):
            for user, groups in ((MEMBER, [GROUP]), (OWNER, [GROUP]), (OWNER, []), (0, [])):
                with self.subTest(folder=oct(folder), user=user, groups=groups):
                    self.path.write_bytes(OLD)
                    self.given(0, 0, folder, self.work)
                    self.given(OWNER, GROUP, 0o660)
                    self.saved(user, groups)
                    self.assertEqual(owners(self.path), (OWNER, GROUP, 0o660))

    def test_by_the_server(self):
        self.given(OWNER, GROUP, 0o660)
        editor = self.editor_on(self.path, program=self.program, user=MEMBER, group=MEMBER, extra_groups=[GROUP])
        for x in (2, 3):
            self.assertEqual(editor.put(drawing(x))[0], 204)
            self.assertEqual((self.path.read_bytes(), owners(self.path)), (drawing(x), (OWNER, GROUP, 0o660)))
        self.assertEqual(self.left(), ["d.batten"])

    def test_a_copy_beside_is_for_no_others(self):
        copy = self.work / "d (copy).batten"
        for groups, group, mode, want in (([GROUP], GROUP, 0o660, 0o660), ([], MEMBER, 0o666, 0o666), ([], MEMBER, 0o664, 0o644),
                                          ([], MEMBER, 0o646, 0o646), ([], MEMBER, 0o606, 0o606)):
            with self.subTest(groups=groups, mode=oct(mode)):
                self.given(OWNER, GROUP, mode)
                editor = self.editor_on(self.path, program=self.program, user=MEMBER, group=MEMBER, extra_groups=groups)
                self.assertEqual(editor.post(drawing(2))[0], 201)
                self.assertEqual(owners(copy), (MEMBER, group, want))
                copy.unlink()

    def test_who_may_not_write(self):
        self.given(OWNER, GROUP, 0o640)
        self.assertIn("is read-only", self.refused_save(MEMBER, [GROUP]))
        self.given(OWNER, GROUP, 0o660)
        self.assertIn("is read-only", self.refused_save(STRANGER))
        self.given(0, 0, 0o755, self.work)
        self.assertIn("Permission denied", self.refused_save(MEMBER, [GROUP]))

    def test_a_file_that_may_be_written_but_not_read(self):
        self.given(OWNER, OWNER, 0o622)
        self.given(OWNER, OWNER, 0o222)
        self.saved(OWNER)
        self.assertEqual(owners(self.path), (OWNER, OWNER, 0o222))
        self.path.write_bytes(OLD)
        self.assertIn("Permission denied", self.refused_save(MEMBER))

    def test_who_starts_it_as_an_owner_gets_nothing_more(self):
        self.given(OWNER, GROUP, 0o6777)
        self.saved(OWNER, [GROUP])
        self.assertEqual(owners(self.path), (OWNER, GROUP, 0o777))

    def test_the_copy_that_is_left_is_the_groups_too(self):
        self.given(OWNER, GROUP, 0o660)
        self.assertEqual(self.save(MEMBER, [GROUP], orders=["half.kill"])[0], -9)
        self.assertEqual(owners(self.work / "d.batten.before-save"), (MEMBER, GROUP, 0o660))


class Attributes(Saving):
    def test_they_stay(self):
        want = {"user.origin": b"a\0b", "user.empty": b"", ACL: acl((STRANGER, 4))}
        for name, value in want.items():
            os.setxattr(self.path, name, value)
        file = os.stat(self.path).st_ino
        self.saved()
        self.assertEqual(attributes(self.path), want)
        self.assertNotEqual(os.stat(self.path).st_ino, file, "it was replaced")
        editor = self.editor_on(self.path)
        self.assertEqual((editor.put(drawing(2))[0], attributes(self.path)), (204, want))
        self.assertEqual(editor.post(drawing(3))[0], 201)
        self.assertEqual(attributes(self.work / "d (copy).batten"), want)

    def test_those_that_the_folder_gives_do_not_come(self):
        self.path.chmod(0o664)
        os.setxattr(self.work, "system.posix_acl_default", acl((STRANGER, 6)))
        self.saved()
        self.assertEqual((attributes(self.path), owners(self.path)[2]), ({}, 0o664))
        new = self.work / "new.batten"  # but they do to a new file, as to any
        self.assertEqual(self.save(path=new), (0, ""))
        touched = self.work / "touched"
        touched.write_bytes(b"")
        self.assertEqual((attributes(new), owners(new)), (attributes(touched), owners(touched)))

    def test_those_that_cannot_be_set(self):
        """The file is written in its place then, and keeps them."""
        os.setxattr(self.path, "user.origin", b"there")
        file = os.stat(self.path).st_ino
        self.saved(orders=["keepattributes"])
        self.assertEqual((attributes(self.path), os.stat(self.path).st_ino), ({"user.origin": b"there"}, file))

    def test_a_file_system_without_any(self):
        file = os.stat(self.path).st_ino
        self.saved(orders=["noattributes"])
        self.assertNotEqual(os.stat(self.path).st_ino, file)

    @as_root
    def test_of_others(self):
        """Only the superuser sees or sets some: they stay all the same."""
        os.setxattr(self.path, "trusted.note", b"1")
        os.setxattr(self.path, ACL, acl((MEMBER, 6), (STRANGER, 4), group=6))
        os.chown(self.path, OWNER, GROUP)
        before = attributes(self.path), owners(self.path)
        self.saved(0)
        self.assertEqual((attributes(self.path), owners(self.path)), before)
        self.path.write_bytes(OLD)
        self.saved(MEMBER)
        self.assertEqual((attributes(self.path), owners(self.path)), before)

    @as_root
    def test_rights_of_the_old_content_are_not_those_of_the_new(self):
        os.setxattr(self.path, "security.capability", struct.pack("<5I", 0x02000000, 1, 0, 0, 0))
        self.saved(0)
        self.assertEqual(attributes(self.path), {})


class Names(Saving):
    def setUp(self):
        super().setUp()
        self.twin = self.folder / "twin.batten"
        os.link(self.path, self.twin)

    def test_both_names_stay_one_file(self):
        self.saved()
        self.assertTrue(self.twin.samefile(self.path))
        editor = self.editor_on(self.path)
        for size in (1, 900, 2):
            self.assertEqual(editor.put(drawing(5, size))[0], 204)
            self.assertEqual((self.twin.read_bytes(), self.left()), (drawing(5, size), ["d.batten"]))

    def test_another_program_changed_it(self):
        editor = self.editor_on(self.path)
        tag = editor.tag()
        self.twin.write_bytes(drawing(7))
        self.assertEqual(editor.put(drawing(2), tag)[0], 412)
        self.assertEqual((self.twin.read_bytes(), self.left()), (drawing(7), ["d.batten"]))

    def test_by_a_symbolic_link(self):
        (self.folder / "link.batten").symlink_to("work/d.batten")
        self.saved(path=self.folder / "link.batten")
        self.assertTrue(self.twin.samefile(self.path))

    def test_long_names(self):
        """255 bytes, in letters of three: the copy's name is cut between two."""
        for name in ("곡" * 82 + "d.batten", "a" * 248 + ".batten"):
            self.path = self.work / name[-255:]
            self.path.write_bytes(OLD)
            twin = self.folder / ("t" + str(len(name)))
            os.link(self.path, twin)
            self.assertEqual(self.save(), (0, ""))
            self.assertEqual(twin.read_bytes(), self.new)
            self.assertEqual(self.save(orders=["half.kill"])[0], -9)
            copy, = (other for other in self.left() if other.endswith(".before-save"))
            self.assertTrue(name.startswith(copy.removesuffix(".before-save")))
            self.assertGreater(len(copy.encode()), 250)
            for path in (self.path, self.work / copy):
                path.unlink()

    def test_two_at_once(self):
        """Both end well, or one finds that it changed; the file is whole."""
        results = []
        threads = [threading.Thread(target=lambda: results.append(self.save())) for _ in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((results, self.path.read_bytes(), self.left()), ([(0, "")] * 6, self.new, ["d.batten"]))

    def test_servers_at_once(self):
        editors = [self.editor_on(self.path) for _ in range(3)]
        for number in range(2, 12):
            tag, results = editors[0].tag(), {}
            threads = [threading.Thread(target=lambda i=i, editor=editor: results.update(
                {i: editor.put(drawing(number + i / 8), tag)[0]})) for i, editor in enumerate(editors)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertEqual(sorted(results.values()), [204, 412, 412])
            winner, = (i for i, status in results.items() if status == 204)
            self.assertEqual(self.twin.read_bytes(), drawing(number + winner / 8))


class BrokenOff(Saving):
    """A file that is written in its place: what an error or a kill in the middle leaves."""

    def setUp(self):
        super().setUp()
        os.link(self.path, self.folder / "twin.batten")
        self.copy = self.work / "d.batten.before-save"
        self.large = drawing(9, 900)

    def put(self, body, *orders):
        how = self.how(orders=orders)
        return self.editor_on(self.path, environment=how["env"]).put(body)

    def test_no_room_beforehand(self):
        for body in (drawing(2), self.large):
            self.assertEqual(self.put(body, "noroom")[0], 507)
            self.assertEqual((self.path.read_bytes(), self.left()), (OLD, ["d.batten"]))

    def test_no_room_in_the_middle(self):
        for body in (drawing(2), self.large):
            self.assertEqual(self.put(body, "half.full", "full")[0], 507)
            self.assertEqual((self.path.read_bytes(), self.left()), (OLD, ["d.batten"]))

    def test_a_limit_of_size(self):
        for limit in (100, len(OLD) + 100):
            editor = self.editor_on(self.path)
            resource.prlimit(editor.process.pid, resource.RLIMIT_FSIZE, (limit, limit))
            self.assertEqual(editor.put(self.large)[0], 507)
            self.assertEqual((self.path.read_bytes(), self.left()), (OLD, ["d.batten"]))

    def test_no_room_to_undo_it(self):
        status, _, said = self.put(self.large, "half.full", "full", "full.again")
        self.assertEqual((status, self.left(), self.copy.read_bytes()), (500, ["d.batten", self.copy.name], OLD))
        self.assertIn(b"in part only. As it was before, it is beside it as d.batten.before-save", said)
        self.copy.unlink()
        self.path.write_bytes(OLD)
        status, said = self.save(orders=["half.full", "full", "full.again"])
        self.assertEqual((status, self.copy.read_bytes()), (1, OLD))
        self.assertIn("in part only; as it was before, it is beside it as d.batten.before-save", said)

    def kill(self):
        self.assertEqual(self.save(orders=["half.kill"])[0], -9)
        self.assertEqual(self.path.read_bytes(), self.new[:len(self.new) // 2] + OLD[len(self.new) // 2:])
        self.assertEqual(self.copy.read_bytes(), OLD)

    def test_a_kill_in_the_middle_is_told_by_whoever_comes_next(self):
        self.kill()
        self.path.write_bytes(self.path.read_bytes()[:len(self.new) // 2])  # half a new one and half an old one may happen to be readable
        told = "an earlier save of it broke off; as it was before, it is beside it as d.batten.before-save"
        for words in (["info", self.path], ["convert", self.path, "-", "--to", "svg"], ["edit", self.path, "--no-open"]):
            self.assertIn(told, self.run_program(*words).stderr.decode())
        status, said = self.save()
        self.assertEqual((status, said.count("\n")), (1, 1))
        self.assertRegex(said, "was not written: an earlier save of it broke off.*the copy is d.batten.before-save")
        self.assertEqual(self.copy.read_bytes(), OLD)
        self.path.write_bytes(OLD)
        editor = self.editor_on(self.path)
        status, _, said = editor.put(drawing(2))
        self.assertEqual((status, self.path.read_bytes()), (409, OLD))
        self.assertRegex(said, b"^An earlier save .*the copy is d.batten.before-save\n$")
        self.copy.unlink()  # the old one is chosen
        self.assertEqual(editor.put(drawing(2))[0], 204)
        self.assertNotIn("broke off", self.run_program("info", self.path).stderr.decode())

    def test_one_that_replaces_the_file_goes_on_and_says_it(self):
        self.kill()
        (self.folder / "twin.batten").unlink()
        status, said = self.save()
        self.assertEqual((status, self.path.read_bytes(), self.copy.read_bytes()), (0, self.new, OLD))
        self.assertIn("broke off", said)

    def test_a_kill_before_the_copy_is_whole_leaves_no_copy(self):
        """The copy gets its name when it is on disk."""
        self.assertEqual(self.save(orders=["0.kill"])[0], -9)
        self.assertEqual((self.path.read_bytes(), self.copy.exists(), len(self.left())), (OLD, False, 2))
        self.editor_on(self.path)
        self.assertEqual(self.left(), ["d.batten"])

    def test_what_another_program_does_meanwhile_counts(self):
        """After the copy was made, before a byte is changed."""
        other = drawing(8)
        twin = self.folder / "twin.batten"
        for does, want, kept in ((self.path.unlink, [], OLD),
                                 (lambda: os.replace(self.file("other", other), self.path), ["d.batten"], OLD),
                                 (lambda: self.path.write_bytes(other), ["d.batten"], other)):
            self.path.unlink(missing_ok=True)
            twin.unlink()
            self.path.write_bytes(OLD)
            os.link(self.path, twin)
            orders, results = self.folder / "orders", []
            thread = threading.Thread(target=lambda: results.append(self.save(orders=["0.wait"])))
            thread.start()
            while not any(name.startswith(".batten-") for name in self.left()) or (orders / "0.wait").exists():
                time.sleep(0.001)
            does()
            (orders / "0.go").touch()
            thread.join()
            (orders / "0.go").unlink()
            self.assertEqual((results[0][0], self.left(), twin.read_bytes()), (1, want, kept))
            self.assertIn("changed on disk", results[0][1])
            self.assertEqual([self.path.read_bytes() for name in want], [other for name in want])


class Order(Saving):
    """What is on disk when the next thing is done: a machine that stops at any moment has the old file, the new one or a copy."""

    def calls(self, path):
        self.how(orders=["log"])
        log = self.folder / "orders" / "log"
        log.write_text("")
        self.assertEqual(self.save(path=path, orders=[]), (0, ""))
        aside = re.search(r" (\.batten-[0-9a-f]{16})$", log.read_text(), re.M)[1]
        return log.read_text().replace(aside, "ASIDE").splitlines()

    def test_a_file_that_is_replaced(self):
        self.assertEqual(self.calls(self.path), ["fsync ASIDE", "rename d.batten", "unlink ASIDE", "fsync work"])

    def test_a_file_that_is_written_over(self):
        os.link(self.path, self.folder / "twin.batten")
        self.assertEqual(self.calls(self.path), [
            "fsync ASIDE", "link d.batten.before-save", "fsync work", "write d.batten", "fsync d.batten",
            "unlink d.batten.before-save", "fsync work", "unlink ASIDE", "fsync work"])


class Devices(Saving):
    """What is no regular file is written to directly."""

    def test_a_pipe_with_a_name(self):
        fifo = self.work / "fifo.batten"
        os.mkfifo(fifo)
        reader = subprocess.Popen(["cat", fifo], stdout=subprocess.PIPE)
        self.assertEqual(self.save(path=fifo), (0, ""))
        self.assertEqual(reader.communicate(timeout=HANG)[0], self.new)
        self.assertTrue(stat.S_ISFIFO(fifo.stat().st_mode))

    def test_devices(self):
        (self.work / "null.batten").symlink_to("/dev/null")
        (self.work / "full.batten").symlink_to("/dev/full")
        self.assertEqual(self.save(path=self.work / "null.batten"), (0, ""))
        status, said = self.save(path=self.work / "full.batten")
        self.assertEqual((status, os.strerror(errno.ENOSPC) in said), (1, True))
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_the_standard_output_by_its_path(self):
        words = [self.program, "convert", self.source, "/dev/stdout", "--to", "batten"]
        self.assertEqual(subprocess.run(words, stdout=subprocess.PIPE, check=True, timeout=HANG).stdout, self.new)


class Moved(Saving):
    """The folder is renamed, or another put in its place, while the file is open."""

    def asked(self, editor, tag):
        """What a look, a save and a copy beside are answered with: all the same."""
        answers = {(status, text) for status, _, text in (editor.get("/document"), editor.put(drawing(2), tag),
                                                          editor.post(drawing(2)))}
        self.assertEqual(len(answers), 1, answers)
        return answers.pop()

    def test_renamed_replaced_removed_and_back(self):
        (self.folder / "link").symlink_to("work")
        for way in (self.path, self.folder / "link" / "d.batten"):
            editor = self.editor_on(way)
            tag, away = editor.tag(), self.folder / "away"
            self.work.rename(away)
            where = (409, f"The folder was moved; nothing is saved here any more. The file may now be in {away}\n".encode())
            self.assertEqual(self.asked(editor, tag), where)
            self.work.mkdir()
            (self.work / "d.batten").write_bytes(OLD)  # the same content, elsewhere
            self.assertEqual(self.asked(editor, tag), where)
            self.assertEqual((os.listdir(self.work), os.listdir(away)), (["d.batten"], ["d.batten"]))
            self.assertEqual(((self.work / "d.batten").read_bytes(), (away / "d.batten").read_bytes()), (OLD, OLD))
            shutil.rmtree(self.work)
            away.rename(self.work)
            self.assertEqual(editor.put(OLD, tag)[0], 204)

    def test_removed(self):
        editor = self.editor_on(self.path)
        tag = editor.tag()
        shutil.rmtree(self.work)
        self.assertEqual(self.asked(editor, tag), (409, b"The folder was moved; nothing is saved here any more.\n"))

    def test_by_a_relative_name(self):
        editor = self.editor_on("d.batten", cwd=self.work)
        tag = editor.tag()
        self.work.rename(self.folder / "away")
        self.assertEqual(self.asked(editor, tag)[0], 409)

    def test_one_above_it(self):
        deep = self.work / "a" / "b"
        deep.mkdir(parents=True)
        (deep / "d.batten").write_bytes(OLD)
        editor = self.editor_on(deep / "d.batten")
        tag = editor.tag()
        (self.work / "a").rename(self.work / "c")
        self.assertIn(b"may now be in " + bytes(self.work / "c" / "b"), self.asked(editor, tag)[1])

    def test_another_folder_in_a_links_place_is_another_file(self):
        other = self.folder / "other"
        other.mkdir()
        (other / "d.batten").write_bytes(drawing(3))
        link = self.folder / "link"
        link.symlink_to("work")
        editor = self.editor_on(link / "d.batten")
        tag = editor.tag()
        link.unlink()
        link.symlink_to("other")
        self.assertEqual(editor.put(drawing(2), tag)[0], 412)
        self.assertEqual((other / "d.batten").read_bytes(), drawing(3))


if __name__ == "__main__":
    unittest.main()
