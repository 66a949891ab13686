import type { Result } from "../model/result.ts";
import { tracePiece } from "../view/trace.ts";

const kLongestSide_px = 4096;

/** A transparent picture of the canvas with some pieces in red, as `tessera refine --erase` reads it. */
export function maskPicture(result: Result, pieces: readonly number[]): Promise<Blob> {
  const { width_px, height_px } = result.data.canvas;
  const scale = Math.min(1, kLongestSide_px / Math.max(width_px, height_px));
  const canvas = new OffscreenCanvas(Math.max(1, Math.round(width_px * scale)), Math.max(1, Math.round(height_px * scale)));
  const context = canvas.getContext("2d")!;
  context.scale(canvas.width / width_px, canvas.height / height_px);
  context.fillStyle = "#ff0000";
  for (const piece of pieces) {
    for (const appearance of result.index.appearancesOf(piece)) {
      context.beginPath();
      tracePiece(context, result.outlines, appearance, 0);
      context.fill("evenodd");
    }
  }
  makeOpaque(context);
  return canvas.convertToBlob({ type: "image/png" });
}

/** Edges are smooth, but a mask knows only yes and no: what is red by half or more becomes red, the rest clear. */
function makeOpaque(context: OffscreenCanvasRenderingContext2D): void {
  const { width, height } = context.canvas;
  const image = context.getImageData(0, 0, width, height);
  for (let at = 0; at < image.data.length; at += 4) {
    const marked = image.data[at + 3]! >= 128;
    image.data[at] = marked ? 255 : 0;
    image.data[at + 3] = marked ? 255 : 0;
  }
  context.putImageData(image, 0, 0);
}
