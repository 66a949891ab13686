#!/usr/bin/env python3
"""Writes the pictures of a font of colour bitmaps (CBDT), a PNG a glyph, named after its characters.

    scripts/emoji_glyphs.py FONT.ttf FOLDER

Needs Debian's python3-fonttools. Glyphs of no name of their own are named after the glyph.
"""
import pathlib
import sys
import unicodedata

from fontTools.ttLib import TTFont

JOINERS = {0x200D, 0xFE0F}  # these stand between the characters of one emoji and mean nothing alone


def word(code_point):
    name = unicodedata.name(chr(code_point), f"u{code_point:04x}").lower()
    return name.replace("emoji modifier fitzpatrick type", "skin").replace(" ", "_")


def ligatures(font):
    """The pair (glyphs, their common glyph) for each ligature."""
    for lookup in font["GSUB"].table.LookupList.Lookup:
        for table in lookup.SubTable:
            table = getattr(table, "ExtSubTable", table)
            for first, of_first in getattr(table, "ligatures", {}).items():
                for ligature in of_first:
                    yield [first, *ligature.Component], ligature.LigGlyph


def names_of_glyphs(font):
    characters = {glyph: [code_point] for code_point, glyph in font.getBestCmap().items()}
    for parts, glyph in ligatures(font):
        if all(part in characters for part in parts):
            characters.setdefault(glyph, [c for part in parts for c in characters[part]])
    return {
        glyph: "_".join(word(c) for c in code_points if c not in JOINERS) for glyph, code_points in characters.items()
    }


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    font = TTFont(sys.argv[1])
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    names = names_of_glyphs(font)
    taken = set()
    for glyph, bitmap in font["CBDT"].strikeData[0].items():
        name = names.get(glyph, glyph)
        if name in taken:
            name += "_" + glyph
        taken.add(name)
        (folder / f"{name}.png").write_bytes(bitmap.imageData)
    print(f"{len(taken)} pictures in {folder}")


main()
