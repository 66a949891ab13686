import type { Box } from "../model/outlines.ts";
import { boxesMeet } from "../model/geometry.ts";
import { deviceRectangle, type Frame, type Layer, useDevice } from "./frame.ts";
import type { Pyramid } from "./pyramid.ts";

/** A tile's place in its level, and on the world. */
interface Place {
  column: number;
  row: number;
  box: Box;
}

/** Draws a picture from the best tiles that are decoded; what is missing comes as soon as it is. */
export class PictureLayer implements Layer {
  constructor(
    private readonly pyramid: Pyramid,
    /** Where the picture lies in the world. */
    private readonly place: Box,
    tell: (box: Box) => void,
  ) {
    pyramid.addViewer((level, column, row) => tell(this.tileBox(level, column, row)));
  }

  draw(frame: Frame): void {
    const { pyramid } = this;
    useDevice(frame);
    frame.context.imageSmoothingQuality = "medium";
    pyramid.tile(pyramid.coarsest, 0, 0); // always wanted: it stands in for all others
    const level = pyramid.levelFor((this.place.right - this.place.left) * frame.scale);
    for (const place of this.places(level, frame.visible)) {
      const bitmap = pyramid.tile(level, place.column, place.row);
      if (bitmap) frame.context.drawImage(bitmap, ...deviceRectangle(frame, place.box));
      else this.drawSubstitute(frame, level, place);
    }
  }

  /** Asks for the tiles that show: those that stay in sight are drawn seldom, and must not be taken for unused ones. */
  work(frame: Frame): boolean {
    const level = this.pyramid.levelFor((this.place.right - this.place.left) * frame.scale);
    for (const { column, row } of this.places(level, frame.visible)) this.pyramid.tile(level, column, row);
    return false;
  }

  /** The part of the next coarser decoded tile, and above it the finer tiles that are decoded. */
  private drawSubstitute(frame: Frame, level: number, place: Place): void {
    for (let coarser = level + 1; coarser <= this.pyramid.coarsest; ++coarser) {
      const shift = coarser - level;
      const [column, row] = [place.column >> shift, place.row >> shift];
      const bitmap = this.pyramid.decodedTile(coarser, column, row);
      if (!bitmap) continue;
      const whole = this.tileBox(coarser, column, row);
      const x_scale = bitmap.width / (whole.right - whole.left);
      const y_scale = bitmap.height / (whole.bottom - whole.top);
      const part = { x: (place.box.left - whole.left) * x_scale, y: (place.box.top - whole.top) * y_scale };
      const width = Math.min((place.box.right - place.box.left) * x_scale, bitmap.width - part.x);
      const height = Math.min((place.box.bottom - place.box.top) * y_scale, bitmap.height - part.y);
      if (width > 0 && height > 0) frame.context.drawImage(bitmap, part.x, part.y, width, height, ...deviceRectangle(frame, place.box));
      break;
    }
    if (level === 0) return;
    for (const finer of this.places(level - 1, place.box)) {
      const bitmap = this.pyramid.decodedTile(level - 1, finer.column, finer.row);
      if (bitmap && boxesMeet(finer.box, place.box)) frame.context.drawImage(bitmap, ...deviceRectangle(frame, finer.box));
    }
  }

  private tileBox(level: number, column: number, row: number): Box {
    const { tile_px, levels } = this.pyramid.data;
    const { width_px, height_px } = levels[level]!;
    const { x_scale, y_scale } = this.scales(level);
    const { left, top } = this.place;
    return {
      left: left + column * tile_px * x_scale,
      top: top + row * tile_px * y_scale,
      right: left + Math.min(width_px, (column + 1) * tile_px) * x_scale,
      bottom: top + Math.min(height_px, (row + 1) * tile_px) * y_scale,
    };
  }

  /** Px of the world for each px of a level. */
  private scales(level: number): { x_scale: number; y_scale: number } {
    const { width_px, height_px } = this.pyramid.data.levels[level]!;
    const { left, top, right, bottom } = this.place;
    return { x_scale: (right - left) / width_px, y_scale: (bottom - top) / height_px };
  }

  /** The tiles of a level that meet a box. */
  private places(level: number, box: Box): Place[] {
    const { levels, tile_px } = this.pyramid.data;
    const { width_px, height_px } = levels[level]!;
    const { x_scale, y_scale } = this.scales(level);
    const [columns, rows] = [Math.ceil(width_px / tile_px), Math.ceil(height_px / tile_px)];
    const column_of = (x: number): number => (x - this.place.left) / (tile_px * x_scale);
    const row_of = (y: number): number => (y - this.place.top) / (tile_px * y_scale);
    const places: Place[] = [];
    for (let row = Math.max(0, Math.floor(row_of(box.top))); row < Math.min(rows, row_of(box.bottom)); ++row) {
      for (let column = Math.max(0, Math.floor(column_of(box.left))); column < Math.min(columns, column_of(box.right)); ++column) {
        places.push({ column, row, box: this.tileBox(level, column, row) });
      }
    }
    return places;
  }
}
