#!/usr/bin/env python3
"""animated_png.py FROM TO: adds the chunk to a PNG that makes it an animation of two pictures."""

import struct
import sys
import zlib

HEADER_END = 33  # the signature and the chunk IHDR

with open(sys.argv[1], "rb") as file:
    png = file.read()
chunk = b"acTL" + struct.pack(">II", 2, 0)
control = struct.pack(">I", 8) + chunk + struct.pack(">I", zlib.crc32(chunk))
with open(sys.argv[2], "wb") as file:
    file.write(png[:HEADER_END] + control + png[HEADER_END:])
