/** The outlines of all pieces (or of the region to fill, as one piece), px of the canvas. */
export interface Outlines {
  /** x, y, x, y, ... */
  points: Float32Array;
  /** First point of each ring; one more at the end. */
  ring_starts: Uint32Array;
  /** First ring of each piece; one more at the end. */
  piece_starts: Uint32Array;
  /** Left, top, right, bottom of each piece. */
  boxes: Float32Array;
}

export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

const kUnitsPerPixel = 8;

/** Reads varints (7 bits a byte, the lowest first), plain and zigzag. */
class VarintReader {
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {}

  atEnd(): boolean {
    return this.at >= this.bytes.length;
  }

  unsigned(): number {
    let value = 0;
    for (let shift = 0; shift < 35; shift += 7) {
      const byte = this.bytes[this.at++];
      if (byte === undefined) break;
      value |= (byte & 127) << shift;
      if (byte < 128) return value >>> 0;
    }
    throw new Error("the outlines of this page are damaged");
  }

  signed(): number {
    const value = this.unsigned();
    return (value >>> 1) ^ -(value & 1);
  }
}

/** Decodes a block of `data.ts`. */
export function decodeOutlines(bytes: Uint8Array): Outlines {
  const reader = new VarintReader(bytes);
  // A point takes two bytes at least, so that this many numbers are always enough.
  const points = new Float32Array(bytes.length);
  const ring_starts: number[] = [];
  const piece_starts: number[] = [];
  let next = 0;
  while (!reader.atEnd()) {
    piece_starts.push(ring_starts.length);
    let x = 0;
    let y = 0;
    for (let rings = reader.unsigned(); rings > 0; --rings) {
      ring_starts.push(next / 2);
      for (let left = reader.unsigned(); left > 0; --left) {
        x += reader.signed();
        y += reader.signed();
        points[next++] = x / kUnitsPerPixel;
        points[next++] = y / kUnitsPerPixel;
      }
    }
  }
  piece_starts.push(ring_starts.length);
  ring_starts.push(next / 2);
  const outlines: Outlines = {
    points: points.slice(0, next),
    ring_starts: Uint32Array.from(ring_starts),
    piece_starts: Uint32Array.from(piece_starts),
    boxes: new Float32Array(0),
  };
  outlines.boxes = boxesOf(outlines);
  return outlines;
}

function boxesOf(outlines: Outlines): Float32Array {
  const pieces = pieceCount(outlines);
  const boxes = new Float32Array(4 * pieces);
  for (let piece = 0; piece < pieces; ++piece) {
    let left = Infinity;
    let top = Infinity;
    let right = -Infinity;
    let bottom = -Infinity;
    const [first, end] = pointRange(outlines, piece);
    for (let point = first; point < end; ++point) {
      const x = outlines.points[2 * point]!;
      const y = outlines.points[2 * point + 1]!;
      if (x < left) left = x;
      if (x > right) right = x;
      if (y < top) top = y;
      if (y > bottom) bottom = y;
    }
    boxes.set([left, top, right, bottom], 4 * piece);
  }
  return boxes;
}

export function pieceCount(outlines: Outlines): number {
  return outlines.piece_starts.length - 1;
}

/** First point of a piece, and the one after its last. */
export function pointRange(outlines: Outlines, piece: number): [number, number] {
  const first_ring = outlines.piece_starts[piece]!;
  const end_ring = outlines.piece_starts[piece + 1]!;
  return [outlines.ring_starts[first_ring]!, outlines.ring_starts[end_ring]!];
}

/** Calls `visit` with the first point of each ring of a piece, and the one after its last. */
export function eachRing(outlines: Outlines, piece: number, visit: (first: number, end: number) => void): void {
  const end_ring = outlines.piece_starts[piece + 1]!;
  for (let ring = outlines.piece_starts[piece]!; ring < end_ring; ++ring) {
    visit(outlines.ring_starts[ring]!, outlines.ring_starts[ring + 1]!);
  }
}

export function boxOf(outlines: Outlines, piece: number): Box {
  const [left, top, right, bottom] = outlines.boxes.subarray(4 * piece, 4 * piece + 4) as unknown as [number, number, number, number];
  return { left, top, right, bottom };
}
