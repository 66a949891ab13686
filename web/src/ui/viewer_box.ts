import type { Viewer } from "../view/viewer.ts";
import { button, element } from "./dom.ts";
import { icon } from "./icons.ts";

/** A viewer's canvas with a text for those who do not see it, and its zoom buttons. */
export function viewerBox(viewer: Viewer, description: string, testid: string, ...more: Node[]): HTMLElement {
  const { canvas } = viewer;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application");
  canvas.setAttribute("aria-roledescription", "picture with zoom");
  canvas.setAttribute("aria-label", description);
  canvas.dataset["testid"] = testid;
  const zoom = element(
    "div",
    { class: "zoom-buttons", role: "group", "aria-label": "Zoom" },
    button({ label: "Zoom in", icon: icon("plus"), icon_only: true, testid: "zoom-in" }, () => viewer.zoomBy(1.6)),
    button({ label: "Zoom out", icon: icon("minus"), icon_only: true, testid: "zoom-out" }, () => viewer.zoomBy(1 / 1.6)),
    button({ label: "Whole picture", icon: icon("fit"), icon_only: true, testid: "zoom-fit" }, () => viewer.fit()),
  );
  return element("div", { class: "viewer" }, canvas, zoom, ...more);
}
