"""The editor's server: every refusal with its status, and saving that is atomic."""
import base64
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import resource
import signal
import socket
import stat
import subprocess
import time
import unittest
import urllib.parse

from editor import EditTest, drawing
from program import HANG, PROGRAM, ROOT

class Serving(EditTest):
    def test_a_file_has_its_own_port(self):
        first = self.start("own.batten", drawing())
        again = self.editor_on(self.path)
        self.assertNotEqual(again.port, first.port, "the port is taken: another")
        other = self.editor_on(self.folder / "other.batten")
        self.assertNotEqual(other.port, first.port)
        first.end()
        again.end()
        self.assertEqual(self.editor_on(self.path).port, first.port)
        self.assertEqual(self.editor_on(self.folder / "." / "other.batten", "--port", "0").get("/")[0], 200)

    def test_a_port_that_was_asked_for_may_be_kept(self):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        editor = self.start("d.batten", drawing(), "--port", str(port))
        self.assertEqual(editor.port, port)
        self.assertIn(b'name="batten-address" content="lasting"', editor.get("/")[2])
        self.assertIn(b'name="batten-address" content="passing"', self.start("e.batten", drawing()).get("/")[2])

    def test_address_shell_and_headers(self):
        editor = self.start(content=drawing())
        self.assertRegex(editor.address, r"^http://127\.0\.0\.1:\d+/$")
        self.assertRegex(editor.token, r"^[0-9a-f]{32}$")
        build = f"/{editor.build}"
        for path, kind in (("/", "text/html; charset=utf-8"), (f"{build}/main.js", "text/javascript; charset=utf-8"),
                           (f"{build}/styles/page.css", "text/css; charset=utf-8"), (f"{build}/batten.wasm", "application/wasm"),
                           ("/document", "application/json")):
            status, headers, body = editor.get(path)
            self.assertEqual((status, headers["Content-Type"]), (200, kind), path)
            self.assertTrue(body)
            self.assertIn("default-src 'none'; script-src 'self' 'wasm-unsafe-eval'", headers["Content-Security-Policy"])
            self.assertIn("frame-ancestors 'none'", headers["Content-Security-Policy"])
            self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
            self.assertEqual(headers["Cache-Control"], "no-store")
            self.assertEqual(headers["Referrer-Policy"], "no-referrer")
            self.assertEqual(headers["Cross-Origin-Opener-Policy"], "same-origin")
            self.assertEqual(headers["Cross-Origin-Resource-Policy"], "same-origin")
            self.assertIsNone(headers["Access-Control-Allow-Origin"])
        self.assertEqual(editor.get(f"{build}/batten.wasm")[2][:4], b"\0asm")
        self.assertEqual(editor.request("HEAD", "/")[::2], (200, b""))

    def test_files_of_one_build(self):
        editor = self.start(content=drawing())
        self.assertRegex(editor.build, r"^[0-9a-f]{16}$")
        for name in ("main.js", "keep/keeping.js", "icons/sprite.svg", "batten.wasm", "batten-later.wasm", "words.ko.json"):
            self.assertEqual(editor.get(f"/{editor.build}/{name}")[0], 200, name)
            for folder in ("", "/0123456789abcdef", f"/{editor.build}0"):
                self.assertEqual(editor.get(f"{folder}/{name}")[0], 404, "a page of another build gets none of these")
        # All that the page and its manifest name is there.
        for path in ("/", "/manifest.webmanifest"):
            named = re.findall(rb'(?:href|src)"?[=:] ?"([^".][^"]*)"', editor.get(path)[2])
            self.assertGreater(len(named), 3)
            for name in named:
                self.assertEqual(editor.get("/" + name.decode())[0], 200, name)

    def test_document_with_name_and_tag(self):
        editor = self.start("Ä b%.batten", drawing())
        status, headers, body = editor.get("/document")
        self.assertEqual((status, body), (200, drawing()))
        self.assertEqual(urllib.parse.unquote(headers["X-Batten-Name"]), "Ä b%.batten")
        self.assertTrue(headers["X-Batten-Name"].isascii())
        self.assertRegex(headers["ETag"], r'^"[^"]+"$')

    def test_name_that_is_no_utf8(self):
        editor = self.editor_on(os.fsencode(self.folder) + b"/a\xff\xc3.svg")
        self.assertEqual(urllib.parse.unquote(editor.get("/document")[1]["X-Batten-Name"], errors="strict"), r"a\xFF\xC3.svg")

    def test_tokens_are_fresh(self):
        self.assertNotEqual(self.start(content=drawing()).token, self.start(content=drawing()).token)

    def test_loopback_only(self):
        editor = self.start(content=drawing())
        listening = pathlib.Path("/proc/net/tcp").read_text() + pathlib.Path("/proc/net/tcp6").read_text()
        local = {line.split()[1].split(":")[0] for line in listening.splitlines()
                 if line.split()[1].endswith(f":{editor.port:04X}") and line.split()[3] == "0A"}
        self.assertEqual(local, {"0100007F"})

    def test_signals_end_it_cleanly(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            editor = self.start(content=drawing())
            self.assertEqual(editor.end(how)[0], 0)

    def test_port(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            port = taken.getsockname()[1]
            taken.listen()
            line = self.refused(1, "edit", self.file("d.batten", drawing()), "--no-open", "--port", port)
            self.assertIn(f"port {port}", line)
        self.assertEqual(self.start("d.batten", None, "--port", str(port)).port, port)

    def test_files_that_cannot_be_edited(self):
        self.assertIn("expected", self.refused(1, "edit", self.file("x.batten", "{"), "--no-open"))
        self.assertIn("line 1", self.refused(1, "edit", self.file("x.svg", "<svg"), "--no-open"))
        self.refused(1, "edit", self.folder / "nowhere" / "x.svg", "--no-open")
        (self.folder / "folder.svg").mkdir()
        self.refused(1, "edit", self.folder / "folder.svg", "--no-open")

    def test_opens_the_browser_only_with_a_display(self):
        asked = self.folder / "asked"
        opener = self.file("xdg-open", f"#!/bin/sh\necho \"$1\" > {asked}.new\nmv {asked}.new {asked}\n")
        os.chmod(opener, 0o755)
        name = self.file("d.batten", drawing())
        for display, opened in (("", False), (":9", True)):
            environment = {**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}", "DISPLAY": display,
                           "WAYLAND_DISPLAY": ""}
            with subprocess.Popen([PROGRAM, "edit", name], stdout=subprocess.PIPE, env=environment) as process:
                address = process.stdout.readline().decode().strip()
                limit = time.monotonic() + (HANG if opened else 0.3)  # that nothing happens takes time to see
                while not asked.exists() and time.monotonic() < limit:
                    time.sleep(0.01)
                process.terminate()
            self.assertEqual(asked.exists(), opened)
            if opened:
                self.assertEqual(asked.read_text().strip(), address)


class Refusals(EditTest):
    """What does not come from the editor's own page is refused, and the file stays as it is."""

    def setUp(self):
        super().setUp()
        self.editor = self.start(content=drawing())
        self.before = self.path.read_bytes(), self.path.stat().st_mtime_ns

    def tearDown(self):
        self.assertEqual((self.path.read_bytes(), self.path.stat().st_mtime_ns), self.before)
        self.assertEqual(os.listdir(self.folder), ["d.batten"])
        self.assertEqual(self.editor.get("/document")[0], 200)  # it still works

    def both(self, headers):
        """Statuses of the page, the document and a save with these headers."""
        return {self.editor.get("/", headers)[0], self.editor.get("/document", headers)[0],
                self.editor.put(drawing(5), headers=headers)[0]}

    def test_host(self):
        for host in ("evil.example", f"evil.example:{self.editor.port}", "127.0.0.1", "localhost", "127.0.0.1:1",
                     f"127.0.0.1.evil.example:{self.editor.port}", f"127.0.0.1:{self.editor.port}.", ""):
            with self.subTest(host=host):
                self.assertEqual(self.both({"Host": host}), {421})
        self.assertEqual(self.editor.get("/", {"Host": f"localhost:{self.editor.port}"})[0], 200)

    def test_duplicate_and_missing_host(self):
        good = f"Host: {self.editor.host}\n"
        self.assertEqual(self.editor.raw(f"GET / HTTP/1.1\n{good}\n"), 200)
        self.assertEqual(self.editor.raw(f"GET / HTTP/1.1\n{good}{good}\n"), 400)
        self.assertEqual(self.editor.raw(f"GET / HTTP/1.1\n{good}Host: evil.example\n\n"), 400)
        self.assertEqual(self.editor.raw(f"GET / HTTP/1.1\nhOsT: evil.example\n{good}\n"), 400)
        self.assertEqual(self.editor.raw("GET / HTTP/1.1\n\n"), 400)
        self.assertEqual(self.editor.raw("GET / HTTP/1.0\n\n"), 400)

    def test_nul_and_folded_lines(self):
        """Nothing stands in a request's head that the server does not see."""
        host = f"Host: {self.editor.host}".encode()
        for head in (b"GET / HTTP/1.1\r\n" + host + b"\0\r\n", b"GET / HTTP/1.1\r\n" + host + b"\0.evil.example\r\n",
                     b"GET / HTTP/1.1\r\nHost: \0" + self.editor.host.encode() + b"\r\n",
                     b"GET / HTTP/1.1\r\n" + host + b"\r\n .evil.example\r\n",
                     b"GET / HTTP/1.1\r\n" + host + b"\r\n\t\0evil\r\n",
                     b"GET / HTTP/1.1\r\n" + host + b"\r\nOrigin\0: http://evil.example\r\n",
                     b"GET / HTTP/1.1\r\n" + host + b"\r\nX: a\0b\r\n", b"GET / HTTP/1.1\r\nX:\r\n" + host + b"\0\r\n", b"GET /\0 HTTP/1.1\r\n" + host + b"\r\n",
                     b"GET\0 / HTTP/1.1\r\n" + host + b"\r\n", b"GET / HTTP/1.1\n" + host + b"\n"):
            with self.subTest(head=head):
                self.assertEqual(self.editor.raw(head + b"\r\n"), 400)
        for fields in (b"", b"Accept: */*\r\n", b"Empty: \r\n", b"Empty:\r\n", b"A:b\r\nC:  d\r\n", "Name: ä ü\r\n".encode()):  # as browsers write
            for path in (b"/", b"/?a=b&c", b"/sw.js?"):
                self.assertEqual(self.editor.raw(b"GET " + path + b" HTTP/1.1\r\n" + host + b"\r\n" + fields + b"\r\n"), 200)

    def test_origin(self):
        host = self.editor.host
        for origin in ("null", "http://evil.example", f"https://{host}", f"http://{host}/", f"http://{host}.evil.example",
                       "http://127.0.0.1", "http://127.0.0.1:1", f"http://localhost:{self.editor.port}", "", "file://"):
            with self.subTest(origin=origin):
                self.assertEqual(self.both({"Origin": origin}), {403})
        self.assertEqual(self.editor.get("/document", {"Origin": f"http://{host}"})[0], 200)

    def test_fetch_from_another_site(self):
        for site in ("cross-site", "same-site", "something"):
            self.assertEqual(self.both({"Sec-Fetch-Site": site}), {403})
        for site in ("same-origin", "none"):
            self.assertEqual(self.editor.get("/", {"Sec-Fetch-Site": site})[0], 200)

    def test_page_that_may_be_kept(self):
        kept = self.editor.get("/index.html")[2]
        self.assertIn(b'content="%TOKEN%"', kept)
        self.assertNotIn(self.editor.token.encode(), kept)
        page = self.editor.get("/")[2]
        self.assertEqual(page, kept.replace(b"%TOKEN%", self.editor.token.encode()).replace(b"%ADDRESS%", b"passing"))
        worker = self.editor.get("/sw.js")[2].decode()
        self.assertNotIn("%", re.sub(r"%TOKEN%", "", worker))
        files = re.search(r'"([^"]* index\.html:[^"]*)"|\'([^\']* index\.html:[^\']*)\'', worker)
        rows = dict(row.split(":") for row in (files[1] or files[2]).split())
        self.assertNotIn("sw.js", rows)
        for name, digest in rows.items():
            status, _, content = self.editor.get(f"/{name}")
            self.assertEqual((status, hashlib.sha256(content).hexdigest()), (200, digest), name)
        icons = f"/{self.editor.build}/icons"
        for path, kind in (("/manifest.webmanifest", "application/manifest+json"), (f"{icons}/app-192.png", "image/png"),
                           (f"{icons}/app.svg", "image/svg+xml"), ("/sw.js", "text/javascript; charset=utf-8")):
            self.assertEqual(self.editor.get(path)[1]["Content-Type"], kind)
        inline = re.findall(rb"<script>(.*?)</script>", page, re.DOTALL)
        self.assertEqual(len(inline), 1)
        digest = base64.b64encode(hashlib.sha256(inline[0]).digest()).decode()
        for part in ("manifest-src 'self'", "worker-src 'self'", f"script-src 'self' 'wasm-unsafe-eval' 'sha256-{digest}';"):
            self.assertIn(part, self.editor.get("/")[1]["Content-Security-Policy"])

    def test_token(self):
        right = self.editor.token
        for token in ("", "x", right[:-1], right + "0", right[::-1], right.upper() + " ", "%TOKEN%"):
            headers = {"X-Batten-Token": token}
            with self.subTest(token=token):
                self.assertEqual(self.editor.get("/document", headers)[0], 403)
                self.assertEqual(self.editor.put(drawing(5), '"x"', headers)[0], 403)
        self.assertEqual(self.editor.get("/document", token=False)[0], 403)
        twice = f"X-Batten-Token: {right}\n"
        self.assertEqual(self.editor.raw(f"GET /document HTTP/1.1\nHost: {self.editor.host}\n{twice}{twice}\n"), 400)

    def test_paths(self):
        for path in ("/nothing", "/document/", "/document.batten", "//", "/index.html/", "/../etc/passwd",
                     "/..%2f..%2fetc%2fpasswd", "/%2e%2e/%2e%2e/etc/passwd", f"/{self.editor.build}/icons/../main.js", "/d.batten",
                     f"/{self.editor.build}/main.js%00.png", "/module/print.c", "http://evil.example/", "*"):
            with self.subTest(path=path):
                self.assertIn(self.editor.raw(f"GET {path} HTTP/1.1\nHost: {self.editor.host}\n\n"), (400, 404))

    def test_methods(self):
        for method in ("DELETE", "OPTIONS", "PATCH", "TRACE", "BREW"):
            status, headers, _ = self.editor.request(method, "/document")
            self.assertEqual((status, headers["Allow"]), (405, "GET, HEAD, PUT, POST"))
            self.assertEqual(self.editor.request(method, "/")[0], 405)
        for method in ("PUT", "POST"):
            self.assertEqual(self.editor.request(method, "/", {"X-Batten-Token": self.editor.token}, b"x")[0], 405)

    def test_media_type(self):
        for kind in ("image/svg+xml", "text/plain", "application/jsonp", "", None):
            with self.subTest(kind=kind):
                self.assertEqual(self.editor.put(drawing(5), kind=kind)[0], 415)

    def test_body_too_large(self):
        head = (f"PUT /document HTTP/1.1\nHost: {self.editor.host}\nX-Batten-Token: {self.editor.token}\n"
                'Content-Type: application/json\nIf-Match: "x"\n')
        for length in ((256 << 20) + 1, 1 << 40, 1 << 62):
            self.assertEqual(self.editor.raw(f"{head}Content-Length: {length}\n\n"), 413)
        for length in ("-1", "1x", "99999999999999999999999999"):
            self.assertIn(self.editor.raw(f"{head}Content-Length: {length}\n\n"), (400, 413))
        self.assertIn(self.editor.raw(f"{head}Content-Length: 3\nContent-Length: 4\n\nabc"), (400,))
        self.assertEqual(self.editor.raw(f"{head}Transfer-Encoding: chunked\n\n1\nx\n0\n\n"), 411)
        self.assertIn(self.editor.raw(f"{head}\n"), (411,))

    def test_body_that_is_no_drawing(self):
        for body in (b"", b"{", b"null", b"<svg/>", drawing()[:-2], drawing().replace(b'"knots": [0, 0, 1, 1]', b'"knots": [1]'),
                     drawing() + b"x", b"\xff\xfe\0"):
            with self.subTest(body=body):
                status, _, text = self.editor.put(body)
                self.assertEqual(status, 422, text)
                self.assertTrue(text.startswith(b"Not a drawing: "))

    def test_tags(self):
        for tag in ('"x"', "x", "*", "W/" + self.editor.tag(), self.editor.tag()[1:-1], '"none"'):
            with self.subTest(tag=tag):
                self.assertEqual(self.editor.put(drawing(5), tag)[0], 412)
        self.assertEqual(self.editor.put(drawing(5), "", {"If-Match": None})[0], 428)

    def test_half_a_body_changes_nothing(self):
        head = (f"PUT /document HTTP/1.1\r\nHost: {self.editor.host}\r\nX-Batten-Token: {self.editor.token}\r\n"
                f"Content-Type: application/json\r\nIf-Match: {self.editor.tag()}\r\nContent-Length: 5000\r\n\r\n")
        with socket.create_connection(("127.0.0.1", self.editor.port)) as connection:
            connection.sendall(head.encode() + drawing(5))
        self.assertEqual(self.editor.get("/document")[2], drawing())
        until = time.monotonic() + HANG
        while len(os.listdir(self.folder)) > 1 and time.monotonic() < until:  # until the server has seen the end
            time.sleep(0.01)

    @unittest.skipUnless(os.geteuid() == 0, "only the superuser can act as somebody else")
    def test_other_users_of_the_machine(self):
        script = ("import http.client, os, sys; os.setgroups([]); os.setgid(65534); os.setuid(65534)\n"
                  f"c = http.client.HTTPConnection('127.0.0.1', {self.editor.port}); c.request('GET', '/')\n"
                  "print(c.getresponse().status)")
        result = subprocess.run(["/usr/bin/python3", "-c", script], capture_output=True, text=True, timeout=HANG)
        self.assertEqual(result.stdout, "")
        self.assertRegex(result.stderr, "RemoteDisconnected|ConnectionResetError|BrokenPipeError")

    def test_noise(self):
        for noise in (b"\0" * 100, b"GET\r\n\r\n", b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n", b"A" * 100000):
            with self.subTest(noise=noise[:20]), socket.create_connection(("127.0.0.1", self.editor.port)) as connection:
                connection.settimeout(0.3)  # the server may wait for more
                answer = b""
                try:
                    connection.sendall(noise + b"\r\n\r\n")
                    answer = connection.recv(4096)
                except OSError:
                    pass
                self.assertNotIn(b" 200 ", answer[:20])
                self.assertEqual(self.editor.get("/")[0], 200)


class Replaced(EditTest):
    """Something that is no regular file stands in the file's place: nobody waits for it."""

    def test_while_it_is_open(self):
        makers = {"pipe": lambda: os.mkfifo(self.path), "folder": self.mkdir, "socket": self.listen,
                  "device": lambda: self.path.symlink_to("/dev/zero"), "terminal": lambda: self.path.symlink_to("/dev/ptmx")}
        editor = self.start(content=drawing())
        tag = editor.tag()
        for name, make in makers.items():
            with self.subTest(name=name):
                self.path.unlink()
                make()
                for status, _, text in (editor.get("/document"), editor.put(drawing(2), tag)):
                    self.assertEqual((status, text), (409, b"In the file's place stands what is no regular file.\n"))
                self.path.rmdir() if name == "folder" else self.path.unlink()
                self.path.write_bytes(drawing())
                self.assertEqual(os.listdir(self.folder), ["d.batten"])
        self.assertEqual(editor.put(drawing(2), tag)[0], 204)

    def mkdir(self):
        self.path.mkdir()

    def listen(self):
        with socket.socket(socket.AF_UNIX) as listener:
            listener.bind(str(self.path))

    def test_at_the_start(self):
        os.mkfifo(self.folder / "pipe.svg")
        (self.folder / "zero.svg").symlink_to("/dev/zero")
        for name in ("pipe.svg", "zero.svg"):
            self.assertIn("not a regular file", self.refused(1, "edit", self.folder / name, "--no-open"))


class Beside(EditTest):
    """A new file beside the document: for whoever finds that another program has changed it."""

    def files(self):
        return sorted(os.listdir(self.folder))

    def test_a_copy_has_a_name_of_its_own(self):
        editor = self.start(content=drawing())
        self.assertEqual(editor.post(drawing(2))[:2], (201, "d (copy).batten"))
        self.assertEqual(editor.post(drawing(3))[:2], (201, "d (copy 2).batten"))
        self.assertEqual((self.folder / "d (copy).batten").read_bytes(), drawing(2))
        self.assertEqual((self.folder / "d (copy 2).batten").read_bytes(), drawing(3))
        self.assertEqual(self.path.read_bytes(), drawing())
        self.assertEqual(self.files(), ["d (copy 2).batten", "d (copy).batten", "d.batten"])

    def test_names(self):
        for name, copy in (("roof.svg", "roof (copy).svg"), ("a.b.svg", "a.b (copy).svg"), (".svg.svg", ".svg (copy).svg"),
                           ("\uc9c0\ubd95 (copy).svg", "\uc9c0\ubd95 (copy) (copy).svg")):
            with self.subTest(name=name):
                editor = self.start(name)
                body = editor.get("/document")[2]
                self.assertEqual(editor.post(body, kind="image/svg+xml")[:2], (201, copy))
                self.assertEqual((self.folder / copy).read_bytes(), body)
                editor.end()

    def test_nothing_is_written_over(self):
        editor = self.start(content=drawing())
        self.file("d (copy).batten", b"mine")
        (self.folder / "d (copy 2).batten").mkdir()
        (self.folder / "d (copy 3).batten").symlink_to("nowhere")
        (self.folder / "d (copy 4).batten").symlink_to("d.batten")
        os.mkfifo(self.folder / "d (copy 5).batten")
        self.file("d (copy 6).batten", b"mine")
        (self.folder / "d (copy 6).batten").chmod(0o444)
        before = self.files()
        self.assertEqual(editor.post(drawing(2))[:2], (201, "d (copy 7).batten"))
        self.assertEqual(self.files(), sorted([*before, "d (copy 7).batten"]))
        self.assertEqual((self.folder / "d (copy).batten").read_bytes(), b"mine")
        self.assertEqual(self.path.read_bytes(), drawing())

    def test_all_names_taken(self):
        editor = self.start(content=drawing())
        self.file("d (copy).batten", b"mine")
        for number in range(2, 100):
            self.file(f"d (copy {number}).batten", b"mine")
        before = self.files()
        status, _, text = editor.post(drawing(2))
        self.assertEqual((status, self.files()), (409, before))
        self.assertIn(b"too many copies", text)

    def test_a_name_without_room_for_more(self):
        editor = self.start("n" * 245 + ".batten", drawing())
        status, _, text = editor.post(drawing(2))
        self.assertEqual(status, 500)
        self.assertIn(b"too long", text)
        self.assertEqual(self.files(), [self.path.name])

    def test_beside_the_file_that_a_link_leads_to_and_with_its_mode(self):
        self.path = self.folder / "real" / "d.batten"
        self.path.parent.mkdir()
        self.path.write_bytes(drawing())
        self.path.chmod(0o600)
        (self.folder / "link.batten").symlink_to("real/d.batten")
        editor = self.editor_on(self.folder / "link.batten")
        self.assertEqual(editor.post(drawing(2))[:2], (201, "d (copy).batten"))
        self.assertEqual(stat.S_IMODE((self.path.parent / "d (copy).batten").stat().st_mode), 0o600)
        self.assertEqual(self.files(), ["link.batten", "real"])

    def test_a_read_only_file_has_copies_all_the_same(self):
        self.file("d.batten", drawing())
        (self.folder / "d.batten").chmod(0o444)
        editor = self.start()
        self.assertEqual(editor.post(drawing(2))[:2], (201, "d (copy).batten"))

    @unittest.skipIf(os.geteuid() == 0, "root writes into any folder")
    def test_a_read_only_folder(self):
        editor = self.start(content=drawing())
        self.folder.chmod(0o555)
        self.addCleanup(self.folder.chmod, 0o755)
        status, _, text = editor.post(drawing(2))
        self.assertEqual((status, self.files()), (409, ["d.batten"]))
        self.assertIn(b"read-only", text)

    def test_no_room_on_the_disk(self):
        editor = self.start(content=drawing())
        resource.prlimit(editor.process.pid, resource.RLIMIT_FSIZE, (100, 100))
        self.assertEqual(editor.post(drawing(2))[0], 507)
        self.assertEqual(editor.put(drawing(2))[0], 507)
        self.assertEqual((self.files(), self.path.read_bytes()), (["d.batten"], drawing()))

    def test_what_a_put_is_refused_for(self):
        editor = self.start(content=drawing())
        self.assertEqual(editor.post(b"{")[0], 422)
        self.assertEqual(editor.post(drawing(2), kind="image/svg+xml")[0], 415)
        self.assertEqual(editor.post(drawing(2), {"X-Batten-Token": "0" * 32})[0], 403)
        self.assertEqual(editor.post(drawing(2), {"Origin": "http://evil.example"})[0], 403)
        self.assertEqual(editor.post(drawing(2), {"Sec-Fetch-Site": "cross-site"})[0], 403)
        self.assertEqual(editor.post(drawing(2), {"Content-Length": str((256 << 20) + 1)})[0], 413)
        self.assertEqual(self.files(), ["d.batten"])


class Saving(EditTest):
    def test_saves_and_moves_the_tag(self):
        editor = self.start(content=drawing())
        first = editor.tag()
        status, headers, body = editor.put(drawing(2), first)
        self.assertEqual((status, body, self.path.read_bytes()), (204, b"", drawing(2)))
        self.assertNotEqual(headers["ETag"], first)
        self.assertEqual(headers["ETag"], editor.tag())
        self.assertEqual(editor.put(drawing(3), first)[0], 412)
        self.assertEqual(editor.put(drawing(3), headers["ETag"], {"Content-Type": "application/json; charset=utf-8"})[0], 204)
        self.assertEqual(os.listdir(self.folder), ["d.batten"])

    def test_file_that_changed_on_disk_is_not_touched(self):
        editor = self.start(content=drawing())
        tag = editor.tag()
        self.path.write_bytes(drawing(7))
        self.assertEqual(editor.put(drawing(2), tag)[0], 412)
        self.assertEqual(self.path.read_bytes(), drawing(7))
        self.path.unlink()
        self.assertEqual(editor.put(drawing(2), tag)[0], 412)
        self.assertFalse(self.path.exists())

    def test_touching_is_no_change(self):
        editor = self.start(content=drawing())
        tag = editor.tag()
        os.utime(self.path, (1, 1))
        self.assertEqual(editor.put(drawing(2), tag)[0], 204)

    def test_two_editors_on_one_file(self):
        first = self.start(content=drawing())
        second = self.editor_on(self.path)
        tag = second.tag()
        self.assertEqual(first.put(drawing(2), tag)[0], 204)
        self.assertEqual(second.put(drawing(3), tag)[0], 412)
        self.assertEqual(self.path.read_bytes(), drawing(2))

    def test_new_file(self):
        for name in ("new.batten", "new.svg"):
            editor = self.start(name)
            self.assertFalse(self.path.exists())
            status, headers, body = editor.get("/document")
            self.assertEqual((status, self.path.exists()), (200, False))
            kind = headers["Content-Type"]
            self.assertEqual(editor.put(body, headers["ETag"], kind=kind)[0], 204)
            self.assertEqual(self.path.read_bytes(), body)
            self.assertEqual(json.loads(self.done("info", self.path, "--json"))["objects"], [])
            self.assertIn("first save", editor.end()[2])

    def test_other_formats_are_saved_beside(self):
        """Whatever convert reads is opened as what convert makes of it; the file stays, and NAME.batten is saved."""
        bvh = ("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n"
               "End Site\n{\nOFFSET 0 9 0\n}\n}\nMOTION\nFrames: 2\nFrame Time: 0.1\n0 0 0\n9 8 7\n")
        obj = "v 0 0 0\nv 1 0 0\nv 0 1 2\nf 1 2 3\n"
        curve = '{"degree":1,"closed":false,"knots":[0,0,1,1],"points":[[0,0],[3,2]]}'
        for name, text in (("walk.bvh", bvh), ("a.b.obj", obj), ("curve.json", curve), ("odd", obj)):
            path = pathlib.Path(self.file(name, text))
            beside = path.parent / (name.rsplit(".", 1)[0] + ".batten")
            self.done("convert", path, "wanted.batten")
            editor = self.editor_on(path)
            status, headers, body = editor.get("/document")
            self.assertEqual((status, headers["X-Batten-Name"], beside.exists()), (200, beside.name, False))
            self.assertEqual(body, (self.folder / "wanted.batten").read_bytes())
            status, headers, _ = editor.put(body, headers["ETag"])
            self.assertEqual(status, 204)
            self.assertEqual((path.read_text(), beside.read_bytes()), (text, body))
            self.assertEqual(editor.get("/document")[2], body)
            said = editor.end()[2]
            self.assertIn("stays as it is", said)
            self.assertIn(beside.name, said)
            self.assertIn("edit that", self.refused(1, "edit", path, "--no-open"))
        self.assertIn("expected a whole GLB file", self.refused(1, "edit", self.file("x.glb", "glTF"), "--no-open"))

    def test_what_saving_over_it_loses(self):
        """Of a file that is not kept as it is, one line names all that would be lost, with one number."""
        path = self.folder / "old.svg"
        path.write_bytes('<?xml version="1.0" encoding="ISO-8859-1"?><svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><title>h\xe9</title>'
                         '<metadata><a/></metadata><text>a</text><text>b</text><path d="M0 0L9 9" stroke="red"/></svg>'.encode("latin-1"))
        said = self.editor_on(path).end()[2]
        found = re.search(r"saving over it loses (\d+) things; the editor asks first\. Left out: (.*)\.$", said, re.M)
        self.assertEqual(sum(map(int, re.findall(r"\d+", found[2]))), int(found[1]), said)
        self.assertEqual(said.count("old.svg: "), 1, said)

    def test_new_file_that_somebody_else_made_is_not_touched(self):
        editor = self.start("new.batten")
        tag = editor.tag()
        self.path.write_bytes(b"mine")
        self.assertEqual(editor.put(drawing(), tag)[0], 412)
        self.assertEqual(self.path.read_bytes(), b"mine")

    def test_mode_and_links_stay(self):
        self.path = self.folder / "real" / "d.batten"
        self.path.parent.mkdir()
        self.path.write_bytes(drawing())
        self.path.chmod(0o640)
        (self.folder / "link.batten").symlink_to("real/d.batten")
        (self.folder / "far.batten").symlink_to(self.folder / "link.batten")
        editor = self.editor_on(self.folder / "far.batten")
        self.assertEqual(editor.put(drawing(2))[0], 204)
        self.assertEqual(self.path.read_bytes(), drawing(2))
        self.assertEqual(stat.S_IMODE(self.path.stat().st_mode), 0o640)
        self.assertTrue((self.folder / "far.batten").is_symlink() and (self.folder / "link.batten").is_symlink())
        self.assertEqual(os.listdir(self.path.parent), ["d.batten"])

    def test_link_to_a_file_that_is_not_there_yet(self):
        (self.folder / "link.batten").symlink_to("real.batten")
        editor = self.editor_on(self.folder / "link.batten")
        self.assertEqual(editor.put(drawing(2))[0], 204)
        self.assertEqual((self.folder / "real.batten").read_bytes(), drawing(2))
        self.assertTrue((self.folder / "link.batten").is_symlink())

    def test_read_only_file(self):
        self.file("d.batten", drawing())
        (self.folder / "d.batten").chmod(0o444)
        editor = self.start()
        status, _, text = editor.put(drawing(2))
        self.assertEqual((status, self.path.read_bytes()), (409, drawing()))
        self.assertIn(b"read-only", text)
        self.assertIn("read-only", editor.end()[2])

    def test_svg(self):
        """A foreign SVG is saved as ours: it opens with every knot; the user was told what would be lost."""
        car = (ROOT / "examples" / "car.svg").read_bytes().replace(b">", b"><title>A car</title>", 1)
        editor = self.start("car.svg", car)
        status, headers, body = editor.get("/document")
        self.assertEqual((status, headers["Content-Type"], body), (200, "image/svg+xml", car))
        native = self.done("convert", self.path, "-", "--to", "batten")
        ours = self.done("convert", "-", "-", "--to", "svg", stdin=native)
        self.assertEqual(editor.put(ours, kind="application/json")[0], 415)
        self.assertEqual(editor.put(b"<svg", kind="image/svg+xml")[0], 422)
        self.assertEqual(editor.put(native, kind="image/svg+xml")[0], 422)
        self.assertEqual(self.path.read_bytes(), car)
        self.assertEqual(editor.put(ours, kind="image/svg+xml")[0], 204)
        self.assertEqual(self.path.read_bytes(), ours)
        self.assertEqual(self.done("convert", self.path, "-", "--to", "batten"), native)
        self.assertNotRegex(editor.end()[2], r"not shown")  # a title makes no picture

    def test_saves_at_once_do_not_mix(self):
        editor = self.start(content=drawing())
        tag = editor.tag()
        bodies = [drawing(x) for x in range(2, 10)]
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            answers = sorted(pool.map(lambda body: editor.put(body, tag)[0], bodies))
        self.assertEqual(answers, [204] + [412] * 7)
        self.assertIn(self.path.read_bytes(), bodies)


if __name__ == "__main__":
    unittest.main()
