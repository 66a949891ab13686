import { type Found, matches, searchables } from "../model/search.ts";
import { announce } from "../ui/announce.ts";
import { element, foreignName, spokenName } from "../ui/dom.ts";
import { count, counted } from "../util/format.ts";
import type { Session } from "./session.ts";

const kMostShown = 100;

/** Finds drawings and groups by name, and marks all their pieces. */
export function searchTab(session: Session): HTMLElement {
  const all = searchables(session.result);
  const input = element("input", {
    type: "search",
    id: "search",
    class: "field",
    "data-testid": "search-input",
    placeholder: "bird, leaf …",
    autocomplete: "off",
    spellcheck: "false",
  });
  const summary = element("p", { class: "note", role: "status", "data-testid": "search-summary" });
  const list = element("ul", { class: "list", "data-testid": "search-results" });
  const show = (): void => {
    const found = matches(all, input.value);
    summary.textContent = summaryOf(found, input.value !== "");
    list.replaceChildren(...found.slice(0, kMostShown).map((entry) => resultEntry(session, entry)));
  };
  input.addEventListener("input", show);
  input.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") list.querySelector("button")?.focus();
    if (event.key === "Enter") list.querySelector("button")?.click();
  });
  list.addEventListener("keydown", (event) => moveFocus(event, list, input));
  show();
  return element("div", {}, element("h2", {}, element("label", { for: "search" }, "Search by name")), input, summary, list);
}

function summaryOf(found: readonly Found[], searching: boolean): string {
  const drawings = found.filter((entry) => entry.kind === "drawing");
  const pieces = drawings.reduce((sum, entry) => sum + entry.pieces, 0);
  if (found.length === 0) return "Nothing has this name.";
  const more = found.length > kMostShown ? ` The first ${kMostShown} are shown.` : "";
  return `${counted(drawings.length, "drawing")}, ${counted(pieces, "piece")}${searching ? " found" : ""}.${more}`;
}

function resultEntry(session: Session, found: Found): HTMLElement {
  const entry = element("button", { type: "button", class: "entry" }, foreignName(found.name || "unnamed drawing"));
  if (found.kind === "group") entry.prepend(element("span", { class: "tag" }, "group"));
  entry.append(element("span", { class: "entry-number" }, element("span", { class: "spoken" }, "used "), `${count(found.pieces)} ×`));
  entry.addEventListener("click", () => choose(session, found));
  return element("li", {}, entry);
}

/** Marks all pieces of what was found; a single one is selected. */
function choose(session: Session, found: Found): void {
  const { result } = session;
  const pieces = found.kind === "drawing" ? result.uses[found.index]! : piecesOfGroup(session, found.index);
  if (pieces.length === 1) session.select(pieces[0]!);
  else {
    session.selected.set(null);
    session.highlight.set({ label: found.name, pieces });
    announce(`${counted(pieces.length, "piece")} of ${spokenName(found.name)} marked on the picture.`);
  }
  session.zoomTo(pieces);
}

function piecesOfGroup(session: Session, group: number): number[] {
  const found: number[] = [];
  session.result.data.pieces.group.forEach((of, piece) => of === group && found.push(piece));
  return found;
}

/** Arrow keys go through the list, and from its top back to the field. */
function moveFocus(event: KeyboardEvent, list: HTMLElement, input: HTMLInputElement): void {
  if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
  event.preventDefault();
  event.stopPropagation();
  const buttons = [...list.querySelectorAll("button")];
  const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
  const next = at + (event.key === "ArrowDown" ? 1 : -1);
  (next < 0 ? input : (buttons[next] ?? buttons[at]))?.focus();
}
