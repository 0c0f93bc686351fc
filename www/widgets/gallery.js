/** The gallery of scenes, each with a thumbnail. */
import { byId, make } from "../app/dom.js";
import { button } from "./elements.js";

/** Side of a thumbnail, CSS pixels. */
export const SIDE = 84;

/** @template {{ id: string, title: string }} E */
export class Gallery {
  /** @param {E[]} scenes @param {(entry: E) => void} onChoose */
  constructor(scenes, onChoose) {
    this.element = byId("scenes", HTMLElement);
    /** @type {Map<string, { input: HTMLInputElement, canvas: HTMLCanvasElement }>} */
    this.cards = new Map();
    for (const entry of scenes) {
      const input = make("input", { type: "radio", name: "scene", value: entry.id, onchange: () => onChoose(entry) });
      const canvas = make("canvas", { ariaHidden: "true" });
      this.cards.set(entry.id, { input, canvas });
      this.element.append(make("label", { className: "card" }, input, canvas, make("span", {}, entry.title)));
    }
    this.count = make("span", { className: "hint" });
    this.more = button("all-scenes", "", () => {
      this.show(!this.element.classList.contains("all"));
      this.measure();
    });
    this.size = make("p", { className: "gallery-size" }, this.count, this.more);
    this.element.after(this.size);
    this.show(false);
    // It also measures at first, with the layout of the first frame.
    new ResizeObserver(() => this.measure()).observe(this.element);
  }

  /** Shows all scenes one below the other, or a strip that scrolls. @param {boolean} all */
  show(all) {
    this.element.classList.toggle("all", all);
    this.more.textContent = all ? "Show fewer" : "Show all";
    this.more.ariaExpanded = String(all);
  }

  /** Shows the number of scenes in view, unless all are. */
  measure() {
    const { element, cards } = this;
    const isAll = element.classList.contains("all");
    const inView = [...cards.values()].filter(({ input: { parentElement: card } }) => card && card.offsetLeft + card.offsetWidth <= element.clientWidth + 1).length;
    this.size.hidden = !isAll && inView === cards.size;
    this.count.textContent = isAll ? `${cards.size} scenes` : `${inView} of ${cards.size} scenes`;
  }

  /** Marks the open scene; null for a file. @param {string | null} id */
  mark(id) {
    for (const [name, { input }] of this.cards) {
      input.checked = name === id;
      const card = input.parentElement;
      if (name !== id || !card) continue;
      // Only the strip scrolls, not the page; in the next frame, as it would force a layout.
      requestAnimationFrame(() => this.element.scrollTo({ left: card.offsetLeft - (this.element.clientWidth - card.offsetWidth) / 2 }));
    }
  }

  /** Shows a scene's thumbnail. @param {string} id @param {ImageBitmap} picture */
  draw(id, picture) {
    const canvas = this.cards.get(id)?.canvas;
    if (!canvas) return;
    canvas.width = picture.width;
    canvas.height = picture.height;
    canvas.getContext("bitmaprenderer")?.transferFromImageBitmap(picture);
  }
}
