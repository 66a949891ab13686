import type { Box } from "../model/outlines.ts";
import { deviceRectangle, type Frame, type Layer, partOf, useDevice, type Work } from "../view/frame.ts";

/** The absolute difference of two pictures, pixel by pixel and channel by channel: black where they are equal. The browser computes it
 *  for what shows, from the tiles that both pictures draw anyway. */
export class DifferenceLayer implements Layer {
  /** The difference is multiplied by 2 to this power. */
  doublings = 1;
  private readonly one = new OffscreenCanvas(1, 1);
  private readonly other = new OffscreenCanvas(1, 1);

  constructor(
    private readonly a: Layer,
    private readonly b: Layer,
    private readonly world: Box,
  ) {}

  work(frame: Frame, work: Work): boolean {
    for (const picture of [this.a, this.b]) picture.work?.(frame, work);
    return false;
  }

  draw(frame: Frame): void {
    const first = this.drawn(frame, this.one, this.a);
    this.drawn(frame, this.other, this.b);
    first.globalCompositeOperation = "difference";
    first.drawImage(this.other, 0, 0);
    first.globalCompositeOperation = "lighter";
    for (let doubling = 0; doubling < this.doublings; ++doubling) first.drawImage(this.one, 0, 0);
    useDevice(frame);
    frame.context.save();
    frame.context.beginPath();
    frame.context.rect(...deviceRectangle(frame, this.world));
    frame.context.clip();
    const { left, top } = partOf(frame, first);
    frame.context.drawImage(this.one, left, top);
    frame.context.restore();
  }

  /** A picture alone, on white as in the result's own file. */
  private drawn(frame: Frame, canvas: OffscreenCanvas, picture: Layer): OffscreenCanvasRenderingContext2D {
    const context = canvas.getContext("2d")!;
    const { part } = partOf(frame, context);
    canvas.width = part.width; // also empties it
    canvas.height = part.height;
    context.fillStyle = "#ffffff";
    context.fillRect(0, 0, canvas.width, canvas.height);
    picture.draw(part);
    return context;
  }
}
