// The data that the program writes into a page, and how the page reaches them. The program's side is src/report/ of Tessera:
// who changes a name or a unit here changes it there, too (result_page.cpp, outline_codec.h), and `kFormat` with it.

/** Version of everything in this file. */
export const kFormat = 1;

/** Lengths are px of the canvas (y down, origin at its upper left corner) unless a name says otherwise. */
export type PageData = ResultData | CampaignData;

/** A picture as a pyramid of WebP tiles. Tile (level, column, row) is the block `tile-<picture>-<level>-<column>-<row>`. */
export interface PictureData {
  /** Number of the picture on this page. */
  picture: number;
  /** Size of the result's own collage.png; level 0 may be smaller (the budget of bytes). */
  full_width_px: number;
  full_height_px: number;
  tile_px: number;
  /** The largest first; each further level has half the size, rounded up. The last one is a single tile. */
  levels: { width_px: number; height_px: number }[];
  /** "#rrggbb" of the canvas between the pieces; null: transparent, a picture, or several colours. */
  background: string | null;
}

/** One number for each piece, in order of placement. */
export interface PieceColumns {
  shape: number[]; // index into ResultData.shapes
  group: number[]; // index into ResultData.groups; -1: none
  x_px: number[]; // centroid
  y_px: number[];
  scale_px: number[]; // square root of the area
  rotation_deg: number[];
  score: number[];
  matched_px: number[];
  mirrored: number[]; // 0 or 1
  locked: number[]; // 0 or 1
  area_px2: number[];
}

export interface ResultData {
  format: number;
  kind: "result";
  /** Name of the result's folder, and the folder as on the command line of tessera. */
  name: string;
  folder: string;
  /** "tessera 0.1.0, commit 0123456789ab" that made the result. */
  program: string;
  /** Digest of pieces.geojson, for files of marks. */
  pieces_digest: string;
  finished: boolean;
  canvas: { width_px: number; height_px: number; area_px2: number; repeats_x: boolean; repeats_y: boolean };
  /** Null: there is no picture yet; the page shows the pieces in flat colours. */
  picture: PictureData | null;
  shapes: { name: string[]; source: string[] };
  groups: string[];
  pieces: PieceColumns;
  /** "#rrggbb" for each piece where pieces are silhouettes of one colour; else empty. */
  colours: string[];
  /** Discs that fit into the uncovered area and do not overlap each other, the largest first. */
  gaps: { x_px: number[]; y_px: number[]; radius_px: number[] };
  /** card.json as it is (docs/result-format.md); null where the result has none. */
  card: Record<string, unknown> | null;
  /** How the collage grew, by the clock: seconds, covered fraction. Empty lists where it was not recorded. */
  progress: { s: number[]; coverage: number[] };
  /** job.toml as it is. */
  job: string;
  /** Whether `tessera serve` shows the page, so that it can refine. */
  served: boolean;
}

/** A measure of a campaign's results. */
export interface Measure {
  key: string; // "coverage"
  label: string; // "Coverage"
  unit: string; // "%", "px", "s" or ""
  decimals: number;
  /** Whether more is better; null: a matter of taste. */
  better: "more" | "less" | null;
}

export interface CampaignResult {
  name: string;
  folder: string;
  rank: number; // from 1; equal scores share a rank
  finished: boolean;
  /** One value for each of CampaignData.measures; null: the card lacks it. */
  values: (number | null)[];
  picture: PictureData | null;
}

export interface CampaignData {
  format: number;
  kind: "campaign";
  name: string;
  program: string;
  /** "score = coverage - 2 overlap ..." */
  formula: string;
  measures: Measure[];
  /** Best first. */
  results: CampaignResult[];
}

// Blocks are texts beside the data. On a page each is <script type="text/plain" id="NAME">; base64 of bytes.
//   outlines   pieces in order: varint number of rings; for each ring: varint number of points; for each point zigzag varints
//              dx, dy in units of 1/8 px, from the point before; the first point of a piece from (0, 0), the first point of a later ring
//              from the last point of the ring before. Rings are not closed: the last point differs from the first. The
//              first ring is the outer one, holes follow. Even-odd rule.
//   contact    one byte for each point of `outlines`, in the same order: of the edge from this point to the next one, the mean distance
//              to the nearest other piece or edge of the canvas in units of 1/16 px, 255: too far for contact. A result counts 2 px (32).
//   canvas     outlines of the region to fill, coded like one piece. Absent: the whole rectangle.
//   tile-...   WebP (PictureData)

/** Where data and blocks come from: the page itself, or an answer of the server. */
export interface Source {
  data: PageData;
  /** The bytes of a block; null where there is none. */
  block(name: string): Uint8Array | null;
}

// The server (`tessera serve`, src/serve/ of Tessera). Paths are relative to the page's own URL, which holds the token:
// http://127.0.0.1:PORT/TOKEN/.
// Each POST has the header "X-Tessera: 1" and a JSON body. Errors are {"error": "text"} with a status of 400 or more.
//   GET  state               ServerState
//   GET  data?result=NAME    {"data": ResultData, "blocks": {NAME: base64}}
//   POST refine              RefineRequest -> 202 {"name": NAME} of the new result; one refinement runs at a time (409)
//   POST stop                {} -> 200 {}; stops the running refinement

export interface ServerState {
  results: {
    name: string;
    /** running: its pieces may be there already (has_pieces), its picture is not. */
    state: "finished" | "running" | "stopped" | "failed";
    has_pieces: boolean;
    has_picture: boolean;
    /** The last line of progress, or the error. */
    message: string;
    /** The result that it was refined from; "" for the first one. */
    from: string;
  }[];
}

export interface RefineRequest {
  result: string;
  /** ResultData.pieces_digest of the pieces that the numbers mean; 409 where the result has other ones by now. */
  pieces_digest: string;
  action: "erase" | "swap" | "relax";
  pieces: number[]; // to erase or to swap
  lock: number[];
  /** Seed of the new filling; null: the job's. */
  seed: number | null;
}

/** The file that `tessera refine RESULT --marks FILE` takes. */
export interface Marks {
  format: number;
  pieces_digest: string;
  action: "erase" | "swap" | "relax";
  pieces: number[];
  lock: number[];
}
