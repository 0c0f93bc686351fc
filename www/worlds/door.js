/**
 * The door for worlds of other programs: it gathers their files, in any order and in several drops, reads them in a
 * worker, again after each change of what was chosen, and gives the world to the page.
 */
import { make } from "../app/dom.js";
import { readFiles } from "../app/read-files.js";
import { coalesced } from "../app/work.js";
import { connect } from "../app/worker-client.js";
import { FIRST } from "./choices.js";
import { Panel } from "./panel.js";

/** @import { App } from "../app/app.js" */
/** @import { Content } from "../app/read-files.js" */
/** @import { ScenarioDocument } from "../domain/types.js" */
/** @import { Choices } from "./choices.js" */
/** @import { Grid, Places, ReadWorld, Report } from "./types.js" */
/** @import { WorldWorker } from "./worker.js" */
/**
 * A world that is used.
 * @typedef {object} OpenedWorld
 * @property {ScenarioDocument} document
 * @property {string | undefined} query   its name
 * @property {Grid | undefined} grid
 * @property {Report} report
 * @property {Content[]} files
 * @property {Choices} choices
 * @property {(count: number) => Promise<number[][]>} spread   connected places that are far apart, while it is opened
 */

/** The query that is added to a world without one, or whose start or goal was moved. */
const OWN = "start to goal";

const ROBOT = /** @type {const} */ (["robot", "radius", "length", "width", "wheelbase", "steering"]);

/** The query with the longest path, by the file, or the first. @param {ReadWorld} world */
function longestOf({ scenario, report }) {
  const all = report.queries.filter(({ length }) => length !== undefined);
  const [longest] = all.toSorted((a, b) => Number(b.length) - Number(a.length));
  return (longest ?? scenario.queries[0]).name;
}

export class Door {
  /**
   * @param {App} app
   * @param {(world: OpenedWorld) => Promise<unknown>} onUse   throws what the page refuses
   */
  constructor(app, onUse) {
    this.app = app;
    this.onUse = onUse;
    /** @type {Content[]} */
    this.files = [];
    /** The files that the worker has. @type {Content[] | null} */
    this.held = null;
    /** Those of the last drop, if files were there before. @type {Content[] | null} */
    this.fresh = null;
    this.choices = FIRST;
    /** Whether the reader has chosen a robot; until then one is suggested. */
    this.isRobotChosen = false;
    /** @type {ReadWorld | null} */
    this.world = null;
    /** @type {Places | null} */
    this.places = null;
    /** The query of the file that is shown; empty: places of the page. */
    this.query = "";
    /** Whether a start or a goal was moved. */
    this.isPlaced = false;
    /** @type {{ worker: Worker, remote: WorldWorker } | null} */
    this.reader = null;
    this.again = coalesced(() => this.read());
    this.check = coalesced(() => this.judge());
    this.panel = new Panel(app, {
      choose: (patch) => {
        this.choices = { ...this.choices, ...patch };
        if (ROBOT.some((name) => name in patch)) this.isRobotChosen = true;
        // Places are elsewhere in other units.
        if ("scale" in patch) this.isPlaced = false;
        this.request();
      },
      place: (places) => {
        this.isPlaced = true;
        this.query = "";
        this.settle(places);
      },
      ask: (query) => this.ask(query),
      remove: (name) => this.begin(this.files.filter((file) => file.name !== name)),
      add: () => this.pick(),
      use: () => void app.track(this.use()),
      close: () => this.close(),
    });
  }

  /** Opens files, or adds them to those in the panel. @param {Content[]} contents */
  async take(contents) {
    const before = this.panel.dialog.open ? this.files : [];
    const names = new Set(contents.map(({ name }) => name));
    this.fresh = before.length > 0 ? contents : null;
    await this.begin([...before.filter(({ name }) => !names.has(name)), ...contents]);
  }

  /** Opens a world again, as it was chosen. @param {OpenedWorld} opened */
  async reopen({ files, choices, document, query }) {
    const [first] = document.queries;
    this.query = query ?? "";
    this.fresh = null;
    await this.begin(files, choices);
    if (query === undefined && first?.name === OWN && first.start && first.goal) {
      this.isPlaced = true;
      this.settle({ start: [...first.start], goal: [...first.goal] });
    }
  }

  /** @param {Content[]} files @param {Choices} [choices] */
  begin(files, choices) {
    this.files = files;
    this.choices = choices ?? FIRST;
    this.isRobotChosen = choices !== undefined;
    this.isPlaced = false;
    this.panel.open();
    return this.request();
  }

  request() {
    this.app.notice.hide();
    this.panel.reading(this.files.map(({ name }) => name));
    return this.app.track(this.again());
  }

