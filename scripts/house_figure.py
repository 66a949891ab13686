#!/usr/bin/env python3
"""scripts/house_figure.py [FILE.svg]: draws docs/house.svg, the rooms of src/ with an arrow to each room whose headers a room includes.
A room stands above all rooms that it knows. An arrow that follows from others is left out."""

import argparse
import os
import re

WIDTH, ROW, BOX, HALF_HEIGHT = 940, 92, 132, 19
WORDS = {  # the text below the name
    "core": "the algorithm", "files": "whole or not at all", "text": "numbers, JSON, XML", "artwork": "foreign drawings",
    "library": "shapes in HDF5", "job": "the job and its keys", "layers": "beside the pieces", "recognition": "matches as files",
    "package": "library for programs", "checkpoint": "state in a file", "result": "the result's files", "render": "pictures",
    "report": "pages of results", "products": "mosaics, puzzles ...", "comm": "MPI", "worker": "devices, OpenCL",
    "master": "the collage's loop", "terminal": "what is printed", "run": "what the ranks do",
    "program": "command line", "plan": "what a job takes", "serve": "for a browser", "bench": "tessera-bench", "cli": "tessera"}
KINDS = {"core": "#cfe3f2", "comm": "#f8d9c4", "worker": "#f8d9c4", "master": "#f8d9c4"}


def rooms_and_includes():
    """The top-level rooms, the lowest first, and for each room the other rooms that its files include."""
    with open("src/rooms.txt", encoding="utf-8") as file:
        listed = [line.split()[0].split("/")[0] for line in file if line.strip() and not line.startswith("#")]
    rooms = list(dict.fromkeys(listed))
    known = {room: set() for room in rooms}
    for room in rooms:
        for folder, _, names in os.walk(os.path.join("src", room)):
            for name in names:
                if not name.endswith((".h", ".cpp")):
                    continue
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    found = re.findall(r'^#include "([a-z_]+)/', file.read(), re.M)
                known[room].update(other for other in found if other in known and other != room)
    return rooms, known


def without_what_follows(known):
    """The includes without those that another room in between implies."""
    def reached(room):
        found = set()
        for other in known[room]:
            found |= {other} | reached(other)
        return found
    return {room: {o for o in others if not any(o in reached(p) for p in others if p != o)} for room, others in known.items()}


def rows_of(rooms, known):
    """The rooms row by row, the lowest row first. Within a row each room is near the rooms that it knows."""
    level = {}
    for room in rooms:
        level[room] = 1 + max((level[other] for other in known[room]), default=-1)
    rows = [[room for room in rooms if level[room] == i] for i in range(max(level.values()) + 1)]
    place = {}
    for row in rows:
        row.sort(key=lambda room: sum(place[o] for o in known[room]) / max(1, len(known[room])) if known[room] else 0)
        for i, room in enumerate(row):
            place[room] = (i + 0.5) / len(row)
    return rows


def figure(rooms, known):
    arrows = without_what_follows(known)
    rows = rows_of(rooms, arrows)
    height = ROW * len(rows) + 20
    at = {}
    for i, row in enumerate(rows):
        for k, room in enumerate(row):
            at[room] = (WIDTH * (k + 0.5) / len(row), height - ROW * (i + 0.5) - 10)
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" '
             'font-family="sans-serif" text-anchor="middle">',
             '<rect width="100%" height="100%" rx="8" fill="#ffffff"/>',
             '<defs><marker id="head" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
             '<path d="M0,0L8,4L0,8Z" fill="#8a8a8a"/></marker></defs>']
    for room in rooms:
        for other in sorted(arrows[room]):
            (x0, y0), (x1, y1) = at[room], at[other]
            y0, y1 = y0 + HALF_HEIGHT, y1 - HALF_HEIGHT
            bend = (y1 - y0) / 2
            lines.append(f'<path d="M{x0:.0f},{y0:.0f}C{x0:.0f},{y0 + bend:.0f} {x1:.0f},{y1 - bend:.0f} {x1:.0f},{y1:.0f}" '
                         'fill="none" stroke="#8a8a8a" stroke-width="1.2" marker-end="url(#head)"/>')
    for room in rooms:
        x, y = at[room]
        lines.append(f'<rect x="{x - BOX / 2:.0f}" y="{y - HALF_HEIGHT:.0f}" width="{BOX}" height="{2 * HALF_HEIGHT}" rx="5" '
                     f'fill="{KINDS.get(room, "#f2efe9")}" stroke="#222222"/>')
        lines.append(f'<text x="{x:.0f}" y="{y - 2:.0f}" font-size="15" fill="#222222">{room}</text>')
        lines.append(f'<text x="{x:.0f}" y="{y + 13:.0f}" font-size="12" fill="#555555">{WORDS[room]}</text>')
    return "\n".join(lines + ["</svg>", ""])


def main(path):
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    with open(path, "w", encoding="utf-8") as file:
        file.write(figure(*rooms_and_includes()))


parser = argparse.ArgumentParser(description="Draws the rooms of src/ and which of them include which.")
parser.add_argument("svg", nargs="?", type=os.path.abspath, default="docs/house.svg", help="default: docs/house.svg")
main(parser.parse_args().svg)
