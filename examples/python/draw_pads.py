"""draw_pads.py A B [PICTURE.png]: PADs of two drawings, and the parts of them that match, with matplotlib.

The lines "# %%" divide it into cells for editors that run Python as notebooks.
"""

# %% Two drawings. Lengths are in px or 1/96 inch, and y points down.
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plot
import numpy

import tessera

a, b = (tessera.read_drawing(path) for path in sys.argv[1:3])
picture = sys.argv[3] if len(sys.argv) > 3 else "pads.png"
figure, ((drawing, curves), (table, matched)) = plot.subplots(2, 2, figsize=(11, 9), layout="constrained")


def draw_outline(axes, outline, colour):
    for curve, closed in zip(outline.curves, outline.closed):
        points = numpy.vstack([curve, curve[:1]]) if closed else curve
        axes.plot(*points.T, color=colour, linewidth=1)
    axes.set_aspect("equal")
    axes.axis("off")


# %% A PAD holds how far one has to go along the curve, both ways, until it has turned by 0.2, 0.4, 0.8, ... rad.
pads = tessera.pads(a, samples=48)
draw_outline(drawing, a, "0.6")
drawing.scatter(*pads.position.T, c=pads.convexity, cmap="coolwarm", vmin=-1, vmax=1, s=22)
drawing.invert_yaxis()
drawing.set_title("A: points with PADs (red: convex, blue: concave)")

# %% The arclengths along the outline: long where it is straight, short at corners.
for level in range(pads.right.shape[1]):
    curves.semilogy(pads.along, pads.right[:, level], marker=".", label=f"level {level}")
curves.set(xlabel="arclength from the first point", ylabel="arclength to the right", title="A: levels of the PADs")
curves.legend()

# %% Distances of all PADs of A to all of B. Parts that are alike are dark diagonals.
distances = pads.distances(tessera.pads(b, samples=48))
shown = table.imshow(distances, cmap="viridis", vmin=0, vmax=1)
table.set(xlabel="PAD of B", ylabel="PAD of A", title="distances")
figure.colorbar(shown, ax=table, shrink=0.8)

# %% The best match: B laid onto A.
draw_outline(matched, a, "0.6")
for match in tessera.match(a, b):
    draw_outline(matched, b.mapped(match.a_from_b), "tab:red")
    matched.set_title(f"B (red) on A: score {match.score:.3f}")
matched.invert_yaxis()

# %%
figure.savefig(picture, dpi=100)
print(f"{picture}: {len(pads)} PADs, median distance to the nearest of B {numpy.median(distances.min(axis=1)):.3f}")
