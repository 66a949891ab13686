import { type Point } from "../model/geometry.ts";
import { centreOf, pieceName } from "../model/result.ts";
import { element, foreignName } from "../ui/dom.ts";
import type { Session } from "./session.ts";

/** The piece at a point, if it shows yet. */
function pieceAt(session: Session, { x, y }: Point): number | null {
  const piece = session.result.index.pieceAt(x, y);
  return piece !== null && piece < session.growth.get() ? piece : null;
}

/** Those pieces that show yet. */
function shown(session: Session, pieces: readonly number[]): number[] {
  return pieces.filter((piece) => piece < session.growth.get());
}

/** Pointing at pieces: the label beside the pointer, and the choice by a click. Returns the label. */
export function addPointing(session: Session): HTMLElement {
  const { canvas } = session.viewer;
  const label = element("div", { class: "hover-label", "aria-hidden": "true", "data-testid": "hover-label" });
  label.hidden = true;
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons !== 0) return session.hovered.set(null);
    session.hovered.set(pieceAt(session, session.viewer.worldPoint(event)));
    const bounds = canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - bounds.left, event.clientY - bounds.top];
    // On the side of the pointer where there is more room.
    label.style.left = `${x}px`;
    label.style.top = `${y}px`;
    label.classList.toggle("to-left", x > bounds.width / 2);
    label.classList.toggle("upwards", y > bounds.height / 2);
  });
  canvas.addEventListener("pointerleave", () => session.hovered.set(null));
  session.hovered.watch((piece) => {
    label.hidden = piece === null;
    if (piece !== null) label.replaceChildren(foreignName(pieceName(session.result, piece)));
    canvas.classList.toggle("pointing", piece !== null && session.tool.get() !== "scribble");
  });
  canvas.addEventListener("click", (event) => {
    const piece = pieceAt(session, session.viewer.worldPoint(event));
    if (session.tool.get() === "pan") session.select(piece);
    if (session.tool.get() === "click" && piece !== null) session.toggleMark(piece);
  });
  return label;
}

/** Scribbling and the lasso. */
export function addDrawingTools(session: Session): void {
  const { canvas } = session.viewer;
  const draws = (): boolean => session.tool.get() === "scribble" || session.tool.get() === "lasso";
  let stroke: { pointer: number; last: Point } | null = null;
  session.viewer.mayPan = () => !draws();
  session.viewer.zoomsOnDoubleClick = () => session.tool.get() === "pan";
  session.tool.watch((tool) => {
    canvas.dataset["tool"] = tool;
  });

  canvas.addEventListener("pointerdown", (event) => {
    if (stroke) {
      session.marked(session.marks.cancelStep()); // a second finger: the two zoom
      return abandon();
    }
    if (!draws() || event.button !== 0) return;
    const at = session.viewer.worldPoint(event);
    stroke = { pointer: event.pointerId, last: at };
    canvas.setPointerCapture(event.pointerId);
    session.beginStep();
    if (session.tool.get() === "scribble") scribble(session, at, at);
    else session.lasso.set([at]);
  });
  canvas.addEventListener("pointermove", (event) => {
    const at = session.viewer.worldPoint(event);
    session.brush.set(at);
    if (stroke?.pointer !== event.pointerId) return;
    if (session.tool.get() === "scribble") scribble(session, stroke.last, at);
    else session.lasso.set([...session.lasso.get(), at]);
    stroke.last = at;
  });
  canvas.addEventListener("pointerup", (event) => {
    if (stroke?.pointer !== event.pointerId) return;
    const way = session.lasso.get();
    if (way.length > 2) session.mark(shown(session, session.result.index.inLasso(way, (piece) => centreOf(session.result, piece))));
    abandon();
  });
  canvas.addEventListener("pointercancel", () => abandon());
  canvas.addEventListener("pointerleave", () => session.brush.set(null));

  function abandon(): void {
    stroke = null;
    session.lasso.set([]);
  }
}

function scribble(session: Session, from: Point, to: Point): void {
  const radius = session.brush_px.get() / 2 / session.viewer.transform.k;
  session.mark(shown(session, session.result.index.touchedBy(from, to, radius)));
}
