import type { Box } from "../model/outlines.ts";
import { boxesMeet } from "../model/geometry.ts";
import { deviceRectangle, drawWithin, type Frame, type Layer, type Work } from "./frame.ts";

const kTile_px = 512;
/** Two steps of level double the scale: a tile is drawn at 0.7 to 1 times its own size. */
const kLevelsPerOctave = 2;
/** Cached tiles of a layer: 32 take 32 MB. */
const kMostTiles = 36;

/** A tile as its painter sees it. */
export interface Tile {
  /** Its part of the world, and px of the tile for each px of the world. */
  box: Box;
  scale: number;
  /** For the painter's own use; 0 in a new tile. */
  progress: number;
  /** The tile's context, transformed to px of the world. A tile that never asks for it takes no memory. */
  context(): OffscreenCanvasRenderingContext2D;
  /** A further canvas of the same size and transform, to compose the tile with. */
  scratch(): OffscreenCanvasRenderingContext2D;
  /** Of the tile, px. */
  size_px: number;
}

export interface TilePainter {
  /** Draws a tile bit by bit: at each yield the work may pause until the next frame. */
  paint(tile: Tile): Generator<void, void, void>;
  /** Whether a change is drawn over what the tile shows already, instead of onto an empty one. */
  inPlace?(tile: Tile): boolean;
}

class CachedTile implements Tile {
  progress = 0;
  canvas: OffscreenCanvas | null = null;
  readonly size_px = kTile_px;
  private readonly scratches: OffscreenCanvasRenderingContext2D[] = [];

  constructor(
    readonly box: Box,
    readonly scale: number,
  ) {}

  context(): OffscreenCanvasRenderingContext2D {
    this.canvas ??= new OffscreenCanvas(kTile_px, kTile_px);
    return this.transformed(this.canvas);
  }

  scratch(): OffscreenCanvasRenderingContext2D {
    const context = this.transformed(new OffscreenCanvas(kTile_px, kTile_px));
    this.scratches.push(context);
    return context;
  }

  /** Lets the browser do now what it was told to draw. It likes to put that off, and the clock would then know nothing of it. */
  settle(): void {
    if (this.canvas) this.context().getImageData(0, 0, 1, 1);
    for (const context of this.scratches) context.getImageData(0, 0, 1, 1);
  }

  /** Gives the memory of the further canvases back. */
  finish(): void {
    this.scratches.length = 0;
  }

  private transformed(canvas: OffscreenCanvas): OffscreenCanvasRenderingContext2D {
    // Reading back is what `settle` does, and the overlaps.
    const context = canvas.getContext("2d", { willReadFrequently: true })!;
    context.setTransform(this.scale, 0, 0, this.scale, -this.box.left * this.scale, -this.box.top * this.scale);
    return context;
  }
}

interface Slot {
  level: number;
  box: Box;
  /** What shows, and what is being drawn to replace it. */
  shown: CachedTile | null;
  next: CachedTile | null;
  job: Generator<void, void, void> | null;
  stale: boolean;
  used: number;
}

/** Vectors over the picture. They are drawn into tiles of the screen's resolution in small portions, so that panning only copies pixels. */
export class TileLayer implements Layer {
  visible = true;
  private readonly slots = new Map<string, Slot>();
  private complete_level = 0;
  private clock = 0;

  constructor(
    private readonly painter: TilePainter,
    private readonly world: Box,
    private readonly opacity = 1,
  ) {}

  /** What lies in `box` (or anywhere) has changed. The old drawing shows until the new one is ready. */
  invalidate(box?: Box): void {
    for (const slot of this.slots.values()) {
      if (box && !boxesMeet(box, slot.box)) continue;
      slot.stale = true;
      slot.job = null;
      slot.next = null;
    }
  }

  /** Forgets everything that is drawn, at once. */
  reset(): void {
    this.slots.clear();
  }

  draw(frame: Frame): void {
    if (!this.visible) return;
    // The last tiles reach beyond the world; what they have there (on a seamless canvas parts of pieces) must not show.
    drawWithin(frame, this.world, () => {
      frame.context.globalAlpha = this.opacity;
      for (const slot of this.slotsFor(frame.visible, levelFor(frame.scale))) {
        if (slot.shown) this.drawTile(frame, slot.shown);
        else this.drawSubstitute(frame, slot);
      }
    });
  }

