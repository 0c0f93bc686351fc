/** The history of an edited scenario: a document for each change. Documents share their unchanged parts. */

/** @import { ScenarioDocument } from "../../domain/types.js" */

/** Changes that can be undone at most. */
const DEPTH = 200;

export class History {
  /** @param {ScenarioDocument} first  the scenario as it was opened */
  constructor(first) {
    this.first = first;
    this.documents = [first];
    this.at = 0;
  }

  get now() {
    return this.documents[this.at];
  }

  /** The number of changes that can be undone, and redone. */
  get undoable() {
    return this.at;
  }
  get redoable() {
    return this.documents.length - 1 - this.at;
  }

  /**
   * Adds a change; changes undone before are dropped.
   * @param {ScenarioDocument} document
   * @param {boolean} [goesOn]  it continues the previous one
   */
  commit(document, goesOn = false) {
    if (goesOn && this.at > 0) this.at--;
    this.documents.splice(this.at + 1, Infinity, document);
    if (this.documents.length > DEPTH + 1) this.documents.shift();
    this.at = this.documents.length - 1;
  }

  /** Undoes or redoes. @param {-1 | 1} way @returns {boolean} whether there was a change */
  go(way) {
    const isThere = this.documents[this.at + way] !== undefined;
    if (isThere) this.at += way;
    return isThere;
  }
}
