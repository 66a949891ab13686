import { eachRing, type Outlines } from "../model/outlines.ts";
import type { Appearance } from "../model/spatial_index.ts";

/** What takes a path: a context or a Path2D. */
interface Pen {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
  closePath(): void;
}

/** Adds the outline of a piece to a path, without points closer than `least_step` px to the one before: on a small picture nobody
 *  sees them. */
export function tracePiece(pen: Pen, outlines: Outlines, { piece, dx, dy }: Appearance, least_step: number): void {
  const { points } = outlines;
  const least_squared = least_step * least_step;
  eachRing(outlines, piece, (first, end) => {
    let x = points[2 * first]! + dx;
    let y = points[2 * first + 1]! + dy;
    pen.moveTo(x, y);
    for (let point = first + 1; point < end; ++point) {
      const next_x = points[2 * point]! + dx;
      const next_y = points[2 * point + 1]! + dy;
      if ((next_x - x) * (next_x - x) + (next_y - y) * (next_y - y) < least_squared) continue;
      x = next_x;
      y = next_y;
      pen.lineTo(x, y);
    }
    pen.closePath();
  });
}

/** The region to fill as a path. */
export function traceRegion(
  pen: Pen & { rect(x: number, y: number, w: number, h: number): void },
  region: Outlines | null,
  width: number,
  height: number,
): void {
  if (!region) return pen.rect(0, 0, width, height);
  for (let piece = 0; piece < region.piece_starts.length - 1; ++piece) tracePiece(pen, region, { piece, dx: 0, dy: 0 }, 0);
}
