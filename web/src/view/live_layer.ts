import { type Box, eachRing } from "../model/outlines.ts";
import { kContactUnits } from "../model/result.ts";
import type { Session } from "../result/session.ts";
import { kMarkColours } from "./marks_painter.ts";
import { drawWithin, type Frame, type Layer, useWorld } from "./frame.ts";
import { tracePiece } from "./trace.ts";

const kContactColour = "#ff7a00";
/** CSS px. */
const kWidestLine_px = 5;

/** What changes with the pointer: the piece below it, the selected one, brush and lasso. */
export class LiveLayer implements Layer {
  constructor(private readonly session: Session) {}

  draw(frame: Frame): void {
    const { session } = this;
    useWorld(frame);
    frame.context.lineJoin = "round";
    frame.context.lineCap = "round";
    drawWithin(frame, this.outlinedBox(frame), () => {
      useWorld(frame);
      const [hovered, selected] = [session.hovered.get(), session.selected.get()];
      if (hovered !== null && hovered !== selected) this.strokeOutline(frame, hovered, 2);
      if (selected !== null) {
        this.strokeOutline(frame, selected, 2.5);
        this.strokeContact(frame, selected);
      }
    });
    this.drawLasso(frame);
    this.drawBrush(frame);
  }

  /** Where outlines show: a line along the edge of the canvas in its full width, but where the canvas repeats, nothing beyond it. */
  private outlinedBox({ pixel_ratio, scale }: Frame): Box {
    const { width_px, height_px, repeats_x, repeats_y } = this.session.result.data.canvas;
    const line = (kWidestLine_px * pixel_ratio) / scale;
    const [x, y] = [repeats_x ? 0 : line, repeats_y ? 0 : line];
    return { left: -x, top: -y, right: width_px + x, bottom: height_px + y };
  }

  /** White within dark: visible on any picture. */
  private strokeOutline(frame: Frame, piece: number, width: number): void {
    const { context, pixel_ratio, scale } = frame;
    const unit = pixel_ratio / scale;
    context.beginPath();
    for (const appearance of this.session.result.index.appearancesOf(piece)) {
      tracePiece(context, this.session.result.outlines, appearance, 0.3 * unit);
    }
    context.strokeStyle = "rgba(8,12,20,0.85)";
    context.lineWidth = (width + 2.5) * unit;
    context.stroke();
    context.strokeStyle = "#ffffff";
    context.lineWidth = width * unit;
    context.stroke();
  }

  /** The parts of the boundary within 2 px of another piece or the edge. */
  private strokeContact(frame: Frame, piece: number): void {
    const { outlines, contact, index } = this.session.result;
    if (!contact) return;
    const { context, pixel_ratio, scale } = frame;
    const { points } = outlines;
    context.beginPath();
    for (const { dx, dy } of index.appearancesOf(piece)) {
      eachRing(outlines, piece, (first, end) => {
        for (let point = first, before = end - 1; point < end; before = point++) {
          if (contact[before]! > kContactUnits) continue;
          context.moveTo(points[2 * before]! + dx, points[2 * before + 1]! + dy);
          context.lineTo(points[2 * point]! + dx, points[2 * point + 1]! + dy);
        }
      });
    }
    context.strokeStyle = kContactColour;
    context.lineWidth = (3 * pixel_ratio) / scale;
    context.stroke();
  }

  private drawLasso(frame: Frame): void {
    const way = this.session.lasso.get();
    if (way.length < 2) return;
    const { context } = frame;
    context.beginPath();
    for (const { x, y } of way) context.lineTo(x, y);
    context.closePath();
    context.fillStyle = "rgba(255,255,255,0.25)";
    context.fill("evenodd");
    this.strokeTool(frame);
  }

  private drawBrush(frame: Frame): void {
    const place = this.session.brush.get();
    if (!place || this.session.tool.get() !== "scribble") return;
    const radius = (this.session.brush_px.get() / 2 / frame.scale) * frame.pixel_ratio;
    frame.context.beginPath();
    frame.context.arc(place.x, place.y, radius, 0, 2 * Math.PI);
    this.strokeTool(frame);
  }

  private strokeTool({ context, pixel_ratio, scale }: Frame): void {
    const kind = this.session.mark_kind.get();
    context.strokeStyle = "#ffffff";
    context.lineWidth = (4 * pixel_ratio) / scale;
    context.stroke();
    context.strokeStyle = kind === "none" ? "#20242c" : kMarkColours[kind];
    context.lineWidth = (2 * pixel_ratio) / scale;
    context.stroke();
  }
}
