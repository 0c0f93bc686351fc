/**
 * A race: the panel's planner and up to three rivals on one scenario, with the same number of clearance evaluations.
 * Each planner has a figure on the stage and a row in the table.
 */
import { letter } from "./standings.js";
import { byId, make } from "../../app/dom.js";
import { button } from "../../widgets/elements.js";
import { Rival } from "./rival.js";
import { Table } from "./table.js";

/** @import { Page } from "../page.js" */
/** @import { Sheets } from "../sheets.js" */
/** @import { PaneKind, Plan, State } from "../../domain/types.js" */

/** Rivals at most. */
const MOST = 3;

export class Race {
  /** @param {Page} page @param {Sheets} sheets */
  constructor(page, sheets) {
    this.page = page;
    this.sheets = sheets;
    /** @type {Rival[]} */
    this.rivals = [];
    /** The plans that the figures and the table were last made for. @type {Plan[]} */
    this.shown = [];
    /** The kind of figure, where one was chosen. @type {PaneKind | null} */
    this.kind = null;
    this.table = new Table(byId("standings", HTMLElement));
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
    this.offer();
    this.lens = this.makeLens();
    sheets.element.before(this.lens);
    page.race = this;
    page.onState((state) => this.show(state));
  }

  /** A choice of the kind of figure for all planners. */
  makeLens() {
    const choice = (/** @type {PaneKind} */ kind, /** @type {string} */ words) => {
      return make(
        "label",
        {},
        make("input", { type: "radio", name: "lens", value: kind, onchange: () => this.setPicture(kind) }),
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

  /**
   * Offers the planners for the robot, and removes other rivals.
   * @returns {{ lane: number, algorithm: string }[]} those removed
   */
  offer() {
    const {
      choice,
      page: {
        panel,
        panel: { served },
      },
    } = this;
    const before = choice.value;
    choice.replaceChildren(...served.map(({ id, title }) => make("option", { value: id }, title)));
    // By default a planner with two trees.
    choice.value =
      served.find(({ id, grows }) => (panel.serves(before) ? id === before : grows === "trees"))?.id ?? served[0].id;
    const dropped = this.rivals.filter(({ planner }) => !panel.serves(planner.value));
    this.rivals = this.rivals.filter((rival) => !dropped.includes(rival));
    for (const { form } of this.rivals) {
      form.offer(served);
      form.build();
    }
    this.number();
    return dropped.map(({ lane, planner }) => ({ lane, algorithm: planner.value }));
  }

  /** The rivals' plans, or null while a field holds an invalid value. @param {Plan} plan @returns {Plan[] | null} */
  beside(plan) {
    const plans = this.rivals.map((rival) => rival.plan(plan));
    return plans.includes(null) ? null : plans.flatMap((one) => one ?? []);
  }

  /** Adds a rival with the settings of planner A. */
  add() {
    const { seed: _, ...settings } = this.page.panel.form.given;
    this.enter({ algorithm: this.choice.value, settings });
    this.number();
    byId("curves-fold", HTMLDetailsElement).open = true;
    this.page.plan();
    if (this.button.disabled) this.rivals[MOST - 1].planner.focus();
  }

  /** @param {Plan} plan */
  enter(plan) {
    const rival = new Rival(this.page.panel, plan, { change: () => this.page.plan(), remove: () => this.drop(rival) });
    this.rivals.push(rival);
  }

  /** @param {Rival} rival */
  drop(rival) {
    this.rivals.splice(this.rivals.indexOf(rival), 1);
    this.number();
    this.button.focus();
    this.page.plan();
  }

  /** Replaces the rivals by those of a link. @param {Plan[]} plans */
  adopt([first, ...others]) {
    this.rivals = [];
    for (const {
      algorithm,
      settings: { seed, ...settings },
    } of others) {
      this.enter({ algorithm, settings: seed === first.settings.seed ? settings : { seed, ...settings } });
    }
    this.number();
  }

  /** Shows the rivals with their letters. */
  number() {
    this.list.replaceChildren(...this.rivals.map(({ element }) => element));
    this.rivals.forEach((rival, i) => rival.place(i + 1));
    const { length } = this.rivals;
    this.button.disabled = this.choice.disabled = length === MOST;
    this.hint.textContent =
      length === 0
        ? "A second planner on the same scene, with the settings above; then change one."
        : `The planner above is A. All get the same number of clearance evaluations.${length === MOST ? " Four race at most." : ""}`;
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
    return this.hasSquare ? (this.kind ?? (this.page.facts?.dimension === 2 ? "cspace" : "workspace")) : "workspace";
  }

  /** @param {PaneKind} kind */
  setPicture(kind) {
    this.kind = kind;
    this.arrange();
  }

  /** Shows a figure for each planner. @returns {boolean} whether there is a race */
  arrange() {
    const { page, lens } = this;
    const { current, names } = page;
    const isRace = current.length > 1;
    this.shown = current;
    lens.hidden = !isRace || !this.hasSquare;
    this.numbers.hidden = isRace;
    this.sheets.element.classList.toggle("race", isRace);
    this.table.build(isRace ? names : []);
    if (!isRace) return false;
    const kind = this.picture;
    for (const input of lens.querySelectorAll("input")) input.checked = input.value === kind;
    this.sheets.show(names.map((caption, lane) => ({ id: `lane-${letter(lane)}`, kind, lane, caption })));
    return true;
  }

  /** @param {State} state */
  show(state) {
    const { page } = this;
    if (page.current !== this.shown && !this.arrange() && page.facts) this.sheets.arrange(page.facts);
    if (page.current.length > 1 && state.lanes.length === page.current.length) this.table.show(state, this.sheets);
  }
}
