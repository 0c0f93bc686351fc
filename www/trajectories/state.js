/** The experiment as a link holds it: what differs from the defaults, the seed, how many were tried, and the single particle. */
import { list, number, record, settings, whole } from "../formats/rules.js";

/** @import { Rule } from "../formats/rules.js" */
/** @import { Settings } from "../domain/types.js" */
/** @import { Motion } from "./one.js" */

/**
 * @typedef {object} State
 * @property {Settings} given   what differs from the defaults, the seed among it
 * @property {number} tried     how many trajectories were tried
 * @property {Motion} [one]
 */

/** Trajectories that can be tried at most. */
const MOST_TRIED = 1_000_000;

/** @type {Rule} */
export const stateRule = record({ given: settings, tried: whole(MOST_TRIED), one: list(number, 3, 3) });
