import { boxesMeet, grownBox, movedBox } from "../model/geometry.ts";
import { boxOf } from "../model/outlines.ts";
import { gapClasses } from "../model/gap_classes.ts";
import { kViridis, rampColour } from "../model/ramp.ts";
import type { Result } from "../model/result.ts";
import type { Appearance } from "../model/spatial_index.ts";
import type { Tile, TilePainter } from "./tile_layer.ts";
import { tracePiece, traceRegion } from "./trace.ts";

/** Pieces that are drawn between two looks at the clock. */
const kPortion = 24;

/** A line along a boundary may reach this far beyond its piece, px of the tile. */
const kMargin_px = 2;

/** Which pieces show: the first `count` in order of placement. */
export interface Shown {
  readonly count: number;
}

/** The pieces of a tile that show, in portions, with those whose lines reach into it. */
export function* portions(result: Result, shown: Shown, tile: Tile): Generator<Appearance[], void, void> {
  const around = result.index.within(grownBox(tile.box, kMargin_px / tile.scale));
  const found = around.filter(({ piece }) => piece < shown.count);
  for (let at = 0; at < found.length; at += kPortion) yield found.slice(at, at + kPortion);
}

/** Points closer than this cannot be told apart on a tile, px of the world. */
export const leastStep = (tile: Tile): number => 0.5 / tile.scale;

/** Of 1: how strong lines along boundaries may be. Where pieces are tiny on the screen, strong lines would hide them. */
export function lineStrength(result: Result, tile: Tile): number {
  const { canvas, pieces } = result.data;
  const typical_px = Math.sqrt(canvas.area_px2 / Math.max(1, pieces.shape.length));
  return Math.max(0.3, Math.min(1, (typical_px * tile.scale) / 30));
}

/** Light lines within dark ones, so that they show on any picture, also along a drawing's own black contour. */
export function outlinePainter(result: Result, shown: Shown): TilePainter {
  return {
    *paint(tile) {
      const strength = lineStrength(result, tile);
      for (const portion of portions(result, shown, tile)) {
        const context = tile.context();
        context.beginPath();
        for (const appearance of portion) tracePiece(context, result.outlines, appearance, leastStep(tile));
        context.lineJoin = "round";
        context.strokeStyle = `rgba(10,14,20,${0.7 * strength})`;
        context.lineWidth = (1.8 + 1.6 * strength) / tile.scale;
        context.stroke();
        context.strokeStyle = `rgba(255,255,255,${0.95 * strength})`;
        context.lineWidth = (0.7 + 0.8 * strength) / tile.scale;
        context.stroke();
        yield;
      }
    },
  };
}

/** Fills pieces, each in its colour. `colour` returns null for a piece that does not show. */
export function fillPainter(result: Result, shown: Shown, colour: (piece: number) => string | null): TilePainter {
  return {
    *paint(tile) {
      for (const portion of portions(result, shown, tile)) {
        for (const appearance of portion) {
          const fill = colour(appearance.piece);
          if (!fill) continue;
          const context = tile.context();
          context.beginPath();
          tracePiece(context, result.outlines, appearance, leastStep(tile));
          context.fillStyle = fill;
          context.fill("evenodd");
        }
        yield;
      }
    },
  };
}

/** A ramp over the order of placement. */
export function orderPainter(result: Result, shown: Shown): TilePainter {
  const last = Math.max(1, result.data.pieces.shape.length - 1);
  return fillPainter(result, shown, (piece) => rampColour(kViridis, piece / last));
}

/** Fills all pieces of a tile that show. Parts of a pixel add up where two pieces meet in it, so that no pale line stays between them. */
function* addUpPieces(result: Result, shown: Shown, tile: Tile, context: OffscreenCanvasRenderingContext2D): Generator<void> {
  context.globalCompositeOperation = "lighter";
  for (const portion of portions(result, shown, tile)) {
    for (const appearance of portion) {
      context.beginPath();
      tracePiece(context, result.outlines, appearance, leastStep(tile));
      context.fill("evenodd");
    }
    yield;
  }
}

