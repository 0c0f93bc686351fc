/** What the panel asks about a world: only what its files leave open, and of the robot only what its kind has. */
import { grouped, make } from "../app/dom.js";
import { button, row, select, toggle } from "../widgets/elements.js";
import { reasonAgainst, showReason } from "../widgets/field.js";
import { filtersOf } from "./choices.js";

/** @import { Choices } from "./choices.js" */
/** @import { Layer, ReadWorld, Report } from "./types.js" */
/**
 * @typedef {object} NumberField
 * @property {"radius" | "length" | "width" | "wheelbase" | "steering" | "margin" | "scale" | "threshold" |
 *   "wall_thickness" | "min_island" | "simplify" | "tolerance"} name
 * @property {string} title
 * @property {string} unit
 * @property {number} min
 * @property {number} max
 * @property {number} [usual]   where it is not chosen
 * @property {boolean} [isMore]   under "More"
 * @property {(world: ReadWorld, choices: Choices) => boolean} isAsked
 */

const ROBOTS = /** @type {const} */ ([
  ["file", "as in the file"],
  ["disc", "disc"],
  ["footprint", "footprint that turns"],
  ["car", "car"],
]);

/** @param {...Choices["robot"]} kinds @returns {NumberField["isAsked"]} */
const ofRobot =
  (...kinds) =>
  (_, { robot }) =>
    kinds.includes(robot);
/** @type {NumberField["isAsked"]} */
const ofGrid = ({ grid }) => grid !== undefined;
/** @param {...Report["format"]} formats @returns {NumberField["isAsked"]} */
const isOf =
  (...formats) =>
  ({ report }) =>
    formats.includes(report.format);
const ofPicture = isOf("picture");
const LONG = 1e4;

/** @type {NumberField[]} */
const NUMBERS = [
  { name: "radius", title: "Radius", unit: "m", min: 0, max: LONG, isAsked: ofRobot("disc") },
  { name: "length", title: "Length", unit: "m", min: 0.001, max: LONG, isAsked: ofRobot("footprint", "car") },
  { name: "width", title: "Width", unit: "m", min: 0.001, max: LONG, isAsked: ofRobot("footprint", "car") },
  { name: "wheelbase", title: "Wheelbase", unit: "m", min: 0.001, max: LONG, isAsked: ofRobot("car") },
  { name: "steering", title: "Steering, to either side", unit: "\u00b0", min: 1, max: 89, isAsked: ofRobot("car") },
  {
    name: "scale",
    title: "Scale",
    unit: "m per cell or unit",
    min: 1e-6,
    max: LONG,
    usual: 1,
    isAsked: isOf("picture", "grid", "moving-ai", "svg", "dxf"),
  },
  { name: "threshold", title: "Free from brightness", unit: "", min: 0, max: 1, usual: 0.5, isAsked: ofPicture },
  {
    name: "wall_thickness",
    title: "Thickness of lines",
    unit: "m",
    min: 0,
    max: LONG,
    isAsked: ({ report }) => Boolean(report.obstacles.walls),
  },
  {
    name: "margin",
    title: "Margin around the robot",
    unit: "m",
    min: 0,
    max: LONG,
    isMore: true,
    isAsked: () => true,
  },
  {
    name: "min_island",
    title: "Drop islands below",
    unit: "cells",
    min: 0,
    max: 1e9,
    isMore: true,
    isAsked: ofGrid,
  },
  { name: "simplify", title: "Let obstacles grow by", unit: "m", min: 0, max: LONG, isMore: true, isAsked: ofGrid },
  {
    name: "tolerance",
    title: "Let curves grow by",
    unit: "m",
    min: 1e-6,
    max: LONG,
    usual: 0.001,
    isMore: true,
    isAsked: isOf("svg", "dxf"),
  },
];

/**
 * @param {string} id @param {string} label @param {[string, string][]} options
 * @param {(value: string) => void} then   with what is chosen
 */
function choice(id, label, options, then) {
  const element = select(id, label, options);
  element.addEventListener("change", () => then(element.value));
  return element;
}

/**
 * What is typed, and below it why it is wrong.
 * @param {import("../app/dom.js").Properties<"input"> & { id: string }} properties
 * @param {HTMLElement} name
 * @param {(value: string) => string} wrongOf   empty where it is right
 * @param {(value: string) => void} then   with what is right
 */
function typed(properties, name, wrongOf, then) {
  const input = make("input", properties);
  const reason = make("p", { className: "reason", id: `${input.id}-reason`, hidden: true });
  input.setAttribute("aria-describedby", reason.id);
  input.addEventListener("input", () => {
    const wrong = wrongOf(input.value);
    showReason(reason, input, wrong);
    if (!wrong) then(input.value);
  });
  const label = make("label", { className: "row", htmlFor: input.id }, name, input);
  return { input, label, element: make("div", { className: "field" }, label, reason) };
}

