#!/usr/bin/env python3
"""silhouette_twins.py FOLDER OUT.txt: lists pairs of silhouettes that look the same.

Two silhouettes are twins when both are of one class (the name before the last hyphen) and one, turned, moved and scaled,
overlaps the other with an intersection over union of 0.97 or more. "~B" is the mirror image of B, which a library may
hold as a shape of its own: "A ~B" says that A and B's mirror image are twins. A benchmark of recognition counts either
twin as found. Needs python3-numpy and python3-pil.
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image

LEAST_IOU = 0.97
COARSE_IOU = 0.88  # pairs are not refined if centroids, areas and the best of 360 angles give less
GRID = 192         # pixels along each side of the square in which pairs are compared
RADIUS = 2.6       # half the square's side, in square roots of the silhouette's area


class Silhouette:
    def __init__(self, path, mirrored=False):
        pixels = np.asarray(Image.open(path).convert("L")) > 127
        if mirrored:
            pixels = pixels[:, ::-1]
        self.name = "~" * mirrored + path.stem
        self.group = path.stem.rsplit("-", 1)[0]
        # The margin puts points outside the picture outside the silhouette.
        self.pixels = np.pad(pixels, 2).astype(np.float32)
        y, x = np.nonzero(self.pixels)
        self.centre = np.array([x.mean(), y.mean()])
        self.unit = np.sqrt(len(x))
        rings = self.polar()
        self.ring_area = rings.sum()
        self.spectrum = np.fft.rfft(rings.astype(np.float32), axis=1)

    def at(self, points):
        """Coverage (bilinear) at points of the unit frame: centroid at the origin, area 1."""
        p = points * self.unit + self.centre
        height, width = self.pixels.shape
        x = np.clip(p[..., 0], 0, width - 1.001)
        y = np.clip(p[..., 1], 0, height - 1.001)
        i, j = x.astype(int), y.astype(int)
        s, t = x - i, y - j
        m = self.pixels
        return (m[j, i] * (1 - s) + m[j, i + 1] * s) * (1 - t) + (m[j + 1, i] * (1 - s) + m[j + 1, i + 1] * s) * t

    def polar(self):
        """Coverage on rings of equal area, 360 angles each."""
        radius = np.sqrt((np.arange(96) + 0.5) / 96) * RADIUS
        angle = np.arange(360) * np.pi / 180
        points = np.stack([np.outer(radius, np.cos(angle)), np.outer(radius, np.sin(angle))], axis=-1)
        return self.at(points) > 0.5


def square_points():
    side = (np.arange(GRID) + 0.5) / GRID * 2 * RADIUS - RADIUS
    return np.stack(np.meshgrid(side, side), axis=-1)


def moved(other, points, pose):
    """Coverage of the other silhouette, turned, scaled and shifted."""
    angle, log_scale, x, y = pose
    cos, sin = np.cos(angle) * np.exp(log_scale), np.sin(angle) * np.exp(log_scale)
    turned = np.stack([cos * points[..., 0] - sin * points[..., 1] + x, sin * points[..., 0] + cos * points[..., 1] + y],
                      axis=-1)
    return other.at(turned)


def iou(a, b):
    return np.minimum(a, b).sum() / np.maximum(a, b).sum()


def best_iou(a, b, angle, points):
    """The best overlap, by a pattern search over angle, scale and position (Hooke and Jeeves 1961). It compares coverages, because
    they change smoothly with the pose, unlike counts of pixels."""
    fixed = a.at(points)
    pose = np.array([angle, 0.0, 0.0, 0.0])
    best = iou(fixed, moved(b, points, pose))
    step = 0.02
    while step > 0.0005:
        start = pose
        for k in range(4):
            for sign in (-1, 1):
                trial = pose.copy()
                trial[k] += sign * step
                overlap = iou(fixed, moved(b, points, trial))
                if overlap > best:
                    best, pose = overlap, trial
                    break
        if pose is start:
            step /= 2
            continue
        trial = 2 * pose - start  # repeats the whole last move
        overlap = iou(fixed, moved(b, points, trial))
        if overlap > best:
            best, pose = overlap, trial
    return iou(fixed > 0.5, moved(b, points, pose) > 0.5)


def twin_line(a, b, points):
    """A line of the list, or None if the two are no twins."""
    both = np.fft.irfft((np.conj(a.spectrum) * b.spectrum).sum(axis=0), n=360)
    shift = int(both.argmax())
    coarse = both[shift] / (a.ring_area + b.ring_area - both[shift])
    if coarse < COARSE_IOU:
        return None
    best = best_iou(a, b, shift * np.pi / 180, points)
    return f"{a.name} {b.name} {best:.3f}" if best >= LEAST_IOU else None


def main(folder, out):
    paths = sorted(Path(folder).glob("*.png"))
    points = square_points()
    groups = {}
    for path in paths:
        pair = Silhouette(path), Silhouette(path, mirrored=True)
        groups.setdefault(pair[0].group, []).append(pair)
    lines = []
    for members in groups.values():
        for i, (a, _) in enumerate(members):
            others = [b for b, _ in members[i + 1:]] + [mirrored for _, mirrored in members[i:]]
            lines += filter(None, (twin_line(a, b, points) for b in others))
    Path(out).write_text("\n".join(lines) + "\n")
    plain = [line.split()[:2] for line in lines if "~" not in line]
    print(f"{len(plain)} pairs, {len({n for pair in plain for n in pair})} of {len(paths)} silhouettes have a twin; "
          f"{len(lines) - len(plain)} pairs of a silhouette and a mirror image")


if __name__ == "__main__":
    main(*sys.argv[1:])
