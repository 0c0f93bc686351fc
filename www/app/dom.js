/**
 * The element with an id, of a known kind.
 * @template {Element} E
 * @param {string} id
 * @param {new () => E} kind
 */
export function byId(id, kind) {
  const element = document.getElementById(id);
  if (!(element instanceof kind)) throw new Error(`The page has no ${kind.name} with the id "${id}".`);
  return element;
}

/** Opens the folds that an element is in. @param {Element | null | undefined} element */
export function reveal(element) {
  for (let fold = element?.closest("details"); fold; fold = fold.parentElement?.closest("details")) fold.open = true;
}

/** Keeps a page's fold "More" as the reader leaves it, while the tab is open. */
export function keepMore() {
  const fold = /** @type {HTMLDetailsElement | null} */ (document.querySelector("details.fold.more"));
  if (!fold) return;
  const key = `more ${location.pathname}`;
  try {
    fold.open = sessionStorage.getItem(key) === "open";
  } catch {
    // A sandboxed frame stores nothing.
  }
  fold.addEventListener("toggle", () => {
    try {
      sessionStorage.setItem(key, fold.open ? "open" : "");
    } catch {
      // Nor does a tab whose storage is full.
    }
  });
}

/**
 * @template {keyof HTMLElementTagNameMap} T
 * @typedef {Omit<Partial<HTMLElementTagNameMap[T]>, "dataset"> & { dataset?: Record<string, unknown> }} Properties
 */

const FIELDS = ["input", "select", "textarea"];

/**
 * A new element with properties, data attributes and children. Fields are not filled in by the browser when a page is
 * opened again: their values are the page's to restore.
 * @template {keyof HTMLElementTagNameMap} T
 * @param {T} tag
 * @param {Properties<T>} [properties]
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[T]}
 */
export function make(tag, { dataset = {}, ...properties } = /** @type {Properties<T>} */ ({}), ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  if (FIELDS.includes(tag) && !element.matches("[type=file]")) element.setAttribute("autocomplete", "off");
  Object.assign(element.dataset, dataset);
  element.append(...children);
  return element;
}

/**
 * A new SVG element.
 * @template {keyof SVGElementTagNameMap} T
 * @param {T} tag @param {Record<string, string | number>} attributes @param {...(Node | string)} children
 */
export function makeSvg(tag, attributes, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

/**
 * A whole number with commas between thousands. The first `Intl.NumberFormat` of a page takes 26 ms.
 * @param {number} count
 */
export function grouped(count) {
  return String(count).replace(/\B(?=(\d{3})+$)/g, ",");
}

/** A number of things in words. @param {number} count @param {string} one @param {string} [many] */
export function counted(count, one, many = `${one}s`) {
  return `${grouped(count)} ${count === 1 ? one : many}`;
}

/** Words as a list: "a, b and c". @param {string[]} words */
export function listed(words) {
  return [words.slice(0, -1).join(", "), ...words.slice(-1)].filter(Boolean).join(" and ");
}

/** @param {HTMLElement} element @param {string} text */
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
