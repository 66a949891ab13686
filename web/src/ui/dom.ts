type Attributes = Record<string, string | number | boolean | null | undefined>;

/** An element with attributes and children. Texts become text nodes: nothing that the data contains is ever read as markup. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, String(value));
  }
  made.append(...children);
  return made;
}

/** A name of unknown origin: shown as it is, without influence on the direction of what surrounds it. */
export function foreignName(name: string): HTMLElement {
  return element("bdi", {}, printable(name));
}

/** Control characters (but tabs and ends of lines) are shown as a replacement character, and so are those that turn the direction of
 *  writing round: "gpj.exe" could read as something else. */
export function printable(text: string): string {
  return text.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u202a-\u202e\u2066-\u2069]/g, "\ufffd");
}

/** A name within a sentence that is spoken or lies in an attribute, where <bdi> cannot isolate marks of direction. */
export function spokenName(name: string): string {
  return printable(name).replace(/[\u200e\u200f\u061c]/g, "");
}

export interface ButtonOptions {
  label: string;
  testid?: string;
  icon?: SVGSVGElement;
  /** Shows the icon alone; the label is spoken, and shown as a tip. */
  icon_only?: boolean;
  kind?: "plain" | "primary" | "quiet";
}

export function button({ label, testid, icon, icon_only = false, kind = "plain" }: ButtonOptions, press: () => void): HTMLButtonElement {
  const made = element("button", { type: "button", class: `button ${kind}`, "data-testid": testid });
  if (icon) made.append(icon);
  if (icon_only) {
    made.setAttribute("aria-label", label);
    made.title = label;
  } else {
    made.append(element("span", {}, label));
  }
  made.addEventListener("click", press);
  return made;
}

/** A choice of yes or no with its explanation below it. */
export function checkbox(label: string, explanation: string, testid: string, change: (on: boolean) => void): HTMLElement {
  const input = element("input", { type: "checkbox", id: testid, "data-testid": testid, "aria-describedby": `${testid}-note` });
  input.addEventListener("change", () => change(input.checked));
  return element(
    "div",
    { class: "choice" },
    input,
    element("label", { for: testid }, label),
    element("p", { class: "note", id: `${testid}-note` }, explanation),
  );
}

/** One of several choices, as a row of radio buttons. */
export function choice<T extends string>(
  legend: string,
  name: string,
  options: readonly { value: T; label: string; testid?: string }[],
  chosen: T,
  change: (value: T) => void,
): HTMLFieldSetElement {
  const made = element("fieldset", { class: "segments" }, element("legend", {}, legend));
  for (const { value, label, testid } of options) {
    const input = element("input", { type: "radio", name, value, checked: value === chosen, "data-testid": testid });
    input.addEventListener("change", () => change(value));
    made.append(element("label", {}, input, element("span", {}, label)));
  }
  return made;
}
