import type { Result } from "../model/result.ts";
import { button, element, foreignName, spokenName } from "../ui/dom.ts";
import { header } from "../ui/header.ts";
import { icon } from "../ui/icons.ts";
import { makeTabs, type Tab } from "../ui/tabs.ts";
import { viewerBox } from "../ui/viewer_box.ts";
import { count, counted, percent } from "../util/format.ts";
import { section } from "../model/card.ts";
import { PictureBase } from "../view/picture_base.ts";
import { Viewer } from "../view/viewer.ts";
import { editTab } from "./edit_tab.ts";
import { growthBar } from "./growth_bar.ts";
import { jobTab } from "./job_tab.ts";
import { addLayers } from "./layers.ts";
import { overlaysTab } from "./overlays_tab.ts";
import { pieceTab } from "./piece_tab.ts";
import { addDrawingTools, addPointing } from "./pointer.ts";
import { qualityTab } from "./quality_tab.ts";
import { searchTab } from "./search_tab.ts";
import type { Session } from "./session.ts";
import type { Variants } from "./variants.ts";
import { refillBox, variantsTab } from "./variants_tab.ts";

export interface WorkspaceOptions {
  /** Lends its picture while the result has none. */
  base: Result | null;
  /** Shown at the right, with the same zoom. */
  beside: Result | null;
  beside_base: Result | null;
  variants: Variants | null;
  /** Comes when another workspace takes this one's place. */
  until: AbortSignal;
  tab: string;
  keys_button: HTMLElement;
  tabChanged(tab: string): void;
  show(name: string): void;
  compare(name: string): void;
  closeCompare(): void;
}

/** Everything that shows one result. */
export function workspace(session: Session, options: WorkspaceOptions): { element: HTMLElement; other_viewer: Viewer | null } {
  const { data } = session.result;
  const layers = addLayers(session, options.base);
  const label = addPointing(session);
  addDrawingTools(session);
  const picture = viewerBox(session.viewer, description(session), "viewer", label, highlightNote(session));
  const other = options.beside ? otherPane(options.beside, options.beside_base, options.closeCompare) : null;
  if (other) picture.prepend(element("p", { class: "pane-name" }, foreignName(data.name)));
  const quality = qualityTab(session);
  const tabs: Tab[] = [
    { id: "piece", label: "Piece", content: pieceTab(session) },
    { id: "search", label: "Search", content: searchTab(session) },
    { id: "overlays", label: "Overlays", content: overlaysTab(session, layers) },
    { id: "edit", label: "Edit", content: editTab(session, options.variants ? refillBox(session, options.variants, options.until) : null) },
    { id: "quality", label: "Quality", ...quality },
    { id: "job", label: "Job", content: jobTab(session) },
  ];
  if (options.variants) {
    const content = variantsTab(data.name, options.variants, options);
    tabs.splice(4, 0, { id: "variants", label: "Variants", content });
  }
  let current = options.tab;
  const made = makeTabs("About the result", tabs, (tab) => {
    current = tab;
    options.tabChanged(tab);
  });
  made.show(current);
  // While someone edits, a click on a piece must not take the tools away.
  session.selected.watch((piece) => piece !== null && current !== "edit" && made.show("piece"));

  const panel = element("aside", { class: "panel", id: "panel", "aria-label": "Details" }, made.list, made.panels);
  const stage = element(
    "section",
    { class: "stage", "aria-label": "Picture" },
    element("div", { class: other ? "panes two" : "panes" }, picture, ...(other ? [other.element] : [])),
    growthBar(session),
  );
  const root = element(
    "div",
    { class: "result" },
    header(foreignName(data.name), summary(session.result), options.keys_button, panelButton(panel)),
    element("main", { class: "work" }, stage, panel),
  );
  return { element: root, other_viewer: other?.viewer ?? null };
}

function panelButton(panel: HTMLElement): HTMLElement {
  const made = button({ label: "Details", icon: icon("panel"), kind: "quiet", testid: "panel-toggle" }, () => {
    panel.hidden = !panel.hidden;
    made.setAttribute("aria-expanded", String(!panel.hidden));
  });
  made.setAttribute("aria-label", "Details"); // on a phone only the icon shows
  made.setAttribute("aria-expanded", "true");
  made.setAttribute("aria-controls", "panel");
  return made;
}

function summary(result: Result): string {
  const { canvas, pieces, finished, card } = result.data;
  const coverage = section(card, "quality")["coverage_fraction"];
  const parts = [counted(pieces.shape.length, "piece"), `${count(canvas.width_px)} × ${count(canvas.height_px)} px`];
  if (typeof coverage === "number") parts.push(`${percent(coverage)} covered`);
  if (!finished) parts.push("unfinished");
  return parts.join(" · ");
}

/** The picture in words. */
function description(session: Session): string {
  const { data, uses } = session.result;
  const most = uses.map((pieces, shape) => ({ pieces, shape })).sort((a, b) => b.pieces.length - a.pieces.length);
  const names = most.slice(0, 3).map(({ shape }) => spokenName(data.shapes.name[shape]!));
  const drawings = counted(uses.filter((pieces) => pieces.length > 0).length, "drawing");
  const keys = "Keys: arrows move, plus and minus zoom, n and p go through the pieces.";
  return `Collage ${spokenName(data.name)}: ${summary(session.result)}. ${drawings}, most often ${names.join(", ")}. ${keys}`;
}

/** How many pieces are marked, and the way to end it. */
function highlightNote(session: Session): HTMLElement {
  const note = element("div", { class: "highlight-note", "data-testid": "highlight-note" });
  session.highlight.watch((highlight) => {
    note.hidden = !highlight || highlight.pieces.length < 2;
    if (!highlight) return;
    const close = button({ label: "Show no marks", icon: icon("clear"), icon_only: true, kind: "quiet" }, () => session.select(null));
    note.replaceChildren(element("span", {}, foreignName(highlight.label), ` · ${count(highlight.pieces.length)} ×`), close);
  });
  return note;
}

function otherPane(result: Result, base: Result | null, close: () => void): { element: HTMLElement; viewer: Viewer } {
  const { name, canvas } = result.data;
  const viewer = new Viewer(canvas.width_px, canvas.height_px);
  viewer.layers.push(new PictureBase(result, base, (box) => viewer.redraw(box)));
  const end = button({ label: "Close", icon: icon("clear"), testid: "compare-close" }, close);
  const title = element("p", { class: "pane-name" }, foreignName(name), end);
  return { element: viewerBox(viewer, `Collage ${spokenName(name)}, for comparison`, "viewer-beside", title), viewer };
}
