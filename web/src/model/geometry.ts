import { type Box, eachRing, type Outlines } from "./outlines.ts";

export interface Point {
  x: number;
  y: number;
}

export function boxesMeet(a: Box, b: Box): boolean {
  return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

export function grownBox(box: Box, by: number): Box {
  return { left: box.left - by, top: box.top - by, right: box.right + by, bottom: box.bottom + by };
}

export function movedBox(box: Box, dx: number, dy: number): Box {
  return { left: box.left + dx, top: box.top + dy, right: box.right + dx, bottom: box.bottom + dy };
}

/** Whether rectangles have the same shape, but for rounded sizes. */
export function sameShape(width: number, height: number, other_width: number, other_height: number): boolean {
  return Math.abs((width * other_height) / (height * other_width) - 1) < 0.01;
}

/** Where a rectangle of some shape lies in a frame from (0, 0): all of the frame for the same shape, else as large as it can, in the
 *  middle. */
export function containedBox(width: number, height: number, frame_width: number, frame_height: number): Box {
  if (sameShape(width, height, frame_width, frame_height)) return { left: 0, top: 0, right: frame_width, bottom: frame_height };
  const scale = Math.min(frame_width / width, frame_height / height);
  const [left, top] = [(frame_width - scale * width) / 2, (frame_height - scale * height) / 2];
  return { left, top, right: frame_width - left, bottom: frame_height - top };
}

/** Even-odd rule, holes included. */
export function pieceContains(outlines: Outlines, piece: number, x: number, y: number): boolean {
  let inside = false;
  const { points } = outlines;
  eachRing(outlines, piece, (first, end) => {
    for (let point = first, before = end - 1; point < end; before = point++) {
      const y0 = points[2 * before + 1]!;
      const y1 = points[2 * point + 1]!;
      if (y0 > y === y1 > y) continue;
      const x0 = points[2 * before]!;
      const x1 = points[2 * point]!;
      if (x < x0 + ((x1 - x0) * (y - y0)) / (y1 - y0)) inside = !inside;
    }
  });
  return inside;
}

export function polygonContains(polygon: readonly Point[], x: number, y: number): boolean {
  let inside = false;
  let before = polygon[polygon.length - 1];
  for (const point of polygon) {
    if (before && before.y > y !== point.y > y && x < before.x + ((point.x - before.x) * (y - before.y)) / (point.y - before.y)) {
      inside = !inside;
    }
    before = point;
  }
  return inside;
}

/** Square of the distance from a point to a segment. */
export function squaredDistanceToSegment(x: number, y: number, x0: number, y0: number, x1: number, y1: number): number {
  const along_x = x1 - x0;
  const along_y = y1 - y0;
  const squared_length = along_x * along_x + along_y * along_y;
  const t = squared_length > 0 ? Math.max(0, Math.min(1, ((x - x0) * along_x + (y - y0) * along_y) / squared_length)) : 0;
  const dx = x - (x0 + t * along_x);
  const dy = y - (y0 + t * along_y);
  return dx * dx + dy * dy;
}

export function segmentsCross(a: Point, b: Point, c: Point, d: Point): boolean {
  const side = (p: Point, q: Point, r: Point): number => (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return side(a, b, c) > 0 !== side(a, b, d) > 0 && side(c, d, a) > 0 !== side(c, d, b) > 0;
}

function squaredDistanceOfSegments(a: Point, b: Point, c: Point, d: Point): number {
  if (segmentsCross(a, b, c, d)) return 0;
  return Math.min(
    squaredDistanceToSegment(a.x, a.y, c.x, c.y, d.x, d.y),
    squaredDistanceToSegment(b.x, b.y, c.x, c.y, d.x, d.y),
    squaredDistanceToSegment(c.x, c.y, a.x, a.y, b.x, b.y),
    squaredDistanceToSegment(d.x, d.y, a.x, a.y, b.x, b.y),
  );
}

/** Whether a stroke of a round brush, from one point to another, touches a piece. */
export function strokeTouchesPiece(outlines: Outlines, piece: number, from: Point, to: Point, radius: number): boolean {
  if (pieceContains(outlines, piece, to.x, to.y) || pieceContains(outlines, piece, from.x, from.y)) return true;
  const { points } = outlines;
  let touches = false;
  eachRing(outlines, piece, (first, end) => {
    for (let point = first, before = end - 1; point < end && !touches; before = point++) {
      const c = { x: points[2 * before]!, y: points[2 * before + 1]! };
      const d = { x: points[2 * point]!, y: points[2 * point + 1]! };
      touches = squaredDistanceOfSegments(from, to, c, d) <= radius * radius;
    }
  });
  return touches;
}
