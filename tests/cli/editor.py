"""A running `batten edit` for the tests: what it serves, by http.client and by raw sockets."""
import http.client
import json
import os
import re
import select
import signal
import socket
import subprocess
import urllib.parse

from program import HANG, PROGRAM, ProgramTest

STYLE = {"stroked": True, "stroke": "#000000ff", "width": 2, "cap": "round", "join": "round", "miter_limit": 4,
         "filled": False, "fill": "#000000ff", "even_odd": False, "opacity": 1}


def drawing(x=1.0, objects=1):
    """A native document that differs with x."""
    curve = {"degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [[0, 0], [x, 2]]}
    return json.dumps({"batten": 1, "page": [0, 0, 100, 50], "next": objects + 1, "objects": [
        {"id": i + 1, "kind": "path", "name": "", "style": STYLE, "curves": [curve]} for i in range(objects)]}).encode()


class Editor:
    """A running `batten edit`."""

    def __init__(self, path, *words, environment=None, program=PROGRAM, **how):
        self.process = subprocess.Popen([program, "edit", path, "--no-open", *words], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, env={**os.environ, **(environment or {})}, **how)
        ready, _, _ = select.select([self.process.stdout], [], [], HANG)
        self.address = self.process.stdout.readline().decode().strip() if ready else ""
        if not self.address:
            self.process.kill()
            raise AssertionError(self.process.communicate()[1].decode())
        self.port = urllib.parse.urlsplit(self.address).port
        self.host = f"127.0.0.1:{self.port}"
        page = self.get("/")[2]
        self.token = re.search(rb'name="batten-token" content="([^"]*)"', page)[1].decode()
        self.build = re.search(rb'<script type="module" src="([^"/]*)/main.js">', page)[1].decode()

    def request(self, method, path, headers=None, body=None, token=True):
        """Status, headers, body."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=HANG)
        headers = dict(headers or {})
        if token and path == "/document":
            headers.setdefault("X-Batten-Token", self.token)
        connection.request(method, path, body, headers)
        response = connection.getresponse()
        result = response.status, response.headers, response.read()
        connection.close()
        return result

    def get(self, path, headers=None, token=True):
        return self.request("GET", path, headers, None, token and path == "/document")

    def tag(self):
        return self.get("/document")[1]["ETag"]

    def put(self, body, tag=None, headers=None, kind="application/json"):
        headers = {"Content-Type": kind, "If-Match": tag or self.tag(), **(headers or {})}
        return self.request("PUT", "/document", {k: v for k, v in headers.items() if v is not None}, body)

    def post(self, body, headers=None, kind="application/json"):
        """A new file beside the document. Status, its name, what was said."""
        headers = {k: v for k, v in {"Content-Type": kind, **(headers or {})}.items() if v is not None}
        status, headers, text = self.request("POST", "/document", headers, body)
        return status, urllib.parse.unquote(headers["X-Batten-Name"] or ""), text

    def raw(self, text):
        """The status that a request written by hand is answered with; 0: the connection was closed."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=HANG) as connection:
            connection.sendall(text if isinstance(text, bytes) else text.replace("\n", "\r\n").encode())
            answer = b""
            while b"\r\n" not in answer:
                part = connection.recv(4096)
                if not part:
                    break
                answer += part
            return int(answer.split()[1]) if answer else 0

    def end(self, how=signal.SIGTERM):
        if self.process.stdout.closed:
            return None
        self.process.send_signal(how)
        output, errors = self.process.communicate(timeout=HANG)
        return self.process.returncode, output, errors.decode()


class EditTest(ProgramTest):
    def start(self, name="d.batten", content=None, *words, environment=None):
        self.path = self.folder / name
        if content is not None:
            self.path.write_bytes(content)
        return self.editor_on(self.path, *words, environment=environment)

    def editor_on(self, path, *words, **how):
        editor = Editor(path, *words, **how)
        self.addCleanup(editor.end, signal.SIGKILL)
        return editor
