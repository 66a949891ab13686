import Flatbush from "flatbush";
import { grownBox, movedBox, pieceContains, polygonContains, type Point, strokeTouchesPiece } from "./geometry.ts";
import { type Box, boxOf, type Outlines, pieceCount } from "./outlines.ts";

/** A piece as it appears on the canvas. On a seamless canvas one that crosses an edge appears at the other side, too, moved there. */
export interface Appearance {
  piece: number;
  dx: number;
  dy: number;
}

export interface Period {
  width_px: number;
  height_px: number;
  repeats_x: boolean;
  repeats_y: boolean;
}

/** By how much a piece that spans [low, high] must be moved to appear wherever it meets [0, size]. */
function shifts(low: number, high: number, size: number, repeats: boolean): number[] {
  if (!repeats) return [0];
  return [0, size, -size].filter((shift) => shift === 0 || (low + shift < size && high + shift > 0));
}

/** Finds pieces by place. */
export class SpatialIndex {
  /** By piece, in order of placement. */
  private readonly appearances: Appearance[] = [];
  /** The first appearance of each piece; one more at the end. */
  private readonly first: number[] = [];
  private readonly tree: Flatbush | null;

  constructor(
    private readonly outlines: Outlines,
    period: Period,
  ) {
    const boxes: Box[] = [];
    for (let piece = 0; piece < pieceCount(outlines); ++piece) {
      const box = boxOf(outlines, piece);
      this.first.push(this.appearances.length);
      for (const dx of shifts(box.left, box.right, period.width_px, period.repeats_x)) {
        for (const dy of shifts(box.top, box.bottom, period.height_px, period.repeats_y)) {
          this.appearances.push({ piece, dx, dy });
          boxes.push(movedBox(box, dx, dy));
        }
      }
    }
    this.first.push(this.appearances.length);
    // Flatbush refuses to be empty.
    this.tree = boxes.length > 0 ? new Flatbush(boxes.length, 16, Float32Array) : null;
    for (const box of boxes) this.tree?.add(box.left, box.top, box.right, box.bottom);
    this.tree?.finish();
  }

  /** What has its box in `box`, in order of placement. */
  within(box: Box): Appearance[] {
    const found = this.tree?.search(box.left, box.top, box.right, box.bottom) ?? [];
    return found.sort((a, b) => a - b).map((index) => this.appearances[index]!);
  }

  /** All places where a piece appears, its own place first. */
  appearancesOf(piece: number): readonly Appearance[] {
    return this.appearances.slice(this.first[piece], this.first[piece + 1]);
  }

  /** The uppermost piece at a point. */
  pieceAt(x: number, y: number): number | null {
    const here = this.within({ left: x, top: y, right: x, bottom: y });
    const hit = here.reverse().find(({ piece, dx, dy }) => pieceContains(this.outlines, piece, x - dx, y - dy));
    return hit ? hit.piece : null;
  }

  /** All pieces that a stroke of a round brush touches. */
  touchedBy(from: Point, to: Point, radius: number): number[] {
    const span = {
      left: Math.min(from.x, to.x),
      top: Math.min(from.y, to.y),
      right: Math.max(from.x, to.x),
      bottom: Math.max(from.y, to.y),
    };
    const touched = this.within(grownBox(span, radius)).filter(({ piece, dx, dy }) =>
      strokeTouchesPiece(this.outlines, piece, { x: from.x - dx, y: from.y - dy }, { x: to.x - dx, y: to.y - dy }, radius),
    );
    return touched.map((appearance) => appearance.piece);
  }

  /** All pieces whose centre lies in a lasso. */
  inLasso(lasso: readonly Point[], centre: (piece: number) => Point): number[] {
    const xs = lasso.map((point) => point.x);
    const ys = lasso.map((point) => point.y);
    const box = { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) };
    const inside = this.within(box).filter(({ piece, dx, dy }) => {
      const { x, y } = centre(piece);
      return polygonContains(lasso, x + dx, y + dy);
    });
    return [...new Set(inside.map((appearance) => appearance.piece))];
  }
}
