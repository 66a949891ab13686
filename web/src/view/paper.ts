import type { Box } from "../model/outlines.ts";
import { deviceRectangle, type Frame, type Layer, useDevice, type Work } from "./frame.ts";

/** What lies below transparent pictures. The same in light and dark pages, so that a picture looks the same in both. */
export const kPaper = "#ffffff";

export function drawPaper(frame: Frame, box: Box, opacity = 1): void {
  useDevice(frame);
  frame.context.globalAlpha = opacity;
  frame.context.fillStyle = kPaper;
  frame.context.fillRect(...deviceRectangle(frame, box));
  frame.context.globalAlpha = 1;
}

/** A picture on paper. */
export class OnPaper implements Layer {
  constructor(
    private readonly picture: Layer,
    private readonly box: Box,
  ) {}

  draw(frame: Frame): void {
    drawPaper(frame, this.box);
    this.picture.draw(frame);
  }

  work(frame: Frame, work: Work): boolean {
    return this.picture.work?.(frame, work) ?? false;
  }
}
