import { announce } from "../ui/announce.ts";
import { button, element, foreignName, printable } from "../ui/dom.ts";
import type { Session } from "./session.ts";
import { sessionMarks } from "./edit_tab.ts";
import type { Variants, VariantState } from "./variants.ts";

/** The button that has the marked pieces refilled by the server, with its progress. */
export function refillBox(session: Session, variants: Variants, until: AbortSignal): HTMLElement {
  const seed = element("input", {
    type: "number",
    id: "seed",
    class: "field short",
    min: 0,
    step: 1,
    placeholder: "the job's",
    "data-testid": "seed",
  });
  seed.value = session.seed.get() === null ? "" : String(session.seed.get());
  seed.addEventListener("input", () => session.seed.set(seed.value === "" ? null : Number(seed.value)));
  const send = (action: "erase" | "swap" | "relax"): void => {
    const { pieces, lock, pieces_digest } = sessionMarks(session);
    const request = { result: session.result.data.name, pieces_digest, action, pieces: action === "relax" ? [] : pieces, lock };
    void variants.refine({ ...request, seed: session.seed.get() });
  };
  const refill = button({ label: "Refill", kind: "primary", testid: "refill" }, () => send(session.swap.get() ? "swap" : "erase"));
  const relax = button({ label: "Relax", testid: "relax" }, () => send("relax"));
  relax.title = "Lets all pieces that are not locked move into better places";
  const stop = button({ label: "Stop", testid: "refill-stop" }, () => void variants.stop());
  const message = element("p", { class: "note", role: "status", "data-testid": "refill-message" });
  const show = (): void => {
    const { running } = variants;
    refill.disabled = running !== undefined || session.marks.pieces("erase").length === 0;
    relax.disabled = running !== undefined;
    stop.hidden = running === undefined;
    const begins = running?.has_pieces ? "The pieces stand; they are improved and drawn …" : "It begins …";
    message.textContent = running ? printable(running.message || begins) : "";
  };
  variants.list.watch(show, until);
  session.marks_changed.watch(show);
  return element(
    "div",
    { class: "refill" },
    element("div", { class: "row" }, refill, relax, stop),
    element("div", { class: "slider-row" }, element("label", { for: "seed" }, "Seed of the filling"), seed),
    message,
    troubleLine(variants, until),
  );
}

function troubleLine(variants: Variants, until: AbortSignal): HTMLElement {
  const line = element("p", { class: "trouble", role: "alert" });
  variants.trouble.watch((text) => {
    line.textContent = printable(text);
  }, until);
  return line;
}

export interface VariantsOptions {
  show(name: string): void;
  compare(name: string): void;
  until: AbortSignal;
}

/** The list of results of the server. Any two can be shown side by side. */
export function variantsTab(shown: string, variants: Variants, options: VariantsOptions): HTMLElement {
  const list = element("ul", { class: "variants", "data-testid": "variants" });
  variants.list.watch((all) => {
    list.replaceChildren(...all.map((variant) => entry(variant, shown, options)));
  }, options.until);
  return element(
    "div",
    {},
    element("h2", {}, "Variants"),
    element("p", { class: "note" }, "Each refill is a result of its own; the one that it came from stays as it is."),
    list,
    troubleLine(variants, options.until),
  );
}

const state_texts = { finished: "finished", running: "at work", stopped: "stopped", failed: "failed" } as const;

function entry(variant: VariantState, shown: string, { show, compare }: VariantsOptions): HTMLElement {
  const is_shown = variant.name === shown;
  const line = element("li", { "aria-current": is_shown ? "true" : null }, element("strong", {}, foreignName(variant.name)));
  line.append(element("span", { class: "tag" }, is_shown ? "shown" : state_texts[variant.state]));
  const from = variant.from ? element("p", { class: "note" }, "from ", foreignName(variant.from)) : null;
  if (from) line.append(from);
  if (variant.message) line.append(element("p", { class: "note" }, printable(variant.message)));
  if (variant.has_pieces && !is_shown) {
    const press = (action: (name: string) => void) => () => {
      announce(`Loading ${printable(variant.name)}.`);
      action(variant.name);
    };
    line.append(
      element("div", { class: "row" }, button({ label: "Show" }, press(show)), button({ label: "Side by side" }, press(compare))),
    );
  }
  return line;
}
