import { grownBox, movedBox } from "../model/geometry.ts";
import { boxOf } from "../model/outlines.ts";
import type { Result } from "../model/result.ts";
import { contactPainter } from "../view/contact_painter.ts";
import { LiveLayer } from "../view/live_layer.ts";
import { marksPainter } from "../view/marks_painter.ts";
import { freePainter, gapPainter, orderPainter, outlinePainter, overlapPainter, usesPainter } from "../view/painters.ts";
import { PictureBase } from "../view/picture_base.ts";
import { TileLayer } from "../view/tile_layer.ts";
import type { Session } from "./session.ts";

/** A mark's line may reach this far beyond its piece. */
const kMarkMargin_px = 8;

/** While the collage grows, overlays are drawn anew after this time. */
const kOverlaysGrow_ms = 150;

export type OverlayName = "order" | "free" | "gaps" | "overlaps" | "contact" | "outlines";

export interface Layers {
  base: PictureBase;
  overlays: Record<OverlayName, TileLayer>;
}

/** Fills the session's viewer. */
export function addLayers(session: Session, base_result: Result | null): Layers {
  const { result, viewer } = session;
  const { width_px, height_px } = result.data.canvas;
  const world = { left: 0, top: 0, right: width_px, bottom: height_px };
  const redraw = (): void => viewer.redraw();
  const base = new PictureBase(result, base_result, (box) => viewer.redraw(box));
  const shown = {
    get count() {
      return session.growth.get();
    },
  };
  const overlays: Layers["overlays"] = {
    order: new TileLayer(orderPainter(result, shown), world, 0.8),
    free: new TileLayer(freePainter(result, shown), world, 0.85),
    gaps: new TileLayer(gapPainter(result), world, 0.9),
    overlaps: new TileLayer(overlapPainter(result, shown), world),
    outlines: new TileLayer(outlinePainter(result, shown), world),
    contact: new TileLayer(contactPainter(result, shown), world),
  };
  for (const overlay of Object.values(overlays)) overlay.visible = false;
  // A selected piece shall be seen among its neighbours; drawings that someone searched for shall be seen at once.
  const spotlight = (): boolean => session.selected.get() === null && session.highlight.get() !== null;
  const uses = new TileLayer(
    usesPainter(result, () => highlighted(session), spotlight),
    world,
  );
  const marks = new TileLayer(marksPainter(result, session.marks), world);
  viewer.layers.push(base, ...Object.values(overlays), uses, marks);
  viewer.live_layers.push(new LiveLayer(session));

  const overlaysGrow = seldom(() => {
    for (const overlay of [...Object.values(overlays), uses]) overlay.invalidate();
    redraw();
  });
  session.growth.watch((count) => {
    base.showFirst(count);
    overlaysGrow();
    redraw();
  });
  session.highlight.watch(() => {
    uses.reset();
    redraw();
  });
  session.selected.watch(() => {
    uses.invalidate();
    redraw();
  });
  session.marks_changed.watch((changed) => {
    for (const piece of changed) {
      const box = grownBox(boxOf(result.outlines, piece), kMarkMargin_px);
      for (const { dx, dy } of result.index.appearancesOf(piece)) marks.invalidate(movedBox(box, dx, dy));
    }
    redraw();
  });
  for (const value of [session.hovered, session.brush, session.lasso]) value.watch(() => viewer.requestFrame());
  return { base, overlays };
}

/** Calls `action` after the first of several calls that follow each other closely: a tile that starts anew in each frame is never done. */
function seldom(action: () => void): () => void {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    setTimeout(() => {
      waiting = false;
      action();
    }, kOverlaysGrow_ms);
  };
}

/** The marked uses that show, without the selected piece: its own outline says more. */
function highlighted(session: Session): readonly number[] {
  const selected = session.selected.get();
  return (session.highlight.get()?.pieces ?? []).filter((piece) => piece !== selected && piece < session.growth.get());
}
