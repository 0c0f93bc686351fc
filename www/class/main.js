/**
 * The slides of a class: one question and one live page each. The arrow keys turn the slides, A shows the answer and
 * Space plays. In the live page Page Up and Page Down, the keys of a remote control, turn the slides as well; after
 * Escape there all keys belong to the slides again. The fragment is the number of the slide. On paper each question has
 * a code that opens its page.
 *
 * For tests: `#deck` carries `data-slide`, counted from 1, and `body` `data-settled` ("true" once the live page has
 * loaded).
 */
import { byId } from "../app/dom.js";
import { qrCode } from "../app/qr-code.js";
import { watchTheme } from "../app/theme.js";

const deck = byId("deck", HTMLElement);
const slides = /** @type {HTMLElement[]} */ ([...document.querySelectorAll(".slide")]);
const [answer, previous, next] = ["answer", "previous", "next"].map((id) => byId(id, HTMLButtonElement));
const own = byId("own", HTMLAnchorElement);
let at = -1;

/** @param {boolean} isShown */
function showAnswer(isShown) {
  const [text] = slides[at].getElementsByClassName("answer");
  /** @type {HTMLElement} */ (text).hidden = !isShown;
  answer.ariaPressed = String(isShown);
}

/** Only the page that is shown is loaded; a new frame adds nothing to the history. */
function load() {
  const { page = "", title = "" } = slides[at].dataset;
  own.href = page;
  document.body.dataset.settled = "false";
  const frame = Object.assign(document.createElement("iframe"), { title });
  frame.addEventListener("load", () => {
    frame.contentWindow?.addEventListener("keydown", (event) => {
      if (event.key.startsWith("Page") && !event.defaultPrevented) turnBy(event);
    });
    document.body.dataset.settled = "true";
  });
  frame.src = page.replace(/^([\w-]+\.html)/, "$1?embed=1");
  byId("frame", HTMLElement).replaceChildren(frame);
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
  load();
  previous.disabled = at === 0;
  next.disabled = at === slides.length - 1;
  byId("at", HTMLElement).textContent = `${at + 1} of ${slides.length}`;
  deck.dataset.slide = String(at + 1);
  history.replaceState(null, "", `#${at + 1}`);
}

/** Turns the slides by a key. @param {KeyboardEvent} event */
function turnBy({ key }) {
  if (key === "ArrowRight" || key === "PageDown") turnTo(at + 1);
  else if (key === "ArrowLeft" || key === "PageUp") turnTo(at - 1);
}

/** Plays or pauses the live page. */
function play() {
  const [frame] = byId("frame", HTMLElement).getElementsByTagName("iframe");
  /** @type {HTMLButtonElement | null | undefined} */ (frame?.contentDocument?.querySelector("#play, #run"))?.click();
}

/** The codes of all pages: they are drawn with the first print. */
function drawCodes() {
  if (document.querySelector(".slide svg")) return;
  for (const slide of slides) {
    const { page = "", title = "" } = slide.dataset;
    slide.prepend(qrCode(new URL(page, location.href).href, `QR code of the link to ${title}`));
  }
}

const open = () => turnTo((Number.parseInt(location.hash.slice(1), 10) || 1) - 1);

// The page in the frame reads the theme when it opens.
watchTheme(load);
answer.addEventListener("click", () => showAnswer(answer.ariaPressed !== "true"));
previous.addEventListener("click", () => turnTo(at - 1));
next.addEventListener("click", () => turnTo(at + 1));
// After a click of the mouse Space plays, rather than pressing the button again.
for (const button of [answer, previous, next])
  button.addEventListener("click", ({ detail }) => detail > 0 && deck.focus({ preventScroll: true }));
addEventListener("hashchange", open);
addEventListener("keydown", (event) => {
  const { key, target, ctrlKey, metaKey, altKey } = event;
  if (ctrlKey || metaKey || altKey) return;
  if (key === "a" || key === "A") answer.click();
  else if (key === " " && !(target instanceof HTMLButtonElement)) {
    event.preventDefault();
    play();
  } else turnBy(event);
});
addEventListener("beforeprint", drawCodes);
matchMedia("print").addEventListener("change", drawCodes);
answer.disabled = false;
open();
