import { grownBox } from "../model/geometry.ts";
import type { MarkSet } from "../model/mark_set.ts";
import { channels } from "../model/ramp.ts";
import type { Result } from "../model/result.ts";
import type { TilePainter } from "./tile_layer.ts";
import { tracePiece } from "./trace.ts";

/** Pieces to erase are red with rising stripes, locked ones blue with falling ones. */
export const kMarkColours = { erase: "#d3214b", lock: "#0a6fc2" } as const;

export function marksPainter(result: Result, marks: MarkSet): TilePainter {
  const patterns = { erase: hatching(kMarkColours.erase, true), lock: hatching(kMarkColours.lock, false) };
  return {
    *paint(tile) {
      if (marks.size === 0) return;
      const found = result.index.within(grownBox(tile.box, 3 / tile.scale));
      for (const [position, appearance] of found.entries()) {
        const mark = marks.get(appearance.piece);
        if (mark) {
          const context = tile.context();
          const pattern = context.createPattern(patterns[mark], "repeat")!;
          // Stripes of the same width at any zoom.
          pattern.setTransform(new DOMMatrix([1 / tile.scale, 0, 0, 1 / tile.scale, tile.box.left, tile.box.top]));
          context.beginPath();
          tracePiece(context, result.outlines, appearance, 0.5 / tile.scale);
          context.fillStyle = pattern;
          context.fill("evenodd");
          context.strokeStyle = "#ffffff";
          context.lineWidth = 3.5 / tile.scale;
          context.stroke();
          context.strokeStyle = kMarkColours[mark];
          context.lineWidth = 2 / tile.scale;
          context.stroke();
        }
        if (position % 100 === 99) yield;
      }
    },
  };
}

/** A pattern of stripes, so that marks do not depend on their colour alone. */
function hatching(colour: string, rising: boolean): OffscreenCanvas {
  const size_px = 10;
  const canvas = new OffscreenCanvas(size_px, size_px);
  const context = canvas.getContext("2d")!;
  const [red, green, blue] = channels(colour);
  context.fillStyle = `rgba(${red},${green},${blue},0.5)`;
  context.fillRect(0, 0, size_px, size_px);
  context.strokeStyle = colour;
  context.lineWidth = 2.5;
  for (const shift of [-size_px, 0, size_px]) {
    context.moveTo(shift, rising ? size_px : 0);
    context.lineTo(shift + size_px, rising ? 0 : size_px);
  }
  context.stroke();
  return canvas;
}
