/**
 * The robots in their order of priority, each with its time: when it moves, waits and has arrived. A click or a drag
 * along the times scrubs; a drag of a number, Alt with an arrow key, or the buttons move a robot in the order.
 */
import { byId, make, makeSvg, write } from "../app/dom.js";
import { comparer } from "../app/once.js";
import { num } from "../widgets/format.js";
import { laneSentence } from "./words.js";

/** @import { Floor } from "./floor.js" */
/** @import { FleetSession } from "./session.js" */
/** @import { Trajectory } from "./trajectory.js" */

/**
 * A robot's row.
 * @typedef {{ robot: number, element: HTMLLIElement, words: HTMLElement, bar: SVGSVGElement, when: HTMLElement, drawn:
 *   string }} Lane
 */

/** Height of a bar, in its own units. */
const HIGH = 12;
/** Pixels from the edge of the list within which a drag scrolls it. */
const EDGE = 24;

export class RobotList {
  /**
   * @param {FleetSession} session
   * @param {Floor} floor  has the colours
   * @param {{ scrub: (time: number) => void, reorder: (order: number[] | null) => void }} actions
   */
  constructor(session, floor, actions) {
    this.differs = comparer();
    this.session = session;
    this.floor = floor;
    this.actions = actions;
    this.list = byId("order", HTMLUListElement);
    this.scroller = byId("lanes", HTMLElement);
    /** By robot. @type {Lane[]} */
    this.lanes = [];
    /** The order that is shown. @type {number[]} */
    this.order = [];
    /** The robot that is dragged, and the order before. @type {{ robot: number, before: number[] } | null} */
    this.held = null;
    this.list.addEventListener("keydown", (event) => this.press(event));
    this.list.addEventListener("pointerdown", (event) => this.grab(event));
    for (const [id, to] of /** @type {const} */ ([
      ["first", -Infinity],
      ["up", -1],
      ["down", 1],
    ])) {
      byId(id, HTMLButtonElement).addEventListener("click", () => this.move(to));
    }
    byId("any-order", HTMLButtonElement).addEventListener("click", () => actions.reorder(null));
  }

  show() {
    const { session, list, differs } = this;
    const { document, run, selected, isStraight, isOrdered, end, time, order, algorithm } = session;
    if (differs("robots", document)) this.build();
    if (differs("plan", run, run.iterations, run.status, run.planned, isStraight, isOrdered)) this.showPlan();
    if (differs("selected", document, selected)) this.mark();
    list.style.setProperty("--now", String(end > 0 ? Math.min(1, time / end) : 0));
    for (const id of ["first", "up", "down"])
      byId(id, HTMLButtonElement).disabled = selected === null || !isOrdered || this.order.length < 2;
    byId("any-order", HTMLButtonElement).disabled = order === null || algorithm !== "prioritized";
  }

  /** Shows the order and the times of the plan. */
  showPlan() {
    const { session } = this;
    if (!this.held) this.arrange(session.isOrdered ? session.run.order : session.robots.map((_, i) => i));
    for (const lane of this.lanes) this.drawLane(lane);
    session.app.write({ "axis-end": session.end > 0 ? `${num(session.end, 1)} s` : "" });
    Object.assign(byId("robots", HTMLElement).dataset, { ordered: session.isOrdered, straight: session.isStraight });
  }

  build() {
    this.lanes = this.session.robots.map((_, robot) => {
      const words = make("span", { className: "visually-hidden" });
      const bar = makeSvg("svg", { class: "bar", preserveAspectRatio: "none", "aria-hidden": "true" });
      const when = make("span", { className: "when", ariaHidden: "true" });
      const grip = make(
        "span",
        { className: "grip", ariaHidden: "true" },
        make("span", { className: "chip" }, String(robot + 1)),
      );
      const element = make(
        "li",
        { id: `robot-${robot + 1}`, className: "lane", role: "option", dataset: { robot } },
        words,
        grip,
        bar,
        when,
      );
      return { robot, element, words, bar, when, drawn: "" };
    });
    this.order = [];
  }

