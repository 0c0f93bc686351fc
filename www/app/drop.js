/** Files to open, scenarios or NumPy arrays: picked, or dropped anywhere on the page. */
import { byId } from "./dom.js";

/** @import { App } from "./app.js" */

/** Size of a file at most, bytes. */
const MOST = 10 * 1024 * 1024;

/** @param {App} app @param {(name: string, bytes: Uint8Array<ArrayBuffer>) => void} onFile */
export function watchFiles(app, onFile) {
  const input = byId("file", HTMLInputElement);
  const button = byId("open", HTMLButtonElement);
  const veil = byId("veil", HTMLElement);
  const read = (/** @type {File} */ file) => void app.track(open(file), `${file.name} could not be read.`);
  button.disabled = false;
  button.addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (file) read(file);
    input.value = "";
  });
  addEventListener("dragover", (event) => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    veil.hidden = false;
  });
  addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) veil.hidden = true;
  });
  addEventListener("drop", (event) => {
    veil.hidden = true;
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    read(file);
  });

  /** @param {File} file */
  async function open(file) {
    if (file.size > MOST) {
      throw Object.assign(new Error(`The file is ${(file.size / 1048576).toFixed(1)} MB; the limit is 10 MB.`), {
        code: "too-large",
      });
    }
    onFile(file.name, new Uint8Array(await file.arrayBuffer()));
  }
}

/** Whether a file is a NumPy array, by its name or its first byte. @param {string} name @param {Uint8Array} bytes */
export function isArray(name, bytes) {
  return /\.npy$/i.test(name) || bytes[0] === 0x93;
}
