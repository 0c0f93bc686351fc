/**
 * The page's wiring: it starts the worker, makes the controls and lets them know of each other. Nothing is put on `window`.
 *
 * What tests may rely on:
 * - `#counters` carries `data-status` ("loading", "failed", "none", "running", "solved", "exhausted"), `data-phase`,
 *   `data-iterations`, `data-vertices`, `data-edges` of what is shown, `data-settled` ("true" while nothing moves and all is
 *   drawn), and while it is settled at the newest iteration `data-fingerprint` and, once solved, `data-length`.
 * - `#play` carries `data-playing`; `body` carries `data-scene` (an id of scenes.js, or "file").
 * - `#notice` is hidden, or carries `data-code` and `data-pointer` of the error it shows.
 * - `#touching` carries `data-free` and names what touches what.
 * - `#story` carries `data-tone`, "bad" where a path that was found collides.
 * - In the worker, the work of each frame in which something grew is a `performance.measure` called "planarium-frame".
 */
import { Announcer } from "./controls/announce.js";
import { Counters } from "./controls/counters.js";
import { byId } from "./controls/dom.js";
import { watchFiles } from "./controls/drop.js";
import { Gallery, SIDE } from "./controls/gallery.js";
import { watchKeys } from "./controls/keys.js";
import { showLegend } from "./controls/legend.js";
import { Notice } from "./controls/notice.js";
import { Panel } from "./controls/panel.js";
import { Pose } from "./controls/pose.js";
import { watchTheme } from "./controls/theme.js";
import { Transport } from "./controls/transport.js";
import { loadCore, loadScene, makeWorker } from "./resources.js";
import { SCENES } from "./scenes.js";
import { Sheets } from "./sheets.js";
import { readPalette } from "./stage/palette.js";
import { Studio } from "./studio.js";

/** @import { Look, Programme, SceneEntry, SceneFacts, Source, State } from "./types.js" */

/** Milliseconds after which the thumbnails are drawn: the stage comes first. */
const THUMBNAILS = 250;

const counters = new Counters();
const notice = new Notice();

try {
  await start();
} catch (error) {
  counters.none("failed");
  notice.show("Planarium could not start: it needs a browser with WebAssembly, and its own files beside this page.", error);
}

