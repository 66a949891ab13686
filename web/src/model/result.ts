import type { ResultData, Source } from "../data.ts";
import { decodeOutlines, eachRing, type Outlines, pieceCount } from "./outlines.ts";
import { SpatialIndex } from "./spatial_index.ts";

/** The value of a contact byte that stands for 2 px, as data.ts says. */
export const kContactUnits = 32;

/** A result with everything that follows from its data. */
export interface Result {
  data: ResultData;
  source: Source;
  outlines: Outlines;
  index: SpatialIndex;
  /** See data.ts; null where the page lacks it. */
  contact: Uint8Array | null;
  /** The region to fill; null: the whole rectangle. */
  region: Outlines | null;
  /** The pieces of each shape. */
  uses: number[][];
}

export function loadResult(source: Source, data: ResultData): Result {
  const outlines = decodeOutlines(source.block("outlines") ?? new Uint8Array(0));
  const pieces = data.pieces.shape.length;
  if (pieceCount(outlines) !== pieces) throw new Error(`this page has ${pieces} pieces, but ${pieceCount(outlines)} outlines`);
  const contact = source.block("contact");
  const region = source.block("canvas");
  return {
    data,
    source,
    outlines,
    index: new SpatialIndex(outlines, data.canvas),
    contact: contact && contact.length === outlines.points.length / 2 ? contact : null,
    region: region ? decodeOutlines(region) : null,
    uses: usesOf(data),
  };
}

function usesOf(data: ResultData): number[][] {
  const uses = data.shapes.name.map((): number[] => []);
  data.pieces.shape.forEach((shape, piece) => uses[shape]?.push(piece));
  return uses;
}

export function pieceName(result: Result, piece: number): string {
  return result.data.shapes.name[result.data.pieces.shape[piece]!] || "unnamed drawing";
}

export function centreOf(result: Result, piece: number): { x: number; y: number } {
  return { x: result.data.pieces.x_px[piece]!, y: result.data.pieces.y_px[piece]! };
}

/** The part of a piece's boundary in contact, by length; null where that is not known. */
export function contactFraction(result: Result, piece: number): number | null {
  const { contact, outlines } = result;
  if (!contact) return null;
  let touching = 0;
  let total = 0;
  eachRing(outlines, piece, (first, end) => {
    for (let point = first, before = end - 1; point < end; before = point++) {
      const dx = outlines.points[2 * point]! - outlines.points[2 * before]!;
      const dy = outlines.points[2 * point + 1]! - outlines.points[2 * before + 1]!;
      const length = Math.hypot(dx, dy);
      total += length;
      if (contact[before]! <= kContactUnits) touching += length;
    }
  });
  return total > 0 ? touching / total : 0;
}