/** Adds up how often each pixel is covered, and shows those that are covered more than once. */
export function overlapPainter(result: Result, shown: Shown): TilePainter {
  return {
    *paint(tile) {
      const counting = tile.scratch();
      counting.fillStyle = "rgb(80,0,0)";
      yield* addUpPieces(result, shown, tile, counting);
      const image = counting.getImageData(0, 0, tile.size_px, tile.size_px);
      // Where two pieces meet within a pixel their parts add up to one cover, 80; one and a half is an overlap.
      if (colourOverlaps(image.data)) tile.context().putImageData(image, 0, 0);
    },
  };
}

function colourOverlaps(pixels: Uint8ClampedArray): boolean {
  let any = false;
  for (let at = 0; at < pixels.length; at += 4) {
    const cover = pixels[at]!;
    any ||= cover >= 120;
    pixels[at] = 213;
    pixels[at + 1] = cover >= 200 ? 0 : 60;
    pixels[at + 2] = cover >= 200 ? 110 : 0;
    pixels[at + 3] = cover >= 120 ? 255 : 0;
  }
  return any;
}

/** The region to fill without the pieces. */
export function freePainter(result: Result, shown: Shown): TilePainter {
  return {
    *paint(tile) {
      const covered = tile.scratch();
      yield* addUpPieces(result, shown, tile, covered);
      const context = tile.context();
      context.beginPath();
      traceRegion(context, result.region, result.data.canvas.width_px, result.data.canvas.height_px);
      context.fillStyle = "#0072b2";
      context.fill("evenodd");
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.globalCompositeOperation = "destination-out";
      context.drawImage(covered.canvas, 0, 0);
    },
  };
}


/** Discs between all pieces, also while some do not show yet. */
export function gapPainter(result: Result): TilePainter {
  const { x_px, y_px, radius_px } = result.data.gaps;
  const classes = gapClasses(radius_px);
  return {
    *paint(tile) {
      for (let gap = 0; gap < radius_px.length; ++gap) {
        const [x, y, radius] = [x_px[gap]!, y_px[gap]!, radius_px[gap]!];
        if (!boxesMeet({ left: x - radius, top: y - radius, right: x + radius, bottom: y + radius }, tile.box)) continue;
        const context = tile.context();
        context.beginPath();
        context.arc(x, y, radius, 0, 2 * Math.PI);
        context.fillStyle = classes.findLast((entry) => radius >= entry.from_px)!.colour;
        context.fill();
        context.lineWidth = 1 / tile.scale;
        context.strokeStyle = "rgba(10,14,20,0.8)";
        context.stroke();
        if (gap % kPortion === 0) yield;
      }
    },
  };
}

/** Pieces that have something in common: with a thick line, and tinted. `spotlight`: instead of the tint all else is darker. */
export function usesPainter(result: Result, chosen: () => readonly number[], spotlight: () => boolean): TilePainter {
  const { width_px, height_px } = result.data.canvas;
  return {
    *paint(tile) {
      const veiled = spotlight();
      if (veiled) {
        const context = tile.context();
        context.fillStyle = "rgba(8,10,14,0.62)";
        context.fillRect(0, 0, width_px, height_px);
      }
      const reach = grownBox(tile.box, 6 / tile.scale);
      for (const piece of chosen()) {
        const box = boxOf(result.outlines, piece);
        for (const appearance of result.index.appearancesOf(piece)) {
          if (!boxesMeet(movedBox(box, appearance.dx, appearance.dy), reach)) continue;
          const context = tile.context();
          context.beginPath();
          tracePiece(context, result.outlines, appearance, leastStep(tile));
          context.globalCompositeOperation = veiled ? "destination-out" : "source-over";
          context.fillStyle = veiled ? "#000000" : "rgba(255,176,0,0.45)";
          context.fill("evenodd");
          context.globalCompositeOperation = "source-over";
          context.lineJoin = "round";
          context.strokeStyle = "rgba(20,16,0,0.9)";
          context.lineWidth = 4.5 / tile.scale;
          context.stroke();
          context.strokeStyle = "#ffb000";
          context.lineWidth = 2.5 / tile.scale;
          context.stroke();
        }
        yield;
      }
    },
  };
}
