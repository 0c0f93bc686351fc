/** Files to open: picked, or dropped anywhere on the page. */
import { byId } from "./dom.js";

/** @param {(files: File[]) => void} onFiles   at least one */
export function watchFiles(onFiles) {
  const input = byId("file", HTMLInputElement);
  const button = byId("open", HTMLButtonElement);
  const veil = byId("veil", HTMLElement);
  const take = (/** @type {FileList | null | undefined} */ files) => files?.length && onFiles([...files]);
  button.disabled = false;
  button.addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    take(input.files);
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
    if (!event.dataTransfer?.files.length) return;
    event.preventDefault();
    take(event.dataTransfer.files);
  });
}
