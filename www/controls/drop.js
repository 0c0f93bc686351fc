/** A scenario from the reader's own disk: picked, or dropped anywhere on the page. */
import { byId } from "./dom.js";

/** Largest file that is read, bytes. */
const MOST = 10 * 1024 * 1024;

/**
 * @param {(name: string, text: string) => void} onText
 * @param {(name: string, error: Error) => void} onError   the file could not be read
 */
export function watchFiles(onText, onError) {
  const input = byId("file", HTMLInputElement);
  const button = byId("open", HTMLButtonElement);
  const veil = byId("veil", HTMLElement);
  button.disabled = false;
  button.addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (file) void read(file);
    input.value = "";
  });
  addEventListener("dragover", (event) => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    veil.hidden = false;
  });
  addEventListener("dragleave", (event) => { if (!event.relatedTarget) veil.hidden = true; });
  addEventListener("drop", (event) => {
    veil.hidden = true;
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    void read(file);
  });

  /** @param {File} file */
  async function read(file) {
    try {
      if (file.size > MOST) throw new Error(`It has ${(file.size / 1048576).toFixed(1)} MB; at most 10 MB are read.`);
      onText(file.name, await file.text());
    } catch (error) {
      onError(file.name, error instanceof Error ? error : new Error(String(error)));
    }
  }
}
