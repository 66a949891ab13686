import type { Session } from "./session.ts";

const kPan_px = 60;

/** What the keys do, for the list of keys. */
export const kKeys: readonly [keys: string, meaning: string][] = [
  ["Arrow keys", "move the picture"],
  ["+ and -", "zoom in and out"],
  ["0", "show the whole picture"],
  ["n and p", "select the next or the previous piece, in order of placement"],
  ["Enter", "zoom to the selected piece"],
  ["e and l", "mark the selected piece to be erased, or locked"],
  ["u", "undo the last mark"],
  ["Esc", "select nothing"],
  ["?", "show these keys"],
];

/** Whether a key belongs to the control that has the focus. */
function isForControl(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement;
  if (target instanceof HTMLCanvasElement) return false;
  if (target.closest("input[type=search], input[type=text], textarea, select, dialog")) return true;
  const uses_arrows = target.closest("input, [role=tab], [role=tabpanel], [tabindex='0']") !== null;
  return (uses_arrows && /^(Arrow|Page|Home|End)/.test(event.key)) || (event.key === "Enter" && target !== document.body);
}

/** Keys of the whole page. `session` gives the one that shows; `showKeys` opens the list of keys. */
export function addKeys(session: () => Session, showKeys: () => void): void {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || isForControl(event)) return;
    const press = event.key === "?" ? showKeys : actions(session())[event.key];
    if (!press) return;
    event.preventDefault();
    press();
  });
}

function actions(session: Session): Record<string, (() => void) | undefined> {
  const { viewer } = session;
  const selected = session.selected.get();
  const mark = (kind: "erase" | "lock") => () => {
    if (selected === null) return;
    session.mark_kind.set(kind);
    session.toggleMark(selected);
  };
  return {
    ArrowLeft: () => viewer.panBy(kPan_px, 0),
    ArrowRight: () => viewer.panBy(-kPan_px, 0),
    ArrowUp: () => viewer.panBy(0, kPan_px),
    ArrowDown: () => viewer.panBy(0, -kPan_px),
    "+": () => viewer.zoomBy(1.5),
    "=": () => viewer.zoomBy(1.5),
    "-": () => viewer.zoomBy(1 / 1.5),
    "0": () => viewer.fit(),
    n: () => step(session, 1),
    p: () => step(session, -1),
    e: mark("erase"),
    l: mark("lock"),
    u: () => session.undo(),
    Enter: () => selected !== null && session.zoomTo([selected]),
    Escape: () => session.select(null),
  };
}

/** Selects the next piece, and moves the picture if the piece does not show. */
export function step(session: Session, by: number): void {
  if (session.pieces === 0) return;
  const selected = session.selected.get();
  const next = selected === null ? (by > 0 ? 0 : session.pieces - 1) : (selected + by + session.pieces) % session.pieces;
  session.select(next);
  const { viewer, result } = session;
  const [x, y] = viewer.transform.apply([result.data.pieces.x_px[next]!, result.data.pieces.y_px[next]!]);
  const margin = 0.08 * Math.min(viewer.width, viewer.height);
  const shows = x > margin && y > margin && x < viewer.width - margin && y < viewer.height - margin;
  if (!shows) viewer.centre(result.data.pieces.x_px[next]!, result.data.pieces.y_px[next]!, viewer.transform.k, true);
}
