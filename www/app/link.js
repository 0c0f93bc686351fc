/**
 * The share link: the fragment of the address stores the state of the page, and a button gives the address. Each page describes
 * its state by one rule, with defaults for entries that a link leaves out.
 */
import { byId, make } from "./dom.js";
import { decodeFragment, encodeFragment } from "../formats/fragment.js";

/** @import { Rule } from "../formats/rules.js" */
/** @import { App } from "./app.js" */

/** @typedef {Rule & { defaults?: Record<string, unknown> }} StateRule */

const LIMITS = { characters: 2048, bytes: 16_384 };
/** Milliseconds for which a message stays. */
const READING = 6000;

/** @param {object} state  plain data that the rule allows @param {StateRule} rule @returns {Promise<string>}  without `#` @throws {Error} in words */
export async function encodeState(state, rule) {
  rule(state, "state");
  const { defaults = {} } = rule;
  const isDefault = (/** @type {string} */ key, /** @type {unknown} */ value) => JSON.stringify(value) === JSON.stringify(defaults[key]);
  return encodeFragment(Object.fromEntries(Object.entries(state).filter(([key, value]) => !isDefault(key, value))), LIMITS);
}

/**
 * @param {string} fragment  with or without `#` @param {StateRule} rule
 * @returns {Promise<{ state: object, fault: "" } | { state: null, fault: string }>}  never rejects
 */
export async function decodeState(fragment, rule) {
  const { value, fault } = await decodeFragment(fragment, LIMITS, (content) => rule(content, "state"));
  return fault ? { state: null, fault } : { state: { ...rule.defaults, .../** @type {object} */ (value) }, fault: "" };
}

/** The button `#link` and the message beside it. */
export class ShareButton {
  /** @param {App} app @param {() => Promise<string>} encode  the fragment, without `#` @param {() => string} contents  of a link, in words */
  constructor(app, encode, contents) {
    this.app = app;
    this.encode = encode;
    this.contents = contents;
    this.button = byId("link", HTMLButtonElement);
    this.words = make("span", {});
    this.field = make("input", { type: "text", readOnly: true, ariaLabel: "Link", hidden: true });
    this.message = make("div", { id: "link-told", className: "told", role: "status" }, this.words, this.field);
    byId("tools", HTMLElement).append(this.message);
    this.timer = 0;
    this.message.addEventListener("keydown", ({ key }) => {
      if (key !== "Escape") return;
      this.show("");
      this.button.focus();
    });
    this.field.addEventListener("blur", () => this.show(""));
  }

  /** Copies the link, or shows it where the page may not use the clipboard. */
  async copy() {
    try {
      const fragment = `#${await this.encode()}`;
      this.show("");
      setAddress(fragment);
      const link = location.href.split("#")[0] + fragment;
      try {
        await navigator.clipboard.writeText(link);
        this.show(`Link copied. It stores ${this.contents()}.`);
      } catch {
        this.show(`Copy this link. It stores ${this.contents()}.`, link);
      }
    } catch (error) {
      this.app.fail(error, "No link can be made.");
    }
  }

  /** @param {string} text @param {string} [link]   to copy by hand */
  show(text, link = "") {
    clearTimeout(this.timer);
    this.words.textContent = text;
    this.field.hidden = link === "";
    this.field.value = link;
    if (link) this.field.select();
    else if (text) this.timer = window.setTimeout(() => this.show(""), READING);
  }
}

/** Changes the address, where the page may. @param {string} fragment  with `#`, or empty */
export function setAddress(fragment) {
  try {
    history.replaceState(null, "", fragment || location.pathname + location.search);
  } catch {
    // A sandboxed frame cannot change its address.
  }
}

/**
 * Makes the share button, and opens the state in the address, now and whenever the address changes.
 * @param {App} app @param {StateRule} rule
 * @param {{ save: () => object, open: (state: any) => unknown, contents: string }} page  `open` gets null where the address has no state, and may throw
 */
export async function useLink(app, rule, { save, open, contents }) {
  const share = new ShareButton(app, () => encodeState(save(), rule), () => contents);
  share.button.addEventListener("click", () => void share.copy());
  addEventListener("hashchange", () => { if (location.hash) void app.track(openAddress()); });
  await openAddress();

  async function openAddress() {
    if (location.hash.length < 2) return void await open(null);
    const { state, fault } = await decodeState(location.hash, rule);
    try {
      await open(state);
      if (state) app.notice.hide();
      else app.notice.show(fault, "");
    } catch (error) {
      await open(null);
      app.fail(error, "The link cannot be opened.");
    }
  }
}
