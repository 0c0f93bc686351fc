/** A 2D context that records what is drawn. */

/**
 * @typedef {{ call: string, numbers: number[] }} Step   of a path, such as `lineTo`
 * @typedef {{ call: "fill" | "stroke" | "strokeRect", style: string, width: number, numbers: number[], path: Step[] }}
 *   Drawn
 */

/** @returns {{ context: CanvasRenderingContext2D, drawn: Drawn[] }}  `drawn`: what was filled and stroked, in order */
export function recordingContext() {
  /** @type {Drawn[]} */
  const drawn = [];
  /** @type {Step[]} */
  let path = [];
  let state = { fillStyle: "black", strokeStyle: "black", lineWidth: 1, lineCap: "butt", lineJoin: "miter" };
  /** @type {(typeof state)[]} */
  const saved = [];
  const add =
    (/** @type {string} */ call) =>
    (/** @type {number[]} */ ...numbers) => {
      if (!numbers.every(Number.isFinite)) throw new RangeError(`${call}(${numbers})`);
      path.push({ call, numbers });
    };
  const draw =
    (/** @type {Drawn["call"]} */ call) =>
    (/** @type {number[]} */ ...numbers) => {
      drawn.push({
        call,
        style: call === "fill" ? state.fillStyle : state.strokeStyle,
        width: state.lineWidth,
        numbers,
        path: call === "strokeRect" ? [] : path,
      });
    };
  const calls = {
    beginPath: () => {
      path = [];
    },
    moveTo: add("moveTo"),
    lineTo: add("lineTo"),
    arc: add("arc"),
    closePath: add("closePath"),
    fill: draw("fill"),
    stroke: draw("stroke"),
    strokeRect: draw("strokeRect"),
    save: () => {
      saved.push({ ...state });
    },
    restore: () => {
      state = saved.pop() ?? state;
    },
  };
  /** @type {unknown} */
  const context = new Proxy(calls, {
    get: (_, name) =>
      calls[/** @type {keyof typeof calls} */ (name)] ?? state[/** @type {keyof typeof state} */ (name)],
    set: (_, name, value) => {
      if (!(name in state)) throw new TypeError(`no style ${String(name)}`);
      state = { ...state, [name]: value };
      return true;
    },
  });
  return { context: /** @type {CanvasRenderingContext2D} */ (context), drawn };
}
