import { select } from "d3-selection";
import "d3-transition";
import { type D3ZoomEvent, zoom, type ZoomBehavior, zoomIdentity, type ZoomTransform, zoomTransform } from "d3-zoom";
import type { Point } from "../model/geometry.ts";
import { grownBox } from "../model/geometry.ts";
import type { Box } from "../model/outlines.ts";
import type { Frame, Layer, Work } from "./frame.ts";
import { copyShifted, KeptFrame } from "./kept_frame.ts";

/** All layers together may prepare tiles for this long in each frame: while the picture moves, and while it rests. */
const kWorkMoving_ms = 6;
const kWorkResting_ms = 10;
/** The picture rests when it has not moved for this time. */
const kRest_ms = 120;
/** Tiles are prepared this far beyond the view, device px, so that they are there when the picture moves. */
const kAhead_px = 256;
const kMargin_px = 12;
/** CSS px of a px of the world at most. */
const kLargestScale = 24;

/** A point of the world that is in the middle, and CSS px for each px of the world. */
export interface Place extends Point {
  k: number;
}

/** A canvas on which layers lie, with zoom and pan. Transforms are CSS px for each px of the world. */
export class Viewer {
  readonly canvas = document.createElement("canvas");
  /** Their pixels are kept: who changes what they show calls `redraw`. */
  readonly layers: Layer[] = [];
  /** Above all others; drawn in each frame. */
  readonly live_layers: Layer[] = [];
  /** Who else follows the zoom. */
  readonly followers = new Set<(viewer: Viewer, by_user: boolean) => void>();
  /** Decides whether a pointer may pan now; the wheel and two fingers always zoom. */
  mayPan: () => boolean = () => true;
  /** Whether a double click, or a double tap, zooms in: not where each click does something. */
  zoomsOnDoubleClick: () => boolean = () => true;
  private readonly behavior: ZoomBehavior<HTMLCanvasElement, unknown>;
  private readonly context = this.canvas.getContext("2d")!;
  private size = { width: 0, height: 0 };
  private readonly kept = new KeptFrame();
  private frame_wanted = false;
  private moved_ms = -kRest_ms;
  private at_fit = true;
  /** Where to go once the size is known. */
  private awaited: Place | null = null;

  constructor(
    readonly world_width: number,
    readonly world_height: number,
  ) {
    this.behavior = zoom<HTMLCanvasElement, unknown>()
      .clickDistance(4)
      .filter((event: Event) => this.accepts(event))
      .on("zoom", (event: D3ZoomEvent<HTMLCanvasElement, unknown>) => this.zoomed(event.sourceEvent !== null));
    // d3's own double click would swallow the second click, and takes taps on two pieces close to each other for one double tap.
    select(this.canvas).call(this.behavior).on("dblclick.zoom", null);
    this.canvas.addEventListener("dblclick", (event) => this.doubleClicked(event));
    new ResizeObserver(() => this.resized()).observe(this.canvas);
  }

  get transform(): ZoomTransform {
    return zoomTransform(this.canvas);
  }

  get width(): number {
    return this.size.width;
  }

  get height(): number {
    return this.size.height;
  }

  /** Lets the layers draw anew what lies in a box of the world, or everything. */
  redraw(box?: Box): void {
    this.kept.invalidate(box);
    this.requestFrame();
  }

  /** Shows the layers as they are, and the live layers anew. */
  requestFrame(): void {
    if (this.frame_wanted) return;
    this.frame_wanted = true;
    requestAnimationFrame(() => this.drawFrame());
  }

  fit(animated = true): void {
    this.go(this.fittingTransform(), animated);
  }

  /** `around`: CSS px of the canvas, the point that stays where it is; the middle by default. */
  zoomBy(factor: number, around?: [number, number]): void {
    const target = select(this.canvas);
    if (stillsMotion()) target.call(this.behavior.scaleBy, factor, around);
    else target.transition().duration(160).call(this.behavior.scaleBy, factor, around);
  }

  panBy(dx: number, dy: number): void {
    const { k } = this.transform;
    select(this.canvas).call(this.behavior.translateBy, dx / k, dy / k);
  }

  /** Shows a box in the middle, with some of what lies around it; for a large box the whole picture, but no less. */
  showBox(box: Box, part = 0.3, animated = true): void {
    const across = Math.max(box.right - box.left, 1) / (this.size.width * part);
    const down = Math.max(box.bottom - box.top, 1) / (this.size.height * part);
    const k = Math.min(1 / Math.max(across, down), this.behavior.scaleExtent()[1]);
    if (k <= this.fittingScale()) this.fit(animated);
    else this.go(this.centred((box.left + box.right) / 2, (box.top + box.bottom) / 2, k), animated);
  }

  /** Puts a point of the world into the middle: at once, or as soon as the page is laid out. */
  centre(x: number, y: number, k: number, animated = false): void {
    if (this.size.width === 0) this.awaited = { x, y, k };
    else this.go(this.centred(x, y, k), animated);
  }

