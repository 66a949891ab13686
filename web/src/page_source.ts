import { kFormat, type PageData, type Source } from "./data.ts";
import { decodeBase64 } from "./util/base64.ts";

function checkedData(data: PageData): PageData {
  if (data.format !== kFormat) throw new Error(`this page shows format ${kFormat}, but the data have format ${data.format}`);
  return data;
}

/** The data that lie in the page itself. */
export function pageSource(): Source {
  const text = document.getElementById("data")?.textContent;
  if (!text) throw new Error("this page is the empty template: Tessera puts a result into it");
  return {
    data: checkedData(JSON.parse(text) as PageData),
    block(name) {
      const block = document.getElementById(name);
      // Only blocks: an id of the page's own controls could have the same name.
      return block instanceof HTMLScriptElement && block.type === "text/plain" ? decodeBase64(block.textContent ?? "") : null;
    },
  };
}

/** The data of an answer of the server. */
export function answerSource(data: PageData, blocks: Record<string, string>): Source {
  return {
    data: checkedData(data),
    block: (name) => (Object.hasOwn(blocks, name) ? decodeBase64(blocks[name]!) : null),
  };
}
