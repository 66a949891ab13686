import { barePixels } from "../model/bare.ts";
import type { Box } from "../model/outlines.ts";
import type { Result } from "../model/result.ts";
import { deviceRectangle, type Frame, type Layer, useDevice } from "./frame.ts";
import { kPaper } from "./paper.ts";
import type { Pyramid } from "./pyramid.ts";
import { traceBeyondRegion, tracePiece } from "./trace.ts";

/** The bare canvas is made from a level of the picture that is no larger: it has colours to spread, not details to keep. */
const kLargestSide_px = 1600;
/** Around a piece its smooth edge and its shadow spoil the canvas: so wide, px of the level, it counts for nothing, or for little. */
const kSpoilt_px = 1.5;
const kDoubtful_px = 5;
const kDoubt = 0.95;

type Pixels = Uint8ClampedArray;

const makeContext = (width: number, height: number): OffscreenCanvasRenderingContext2D =>
  new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true })!;

const pause = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/** The canvas as it looks without pieces, within the region to fill: in its colour. Where it has no single one, it is guessed from the gaps
 *  of the picture: the regions' colours, or the picture of a ground, are not on the page. */
export class BareCanvas implements Layer {
  private picture: OffscreenCanvas | null = null;
  private begun = false;

  constructor(
    private readonly result: Result,
    private readonly pyramid: Pyramid,
    private readonly world: Box,
    private readonly tell: (box: Box) => void,
  ) {}

  draw(frame: Frame): void {
    if (!this.begun && this.pyramid.data.background === null) void this.make();
    useDevice(frame);
    if (this.picture) frame.context.drawImage(this.picture, ...deviceRectangle(frame, this.world));
    else this.drawPlain(frame);
  }

  /** The known colour; paper until the canvas is made, and where pieces cover everything. */
  private drawPlain(frame: Frame): void {
    frame.context.fillStyle = this.pyramid.data.background ?? kPaper;
    frame.context.fillRect(...deviceRectangle(frame, this.world));
  }

  /** In steps of some 100 ms at most, between which the page may do other things. */
  private async make(): Promise<void> {
    this.begun = true;
    const level = this.level();
    const { width_px: width, height_px: height } = this.pyramid.data.levels[level]!;
    const picture = makeContext(width, height);
    await this.drawLevel(picture, level);
    const cover = await this.drawCover(width, height);
    const [pixels, hidden] = [picture, cover].map((context) => context.getImageData(0, 0, width, height).data) as [Pixels, Pixels];
    await pause();
    const bare = barePixels(pixels, hidden, width, height);
    if (!bare) return;
    picture.putImageData(new ImageData(bare as ImageDataArray, width, height), 0, 0);
    this.picture = picture.canvas;
    this.tell(this.world);
  }

  private level(): number {
    const { levels } = this.pyramid.data;
    const small = levels.findIndex(({ width_px, height_px }) => Math.max(width_px, height_px) <= kLargestSide_px);
    return small < 0 ? levels.length - 1 : small;
  }

  private async drawLevel(context: OffscreenCanvasRenderingContext2D, level: number): Promise<void> {
    const { levels, tile_px } = this.pyramid.data;
    for (let row = 0; row * tile_px < levels[level]!.height_px; ++row) {
      for (let column = 0; column * tile_px < levels[level]!.width_px; ++column) {
        const bitmap = await this.pyramid.decoded(level, column, row);
        if (bitmap) context.drawImage(bitmap, column * tile_px, row * tile_px);
        bitmap?.close();
      }
    }
  }

  /** Alpha tells how little a pixel says about the canvas. */
  private async drawCover(width: number, height: number): Promise<OffscreenCanvasRenderingContext2D> {
    const doubtful = this.drawPieces(width, height, kDoubtful_px);
    await pause();
    const cover = this.drawPieces(width, height, kSpoilt_px);
    // No piece lies beyond the region to fill: what is there must not run into the region.
    cover.beginPath();
    traceBeyondRegion(cover, this.result.region, this.world);
    cover.fill("evenodd");
    cover.setTransform(1, 0, 0, 1, 0, 0);
    cover.globalAlpha = kDoubt;
    cover.drawImage(doubtful.canvas, 0, 0);
    return cover;
  }

  /** All pieces in black, with a rim around them. */
  private drawPieces(width: number, height: number, rim_px: number): OffscreenCanvasRenderingContext2D {
    const context = makeContext(width, height);
    const { result, world } = this;
    const unit = world.right / width;
    context.scale(1 / unit, height / world.bottom);
    context.lineJoin = "bevel"; // of thousands of pieces; nobody sees the corners
    context.lineWidth = 2 * rim_px * unit;
    for (const appearance of result.index.within(world)) {
      context.beginPath();
      tracePiece(context, result.outlines, appearance, 0.5 * unit);
      context.stroke();
      context.fill("evenodd");
    }
    return context;
  }
}
