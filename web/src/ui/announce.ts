import { element } from "./dom.ts";

/** Where texts for screen readers go; nobody sees it. */
const region = element("div", { class: "spoken", role: "status", "aria-live": "polite", "data-testid": "announcer" });

export function announcer(): HTMLElement {
  return region;
}

/** Lets a screen reader say something. */
export function announce(text: string): void {
  region.textContent = text;
}
