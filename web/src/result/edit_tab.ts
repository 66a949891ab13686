import type { Marks } from "../data.ts";
import { needsFile, refineCommand } from "../model/command.ts";
import { button, checkbox, choice, element } from "../ui/dom.ts";
import { copyButton, download } from "../ui/files.ts";
import { icon, type IconName } from "../ui/icons.ts";
import { count, counted } from "../util/format.ts";
import { maskPicture } from "./mask_picture.ts";
import type { Session, Tool } from "./session.ts";

const tools: readonly { value: Tool; label: string; icon: IconName; hint: string }[] = [
  { value: "pan", label: "Pan", icon: "hand", hint: "Drag to move the picture; a click selects a piece." },
  { value: "click", label: "Click", icon: "pointer", hint: "Click a piece to mark it; once more takes the mark away." },
  { value: "scribble", label: "Scribble", icon: "brush", hint: "Paint over pieces; all that the brush touches are marked." },
  { value: "lasso", label: "Lasso", icon: "lasso", hint: "Draw around pieces; those whose centres lie inside are marked." },
];

const kLeftOut = "Locked pieces cannot be erased, and were left out.";

/** Marks as the command and the files have them. */
export function sessionMarks(session: Session): Marks {
  return session.marks.toFile(session.result.data.pieces_digest, session.swap.get() ? "swap" : "erase");
}

/** Marking pieces, and how to have them refilled. `refill` is the part of the page of a server, if there is one. */
export function editTab(session: Session, refill: HTMLElement | null): HTMLElement {
  return element(
    "div",
    { class: "edit" },
    element("h2", {}, "Edit"),
    element("p", { class: "note" }, "Mark pieces to erase them; Tessera then fills their place anew. Locked pieces stay where they are."),
    ...fixedNote(session),
    toolPicker(session),
    brushSlider(session),
    kindPicker(session),
    status(session),
    checkbox("Other drawings (swap)", "None of the erased drawings may come back, not even at another place.", "edit-swap", (on) =>
      session.swap.set(on),
    ),
    ...(refill ? [refill] : []),
    ...command(session),
    ...files(session),
  );
}

/** Says where pieces cannot be erased. */
function fixedNote(session: Session): Node[] {
  const fixed = session.result.data.pieces.locked.filter((locked) => locked === 1).length;
  if (fixed === 0) return [];
  const which = fixed === session.pieces ? "All pieces" : `${count(fixed)} of ${counted(session.pieces, "piece")}`;
  const by = "by the job, or when this result was refined";
  const text = `${which} ${fixed === 1 && session.pieces > 1 ? "is" : "are"} locked (${by}) and cannot be erased.`;
  return [element("p", { class: "note", "data-testid": "fixed-note" }, text)];
}

function toolPicker(session: Session): HTMLElement {
  const options = tools.map(({ value, label }) => ({ value, label, testid: `tool-${value}` }));
  const picker = choice("Tool", "tool", options, session.tool.get(), (tool) => session.tool.set(tool));
  picker.querySelectorAll("label").forEach((label, index) => label.querySelector("span")!.prepend(icon(tools[index]!.icon)));
  const hint = element("p", { class: "note", role: "status" });
  session.tool.watch((tool) => {
    hint.textContent = tools.find(({ value }) => value === tool)!.hint;
  });
  return element("div", {}, picker, hint);
}

function brushSlider(session: Session): HTMLElement {
  const input = element("input", {
    type: "range",
    id: "brush",
    min: 4,
    max: 120,
    value: session.brush_px.get(),
    "data-testid": "brush-size",
  });
  input.addEventListener("input", () => session.brush_px.set(Number(input.value)));
  const row = element("div", { class: "slider-row" }, element("label", { for: "brush" }, "Size of the brush"), input);
  session.tool.watch((tool) => {
    input.disabled = tool !== "scribble";
  });
  return row;
}

function kindPicker(session: Session): HTMLElement {
  const picker = choice(
    "Marks",
    "mark-kind",
    [
      { value: "erase", label: "Erase", testid: "mark-erase" },
      { value: "lock", label: "Lock", testid: "mark-lock" },
      { value: "none", label: "Unmark", testid: "mark-none" },
    ],
    session.mark_kind.get(),
    (kind) => session.mark_kind.set(kind),
  );
  session.mark_kind.watch((kind) => {
    picker.querySelector<HTMLInputElement>(`[value=${kind}]`)!.checked = true;
  });
  picker.classList.add("mark-kinds");
  return picker;
}

function status(session: Session): HTMLElement {
  const text = element("p", { class: "marks-status", role: "status", "data-testid": "marks-status" });
  const undo = button({ label: "Undo", icon: icon("undo"), testid: "marks-undo" }, () => session.undo());
  const clear = button({ label: "Clear", icon: icon("clear"), testid: "marks-clear" }, () => session.clearMarks());
  const show = (): void => {
    const { pieces, lock } = sessionMarks(session);
    const marked = session.marks.size === 0 ? "Nothing is marked." : `${counted(pieces.length, "piece")} to erase, ${lock.length} locked.`;
    text.textContent = session.left_out.get() ? `${marked} ${kLeftOut}` : marked;
    undo.disabled = !session.marks.canUndo;
    clear.disabled = session.marks.size === 0;
  };
  session.marks_changed.watch(show);
  session.left_out.watch(show);
  return element("div", {}, text, element("div", { class: "row" }, undo, clear));
}

function command(session: Session): Node[] {
  const text = element("pre", { class: "code wrapping", tabindex: 0, role: "region", "aria-label": "Command", "data-testid": "command" });
  const note = element("p", { class: "note" });
  const current = (): string => refineCommand(session.result.data.folder, sessionMarks(session), session.seed.get());
  const copy = copyButton("Copy", "command-copy", current, text);
  const show = (): void => {
    const marks = sessionMarks(session);
    copy.disabled = marks.pieces.length === 0; // locks alone change nothing, and the program refuses them
    text.textContent = copy.disabled ? "# mark pieces to erase first" : current();
    const by_file = !copy.disabled && needsFile(marks);
    note.textContent = by_file ? "Save marks.json first, into the folder where you call the command." : "";
  };
  session.marks_changed.watch(show);
  session.swap.watch(show);
  session.seed.watch(show);
  return [element("h3", {}, "Command"), text, note, element("div", { class: "row" }, copy)];
}

function files(session: Session): Node[] {
  const saveMarks = (): void => {
    download("marks.json", new Blob([`${JSON.stringify(sessionMarks(session))}\n`], { type: "application/json" }));
  };
  const saveMask = async (): Promise<void> => {
    download("mask.png", await maskPicture(session.result, sessionMarks(session).pieces));
  };
  const marks = button({ label: "Save marks.json", testid: "save-marks" }, saveMarks);
  const mask = button({ label: "Save mask.png", testid: "save-mask" }, () => void saveMask());
  session.marks_changed.watch(() => {
    marks.disabled = mask.disabled = session.marks.pieces("erase").length === 0;
  });
  return [
    element("h3", {}, "Files"),
    element("p", { class: "note" }, "marks.json holds all marks (--marks). mask.png shows the pieces to erase in red (--erase)."),
    element("div", { class: "row" }, marks, mask),
  ];
}