  /** Gives the rows the colours of their robots. */
  colour() {
    for (const { robot, element } of this.lanes)
      element.style.setProperty("--robot-colour", this.floor.colours[robot] ?? "");
  }

  /** Puts the rows into an order. @param {number[]} order */
  arrange(order) {
    if (order.join() === this.order.join()) return;
    this.order = [...order];
    this.list.replaceChildren(...order.map((robot) => this.lanes[robot].element));
  }

  /** @param {Lane} lane */
  drawLane(lane) {
    const { session } = this;
    const { robot, element, words, bar, when } = lane;
    const { isStraight, shown, end } = session;
    const { blocked, status } = session.run;
    const isFailed = !isStraight && status === "exhausted";
    const state =
      isFailed && blocked[0] === robot
        ? "blocked"
        : isFailed && blocked.includes(robot)
          ? "in-the-way"
          : shown[robot]
            ? "planned"
            : "open";
    element.dataset.state = state;
    write(words, laneSentence(session, robot));
    write(
      when,
      state === "blocked"
        ? "no plan"
        : state === "in-the-way"
          ? "in the way"
          : shown[robot]
            ? `${num(shown[robot].arrival, 1)} s`
            : "",
    );
    const key = `${end} ${shown[robot]?.count} ${shown[robot]?.arrival} ${shown[robot]?.waits} ${isStraight}`;
    if (key === lane.drawn) return;
    lane.drawn = key;
    bar.replaceChildren(
      ...(shown[robot] && end > 0 ? shapesOf(shown[robot], end) : []),
      ...(isStraight ? this.conflictsOf(robot) : []),
    );
    bar.setAttribute("viewBox", `0 0 ${Math.max(end, 1e-9)} ${HIGH}`);
  }

  /** When a robot touches another one, if all drive straight. @param {number} robot */
  conflictsOf(robot) {
    const { conflicts, end } = this.session;
    return conflicts
      .filter(({ robots }) => robots.includes(robot))
      .map(({ from, to }) =>
        makeSvg("rect", {
          class: "conflict",
          x: from,
          y: 0,
          width: Math.max(Math.min(to ?? end, end) - from, 0.006 * end),
          height: HIGH,
        }),
      );
  }

  /** Marks the chosen robot. */
  mark() {
    const { lanes, list } = this;
    const { selected } = this.session;
    for (const { robot, element } of lanes) element.ariaSelected = String(robot === selected);
    if (selected === null) list.removeAttribute("aria-activedescendant");
    else {
      list.setAttribute("aria-activedescendant", lanes[selected].element.id);
      this.reveal(lanes[selected].element);
    }
  }

  /** Scrolls the list, and not the page, to a row. @param {HTMLElement} element */
  reveal({ offsetTop, offsetHeight }) {
    const { scroller } = this;
    if (offsetTop < scroller.scrollTop) scroller.scrollTop = offsetTop;
    else if (offsetTop + offsetHeight > scroller.scrollTop + scroller.clientHeight)
      scroller.scrollTop = offsetTop + offsetHeight - scroller.clientHeight;
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    if (event.ctrlKey || event.metaKey) return;
    const { session, order } = this;
    const at = session.selected === null ? -1 : order.indexOf(session.selected);
    /** @type {Record<string, number>} */
    const targets = {
      ArrowUp: Math.max(0, at - 1),
      ArrowDown: Math.min(order.length - 1, at + 1),
      Home: 0,
      End: order.length - 1,
    };
    const to = targets[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.altKey && at >= 0) this.move(to - at);
    else session.select(order[to]);
  }

  /** Moves the chosen robot in the order, and plans again. @param {number} by */
  move(by) {
    const { session, order } = this;
    if (session.selected === null || !session.isOrdered) return;
    const at = order.indexOf(session.selected);
    this.place(at, Math.min(order.length - 1, Math.max(0, at + by)));
    if (this.order !== order) this.actions.reorder(this.order);
  }

