/**
 * The share link: the fragment of the address stores the state of the page, and a button gives the address. Each page
 * describes its state by one rule, with defaults for entries that a link leaves out.
 */
import { byId, make } from "./dom.js";
import { LazyFeature } from "./lazy-feature.js";
import { keepState, takeState } from "./left.js";
import { isAbort } from "./work.js";
import { decodeFragment, encodeFragment } from "../formats/fragment.js";

/** @import { Limits } from "../formats/fragment.js" */
/** @import { Rule } from "../formats/rules.js" */
/** @import { App } from "./app.js" */

/** @typedef {Rule & { defaults?: Record<string, unknown>, limits?: Limits }} StateRule */

const LIMITS = { characters: 2048, bytes: 16_384 };
/** Milliseconds for which a message stays. */
const READING = 6000;
/** Milliseconds after the page has opened at which what a print needs is loaded. */
const PRINT = 1500;

/**
 * @param {object} state  plain data that the rule allows
 * @param {StateRule} rule
 * @returns {Promise<string>}  without `#`
 * @throws {Error} in words
 */
export async function encodeState(state, rule) {
  rule(state, "state");
  const { defaults = {}, limits = LIMITS } = rule;
  const isDefault = (/** @type {string} */ key, /** @type {unknown} */ value) =>
    JSON.stringify(value) === JSON.stringify(defaults[key]);
  return encodeFragment(
    Object.fromEntries(Object.entries(state).filter(([key, value]) => !isDefault(key, value))),
    limits,
  );
}

/**
 * @param {string} fragment  with or without `#` @param {StateRule} rule
 * @returns {Promise<{ state: object, fault: "" } | { state: null, fault: string }>}  never rejects
 */
export async function decodeState(fragment, rule) {
  const { value, fault } = await decodeFragment(fragment, rule.limits ?? LIMITS, (content) => rule(content, "state"));
  return fault ? { state: null, fault } : { state: { ...rule.defaults, .../** @type {object} */ (value) }, fault: "" };
}

/**
 * Makes the message beside the button `#link`.
 * @param {App} app
 * @param {() => Promise<string>} encode  the fragment, without `#`
 * @param {() => string} contents  of a link, in words
 * @returns {() => Promise<void>} copies the link, or shows it where the page may not use the clipboard
 */
