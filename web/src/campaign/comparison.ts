import type { CampaignData, CampaignResult, PictureData, Source } from "../data.ts";
import { containedBox } from "../model/geometry.ts";
import { announce } from "../ui/announce.ts";
import { button, choice, element, foreignName, spokenName } from "../ui/dom.ts";
import { icon } from "../ui/icons.ts";
import { viewerBox } from "../ui/viewer_box.ts";
import type { Layer } from "../view/frame.ts";
import { linkViewers } from "../view/link.ts";
import { OnPaper } from "../view/paper.ts";
import { PictureLayer } from "../view/picture_layer.ts";
import { Pyramid } from "../view/pyramid.ts";
import { Viewer } from "../view/viewer.ts";
import { DifferenceLayer } from "./difference_layer.ts";
import { shownValue } from "./ranking_table.ts";

const kBlink_ms = 700;

type Mode = "side" | "difference" | "blink";

/** Two results: side by side with the same zoom, their difference, or one after the other at the same place. */
export class Comparison {
  readonly element: HTMLElement;
  /** The viewer that the others follow. */
  leading: Viewer;
  private readonly panes = element("div", { class: "panes" });
  private mode: Mode = "side";
  private doublings = 1;
  private unlink: () => void = () => {};
  private blinking = 0;

  constructor(
    private readonly source: Source,
    private readonly data: CampaignData,
    private first: CampaignResult,
    private second: CampaignResult,
    private readonly close: () => void,
  ) {
    this.leading = this.makeViewer(this.first.picture!);
    this.element = element("main", { class: "comparison" }, this.toolbar(), this.panes);
  }

  begin(): void {
    this.show();
    this.leading.canvas.focus();
  }

  leave(): void {
    clearInterval(this.blinking);
    this.unlink();
  }

  private toolbar(): HTMLElement {
    const modes: readonly { value: Mode; label: string; testid: string }[] = [
      { value: "side", label: "Side by side", testid: "mode-side" },
      { value: "difference", label: "Difference", testid: "mode-difference" },
      { value: "blink", label: "Blink", testid: "mode-blink" },
    ];
    const strength = element("select", {
      class: "select",
      "aria-label": "Strength of the difference",
      "data-testid": "difference-strength",
    });
    for (const doublings of [0, 1, 2, 3])
      strength.append(element("option", { value: doublings, selected: doublings === 1 }, `${2 ** doublings} ×`));
    strength.hidden = true;
    strength.addEventListener("change", () => {
      this.doublings = Number(strength.value);
      this.show();
    });
    const picker = choice("View", "mode", modes, this.mode, (mode) => {
      this.mode = mode;
      strength.hidden = mode !== "difference";
      this.show();
    });
    return element(
      "div",
      { class: "comparison-tools" },
      button({ label: "All results", icon: icon("previous"), testid: "compare-close" }, this.close),
      picker,
      strength,
      button({ label: "Swap", icon: icon("swap"), testid: "compare-swap" }, () => {
        [this.first, this.second] = [this.second, this.first];
        this.show();
      }),
    );
  }

  /** Builds the panes of the mode, at the place that showed before. */
  private show(): void {
    const before = this.leading;
    const place = before.place();
    this.leave();
    const viewers = { side: () => this.sideBySide(), difference: () => this.difference(), blink: () => this.blink() }[this.mode]();
    this.leading = viewers[0]!;
    this.unlink = linkViewers(viewers);
    this.panes.className = viewers.length > 1 ? "panes two" : "panes";
    if (!place) return;
    const { leading } = this;
    const ratio = leading.world_width / before.world_width;
    leading.centre(place.x * ratio, (place.y / before.world_height) * leading.world_height, place.k / ratio);
  }

  private sideBySide(): Viewer[] {
    const viewers = [this.first, this.second].map((result) => {
      const viewer = this.makeViewer(result.picture!);
      viewer.layers.push(this.pictureLayer(result, viewer));
      return viewer;
    });
    this.panes.replaceChildren(
      viewerBox(viewers[0]!, this.description(this.first), "viewer", this.paneName(this.first)),
      viewerBox(viewers[1]!, this.description(this.second), "viewer-beside", this.paneName(this.second)),
    );
    return viewers;
  }

  private difference(): Viewer[] {
    const viewer = this.makeViewer(this.first.picture!);
    const world = { left: 0, top: 0, right: viewer.world_width, bottom: viewer.world_height };
    const layer = new DifferenceLayer(this.pictureLayer(this.first, viewer), this.pictureLayer(this.second, viewer), world);
    layer.doublings = this.doublings;
    viewer.layers.push(layer);
    const names = `${spokenName(this.first.name)} and ${spokenName(this.second.name)}`;
    const title = element("p", { class: "pane-name" }, "Difference: black where both are equal");
    this.panes.replaceChildren(viewerBox(viewer, `Difference of ${names}`, "viewer", title));
    return [viewer];
  }

  private blink(): Viewer[] {
    const viewer = this.makeViewer(this.first.picture!);
    const results = [this.first, this.second];
    const layers = results.map((result) => this.pictureLayer(result, viewer));
    const title = element("div", {});
    let shown = 1;
    const turn = (): void => {
      shown = 1 - shown;
      viewer.layers.splice(0, 1, layers[shown]!);
      title.replaceChildren(this.paneName(results[shown]!));
      viewer.redraw();
    };
    const pause = button({ label: "Pause", testid: "blink-pause" }, () => {
      const stopped = this.blinking !== 0;
      if (stopped) clearInterval(this.blinking);
      this.blinking = stopped ? 0 : window.setInterval(turn, kBlink_ms);
      pause.querySelector("span")!.textContent = stopped ? "Go on" : "Pause";
      announce(stopped ? `Stopped at ${spokenName(results[shown]!.name)}.` : "Blinking.");
    });
    turn();
    this.blinking = window.setInterval(turn, kBlink_ms);
    pause.classList.add("blink-pause");
    this.panes.replaceChildren(
      viewerBox(viewer, `${this.description(this.first)} and ${this.description(this.second)}, in turn`, "viewer", title, pause),
    );
    return [viewer];
  }

  private makeViewer(picture: PictureData): Viewer {
    return new Viewer(picture.full_width_px, picture.full_height_px);
  }

  /** A result's picture on paper. It fills the world of the viewer; a picture of another shape lies in its middle, as large as it can. */
  private pictureLayer(result: CampaignResult, viewer: Viewer): Layer {
    const { full_width_px, full_height_px } = result.picture!;
    const box = containedBox(full_width_px, full_height_px, viewer.world_width, viewer.world_height);
    return new OnPaper(new PictureLayer(new Pyramid(result.picture!, this.source), box, (part) => viewer.redraw(part)), box);
  }

  private paneName(result: CampaignResult): HTMLElement {
    const [measure] = this.data.measures;
    const figure = measure ? ` · ${measure.label} ${shownValue(measure, result.values[0] ?? null)}` : "";
    return element("p", { class: "pane-name" }, foreignName(result.name), `${figure} · rank ${result.rank}`);
  }

  private description(result: CampaignResult): string {
    return `Collage ${spokenName(result.name)}, rank ${result.rank}`;
  }
}
