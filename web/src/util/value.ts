/** A value that tells others when it changes. */
export class Value<T> {
  private readonly listeners = new Set<(value: T) => void>();

  constructor(private current: T) {}

  get(): T {
    return this.current;
  }

  /** Tells the listeners only if the value differs. */
  set(value: T): void {
    if (Object.is(value, this.current)) return;
    this.current = value;
    for (const listener of [...this.listeners]) listener(value);
  }

  /** Calls `listener` now and after each change, until the signal. */
  watch(listener: (value: T) => void, until?: AbortSignal): void {
    this.listeners.add(listener);
    until?.addEventListener("abort", () => this.listeners.delete(listener));
    listener(this.current);
  }
}
