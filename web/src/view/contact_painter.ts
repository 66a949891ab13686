import { eachRing } from "../model/outlines.ts";
import { kCividis } from "../model/ramp.ts";
import type { Result } from "../model/result.ts";
import type { Appearance } from "../model/spatial_index.ts";
import { leastStep, lineStrength, portions, type Shown } from "./painters.ts";
import type { TilePainter } from "./tile_layer.ts";

/** Classes of distance to the next piece, units of the contact block (1/16 px): up to this. */
export const kContactClasses = [8, 16, 32, 64, 255].map((to, index) => ({ to, colour: kCividis[index]! }));

/** The class of each contact value. */
const class_of = Uint8Array.from({ length: 256 }, (_, value) => kContactClasses.findIndex(({ to }) => value <= to));

/** Boundaries, coloured by their distance to the next piece. */
export function contactPainter(result: Result, shown: Shown): TilePainter {
  return {
    *paint(tile) {
      if (!result.contact) return;
      const step = 2 * leastStep(tile);
      const strength = lineStrength(result, tile);
      for (const portion of portions(result, shown, tile)) {
        const paths = kContactClasses.map(() => new Path2D());
        for (const appearance of portion) traceClasses(result, result.contact, appearance, step, paths);
        const context = tile.context();
        context.lineJoin = "round";
        context.strokeStyle = `rgba(10,14,20,${0.8 * strength})`;
        context.lineWidth = (3.6 * strength) / tile.scale;
        for (const path of paths) context.stroke(path);
        context.lineWidth = Math.max(0.9, 2.2 * strength) / tile.scale;
        paths.forEach((path, index) => {
          context.strokeStyle = kContactClasses[index]!.colour;
          context.stroke(path);
        });
        yield;
      }
    },
  };
}

/** Adds each part of a boundary to the path of its class. Points closer than `step` px are joined; the farthest of them decides. */
function traceClasses(result: Result, contact: Uint8Array, { piece, dx, dy }: Appearance, step: number, paths: readonly Path2D[]): void {
  const { points } = result.outlines;
  eachRing(result.outlines, piece, (first, end) => {
    let x = points[2 * end - 2]! + dx;
    let y = points[2 * end - 1]! + dy;
    let farthest = contact[end - 1]!;
    let open: number | null = null; // the class of the line that ends at (x, y)
    for (let point = first; point < end; ++point) {
      const next_x = points[2 * point]! + dx;
      const next_y = points[2 * point + 1]! + dy;
      const short = (next_x - x) ** 2 + (next_y - y) ** 2 < step * step;
      if (short && point < end - 1) {
        farthest = Math.max(farthest, contact[point]!);
        continue;
      }
      const found = class_of[farthest]!;
      if (found !== open) paths[found]!.moveTo(x, y);
      paths[found]!.lineTo(next_x, next_y);
      [x, y, open, farthest] = [next_x, next_y, found, contact[point]!];
    }
  });
}