export class Fields {
  /**
   * @param {(patch: Partial<Choices>) => void} choose
   * @param {() => void} measure   the scale on the picture
   */
  constructor(choose, measure) {
    this.choose = choose;
    this.robot = choice(
      "world-robot",
      "Robot",
      ROBOTS.map(([value, text]) => [value, text]),
      (robot) => choose({ robot: /** @type {Choices["robot"]} */ (robot) }),
    );
    this.unknown = choice(
      "world-unknown",
      "Unknown cells",
      [
        ["occupied", "obstacles"],
        ["free", "free"],
      ],
      (unknown) => choose({ unknown: /** @type {Choices["unknown"]} */ (unknown) }),
    );
    this.unknownRow = row("Unknown cells", this.unknown);
    this.walkable = choice(
      "world-walkable",
      "Areas of the file",
      [
        ["", "as the file suggests"],
        ["false", "obstacles"],
        ["true", "free space"],
      ],
      (walkable) => choose({ walkable: walkable === "" ? undefined : walkable === "true" }),
    );
    this.walkableRow = row("Areas", this.walkable);
    this.level = choice("world-level", "Level of the building", [], (level) => choose({ level }));
    this.levelRow = row("Level", this.level);
    this.filled = toggle("world-filled", (filled) => choose({ filled }));
    this.filledRow = row("Closed lines are filled", this.filled);
    this.filters = typed(
      { type: "text", id: "world-filters", placeholder: "kind=wall, level!=2" },
      make("span", { className: "name" }, "Only features with"),
      (filters) => (filtersOf(filters) ? "" : "Write KEY=VALUE or KEY!=VALUE, separated by commas"),
      (filters) => choose({ filters }),
    );
    this.measure = button("world-measure", "Measure\u2026", measure, { ariaPressed: "false" });
    this.layers = make("fieldset", { id: "world-layers", hidden: true });
    this.numbers = NUMBERS.map((info) => this.number(info));
    const own = this.numbers.filter(({ info }) => !info.isMore).map(({ element }) => element);
    const more = this.numbers.filter(({ info }) => info.isMore).map(({ element }) => element);
    this.more = make(
      "details",
      { id: "world-more" },
      make("summary", {}, "More"),
      ...more,
      this.filledRow,
      this.filters.element,
    );
    this.element = make(
      "div",
      { className: "world-fields" },
      row("Robot", this.robot),
      ...own,
      this.unknownRow,
      this.walkableRow,
      this.levelRow,
      this.layers,
      this.more,
    );
  }

  /** @param {NumberField} info */
  number(info) {
    const { name, title, unit, min, max } = info;
    const { input, label, element } = typed(
      { type: "number", id: `world-${name}`, step: "any", min: String(min), max: String(max) },
      make("span", { className: "name" }, title, make("span", { className: "unit" }, ` ${unit}`)),
      (value) =>
        reasonAgainst(
          { kind: name === "min_island" ? "integer" : "number", min, max, choices: null },
          value.trim() === "" ? NaN : Number(value),
        ),
      (value) => this.choose({ [name]: Number(value) }),
    );
    if (name === "scale") label.append(this.measure);
    return { info, input, element };
  }

  /** @param {ReadWorld} world @param {Choices} choices */
  show(world, choices) {
    const { robot, unknown, unknownRow, numbers, measure } = this;
    robot.value = choices.robot;
    unknown.value = choices.unknown;
    const count = world.grid ? (world.report.grid?.unknown ?? 0) : 0;
    unknownRow.hidden = count === 0;
    /** @type {HTMLElement} */ (unknownRow.firstElementChild).textContent = `${grouped(count)} unknown cells`;
    this.walkable.value = String(choices.walkable ?? "");
    this.walkableRow.hidden = !isOf("geojson", "wkt")(world, choices);
    this.filledRow.hidden = !isOf("dxf")(world, choices);
    this.filled.checked = choices.filled;
    this.filters.element.hidden = !isOf("geojson")(world, choices);
    if (this.filters.input !== document.activeElement) this.filters.input.value = choices.filters;
    this.showLevels(world.report.levels ?? [], choices);
    measure.hidden = !ofPicture(world, choices);
    for (const { info, input, element } of numbers) {
      element.hidden = !info.isAsked(world, choices);
      const value = choices[info.name] ?? info.usual;
      // What is being typed stays as it is.
      if (input !== document.activeElement) input.value = String(value);
    }
    this.showLayers(world.report.layers ?? [], choices);
  }

  /** @param {string[]} levels @param {Choices} choices */
  showLevels(levels, { level }) {
    this.levelRow.hidden = levels.length < 2;
    const options = levels.map((name) => make("option", { value: name, selected: name === level }, name));
    this.level.replaceChildren(...options);
  }

  /**
   * A tick for each layer, where there are several.
   * @param {Layer[]} layers
   * @param {Choices} choices
   */
  showLayers(layers, { layers: kept }) {
    const key = layers.map(({ name }) => name).join("\n");
    this.layers.hidden = layers.length < 2;
    if (this.layers.dataset.key === key) return;
    this.layers.dataset.key = key;
    const ticks = layers.map(({ name, shapes, omitted }) => {
      const input = make("input", { type: "checkbox", checked: kept?.includes(name) ?? !omitted, value: name });
      input.addEventListener("change", () =>
        this.choose({ layers: ticks.flatMap((tick) => (tick.input.checked ? tick.input.value : [])) }),
      );
      return {
        input,
        element: make("label", {}, input, ` ${name} `, make("span", { className: "unit" }, grouped(shapes))),
      };
    });
    this.layers.replaceChildren(make("legend", {}, "Layers"), ...ticks.map(({ element }) => element));
  }
}
