"""The files that a check reads: found in the tree, and compared with those that git tracks, so that no check silently
reads nothing when folders move."""
import os
import pathlib
import subprocess
import sys


def sources(root, folders, suffixes):
    """Sorted paths under root's folders with one of the suffixes. Ends the program if git lists a different set."""
    root = pathlib.Path(root)
    walked = set()
    for folder in folders:
        for place, below, names in os.walk(root / folder):
            below[:] = [name for name in below if name not in ("node_modules", "build")]
            walked |= {pathlib.Path(place) / name for name in names if name.endswith(suffixes)}
    told = subprocess.run(["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--",
                           *folders], capture_output=True, text=True, check=True).stdout.split("\0")
    tracked = {root / name for name in told if name.endswith(suffixes) and (root / name).exists()}
    for path in sorted(walked ^ tracked):
        print(f"{path.relative_to(root)}: {'not known to git' if path in walked else 'not read'}")
    if walked != tracked or not walked:
        print(f"{len(walked)} files read, {len(tracked)} known to git")
        sys.exit(1)
    return sorted(walked)
