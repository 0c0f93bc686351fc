/**
 * The state that a link stores: the settings that differ from the defaults, the tries made, and the single particle.
 */
import { list, number, settings, whole, withDefaults } from "../formats/rules.js";

/** @typedef {[number, number, number]} Movement   speed, turn rate, duration */

/** The single particle at first. @type {Movement} */
export const FIRST = [1, Math.PI / 4, 4];

export const stateRule = withDefaults(
  {
    given: settings,
    tried: whole(1_000_000),
    one: /** @type {import("../formats/rules.js").Rule<Movement>} */ (list(number, 3, 3)),
  },
  { given: {}, tried: 0, one: FIRST },
);

/** @typedef {import("../formats/rules.js").Allowed<typeof stateRule>} State */
