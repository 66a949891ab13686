import { element } from "./dom.ts";
import { themeSwitch } from "./theme.ts";

/** The bar at the top: what the page shows, and its own controls. */
export function header(title: Node, summary: string, ...controls: Node[]): HTMLElement {
  return element(
    "header",
    { class: "bar" },
    element("div", { class: "bar-title" }, element("h1", {}, title), element("p", { "data-testid": "summary" }, summary)),
    element("div", { class: "bar-controls" }, ...controls, themeSwitch()),
  );
}

/** A window with the keys that work on the page, and the button that opens it. */
export function keysHelp(keys: readonly (readonly [string, string])[]): [HTMLButtonElement, HTMLDialogElement] {
  const list = element("dl", { class: "keys" });
  for (const [key, meaning] of keys) list.append(element("div", {}, element("dt", {}, key), element("dd", {}, meaning)));
  const close = element("button", { type: "button", class: "button primary" }, "Close");
  const dialog = element(
    "dialog",
    { class: "dialog", "aria-labelledby": "keys-title" },
    element("h2", { id: "keys-title" }, "Keys"),
    list,
    close,
  );
  close.addEventListener("click", () => dialog.close());
  const open = element("button", { type: "button", class: "button quiet", "data-testid": "keys" }, "Keys");
  open.addEventListener("click", () => dialog.showModal());
  return [open, dialog];
}
