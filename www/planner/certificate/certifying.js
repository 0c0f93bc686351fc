/**
 * Whether a path exists, decided by dividing the configuration space into cells: in the worker, block by block, each
 * drawn before the next one is requested.
 */
import { grouped } from "../../app/dom.js";
import { numberText, small } from "../../widgets/format.js";
import { CSpace } from "../stage/cspace-pane.js";
import { CellPicture, WIDTH } from "./cells.js";

/** @import { Certificate } from "planarium" */
/** @import { PlannerWorker } from "../worker/worker.js" */
/** @import { Lane, Shown } from "../stage/lane.js" */
/** @import { Pane } from "../stage/pane.js" */

/** The part of the cells that a block divides: at first they are seen one by one, and later many are soon there. */
const PART = 0.012;

/**
 * @typedef {object} Session   what a subdivision takes of the page's session
 * @property {{ reducedMotion: boolean }} app
 * @property {{ halt: () => void }} clock
 * @property {Shown | null} shown
 * @property {Certifying | null} certifying
 * @property {() => void} markDirty
 */

/**
 * @typedef {object} Found
 * @property {Float64Array[]} blocks   rows of cells
 * @property {Certificate | null} certificate   once there is a verdict
 * @property {Float64Array} marked     rows of the certificate's cells
 * @property {Map<Pane, CellPicture>} pictures
 */

/** @returns {Found} */
const nothing = () => ({ blocks: [], certificate: null, marked: new Float64Array(), pictures: new Map() });

export class Certifying {
  /** @param {Session} session @param {PlannerWorker} worker */
  constructor(session, worker) {
    this.session = session;
    this.worker = worker;
    this.on = false;
    /** How many questions there have been: what comes for an older one is dropped. */
    this.asked = 0;
    /** That paths have to exceed, metres. */
    this.clearance = 0;
    this.found = nothing();
  }

  /** The answer, once there is one. */
  get verdict() {
    return this.found.certificate?.verdict ?? null;
  }

  /**
   * Divides cells until it is decided.
   * @param {number} clearance   that paths have to exceed, metres
   * @throws {Error} with `code` and `pointer`
   */
  async begin(clearance) {
    const { session, worker } = this;
    const { shown } = session;
    if (!shown) return;
    const asked = ++this.asked;
    const found = (this.found = nothing());
    this.clearance = clearance;
    this.on = true;
    shown.certifying = this;
    session.clock.halt();
    session.markDirty();
    try {
      await worker.certify(shown.document, { query: shown.query, clearance });
      while (asked === this.asked && !found.certificate) {
        const { cells, certificate } = await worker.divide(session.app.reducedMotion ? Infinity : PART);
        found.blocks.push(cells);
        if (certificate) Object.assign(found, { certificate, marked: rowsOf(certificate, found.blocks[0]) });
        session.markDirty();
        await new Promise((resolve) => requestAnimationFrame(resolve));
      }
    } catch (error) {
      if (asked !== this.asked) return;
      this.end();
      throw error;
    }
  }

  /** Shows the run alone again. */
  end() {
    if (!this.on) return;
    this.asked++;
    this.on = false;
    this.found = nothing();
    if (this.session.shown) this.session.shown.certifying = null;
    this.session.markDirty();
  }

  /** The sentence above the stage. */
  get sentence() {
    const { clearance } = this;
    const { blocks, certificate } = this.found;
    const path = clearance > 0 ? `path with clearance above ${numberText(clearance)} m` : "path";
    const blocked = clearance > 0 ? `comes within ${numberText(clearance)} m of an obstacle` : "is in collision";
    if (!certificate)
      return `Does a ${path} exist? Cells are split until in each either every configuration ${blocked}, or none.`;
    const cells = `${grouped(blocks.reduce((sum, { length }) => sum + length / WIDTH, 0))} cells`;
    const { verdict, clearance_at_most: most, slack } = certificate;
    if (verdict === "infeasible")
      return `No ${path} exists: in the solid cells every configuration ${blocked}, to within ${small(slack)} m, and they separate start and goal. ${cells}.`;
    if (verdict === "connected")
      return `A ${path} exists: it leads through the solid cells, in which no configuration ${blocked}. ${cells}.`;
    return `Not decided: gave up after ${cells}.${most === undefined ? "" : ` No path with clearance above ${small(roundedUp(most))} m exists.`}`;
  }

  /**
   * Draws the cells where configurations are points: on the square of two joints, and in the workspace of a disc.
   * @param {Pane} pane
   * @param {CanvasRenderingContext2D} context
   * @param {Lane} lane
   */
  draw(pane, context, { scenario }) {
    if (scenario.robot !== "disc" && !(pane instanceof CSpace)) return;
    const { verdict } = this;
    const { pictures, blocks, marked } = this.found;
    const picture = pictures.get(pane) ?? new CellPicture(pane);
    pictures.set(pane, picture);
    picture.draw(context, blocks, marked, verdict !== "connected");
  }
}

/**
 * The cells that separate start and goal, or connect them, as rows.
 * @param {Certificate} certificate
 * @param {Float64Array} whole   rows that begin with that of the whole square
 */
function rowsOf({ wall, channel }, [x, y, w, h]) {
  const cells = wall.length > 0 ? wall.map(({ cell }) => cell) : channel;
  return Float64Array.from(
    cells.flatMap(([depth, column, row]) => {
      const part = 2 ** -depth;
      return [x + w * (part * (2 * column + 1) - 1), y + h * (part * (2 * row + 1) - 1), w * part, h * part, 0];
    }),
  );
}

/** To two digits, and not less. @param {number} value   greater than 0 */
function roundedUp(value) {
  const unit = 10 ** (Math.floor(Math.log10(value)) - 1);
  return Math.ceil(value / unit) * unit;
}