  /** The point of the world in the middle. */
  middle(): Point {
    const [x, y] = this.transform.invert([this.size.width / 2, this.size.height / 2]);
    return { x, y };
  }

  /** What shows, for another viewer to show it, too; null: all of the world. */
  place(): Place | null {
    return this.at_fit || this.size.width === 0 ? null : { ...this.middle(), k: this.transform.k };
  }

  /** Where a pointer is on the world. */
  worldPoint(event: MouseEvent): Point {
    const bounds = this.canvas.getBoundingClientRect();
    const [x, y] = this.transform.invert([event.clientX - bounds.left, event.clientY - bounds.top]);
    return { x, y };
  }

  private accepts(event: Event): boolean {
    if (event.type === "wheel") return true;
    if (event.type === "touchstart" && (event as TouchEvent).touches.length > 1) return true;
    if (event instanceof MouseEvent && event.button === 1) return true;
    return this.mayPan() && !(event instanceof MouseEvent && event.button !== 0);
  }

  private doubleClicked(event: MouseEvent): void {
    if (!this.zoomsOnDoubleClick()) return;
    const bounds = this.canvas.getBoundingClientRect();
    this.zoomBy(event.shiftKey ? 0.5 : 2, [event.clientX - bounds.left, event.clientY - bounds.top]);
  }

  private centred(x: number, y: number, k: number): ZoomTransform {
    return zoomIdentity.translate(this.size.width / 2 - x * k, this.size.height / 2 - y * k).scale(k);
  }

  private go(transform: ZoomTransform, animated: boolean): void {
    const target = select(this.canvas);
    if (animated && !stillsMotion()) target.transition().duration(320).call(this.behavior.transform, transform);
    else target.interrupt().call(this.behavior.transform, transform);
  }

  private fittingTransform(): ZoomTransform {
    return this.centred(this.world_width / 2, this.world_height / 2, this.fittingScale());
  }

  /** At this scale the whole picture shows. */
  fittingScale(): number {
    const { width, height } = this.size;
    return Math.max(0.001, Math.min((width - 2 * kMargin_px) / this.world_width, (height - 2 * kMargin_px) / this.world_height));
  }

  private zoomed(by_user: boolean): void {
    const fitting = this.fittingTransform();
    const { k, x, y } = this.transform;
    this.at_fit = Math.abs(k / fitting.k - 1) < 1e-3 && Math.abs(x - fitting.x) < 1 && Math.abs(y - fitting.y) < 1;
    for (const follow of this.followers) follow(this, by_user);
    this.moved_ms = performance.now();
    this.requestFrame();
  }

  /** Keeps the middle in the middle, and the whole picture whole. */
  private resized(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    const first = this.size.width === 0;
    const place = first ? this.awaited : this.place();
    this.size = { width, height };
    this.canvas.width = Math.round(width * devicePixelRatio);
    this.canvas.height = Math.round(height * devicePixelRatio);
    const smallest = this.fittingScale();
    const margin_x = width / smallest / 2;
    const margin_y = height / smallest / 2;
    this.behavior
      .extent([
        [0, 0],
        [width, height],
      ])
      .scaleExtent([smallest * 0.6, Math.max(kLargestScale, smallest * 4)])
      .translateExtent([
        [-margin_x, -margin_y],
        [this.world_width + margin_x, this.world_height + margin_y],
      ]);
    if (place) this.centre(place.x, place.y, place.k);
    else this.fit(false);
    this.drawFrame(); // at once, because a new size empties the canvas
  }

  private drawFrame(): void {
    this.frame_wanted = false;
    if (this.size.width === 0) return;
    const frame = this.frame();
    const left = this.work(frame);
    this.kept.update(frame, this.layers);
    copyShifted(this.context, this.kept.canvas, 0, 0);
    for (const layer of this.live_layers) layer.draw(frame);
    if (left) this.requestFrame();
  }

  /** Lets the layers prepare what shows, then what lies around it. Returns whether something is left to do. */
  private work(frame: Frame): boolean {
    const begin_ms = performance.now();
    const resting = begin_ms - this.moved_ms >= kRest_ms;
    const deadline_ms = begin_ms + (resting ? kWorkResting_ms : kWorkMoving_ms);
    const changed = (box: Box): void => this.kept.invalidate(box);
    const prepare = (box: Box): boolean => {
      const work: Work = { box, deadline_ms, changed };
      return this.layers.map((layer) => layer.work?.(frame, work) ?? false).some((left) => left);
    };
    return prepare(frame.visible) || prepare(grownBox(frame.visible, kAhead_px / frame.scale));
  }

  private frame(): Frame {
    const { k, x, y } = this.transform;
    const { width, height } = this.canvas;
    const pixel_ratio = width / this.size.width;
    const scale = k * pixel_ratio;
    const [left, top] = [Math.round(x * pixel_ratio), Math.round(y * pixel_ratio)];
    const visible = { left: -left / scale, top: -top / scale, right: (width - left) / scale, bottom: (height - top) / scale };
    return { context: this.context, width, height, scale, left, top, pixel_ratio, visible };
  }
}

export function stillsMotion(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}
