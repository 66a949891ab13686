"""match_drawings.py A B: how drawing B lies on drawing A where their outlines follow one another."""

import sys

import tessera

a, b = (tessera.read_drawing(path) for path in sys.argv[1:3])
for match in tessera.match(a, b, most=3):
    pose = match.a_from_b
    print(f"score {match.score:.3f}: {100 * match.part_of_a:.1f} % of A, scale {pose.scale:.3f}, "
          f"turned by {pose.rotation_rad:.3f} rad")
