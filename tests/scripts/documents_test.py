#!/usr/bin/env python3
"""documents_test.py TESSERA: everything that pages name exists: the targets of their links, the commands and options of their
examples, and the keys of a job. README.md must be short."""

import functools
import glob
import os
import re
import subprocess
import sys

MOST_LINES_OF_README = 150
PAGES = ("*.md", "docs/*.md", "docs/*/*.md", "slurm/*.md", "jobs/*/*.md")
LINK = re.compile(r"\]\(([^)\s]+)\)")
KEY = re.compile(r"^([a-z_]+\.[a-z_]+)(?:$| = )")
FILE_ENDINGS = ("png", "svg", "h5", "json", "toml", "txt", "geojson", "log", "csv", "html", "pdf", "dxf", "md", "sh", "sbatch", "tif",
                "tiff", "cpp", "cl", "h", "previous", "lock")


def anchors_of(text):
    """The anchors that forges make from the headings."""
    found = set()
    for heading in re.findall(r"^#+ +(.+)$", text, re.M):
        heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        found.add(re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-"))
    return found


@functools.cache
def help_of(program, *words):
    run = subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=False)
    return run.stdout if run.returncode == 0 else None


def command_faults(program, line):
    """The faults in each command `tessera WORD [WORD] ... --option ...` of the line."""
    for part in re.split(r"&&|\|\||;", line.split(" # ")[0].split("   #")[0]):
        words = part.split()
        if "tessera" not in words:
            continue
        words = words[words.index("tessera") + 1:]
        names = [word for word in words[:2] if re.fullmatch(r"[a-z0-9]+", word)]
        if not names or words[0].startswith("-"):
            continue
        if names[0] == "bench":
            program_of, names = program + "-bench", names[1:]
            if not os.path.exists(program_of):
                continue
        else:
            program_of = program
        text = help_of(program_of, *names) or help_of(program_of, *names[:1])
        if text is None:
            yield f"no such command: tessera {' '.join(names)}"
            continue
        for option in re.findall(r"(?<=\s)(--[a-z][a-z0-9-]*|-[a-z])(?=[\s=]|$)", " " + " ".join(words)):
            if not re.search(re.escape(option) + r"(?![\w-])", text):
                yield f"tessera {' '.join(names)} has no {option}"


def faults_of(page, program, keys):
    with open(page, encoding="utf-8") as file:
        text = file.read()
    plain = re.sub(r"^```.*?^```$|^    .*$|`[^`\n]*`", "", text, flags=re.M | re.S)
    for target in LINK.findall(plain):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        there = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        if not os.path.exists(there):
            yield f"the link {target} leads nowhere"
        elif anchor and there.endswith(".md"):
            with open(there, encoding="utf-8") as file:
                if anchor not in anchors_of(file.read()):
                    yield f"the link {target}: no such heading"
    if page.startswith("docs/concepts/") and not re.search(r"^!\[.+\]\(.+\)$", text, re.M):
        yield "a page of the concepts without a figure"
    if not page.startswith(("README", "docs/guide", "docs/reference")):
        return
    for block in re.findall(r"^```\n(.*?)^```$", text, re.M | re.S):
        for line in block.replace("\\\n", " ").split("\n"):
            yield from command_faults(program, line)
    for word in re.findall(r"`([^`\n]+)`", text):
        key = KEY.match(word)
        if not key or key[1].endswith(tuple("." + ending for ending in FILE_ENDINGS)):
            continue
        if key[1] not in keys and re.sub("_mm$", "_px", key[1]) not in keys:  # lengths have a second key in mm
            yield f"no job has the key {key[1]}"


def keys_of_jobs():
    """The keys of a job, from docs/job-format.md. Another test compares that page with the program's table of keys."""
    with open("docs/job-format.md", encoding="utf-8") as file:
        text = file.read()
    keys = set(re.findall(r"`([a-z_]+\.[a-z_0-9]+)", text))
    section = ""
    for line in text.split("\n"):
        heading = re.match(r"^#+ .*?\[?\[?([a-z_]+)\]", line)
        if heading:
            section = heading[1]
        row = re.match(r"^\| `([a-z_]+)`", line)
        if row:
            keys.add(f"{section}.{row[1]}")
    return keys


def main(program):
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
    keys = keys_of_jobs()
    pages = sorted(page for pattern in PAGES for page in glob.glob(pattern))
    assert len(pages) > 20 and len(keys) > 50, f"looked at {len(pages)} pages and {len(keys)} keys alone"
    faults = [f"{page}: {fault}" for page in pages for fault in faults_of(page, program, keys)]
    with open("README.md", encoding="utf-8") as file:
        lines = file.read().count("\n")
    if lines > MOST_LINES_OF_README:
        faults.append(f"README.md: {lines} lines, allowed: {MOST_LINES_OF_README}")
    for fault in faults:
        print(fault, file=sys.stderr)
    return len(faults) > 0


sys.exit(main(os.path.abspath(sys.argv[1])))
