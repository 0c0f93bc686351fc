/**
 * The options of the stage: rejected samples and motions, configurations along the path, the path before shortcutting,
 * the shortest path, the axes.
 */
import { byId, make, write } from "../app/dom.js";
import { hasOptimum } from "./stage/lane.js";
import { row, toggle } from "../widgets/elements.js";

/** @import { Page } from "./page.js" */
/** @import { SceneFacts } from "./session.js" */
/** @import { State } from "./state.js" */

/** Limits of the number of configurations along the path. */
const POSES = { least: 3, most: 24 };

/** @param {Page} page */
export function watchView(page) {
  const poses = make("input", {
    type: "number",
    id: "view-poses",
    min: String(POSES.least),
    max: String(POSES.most),
    step: "1",
  });
  poses.oninput = () => {
    const count = Number(poses.value);
    const isValid = Number.isInteger(count) && count >= POSES.least && count <= POSES.most;
    if (isValid) page.setView({ poses: count });
    poses.ariaInvalid = String(!isValid);
  };
  const selects = ["across", "up"].map((way, i) => {
    const select = make("select", { id: `view-${way}` });
    select.addEventListener("change", () => {
      const [before, other] = [page.state?.view.axes[i] ?? 0, Number(selects[1 - i].value)];
      const chosen = Number(select.value);
      // The axes are swapped where both would be the same.
      const rest = chosen === other ? before : other;
      page.setView({ axes: i === 0 ? [chosen, rest] : [rest, chosen] });
    });
    return select;
  });
  const lengths = make("p", { className: "hint", id: "view-lengths" });
  const switches = {
    refused: option("refused"),
    strobe: option("strobe"),
    raw: option("raw"),
    slice: option("slice"),
    optimum: option("optimum"),
    regions: option("regions"),
  };
  const plane = make(
    "div",
    { id: "view-plane" },
    field("Horizontal axis", selects[0]),
    field("Vertical axis", selects[1]),
    field(
      "Obstacle slice",
      switches.slice,
      "Configurations of this plane that collide, with the other coordinates as they are now.",
    ),
  );
  const raw = field("Path before shortcutting", switches.raw);
  raw.append(lengths);
  const shortest = field("Shortest path", switches.optimum);
  const regions = field(
    "Voronoi regions",
    switches.regions,
    "Of a tree: each place has the colour of the vertex that is nearest to it. A sample there extends that vertex.",
  );
  const about = make("p", { className: "hint" });
  shortest.append(about);
  const number = inspector();
  byId("view", HTMLElement).append(
    field(
      "Show rejected",
      switches.refused,
      "Colliding samples as crosses, blocked motions as dashed lines up to the collision.",
    ),
    field("Configurations along the path", switches.strobe),
    field("Number of configurations", poses),
    raw,
    shortest,
    regions,
    plane,
    field("Vertex", number, "Type a vertex number or point at a vertex; both panes highlight it."),
  );

  page.onOpen(build);
  page.onState(reflect);

  /** @param {SceneFacts} facts */
  function build({ robot, dimension, coordinates }) {
    const many = dimension > 2;
    shortest.hidden = !hasOptimum({ robot, dimension });
    write(
      about,
      robot === "disc"
        ? "Dashed: no free path is shorter."
        : "Dashed: a reference, found on a fine grid. A run may find a shorter path.",
    );
    plane.hidden = !many;
    regions.hidden = dimension !== 2;
    for (const select of selects)
      select.replaceChildren(
        ...(many ? coordinates : []).map(({ name }, i) => make("option", { value: String(i) }, name)),
      );
  }

  /** @param {State} state */
  function reflect({ view, lanes: [{ raw: found, length, unit, vertices }] }) {
    number.max = String(Math.max(0, vertices - 1));
    for (const name of /** @type {const} */ (["refused", "strobe", "raw", "slice", "optimum", "regions"]))
      switches[name].checked = view[name];
    if (document.activeElement !== poses) poses.value = String(view.poses);
    if (!plane.hidden)
      selects.forEach((select, i) => {
        select.value = String(view.axes[i]);
      });
    write(
      lengths,
      found !== null && length !== null
        ? `${found.toFixed(2)} ${unit} before shortcutting, ${length.toFixed(2)} ${unit} after.`.replace(
            / (?=[ ,.])/g,
            "",
          )
        : "Shows the path before shortcutting, as a second line.",
    );
  }

  /** A field for the number of a vertex, in place of a pointer. */
  function inspector() {
    const readout = byId("readout", HTMLOutputElement);
    const input = make("input", {
      type: "number",
      id: "inspect",
      min: "0",
      step: "1",
      placeholder: "none",
    });
    // The readout is announced while the field has the focus, and not while a pointer moves.
    return Object.assign(input, {
      oninput: () => void page.inspect(input.value === "" ? -1 : Math.max(0, Math.floor(Number(input.value)))),
      onfocus: () => {
        readout.ariaLive = "polite";
      },
      onblur: () => {
        readout.ariaLive = "off";
      },
    });
  }

  /** @param {"refused" | "strobe" | "raw" | "slice" | "optimum" | "regions"} name */
  function option(name) {
    return toggle(`view-${name}`, (isOn) => page.setView({ [name]: isOn }));
  }
}

/**
 * A control with its name and its meaning.
 * @param {string} name
 * @param {HTMLElement} control
 * @param {string} [meaning]
 */
function field(name, control, meaning) {
  const element = make("div", { className: "field" }, row(name, control));
  if (meaning) element.append(make("p", { className: "hint" }, meaning));
  return element;
}
