// Looks at pictures of a page pixel by pixel.

import * as fixture from "./page_fixture.mjs";

/** The viewer's colours: [red, green, blue] for each point of the canvas. */
export async function coloursAt(page, points) {
  const png = await fixture.settledShot(page);
  const { k, x, y } = await fixture.transform(page);
  return page.evaluate(drawn, [png.toString("base64"), points.map((point) => [Math.round(x + k * point.x), Math.round(y + k * point.y)])]);
}

/** How many pixels of the viewer changed between two pictures: beyond the canvas, and within boxes of the canvas. */
export async function changedPixels(page, before, after, size, boxes = []) {
  const { k, x, y } = await fixture.transform(page);
  const inView = ([left, top, right, bottom]) => [x + k * left, y + k * top, x + k * right, y + k * bottom];
  const shots = [before, after].map((png) => png.toString("base64"));
  return page.evaluate(countChanged, [shots, inView([0, 0, ...size]), boxes.map(inView)]);
}

async function drawn([png, places]) {
  const picture = new Image();
  picture.src = `data:image/png;base64,${png}`;
  await picture.decode();
  const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d", { willReadFrequently: true });
  context.drawImage(picture, 0, 0);
  return places.map(([x, y]) => [...context.getImageData(x, y, 1, 1).data.slice(0, 3)]);
}

async function countChanged([shots, canvas, boxes]) {
  const [one, two] = await Promise.all(
    shots.map(async (png) => {
      const picture = new Image();
      picture.src = `data:image/png;base64,${png}`;
      await picture.decode();
      const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d", { willReadFrequently: true });
      context.drawImage(picture, 0, 0);
      return context.getImageData(0, 0, picture.width, picture.height);
    }),
  );
  const inside = ([left, top, right, bottom], x, y, margin) =>
    x >= left - margin && x < right + margin && y >= top - margin && y < bottom + margin;
  let beyond = 0;
  const within = boxes.map(() => 0);
  for (let at = 0; at < one.data.length; at += 4) {
    if ([0, 1, 2].every((channel) => Math.abs(one.data[at + channel] - two.data[at + channel]) <= 12)) continue;
    const [x, y] = [(at / 4) % one.width, Math.floor(at / 4 / one.width)];
    if (!inside(canvas, x, y, 1)) ++beyond;
    boxes.forEach((box, index) => (within[index] += inside(box, x, y, 0) ? 1 : 0));
  }
  return { beyond, within };
}