  /** The worker, which is started with the first world. */
  get remote() {
    if (!this.reader) {
      const worker = new Worker("world-worker.js", { type: "module" });
      const core = /** @type {any} */ (undefined);
      const remote = connect(worker, "worlds", core, () => this.dismiss());
      this.reader = { worker, remote: /** @type {WorldWorker} */ (remote) };
    }
    return this.reader.remote;
  }

  /** Ends the worker, and gives back its memory. */
  dismiss() {
    this.reader?.worker.terminate();
    this.reader = this.held = null;
  }

  /** Reads the files as they were chosen. */
  async read() {
    const { files, choices, isRobotChosen, fresh } = this;
    this.fresh = null;
    const asked = isRobotChosen ? choices : { ...choices, robot: FIRST.robot };
    let answer = await this.readOf(files, asked, !isRobotChosen);
    if ("fault" in answer && fresh && answer.fault.code !== "missing-file") {
      // Files that do not go with those before are a world of their own.
      const other = await this.readOf(fresh, FIRST, true);
      if (!("fault" in other) || other.fault.code === "missing-file") {
        answer = other;
        this.files = fresh;
        this.choices = FIRST;
        this.panel.reading(fresh.map(({ name }) => name));
      }
    } else if (files !== this.files || choices !== this.choices) return; // It is read again.
    if (!this.panel.dialog.open) return;
    if ("fault" in answer) this.panel.fail(answer.fault);
    else this.show(answer);
  }

  /** @param {Content[]} files @param {Choices} choices @param {boolean} suggests   a robot */
  async readOf(files, choices, suggests) {
    if (this.held !== files) await this.remote.hold(files);
    this.held = files;
    return this.remote.read(choices, suggests);
  }

  /** @param {import("./types.js").Reading} reading */
  show({ world, places, suggested }) {
    this.world = world;
    if (!this.isRobotChosen && suggested) this.choices = { ...this.choices, ...suggested };
    this.panel.show(world, this.choices);
    const { queries } = world.scenario;
    if (this.isPlaced) this.settle(this.fittedPlaces());
    else if (queries.length > 0)
      this.ask(queries.some(({ name }) => name === this.query) ? this.query : longestOf(world));
    else if (places) {
      this.query = "";
      this.settle(places);
    } else {
      this.places = null;
      this.panel.place(null, []);
      this.panel.refuse(
        "This robot fits nowhere: no two free places could be connected. Choose a smaller one.",
        "no-place",
      );
    }
  }

  /** The places that were moved, with headings only where the robot turns. */
  fittedPlaces() {
    const turns = this.world?.scenario.robot.type !== "disc";
    const fit = (/** @type {number[]} */ [x, y, theta = 0]) => (turns ? [x, y, theta] : [x, y]);
    const { start, goal } = /** @type {Places} */ (this.places);
    return { start: fit(start), goal: fit(goal) };
  }

  /** Shows a query of the file. @param {string} name */
  ask(name) {
    const query = this.world?.scenario.queries.find((one) => one.name === name);
    if (!query?.start || !query.goal) return;
    this.query = name;
    this.panel.query.value = name;
    this.settle({ start: [...query.start], goal: [...query.goal] });
  }

  /** Shows start and goal, and asks whether they are free. @param {Places} places */
  settle(places) {
    this.places = places;
    this.panel.place(places, this.panel.preview.bad);
    void this.app.track(this.check());
  }

  async judge() {
    const { places } = this;
    if (!places || !this.reader) return;
    const free = await this.remote.check([places.start, places.goal]);
    if (places === this.places)
      this.panel.place(
        places,
        /** @type {const} */ (["start", "goal"]).filter((_, i) => !free[i]),
      );
  }

  /** Lets the reader pick more files. */
  pick() {
    const input = make("input", { type: "file", multiple: true });
    input.addEventListener("change", () => {
      const contents = readFiles([...(input.files ?? [])]);
      void this.app.track(
        contents.then((files) => this.take(files)),
        "The files could not be read.",
      );
    });
    input.click();
  }

  /** Gives the world to the page; what it refuses leaves the panel open. */
  async use() {
    const { world, choices, files, query } = this;
    if (!world) return;
    await this.onUse({
      document: this.documentOf(world.scenario),
      query: query || undefined,
      grid: world.grid,
      report: world.report,
      files,
      choices,
      spread: (count) => this.remote.spread(count),
    });
    this.close();
  }

  /** The scenario with the query of the page, where none of the file is used. @param {ScenarioDocument} document */
  documentOf(document) {
    const { places, query } = this;
    if (query || !places) return document;
    const { robot, queries } = document;
    const own = {
      name: OWN,
      ...places,
      // A car driven by controls ends in a region.
      ...(robot.type === "car" ? { goal_tolerance: { translation: robot.wheelbase / 10, rotation: 0.1 } } : {}),
    };
    return { ...document, queries: [own, ...queries.filter(({ name }) => name !== OWN)] };
  }

  close() {
    this.panel.close();
    this.dismiss();
    this.world = this.places = null;
    this.query = "";
  }
}
