/**
 * A form built from a table of options such as the core's. Each field shows its meaning, and why a value is refused.
 */
import { make, reveal } from "../app/dom.js";
import { Field } from "./field.js";

/** @import { ParameterInfo, Settings } from "../domain/types.js" */

export class Fields {
  /** @param {Field[]} fields */
  constructor(fields) {
    this.fields = fields;
  }

  /** All values, or null while one is invalid. @returns {Settings | null} */
  get settings() {
    // Each field is validated, so that each shows its reason.
    const isValid = this.fields.map((field) => field.validate()).every(Boolean);
    const entries = this.fields.map(({ info, value }) => /** @type {const} */ ([info.name, value]));
    return isValid
      ? Object.fromEntries(/** @type {[string, number][]} */ (entries.filter(([, value]) => value !== undefined)))
      : null;
  }

  /** @param {string} name */
  field(name) {
    return this.fields.find(({ info }) => info.name === name);
  }

  /**
   * Shows beside a field why the core refused its value.
   * @param {string} pointer  JSON pointer into the options
   * @param {string} reason
   * @returns {boolean} whether there is such a field
   */
  refuse(pointer, reason) {
    const field = this.field(pointer.split("/")[1] ?? "");
    field?.refuse(reason);
    reveal(field?.element);
    return field !== undefined;
  }
}

export class Options extends Fields {
  /**
   * @param {HTMLElement} host   its content is replaced
   * @param {ParameterInfo[]} table
   * @param {Settings} given     the values that differ from the defaults
   * @param {() => void} onChange   called after a valid change
   * @param {{ prefix?: string, first?: string[] }} [layout]   the prefix begins the ids of the fields; fields that are
   *   not first are folded away
   */
  constructor(host, table, given, onChange, { prefix = "option", first = table.map(({ name }) => name) } = {}) {
    super(table.map((info) => new Field(info, given[info.name] ?? info.default, onChange, prefix)));
    const elements = (/** @type {boolean} */ isFirst) =>
      this.fields.filter(({ info }) => first.includes(info.name) === isFirst).map(({ element }) => element);
    const rest = elements(false);
    host.replaceChildren(
      ...elements(true),
      ...(rest.length > 0 ? [make("details", {}, make("summary", {}, "More"), ...rest)] : []),
    );
  }

  /** The values that differ from the defaults. @returns {Settings} */
  get given() {
    return Object.fromEntries(
      Object.entries(this.settings ?? {}).filter(([name, value]) => this.field(name)?.info.default !== value),
    );
  }
}
