/**
 * The slides of a class: one question and one live page each. The arrow keys turn the slides, Home and End lead to the
 * first and the last, A shows the answer and Space plays. In the live page keys do the same, but for those that it uses
 * itself, Space among them; after Escape there all keys belong to the slides again. The fragment is the number of the slide. A link in an
 * answer opens another page in the place of the slide's; pressed again, it returns to that. The pages that were shown
 * last stay as they were, so that one can go back to a run. On paper each question has a code that opens its page, and
 * the answers are on a separate sheet.
 *
 * For tests: `#deck` carries `data-slide`, counted from 1, and `body` `data-settled` ("true" once the live page has
 * loaded).
 */
import { byId, make } from "../app/dom.js";
import { codeWarning, qrCode } from "../app/qr-code.js";
import { dress, themeOf, watchTheme } from "../app/theme.js";

const deck = byId("deck", HTMLElement);
const slides = /** @type {HTMLElement[]} */ ([...document.querySelectorAll(".slide")]);
const [answer, previous, next] = ["answer", "previous", "next"].map((id) => byId(id, HTMLButtonElement));
const own = byId("own", HTMLAnchorElement);
/** The pages that were shown last, by their addresses, the latest at the end. @type {Map<string, HTMLIFrameElement>} */
const frames = new Map();
/** How many of them stay: each has a core. */
const KEPT = 4;
let at = -1;
/** The page that is shown: that of the slide, or one that its answer links to. */
let shown = "";

/** @param {boolean} isShown */
function showAnswer(isShown) {
  const [text] = slides[at].getElementsByClassName("answer");
  /** @type {HTMLElement} */ (text).hidden = !isShown;
  answer.ariaPressed = String(isShown);
  frames.forEach(follow);
}

/** Shows a page: as it was left, if it is among the latest. @param {string} page */
function showPage(page) {
  shown = own.href = page;
  for (const link of linksOf(slides[at])) link.ariaCurrent = link.getAttribute("href") === page ? "page" : null;
  for (const frame of frames.values()) if (!frame.classList.contains("past")) leave(frame);
  const { title = "" } = slides[at].dataset;
  const name = [...linksOf(slides[at])].find((link) => link.getAttribute("href") === page)?.textContent;
  const frame = frames.get(page) ?? load(page, name ? `${title}: ${name}` : title);
  frame.classList.remove("past");
  frames.delete(page);
  frames.set(page, frame);
  const [[oldest, its]] = frames;
  if (frames.size > KEPT) {
    its.remove();
    frames.delete(oldest);
  }
  showSettled();
}

/** The links of an answer. @param {HTMLElement} slide @returns {NodeListOf<HTMLAnchorElement>} */
const linksOf = (slide) => slide.querySelectorAll(".answer a");

/** Pauses a page and hides it; the keys belong to the slides again. @param {HTMLIFrameElement} frame */
function leave(frame) {
  frame.contentWindow?.postMessage({ planarium: "pause" }, "*");
  const inside = frame.contentDocument;
  // The page of experiments takes no messages.
  if (inside?.body?.dataset.phase === "running") inside.getElementById("run")?.click();
  if (document.activeElement === frame) deck.focus({ preventScroll: true });
  frame.dataset.awaited = "false";
  frame.classList.add("past");
}

/** Gives a page the theme of the slides. @param {HTMLIFrameElement} frame */
function follow({ contentDocument: inside }) {
  // There is no element yet while a page is being loaded: it follows once it has loaded.
  if (!inside?.documentElement) return;
  // The sentence of a run that grows would answer the question.
  inside.documentElement.dataset.quiet = String(answer.ariaPressed !== "true");
  dress(inside, themeOf(document));
}

function showSettled() {
  document.body.dataset.settled = frames.get(shown)?.dataset.loaded ?? "false";
}

/** A new frame adds nothing to the history. @param {string} page @param {string} title */
function load(page, title) {
  const frame = Object.assign(document.createElement("iframe"), { title });
  frame.addEventListener("load", () => {
    frame.contentWindow?.addEventListener("keydown", (event) => {
      if (!event.defaultPrevented && !isTyped(event)) press(event);
    });
    const inside = /** @type {Document} */ (frame.contentDocument);
    new MutationObserver(() => begin(frame)).observe(inside, { subtree: true, attributeFilter: ["disabled"] });
    frame.dataset.loaded = "true";
    follow(frame);
    begin(frame);
    showSettled();
  });
  frame.src = page.replace(/^([\w-]+\.html)/, "$1?embed=1&projector=1");
  byId("frame", HTMLElement).append(frame);
  return frame;
}

