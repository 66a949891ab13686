/** Rings as lists of x, y in px -> the bytes of an outline block, as Tessera writes them. */
export function encodeOutlines(pieces: readonly (readonly (readonly [number, number])[])[][]): Uint8Array {
  const bytes: number[] = [];
  const unsigned = (value: number): void => {
    let left = value >>> 0;
    for (; left > 127; left >>>= 7) bytes.push((left & 127) | 128);
    bytes.push(left);
  };
  const signed = (value: number): void => unsigned((value << 1) ^ (value >> 31));
  for (const rings of pieces) {
    let [x, y] = [0, 0];
    unsigned(rings.length);
    for (const ring of rings) {
      unsigned(ring.length);
      for (const [to_x, to_y] of ring) {
        signed(Math.round(to_x * 8) - x);
        signed(Math.round(to_y * 8) - y);
        [x, y] = [Math.round(to_x * 8), Math.round(to_y * 8)];
      }
    }
  }
  return Uint8Array.from(bytes);
}

/** A square as a ring. */
export function square(left: number, top: number, size: number): [number, number][] {
  return [
    [left, top],
    [left + size, top],
    [left + size, top + size],
    [left, top + size],
  ];
}
