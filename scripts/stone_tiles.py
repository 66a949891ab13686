#!/usr/bin/env python3
"""Breaks slabs of stone in eight greys into 734 tiles: a sheet of slabs, and the map of the pixels of each tile.

    scripts/stone_tiles.py PHOTO.jpg FOLDER    writes FOLDER/sheet.svg (of the photo's stone) and FOLDER/labels.png

scripts/stone-library.sh makes a library of them. The same photo gives the same tiles.
"""
import base64
import math
import pathlib
import random
import struct
import sys
import zlib

PHOTO_PX = (1600, 800)  # PHOTO.jpg is scaled to this size
PHOTO_MEAN = 0.57  # mean lightness, sRGB
SLAB_PX = (1600, 200)  # the sheet has eight of them
TILES = [92, 92, 92, 92, 92, 92, 91, 91]  # for each slab; 734 in all
MEANS = [0.09, 0.2, 0.31, 0.43, 0.55, 0.67, 0.8, 0.92]  # for each slab, sRGB
CONTRASTS = [0.5, 0.9, 1.2, 1.3, 1.3, 1.2, 0.9, 0.5]  # for each slab; the photo has 1
STEP_PX = 2  # the size of a pixel of the map
GAP_PX = 4  # between two tiles


def slab(number):
    """A strip of the photo's stone in one grey. The lower slabs are mirrored, so that no strip appears twice."""
    width, height = SLAB_PX
    contrast = CONTRASTS[number]
    tone = f"type='linear' slope='{contrast}' intercept='{MEANS[number] - contrast * PHOTO_MEAN:.3f}'"
    mirror = f"translate({width} 0) scale(-1 1)" if number >= 4 else ""
    return (
        f"<filter id='tone{number}' color-interpolation-filters='sRGB' x='0' y='0' width='1' height='1'>"
        "<feColorMatrix type='saturate' values='0'/><feComponentTransfer>"
        f"<feFuncR {tone}/><feFuncG {tone}/><feFuncB {tone}/></feComponentTransfer></filter>"
        f"<svg y='{number * height}' width='{width}' height='{height}'><g filter='url(#tone{number})'>"
        f"<use href='#photo' transform='{mirror} translate(0 {-(number % 4) * height})'/></g></svg>\n"
    )


def sheet(photo):
    width, height = SLAB_PX
    page = f"width='{width}' height='{height * len(TILES)}'"
    image = base64.b64encode(photo).decode()
    return (
        f"<svg xmlns='http://www.w3.org/2000/svg' {page}><defs><image id='photo' width='{PHOTO_PX[0]}' "
        f"height='{PHOTO_PX[1]}' href='data:image/jpeg;base64,{image}'/></defs>\n"
        + "".join(slab(number) for number in range(len(TILES)))
        + "</svg>\n"
    )


class Site:
    """The middle of a tile and its extent by direction, so that tiles are neither squares nor all alike."""

    def __init__(self, chance):
        self.x, self.y = (chance.uniform(0, side) for side in SLAB_PX)
        turn, length = chance.uniform(0, math.pi), chance.uniform(1, 1.5)
        self.along = (math.cos(turn) / length, math.sin(turn) / length)
        self.across = (-math.sin(turn) * length, math.cos(turn) * length)

    def distance(self, x, y):
        x, y = x - self.x, y - self.y
        return math.hypot(self.along[0] * x + self.along[1] * y, self.across[0] * x + self.across[1] * y)


def sites(count, chance):
    """Chooses each site as the one of six that is farthest from the earlier sites, so that no tile is a splinter."""
    chosen = []
    while len(chosen) < count:
        offers = [Site(chance) for _ in range(6)]
        chosen.append(max(offers, key=lambda o: min((math.hypot(o.x - c.x, o.y - c.y) for c in chosen), default=0)))
    return chosen


def label_rows(count, chance):
    """The rows of labels of one slab: 1..count, and 0 between tiles and along the slab's edge."""
    width, height = SLAB_PX
    near_px = 3 * math.sqrt(width * height / count)
    all_sites = sites(count, chance)
    for y in range(STEP_PX // 2, height, STEP_PX):
        in_reach = [(i, s) for i, s in enumerate(all_sites, 1) if abs(s.y - y) < near_px]
        row = []
        for x in range(STEP_PX // 2, width, STEP_PX):
            two = sorted((s.distance(x, y), i) for i, s in in_reach if abs(s.x - x) < near_px)[:2]
            inside = GAP_PX < x < width - GAP_PX and GAP_PX < y < height - GAP_PX
            row.append(two[0][1] if inside and two[1][0] - two[0][0] > GAP_PX else 0)
        yield bytes(label for label in row for _ in range(STEP_PX))


def grey_png(rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + row for row in rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")


def main(photo, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "sheet.svg").write_text(sheet(pathlib.Path(photo).read_bytes()))
    chance = random.Random(1)
    rows = [row for count in TILES for row in label_rows(count, chance) for _ in range(STEP_PX)]
    (folder / "labels.png").write_bytes(grey_png(rows))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
