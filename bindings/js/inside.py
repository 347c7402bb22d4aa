#!/usr/bin/env python3
"""Writes a file as a module of JavaScript, so that a package needs no other kind of file: inside.py FILE OUT.js. Its default export is
the file, gzip in base64."""
import base64
import gzip
import pathlib
import sys

source, out = map(pathlib.Path, sys.argv[1:])
out.write_text(f"export default '{base64.b64encode(gzip.compress(source.read_bytes(), 9, mtime=0)).decode()}';\n")
