import { type Box, eachRing, type Outlines } from "../model/outlines.ts";
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

type RegionPen = Pen & { rect(x: number, y: number, w: number, h: number): void };

/** What lies beyond the region to fill, within `box`, as a path for the even-odd rule. Nothing if the region is the whole canvas. */
export function traceBeyondRegion(pen: RegionPen, region: Outlines | null, box: Box): void {
  if (!region) return;
  pen.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  traceRegion(pen, region, 0, 0);
}

/** The region to fill as a path. */
export function traceRegion(
  pen: RegionPen,
  region: Outlines | null,
  width: number,
  height: number,
): void {
  if (!region) return pen.rect(0, 0, width, height);
  for (let piece = 0; piece < region.piece_starts.length - 1; ++piece) tracePiece(pen, region, { piece, dx: 0, dy: 0 }, 0);
}
