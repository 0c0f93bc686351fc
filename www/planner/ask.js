/**
 * A roadmap that stands is asked for another path: from or to the robot as it is posed by hand, or for another query of
 * the scene. Nothing is planned again.
 */
import { byId, make, write } from "../app/dom.js";
import { button } from "../widgets/elements.js";

/** @import { State } from "./state.js" */
/** @import { Configuration } from "../domain/types.js" */
/** @import { Page } from "./page.js" */

/** @param {Page} page */
export function watchAsking(page) {
  const { session, notice } = page;
  const row = byId("ask-row", HTMLElement);
  const queries = byId("ask-query", HTMLSelectElement);
  const group = byId("ask", HTMLElement);
  const byHand = [
    button("ask-from", "from here", () => ask(hand(), null)),
    button("ask-to", "to here", () => ask(null, hand())),
  ];
  const back = button("ask-own", "Back to the run", () => page.act(() => session.forget()));
  const name = make("span", { ariaHidden: "true" }, "Ask this roadmap");
  group.append(name, ...byHand, back);
  queries.addEventListener("change", () => {
    const query = session.shown?.document.queries.find((one) => one.name === queries.value);
    if (!query) page.act(() => session.forget());
    else if (query.goal) ask(query.start, query.goal, query.name);
    else
      fail(
        Object.assign(
          new Error(`the query "${query.name}" has a target, and a roadmap is asked for the path to a configuration`),
          { code: "unsupported" },
        ),
      );
  });
  page.onOpen(offer);
  page.onState(reflect);
  offer();
  if (page.state) reflect(page.state);

  function offer() {
    queries.replaceChildren(
      make("option", { value: "" }, "choose a query"),
      ...Array.from(page.panel.query.options, ({ value, text }) => make("option", { value }, text)),
    );
  }

  /** @param {State} state */
  function reflect({ canAsk, asked, inHand, lanes: [{ kind }], clock }) {
    row.hidden = queries.length < 3 || kind !== "roadmap" || clock.isRace;
    queries.disabled = !canAsk;
    Array.from(page.panel.query.options, ({ text }, i) => write(queries.options[i + 1], text));
    queries.value = asked ?? "";
    const { activeElement } = document;
    group.hidden = !canAsk || (!inHand && asked === null);
    for (const element of [name, ...byHand]) element.hidden = !inHand;
    back.hidden = asked === null || inHand;
    // A control that is hidden loses the focus.
    if (group.contains(activeElement) && !activeElement?.checkVisibility())
      (back.checkVisibility() ? back : byId("stage", HTMLElement)).focus();
  }

  /** The configuration posed by hand. @returns {Configuration | null} */
  function hand() {
    return session.shown?.hand ? Array.from(session.shown.hand) : null;
  }

  /**
   * Asks for a path; an end that is null stays as it is shown.
   * @param {Configuration | null} start
   * @param {Configuration | null} goal
   * @param {string} [query]  its name
   */
  function ask(start, goal, query = "") {
    const { shown } = session;
    const [from, to] = [start ?? shown?.start, goal ?? shown?.goals[0]];
    if (!from || !to) return;
    notice.hide();
    void page.app.track(session.ask(from, to, query).catch(fail));
  }

  /** @param {unknown} error */
  function fail(error) {
    queries.value = page.state?.asked ?? "";
    page.app.fail(error, "This roadmap cannot be asked.");
  }
}
