/**
 * The gallery of the course reports: its data, and how to add to it.
 *
 * `report-1.js` to `report-5.js` each export a report: its rows and its entries. A row is one thing that the report has, be it a figure, an
 * algorithm or a claim; the 161 rows are numbered from 1 through all reports, in the order of the texts. An entry is a picture that can be
 * opened: a page and the state that its link holds. A row names its entries by their ids; a row without one says where it is found.
 *
 * To add an entry:
 * 1. Choose an id: the report's number, a hyphen, and a name in lower case, such as `3-fig-8`. It is the address `gallery.html#3-fig-8`.
 * 2. Choose the page, and the `state` that the page's own rule allows (see `States`); defaults are left out. A world that no page has is a
 *    scenario in `worlds/NAME.json`, with `name` NAME and a `title`, and the entry's `world` is NAME: it becomes a part of the state.
 *    On the planner's page an entry without an `iteration` opens at the end of its run, as does a race.
 * 3. Say what the picture must show (`expect`), and write its texts: a sentence each, four at most. Name the report as "the report".
 * 4. Add its id to the rows that it is about.
 *
 * The build makes the links, the pictures and the page from this data: see `build/`. `tests/page/gallery.test.mjs` checks
 * that all rows are there, that every state is valid, and that every entry opens and shows what it should.
 *
 * Texts are plain: `code` between backticks is the only markup.
 */

/** @import { Experiment } from "../planner/link/codec.js" */
/** @import { View } from "../experiments/link.js" */
/** @import { State as ReachState } from "../reach/state.js" */
/** @import { State as NeighboursState } from "../neighbours/state.js" */
/** @import { State as TrajectoriesState } from "../trajectories/state.js" */
/** @import { State as LearnedState } from "../prm-rl/state.js" */

/** @typedef {"yes" | "partly" | "no"} Verdict */
/** @typedef {"figure" | "table" | "animation" | "experiment" | "system" | "function" | "algorithm" | "claim" | "interaction" | "other"} Kind */
/** What is planned for, or drawn. @typedef {"arm" | "point" | "body" | "car" | "drive" | "particle"} Robot */

/**
 * The state in the link of each page, without what the entry's world adds to it.
 * @typedef {object} States
 * @property {Partial<Omit<Experiment, "document" | "version">> & Pick<Experiment, "lanes">} planner
 * @property {Partial<ReachState>} reach
 * @property {Partial<NeighboursState>} neighbours
 * @property {Partial<TrajectoriesState>} trajectories
 * @property {Partial<LearnedState>} prm-rl
 * @property {{ document: string, worlds?: string[], view?: View }} experiments   the name of a document in `www/experiments/documents`, the
 *   names of those of its scenarios that are kept, all by default, and what is shown of its rows
 */
/** @typedef {keyof States} PageName */

/**
 * What an entry's page must show, once it is open:
 * - of the planner's page "solved", "exhausted" or "running" for the first planner at the iteration; "flawed" for a path that collides;
 *   "refused" where planning is refused, as the start or the goal is in collision;
 * - of Reach "free" or "in collision", the configuration shown;
 * - of Neighbours "found", or "drawn" where only the list is shown, of Trajectories and PRM-RL "solved" or "exhausted", of Experiments "open".
 * @typedef {"solved" | "exhausted" | "running" | "flawed" | "refused" | "free" | "in collision" | "found" | "drawn" | "open"} Expect
 */

/**
 * @template {PageName} P
 * @typedef {object} EntryOn
 * @property {string} id
 * @property {string} title      at most 48 characters
 * @property {string} name       its number or name in the report, such as "Fig. 8"; "" where it has none
 * @property {Kind} kind
 * @property {Robot} robot
 * @property {P} page
 * @property {States[P]} state
 * @property {string} [world]    a scenario in `worlds/`, without its extension
 * @property {Expect} expect
 * @property {string} see        what to see
 * @property {string} [try]      what to try
 * @property {string} [report]   what the report says
 * @property {Verdict} holds     whether what the report says or shows is right
 * @property {string} [why]      not, or only in part
 * @property {string} [chosen]   what is not in the report's text and was chosen here
 */
/** @typedef {{ [P in PageName]: EntryOn<P> }[PageName]} Entry */

/**
 * @typedef {object} Row
 * @property {number} row        1 to 161
 * @property {Kind} kind
 * @property {string} name       its number or name in the report; "" where it has none
 * @property {string} shows      what it shows, does or says
 * @property {Verdict} verdict   whether Planarium has it
 * @property {string} where      where it is: pages, options, functions, commands; or why it is not there
 * @property {string[]} entries  ids
 * @property {Verdict} holds     whether the report is right
 * @property {string} [why]      not, or only in part
 */

/** @typedef {{ number: 1 | 2 | 3 | 4 | 5, about: string, rows: Row[], entries: Entry[] }} Report   `about`: what it is about, a sentence */

/** Whether a report holds, in words. @type {Record<Verdict, string>} */
export const HOLDS = { yes: "holds", partly: "in part", no: "does not hold" };
/** The pages, as the links to them are called. @type {Record<PageName, string>} */
export const PAGES = { planner: "Plan", reach: "Reach", neighbours: "Neighbours", trajectories: "Trajectories", "prm-rl": "PRM-RL", experiments: "Experiments" };
