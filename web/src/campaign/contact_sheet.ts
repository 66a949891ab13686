import type { CampaignData, CampaignResult, Source } from "../data.ts";
import { element, foreignName, spokenName } from "../ui/dom.ts";
import { Pyramid } from "../view/pyramid.ts";
import { PictureLayer } from "../view/picture_layer.ts";
import { type Chosen, toggleChosen } from "./chosen.ts";
import { shownValue } from "./ranking_table.ts";

const kThumbnail_px = 240;
/** Measures below each picture. */
const kMeasures = 3;

/** All pictures, the best first. Pictures are decoded when they come into sight. */
export function contactSheet(data: CampaignData, source: Source, chosen: Chosen): HTMLElement {
  const list = element("ul", { class: "sheet", "data-testid": "contact-sheet" });
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        observer.unobserve(target);
        const result = data.results[Number((target as HTMLElement).dataset["index"])]!;
        drawThumbnail(target as HTMLCanvasElement, result, source);
      }
    },
    { rootMargin: "300px" },
  );
  data.results.forEach((result, index) => {
    const { card, canvas } = sheetCard(data, result, index, chosen);
    list.append(element("li", {}, card));
    if (canvas) observer.observe(canvas);
  });
  return list;
}

function sheetCard(
  data: CampaignData,
  result: CampaignResult,
  index: number,
  chosen: Chosen,
): { card: HTMLElement; canvas: HTMLCanvasElement | null } {
  const figures = data.measures
    .slice(0, kMeasures)
    .map((measure, at) => `${measure.label} ${shownValue(measure, result.values[at] ?? null)}`);
  const canvas = result.picture
    ? element("canvas", { role: "img", "aria-label": `Collage ${spokenName(result.name)}: ${figures.join(", ")}`, "data-index": index })
    : null;
  const card = element(
    "button",
    { type: "button", class: "sheet-card", "data-testid": `card-${index}` },
    element("span", { class: "thumbnail" }, canvas ?? "no picture"),
    element("span", { class: "sheet-name" }, element("span", { class: "rank" }, String(result.rank)), foreignName(result.name)),
    element("span", { class: "sheet-figures" }, figures.join(" · "), result.finished ? "" : " · unfinished"),
  );
  card.addEventListener("click", () => toggleChosen(chosen, index));
  chosen.watch((indices) => card.setAttribute("aria-pressed", String(indices.includes(index))));
  return { card, canvas };
}

/** From the level that is big enough for the card. */
function drawThumbnail(canvas: HTMLCanvasElement, result: CampaignResult, source: Source): void {
  const picture = result.picture!;
  const longest = Math.max(picture.full_width_px, picture.full_height_px);
  const scale = (kThumbnail_px * devicePixelRatio) / longest;
  canvas.width = Math.max(1, Math.round(picture.full_width_px * scale));
  canvas.height = Math.max(1, Math.round(picture.full_height_px * scale));
  const context = canvas.getContext("2d")!;
  const visible = { left: 0, top: 0, right: picture.full_width_px, bottom: picture.full_height_px };
  const draw = (): void => {
    const { width, height } = canvas;
    context.clearRect(0, 0, width, height);
    layer.draw({ context, width, height, scale, left: 0, top: 0, pixel_ratio: devicePixelRatio, visible });
  };
  const layer = new PictureLayer(new Pyramid(picture, source), visible, draw);
  draw();
}
