import type { RefineRequest, ServerState } from "../data.ts";
import { loadResult, type Result } from "../model/result.ts";
import { Value } from "../util/value.ts";
import { fetchResult, fetchState, refine, stopRefining } from "./server.ts";

const kPoll_ms = 100;

export type VariantState = ServerState["results"][number];

/** The results that the server has, and what is loaded of them. */
export class Variants {
  readonly list = new Value<readonly VariantState[]>([]);
  /** What went wrong last; "" after a success. */
  readonly trouble = new Value("");
  private readonly loaded = new Map<string, Result>();
  private awaited = "";
  private polling = false;

  /** `show` is called with the result that the user waits for, first without and then with its picture. */
  constructor(
    first: Result,
    private readonly show: (name: string) => void,
  ) {
    this.loaded.set(first.data.name, first);
    void this.poll();
  }

  get(name: string): Result | null {
    return this.loaded.get(name) ?? null;
  }

  /** The result that lends its picture to one that has none: the nearest of its ancestors with a picture. */
  baseOf(name: string): Result | null {
    let from = this.list.get().find((variant) => variant.name === name)?.from;
    for (let steps = 0; from && steps < 100; ++steps) {
      const base = this.get(from);
      if (base?.data.picture) return base;
      const above: string = from;
      from = this.list.get().find((variant) => variant.name === above)?.from;
    }
    return null;
  }

  get running(): VariantState | undefined {
    return this.list.get().find((variant) => variant.state === "running");
  }

  /** Loads a result unless what is loaded is as good as what the server has. */
  async load(name: string): Promise<Result> {
    const known = this.get(name);
    const state = this.list.get().find((variant) => variant.name === name);
    if (known && (known.data.picture || !state?.has_picture)) return known;
    const source = await fetchResult(name);
    const result = loadResult(source, source.data);
    this.loaded.set(name, result);
    return result;
  }

  async refine(request: RefineRequest): Promise<void> {
    this.trouble.set("");
    const begin = async (): Promise<void> => {
      this.awaited = await refine(request);
    };
    if (await this.attempt(begin)) await this.poll();
  }

  async stop(): Promise<void> {
    this.trouble.set("");
    await this.attempt(stopRefining);
  }

  /** Whether it succeeded; a failure is told. */
  async attempt(action: () => Promise<unknown>): Promise<boolean> {
    try {
      await action();
      return true;
    } catch (error) {
      this.trouble.set(error instanceof Error ? error.message : String(error));
      return false;
    }
  }

  /** Asks for the state until nothing runs or is awaited any more, or the server is gone. */
  private async poll(): Promise<void> {
    if (this.polling) return;
    this.polling = true;
    while (await this.attempt(async () => this.take((await fetchState()).results))) {
      await this.attempt(() => this.showAwaited());
      if (!this.running && this.awaited === "") break;
      await new Promise((resolve) => setTimeout(resolve, kPoll_ms));
    }
    // If the server is gone, nobody learns any more how its work ends.
    this.take(this.list.get().map((variant) => (variant.state === "running" ? { ...variant, state: "failed" } : variant)));
    this.awaited = "";
    this.polling = false;
  }

  /** Tells of changes only: whoever walks through the list with the keyboard keeps their place. */
  private take(now: readonly VariantState[]): void {
    if (JSON.stringify(now) !== JSON.stringify(this.list.get())) this.list.set(now);
  }

  /** Shows what there is of the awaited result, and says so where it failed. Another one may be awaited afterwards. */
  private async showAwaited(): Promise<void> {
    const state = this.list.get().find((variant) => variant.name === this.awaited);
    if (!state) return;
    if (state.state !== "running") this.awaited = "";
    if (state.state === "failed" || state.state === "stopped") this.trouble.set(`${state.name}: ${state.message || state.state}`);
    if (!state.has_pieces) return;
    const before = this.get(state.name);
    // While it runs its files may change under the server's hands; the next answer has them whole.
    const now = state.state === "running" ? await this.load(state.name).catch(() => before) : await this.load(state.name);
    if (now !== before) this.show(state.name);
  }
}