async function start() {
  const first = SCENES[0];
  const core = loadCore();
  const text = loadScene(first.id);
  text.catch(() => {});
  /** @type {State | null} */
  let state = null;
  const studio = new Studio(makeWorker(), reflect, (error) => notice.show("Something went wrong.", error));
  const { planners } = await studio.ask("start", [await core]);

  const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const story = byId("story", HTMLElement);
  const turn = byId("your-turn", HTMLButtonElement);
  const stage = byId("stage", HTMLElement);
  const announcer = new Announcer();
  const sheets = new Sheets(studio);
  const transport = new Transport({
    toggle: () => studio.tell("toggle"),
    step: (iterations) => studio.tell("step", iterations),
    show: (time) => studio.tell("seek", time),
    finish: () => studio.tell("finish"),
    reset: () => studio.tell("reset"),
    seek: (part) => studio.tell("along", part),
    pace: (pace) => studio.tell("pace", pace),
  });
  /** Whoever changes a setting of a run that moves or has ended wants to see the new one. */
  const goesOn = () => state !== null && (state.playing || (!calm && !state.growing && state.lanes.some(({ status }) => status !== "none")));
  const panel = new Panel(planners, () => studio.ask("freshSeed", []), () => {
    const { plan } = panel;
    if (plan) studio.tell("plan", [plan], goesOn());
  }, () => studio.tell("ask", panel.query.value, goesOn()));
  const pose = new Pose((at) => studio.tell("hold", at));
  const gallery = new Gallery(SCENES, (entry) => void choose(entry));
  /** What was announced last, by kind. */
  const said = { end: "", touching: "" };

  /** The number of the latest wish: an answer that comes after a newer wish is dropped. */
  let wish = 0;
  /** Is the first joint to be focused once the robot is in the hand? */
  let focusPose = false;

  turn.addEventListener("click", (event) => {
    focusPose = event.detail === 0;
    studio.tell("turn");
  });
  turn.disabled = false;
  watchKeys([stage, transport.bar], {
    " ": () => studio.tell("toggle"),
    ".": () => studio.tell("step", 1),
    ",": () => studio.tell("step", -1),
    e: () => studio.tell("finish"),
    r: () => studio.tell("reset"),
    n: () => void panel.reseed(),
  });
  watchFiles(openFile, (name, error) => notice.show(`${name} could not be read.`, error));
  watchTheme(dress);
  watchRatio();
  dress();

  await open({ document: await text }, first);
  setTimeout(() => void drawThumbnails(), THUMBNAILS);

  /** @returns {Look} */
  function look() { return { palette: readPalette(stage), ratio: devicePixelRatio || 1, calm }; }

  function dress() {
    studio.tell("dress", look());
    void drawThumbnails();
  }

  /** Asks to be told when the number of device pixels a CSS pixel changes. */
  function watchRatio() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
      dress();
      watchRatio();
    }, { once: true });
  }

  /** @param {SceneEntry} entry @returns {Promise<Source>} */
  async function sourceOf(entry) {
    return entry.generate ? { generate: entry.generate } : { document: await loadScene(entry.id) };
  }

  /** @param {SceneEntry} entry */
  async function choose(entry) {
    const mine = ++wish;
    try {
      const source = await sourceOf(entry);
      if (mine === wish) await open(source, entry);
    } catch (error) {
      notice.show(`The scene "${entry.title}" could not be loaded.`, error);
    }
  }

  /** @param {Source} source @param {SceneEntry} entry */
  async function open(source, entry) {
    panel.suggest(entry.algorithm, entry.settings);
    transport.pace = entry.pace;
    await put(source, { pace: entry.pace, story: entry.story }, entry.id);
  }

  /** A file of the reader's own. If it is refused, what is on the stage stays there. @param {string} name @param {string} json */
  async function openFile(name, json) {
    wish++;
    try {
      await put({ document: json }, { pace: 60, story: "" }, "file");
    } catch (error) {
      notice.show(`${name} is not a scenario that can be shown.`, error);
    }
  }

  /** @param {Source} source @param {Pick<Programme, "pace" | "story">} programme @param {string} id */
  async function put(source, programme, id) {
    const plan = panel.plan ?? { algorithm: panel.algorithm, settings: {} };
    notice.hide();
    const facts = await studio.ask("open", [source, { ...programme, plans: [plan], play: !calm }]);
    panel.offerQueries(facts.queries, facts.query);
    pose.build(facts);
    showSheets(facts);
    document.body.dataset.scene = id;
    gallery.mark(id === "file" ? null : id);
  }

  /** @param {SceneFacts} facts */
  function showSheets({ robot, dimension }) {
    const square = robot === "arm" && dimension >= 2;
    sheets.show([
      { id: "workspace", kind: "workspace", lane: 0, caption: "Workspace" },
      ...(square ? [{ id: "cspace", kind: /** @type {const} */ ("cspace"), lane: 0, caption: "Configuration space" }] : []),
    ]);
  }

  async function drawThumbnails() {
    for (const entry of SCENES) {
      const picture = await studio.ask("thumbnail", [await sourceOf(entry), SIDE, look()]);
      gallery.draw(entry.id, picture);
    }
  }

  /** Shows what the worker tells of a frame. @param {State} next */
  function reflect(next) {
    const before = state;
    state = next;
    const lane = next.lanes[0];
    if (!lane) return;
    counters.show(lane, next.settled);
    transport.show(next);
    showLegend(lane);
    if (story.textContent !== next.sentence) story.textContent = next.sentence;
    story.dataset.tone = next.isBad ? "bad" : "";
    turn.textContent = next.inHand ? "Watch again" : "Your turn";
    stage.classList.toggle("in-hand", next.inHand);
    if (next.pose) pose.show(next.pose);
    pose.tell(next.touching.text, next.touching.free);
    if (next.inHand && focusPose) pose.focus();
    if (next.inHand) focusPose = false;
    if (next.settled || !before?.settled) sheets.describe(next.summary);
    announce(next);
    if (next.refusal && next.refusal.message !== before?.refusal?.message) refuse(next);
  }

  /** @param {State} next */
  function announce(next) {
    const end = next.settled && next.lanes.every(({ status }) => status === "solved" || status === "exhausted") && !next.inHand ? next.sentence : "";
    if (end !== said.end && end !== "") announcer.say(end);
    said.end = end;
    const touching = next.arrived ? next.sentence : next.touching.free ? "" : next.touching.text;
    if (touching !== said.touching && touching !== "") announcer.say(touching);
    said.touching = touching;
  }

  /** The core would not plan this. @param {State} next */
  function refuse({ refusal }) {
    if (!refusal) return;
    if (!panel.refuse(refusal.pointer, refusal.message)) notice.show("This cannot be planned.", Object.assign(new Error(refusal.message), refusal));
  }
}
