/** The button below the stage that asks whether a path exists, and the clearance that it has to have. */
import { byId, make } from "../../app/dom.js";
import { button } from "../../widgets/elements.js";

/** @import { App } from "../../app/app.js" */
/** @import { Certifying, Session } from "./certifying.js" */
/**
 * @typedef {object} State
 * @property {boolean} canCertify
 * @property {{ verdict: string | null } | null} certificate
 * @property {{ status: string }[]} lanes
 */
/**
 * @typedef {object} Page   what is taken of the page
 * @property {App} app
 * @property {Session} session
 * @property {(action: () => void) => void} act
 * @property {(listener: () => void) => void} onOpen
 * @property {(listener: (state: State) => void) => void} onState
 */

/** @param {Page} page @param {() => Promise<Certifying>} load   what decides it */
export function offerCertificate(page, load) {
  const { session, app } = page;
  const group = byId("certify", HTMLElement);
  /** @type {HTMLInputElement} */
  const clearance = make("input", {
    type: "number",
    id: "certify-clearance",
    min: "0",
    step: "any",
    value: "0",
    onchange: () => ask(),
  });
  const label = make("label", { htmlFor: clearance.id }, "with clearance above ", clearance, " m");
  const toggle = button("certify-ask", "Does a path exist?", () =>
    session.certifying?.on ? page.act(() => session.certifying?.end()) : ask(),
  );
  group.append(toggle, label);
  page.onState(reflect);
  page.onOpen(() => {
    clearance.value = "0";
  });

  function ask() {
    if (clearance.reportValidity()) void app.track(decide(), "Whether a path exists cannot be decided.");
  }

  async function decide() {
    session.certifying ??= await load();
    await session.certifying.begin(clearance.valueAsNumber || 0);
  }

  /** @param {State} state */
  function reflect({ canCertify, certificate, lanes }) {
    group.hidden = !canCertify && !certificate;
    label.hidden = !certificate;
    // A planner that gave up proves nothing: this does.
    toggle.classList.toggle("invite", !certificate && lanes.every(({ status }) => status === "exhausted"));
    toggle.textContent = certificate ? "Back to the run" : "Does a path exist?";
    group.dataset.verdict = certificate?.verdict ?? "";
    group.dataset.on = String(certificate !== null);
  }
}
