/**
 * A link is an experiment: the fragment of the address holds what the room shows, and a button gives the address of it. What comes
 * in is checked by the room's own rule; a link that does not work is said not to, and the room opens as usual.
 */
import { byId, make } from "../app/dom.js";
import { packed, unpacked } from "../formats/deflate-json.js";
import { Fault, must } from "../formats/rules.js";

/** @import { Rule } from "../formats/rules.js" */
/** @import { Room } from "./room.js" */

/** Characters of a fragment at most, and bytes that it may unpack to. */
const MOST_FRAGMENT = 2048;
const MOST_BYTES = 16_384;
/** Milliseconds for which it says what it did. */
const READING = 6000;

/** @param {object} state  plain data that the rule allows @param {Rule} rule @returns {Promise<string>}  without `#` @throws {Error} in words */
export async function encodeState(state, rule) {
  rule(state, "state");
  const fragment = `1${await packed(state, MOST_BYTES)}`;
  must(fragment.length <= MOST_FRAGMENT, "it is too long");
  return fragment;
}

/**
 * @param {string} fragment  with or without `#` @param {Rule} rule
 * @returns {Promise<{ state: object, fault: null } | { state: null, fault: string }>}  never rejects
 */
export async function decodeState(fragment, rule) {
  try {
    must(fragment.length <= MOST_FRAGMENT + 1, "it is too long");
    const [, content] = /^#?1([\w-]+)$/.exec(fragment) ?? [];
    must(content, "it is not one of version 1");
    const state = await unpacked(content, MOST_BYTES);
    must(typeof state === "object" && state !== null, "state is wrong");
    rule(state, "state");
    return { state, fault: null };
  } catch (error) {
    return { state: null, fault: error instanceof Fault ? error.message : "This link does not work: it is damaged." };
  }
}

/**
 * The button `#link`, and the address that the page is opened with.
 * @template {object} S
 */
export class Link {
  /**
   * @param {Room} room @param {Rule} rule  what a state may be
   * @param {() => S} stateOf   of what is shown
   * @param {(state: S | null) => void | Promise<void>} put   shows it; null: what is shown where nothing is asked for
   * @param {string} what   what a link holds, in words
   */
  constructor(room, rule, stateOf, put, what) {
    this.room = room;
    this.rule = rule;
    this.stateOf = stateOf;
    this.put = put;
    this.what = what;
    this.button = byId("link", HTMLButtonElement);
    this.words = make("span", {});
    this.field = make("input", { type: "text", readOnly: true, ariaLabel: "Link", hidden: true });
    this.told = make("div", { id: "link-told", className: "told", role: "status" }, this.words, this.field);
    byId("tools", HTMLElement).append(this.told);
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
    this.button.addEventListener("click", () => void this.copy());
    this.told.addEventListener("keydown", ({ key }) => {
      if (key !== "Escape") return;
      this.say("");
      this.button.focus();
    });
    this.field.addEventListener("blur", () => this.say(""));
    addEventListener("hashchange", () => { if (location.hash) void room.await(this.obey()); });
  }

  /** Shows what the address asks for. */
  async obey() {
    const fragment = location.hash;
    if (fragment.length < 2) return this.put(null);
    const { state, fault } = await decodeState(fragment, this.rule);
    if (state) {
      try {
        await this.put(/** @type {S} */ (state));
        return undefined;
      } catch (error) {
        await this.put(null);
        this.room.notice.show("The link cannot be opened.", error);
        return undefined;
      }
    }
    await this.put(null);
    this.room.notice.show(fault ?? "", "");
    return undefined;
  }

  /** Gives the link: to the clipboard and the address bar where they are open to this page, else to be copied by hand. */
  async copy() {
    this.say("");
    try {
      const fragment = `#${await encodeState(this.stateOf(), this.rule)}`;
      try {
        history.replaceState(null, "", fragment);
      } catch {
        // a frame whose address is not its own: the link is told all the same
      }
      const link = location.href.split("#")[0] + fragment;
      try {
        await navigator.clipboard.writeText(link);
        this.say(`Link copied: ${this.what}.`);
      } catch {
        this.say(`Copy this link: ${this.what}.`, link);
      }
    } catch (error) {
      this.room.notice.show("There is no link to this.", error);
    }
  }

  /** @param {string} words @param {string} [link]   to be copied by hand */
  say(words, link = "") {
    clearTimeout(this.timer);
    this.words.textContent = words;
    this.field.hidden = link === "";
    this.field.value = link;
    if (link) this.field.select();
    else if (words) this.timer = setTimeout(() => this.say(""), READING);
  }
}
