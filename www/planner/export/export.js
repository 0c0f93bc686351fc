/**
 * The exports of what is on the stage: pictures, drawn at the requested size, and the numbers behind them. Each says what it
 * is, or why it is not available.
 */
import { json, save } from "../../app/files.js";
import { byId, make, write } from "../../app/dom.js";
import { Exporter } from "./exporter.js";
import { writeNpy } from "../../formats/npy.js";
import { showSnippets } from "./embed.js";
import { countersCsv, nameOf } from "./files.js";
import { layoutOfStage } from "./layout.js";

/** @import { Page } from "../page.js" */
/** @import { State, TakeRequest } from "../../domain/types.js" */
/** @typedef {{ button: HTMLButtonElement, hint: HTMLElement, meaning: string, lack: (state: State) => string }} Offer   `lack`: why it is not to be had, or empty */

/** @param {State} state */
const noRun = ({ lanes }) => (lanes.some(({ status }) => status === "none") ? "No planner has run." : "");

/** @param {Page} page */
export function showTake(page) {
  const host = byId("take", HTMLElement);
  const exporter = new Exporter(page.session);
  /** @type {Offer[]} */
  const offers = [];
  /** Counts what was begun: what was cancelled stops. */
  let turn = 0;

  const scale = select("take-scale", "Size", [["1", "1\u00d7"], ["2", "2\u00d7"], ["4", "4\u00d7"]], "2");
  const frames = select("take-frames", "Frames", [["24", "24 frames"], ["48", "48 frames"], ["96", "96 frames"]], "48");
  const width = select("take-width", "Width", [["480", "480 px"], ["800", "800 px"]], "800");
  const lane = select("take-lane", "Planner", [], "");
  const which = make("label", { className: "row", hidden: true }, make("span", { className: "name" }, "Planner"), lane);
  const bar = make("progress", { max: 1, value: 0, ariaLabel: "Progress" });
  const cancel = make("button", { type: "button", id: "take-cancel" }, "Cancel");
  const progress = make("div", { className: "row", id: "take-progress", hidden: true }, bar, cancel);
  const told = make("p", { className: "hint", id: "take-told", role: "status" });
  cancel.addEventListener("click", () => { turn++; });

  host.append(
    offer("png", "Image", "PNG", "The stage as shown.", () => draw("png"), () => "", scale),
    offer("svg", "Vector graphic", "SVG", "The stage as shown, sharp at any size.", () => draw("svg"), () => ""),
    offer("gif", "Animation", "GIF", "The run up to here, in equal steps.", () => draw("gif"),
      (state) => noRun(state) || (state.clock.now === 0 ? "Nothing has happened yet." : ""), frames, width),
    progress, told,
    offer("scenario", "Scenario", "JSON", "For this page, the package and the command line.", async () => {
      const { facts } = page;
      if (facts) save(json(facts.document), `${facts.name.replace(/[^\w.-]+/g, "-")}.json`);
    }, () => ""),
    which,
    offer("result", "Result", "JSON", "Path, length, counts and fingerprint.", async () => {
      const { result } = await log();
      save(json(result), `${label(page.state?.lanes[Number(lane.value)].made)}-result.json`);
    }, noRun),
    offer("path", "Path", "NPY", "For NumPy: one row per waypoint.", async () => {
      const { path, dimension } = await log();
      if (path) save(npy(path, dimension), `${label()}-path.npy`);
    }, (state) => (state.lanes[Number(lane.value)]?.status === "solved" ? "" : "No path found yet.")),
    offer("vertices", "Vertices", "NPY", "For NumPy: one row per vertex shown.", async () => {
      const { vertices, dimension } = await log();
      save(npy(vertices, dimension), `${label()}-vertices.npy`);
    }, noRun),
    offer("counters", "Counters", "CSV", "For a spreadsheet: one row per iteration.", async () => {
      const logs = await Promise.all(page.asked.map((_, i) => exporter.log(i)));
      save(countersCsv(logs, page.asked), `${name(page.state?.lanes[0].made)}.csv`);
    }, noRun),
  );
  showSnippets(page, host);
  page.onOpen(() => { turn++; });
  page.onState(reflect);
  if (page.state) reflect(page.state);

  /**
   * A thing to take away.
   * @param {string} id @param {string} title @param {string} format @param {string} meaning
   * @param {() => Promise<void>} give @param {Offer["lack"]} lack @param {...HTMLElement} choices
   */
  function offer(id, title, format, meaning, give, lack, ...choices) {
    const button = make("button", { type: "button", id: `take-${id}` }, format);
    const hint = make("span", { className: "hint", id: `take-${id}-hint` }, meaning);
    button.setAttribute("aria-label", `${title}, ${format}`);
    button.setAttribute("aria-describedby", hint.id);
    button.addEventListener("click", async () => {
      try {
        await give();
      } catch (error) {
        page.notice.show(`The ${title.toLowerCase()} could not be created.`, error);
      }
    });
    offers.push({ button, hint, meaning, lack });
    const [beside, below] = choices.length === 1 ? [choices, []] : [[], choices];
    const row = make("div", { className: "row" }, make("span", { className: "name" }, title, hint), ...beside, button);
    return make("div", { className: "offer" }, row, below.length > 0 ? make("div", { className: "parts" }, ...below) : "");
  }

  /** @param {State} state */
  function reflect(state) {
    const names = page.names;
    which.hidden = names.length === 1;
    if (lane.dataset.names !== names.join("|")) {
      lane.dataset.names = names.join("|");
      lane.replaceChildren(...names.map((text, i) => make("option", { value: String(i) }, text)));
    }
    for (const { button, hint, meaning, lack } of offers) {
      const reason = lack(state);
      button.disabled = reason !== "" || (!progress.hidden && /take-(png|svg|gif)/.test(button.id));
      write(hint, reason || meaning);
    }
  }

  /** The run whose numbers are asked for. */
  function log() { return exporter.log(Number(lane.value)); }

  /** What a file is about, at the time that is shown. @param {number} [time] */
  function name(time = page.state?.clock.now ?? 0) { return nameOf(page.facts?.name ?? "", page.asked, time); }

  /** The same of the planner that is chosen. @param {number} [time] */
  function label(time = page.state?.lanes[Number(lane.value)].iteration ?? 0) { return nameOf(page.facts?.name ?? "", [page.asked[Number(lane.value)]], time); }

  /** Draws, slice by slice, and hands over what comes of it. @param {TakeRequest["kind"]} kind */
  async function draw(kind) {
    const mine = ++turn;
    const file = `${name()}.${kind}`;
    const began = performance.now();
    bar.value = 0;
    write(told, "");
    try {
      exporter.begin({
        kind, layout: layoutOfStage(), title: page.state?.summary[0] ?? "", ratio: Number(scale.value), width: Number(width.value), frames: Number(frames.value),
      });
      progress.hidden = false;
      for (let part = 0; part < 1;) {
        part = await exporter.step();
        bar.value = part;
        if (mine !== turn) {
          exporter.drop();
          write(told, "Cancelled.");
          return;
        }
      }
      const blob = await exporter.end();
      save(blob, file);
      write(told, `${file}, ${size(blob.size)}, in ${((performance.now() - began) / 1000).toFixed(1)} s.`);
    } finally {
      progress.hidden = true;
      if (page.state) reflect(page.state);
    }
  }
}

/** @param {Float64Array} rows @param {number} dimension */
function npy(rows, dimension) { return new Blob([writeNpy(rows, [rows.length / dimension, dimension])]); }

/** @param {number} bytes */
function size(bytes) { return bytes < 1e6 ? `${Math.ceil(bytes / 1000)} kB` : `${(bytes / 1e6).toFixed(1)} MB`; }

/** @param {string} id @param {string} label @param {[string, string][]} options @param {string} value */
function select(id, label, options, value) {
  const element = make("select", { id, ariaLabel: label }, ...options.map(([key, text]) => make("option", { value: key }, text)));
  element.value = value;
  return element;
}
