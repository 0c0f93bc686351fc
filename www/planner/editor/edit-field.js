/** A field of the editor for a number that is typed. */
import { Field } from "../../widgets/field.js";

/** @import { ParameterInfo } from "../../domain/types.js" */

/**
 * @param {Partial<ParameterInfo> & Pick<ParameterInfo, "name" | "title">} info
 * @param {number | null} value
 * @param {() => void} onEnter
 */
export function editField(info, value, onEnter) {
  const plain = {
    kind: "number",
    unit: "",
    min: null,
    max: null,
    default: value,
    choices: null,
    robots: [],
    meaning: "",
  };
  return new Field(/** @type {ParameterInfo} */ ({ ...plain, ...info }), value, onEnter, "edit", false);
}
