/** A panel of options, built from a table such as the core's own: each a field that says what it means and why it refuses a value. */
import { make } from "../app/dom.js";
import { Field } from "../widgets/field.js";

/** @import { OptionInfo, ParameterInfo, Settings } from "../domain/types.js" */

export class Options {
  /**
   * @param {HTMLElement} host   emptied and filled
   * @param {(OptionInfo | ParameterInfo)[]} table
   * @param {Settings} given     what differs from the defaults
   * @param {(name: string) => void} onChange   a good value was given
   * @param {string} [family]    begins the ids of its fields
   * @param {(name: string) => boolean} [isFirst]   the others stand in a fold
   */
  constructor(host, table, given, onChange, family = "option", isFirst = () => true) {
    this.fields = table.map((info) => new Field(info, given[info.name] ?? /** @type {number | string | boolean | null} */ (info.default), () => onChange(info.name), family));
    const [first, rest] = [true, false].map((wanted) => this.fields.filter(({ info }) => isFirst(info.name) === wanted).map(({ element }) => element));
    host.replaceChildren(...first);
    if (rest.length > 0) host.append(make("details", {}, make("summary", {}, "More"), ...rest));
  }

  /** All that is set, or null while a field holds a value that is refused. @returns {Settings | null} */
  get settings() {
    /** @type {Settings} */
    const settings = {};
    for (const field of this.fields) {
      if (!field.validate()) return null;
      const { value } = field;
      if (value !== undefined) settings[field.info.name] = value;
    }
    return settings;
  }

  /** What differs from the defaults: all that a link need say. @returns {Settings} */
  get given() {
    return Object.fromEntries(Object.entries(this.settings ?? {}).filter(([name, value]) => this.field(name)?.info.default !== value));
  }

  /** @param {string} name */
  field(name) { return this.fields.find(({ info }) => info.name === name); }

  /** Says beside a field why the core refused its value. @param {string} pointer  JSON pointer into the options @param {string} reason @returns {boolean} whether there is such a field */
  refuse(pointer, reason) {
    const field = this.field(pointer.split("/")[1] ?? "");
    field?.refuse(reason);
    return field !== undefined;
  }
}
