/**
 * The page of many trajectories: wiring.
 *
 * What tests may rely on, beside what room.js says: `#stage` carries `data-status` ("running", "solved", "exhausted", or "refused"
 * while the settings cannot be used), `data-accepted`, `data-tried`, `data-drawn` (trajectories on the canvas), `data-last`
 * ("accepted", "refused" or "none"), `data-begun` (another number for each experiment), and `data-fingerprint`. Each frame leaves a measure "trajectories-frame".
 */
import * as library from "planarium";
import { grouped, write } from "../controls/counters.js";
import { byId, make } from "../controls/dom.js";
import { loadCore } from "../resources.js";
import { Asker, WorkerError } from "../room/ask.js";
import { Link } from "../room/link.js";
import { Options } from "../room/options.js";
import { Room } from "../room/room.js";
import { Sheet } from "../room/sheet.js";
import { Transport } from "../room/transport.js";
import { Charts, WINDOW } from "./charts.js";
import { Growth } from "./growth.js";
import { ONE, One } from "./one.js";
import { Plane } from "./plane.js";
import { stateRule } from "./state.js";
import { showTake } from "./take.js";

/** @import { TrajectoryOptions } from "planarium" */
/** @import { ParameterInfo } from "../types.js" */
/** @import { Settings } from "../types.js" */
/** @import { State } from "./state.js" */
/** @import { Commands } from "./worker.js" */

/** The seed as a row of the table: the core's own has none. @type {ParameterInfo} */
const SEED = { name: "seed", title: "Seed", kind: "integer", unit: "", min: 0, max: Number.MAX_SAFE_INTEGER, default: 0, choices: null, meaning: "The same seed gives the same trajectories.", robots: [] };
/** What stands at the top; the rest is folded away. */
const FIRST = ["seed", "model", "count", "fastest", "greatest_turn_rate", "least_turn_rate"];

/** Tries asked for at once on the way to the end. */
const AT_ONCE = 5000;

const room = new Room();
/** When the frame at hand began. */
let begun = 0;

