/**
 * A link is an experiment: the address that the page is opened with says what is put on the stage, and a button gives the
 * address of what is there.
 */
import { decodeLink, encodeLink } from "./codec.js";
import { axesOf } from "../../domain/names.js";
import { byId, grouped, make } from "../../app/dom.js";
import { POSES, experimentOf, find } from "./experiment.js";

/** @import { Page } from "../page.js" */
/** @import { Projector } from "../../app/projector.js" */
/** @import { Experiment } from "./codec.js" */
/** @import { GeneratorInfo, SceneEntry } from "../../domain/types.js" */

/** Milliseconds for which it says what it did. */
const READING = 6000;

export class Link {
  /** @param {Page} page @param {SceneEntry[]} scenes @param {GeneratorInfo[]} generators @param {Projector} projector */
  constructor(page, scenes, generators, projector) {
    this.page = page;
    this.projector = projector;
    this.house = { scenes, generators, page };
    /** The time that a link asks for and is not there yet. @type {number | null} */
    this.wanted = null;
    /** What of the link could not be had. @type {string[]} */
    this.faults = [];
    this.button = byId("link", HTMLButtonElement);
    this.words = make("span", {});
    this.field = make("input", { type: "text", readOnly: true, ariaLabel: "Link", hidden: true });
    this.told = make("div", { id: "link-told", className: "told", role: "status" }, this.words, this.field);
    byId("tools", HTMLElement).append(this.told);
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
    this.told.addEventListener("keydown", ({ key }) => {
      if (key !== "Escape") return;
      this.say("");
      this.button.focus();
    });
    this.field.addEventListener("blur", () => this.say(""));
    page.onOpen(() => { this.wanted = null; });
    page.onState((state) => {
      const { wanted } = this;
      if (wanted === null) return;
      const { now } = state.clock;
      if (state.playing || state.refusal || now >= wanted) this.wanted = null;
      else if (state.settled) {
        this.wanted = null;
        if (!state.growing) this.complain(`The run ends at ${time(now, state.clock.isRace)}, before ${grouped(wanted)}.`);
      }
    });
  }

  /** Puts what an address's fragment holds on the stage; where that cannot be, says so, and something is there all the same. @param {string} fragment */
  async obey(fragment) {
    const { page, house } = this;
    this.faults = [];
    const { experiment, fault } = await decodeLink(fragment);
    try {
      if (experiment) await this.put(experiment);
    } catch (error) {
      if (!page.facts) await page.openScene(house.scenes[0]);
      page.notice.show("The link cannot be opened.", error);
    }
    if (experiment) return;
    if (!page.facts) await page.openScene(house.scenes[0]);
    page.notice.show(fault, "");
  }

  /** @param {Experiment} experiment @throws {Error} its scenario cannot be read */
  async put(experiment) {
    const { page, house } = this;
    const { query, iteration, view } = experiment;
    /** @type {string[]} */
    const faults = [];
    const { source, entry, plans } = find(experiment, house, faults);
    const opening = { entry, query, plans, iteration, play: false };
    if (source) await page.open(source, opening);
    else if (!entry || !(await page.openScene(entry, opening))) return;
    const { facts } = page;
    if (!facts) return;
    if (query && facts.query !== query) faults.push(`This scene has no query "${query}".`);
    const usual = axesOf(facts.robot);
    const [across, up] = view.axes ?? usual;
    const areThere = Math.max(across, up) < facts.dimension && across !== up;
    if (view.axes && !areThere) faults.push(`This robot has no coordinates ${across} and ${up}.`);
    const { refused = false, strobe = false, poses = POSES, raw = false, slice = false, projector = false, lens = "workspace" } = view;
    page.see({ axes: areThere ? [across, up] : usual, refused, strobe, poses, raw, slice });
    this.projector.turn(projector);
    if (page.asked.length > 1) page.race?.look(lens);
    this.wanted = iteration;
    if (faults.length > 0) this.complain(...faults);
  }

  /** @param {...string} faults */
  complain(...faults) {
    this.faults.push(...faults);
    this.page.notice.show("Parts of the link could not be restored.", this.faults.join(" "));
  }

  /** Gives the link: to the clipboard and the address bar where they are open to this page, else to be copied by hand. */
  async copy() {
    const { page } = this;
    // What was asked for a moment ago belongs to it.
    const state = await page.arrived();
    if (!state) return;
    this.say("");
    try {
      const fragment = `#${await encodeLink(experimentOf(page))}`;
      try {
        history.replaceState(null, "", fragment);
      } catch {
        // a frame whose address is not its own: the link is told all the same
      }
      const link = location.href.split("#")[0] + fragment;
      const what = `the scene, the settings and ${time(state.clock.now, state.clock.isRace)}`;
      try {
        await navigator.clipboard.writeText(link);
        this.say(`Link copied. It stores ${what}.`);
      } catch {
        this.say(`Copy this link. It stores ${what}.`, link);
      }
    } catch (error) {
      page.notice.show("No link can be made.", error);
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

/** @param {number} now @param {boolean} isRace */
function time(now, isRace) { return isRace ? `${grouped(now)} clearance evaluations` : `iteration ${grouped(now)}`; }
