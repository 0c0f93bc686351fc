/**
 * The start page: after the first paint it loads the core and grows its picture by a run of the planner. With reduced
 * motion it does so once it is asked to.
 *
 * For tests: `#grown` carries `data-state` ("picture", "running", "paused", "solved", "failed") and `data-iterations`,
 * and `body` `data-settled` ("true" while nothing grows or is loaded).
 */
import { byId } from "../app/dom.js";
import { readPalette } from "../app/palette.js";
import { watchTheme } from "../app/theme.js";
import { beginRun, drawRun } from "./growth.js";

/** @import { Run } from "./growth.js" */

/** Iterations of a frame at first, and by how much more there are in each next one. */
const FIRST = 1;
const MORE = 1.008;

const grown = byId("grown", HTMLElement);
const canvas = byId("canvas", HTMLCanvasElement);
const play = byId("grow", HTMLButtonElement);
const count = byId("count", HTMLElement);
const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));

/** @type {Run | null} */
let run = null;
let speed = FIRST;
let frame = 0;

/** @param {"running" | "paused" | "solved" | "failed"} state */
function enter(state) {
  cancelAnimationFrame(frame);
  grown.dataset.state = state;
  document.body.dataset.settled = String(state !== "running");
  play.textContent = { running: "Pause", paused: "Continue", solved: "Grow again", failed: "Try again" }[state];
  if (state === "running") frame = requestAnimationFrame(grow);
}

function grow() {
  if (!run) return;
  const status = run.planner.step(Math.floor(speed));
  speed *= MORE;
  draw();
  if (status === "running") frame = requestAnimationFrame(grow);
  else enter("solved");
}

function draw() {
  if (!run) return;
  const { clientWidth: width, clientHeight: height } = canvas;
  const ratio = devicePixelRatio || 1;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const path = drawRun(context, run, readPalette(grown), width, height);
  const { iterations } = run.planner;
  const length = path.slice(1).reduce((sum, [x, y], i) => sum + Math.hypot(x - path[i][0], y - path[i][1]), 0);
  grown.dataset.iterations = String(iterations);
  count.textContent = `Iteration ${iterations}, ${length ? `a path of ${length.toFixed(3)} m` : "no path yet"}`;
}

async function start() {
  play.disabled = true;
  document.body.dataset.settled = "false";
  try {
    const library = await import("planarium");
    await library.default();
    const begun = beginRun(library);
    run?.planner.free();
    run?.scenario.free();
    run = begun;
    speed = FIRST;
    enter("running");
  } catch {
    enter("failed");
    count.textContent = "The run could not be loaded; the picture shows its end.";
  }
  play.disabled = false;
}

watchTheme(draw);
new ResizeObserver(draw).observe(canvas);
play.addEventListener("click", () => {
  const { state } = grown.dataset;
  if (state === "running") enter("paused");
  else if (state === "paused") enter("running");
  else void start();
});
play.disabled = false;
document.body.dataset.settled = "true";

function begin() {
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) void start();
  if (location.protocol.startsWith("http")) navigator.serviceWorker?.register("offline.js").catch(() => {});
}

/** The first paint is reported after it; the task after the first frame may be before it on a busy machine. */
if (PerformanceObserver.supportedEntryTypes.includes("paint")) {
  new PerformanceObserver((list, observer) => {
    if (!list.getEntriesByName("first-contentful-paint").length) return;
    observer.disconnect();
    begin();
  }).observe({ type: "paint", buffered: true });
} else {
  requestAnimationFrame(() => setTimeout(begin));
}
