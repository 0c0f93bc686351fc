/** What was done to a scenario, so that it can be undone: one document a gesture. Documents share all that did not change. */

/** @import { ScenarioDocument } from "../../domain/types.js" */

/** History that can be undone at most. */
const DEPTH = 200;

export class History {
  /** @param {ScenarioDocument} first  the scenario as it was opened */
  constructor(first) {
    this.first = first;
    this.documents = [first];
    this.at = 0;
  }

  get now() { return this.documents[this.at]; }

  /** How many edits can be undone, and how many redone. */
  get undoable() { return this.at; }
  get redoable() { return this.documents.length - 1 - this.at; }

  /** One more edit; what was undone before it is forgotten. @param {ScenarioDocument} document @param {boolean} [goesOn]  it goes on with the edit before */
  commit(document, goesOn = false) {
    if (goesOn && this.at > 0) this.at--;
    this.documents.splice(this.at + 1, Infinity, document);
    if (this.documents.length > DEPTH + 1) this.documents.shift();
    this.at = this.documents.length - 1;
  }

  /** Goes back or on. @param {-1 | 1} way @returns {boolean} whether there was anywhere to go */
  go(way) {
    const there = this.documents[this.at + way] !== undefined;
    if (there) this.at += way;
    return there;
  }
}