export function makeShare(app, encode, contents) {
  let timer = 0;
  const words = make("span", {});
  const field = make("input", {
    type: "text",
    readOnly: true,
    ariaLabel: "Link",
    hidden: true,
    onblur: () => show(""),
  });
  const message = make("div", { id: "link-told", className: "told", role: "status" }, words, field);
  byId("tools", HTMLElement).append(message);
  message.addEventListener("keydown", ({ key }) => {
    if (key !== "Escape") return;
    show("");
    byId("link", HTMLElement).focus();
  });
  return async () => {
    try {
      const fragment = `#${await encode()}`;
      show("");
      setAddress(fragment);
      const link = location.href.split("#")[0] + fragment;
      try {
        await navigator.clipboard.writeText(link);
        show(`Link copied. It stores ${contents()}.`);
      } catch {
        show(`Copy this link. It stores ${contents()}.`, link);
      }
    } catch (error) {
      app.fail(error, "No link can be made.");
    }
  };

  /** @param {string} text @param {string} [link]   to copy by hand */
  function show(text, link = "") {
    clearTimeout(timer);
    words.textContent = text;
    field.hidden = link === "";
    field.value = link;
    if (link) field.select();
    else if (text) timer = window.setTimeout(() => show(""), READING);
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
 * What a link stores and how it is opened.
 * @typedef {object} Link
 * @property {() => object} save   the state
 * @property {string} [spare]   an entry that is left out of a link that would be too long with it, which then is not
 *   whole
 * @property {() => object} [leave]   the state in which the page is left, where it has more than that of a link
 * @property {(state: any, signal: AbortSignal, isLeft: boolean) => unknown} open   gets null where the address has no
 *   state, and may throw; the signal: something else is opened meanwhile; `isLeft`: the reader comes back to it
 * @property {string | ((isWhole: boolean) => string)} contents   of the link, in words
 */

/**
 * Makes the share button, the code of a frame and the printed link, and opens the state in the address, now and
 * whenever the address changes; on the way back to the page, the state in which it was left.
 * @param {App} app @param {StateRule} rule @param {Link} link
 * @param {(act: (signal: AbortSignal) => unknown) => Promise<unknown>} opening   of which only the newest counts
 */
export async function useLink(app, rule, { save, spare = "", leave = save, open, contents }, opening) {
  let isWhole = true;
  const encode = async (/** @type {Record<string, unknown>} */ state = { ...save() }) => {
    isWhole = true;
    try {
      return await encodeState(state, rule);
    } catch (error) {
      if (!(spare in state)) throw error;
      isWhole = false;
      return await encodeState({ ...state, [spare]: undefined }, rule);
    }
  };
  const share = makeShare(
    app,
    () => encode(),
    () => (typeof contents === "string" ? contents : contents(isWhole)),
  );
  byId("link", HTMLElement).addEventListener("click", () => void share());
  new LazyFeature(app.notice, async () =>
    (await import("./embed-code.js")).showEmbedCode(app, byId("export", HTMLElement), () => encode()),
  ).inFold("export-fold");
  const printing = new LazyFeature(app.notice, () => import("./printed-link.js"));
  setTimeout(() => printing.use(({ printLink }) => printLink(() => ({ ...save() }), encode)), PRINT);
  /** Whether there is a state to return to. */
  let isOpen = false;
  /** Whether something has been opened, or not been opened. */
  let isBegun = false;
  /** What is being opened. @type {Record<string, unknown> | null} */
  let coming = null;
  keepState(() => {
    const state = coming ?? (isBegun ? { ...leave() } : null);
    if (!state || !(spare in state)) return state;
    try {
      rule(state, "state");
      return state;
    } catch {
      return { ...state, [spare]: undefined };
    }
  });
  addEventListener("hashchange", () => {
    if (location.hash) void app.track(opening(openAddress));
  });
  const left = takeState();
  await opening(left ? openLeft : openAddress);

  /** Opens the state in which the page was left, or else that in the address. @param {AbortSignal} signal */
  async function openLeft(signal) {
    try {
      rule(left, "state");
      await enter({ ...rule.defaults, ...left }, signal, true);
      isOpen = true;
    } catch (error) {
      if (isAbort(error) || signal.aborted) throw error;
      await openAddress(signal);
    }
  }

  /**
   * Opens a state; until it is open, it is the one in which the page is left.
   * @param {Record<string, unknown> | null} state @param {AbortSignal} signal @param {boolean} [isLeft]
   */
  async function enter(state, signal, isLeft = false) {
    coming = state;
    try {
      await open(state, signal, isLeft);
      signal.throwIfAborted();
    } finally {
      if (coming === state) coming = null;
      isBegun = true;
    }
  }

  /**
   * Opens the state in the address; where it is refused, all is as it was.
   * @param {AbortSignal} signal
   */
  async function openAddress(signal) {
    const { state, fault } =
      location.hash.length < 2 ? { state: null, fault: "" } : await decodeState(location.hash, rule);
    signal.throwIfAborted();
    const before = isOpen ? save() : null;
    if (state) app.notice.hide();
    try {
      await enter(/** @type {Record<string, unknown> | null} */ (state), signal);
      if (fault) app.notice.show(fault, "");
    } catch (error) {
      // Something else has begun meanwhile.
      if (!state || isAbort(error) || signal.aborted) throw error;
      if (!before || JSON.stringify(save()) !== JSON.stringify(before)) await open(before, signal, false);
      app.fail(error, "The link cannot be opened.");
    }
    isOpen = true;
  }
}
