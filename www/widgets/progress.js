/**
 * The progress of a file that takes a while to make: a bar, a button that cancels it, and a line about what came of it.
 */
import { make, write } from "../app/dom.js";
import { save } from "../app/files.js";
import { button } from "./elements.js";

export class Progress {
  /** @param {() => void} onChange   it begins or ends */
  constructor(onChange) {
    this.onChange = onChange;
    /** Number of the latest file; an older one is cancelled. */
    this.turn = 0;
    this.bar = make("progress", { max: 1, value: 0, ariaLabel: "Progress" });
    this.row = make(
      "div",
      { className: "row", id: "export-progress", hidden: true },
      this.bar,
      button("export-cancel", "Cancel", () => this.cancel()),
    );
    this.result = make("p", { className: "hint", id: "export-told", role: "status" });
  }

  /** Whether a file is being made. */
  get isBusy() {
    return !this.row.hidden;
  }

  cancel() {
    this.turn++;
  }

  /**
   * Makes a file, saves it, and says how large it is. Another one that is being made is cancelled.
   * @param {string} name
   * @param {(onProgress: (part: number) => boolean) => Promise<Blob | null>} makeFile   `onProgress` returns whether to
   *   continue; null: cancelled
   */
  async save(name, makeFile) {
    const mine = ++this.turn;
    const began = performance.now();
    this.bar.value = 0;
    write(this.result, "");
    this.row.hidden = false;
    this.onChange();
    try {
      const blob = await makeFile((part) => {
        this.bar.value = part;
        return mine === this.turn;
      });
      if (blob) save(blob, name);
      write(
        this.result,
        blob
          ? `${name}, ${sizeText(blob.size)}, in ${((performance.now() - began) / 1000).toFixed(1)} s.`
          : "Cancelled.",
      );
    } finally {
      this.row.hidden = true;
      this.onChange();
    }
  }
}

/** @param {number} bytes */
function sizeText(bytes) {
  return bytes < 1e6 ? `${Math.ceil(bytes / 1000)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}
