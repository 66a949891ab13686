import type { Box } from "../model/outlines.ts";
import type { Result } from "../model/result.ts";
import { type Frame, type Layer, partOf, useDevice, useWorld, type Work } from "./frame.ts";
import { type Tile, TileLayer, type TilePainter } from "./tile_layer.ts";
import { tracePiece, traceRegion } from "./trace.ts";

/** Which pieces show: the first `count` in order of placement, and of them those that `wanted` accepts. */
export interface Shown {
  count: number;
  wanted(piece: number): boolean;
}

type Draw = (context: OffscreenCanvasRenderingContext2D, piece: number) => void;

/** Adds the pieces that a tile lacks, in order of placement. `tile.progress` is the number of pieces that it shows; a half more while
 *  the next one is being added, which may be interrupted. */
function growingPainter(result: Result, shown: Shown, draw: Draw): TilePainter {
  return {
    in_place: true,
    *paint(tile: Tile) {
      if (tile.progress > shown.count) {
        tile.context().clearRect(tile.box.left, tile.box.top, tile.box.right - tile.box.left, tile.box.bottom - tile.box.top);
        tile.progress = 0;
      }
      const from = Math.floor(tile.progress);
      const until = shown.count;
      let drawn = 0;
      for (const appearance of result.index.within(tile.box)) {
        const { piece } = appearance;
        if (piece < from || piece >= until || !shown.wanted(piece)) continue;
        tile.progress = piece + 0.5;
        const context = tile.context();
        context.beginPath();
        tracePiece(context, result.outlines, appearance, 0.5 / tile.scale);
        draw(context, piece);
        if (++drawn % 24 === 0) yield;
      }
      tile.progress = until;
    },
  };
}

/** Shows a picture only within some pieces, and the others that show in flat colours. */
export class MaskedPicture implements Layer {
  private readonly mask: TileLayer;
  private readonly flat: TileLayer;
  private readonly scratch = new OffscreenCanvas(1, 1);

  constructor(
    private readonly result: Result,
    private readonly picture: Layer | null,
    private readonly background: string | null,
    private readonly growth: { count: number },
    in_picture: (piece: number) => boolean,
    colour: (piece: number) => string,
    world: Box,
  ) {
    const masked: Shown = {
      get count() {
        return growth.count;
      },
      wanted: in_picture,
    };
    const coloured: Shown = {
      get count() {
        return growth.count;
      },
      wanted: (piece) => !in_picture(piece),
    };
    const cover = growingPainter(result, masked, (context) => {
      // Parts of a pixel add up where two pieces meet in it: no line of background between them.
      context.globalCompositeOperation = "lighter";
      context.fill("evenodd");
    });
    const paint = growingPainter(result, coloured, (context, piece) => {
      context.fillStyle = colour(piece);
      context.fill("evenodd");
    });
    this.mask = new TileLayer(cover, world);
    this.flat = new TileLayer(paint, world);
  }

  /** The number of pieces has changed. */
  grown(): void {
    this.mask.invalidate();
    this.flat.invalidate();
  }

  draw(frame: Frame): void {
    this.drawBackground(frame);
    if (this.growth.count === 0) return;
    if (this.picture) this.drawMasked(frame, this.picture);
    this.flat.draw(frame);
  }

  work(frame: Frame, work: Work): boolean {
    this.picture?.work?.(frame, work);
    const mask_left = this.picture ? this.mask.work(frame, work) : false;
    const flat_left = this.flat.work(frame, work);
    return mask_left || flat_left;
  }

  private drawBackground(frame: Frame): void {
    const { context } = frame;
    const { width_px, height_px } = this.result.data.canvas;
    useWorld(frame);
    context.beginPath();
    traceRegion(context, this.result.region, width_px, height_px);
    context.fillStyle = this.background ?? "#ffffff";
    context.fill("evenodd");
  }

  private drawMasked(frame: Frame, picture: Layer): void {
    const context = this.scratch.getContext("2d")!;
    const { part, left, top } = partOf(frame, context);
    this.scratch.width = part.width; // also empties it
    this.scratch.height = part.height;
    this.mask.draw(part);
    context.globalCompositeOperation = "source-atop";
    picture.draw(part);
    useDevice(frame);
    frame.context.drawImage(this.scratch, left, top);
  }
}
