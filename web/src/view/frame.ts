import type { Box } from "../model/outlines.ts";

export type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

/** What a layer needs to draw one frame. The canvas is measured in device px, the picture ("world") in px of its own. */
export interface Frame {
  context: Context;
  /** Size of the canvas, device px. */
  width: number;
  height: number;
  /** Device px of a world px, and where the world's origin lies, whole device px: so that pixels can be kept while the picture moves. */
  scale: number;
  left: number;
  top: number;
  /** Device px of a CSS px. */
  pixel_ratio: number;
  /** The part of the world that shows. */
  visible: Box;
}

/** Something that a viewer shows; the first one lies lowest. */
export interface Layer {
  /** Draws what lies in `frame.visible`, at least. */
  draw(frame: Frame): void;
  /** Prepares a part of what `draw` lacks. Returns whether something is left to do. */
  work?(frame: Frame, work: Work): boolean;
}

/** What layers may prepare in one frame. */
export interface Work {
  /** The part of the world to prepare: what shows, or more than that. */
  box: Box;
  /** Of performance.now; shared by all layers. */
  deadline_ms: number;
  /** A layer tells what it would draw otherwise than before. */
  changed(box: Box): void;
}

/** A rectangle of the world in whole device px, so that neighbours meet without a seam. */
export function deviceRectangle(frame: Frame, box: Box): [left: number, top: number, width: number, height: number] {
  const left = Math.round(frame.left + box.left * frame.scale);
  const top = Math.round(frame.top + box.top * frame.scale);
  const right = Math.round(frame.left + box.right * frame.scale);
  const bottom = Math.round(frame.top + box.bottom * frame.scale);
  return [left, top, right - left, bottom - top];
}

/** The part of the canvas that shows `frame.visible`, as a frame of its own: to draw on a further canvas no more than is wanted. `left` and
 *  `top` tell where the part lies on the canvas. */
export function partOf(frame: Frame, context: Context): { part: Frame; left: number; top: number } {
  const [left, top, width, height] = deviceRectangle(frame, frame.visible);
  return { part: { ...frame, context, width, height, left: frame.left - left, top: frame.top - top }, left, top };
}

/** Draws with the context bounded to a box of the world. */
export function drawWithin(frame: Frame, box: Box, draw: () => void): void {
  const { context } = frame;
  context.save();
  useDevice(frame);
  context.beginPath();
  context.rect(...deviceRectangle(frame, box));
  context.clip();
  draw();
  context.restore();
}

/** Lets the context be used in px of the world. */
export function useWorld(frame: Frame): void {
  frame.context.setTransform(frame.scale, 0, 0, frame.scale, frame.left, frame.top);
}

export function useDevice(frame: Frame): void {
  frame.context.setTransform(1, 0, 0, 1, 0, 0);
}
