import { unchangedPieces } from "../model/changes.ts";
import { flatColour } from "../model/ramp.ts";
import type { Result } from "../model/result.ts";
import type { Box } from "../model/outlines.ts";
import type { Frame, Layer, Work } from "./frame.ts";
import { MaskedPicture } from "./masked_picture.ts";
import { PictureLayer } from "./picture_layer.ts";
import { Pyramid } from "./pyramid.ts";

/** The collage itself: its picture, the part of another result's picture that still holds, or pieces in flat colours. */
export class PictureBase implements Layer {
  /** Of 1: how strongly the picture shows; the rest is the paper's colour. */
  strength = 1;
  private readonly whole: PictureLayer | null;
  private readonly masked: MaskedPicture;
  private readonly growth: { count: number };

  /** `base` lends its picture to a result that has none yet. */
  constructor(
    private readonly result: Result,
    base: Result | null,
    tell: (box: Box) => void,
  ) {
    const { data, source } = result;
    const { width_px, height_px } = data.canvas;
    const pieces = data.pieces.shape.length;
    this.growth = { count: pieces };
    this.whole = data.picture ? new PictureLayer(new Pyramid(data.picture, source), width_px, height_px, tell) : null;
    const lent = !this.whole && base?.data.picture ? base : null;
    const kept = lent ? unchangedPieces(result, lent) : new Uint8Array(pieces).fill(this.whole ? 1 : 0);
    const picture = lent ? new PictureLayer(new Pyramid(lent.data.picture!, lent.source), width_px, height_px, tell) : this.whole;
    this.masked = new MaskedPicture(
      result,
      picture,
      (data.picture ?? lent?.data.picture)?.background ?? null,
      this.growth,
      (piece) => kept[piece] === 1,
      (piece) => data.colours[piece] ?? flatColour(data.pieces.shape[piece]!),
      { left: 0, top: 0, right: width_px, bottom: height_px },
    );
  }

  /** Shows only the first pieces in order of placement. */
  showFirst(count: number): void {
    this.growth.count = count;
    this.masked.grown();
  }

  draw(frame: Frame): void {
    this.drawn().draw(frame);
    if (this.strength < 1) this.fade(frame);
  }

  work(frame: Frame, work: Work): boolean {
    return this.drawn().work?.(frame, work) ?? false;
  }

  private drawn(): Layer {
    const complete = this.growth.count === this.result.data.pieces.shape.length;
    return this.whole && complete ? this.whole : this.masked;
  }

  private fade({ context, left, top, scale }: Frame): void {
    const { width_px, height_px } = this.result.data.canvas;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = `rgba(255,255,255,${1 - this.strength})`;
    context.fillRect(left, top, width_px * scale, height_px * scale);
  }
}
