#!/usr/bin/env python3
# label: slow
"""What is not edited is painted by librsvg: texts and filters as rsvg-convert shows them; a hostile file fetches nothing, reads
no other file, and is kept as it is."""
import http.server
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
import unittest
import zlib

from program import PROGRAM, ROOT, ProgramTest

sys.path.insert(0, str(ROOT / "tests" / "pictures"))
from compare import SHARE, compare  # noqa: E402

OPEN = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 100 100">'
RED = '<rect x="20" y="20" width="60" height="60" fill="#f00"/>'
MASK = '<mask id="m"><circle cx="50" cy="50" r="30" fill="#fff"/></mask>'
BOXED, NAMED = '<mask maskContentUnits="userSpaceOnUse" x="0" y="0" width=".5" height="1"', '<rect id="r"'
FILES = {
    "text": '<text x="5" y="50" font-size="20">Batten</text>',
    "text in the middle": '<text x="50" y="50" font-size="20" text-anchor="middle">Batten</text>',
    "text at its end": '<style>text{text-anchor:end;font:italic 18px serif}</style><text x="95" y="50">Batten</text>',
    "text in parts": '<text y="30" font-size="12"><tspan x="5">one</tspan><tspan x="5" dy="20">two</tspan> three</text>',
    "text, turned": '<g transform="rotate(-40 50 50)"><text x="5" y="50" font-size="24" fill="#246">Batten</text></g>',
    "text with a gradient": '<linearGradient id="g"><stop stop-color="red"/><stop offset="1" stop-color="blue"/></linearGradient>'
                            '<g fill="url(#g)"><text x="5" y="60" font-size="28">Batten</text></g>',
    "order": f'<text x="5" y="55" font-size="40">AB</text>{RED}<text x="30" y="65" font-size="40">CD</text>',
    "blur": f'<filter id="f"><feGaussianBlur stdDeviation="6"/></filter><g filter="url(#f)">{RED}</g>',
    "shadow": '<filter id="f" x="-.3" y="-.3" width="1.8" height="1.8"><feOffset dx="9" dy="9"/><feGaussianBlur stdDeviation="3"/>'
              f'</filter><g style="filter:url(#f)">{RED}</g>{RED.replace("f00", "fb0")}',
    "mask": '<mask id="m"><circle cx="50" cy="50" r="30" fill="#fff"/></mask><g mask="url(#m)">' + RED + '</g>',
    "mask of a copy": f'{MASK}<g id="r">{RED}</g><use xlink:href="#r" x="9" mask="url(#m)"/>',
    "mask of a copy, by a box": f'{MASK.replace("<mask", BOXED)}<defs>{RED.replace("<rect", NAMED)}</defs><use xlink:href="#r" mask="url(#m)"/>',
    "mask of a text": f'{MASK}<text x="5" y="60" font-size="28" mask="url(#m)">Batten</text>',
    "mask of a drawing": f'{MASK}<svg x="10" y="10" width="70" height="70" viewBox="0 0 100 100" mask="url(#m)">{RED}</svg>',
    "mask of a switch": f'{MASK}<switch mask="url(#m)"><g systemLanguage="xx"/>{RED}</switch>',
    "copy of what is masked": f'{MASK}<g id="r"><g mask="url(#m)">{RED}</g></g><use xlink:href="#r" x="15"/>',
    "pattern": '<pattern id="p" width="12" height="12" patternUnits="userSpaceOnUse"><circle cx="6" cy="6" r="4" fill="#0a5"/>'
               '</pattern><path d="M5 5H95L50 95Z" fill="url(#p)" stroke="#246" stroke-width="4"/>',
    "pattern on a stroke": '<pattern id="p" width="6" height="6" patternUnits="userSpaceOnUse"><path d="M0 0H3V6H0Z"/></pattern>'
                           '<circle cx="50" cy="50" r="35" fill="#fd0" stroke="url(#p)" stroke-width="14"/>',
    "in layers": '<g transform="scale(.5)" opacity=".5"><g font-size="40" font-family="serif"><text x="20" y="120">Batten</text>'
                 '</g></g>',
}


@unittest.skipUnless(shutil.which("rsvg-convert"), "rsvg-convert is not installed")
class Foreign(ProgramTest):
    def test_as_librsvg_shows_it(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, content in FILES.items():
                path = pathlib.Path(folder) / "drawn.svg"
                path.write_text(f"{OPEN}{content}</svg>", encoding="utf-8")
                share = compare(PROGRAM, path)
                self.assertIsNotNone(share, name)
                self.assertLessEqual(share, SHARE, name)
                saved = pathlib.Path(folder) / "saved.svg"
                subprocess.run([PROGRAM, "convert", str(path), str(saved)], check=True, capture_output=True)
                self.assertIn(content, saved.read_text(encoding="utf-8"), name)

    def test_a_hostile_file_fetches_and_runs_nothing(self):
        asked = []

        class Listener(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                asked.append(self.path)
                self.send_error(404)

            def log_message(self, *_):
                pass

        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Listener)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_port}"
        with tempfile.TemporaryDirectory() as folder:
            secret, path, made = (pathlib.Path(folder) / name for name in ("secret.png", "hostile.svg", "hostile.png"))
            row = b"\0" + b"\xff\0\0" * 4
            chunk = lambda name, data: struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
            secret.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 4, 4, 8, 2, 0, 0, 0)) +
                               chunk(b"IDAT", zlib.compress(row * 4)) + chunk(b"IEND", b""))
            text = (f'{OPEN}<style>@import url({address}/style); text{{fill:url({address}/fill#a)}}</style><filter id="f" width="1" '
                    f'height="1"><feImage xlink:href="file://{secret}" width="100" height="100"/></filter><g filter="url(#f)" onclick='
                    f'"x()"><rect width="90" height="90"/><image width="90" height="90" xlink:href="{address}/image"/><image width="90" '
                    f'height="90" xlink:href="file://{secret}"/><image width="90" height="90" xlink:href="secret.png"/></g><script '
                    f'xlink:href="{address}/script">x()</script><mask id="m"><image width="90" height="90" xlink:href="{address}/mask"/><image '
                    f'width="90" height="90" xlink:href="file://{secret}"/></mask><rect width="9" height="9" fill="red" '
                    f'mask="url(#m)"/><text y="20" font-size="9">a<tref xlink:href="file:///etc/passwd#a"/>'
                    f'<xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="file:///etc/passwd" parse="text"/></text></svg>')
            path.write_text(text, encoding="utf-8")
            for name in ("hostile.png", "hostile.pdf"):
                subprocess.run([PROGRAM, "render", str(path), str(pathlib.Path(folder) / name)], check=True, capture_output=True, timeout=60)
            from test_render import pixels
            seen = pixels(made.read_bytes())
            self.assertFalse(((seen[:, :, 0] > 200) & (seen[:, :, 1] < 60)).any(), "the red picture of another file is seen")
            saved = pathlib.Path(folder) / "saved.svg"
            subprocess.run([PROGRAM, "convert", str(path), str(saved)], check=True, capture_output=True)
            self.assertEqual(saved.read_text(encoding="utf-8"), text)
        server.shutdown()
        server.server_close()
        self.assertEqual(asked, [])


if __name__ == "__main__":
    unittest.main()
