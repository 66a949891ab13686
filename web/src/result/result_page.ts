import type { ResultData, Source } from "../data.ts";
import { loadResult, type Result } from "../model/result.ts";
import type { TestHooks } from "../test_hooks.ts";
import { announcer } from "../ui/announce.ts";
import { keysHelp } from "../ui/header.ts";
import { linkViewers } from "../view/link.ts";
import { addKeys, kKeys } from "./keyboard.ts";
import { Session } from "./session.ts";
import { Variants } from "./variants.ts";
import { workspace } from "./workspace.ts";

/** The page of a result: it shows one result, and on a server also those that were refined from it. */
class ResultPage {
  session: Session;
  private readonly variants: Variants | null;
  private readonly keys = keysHelp(kKeys);
  private tab = "piece";
  private unlink: () => void = () => {};
  private shown = new AbortController();

  constructor(
    private readonly page: HTMLElement,
    first: Result,
  ) {
    this.variants = first.data.served ? new Variants(first, (name) => this.show(name)) : null;
    this.session = new Session(first);
    this.build(null);
    addKeys(
      () => this.session,
      () => this.keys[0].click(),
    );
  }

  private show(name: string, beside: string | null = null): void {
    void this.variants!.attempt(() => this.showLoaded(name, beside));
  }

  /** Shows another result, at the same place, with the same tab open. */
  private async showLoaded(name: string, beside: string | null): Promise<void> {
    const result = await this.variants!.load(name);
    const other = beside === null ? null : await this.variants!.load(beside);
    const from = this.session;
    const { viewer, marks, result: before } = from;
    const place = viewer.place();
    // The marks stay with their pieces, when only the picture has come or the panes change.
    const same = before.data.pieces_digest === result.data.pieces_digest;
    this.session = new Session(result, same ? marks : undefined);
    this.session.takeTools(from);
    this.build(other);
    if (place) this.session.viewer.centre(place.x, place.y, place.k);
  }

  private build(beside: Result | null): void {
    this.unlink();
    this.shown.abort();
    this.shown = new AbortController();
    const { session, variants } = this;
    const { name } = session.result.data;
    const space = workspace(session, {
      base: variants?.baseOf(name) ?? null,
      beside,
      beside_base: beside ? (variants?.baseOf(beside.data.name) ?? null) : null,
      variants,
      until: this.shown.signal,
      tab: this.tab,
      keys_button: this.keys[0],
      tabChanged: (tab) => {
        this.tab = tab;
      },
      show: (other) => this.show(other),
      compare: (other) => this.show(name, other),
      closeCompare: () => this.show(name),
    });
    this.page.replaceChildren(space.element, announcer(), this.keys[1]);
    this.unlink = space.other_viewer ? linkViewers([session.viewer, space.other_viewer]) : () => {};
  }
}

export function showResult(page: HTMLElement, source: Source, data: ResultData): NonNullable<TestHooks["view"]> {
  if (document.title === "") document.title = data.name;
  const shown = new ResultPage(page, loadResult(source, data));
  return {
    transform: () => {
      const { k, x, y } = shown.session.viewer.transform;
      return { k, x, y };
    },
    fit: () => shown.session.viewer.fit(false),
    centre: (x, y, k) => shown.session.viewer.centre(x, y, k),
    selected: () => shown.session.selected.get(),
    select: (piece) => shown.session.select(piece),
  };
}
