/** Links: opens the experiment in the address, and makes the address of the current one. */
import { errorInfo } from "../../app/error-info.js";
import { makeShare } from "../../app/link.js";
import { byId, counted, grouped, reveal } from "../../app/dom.js";
import { completed, decodeLink, encodeLink, requireExperiment } from "./codec.js";
import { experimentOf, known } from "./experiment.js";

/** @import { App } from "../../app/app.js" */
/** @import { Moment, Open, Planners } from "./experiment.js" */
/** @import { Projector } from "../../app/projector.js" */
/** @import { Experiment } from "./codec.js" */
/** @import { GeneratorInfo, ScenarioDocument, SceneEntry } from "../../domain/types.js" */
/**
 * @typedef {object} State
 * @property {{ now: number, isRace: boolean }} clock
 * @property {boolean} playing
 * @property {boolean} growing
 * @property {boolean} settled
 * @property {object | null} refusal
 */
/** @typedef {Pick<Experiment, "drive" | "roll" | "euler">} Drive */
/** @typedef {(drive: NonNullable<Drive["drive"]>, roll: Drive["roll"], euler: Drive["euler"]) => void} Restore */
/**
 * @typedef {object} Host   what a link changes in the page
 * @property {App} app
 * @property {App["notice"]} notice
 * @property {Planners} planners
 * @property {Moment & { plannings: number }} session
 * @property {object | null} facts
 * @property {string} robot
 * @property {number} request
 * @property {Experiment | null} coming
 * @property {(patch: Partial<Experiment>, how?: { play: boolean }) => Promise<string[] | null>} open
 * @property {() => Promise<unknown>} arrived
 * @property {() => Promise<{ restore: Restore }>} loadDrive
 * @property {(listener: () => void) => void} onOpen
 * @property {(listener: (state: State) => void) => void} onState
 */
/** @typedef {Open & Host} Page */

/** What a link can show besides the run; the switches are under "View", and under "How much room". */
const SHOWN = /** @type {const} */ (["refused", "strobe", "raw", "slice", "optimum", "regions"]);
const ROOM = /** @type {const} */ (["widest", "safest", "routes"]);

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
    this.catalogue = { scenes, generators, planners: page.planners };
    /** What could not be restored of the experiment that is coming. @type {string[]} */
    this.faults = [];
    const encode = async () => {
      await page.arrived();
      const experiment = experimentOf(page);
      try {
        return await encodeLink(experiment);
      } catch (error) {
        if (!experiment.document) throw error;
        const { obstacles } = /** @type {ScenarioDocument} */ (/** @type {unknown} */ (experiment.document)).world;
        throw new Error(
          `A link stores the whole scene, and this one is too large for it, with ${counted(obstacles.length, "obstacle")}: save it as a scenario, under Export.`,
          { cause: error },
        );
      }
    };
    this.share = makeShare(page.app, encode, () => contentsOf(page.session));
    page.onOpen(() => {
      page.coming = null;
    });
    page.onState(({ clock, playing, refusal, settled, growing }) => {
      const { coming } = page;
      if (coming === null) return;
      const isOver = playing || refusal || clock.now >= coming.iteration;
      if (isOver || settled) page.coming = null;
      if (isOver || !settled || growing) return;
      this.faults.push(`The run ends at ${timeText(clock)}, before ${grouped(coming.iteration)}.`);
      this.complain(this.faults);
    });
  }

  /** Opens the experiment that was left. @param {object} left @returns {Promise<boolean>} whether it can be opened */
  async openLeft(left) {
    try {
      requireExperiment(left);
      await this.restore(completed(left));
      return true;
    } catch {
      return false;
    }
  }

  /**
   * Opens the experiment in a fragment; where it is damaged, the first scene unless one is open.
   * @param {string} fragment
   */
  async open(fragment) {
    const { page } = this;
    const request = ++page.request;
    const { experiment, fault } = await decodeLink(fragment);
    if (request !== page.request) return;
    try {
      if (experiment) return await this.restore(experiment);
      if (!page.facts) await page.open({ scene: this.catalogue.scenes[0].id });
      page.notice.show(fault, "");
    } catch (error) {
      if (!page.facts) await page.open({ scene: this.catalogue.scenes[0].id });
      page.app.fail(error, "The link cannot be opened.");
    }
  }

  /** @param {Experiment} experiment @throws {Error} its scenario cannot be read */
  async restore(experiment) {
    const { page, catalogue } = this;
    /** @type {string[]} */
    const faults = [];
    const unfit = await page.open({ timing: undefined, ...known(experiment, catalogue, faults) }, { play: false });
    if (!unfit) return;
    const { request } = page;
    faults.push(...unfit);
    const { view, ...rest } = experiment;
    this.projector.turn(view.projector ?? false);
    if (SHOWN.some((name) => view[name])) reveal(byId("view", HTMLElement));
    if (ROOM.some((name) => view[name])) reveal(byId("room", HTMLElement));
    if (page.plans.length > 1) reveal(byId("race", HTMLElement));
    if (rest.timing) reveal(byId("timing", HTMLElement));
    if (rest.pose) reveal(byId("pose", HTMLElement));
    this.faults = faults;
    page.coming = experiment;
    await this.drive(rest, faults);
    if (faults.length > 0 && page.request === request) this.complain(faults);
  }

  /**
   * Restores a drive by keys.
   * @param {Drive} experiment
   * @param {string[]} faults   a sentence is added to it where the drive cannot be restored
   */
  async drive({ drive, roll, euler }, faults) {
    const { page } = this;
    const { session } = page;
    if ((!drive && !roll && !euler) || page.robot !== "car") return;
    const { plannings } = session;
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
  }

  /** @param {string[]} faults */
  complain(faults) {
    this.page.notice.show("Parts of the link could not be restored.", faults.join(" "));
  }
}

/** What a link stores, in words. @param {Moment} session */
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
