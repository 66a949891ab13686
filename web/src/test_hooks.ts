/** What tests in a browser may use; described in README.md. */
export interface TestHooks {
  /** Done when the page shows its data, or says why it cannot. */
  ready: Promise<void>;
  view: {
    /** CSS px for each px of the canvas, and where the canvas' origin lies. */
    transform(): { k: number; x: number; y: number };
    fit(): void;
    /** Puts a point of the canvas into the middle. */
    centre(x: number, y: number, k: number): void;
    /** Index of the selected piece. */
    selected(): number | null;
    select(piece: number | null): void;
  } | null;
}

declare global {
  interface Window {
    tesseraReport: TestHooks;
  }
}
