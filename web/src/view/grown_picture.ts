import { grownBox } from "../model/geometry.ts";
import type { Box } from "../model/outlines.ts";
import type { Result } from "../model/result.ts";
import { type Frame, type Layer, partOf, useDevice, useWorld, type Work } from "./frame.ts";
import type { Shown } from "./painters.ts";
import { type Tile, TileLayer, type TilePainter } from "./tile_layer.ts";
import { traceBeyondRegion, tracePiece, traceRegion } from "./trace.ts";

/** Around a piece that does not show its smooth edge and its shadow shall not show either: px of the canvas. */
const kRim_px = 1.5;
/** The region to fill, where there is no picture of it and it is not the whole canvas. */
const kPlainRegion = "#ecebe7";

/** A picture, the result whose pieces it shows, and the same without its pieces. `gaps`: between pieces the picture shows more than
 *  the bare canvas. */
export interface Pictured {
  result: Result;
  picture: Layer;
  bare: Layer;
  gaps: boolean;
}

type Draw = (context: OffscreenCanvasRenderingContext2D, piece: number) => void;

/** Of `tile.progress`: what lies below all pieces is drawn, but no piece yet. */
const kBegun = 0.25;

/** Adds the pieces that a tile lacks, in order of placement. `tile.progress` is the number of pieces that it shows; a half more while
 *  the next one is being added, which may be interrupted. `begin` draws what lies below all pieces. */
function growingPainter(
  result: Result,
  shown: Shown,
  wanted: (piece: number) => boolean,
  draw: Draw,
  begin: (tile: Tile) => Generator<void, void, void>,
): TilePainter {
  return {
    // Pieces can be added to a tile, but none can be taken away.
    inPlace: (tile) => Math.floor(tile.progress) <= shown.count,
    *paint(tile: Tile) {
      if (tile.progress === 0) yield* begin(tile);
      tile.progress = Math.max(kBegun, tile.progress);
      const from = Math.floor(tile.progress);
      const until = shown.count;
      let drawn = 0;
      for (const appearance of result.index.within(tile.box)) {
        const { piece } = appearance;
        if (piece < from || piece >= until || !wanted(piece)) continue;
        tile.progress = piece + 0.5;
        const context = tile.context();
        context.beginPath();
        tracePiece(context, result.outlines, appearance, 0.5 / tile.scale);
        draw(context, piece);
        if (++drawn % 24 === 0) yield;
      }
      tile.progress = Math.max(kBegun, until);
    },
  };
}

/** Covers what lies beyond the region to fill. */
function coverBeyond(result: Result, tile: Tile): void {
  const context = tile.context();
  context.globalCompositeOperation = "source-over";
  context.beginPath();
  traceBeyondRegion(context, result.region, tile.box);
  context.fill("evenodd");
}

/** Covers a tile but for all pieces of a picture and a rim around them. */
function* coverGaps(result: Result, tile: Tile): Generator<void, void, void> {
  const { left, top, right, bottom } = tile.box;
  const context = tile.context();
  context.globalCompositeOperation = "source-over";
  context.fillRect(left, top, right - left, bottom - top);
  context.lineJoin = "bevel"; // of thousands of pieces; nobody sees the corners
  context.lineWidth = 2 * kRim_px;
  for (const [position, appearance] of result.index.within(grownBox(tile.box, kRim_px)).entries()) {
    context.globalCompositeOperation = "destination-out";
    context.beginPath();
    tracePiece(context, result.outlines, appearance, 0.5 / tile.scale);
    context.fill("evenodd");
    context.stroke();
    if (position % 24 === 23) yield;
  }
}

/** The collage while some of its pieces do not show: in their places the bare canvas. Pieces that are on no picture have flat colours. */
export class GrownPicture implements Layer {
  /** Where the picture shows: beyond the region to fill, between all pieces, and within those that show. */
  private readonly mask: TileLayer;
  private readonly flat: TileLayer;
  private readonly scratches = [0, 1, 2].map(() => new OffscreenCanvas(1, 1));

  constructor(
    private readonly result: Result,
    private readonly pictured: Pictured | null,
    shown: Shown,
    in_picture: (piece: number) => boolean,
    colour: (piece: number) => string,
    world: Box,
  ) {
    const reveal: Draw = (context) => {
      // Parts of a pixel add up where two pieces meet in it: no line of background between them.
      context.globalCompositeOperation = "lighter";
      context.fill("evenodd");
    };
    const paint: Draw = (context, piece) => {
      context.fillStyle = colour(piece);
      context.fill("evenodd");
    };
    const beginMask = function* (tile: Tile): Generator<void, void, void> {
      if (pictured?.gaps) yield* coverGaps(pictured.result, tile);
      coverBeyond(result, tile);
    };
    this.mask = new TileLayer(growingPainter(result, shown, in_picture, reveal, beginMask), world);
    this.flat = new TileLayer(
      growingPainter(
        result,
        shown,
        (piece) => !in_picture(piece),
        paint,
        function* () {},
      ),
      world,
    );
  }

  /** The number of pieces has changed. */
  grown(): void {
    this.mask.invalidate();
    this.flat.invalidate();
  }

  draw(frame: Frame): void {
    if (this.pictured) this.drawPictured(frame, this.pictured);
    else this.drawRegion(frame);
    this.flat.draw(frame);
  }

  work(frame: Frame, work: Work): boolean {
    this.pictured?.picture.work?.(frame, work);
    const mask_left = this.pictured ? this.mask.work(frame, work) : false;
    const flat_left = this.flat.work(frame, work);
    return mask_left || flat_left;
  }

  private drawRegion(frame: Frame): void {
    const { region, data } = this.result;
    if (!region) return;
    useWorld(frame);
    frame.context.beginPath();
    traceRegion(frame.context, region, data.canvas.width_px, data.canvas.height_px);
    frame.context.fillStyle = kPlainRegion;
    frame.context.fill("evenodd");
  }

  /** The picture within the mask, and the bare canvas in the rest. Their parts of a pixel add up, so that nothing shines through. */
  private drawPictured(frame: Frame, { picture, bare }: Pictured): void {
    const [mask, inside, outside] = [this.mask, picture, bare].map((layer, index) => this.drawn(frame, layer, index)) as [
      Drawn,
      Drawn,
      Drawn,
    ];
    inside.globalCompositeOperation = "destination-in";
    inside.drawImage(mask.canvas, 0, 0);
    outside.globalCompositeOperation = "destination-out";
    outside.drawImage(mask.canvas, 0, 0);
    inside.globalCompositeOperation = "lighter";
    inside.drawImage(outside.canvas, 0, 0);
    useDevice(frame);
    const { left, top } = partOf(frame, inside);
    frame.context.drawImage(inside.canvas, left, top);
  }

  /** A layer alone, in the part of the frame that is wanted. */
  private drawn(frame: Frame, layer: Layer, scratch: number): Drawn {
    const canvas = this.scratches[scratch]!;
    const context = canvas.getContext("2d")!;
    const { part } = partOf(frame, context);
    canvas.width = part.width; // also empties it
    canvas.height = part.height;
    layer.draw(part);
    context.setTransform(1, 0, 0, 1, 0, 0);
    return context;
  }
}

type Drawn = OffscreenCanvasRenderingContext2D;
