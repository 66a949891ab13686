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
    private readonly width_px: number,
    private readonly height_px: number,
    tell: (box: Box) => void,
  ) {
    pyramid.addViewer((level, column, row) => tell(this.tileBox(level, column, row)));
  }

  draw(frame: Frame): void {
    const { pyramid } = this;
    useDevice(frame);
    frame.context.imageSmoothingQuality = "medium";
    pyramid.tile(pyramid.coarsest, 0, 0); // always wanted: it stands in for all others
    const level = pyramid.levelFor(this.width_px * frame.scale);
    for (const place of this.places(level, frame.visible)) {
      const bitmap = pyramid.tile(level, place.column, place.row);
      if (bitmap) frame.context.drawImage(bitmap, ...deviceRectangle(frame, place.box));
      else this.drawSubstitute(frame, level, place);
    }
  }

  /** Asks for the tiles that show: those that stay in sight are drawn seldom, and must not be taken for unused ones. */
  work(frame: Frame): boolean {
    const level = this.pyramid.levelFor(this.width_px * frame.scale);
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
    const { levels, tile_px } = this.pyramid.data;
    const { width_px, height_px } = levels[level]!;
    const x_scale = this.width_px / width_px;
    const y_scale = this.height_px / height_px;
    return {
      left: column * tile_px * x_scale,
      top: row * tile_px * y_scale,
      right: Math.min(width_px, (column + 1) * tile_px) * x_scale,
      bottom: Math.min(height_px, (row + 1) * tile_px) * y_scale,
    };
  }

  /** The tiles of a level that meet a box. */
  private places(level: number, box: Box): Place[] {
    const { levels, tile_px } = this.pyramid.data;
    const { width_px, height_px } = levels[level]!;
    const x_scale = width_px / this.width_px / tile_px;
    const y_scale = height_px / this.height_px / tile_px;
    const columns = Math.ceil(width_px / tile_px);
    const rows = Math.ceil(height_px / tile_px);
    const places: Place[] = [];
    for (let row = Math.max(0, Math.floor(box.top * y_scale)); row < Math.min(rows, box.bottom * y_scale); ++row) {
      for (let column = Math.max(0, Math.floor(box.left * x_scale)); column < Math.min(columns, box.right * x_scale); ++column) {
        places.push({ column, row, box: this.tileBox(level, column, row) });
      }
    }
    return places;
  }
}
