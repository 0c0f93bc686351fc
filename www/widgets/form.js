import { byId } from "../app/dom.js";
import { Options } from "./options.js";

/** @import { Refusal } from "../app/room.js" */
/** @import { ParameterInfo, Settings } from "../domain/types.js" */

/**
 * A form of options in the element `PREFIX-settings`: valid settings are used, and what the core then refuses is shown
 * beside its field.
 * @param {string} prefix
 * @param {ParameterInfo[]} table
 * @param {Settings} given
 * @param {(given: Settings, onRefused: Refusal) => void} use
 * @param {string[]} [first]   options that are not folded away
 */
export function formOf(prefix, table, given, use, first) {
  const host = byId(`${prefix}-settings`, HTMLElement);
  const change = () => {
    if (form.settings) use(form.given, (pointer, reason) => form.refuse(pointer, reason));
  };
  const form = new Options(host, table, given, change, { prefix, first });
  return form;
}
