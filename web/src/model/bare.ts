// The canvas without its pieces, guessed from what shows of it between them ("push-pull" of Gortler et al., The Lumigraph, 1996, 3.4).

/** A picture as sums: weight times red, green, blue (premultiplied) and alpha, and the weight, for each pixel. */
interface Sums {
  width: number;
  height: number;
  values: Float32Array;
}

const kValues = 5;
const kWeight = 4;

/** Fills what `cover` hides of a picture with the colours around it. `pixels` and `cover` are RGBA; of the cover only alpha counts. Returns
 *  null where the cover hides everything: then nothing is known of the canvas. */
export function barePixels(pixels: Uint8ClampedArray, cover: Uint8ClampedArray, width: number, height: number): Uint8ClampedArray | null {
  const levels = [visibleSums(pixels, cover, width, height)];
  for (let top = levels[0]!; top.width > 1 || top.height > 1; top = levels[levels.length - 1]!) levels.push(halved(top));
  if (levels[levels.length - 1]!.values[kWeight] === 0) return null;
  for (let level = levels.length - 2; level >= 0; --level) fillFrom(levels[level]!, levels[level + 1]!);
  return pixelsOf(levels[0]!);
}

function visibleSums(pixels: Uint8ClampedArray, cover: Uint8ClampedArray, width: number, height: number): Sums {
  const values = new Float32Array(kValues * width * height);
  for (let pixel = 0, at = 0; pixel < width * height; ++pixel, at += kValues) {
    const weight = 1 - cover[4 * pixel + 3]! / 255;
    const alpha = (weight * pixels[4 * pixel + 3]!) / 255;
    for (let channel = 0; channel < 3; ++channel) values[at + channel] = alpha * pixels[4 * pixel + channel]!;
    values[at + 3] = 255 * alpha;
    values[at + kWeight] = weight;
  }
  return { width, height, values };
}

/** Adds up two by two pixels. */
function halved({ width, height, values }: Sums): Sums {
  const [half_width, half_height] = [Math.ceil(width / 2), Math.ceil(height / 2)];
  const sums = new Float32Array(kValues * half_width * half_height);
  for (let y = 0, at = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x, at += kValues) {
      const to = kValues * ((y >> 1) * half_width + (x >> 1));
      for (let value = 0; value < kValues; ++value) sums[to + value]! += values[at + value]!;
    }
  }
  return { width: half_width, height: half_height, values: sums };
}

/** Makes means of a level's sums. Where less than a whole pixel was visible, the rest comes from the coarser level, which has means already
 *  (or, as the last one, is a single pixel). */
function fillFrom(level: Sums, coarser: Sums): void {
  const { width, height, values } = level;
  for (let y = 0, at = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x, at += kValues) {
      const weight = values[at + kWeight]!;
      const own = Math.min(1, weight);
      for (let value = 0; value < kWeight; ++value) values[at + value]! *= weight > 0 ? own / weight : 0;
      if (own < 1) addBetween(coarser, x, y, 1 - own, values, at);
      values[at + kWeight] = 1;
    }
  }
}

/** Adds a part of a coarser level's values, in the middle of a pixel of the finer one: between four pixels, so that no squares show. */
function addBetween({ width, height, values }: Sums, x: number, y: number, part: number, to: Float32Array, to_at: number): void {
  const [near_x, near_y] = [x >> 1, y >> 1];
  const far_x = Math.max(0, Math.min(width - 1, near_x + (x & 1 ? 1 : -1)));
  const far_y = Math.max(0, Math.min(height - 1, near_y + (y & 1 ? 1 : -1)));
  addPixel(values, kValues * (near_y * width + near_x), (9 / 16) * part, to, to_at);
  addPixel(values, kValues * (near_y * width + far_x), (3 / 16) * part, to, to_at);
  addPixel(values, kValues * (far_y * width + near_x), (3 / 16) * part, to, to_at);
  addPixel(values, kValues * (far_y * width + far_x), (1 / 16) * part, to, to_at);
}

function addPixel(values: Float32Array, at: number, part: number, to: Float32Array, to_at: number): void {
  const scale = part / values[at + kWeight]!;
  for (let value = 0; value < kWeight; ++value) to[to_at + value]! += scale * values[at + value]!;
}

function pixelsOf({ width, height, values }: Sums): Uint8ClampedArray {
  const pixels = new Uint8ClampedArray(4 * width * height);
  for (let pixel = 0, at = 0; pixel < width * height; ++pixel, at += kValues) {
    const alpha = values[at + 3]! / 255;
    for (let channel = 0; channel < 3; ++channel) pixels[4 * pixel + channel] = alpha > 0 ? values[at + channel]! / alpha : 0;
    pixels[4 * pixel + 3] = values[at + 3]!;
  }
  return pixels;
}
