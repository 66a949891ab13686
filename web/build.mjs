// Makes dist/report.html: one file with the page, its styles and its program, into which Tessera writes its data. The same sources give
// the same bytes each time.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));

async function bundle(entry) {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    charset: "utf8",
    format: entry.endsWith(".ts") ? "iife" : undefined,
    target: ["chrome123", "firefox120", "safari17.5"],
    legalComments: "none",
    metafile: true,
  });
  return { text: result.outputFiles[0].text.trim(), inputs: Object.keys(result.metafile.inputs) };
}

/** The names of the npm packages of which files are in the bundles. */
function bundledPackages(inputs) {
  const names = inputs.map((path) => path.match(/^node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[1]).filter(Boolean);
  return [...new Set(names)].sort();
}

function licenses(packages) {
  const texts = packages.map((name) => {
    const folder = join(here, "node_modules", name);
    const version = JSON.parse(readFileSync(join(folder, "package.json"), "utf8")).version;
    return `${name} ${version}\n\n${readFileSync(join(folder, "LICENSE"), "utf8").trim()}\n`;
  });
  return `report.html contains these libraries.\n\n${texts.join(`\n${"-".repeat(80)}\n\n`)}`;
}

/** As Content-Security-Policy wants it: of the bytes between the tags. */
const hash = (text) => `'sha256-${createHash("sha256").update(text, "utf8").digest("base64")}'`;

const script = await bundle("src/main.ts");
const style = await bundle("src/style.css");

// Such text would end the element early, or hide its end, when a browser reads the page.
if (/<\/script|<!--/i.test(script.text)) throw new Error("the program contains text that a script element must not contain");
if (/<\/style/i.test(style.text)) throw new Error("the styles contain text that a style element must not contain");

const policy = [
  "default-src 'none'",
  `script-src ${hash(script.text)}`,
  `style-src ${hash(style.text)}`,
  "img-src data: blob:",
  "connect-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

const parts = { POLICY: policy, STYLE: style.text, SCRIPT: script.text };
const template = readFileSync(join(here, "src/template.html"), "utf8");
// A function as the replacement: the bundle contains "$&" and the like.
const page = template.replace(/%(POLICY|STYLE|SCRIPT)%/g, (_match, name) => parts[name]);

mkdirSync(join(here, "dist"), { recursive: true });
writeFileSync(join(here, "dist/report.html"), page);
writeFileSync(join(here, "dist/LICENSES.txt"), licenses(bundledPackages([...script.inputs, ...style.inputs])));
console.log(`dist/report.html: ${Buffer.byteLength(page)} bytes`);
