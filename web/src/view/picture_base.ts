import { unchangedPieces } from "../model/changes.ts";
import type { Box } from "../model/outlines.ts";
import { flatColour } from "../model/ramp.ts";
import type { Result } from "../model/result.ts";
import { BareCanvas } from "./bare_canvas.ts";
import type { Frame, Layer, Work } from "./frame.ts";
import { GrownPicture, type Pictured } from "./grown_picture.ts";
import { drawPaper } from "./paper.ts";
import { PictureLayer } from "./picture_layer.ts";
import { Pyramid } from "./pyramid.ts";

/** The collage itself on paper: its picture, the part of another result's picture that still holds, or pieces in flat colours. */
export class PictureBase implements Layer {
  /** Of 1: how strongly the picture shows; the rest is the paper's colour. */
  strength = 1;
  private readonly world: Box;
  private readonly whole: Layer | null;
  private readonly grown: GrownPicture;
  private readonly growth: { count: number };

  /** `base` lends its picture to a result that has none yet. */
  constructor(
    private readonly result: Result,
    base: Result | null,
    tell: (box: Box) => void,
  ) {
    const { data } = result;
    const pieces = data.pieces.shape.length;
    this.world = { left: 0, top: 0, right: data.canvas.width_px, bottom: data.canvas.height_px };
    this.growth = { count: pieces };
    const own = picturedBy(result, this.world, tell);
    const lent = !own && base ? picturedBy(base, this.world, tell) : null;
    const kept = lent ? unchangedPieces(result, lent.result) : new Uint8Array(pieces).fill(own ? 1 : 0);
    this.whole = own?.picture ?? null;
    this.grown = new GrownPicture(
      result,
      own ?? lent,
      this.growth,
      (piece) => kept[piece] === 1,
      (piece) => data.colours[piece] ?? flatColour(data.pieces.shape[piece]!),
      this.world,
    );
  }

  /** Shows only the first pieces in order of placement. */
  showFirst(count: number): void {
    this.growth.count = count;
    this.grown.grown();
  }

  draw(frame: Frame): void {
    drawPaper(frame, this.world);
    this.drawn().draw(frame);
    if (this.strength < 1) drawPaper(frame, this.world, 1 - this.strength);
  }

  work(frame: Frame, work: Work): boolean {
    return this.drawn().work?.(frame, work) ?? false;
  }

  private drawn(): Layer {
    const complete = this.growth.count === this.result.data.pieces.shape.length;
    return this.whole && complete ? this.whole : this.grown;
  }
}

/** A result's picture; null if it has none. */
function picturedBy(result: Result, world: Box, tell: (box: Box) => void): Pictured | null {
  const { picture } = result.data;
  if (!picture) return null;
  const pyramid = new Pyramid(picture, result.source);
  return {
    result,
    picture: new PictureLayer(pyramid, world, tell),
    bare: new BareCanvas(result, pyramid, world, tell),
    gaps: picture.background === null,
  };
}
