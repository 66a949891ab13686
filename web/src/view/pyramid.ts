import type { PictureData, Source } from "../data.ts";

/** Bitmaps of all pictures of the page together, pixels: 24 million take 96 MB. */
const kBudget_pixels = 24e6;
const kDecodesAtOnce = 4;

interface Entry {
  bitmap: ImageBitmap | null;
  state: "wanted" | "decoding" | "ready" | "absent";
  used: number;
  place: [level: number, column: number, row: number];
  pyramid: Pyramid;
}

/** Decoded tiles of all pictures, the latest used ones, within a budget. */
class TileStore {
  private readonly entries = new Map<string, Entry>();
  private readonly queue: Entry[] = [];
  private decoding = 0;
  private pixels = 0;
  private clock = 0;

  /** The tile if it is decoded; else it is decoded soon, and the pyramid then tells its viewers. */
  get(pyramid: Pyramid, place: Entry["place"]): ImageBitmap | null {
    const key = keyOf(pyramid, place);
    let entry = this.entries.get(key);
    if (!entry) {
      entry = { bitmap: null, state: "wanted", used: 0, place, pyramid };
      this.entries.set(key, entry);
      this.queue.push(entry);
      this.startDecoding();
    }
    entry.used = ++this.clock;
    return entry.bitmap;
  }

  /** The tile if it is decoded; asks for nothing. */
  peek(pyramid: Pyramid, place: Entry["place"]): ImageBitmap | null {
    return this.entries.get(keyOf(pyramid, place))?.bitmap ?? null;
  }

  private startDecoding(): void {
    while (this.decoding < kDecodesAtOnce && this.queue.length > 0) {
      // The latest wish first: it is what shows now.
      const entry = this.queue.pop()!;
      ++this.decoding;
      void this.decode(entry);
    }
  }

  private async decode(entry: Entry): Promise<void> {
    entry.state = "decoding";
    entry.bitmap = await entry.pyramid.decoded(...entry.place);
    entry.state = entry.bitmap ? "ready" : "absent";
    this.pixels += entry.bitmap ? entry.bitmap.width * entry.bitmap.height : 0;
    --this.decoding;
    this.dropOldest();
    this.startDecoding();
    entry.pyramid.tellViewers(...entry.place);
  }

  private dropOldest(): void {
    if (this.pixels <= kBudget_pixels) return;
    const by_age = [...this.entries].filter(([, entry]) => entry.state === "ready").sort(([, a], [, b]) => a.used - b.used);
    for (const [key, { bitmap }] of by_age) {
      if (this.pixels <= 0.8 * kBudget_pixels) break;
      this.pixels -= bitmap!.width * bitmap!.height;
      bitmap!.close();
      this.entries.delete(key);
    }
  }
}

const keyOf = (pyramid: Pyramid, place: Entry["place"]): string => `${pyramid.id}/${place.join("-")}`;

const store = new TileStore();
let pyramids = 0;

/** A picture in tiles that are decoded when they are needed. */
export class Pyramid {
  readonly id = ++pyramids;
  private readonly viewers = new Set<(level: number, column: number, row: number) => void>();

  constructor(
    readonly data: PictureData,
    readonly source: Source,
  ) {}

  /** `tell` is called whenever a tile has been decoded. */
  addViewer(tell: (level: number, column: number, row: number) => void): void {
    this.viewers.add(tell);
  }

  tellViewers(level: number, column: number, row: number): void {
    for (const tell of this.viewers) tell(level, column, row);
  }

  tile(level: number, column: number, row: number): ImageBitmap | null {
    return store.get(this, [level, column, row]);
  }

  decodedTile(level: number, column: number, row: number): ImageBitmap | null {
    return store.peek(this, [level, column, row]);
  }

  /** A bitmap of the caller's own. Null where there is no tile, or a damaged one: the level above it shows instead. */
  async decoded(level: number, column: number, row: number): Promise<ImageBitmap | null> {
    try {
      const bytes = this.block(level, column, row);
      return bytes ? await createImageBitmap(new Blob([bytes as BlobPart], { type: "image/webp" })) : null;
    } catch {
      return null;
    }
  }

  get coarsest(): number {
    return this.data.levels.length - 1;
  }

  /** The smallest level that has at least `width_px` pixels across, or nearly so. */
  levelFor(width_px: number): number {
    for (let level = this.coarsest; level > 0; --level) {
      if (this.data.levels[level]!.width_px >= 0.9 * width_px) return level;
    }
    return 0;
  }

  /** The bytes of a tile; null where there are none. */
  private block(level: number, column: number, row: number): Uint8Array | null {
    return this.source.block(`tile-${this.data.picture}-${level}-${column}-${row}`);
  }
}