  work(frame: Frame, work: Work): boolean {
    if (!this.visible) return false;
    const level = levelFor(frame.scale);
    const slots = this.slotsFor(work.box, level);
    const left = slots.some((slot) => (!slot.shown || slot.stale) && !this.workOn(slot, work));
    if (slots.every((slot) => slot.shown)) this.complete_level = level;
    this.dropOldest(Math.max(kMostTiles, slots.length));
    return left;
  }

  /** Whether the tile is finished. */
  private workOn(slot: Slot, { deadline_ms, changed }: Work): boolean {
    let now_ms = performance.now();
    let step_ms = 0;
    // A step takes about as long as the one before.
    while (now_ms + step_ms < deadline_ms) {
      const done = this.step(slot);
      if (slot.next === slot.shown) changed(slot.box);
      if (done) return true;
      step_ms = performance.now() - now_ms;
      now_ms += step_ms;
    }
    return false;
  }

  /** Draws a portion of a tile. Returns whether the tile is finished; then it shows. */
  private step(slot: Slot): boolean {
    if (!slot.job) {
      const goes_on = slot.shown && this.painter.inPlace?.(slot.shown);
      slot.next = goes_on ? slot.shown! : new CachedTile(slot.box, 2 ** (slot.level / kLevelsPerOctave));
      slot.job = this.painter.paint(slot.next);
    }
    const { done } = slot.job.next();
    slot.next!.settle();
    if (!done) return false;
    slot.next!.finish();
    slot.shown = slot.next;
    slot.job = null;
    slot.stale = false;
    return true;
  }

  private drawTile(frame: Frame, tile: CachedTile): void {
    if (tile.canvas) frame.context.drawImage(tile.canvas, ...deviceRectangle(frame, tile.box));
  }

  /** Tiles of another level in the place of one that is not drawn yet: of the level that was last complete, or of the next coarser one. */
  private drawSubstitute(frame: Frame, missing: Slot): void {
    const others = [...this.slots.values()].filter((slot) => slot.shown?.canvas && boxesMeet(slot.box, missing.box));
    const coarser = others.map(({ level }) => level).filter((level) => level < missing.level);
    const levels = [this.complete_level, Math.max(...coarser)];
    const level = levels.find((wanted) => wanted !== missing.level && others.some((slot) => slot.level === wanted));
    if (level === undefined) return;
    drawWithin(frame, missing.box, () => {
      for (const slot of others) if (slot.level === level) this.drawTile(frame, slot.shown!);
    });
  }

  /** The tiles of a level in a part of the world, those in the middle first. */
  private slotsFor(part: Box, level: number): Slot[] {
    const size = kTile_px / 2 ** (level / kLevelsPerOctave);
    const [left, top] = [Math.max(this.world.left, part.left), Math.max(this.world.top, part.top)];
    const [right, bottom] = [Math.min(this.world.right, part.right), Math.min(this.world.bottom, part.bottom)];
    const slots: Slot[] = [];
    for (let row = Math.floor(top / size); row * size < bottom; ++row) {
      for (let column = Math.floor(left / size); column * size < right; ++column) slots.push(this.slot(level, column, row, size));
    }
    const [x, y] = [(left + right) / 2, (top + bottom) / 2];
    const distance = ({ box }: Slot): number => Math.hypot((box.left + box.right) / 2 - x, (box.top + box.bottom) / 2 - y);
    return slots.sort((a, b) => distance(a) - distance(b));
  }

  private slot(level: number, column: number, row: number, size: number): Slot {
    const key = `${level}/${column}/${row}`;
    let slot = this.slots.get(key);
    if (!slot) {
      const box = { left: column * size, top: row * size, right: (column + 1) * size, bottom: (row + 1) * size };
      slot = { level, box, shown: null, next: null, job: null, stale: false, used: 0 };
      this.slots.set(key, slot);
    }
    slot.used = ++this.clock;
    return slot;
  }

  private dropOldest(most: number): void {
    if (this.slots.size <= 2 * most) return;
    const by_age = [...this.slots].sort(([, a], [, b]) => b.used - a.used);
    for (const [key] of by_age.slice(most)) this.slots.delete(key);
  }
}

function levelFor(scale: number): number {
  return Math.ceil(kLevelsPerOctave * Math.log2(scale) - 1e-6);
}
