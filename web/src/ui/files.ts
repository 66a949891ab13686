import { announce } from "./announce.ts";
import { button, element } from "./dom.ts";
import { icon } from "./icons.ts";

/** Lets the browser save bytes under a name. */
export function download(name: string, blob: Blob): void {
  const url = URL.createObjectURL(blob);
  const link = element("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
  announce(`Saved ${name}.`);
}

/** Copies a text. Where the clipboard is closed to pages (file:// in some browsers), by way of a selection; false: not even so. */
async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = element("textarea", { class: "spoken", "aria-hidden": "true" });
    area.value = text;
    document.body.append(area);
    area.select();
    const copied = document.execCommand("copy");
    area.remove();
    return copied;
  }
}

/** A button that copies a text and says so. If nothing helps, `source` is selected, ready for Ctrl-C. */
export function copyButton(label: string, testid: string, text: () => string, source: HTMLElement): HTMLButtonElement {
  const made = button({ label, icon: icon("copy"), testid }, async () => {
    const copied = await copyText(text());
    if (!copied) getSelection()?.selectAllChildren(source);
    const caption = made.querySelector("span")!;
    caption.textContent = copied ? "Copied" : "Press Ctrl-C";
    announce(copied ? "Copied." : "The text is selected. Press Control-C to copy it.");
    setTimeout(() => (caption.textContent = label), 2000);
  });
  return made;
}
