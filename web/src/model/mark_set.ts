import { kFormat, type Marks } from "../data.ts";

export type Mark = "erase" | "lock";

/** The pieces that someone marked, with all steps back to the beginning. */
export class MarkSet {
  private marks: ReadonlyMap<number, Mark> = new Map();
  private readonly history: ReadonlyMap<number, Mark>[] = [];
  private step_open = false;

  get(piece: number): Mark | undefined {
    return this.marks.get(piece);
  }

  get size(): number {
    return this.marks.size;
  }

  get canUndo(): boolean {
    return this.history.length > 0;
  }

  /** Marked pieces of one kind, in order of placement. */
  pieces(mark: Mark): number[] {
    const found = [...this.marks].filter(([, value]) => value === mark);
    return found.map(([piece]) => piece).sort((a, b) => a - b);
  }

  /** All marks from here to the next `beginStep` are undone at once: a stroke is one step. */
  beginStep(): void {
    this.step_open = false;
  }

  /** Marks pieces; null takes their marks away. Returns those that changed. */
  mark(pieces: readonly number[], mark: Mark | null): number[] {
    const changed = pieces.filter((piece) => (this.marks.get(piece) ?? null) !== mark);
    if (changed.length === 0) return changed;
    if (!this.step_open) this.history.push(this.marks);
    this.step_open = true;
    const marks = new Map(this.marks);
    for (const piece of changed) {
      if (mark) marks.set(piece, mark);
      else marks.delete(piece);
    }
    this.marks = marks;
    return changed;
  }

  clear(): number[] {
    this.beginStep();
    return this.mark([...this.marks.keys()], null);
  }

  /** Takes the last step back; returns the pieces whose marks changed. */
  undo(): number[] {
    const before = this.history.pop();
    if (!before) return [];
    this.step_open = false;
    const now = this.marks;
    this.marks = before;
    return [...new Set([...now.keys(), ...before.keys()])].filter((piece) => now.get(piece) !== before.get(piece));
  }

  /** Takes back what has been marked since `beginStep`. */
  cancelStep(): number[] {
    return this.step_open ? this.undo() : [];
  }

  /** As `tessera refine --marks` reads them. */
  toFile(pieces_digest: string, action: Marks["action"]): Marks {
    return { format: kFormat, pieces_digest, action, pieces: this.pieces("erase"), lock: this.pieces("lock") };
  }
}