  /** Moves a row. @param {number} from @param {number} to */
  place(from, to) {
    if (from === to) return;
    const order = this.order.toSpliced(from, 1);
    this.arrange(order.toSpliced(to, 0, this.order[from]));
    this.reveal(this.lanes[this.order[to]].element);
  }

  /** Begins to drag a robot, or along the times. @param {PointerEvent} event */
  grab(event) {
    const { list, session } = this;
    const target = /** @type {Element} */ (event.target);
    const lane = target.closest(".lane");
    if (event.button !== 0 || !event.isPrimary || !(lane instanceof HTMLElement)) return;
    const robot = Number(lane.dataset.robot);
    session.select(robot);
    list.focus({ preventScroll: true });
    event.preventDefault();
    const isGrip = target.closest(".grip") !== null && session.isOrdered;
    if (!isGrip && target.closest(".grip")) return;
    const stop = new AbortController();
    const follow = isGrip ? this.hold(robot, lane) : this.scrubber(lane);
    follow(event);
    addEventListener("pointermove", follow, stop);
    for (const type of ["pointerup", "pointercancel"]) {
      addEventListener(
        type,
        () => {
          stop.abort();
          if (isGrip) this.drop(type === "pointerup");
        },
        stop,
      );
    }
    if (isGrip)
      addEventListener(
        "keydown",
        ({ key }) => {
          if (key !== "Escape") return;
          stop.abort();
          this.drop(false);
        },
        stop,
      );
  }

  /** @param {number} robot @param {HTMLElement} lane @returns {(event: PointerEvent) => void} */
  hold(robot, lane) {
    this.held = { robot, before: this.order };
    lane.classList.add("held");
    return ({ clientY }) => {
      const { list, scroller, order } = this;
      const view = scroller.getBoundingClientRect();
      if (clientY < view.top + EDGE) scroller.scrollTop -= EDGE / 2;
      if (clientY > view.bottom - EDGE) scroller.scrollTop += EDGE / 2;
      const { top, height } = list.getBoundingClientRect();
      const to = Math.floor(((clientY - top) / height) * order.length);
      this.place(order.indexOf(robot), Math.min(order.length - 1, Math.max(0, to)));
    };
  }

  /** Ends a drag. @param {boolean} isDone  or cancelled */
  drop(isDone) {
    const { held } = this;
    if (!held) return;
    this.held = null;
    this.lanes[held.robot].element.classList.remove("held");
    if (!isDone) this.arrange(held.before);
    else if (this.order.join() !== held.before.join()) this.actions.reorder(this.order);
  }

  /** @param {HTMLElement} lane @returns {(event: PointerEvent) => void} */
  scrubber(lane) {
    return ({ clientX }) => {
      const { left, width } = (lane.querySelector(".bar") ?? lane).getBoundingClientRect();
      this.actions.scrub(Math.min(1, Math.max(0, (clientX - left) / width)) * this.session.end);
    };
  }
}

/** Moving is a full bar, waiting a hollow one, having arrived a line. @param {Trajectory} way @param {number} end */
function shapesOf({ spans, arrival }, end) {
  const rect = (/** @type {number} */ from, /** @type {number} */ to, /** @type {number} */ y) =>
    `M${from} ${y}H${to}V${HIGH - y}H${from}z`;
  const path = (/** @type {boolean} */ isWait, /** @type {number} */ y) =>
    spans
      .filter((span) => span.isWait === isWait)
      .map(({ from, to }) => rect(from, to, y))
      .join("");
  return [
    makeSvg("path", { class: "moving", d: path(false, 1) }),
    makeSvg("path", { class: "waiting", d: path(true, 3.5) }),
    ...(arrival < end ? [makeSvg("path", { class: "arrived", d: `M${arrival} ${HIGH / 2}H${end}` })] : []),
  ];
}
