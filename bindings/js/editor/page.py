#!/usr/bin/env python3
"""Packs the editor's page for the element that has it inside: page.py WEB PAGE ESBUILD FOLDER OUT. WEB: the sources; PAGE: the page as files, of
which this takes all but the scripts; FOLDER: for what is made meanwhile. Scripts are one for the page and one for each worker. OUT: as
editor/inside.js unpacks it."""
import pathlib
import re
import shutil
import subprocess
import sys

TYPES = {".html": "text/html;charset=utf-8", ".js": "text/javascript;charset=utf-8", ".css": "text/css;charset=utf-8", ".svg": "image/svg+xml",
         ".json": "application/json", ".wasm": "application/wasm", ".woff2": "font/woff2", ".txt": "text/plain;charset=utf-8"}
WORKERS = ("stage/heavy_worker.js", "stage/small_worker.js", "keep/apart_worker.js")
# A file's address comes from a list: in a page it stands there, before a worker's script in that.
HERE = "export const addressOf = (name) => new URL(`../${name}`, here).href;"
LISTED = ("const listed = globalThis.battenAddresses ?? JSON.parse(document.getElementById('batten-addresses').textContent);\n"
          "export const addressOf = (name) => listed[name];")


def once(text, old, new):
    if text.count(old) != 1:
        sys.exit(f"page.py: {old!r} is there {text.count(old)} times")
    return text.replace(old, new)


def scripts(web, esbuild, folder):
    """The page's script and those of its workers, each with all that it imports."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(web, folder / "web", ignore=lambda _, names: [one for one in names if one in ("node_modules", "module", "site")])
    build = folder / "web/page/build.js"
    build.write_text(once(build.read_text("utf-8"), HERE, LISTED), "utf-8")
    named = [folder / "web" / name for name in ("main.js", *WORKERS)]
    subprocess.run([esbuild, *named, "--bundle", "--format=esm", "--minify", "--charset=utf8", "--legal-comments=none", "--log-level=error",
                    f"--outbase={folder / 'web'}", f"--outdir={folder / 'out'}"], check=True)
    return {name: (folder / "out" / name).read_bytes() for name in ("main.js", *WORKERS)}


def page(text, build):
    """index.html, with places for addresses, and the script that is a part of it: as a file, policies of the page around allow it."""
    [starting] = re.findall(r"<script>(.*?)</script>", text, re.S)
    text = text.replace(f"<script>{starting}</script>", '<script src="%page/starting.js%"></script>')
    text = re.sub(r" 'sha256-[^']*'", "", text)
    text = re.sub(r'\n *<link rel="modulepreload"[^>]*>', "", text)
    text = re.sub(rf'(href|src)="{build}/([^"]*)"', r'\1="%\2%"', text)
    text = re.sub(r"(script-src) 'self'", r"\1 blob:", text)
    text = re.sub(r"(style-src|font-src|connect-src) 'self'", r"\1 blob:", text)
    listed = '  <script type="application/json" id="batten-addresses">%ADDRESSES%</script>\n  </head>'
    return starting.encode(), once(text, "</head>", listed).encode()


def main(web, folder, esbuild, made, out):
    folder, made, out = map(pathlib.Path, (folder, made, out))
    [build] = [one.name for one in folder.iterdir() if one.is_dir()]
    files = scripts(pathlib.Path(web), esbuild, made)
    for one in sorted((folder / build).rglob("*")):
        if one.is_file() and one.suffix != ".js":
            files[one.relative_to(folder / build).as_posix()] = one.read_bytes()
    files["page/starting.js"], files["index.html"] = page((folder / "index.html").read_text("utf-8"), build)
    head = "\n".join(f"{name} {TYPES[pathlib.Path(name).suffix]} {len(data)}" for name, data in files.items())
    out.write_bytes(f"{head}\n\n".encode() + b"".join(files.values()))


if __name__ == "__main__":
    main(*sys.argv[1:])
