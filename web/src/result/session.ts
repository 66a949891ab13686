import type { Point } from "../model/geometry.ts";
import { MarkSet } from "../model/mark_set.ts";
import { boxOf } from "../model/outlines.ts";
import { pieceName, type Result } from "../model/result.ts";
import { announce } from "../ui/announce.ts";
import { spokenName } from "../ui/dom.ts";
import { Value } from "../util/value.ts";
import { Viewer } from "../view/viewer.ts";

export type Tool = "pan" | "click" | "scribble" | "lasso";

/** Pieces that are marked on the picture, because they have something in common. */
export interface Highlight {
  label: string;
  pieces: readonly number[];
}

/** All that the parts of the page know together about the result that shows. */
export class Session {
  readonly viewer: Viewer;
  readonly selected = new Value<number | null>(null);
  readonly hovered = new Value<number | null>(null);
  readonly highlight = new Value<Highlight | null>(null);
  /** The pieces whose marks changed last. */
  readonly marks_changed = new Value<readonly number[]>([]);
  /** The first pieces in order of placement show. */
  readonly growth: Value<number>;
  readonly tool = new Value<Tool>("pan");
  readonly brush_px = new Value(24); // CSS px
  readonly mark_kind = new Value<"erase" | "lock" | "none">("erase");
  readonly swap = new Value(false);
  /** Of the new filling; null: the job's. */
  readonly seed = new Value<number | null>(null);
  /** Whether the last step left pieces out that cannot be erased. */
  readonly left_out = new Value(false);
  /** The way of the lasso so far, and where the brush is: px of the canvas. */
  readonly lasso = new Value<readonly Point[]>([]);
  readonly brush = new Value<Point | null>(null);

  constructor(
    readonly result: Result,
    readonly marks = new MarkSet(),
  ) {
    const { width_px, height_px } = result.data.canvas;
    this.viewer = new Viewer(width_px, height_px);
    this.growth = new Value(result.data.pieces.shape.length);
  }

  /** Goes on with the tools of another session. */
  takeTools(from: Session): void {
    this.tool.set(from.tool.get());
    this.brush_px.set(from.brush_px.get());
    this.mark_kind.set(from.mark_kind.get());
    this.seed.set(from.seed.get());
  }

  get pieces(): number {
    return this.result.data.pieces.shape.length;
  }

  /** Selects a piece; all uses of its drawing are marked then. */
  select(piece: number | null): void {
    this.selected.set(piece);
    if (piece === null) {
      this.highlight.set(null);
      return;
    }
    const name = pieceName(this.result, piece);
    const uses = this.result.uses[this.result.data.pieces.shape[piece]!]!;
    this.highlight.set({ label: name, pieces: uses });
    announce(`Piece ${piece}, ${spokenName(name)}. Its drawing is used ${uses.length === 1 ? "once" : `${uses.length} times`}.`);
  }

  zoomTo(pieces: readonly number[]): void {
    const boxes = pieces.map((piece) => boxOf(this.result.outlines, piece));
    const around = {
      left: Math.min(...boxes.map((box) => box.left)),
      top: Math.min(...boxes.map((box) => box.top)),
      right: Math.max(...boxes.map((box) => box.right)),
      bottom: Math.max(...boxes.map((box) => box.bottom)),
    };
    if (pieces.length > 0) this.viewer.showBox(around, pieces.length === 1 ? 0.3 : 0.9);
  }

  /** Whether a piece stood from the start: the program refuses to erase it. */
  isFixed(piece: number): boolean {
    return this.result.data.pieces.locked[piece] === 1;
  }

  /** All marks from here to the next `beginStep` are undone at once: a stroke is one step. */
  beginStep(): void {
    this.marks.beginStep();
    this.left_out.set(false);
  }

  /** Marks pieces as `mark_kind` says. */
  mark(pieces: readonly number[]): void {
    const kind = this.mark_kind.get();
    const possible = kind === "erase" ? pieces.filter((piece) => !this.isFixed(piece)) : pieces;
    this.marked(this.marks.mark(possible, kind === "none" ? null : kind));
    if (possible.length < pieces.length) this.left_out.set(true);
  }

  undo(): void {
    this.left_out.set(false);
    this.marked(this.marks.undo());
  }

  clearMarks(): void {
    this.left_out.set(false);
    this.marked(this.marks.clear());
  }

  /** Marks a piece, or takes the mark away if it has this mark already. */
  toggleMark(piece: number): void {
    const kind = this.mark_kind.get();
    this.beginStep();
    if (this.marks.get(piece) === kind) this.marked(this.marks.mark([piece], null));
    else this.mark([piece]);
  }

  marked(changed: readonly number[]): void {
    if (changed.length > 0) this.marks_changed.set(changed);
  }
}
