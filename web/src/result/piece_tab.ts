import { kContact_px, neighboursOf } from "../model/neighbours.ts";
import { contactFraction, pieceName, type Result } from "../model/result.ts";
import { button, element, foreignName } from "../ui/dom.ts";
import { icon } from "../ui/icons.ts";
import { count, counted, fixed, percent } from "../util/format.ts";
import { step } from "./keyboard.ts";
import type { Session } from "./session.ts";

/** No more than this many buttons for the uses of a drawing. */
const kMostUses = 60;

/** The panel about the selected piece. */
export function pieceTab(session: Session): HTMLElement {
  const panel = element("div", { class: "piece", "data-testid": "piece-panel" });
  const show = (): void => {
    const piece = session.selected.get();
    panel.replaceChildren(...(piece === null ? nothingSelected(session) : [...about(session, piece)]));
  };
  session.selected.watch(show);
  session.marks_changed.watch(show);
  return panel;
}

function nothingSelected(session: Session): Node[] {
  return [
    element("h2", {}, "No piece selected"),
    element("p", { class: "note" }, "Click a piece on the picture, or go through them in order of placement."),
    stepButtons(session),
  ];
}

function stepButtons(session: Session): HTMLElement {
  return element(
    "div",
    { class: "row" },
    button({ label: "Previous", icon: icon("previous"), testid: "piece-previous" }, () => step(session, -1)),
    button({ label: "Next", icon: icon("next"), testid: "piece-next" }, () => step(session, 1)),
  );
}

function* about(session: Session, piece: number): Generator<Node> {
  const { result } = session;
  const { pieces, shapes } = result.data;
  yield element("h2", { class: "piece-name", "data-testid": "piece-name" }, foreignName(pieceName(result, piece)));
  yield element("p", { class: "source" }, foreignName(shapes.source[pieces.shape[piece]!] ?? ""));
  const mark = session.marks.get(piece);
  const toggle = (kind: "erase" | "lock") => () => {
    session.mark_kind.set(kind);
    session.toggleMark(piece);
  };
  const erase = button({ label: mark === "erase" ? "Keep" : "Erase", testid: "piece-erase" }, toggle("erase"));
  erase.disabled = session.isFixed(piece);
  yield element(
    "div",
    { class: "row" },
    button({ label: "Zoom to it", testid: "piece-zoom" }, () => session.zoomTo([piece])),
    erase,
    button({ label: mark === "lock" ? "Unlock" : "Lock", testid: "piece-lock" }, toggle("lock")),
  );
  yield stepButtons(session);
  yield facts(session, piece);
  yield* usesOf(session, piece);
  yield* neighbours(session, piece);
}

function areaText({ data }: Result, piece: number): string {
  const area_px2 = data.pieces.area_px2[piece]!;
  return `${count(Math.round(area_px2))} px², ${percent(area_px2 / data.canvas.area_px2)} of the canvas`;
}

function facts(session: Session, piece: number): HTMLElement {
  const { result } = session;
  const { pieces, groups } = result.data;
  const contact = contactFraction(result, piece);
  const rows: [string, Node | string][] = [
    ["Place in the order", `${piece} (of 0 to ${session.pieces - 1})`],
    ["Position", `x ${fixed(pieces.x_px[piece]!, 1)} px, y ${fixed(pieces.y_px[piece]!, 1)} px`],
    ["Scale", `${fixed(pieces.scale_px[piece]!, 1)} px`],
    ["Area", areaText(result, piece)],
    ["Rotation", rotationText(pieces.rotation_deg[piece]!)],
    ["Mirrored", pieces.mirrored[piece] ? "yes" : "no"],
    ["Locked", pieces.locked[piece] ? "yes (by the job, or when this result was refined): it cannot be erased" : "no"],
    ["Score when placed", fixed(pieces.score[piece]!, 3)],
    ["Matched boundary", `${fixed(pieces.matched_px[piece]!, 1)} px`],
  ];
  if (contact !== null) rows.push(["In contact", `${percent(contact)} of its boundary`]);
  const group = pieces.group[piece]!;
  if (group >= 0) rows.splice(0, 0, ["Group", foreignName(groups[group] ?? "")]);
  return factList(rows, "piece-facts");
}

function rotationText(degrees: number): string {
  return `${fixed(Math.abs(degrees), 1)}° ${degrees < 0 ? "anticlockwise" : "clockwise"}`;
}

/** Names and values, one pair a row. */
export function factList(rows: readonly [string, Node | string][], testid: string): HTMLElement {
  const list = element("dl", { class: "facts", "data-testid": testid });
  for (const [name, value] of rows) list.append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
  return list;
}

function* usesOf(session: Session, piece: number): Generator<Node> {
  const uses = session.result.uses[session.result.data.pieces.shape[piece]!]!;
  yield element("h3", {}, "Uses of this drawing ", element("span", { class: "badge", "data-testid": "piece-uses" }, count(uses.length)));
  if (uses.length === 1) {
    yield element("p", { class: "note" }, "It is used once.");
    return;
  }
  yield element("p", { class: "note" }, "Marked in yellow on the picture. The numbers are places in the order of placement.");
  const chips = uses.slice(0, kMostUses).map((use) => {
    const chip = button({ label: String(use), kind: "quiet" }, () => session.select(use));
    chip.setAttribute("aria-current", String(use === piece));
    return chip;
  });
  yield element("div", { class: "chips" }, ...chips);
  if (uses.length > kMostUses) yield element("p", { class: "note" }, `and ${counted(uses.length - kMostUses, "more use")}`);
}

function* neighbours(session: Session, piece: number): Generator<Node> {
  const near = neighboursOf(session.result.outlines, session.result.index, piece, kContact_px);
  yield element("h3", {}, "Neighbours ", element("span", { class: "badge" }, count(near.length)));
  yield element("p", { class: "note" }, `Pieces within ${kContact_px} px. Where the boundary is orange, it is in contact.`);
  const list = element("ul", { class: "list", "data-testid": "neighbours" });
  for (const other of near) {
    const entry = element("button", { type: "button", class: "entry" }, foreignName(pieceName(session.result, other)));
    entry.append(element("span", { class: "entry-number" }, String(other)));
    entry.addEventListener("click", () => session.select(other));
    entry.addEventListener("pointerenter", () => session.hovered.set(other));
    entry.addEventListener("pointerleave", () => session.hovered.set(null));
    list.append(element("li", {}, entry));
  }
  yield list;
}
