import { boxesMeet, grownBox, movedBox, pieceContains, squaredDistanceToSegment } from "./geometry.ts";
import { type Box, boxOf, eachRing, type Outlines, pointRange } from "./outlines.ts";
import type { SpatialIndex } from "./spatial_index.ts";

/** Within this distance two pieces touch, as in the quality card. */
export const kContact_px = 2;

/** The pieces within `reach` px of a piece, without itself, in order of placement. */
export function neighboursOf(outlines: Outlines, index: SpatialIndex, piece: number, reach: number): number[] {
  const found = new Set<number>();
  const box = grownBox(boxOf(outlines, piece), reach);
  for (const other of index.within(box)) {
    if (other.piece === piece || found.has(other.piece)) continue;
    if (areNear(outlines, piece, other.piece, other.dx, other.dy, reach)) found.add(other.piece);
  }
  return [...found];
}

/** Whether a piece and another one, moved by (dx, dy), come within `reach` px of each other, or overlap. */
function areNear(outlines: Outlines, piece: number, other: number, dx: number, dy: number, reach: number): boolean {
  if (pointsNearBoundary(outlines, other, piece, dx, dy, reach)) return true;
  if (pointsNearBoundary(outlines, piece, other, -dx, -dy, reach)) return true;
  const [first] = pointRange(outlines, other);
  const [own] = pointRange(outlines, piece);
  const { points } = outlines;
  return (
    pieceContains(outlines, piece, points[2 * first]! + dx, points[2 * first + 1]! + dy) ||
    pieceContains(outlines, other, points[2 * own]! - dx, points[2 * own + 1]! - dy)
  );
}

/** Whether a point of `of`, moved by (dx, dy), lies within `reach` px of the boundary of `to`. */
function pointsNearBoundary(outlines: Outlines, of: number, to: number, dx: number, dy: number, reach: number): boolean {
  const zone = grownBox(boxOf(outlines, to), reach);
  const segments = segmentsWithin(outlines, to, grownBox(movedBox(boxOf(outlines, of), dx, dy), reach));
  const [first, end] = pointRange(outlines, of);
  for (let point = first; point < end; ++point) {
    const x = outlines.points[2 * point]! + dx;
    const y = outlines.points[2 * point + 1]! + dy;
    if (x < zone.left || x > zone.right || y < zone.top || y > zone.bottom) continue;
    for (let at = 0; at < segments.length; at += 4) {
      const distance = squaredDistanceToSegment(x, y, segments[at]!, segments[at + 1]!, segments[at + 2]!, segments[at + 3]!);
      if (distance <= reach * reach) return true;
    }
  }
  return false;
}

/** The segments of a piece whose boxes meet `box`: x0, y0, x1, y1, ... */
function segmentsWithin(outlines: Outlines, piece: number, box: Box): number[] {
  const segments: number[] = [];
  const { points } = outlines;
  eachRing(outlines, piece, (first, end) => {
    for (let point = first, before = end - 1; point < end; before = point++) {
      const [x0, y0, x1, y1] = [points[2 * before]!, points[2 * before + 1]!, points[2 * point]!, points[2 * point + 1]!];
      const span = { left: Math.min(x0, x1), top: Math.min(y0, y1), right: Math.max(x0, x1), bottom: Math.max(y0, y1) };
      if (boxesMeet(span, box)) segments.push(x0, y0, x1, y1);
    }
  });
  return segments;
}
