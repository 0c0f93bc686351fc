/**
 * The page's wiring: it loads the package, makes the parts and lets them know of each other. Nothing is put on `window`.
 *
 * What tests may rely on:
 * - `#counters` carries `data-status` ("loading", "failed", "none", "running", "solved", "exhausted"), `data-phase`,
 *   `data-iterations`, `data-vertices`, `data-edges`, and while the run is at rest and all is drawn `data-fingerprint`
 *   and, once solved, `data-length`.
 * - `#play` carries `data-playing`; `body` carries `data-scene` (an id of scenes.js, or "file").
 * - `#notice` is hidden, or carries `data-code` and `data-pointer` of the error it shows.
 * - `#touching` carries `data-free` and names what touches what.
 * - `#story` carries `data-tone`, "bad" where a path that was found collides.
 * - The work of each frame in which something grew is a `performance.measure` called "planarium-frame".
 */
import { Announcer } from "./announce.js";
import { Counters } from "./counters.js";
import { byId } from "./dom.js";
import { watchFiles } from "./drop.js";
import { Gallery } from "./gallery.js";
import { watchKeys } from "./keys.js";
import { showLegend } from "./legend.js";
import { Notice } from "./notice.js";
import { Panel } from "./panel.js";
import { Pose } from "./pose.js";
import { SCENES } from "./scenes.js";
import { Stage } from "./stage/stage.js";
import { Theatre } from "./theatre.js";
import { watchTheme } from "./theme.js";
import { Transport } from "./transport.js";

/** @import { Library, SceneEntry } from "./types.js" */

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
  const [library, text] = await Promise.all([load(), fetchScene(first)]);
  const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const story = byId("story", HTMLElement);
  const turn = byId("your-turn", HTMLButtonElement);
  const stageElement = byId("stage", HTMLElement);

  /** @type {Theatre} */
  let theatre;
  const stage = new Stage(stageElement, { change: () => theatre?.wake(), pose: (pose) => theatre.hold(pose) });
  const transport = new Transport({
    toggle: () => theatre.toggle(),
    step: (iterations) => theatre.step(iterations),
    finish: () => theatre.finish(),
    reset: () => theatre.reset(),
    seek: (part) => theatre.seek(part),
  });
  const panel = new Panel(library, () => theatre.changed());
  const pose = new Pose((at) => theatre.hold(at));
  theatre = new Theatre({
    stage, transport, counters, panel, pose, notice, announcer: new Announcer(),
    tell: (sentence, isBad = false) => {
      story.textContent = sentence;
      story.dataset.tone = isBad ? "bad" : "";
    },
    legend: showLegend,
    turn: (inHand) => {
      turn.textContent = inHand ? "Watch again" : "Your turn";
      stageElement.classList.toggle("in-hand", inHand);
    },
  }, calm);

  const gallery = new Gallery((entry) => void choose(entry));
  turn.addEventListener("click", (event) => theatre.takeTurn(event.detail === 0));
  turn.disabled = false;
  watchKeys([stageElement, transport.bar], {
    " ": () => theatre.toggle(),
    ".": () => theatre.step(1),
    e: () => theatre.finish(),
    r: () => theatre.reset(),
    n: () => panel.reseed(),
  });
  watchFiles(openFile, (name, error) => notice.show(`${name} could not be read.`, error));
  watchTheme(() => {
    stage.relay();
    void drawThumbnails();
  });

  openEntry(first, text);
  setTimeout(() => void drawThumbnails(), THUMBNAILS);

  /** The number of the latest wish: an answer that comes after a newer wish is dropped. */
  let wish = 0;

  /** @param {SceneEntry} entry */
  async function choose(entry) {
    const mine = ++wish;
    try {
      const json = await fetchScene(entry);
      if (mine === wish) openEntry(entry, json);
    } catch (error) {
      notice.show(`The scene "${entry.title}" could not be loaded.`, error);
    }
  }

  /** @param {SceneEntry} entry @param {string} json */
  function openEntry(entry, json) {
    theatre.open(library.Scenario.parse(json), entry);
    document.body.dataset.scene = entry.id;
    gallery.mark(entry.id);
  }

  /** A file of the reader's own. If it is refused, what is on the stage stays there. @param {string} name @param {string} json */
  function openFile(name, json) {
    let scenario;
    try {
      scenario = library.Scenario.parse(json);
    } catch (error) {
      notice.show(`${name} is not a scenario that can be shown.`, error);
      return;
    }
    wish++;
    theatre.open(scenario, { algorithm: panel.algorithm, settings: {}, pace: 60, story: `${scenario.title || scenario.name || name}.` });
    document.body.dataset.scene = "file";
    gallery.mark(null);
  }

  async function drawThumbnails() {
    for (const entry of SCENES) {
      const scenario = library.Scenario.parse(await fetchScene(entry));
      gallery.draw(entry.id, scenario);
      scenario.free();
    }
  }
}

/** The package: a page without it says so instead of staying empty. @returns {Promise<Library>} */
async function load() {
  const library = await import("./planarium/planarium.js");
  await library.default();
  return library;
}

/** @param {SceneEntry} entry @returns {Promise<string>} */
async function fetchScene(entry) {
  const response = await fetch(`scenes/${entry.id}.json`);
  if (!response.ok) throw new Error(`scenes/${entry.id}.json: ${response.status} ${response.statusText}`);
  return response.text();
}
