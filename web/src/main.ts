import { showCampaign } from "./campaign/campaign_page.ts";
import { pageSource } from "./page_source.ts";
import { showResult } from "./result/result_page.ts";
import type { TestHooks } from "./test_hooks.ts";
import { element, printable } from "./ui/dom.ts";
import { restoreTheme } from "./ui/theme.ts";

async function start(page: HTMLElement): Promise<TestHooks["view"]> {
  // The browser shows the waiting text before the work begins.
  await new Promise((resolve) => setTimeout(resolve));
  const source = pageSource();
  return source.data.kind === "result" ? showResult(page, source, source.data) : showCampaign(page, source, source.data);
}

restoreTheme();
const page = document.getElementById("page")!;
const hooks: TestHooks = { ready: Promise.resolve(), view: null };
window.tesseraReport = hooks;
hooks.ready = start(page).then(
  (view) => {
    hooks.view = view;
  },
  (error: unknown) => {
    const text = error instanceof Error ? error.message : String(error);
    page.replaceChildren(
      element(
        "main",
        { class: "loading", "data-testid": "failure" },
        element("h1", {}, "This page cannot be shown"),
        element("p", {}, printable(text)),
      ),
    );
  },
);
