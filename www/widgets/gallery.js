/** The gallery of scenes, each with a thumbnail. */
import { byId, make } from "../app/dom.js";
import { button } from "./elements.js";

/** Side of a thumbnail, CSS pixels. */
export const SIDE = 84;

/** @template {{ id: string, title: string }} E @param {E[]} scenes @param {(entry: E) => void} onChoose */
export function makeGallery(scenes, onChoose) {
  const element = byId("scenes", HTMLElement);
  const cards = scenes.map((entry) => {
    const input = make("input", { type: "radio", name: "scene", value: entry.id, onchange: () => onChoose(entry) });
    const canvas = make("canvas", { ariaHidden: "true" });
    const card = make("label", { className: "card" }, input, canvas, make("span", {}, entry.title));
    return { id: entry.id, input, canvas, card };
  });
  const count = make("span", { className: "hint" });
  const more = button("all-scenes", "", () => {
    show(!element.classList.contains("all"));
    measure();
  });
  const size = make("p", { className: "gallery-size" }, count, more);
  element.append(...cards.map(({ card }) => card));
  element.after(size);
  show(false);
  // It also measures at first, with the layout of the first frame.
  new ResizeObserver(measure).observe(element);

  /** Shows all scenes one below the other, or a strip that scrolls. @param {boolean} all */
  function show(all) {
    element.classList.toggle("all", all);
    more.textContent = all ? "Show fewer" : "Show all";
    more.ariaExpanded = String(all);
  }

  /** Shows the number of scenes in view, unless all are. */
  function measure() {
    const isAll = element.classList.contains("all");
    const inView = cards.filter(({ card }) => card.offsetLeft + card.offsetWidth <= element.clientWidth + 1).length;
    size.hidden = !isAll && inView === cards.length;
    count.textContent = isAll ? `${cards.length} scenes` : `${inView} of ${cards.length} scenes`;
  }

  return {
    /** Marks the open scene; null for a file. @param {string | null} chosen */
    mark(chosen) {
      for (const { id, input, card } of cards) {
        input.checked = id === chosen;
        // Only the strip scrolls, not the page; in the next frame, as it would force a layout.
        if (input.checked)
          requestAnimationFrame(() =>
            element.scrollTo({ left: card.offsetLeft - (element.clientWidth - card.offsetWidth) / 2 }),
          );
      }
    },

    /** Shows a scene's thumbnail. @param {string} scene @param {ImageBitmap} picture */
    draw(scene, picture) {
      const canvas = cards.find(({ id }) => id === scene)?.canvas;
      if (!canvas) return;
      canvas.width = picture.width;
      canvas.height = picture.height;
      canvas.getContext("bitmaprenderer")?.transferFromImageBitmap(picture);
    },
  };
}
