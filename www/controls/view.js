/** What is to be seen on the stage: what was refused, poses along the path, the path as it was found, which joints a plane shows. */
import { write } from "./counters.js";
import { byId, make } from "./dom.js";

/** @import { Page } from "../page.js" */
/** @import { Sheets } from "../sheets.js" */

/** Poses along the path. */
const POSES = { least: 3, most: 24 };

/** @param {Page} page @param {Sheets} sheets */
export function watchView(page, sheets) {
  const { view } = page;
  const poses = make("input", { type: "number", id: "view-poses", min: String(POSES.least), max: String(POSES.most), step: "1", value: String(view.poses), autocomplete: "off" });
  poses.addEventListener("input", () => {
    const count = Number(poses.value);
    const good = Number.isInteger(count) && count >= POSES.least && count <= POSES.most;
    if (good) page.see({ poses: count });
    poses.setAttribute("aria-invalid", String(!good));
  });
  const [across, up] = ["across", "up"].map((way, i) => {
    const select = make("select", { id: `view-${way}` });
    select.addEventListener("change", () => {
      const chosen = Number(select.value);
      // The two change places where both would be the same.
      page.see({ axes: i === 0 ? [chosen, chosen === view.axes[1] ? view.axes[0] : view.axes[1]] : [chosen === view.axes[0] ? view.axes[1] : view.axes[0], chosen] });
      showPlane();
    });
    return select;
  });
  const slice = toggle("slice", "Slice of the obstacles", "What would collide on this plane, with the other joints as the robot has them.");
  const plane = make("div", { id: "view-plane" }, row("Joint across", across), row("Joint up", up), slice);
  const lengths = make("p", { className: "hint", id: "view-lengths" });
  const raw = toggle("raw", "Path as found");
  raw.append(lengths);
  byId("view", HTMLElement).append(
    toggle("refused", "What was refused", "Samples that collide as crosses; motions as broken lines, up to where they hit."),
    toggle("strobe", "Poses along the path"), row("How many poses", poses), raw, plane,
  );

  page.onOpen(({ robot, dimension }) => {
    const many = robot === "arm" && dimension > 2;
    plane.hidden = !many;
    for (const select of [across, up]) select.replaceChildren(...Array.from({ length: many ? dimension : 0 }, (_, i) => make("option", { value: String(i) }, `joint ${i}`)));
    if (!view.axes.every((axis) => axis < dimension)) page.see({ axes: [0, 1] });
    showPlane();
  });
  page.onState(({ lanes: [lane] }) => {
    const { raw: found, length, unit } = lane;
    write(lengths, found !== null && length !== null
      ? `${found.toFixed(2)} ${unit} as found, ${length.toFixed(2)} ${unit} shortened.`
      : "The path before it was shortened, where it was: see the planner\u2019s parameters.");
  });

  function showPlane() {
    [across, up].forEach((select, i) => { select.value = String(view.axes[i]); });
    const names = plane.hidden ? "" : `joint ${view.axes[0]} across, joint ${view.axes[1]} up`;
    sheets.annotate("cspace", names && view.slice ? `${names}; slice at the robot\u2019s pose` : names);
  }

  /** A switch for something to be seen. @param {"refused" | "strobe" | "raw" | "slice"} option @param {string} name @param {string} [meaning] */
  function toggle(option, name, meaning) {
    const input = make("input", { type: "checkbox", role: "switch", id: `view-${option}`, checked: view[option] });
    input.addEventListener("change", () => {
      page.see({ [option]: input.checked });
      showPlane();
    });
    return row(name, input, meaning);
  }
}

/** A control with its name, and what it means. @param {string} name @param {HTMLElement} control @param {string} [meaning] */
function row(name, control, meaning) {
  const field = make("div", { className: "field" }, make("label", { className: "row" }, make("span", { className: "name" }, name), control));
  if (meaning) field.append(make("p", { className: "hint" }, meaning));
  return field;
}
