#!/usr/bin/env python3
"""The program prints the messages that the pages on files document. Each message in the last column of their tables stands in the
sources, or at least its longest part without numbers and names does. The pages list every file name ending that the sources know."""

import glob
import os
import re
import sys

PAGES = ("docs/nesting.md", "docs/files-read.md")
LITERAL = r'"((?:[^"\\\n]|\\.)*)"'


def sources():
    for path in sorted(glob.glob("src/**/*.cpp", recursive=True) + glob.glob("src/**/*.h", recursive=True)):
        with open(path, encoding="utf-8") as file:
            yield file.read()


def literals():
    """The string literals of the sources. Literals that the compiler joins are one text."""
    texts = []
    for source in sources():
        joined = re.sub(r'(?<!\\)"\s*\n\s*"', "", source)
        texts += re.findall(LITERAL, joined)
    return "\n".join(texts).replace('\\"', '"')


def messages(page):
    with open(page, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            cells = line.strip().strip("|").split(" | ")
            if not line.startswith("|") or len(cells) != 3 or set(line) <= set("|- \n"):
                continue
            for message in re.findall(r"`([^`]*)`", cells[2]):
                yield f"{page}:{number}", message


def main():
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
    told = literals()
    faults = []
    count = 0
    for place, message in (found for page in PAGES for found in messages(page)):
        count += 1
        parts = [part.strip() for part in re.split(r'[\d.,:;"()]+|\bNAME\b', message)]
        longest = max(parts, key=len)
        if longest not in told:
            faults.append(f"{place}: no source says \"{message}\"")
    pages = "".join(open(page, encoding="utf-8").read() for page in PAGES).lower()
    for ending in sorted(set(re.findall(r'^\.([a-z0-9]{2,5})$', told, re.MULTILINE))):
        if ending in READ and f"`.{ending}`" not in pages:
            faults.append(f".{ending} is read, and no page on files names it")
    for fault in faults:
        print(fault)
    if count < 20:
        print(f"found only {count} messages in {', '.join(PAGES)}")
    sys.exit(1 if faults or count < 20 else 0)


READ = {"svg", "svgz", "png", "jpg", "jpeg", "webp", "tif", "tiff", "bmp", "dxf", "json", "csv", "toml", "h5", "gpl", "hex"}

main()