await room.open(async () => {
  const core = await loadCore();
  await library.default(core);
  const asker = /** @type {Asker<Commands>} */ (new Asker("trajectories/worker.js", (error) => room.fail(error)));
  void asker.start(core).catch((error) => room.fail(error));

  const growth = new Growth(asker);
  const plane = new Plane(growth);
  const stage = byId("stage", HTMLElement);
  const sheet = new Sheet(room, stage, { id: "plane", kind: "workspace", caption: "Trajectories", note: "" }, plane);
  const charts = new Charts(growth);
  const one = new One(room, library, byId("single", HTMLElement), () => {});
  const table = [SEED, ...library.trajectoryOptions()];
  const host = byId("settings", HTMLElement);
  let options = new Options(host, table, {}, () => void restart(), "option", (name) => FIRST.includes(name));

  room.onFrame((now) => {
    begun = performance.now();
    plane.now = now;
    return undefined;
  });
  const transport = new Transport(room, byId("course", HTMLElement), {
    name: "course", label: "Playing", unit: "tries", steps: [1, 10, 100], slowest: 1, fastest: 20_000, pace: 120,
    advance: (count) => growth.advance(transport.isFinishing ? Math.max(count, AT_ONCE) : count, news),
    reset: () => void restart(), canFinish: true,
  }, [stage]);
  const move = make("button", { type: "button", id: "course-move", className: "quiet" }, "Let them move");
  move.setAttribute("aria-pressed", "false");
  move.addEventListener("click", () => {
    plane.moment = plane.moment === null ? 0 : null;
    started = performance.now();
    move.setAttribute("aria-pressed", String(plane.moment !== null));
    sheet.refresh();
  });
  transport.bar.append(move);
  /** When the particles set out. */
  let started = 0;

  room.onFrame((now) => {
    if (plane.moment !== null) plane.moment = (Math.max(0, now - started) / 1000) % plane.round;
    plane.isStill = room.calm || !transport.isPlaying;
    const isMoving = plane.isMoving(now);
    if (isMoving || wasMoving) sheet.refresh();
    wasMoving = isMoving;
    return isMoving;
  });
  room.onPaint(() => {
    // Those that have come since are drawn on top of the others; Sheet draws all anew only where it must.
    const { palette, layers: { ground } } = sheet;
    if (palette && !sheet.stale.has("ground") && sheet.width > 0) plane.append({ context: ground.context, palette });
    const isAtRest = !transport.isPlaying && room.waiting === 0;
    charts.draw(performance.now(), isAtRest);
    tell();
    performance.measure("trajectories-frame", { start: begun });
  });
  let wasMoving = false;

  showTake(room, growth, sheet, WINDOW);
  byId("new-seed", HTMLButtonElement).disabled = false;
  byId("new-seed", HTMLButtonElement).addEventListener("click", () => {
    // Short enough to be said aloud.
    put({ ...options.given, seed: library.randomSeed() % 100_000 });
    void restart().then((isBegun) => { if (isBegun) transport.start(); });
  });
  const link = new Link(room, stateRule, stateOf, show, "these settings, the seed, and how far it has come");
  room.recover = () => void library.default().then(() => restart()).catch((error) => room.fail(error));
  room.onDress(() => { charts.epoch = -1; });
  await room.await(link.obey());

  /** What is new has come. */
  function news() {
    sheet.refresh();
    if (growth.isRunning) return;
    const { accepted, iterations } = growth.result ?? { accepted: 0, iterations: 0 };
    room.announcer.say(growth.result?.status === "solved" ? `All ${grouped(accepted)} accepted after ${grouped(iterations)} tries.` : `Given up after ${grouped(iterations)} tries, ${grouped(accepted)} accepted.`);
  }

  /** Puts settings into the panel. @param {Settings} given */
  function put(given) { options = new Options(host, table, given, () => void restart(), "option", (name) => FIRST.includes(name)); }

  /** Begins anew with what the panel says. @returns {Promise<boolean>} */
  async function restart() {
    transport.pause();
    const { settings } = options;
    if (!settings) return refuse();
    room.notice.hide();
    const isBegun = await room.await(growth.begin(/** @type {TrajectoryOptions} */ (settings)).catch((error) => {
      if (error instanceof WorkerError && error.code !== "internal" && options.refuse(error.pointer, error.message)) return refuse();
      throw error;
    }));
    if (!isBegun) return false;
    transport.enable(true);
    plane.fit();
    started = performance.now();
    Object.assign(stage.dataset, { status: "running", begun: String(growth.epoch) });
    sheet.redraw();
    return true;
  }

  /** The settings cannot be used: what stands there stays, but does not go on. */
  function refuse() {
    growth.epoch++;
    transport.enable(false);
    stage.dataset.status = "refused";
    return false;
  }

  /** @returns {State} */
  function stateOf() {
    return { given: options.given, tried: growth.result?.iterations ?? 0, one: one.motion };
  }

  /** @param {State | null} state */
  async function show(state) {
    put(state?.given ?? {});
    const unknown = Object.keys(state?.given ?? {}).find((name) => !table.some((info) => info.name === name));
    if (unknown) throw new Error(`There is no setting "${unknown}" here.`);
    const wrong = (state?.one ?? ONE).some((value, i) => value < one.sliders[i].info.min || value > one.sliders[i].info.max);
    if (wrong) throw new Error("The single particle of this link is out of range.");
    one.put(state?.one ?? ONE);
    if (!await restart()) {
      if (state) throw new Error("Its settings cannot be used.");
      return;
    }
    if (state) await growth.advance(state.tried, news);
    else if (room.calm) await growth.advance(Infinity, news);
    else transport.start();
    sheet.refresh();
  }

  /** The numbers, as text and for tests. */
  function tell() {
    const { result, lines, tries, milliseconds, isLastRefused, options: { count = 1000 } } = growth;
    if (!result) return;
    const mean = (/** @type {number[]} */ values) => values.slice(-WINDOW).reduce((sum, value) => sum + value, 0) / Math.min(WINDOW, values.length);
    const last = result.iterations === 0 ? "none" : isLastRefused ? "refused" : "accepted";
    const status = stage.dataset.status === "refused" ? "refused" : result.status;
    Object.assign(stage.dataset, { status, accepted: String(lines.length), tried: String(result.iterations), drawn: String(plane.drawn), last, fingerprint: result.fingerprint });
    write(byId("fact-accepted", HTMLElement), `${grouped(lines.length)} of ${grouped(count)}`);
    write(byId("fact-tried", HTMLElement), grouped(result.iterations));
    write(byId("fact-tries", HTMLElement), tries.length === 0 ? "\u2013" : mean(tries).toFixed(1));
    write(byId("fact-time", HTMLElement), milliseconds.length === 0 ? "\u2013" : mean(milliseconds) === 0 ? "too short" : `${(1000 * mean(milliseconds)).toFixed(0)} \u00b5s`);
    write(byId("fact-pairs", HTMLElement), grouped(result.pairs));
    write(byId("fact-fingerprint", HTMLElement), transport.isPlaying ? "\u2013" : result.fingerprint);
    write(byId("where", HTMLElement), `${growth.options.model === "spiral" ? "Spirals" : "Arcs"} \u00b7 seed ${growth.options.seed ?? 0}`);
    write(byId("story", HTMLElement), sentence(last));
    sheet.describe(`${lines.length} trajectories of which no two cross, after ${result.iterations} tries.`);
  }

  /** What is going on, in a sentence. @param {string} last */
  function sentence(last) {
    const { result, refused, tries, lines } = growth;
    if (stage.dataset.status === "refused") return "These settings cannot be used: the panel says why.";
    if (result?.status === "solved") return `${grouped(lines.length)} trajectories, none of which crosses another, out of ${grouped(result.iterations)} tried. The last ${Math.min(WINDOW, tries.length)} took ${grouped(tries.slice(-WINDOW).reduce((sum, count) => sum + count, 0))} tries.`;
    if (result?.status === "exhausted") return `Given up after ${grouped(result.iterations)} tries: ${grouped(lines.length)} are accepted, and hardly anything fits between them.`;
    if (!transport.isPlaying && last === "refused" && refused) return `The last one is refused: it crosses number ${grouped(refused.other + 1)}.`;
    return "Random trajectories are added one by one; one that would cross an earlier one is refused.";
  }
});
