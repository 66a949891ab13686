#!/usr/bin/env python3
"""Every source file that a comment or a page names exists, so that a moved or renamed file leaves no wrong name behind.

The test checks names with a folder: "core/pad/pad.h" anywhere, and in pages also `core/pad/pad.*` and `core/{a,b}.*`."""

import glob
import os
import re
import sys

ROOTS = ("", "src/", "tests/", "kernels/")
# (?<!...) excludes parts of a longer path, of a URL or of an include.
FILE = re.compile(r"(?<![\w/.<\"$}{-])((?:[a-z_]+/)+[a-z_0-9]+\.(?:h|cpp|cl))\b")
PATTERN = re.compile(r"`((?:src/)?(?:core|files|text|artwork|library|job|layers|recognition|package|checkpoint|result|render|products|comm|worker"
                     r"|master|terminal|run|plan|program|bench|cli|kernels)/[\w/{},*]+(?:\.\*)?)`")


def texts():
    """Pages, sources and scripts, except this test and the test of rooms, which use invented names."""
    made_up = ("tests/scripts/rooms_refusals_test.sh", "tests/scripts/named_files_test.py")
    for root in ("src", "include", "python", "examples", "tests", "kernels", "bench", "scripts", "slurm", "docs", "."):
        for folder, folders, files in os.walk(root):
            if root == ".":
                folders.clear()
            for file in files:
                path = os.path.normpath(os.path.join(folder, file))
                if path.endswith((".h", ".cpp", ".cl", ".sh", ".md")) and path not in made_up:
                    yield path


def alternatives(name):
    """Expands core/{a,b}.* to core/a.* and core/b.*."""
    found = re.search(r"\{([\w,]+)\}", name)
    if not found:
        return [name]
    return [name.replace(found.group(0), part) for part in found.group(1).split(",")]


def is_there(name):
    return any(glob.glob(root + name) or glob.glob(root + name + ".*") for root in ROOTS)


os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
missing = 0
looked_at = 0
for path in texts():
    looked_at += 1
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            names = FILE.findall(line)
            if path.endswith(".md"):
                names += [name for pattern in PATTERN.findall(line) for name in alternatives(pattern)]
            for name in names:
                if not is_there(name):
                    print(f"{path}:{number}: {name} is not there", file=sys.stderr)
                    missing += 1
if looked_at < 1000:
    sys.exit(f"looked at {looked_at} files alone: this is not the root of the project")
sys.exit(missing > 0)
