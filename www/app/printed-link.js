/**
 * The address of what is on screen for the printed page: as text, and as a QR code. It is made whenever the page has
 * come to rest, since a page cannot make a link while it is printed.
 */
import { ErrorInfo } from "../formats/rules.js";
import { byId, counted, make } from "./dom.js";
import { codeWarning, qrCode } from "./qr-code.js";

/** Characters of an address whose code can be read on paper. */
const MOST = 1200;
/** Characters of an address that is printed whole. */
const SHORT = 100;
/** Milliseconds at rest after which the link is made. */
const REST = 300;

/**
 * @template {object} S
 * @param {() => S} save   the state
 * @param {(state: S) => Promise<string>} encode   the fragment, without `#`
 */
export function printLink(save, encode) {
  const host = make("div", { id: "printed-link" });
  byId("announcer", HTMLElement).before(host);
  let timer = 0;
  /** The state whose link is shown, as JSON. */
  let shown = "";
  // The counters of a run come to rest with it, while the robot still drives along the path.
  const run = document.getElementById("counters") ?? document.body;
  let isSettled = false;
  const watch = () => {
    // It is also set to what it was.
    if ((run.dataset.settled === "true") === isSettled) return;
    isSettled = !isSettled;
    clearTimeout(timer);
    if (isSettled) timer = window.setTimeout(() => void renew(), REST);
  };
  new MutationObserver(watch).observe(run, { attributeFilter: ["data-settled"] });
  watch();
  addEventListener("beforeprint", () => {
    if (shown === "" || JSON.stringify(save()) !== shown) show("", "The page was still at work when it was printed.");
  });

  async function renew() {
    const state = save();
    const key = JSON.stringify(state);
    if (key === shown) return;
    try {
      const fragment = await encode(state);
      show(fragment, "");
    } catch (error) {
      if (!(error instanceof ErrorInfo)) throw error;
      show("", "What is shown is too large for a link; Export saves it as files.");
    }
    shown = key;
  }

  /** @param {string} fragment   or empty @param {string} reason   why there is none */
  function show(fragment, reason) {
    shown = "";
    const page = location.href.split("#")[0];
    const address = fragment ? `${page}#${fragment}` : page;
    const isCode = fragment !== "" && address.length <= MOST;
    const words = isCode
      ? `The code is the link to what is shown. ${codeWarning(location)}`.trimEnd()
      : reason ||
        `The link to what is shown has ${counted(address.length, "character")}, too many for a code on paper: the button Link copies it.`;
    host.replaceChildren(
      ...(isCode ? [qrCode(address, "QR code of the link to what is shown")] : []),
      make("p", {}, make("span", {}, address.length <= SHORT ? address : page), " ", words),
    );
    host.dataset.length = String(address.length);
  }
}
