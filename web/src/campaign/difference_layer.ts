import type { Box } from "../model/outlines.ts";
import { deviceRectangle, type Frame, type Layer, useDevice } from "../view/frame.ts";

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
    frame.context.drawImage(this.one, 0, 0);
    frame.context.restore();
  }

  /** A picture alone, on white as in the result's own file. */
  private drawn(frame: Frame, canvas: OffscreenCanvas, picture: Layer): OffscreenCanvasRenderingContext2D {
    canvas.width = frame.width; // also empties it
    canvas.height = frame.height;
    const context = canvas.getContext("2d")!;
    context.fillStyle = "#ffffff";
    context.fillRect(0, 0, canvas.width, canvas.height);
    picture.draw({ ...frame, context });
    return context;
  }
}
