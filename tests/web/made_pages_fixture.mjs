// Pages that tests make for themselves.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";

function tessera(...words) {
  const { status, stderr } = spawnSync(process.env.TESSERA, words, { encoding: "utf8", timeout: 100_000 });
  assert.equal(status, 0, `tessera ${words.join(" ")}: ${stderr}`);
}

/** Makes a result and its page, NAME.html: as job.toml says, but for some settings ("canvas.seamless='both'"). */
export function makeResult(name, ...settings) {
  tessera("collage", "job.toml", "--out", name, "--quiet", ...settings.flatMap((setting) => ["--set", setting]));
  tessera("report", name, "-o", `${name}.html`);
}

/** The page of several results. */
export function makeCampaign(file, ...results) {
  tessera("report", ...results, "-o", file);
}

const kData = /(<script type="application\/json" id="data">)(.*?)(<\/script>)/s;

/** Writes a page like another one whose data `change` has changed. */
export function alterPage(from, to, change) {
  const page = readFileSync(from, "utf8");
  const data = JSON.parse(page.match(kData)[2]);
  change(data);
  const text = JSON.stringify(data).replaceAll("<", "\\u003c");
  writeFileSync(to, page.replace(kData, (_all, begin, _old, end) => begin + text + end));
}
