/**
 * A race: the panel's planner and up to three rivals on one scenario, with the same number of clearance evaluations.
 * Each planner has a figure on the stage and a row in the table.
 */
import { letter } from "./standings.js";
import { byId, make } from "../../app/dom.js";
import { button } from "../../widgets/elements.js";
import { Rival } from "./rival.js";
import { Table } from "./table.js";

/** @import { Planners } from "../settings/planners.js" */
/** @import { Racer } from "./table.js" */
/** @import { PaneKind, Plan, PlannerInfo, Scenario } from "../../domain/types.js" */
/**
 * @typedef {object} Figures   the figures on the stage
 * @property {HTMLElement} element
 * @property {(wanted: { id: string, kind: PaneKind, lane: number, caption: string }[]) => void} show
 * @property {(lane: number, text: string) => void} setStanding
 */
/**
 * @typedef {object} Page   what a race takes of the page
 * @property {{ on: { seeds: (() => void) | null } }} panel
 * @property {Planners} planners
 * @property {Scenario["robot"]} robot
 * @property {{ lanes: Plan[], view: { lens?: PaneKind } }} record
 * @property {{ robot: string, dimension: number } | null} facts
 * @property {Plan[]} plans
 * @property {string[]} names
 * @property {Race | null} race
 * @property {(patch: { lanes: Plan[] }) => void} change
 * @property {(view: { lens: PaneKind }) => void} setView
 * @property {(listener: (state: { lanes: Racer[] }) => void) => void} onState
 */

/** Rivals at most. */
const MOST = 3;

export class Race {
  /** @param {Page} page @param {Figures} figures */
  constructor(page, figures) {
    this.page = page;
    this.figures = figures;
    /** @type {Rival[]} */
    this.rivals = [];
    /** The names in the table. */
    this.named = "";
    /** The planners that are offered. @type {PlannerInfo[]} */
    this.served = [];
    this.table = new Table(byId("standings", HTMLElement), page.panel.on.seeds);
    this.numbers = byId("numbers", HTMLElement);
    this.list = make("div", {});
    this.choice = make("select", { id: "rival" });
    this.button = button("add-rival", "Add", () => this.add());
    this.hint = make("p", { className: "hint" });
    const row = make(
      "div",
      { className: "row" },
      make("label", { htmlFor: "rival" }, "Against"),
      this.choice,
      this.button,
    );
    byId("race", HTMLElement).append(this.list, row, this.hint);
    this.lens = this.makeLens();
    figures.element.before(this.lens);
    page.race = this;
    this.agree();
    page.onState(({ lanes }) => this.show(lanes));
  }

  /** A choice of the kind of figure for all planners. */
  makeLens() {
    const choice = (/** @type {PaneKind} */ kind, /** @type {string} */ words) => {
      return make(
        "label",
        {},
        make("input", { type: "radio", name: "lens", value: kind, onchange: () => this.page.setView({ lens: kind }) }),
        words,
      );
    };
    return make(
      "fieldset",
      { className: "lens", hidden: true },
      make("legend", { className: "visually-hidden" }, "Picture"),
      choice("workspace", "Workspace"),
      choice("cspace", "Configuration space"),
    );
  }

  /** Shows the rivals of the page's state, and the planners for its robot. */
  agree() {
    const { rivals } = this;
    const { planners, robot, record } = this.page;
    const [, ...lanes] = record.lanes;
    const served = planners.for(robot);
    if (served !== this.served) this.offer(served);
    if (lanes.length !== rivals.length || this.hint.textContent === "") {
      while (rivals.length < lanes.length) this.enter(rivals.length + 1);
      rivals.length = lanes.length;
      this.list.replaceChildren(...rivals.map(({ element }) => element));
      this.button.disabled = this.choice.disabled = lanes.length === MOST;
      this.hint.textContent =
        lanes.length === 0
          ? "A second planner on the same scene, with the settings above; then change one."
          : `The planner above is A. All get the same number of clearance evaluations.${lanes.length === MOST ? " Four race at most." : ""}`;
    }
    rivals.forEach(({ form }, i) => form.show(lanes[i], served, robot));
  }

  /** Offers planners for a rival. @param {PlannerInfo[]} served */
  offer(served) {
    const { choice } = this;
    const { value } = choice;
    this.served = served;
    choice.replaceChildren(...served.map(({ id, title }) => make("option", { value: id }, title)));
    // By default a planner with two trees.
    const isServed = served.some(({ id }) => id === value);
    choice.value = served.find(({ id, grows }) => (isServed ? id === value : grows === "trees"))?.id ?? served[0].id;
  }

  /** @param {number} lane */
  enter(lane) {
    const { page } = this;
    this.rivals.push(
      new Rival(lane, {
        change: (plan) => page.change({ lanes: page.record.lanes.with(lane, plan) }),
        remove: () => {
          page.change({ lanes: page.record.lanes.toSpliced(lane, 1) });
          this.button.focus();
        },
      }),
    );
  }

  /** Adds a rival with the settings of planner A. */
  add() {
    const { page } = this;
    const { lanes } = page.record;
    const { seed: _, ...settings } = lanes[0].settings;
    byId("curves-fold", HTMLDetailsElement).open = true;
    page.change({ lanes: [...lanes, { algorithm: this.choice.value, settings }] });
    if (this.button.disabled) this.rivals[MOST - 1].planner.focus();
  }

  /** @param {number} lane @param {string} pointer @param {string} reason */
  refuse(lane, pointer, reason) {
    this.rivals[lane - 1]?.form.refuse(pointer, reason);
  }

  get hasSquare() {
    const { facts } = this.page;
    return facts !== null && facts.robot !== "disc" && facts.dimension > 1;
  }

  /** The kind of figure for each planner. @returns {PaneKind} */
  get picture() {
    const { facts, record } = this.page;
    return this.hasSquare ? (record.view.lens ?? (facts?.dimension === 2 ? "cspace" : "workspace")) : "workspace";
  }

  /** Shows a figure for each planner. @returns {boolean} whether there is a race */
  arrange() {
    const { page, lens } = this;
    const { plans, names } = page;
    const isRace = plans.length > 1;
    lens.hidden = !isRace || !this.hasSquare;
    this.numbers.hidden = isRace;
    this.figures.element.classList.toggle("race", isRace);
    if (names.join("\n") !== this.named) this.table.build(isRace ? names : []);
    this.named = names.join("\n");
    if (!isRace) return false;
    const kind = this.picture;
    for (const input of lens.querySelectorAll("input")) input.checked = input.value === kind;
    this.figures.show(names.map((caption, lane) => ({ id: `lane-${letter(lane)}`, kind, lane, caption })));
    return true;
  }

  /** @param {Racer[]} lanes */
  show(lanes) {
    const { plans } = this.page;
    if (plans.length > 1 && lanes.length === plans.length)
      this.table.show(lanes, (lane, text) => this.figures.setStanding(lane, text));
  }
}
