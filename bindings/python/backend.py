"""Builds the wheel batten-core: libbatten, made by CMake in a folder of its own, and the Python files. Needs CMake, a program that it
drives (make or ninja) and a C compiler; no network. What is missing is said before anything is compiled. BATTEN_LIBRARY names a
shared library that has been built already.
"""
import base64
import hashlib
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
VERSION = re.search(r'BAT_VERSION "(.*)"', (ROOT / "include/batten/base.h").read_text("utf-8"))[1]
INFO = f"batten_core-{VERSION}.dist-info"
METADATA = f"""Metadata-Version: 2.1
Name: batten-core
Version: {VERSION}
Summary: B-spline curves that follow the pen: fit, sketch, levels, tangents
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
"""


def say(text):
    print(f"batten: {text}", flush=True)


def missing():
    """What compiling needs and is not here, with a way to get it."""
    tools = {"CMake": ([os.environ.get("CMAKE", "cmake")], "apt install cmake, brew install cmake, or pip install cmake")}
    if sys.platform != "win32":  # there, CMake finds Visual Studio by itself
        tools["C compiler"] = ([os.environ.get("CC", "cc").split()[0], "gcc", "clang"], "apt install gcc, or xcode-select --install")
        tools["make or ninja"] = (["make", "gmake", "ninja"], "apt install make")
    return [f"{what} ({how})" for what, (names, how) in tools.items() if not any(map(shutil.which, names))]


def prepared():
    """Says what is needed, before anything is compiled."""
    if os.environ.get("BATTEN_LIBRARY"):
        return
    if lacking := missing():
        sys.exit("batten is compiled from C when it is installed. This machine has no " + ", no ".join(lacking)
                 + ". Install what is missing and try again; or let BATTEN_LIBRARY name a libbatten that has been built.")


def get_requires_for_build_wheel(config_settings=None):
    prepared()
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Without this, pip would compile everything to learn the version."""
    folder = pathlib.Path(metadata_directory) / INFO
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "METADATA").write_text(METADATA, "utf-8")
    return INFO


def library(folder):
    """The shared library: as given, or built."""
    if given := os.environ.get("BATTEN_LIBRARY"):
        return pathlib.Path(given).resolve()
    prepared()
    cmake, jobs = os.environ.get("CMAKE", "cmake"), str(os.cpu_count() or 2)
    say("1 of 3: CMake looks at the compiler")
    subprocess.run([cmake, "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DBATTEN_PROGRAM=OFF", "-DBATTEN_SVG=OFF"], check=True)
    say(f"2 of 3: compiling the library with {jobs} jobs (a minute or more)")
    subprocess.run([cmake, "--build", folder, "--target", "batten_shared", "--parallel", jobs], check=True)
    say("3 of 3: packing")
    found = [*folder.glob("libbatten.so"), *folder.glob("libbatten*.dylib"), *folder.glob("**/batten*.dll")]
    return found[0].resolve()


def made(folder):
    """What is generated from the headers: the table of calls, the types."""
    subprocess.run([sys.executable, "-B", ROOT / "bindings/generate.py", ROOT, folder], check=True)
    spec = importlib.util.spec_from_file_location("stubs", HERE / "stubs.py")
    stubs = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(stubs)
    return {**{f"batten/{name}": (folder / name).read_bytes() for name in ("calls.json", "docs.json")},
            "batten/__init__.pyi": stubs.text(folder / "calls.json").encode()}


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        built = library(folder / "build")
        files = {f"batten/{path.name}": path.read_bytes() for path in sorted((HERE / "batten").glob("*.py"))}
        files |= made(folder / "made") | {"batten/py.typed": b"", f"batten/libbatten{'.' + built.name.split('.', 1)[1].split('.')[0]}": built.read_bytes()}
        tag = f"py3-none-{re.sub('[-.]', '_', sysconfig.get_platform())}"
        files |= {f"{INFO}/METADATA": METADATA.encode(), f"{INFO}/LICENSE": (ROOT / "LICENSE").read_bytes(),
                  f"{INFO}/WHEEL": f"Wheel-Version: 1.0\nGenerator: batten\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()}
        name = f"batten_core-{VERSION}-{tag}.whl"
        with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
            record = []
            for path, text in files.items():
                digest = base64.urlsafe_b64encode(hashlib.sha256(text).digest()).rstrip(b"=").decode()
                record.append(f"{path},sha256={digest},{len(text)}")
                put(wheel, path, text)
            put(wheel, f"{INFO}/RECORD", ("\n".join([*record, f"{INFO}/RECORD,,"]) + "\n").encode())
        return name


def put(wheel, path, text):
    """The same bytes whenever it is made."""
    entry = zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0))
    entry.external_attr, entry.compress_type = 0o644 << 16, zipfile.ZIP_DEFLATED
    wheel.writestr(entry, text)
