/** Links: opens the experiment in the address, and makes the address of the current one. */
import { errorInfo } from "../../app/error-info.js";
import { makeShare } from "../../app/link.js";
import { byId, grouped, reveal } from "../../app/dom.js";
import { axesOf } from "../../domain/names.js";
import { decodeLink, encodeLink } from "./codec.js";
import { POSES, experimentOf, find } from "./experiment.js";

/** @import { Page } from "../page.js" */
/** @import { Session } from "../session.js" */
/** @import { Projector } from "../../app/projector.js" */
/** @import { Experiment } from "./codec.js" */
/** @import { GeneratorInfo, SceneEntry } from "../../domain/types.js" */

export class Link {
  /**
   * @param {Page} page
   * @param {SceneEntry[]} scenes
   * @param {GeneratorInfo[]} generators
   * @param {Projector} projector
   */
  constructor(page, scenes, generators, projector) {
    this.page = page;
    this.projector = projector;
    this.catalogue = { scenes, generators, page };
    /** The time in the link, until the run has reached it. @type {number | null} */
    this.wanted = null;
    /** The parts of the link that could not be restored. @type {string[]} */
    this.faults = [];
    const encode = async () => {
      await page.arrived();
      return encodeLink(experimentOf(page));
    };
    this.share = makeShare(page.app, encode, () => contentsOf(page.session));
    page.onOpen(() => {
      this.wanted = null;
    });
    page.onState(({ clock, playing, refusal, settled, growing }) => {
      const { wanted } = this;
      if (wanted === null) return;
      const isOver = playing || refusal || clock.now >= wanted;
      if (isOver || settled) this.wanted = null;
      if (isOver || !settled || growing) return;
      this.faults.push(`The run ends at ${timeText(clock)}, before ${grouped(wanted)}.`);
      this.complain();
    });
  }

  /**
   * Opens the experiment in a fragment; where it is damaged, the first scene unless one is open.
   * @param {string} fragment
   */
  async open(fragment) {
    const { page } = this;
    this.faults = [];
    const { experiment, fault } = await decodeLink(fragment);
    try {
      if (experiment) return await this.restore(experiment);
      if (!page.facts) await page.openScene(this.catalogue.scenes[0]);
      page.notice.show(fault, "");
    } catch (error) {
      if (!page.facts) await page.openScene(this.catalogue.scenes[0]);
      page.app.fail(error, "The link cannot be opened.");
    }
  }

  /** @param {Experiment} experiment @throws {Error} its scenario cannot be read */
  async restore(experiment) {
    const { page, catalogue, faults } = this;
    const { query, iteration, view } = experiment;
    const { source, entry, plans } = find(experiment, catalogue, faults);
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
    const {
      refused = false,
      strobe = false,
      poses = POSES,
      raw = false,
      slice = false,
      optimum = false,
      regions = false,
      projector = false,
      lens = "workspace",
    } = view;
    page.setView({ axes: areThere ? [across, up] : usual, refused, strobe, poses, raw, slice, optimum, regions });
    if (refused || strobe || raw || slice || optimum || regions) reveal(byId("view", HTMLElement));
    if (page.current.length > 1) reveal(byId("race", HTMLElement));
    this.projector.turn(projector);
    if (page.current.length > 1) page.race?.setPicture(lens);
    this.wanted = iteration;
    await this.restoreHand(experiment);
    if (faults.length > 0) this.complain();
  }

  /** The configuration in hand, or the drive by keys. @param {Experiment} experiment */
  async restoreHand({ pose, drive, roll, euler }) {
    const { page, faults } = this;
    const { session, facts } = page;
    const { plannings } = session;
    if (drive || roll || euler) {
      if (facts?.robot !== "car") return void faults.push("This robot cannot be driven.");
      const controls = await page.loadDrive();
      // Whoever drives does not plan.
      await page.arrived();
      if (session.plannings !== plannings) return;
      try {
        controls.restore(drive ?? {}, roll, euler);
      } catch (error) {
        if (errorInfo(error).code === "internal") throw error;
        faults.push(errorInfo(error).message.replace(/\.?$/, "."));
      }
    } else if (pose && pose.length !== facts?.dimension)
      faults.push(`The configuration has ${pose.length} numbers; one of this robot has ${facts?.dimension}.`);
    else if (pose) {
      reveal(byId("pose", HTMLElement));
      page.act(({ byHand }) => byHand.hold(Float64Array.from(pose)));
    }
  }

  complain() {
    this.page.notice.show("Parts of the link could not be restored.", this.faults.join(" "));
  }
}

/** What a link stores, in words. @param {Session} session */
function contentsOf({ clock, shown, driving }) {
  const hand = driving?.on
    ? driving.rollout
      ? "the drive with its control"
      : "the drive"
    : shown?.hand
      ? "the configuration in hand"
      : "";
  return hand
    ? `the scene, the settings, ${timeText(clock)} and ${hand}`
    : `the scene, the settings and ${timeText(clock)}`;
}

/** @param {{ now: number, isRace: boolean }} clock */
function timeText({ now, isRace }) {
  return isRace ? `${grouped(now)} clearance evaluations` : `iteration ${grouped(now)}`;
}
