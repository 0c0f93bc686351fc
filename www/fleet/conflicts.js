/**
 * If all drove straight to their goals at once: a switch that shows it, and the pairs that would touch, each with its
 * time.
 */
import { byId, counted, make } from "../app/dom.js";
import { comparer } from "../app/once.js";
import { button } from "../widgets/elements.js";
import { num } from "../widgets/format.js";

/** @import { FleetConflict } from "planarium/full" */
/** @import { FleetSession } from "./session.js" */

/** Pairs in the list, at most. */
const MOST = 60;

/** @param {FleetSession} session @param {(isStraight: boolean, time?: number) => void} setStraight */
export function showConflicts(session, setStraight) {
  const toggle = byId("straight", HTMLInputElement);
  const list = byId("conflicts", HTMLUListElement);
  toggle.addEventListener("change", () => setStraight(toggle.checked));
  const differs = comparer();
  session.app.onShow(() => {
    toggle.checked = session.isStraight;
    if (differs("conflicts", session.conflicts)) showPairs(session.conflicts);
  });

  /** @param {FleetConflict[]} conflicts */
  function showPairs(conflicts) {
    session.app.write({
      "conflicts-told":
        conflicts.length === 0
          ? "No two robots would touch."
          : `${counted(conflicts.length, "pair")} would touch${conflicts.length > MOST ? `; the first ${MOST}` : ""}:`,
    });
    list.replaceChildren(
      ...conflicts.slice(0, MOST).map(({ robots: [a, b], from }) => {
        return make(
          "li",
          {},
          button("", `${a + 1} and ${b + 1} at ${num(from, 1)} s`, () => setStraight(true, from)),
        );
      }),
    );
  }
}
