import type { Box } from "../model/outlines.ts";
import { deviceRectangle, type Frame, type Layer } from "./frame.ts";

/** Device px of the view. */
type Rectangle = [left: number, top: number, width: number, height: number];

/** If parts of the view must be drawn that are larger than this fraction of it, all of it is drawn. */
const kWholeFraction = 0.7;

/** What the layers of a viewer drew last. While the picture only moves, its pixels are copied to their new place, and the layers draw no
 *  more than what comes into sight and what has changed. So panning takes the same time with many layers as with one. */
export class KeptFrame {
  readonly canvas = new OffscreenCanvas(1, 1);
  private readonly context = this.canvas.getContext("2d")!;
  /** Where the pixels belong; null: nowhere, everything must be drawn. */
  private place: Frame | null = null;
  private changed: Box[] = [];

  /** What lies in `box` of the world, or everything, must be drawn anew. */
  invalidate(box?: Box): void {
    if (box) this.changed.push(box);
    else this.place = null;
  }

  /** Brings the pixels to what `frame` shows. */
  update(frame: Frame, layers: readonly Layer[]): void {
    const kept = { ...frame, context: this.context };
    for (const part of this.partsToDraw(kept)) drawPart(kept, part, layers);
    this.place = kept;
    this.changed = [];
  }

  /** Moves the pixels, and tells what must be drawn then. */
  private partsToDraw(frame: Frame): Rectangle[] {
    const { width, height, scale, left, top } = frame;
    const { place, canvas, changed } = this;
    const whole: Rectangle[] = [[0, 0, width, height]];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    else if (place?.scale === scale) {
      const [dx, dy] = [left - place.left, top - place.top];
      const parts = [...uncovered(frame, dx, dy), ...changed.map((box) => around(frame, box))].filter(([, , w, h]) => w > 0 && h > 0);
      const area = parts.reduce((sum, [, , w, h]) => sum + w * h, 0);
      if (area > kWholeFraction * width * height) return whole;
      if (dx !== 0 || dy !== 0) copyShifted(this.context, canvas, dx, dy);
      return parts;
    }
    return whole;
  }
}

/** Draws a canvas over another one of the same size, which then shows nothing else. */
export function copyShifted(context: Frame["context"], from: CanvasImageSource, dx: number, dy: number): void {
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.globalCompositeOperation = "copy";
  context.drawImage(from, dx, dy);
  context.globalCompositeOperation = "source-over";
}

/** What comes into sight when the picture moves by (dx, dy): a strip at one side, and one above or below. */
function uncovered({ width, height }: Frame, dx: number, dy: number): Rectangle[] {
  const across = Math.min(Math.abs(dx), width);
  const down = Math.min(Math.abs(dy), height);
  return [
    [dx > 0 ? 0 : width - across, 0, across, height],
    [0, dy > 0 ? 0 : height - down, width, down],
  ];
}

/** The part of the view in which a box of the world shows, with all pixels that it touches. */
function around(frame: Frame, box: Box): Rectangle {
  const [left, top, width, height] = deviceRectangle(frame, box);
  const [first_x, first_y] = [Math.max(0, left - 1), Math.max(0, top - 1)];
  return [first_x, first_y, Math.min(frame.width, left + width + 1) - first_x, Math.min(frame.height, top + height + 1) - first_y];
}

function drawPart(frame: Frame, [left, top, width, height]: Rectangle, layers: readonly Layer[]): void {
  const { context, scale } = frame;
  const visible = {
    left: (left - frame.left) / scale,
    top: (top - frame.top) / scale,
    right: (left + width - frame.left) / scale,
    bottom: (top + height - frame.top) / scale,
  };
  context.save();
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.beginPath();
  context.rect(left, top, width, height);
  context.clip();
  context.clearRect(left, top, width, height);
  for (const layer of layers) layer.draw({ ...frame, visible });
  context.restore();
}
