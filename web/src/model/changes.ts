import type { PieceColumns } from "../data.ts";
import type { Result } from "./result.ts";

/** What tells one piece from another: its drawing and its pose. */
function poseKey(result: Result, piece: number): string {
  const { shapes, pieces } = result.data;
  const columns: (keyof PieceColumns)[] = ["x_px", "y_px", "scale_px", "rotation_deg", "mirrored"];
  const numbers = columns.map((column) => Math.round(pieces[column][piece]! * 100));
  return `${shapes.name[pieces.shape[piece]!]}\n${shapes.source[pieces.shape[piece]!]}\n${numbers.join(",")}`;
}

/** For each piece of a result, 1 if `base` has the same drawing at the same place, so that base's picture shows it. */
export function unchangedPieces(result: Result, base: Result): Uint8Array {
  const known = new Set(base.data.pieces.shape.map((_shape, piece) => poseKey(base, piece)));
  return Uint8Array.from(result.data.pieces.shape, (_shape, piece) => (known.has(poseKey(result, piece)) ? 1 : 0));
}
