import { element, printable } from "../ui/dom.ts";
import { copyButton } from "../ui/files.ts";
import type { Session } from "./session.ts";

/** The job file that makes the same collage again. */
export function jobTab(session: Session): HTMLElement {
  const { job } = session.result.data;
  const text = element("pre", { class: "code", tabindex: 0, role: "region", "aria-label": "job.toml", "data-testid": "job-text" });
  text.textContent = printable(job);
  return element(
    "div",
    {},
    element("h2", {}, "Job"),
    element("p", { class: "note" }, "The effective job.toml, with every key. As a job file it gives the same collage."),
    element(
      "div",
      { class: "row" },
      copyButton("Copy", "job-copy", () => job, text),
    ),
    text,
  );
}
