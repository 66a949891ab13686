#!/usr/bin/env python3
"""silhouette_twins.py FOLDER OUT.txt: lists pairs of silhouettes that nobody can tell apart.

Two silhouettes are twins when both are of one class (the name before the last hyphen) and one, turned, moved and scaled
(never mirrored), overlaps the other with an intersection over union of 0.97 or more. A benchmark of recognition counts
either of them as found. Needs python3-numpy and python3-pil.
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image

LEAST_IOU = 0.97
COARSE_IOU = 0.88  # pairs below it by centroids, areas and the best of 360 angles are not looked at again
GRID = 192         # pixels of the square on which pairs are compared
RADIUS = 2.6       # half the square's side, in square roots of the silhouette's area


class Silhouette:
    def __init__(self, path):
        pixels = np.asarray(Image.open(path).convert("L")) > 127
        self.name = path.stem
        self.group = path.stem.rsplit("-", 1)[0]
        # A margin, so that points outside the picture are outside the silhouette.
        self.pixels = np.pad(pixels, 2).astype(np.float32)
        y, x = np.nonzero(self.pixels)
        self.centre = np.array([x.mean(), y.mean()])
        self.unit = np.sqrt(len(x))

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


def iou_at(fixed, other, points, pose):
    angle, log_scale, x, y = pose
    cos, sin = np.cos(angle) * np.exp(log_scale), np.sin(angle) * np.exp(log_scale)
    turned = np.stack([cos * points[..., 0] - sin * points[..., 1] + x, sin * points[..., 0] + cos * points[..., 1] + y],
                      axis=-1)
    moved = other.at(turned) > 0.5
    return np.count_nonzero(fixed & moved) / max(1, np.count_nonzero(fixed | moved))


def best_iou(a, b, angle, points):
    """Pattern search over angle, scale and position."""
    fixed = a.at(points) > 0.5
    pose = np.array([angle, 0.0, 0.0, 0.0])
    best = iou_at(fixed, b, points, pose)
    step = np.array([0.02, 0.02, 0.02, 0.02])
    while step[0] > 0.001 and best < 0.995:
        improved = False
        for k in range(4):
            for sign in (-1, 1):
                trial = pose.copy()
                trial[k] += sign * step[k]
                iou = iou_at(fixed, b, points, trial)
                if iou > best:
                    best, pose, improved = iou, trial, True
        if not improved:
            step /= 2
    return best


def main(folder, out):
    silhouettes = [Silhouette(p) for p in sorted(Path(folder).glob("*.png"))]
    points = square_points()
    groups = {}
    for s in silhouettes:
        groups.setdefault(s.group, []).append(s)
    lines = []
    for members in groups.values():
        rings = [m.polar() for m in members]
        spectra = [np.fft.rfft(r.astype(np.float32), axis=1) for r in rings]
        for i, a in enumerate(members):
            for j in range(i + 1, len(members)):
                both = np.fft.irfft((np.conj(spectra[i]) * spectra[j]).sum(axis=0), n=360)
                shift = int(both.argmax())
                coarse = both[shift] / (rings[i].sum() + rings[j].sum() - both[shift])
                if coarse < COARSE_IOU:
                    continue
                iou = best_iou(a, members[j], shift * np.pi / 180, points)
                if iou >= LEAST_IOU:
                    lines.append(f"{a.name} {members[j].name} {iou:.3f}")
    Path(out).write_text("\n".join(lines) + "\n")
    names = {n for line in lines for n in line.split()[:2]}
    print(f"{len(lines)} pairs, {len(names)} of {len(silhouettes)} silhouettes have a twin")


if __name__ == "__main__":
    main(*sys.argv[1:])
