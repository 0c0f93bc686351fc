/** The direction that the last link keeps while the tip is dragged, where the arm has the joints for it. */
import { byId, make } from "../app/dom.js";
import { Slider } from "../room/slider.js";

/** @import { Bench } from "./bench.js" */

/** Joints that it takes: two for the point, one for the direction. */
const JOINTS = 3;

/** @param {Bench} bench @param {() => void} onChange   the direction wanted is another */
export function showLock(bench, onChange) {
  const host = byId("lock", HTMLElement);
  const input = make("input", { type: "checkbox", id: "keep" });
  input.setAttribute("role", "switch");
  const hint = make("p", { className: "hint", id: "keep-hint" });
  input.setAttribute("aria-describedby", hint.id);
  const slider = new Slider({ name: "direction", title: "direction", unit: "rad", min: -Math.PI, max: Math.PI }, 0, (angle) => {
    bench.lock = angle;
    onChange();
  });
  host.append(make("label", { className: "row", htmlFor: "keep" }, make("span", { className: "name" }, "Keep the last link\u2019s direction"), input), slider.element, hint);
  input.addEventListener("change", () => {
    bench.lock = input.checked ? bench.arm.orientation : null;
    onChange();
  });
  bench.onChange(() => {
    const { lock, arm } = bench;
    input.disabled = arm.dimension < JOINTS;
    input.checked = lock !== null;
    slider.element.hidden = lock === null;
    if (lock !== null) slider.show(lock);
    hint.textContent = input.disabled ? "Two joints are used up by the point: a direction takes a third." : "";
    hint.hidden = !input.disabled;
  });
}