/** @param {number} index */
function turnTo(index) {
  const to = Math.min(Math.max(index, 0), slides.length - 1);
  if (to === at) return;
  at = to;
  slides.forEach((slide, i) => {
    slide.hidden = i !== at;
  });
  showAnswer(false);
  showPage(slides[at].dataset.page ?? "");
  const [guides] = slides[at].getElementsByClassName("guides");
  byId("guides", HTMLElement).replaceChildren(...guides.cloneNode(true).childNodes);
  previous.disabled = at === 0;
  next.disabled = at === slides.length - 1;
  byId("at", HTMLElement).textContent = `${at + 1} of ${slides.length}`;
  deck.dataset.slide = String(at + 1);
  history.replaceState(null, "", `#${at + 1}`);
}

/** Whether a key belongs to the field or the slider that has the focus. @param {KeyboardEvent} event */
function isTyped({ target, key }) {
  return !key.startsWith("Page") && /** @type {Element} */ (target).matches("input, select, textarea, summary");
}

/** Shows the answer, or turns the slides, by a key. @param {KeyboardEvent} event */
function press(event) {
  const { key, ctrlKey, metaKey, altKey } = event;
  if (ctrlKey || metaKey || altKey) return;
  if (key === "a" || key === "A") answer.click();
  else turnBy(event);
}

/** Turns the slides by a key. @param {KeyboardEvent} event */
function turnBy({ key }) {
  if (key === "ArrowRight" || key === "PageDown") turnTo(at + 1);
  else if (key === "ArrowLeft" || key === "PageUp") turnTo(at - 1);
  else if (key === "Home") turnTo(0);
  else if (key === "End") turnTo(slides.length - 1);
}

/** The button that plays a page, once it can be pressed. @param {HTMLIFrameElement} frame */
function playOf({ contentDocument: inside }) {
  return /** @type {HTMLButtonElement | null | undefined} */ (inside?.querySelector(":is(#play, #run):enabled"));
}

/** Plays or pauses a live page; one that cannot play yet will, unless it is asked again. @param {HTMLIFrameElement} frame */
function toggle(frame) {
  const play = playOf(frame);
  if (play) play.click();
  else frame.dataset.awaited = String(frame.dataset.awaited !== "true");
}

/** Plays a page that was to play before it could; some have begun by themselves. @param {HTMLIFrameElement} frame */
function begin(frame) {
  const play = playOf(frame);
  if (frame.dataset.awaited !== "true" || !play) return;
  frame.dataset.awaited = "false";
  const isPlaying = play.dataset.playing === "true" || frame.contentDocument?.body?.dataset.phase === "running";
  if (!isPlaying) play.click();
}

/** The codes of all pages and the sheet of the answers: they are made with the first print. */
function prepareSheets() {
  if (document.querySelector("#answers")) return;
  for (const slide of slides) {
    const { page = "", title = "" } = slide.dataset;
    slide.prepend(qrCode(new URL(page, location.href).href, `QR code of the link to ${title}`));
  }
  const texts = slides.map((slide) => slide.querySelector(".answer")?.textContent ?? "");
  const list = make("ol", {}, ...texts.map((text) => make("li", {}, text)));
  deck.append(make("section", { id: "answers" }, make("h2", {}, "Answers"), list));
  const warning = codeWarning(location);
  if (warning) slides[0].before(make("p", { className: "warning" }, warning));
}

const open = () => turnTo((Number.parseInt(location.hash.slice(1), 10) || 1) - 1);

for (const link of slides.flatMap((slide) => [...linksOf(slide)]))
  link.addEventListener("click", (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    showPage(link.ariaCurrent ? (slides[at].dataset.page ?? "") : (link.getAttribute("href") ?? ""));
    if (event.detail > 0) deck.focus({ preventScroll: true });
  });
watchTheme(() => frames.forEach(follow));
answer.addEventListener("click", () => showAnswer(answer.ariaPressed !== "true"));
previous.addEventListener("click", () => turnTo(at - 1));
next.addEventListener("click", () => turnTo(at + 1));
// After a click of the mouse Space plays, rather than pressing the button again.
for (const button of [answer, previous, next, byId("theme", HTMLButtonElement)])
  button.addEventListener("click", ({ detail }) => detail > 0 && deck.focus({ preventScroll: true }));
addEventListener("hashchange", open);
addEventListener("keydown", (event) => {
  const { key, target, ctrlKey, metaKey, altKey } = event;
  if (key === " " && !(ctrlKey || metaKey || altKey || target instanceof HTMLButtonElement)) {
    event.preventDefault();
    toggle(/** @type {HTMLIFrameElement} */ (frames.get(shown)));
  } else press(event);
});
addEventListener("beforeprint", prepareSheets);
matchMedia("print").addEventListener("change", prepareSheets);
answer.disabled = false;
open();
