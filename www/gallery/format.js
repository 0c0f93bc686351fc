/**
 * The gallery: its data, and how to add to it.
 *
 * An entry is a picture that can be opened: a page and the state that its link holds. Every entry has a topic;
 * `topics.js` has the topics, and which entries come first in each. The entries of the five course reports are in
 * `report-1.js` to `report-5.js`, all others in `more.js`. A report also has rows. A row is one thing that the report
 * has, be it a figure, an algorithm or a claim; the 161 rows are numbered from 1 through all reports, in the order of
 * the texts. A row names its entries by their ids; a row without one says where it is found.
 *
 * An entry is one object. To add one:
 * 1. Choose an id: a name in lower case, such as `fleets-ring`, or in a report the report's number, a hyphen and a
 *    name, such as `3-fig-8`. It is the address `gallery.html#3-fig-8`.
 * 2. Choose its `topic`, its page, and the `state` that the page's own rule allows (see `States`); defaults are left
 *    out. A world that no page has is a scenario in `worlds/NAME.json`, with `name` NAME and a `title`, and the entry's
 *    `world` is NAME: it becomes a part of the state. On the planner's page an entry without an `iteration` opens at
 *    the end of its run, as does a race. `reports.js` sets `direct=false` wherever it applies, as in the reports.
 * 3. Say what the picture must show (`expect`), and write its texts: a sentence each, four at most. Name the report as
 *    "the report". A number that the page shows is in `shows`, and in the text by its name: `{visited}`, or of the
 *    second planner of a race `{visited B}`. Every other number in `see` is one of the entry's settings.
 * 4. Of a report: add its id to the rows that it is about. If it is among the best of its topic: to `best` there.
 *
 * The build makes the links, the pictures and the page from this data: see `build/`.
 * `tests/page/gallery-entries.test.mjs` checks that all rows are there, that every state is valid, and that every entry
 * opens and shows what it should, to the numbers in `shows`.
 *
 * Texts are plain: `code` between backticks is the only markup.
 */

/** @import { Experiment } from "../planner/link/codec.js" */
/** @import { View } from "../experiments/link.js" */
/** @import { State as ReachState } from "../reach/state.js" */
/** @import { State as NeighboursState } from "../neighbours/state.js" */
/** @import { State as TrajectoriesState } from "../trajectories/state.js" */
/** @import { State as LearnedState } from "../prm-rl/state.js" */
/** @import { State as FleetState } from "../fleet/state.js" */

/** Whether Planarium has it. @typedef {"yes" | "partly" | "no"} Verdict */
/**
 * Whether the report is right; "unclear" where its text does not say enough to tell.
 * @typedef {Verdict | "unclear"} Holds
 */
/**
 * @typedef {"figure" | "table" | "animation" | "experiment" | "system" | "function" | "algorithm" | "claim" |
 *   "interaction" | "other"} Kind
 */
/** What is planned for, or drawn. @typedef {"arm" | "point" | "disc" | "body" | "car" | "drive" | "particle"} Robot */
/**
 * @typedef {"sampling" | "roadmaps" | "narrow-passages" | "trees" | "optimal-paths" | "cars" | "neighbours" |
 *   "kinematics" | "fleets" | "learned-edges"} Topic
 */

/**
 * The state in the link of each page, without what the entry's world adds to it.
 * @typedef {object} States
 * @property {Partial<Omit<Experiment, "document" | "version">> & Pick<Experiment, "lanes">} planner
 * @property {Partial<ReachState>} reach
 * @property {Partial<NeighboursState>} neighbours
 * @property {Partial<TrajectoriesState>} trajectories
 * @property {Partial<LearnedState>} prm-rl
 * @property {Partial<FleetState>} fleet
 * @property {{ document: string, worlds?: string[], view?: View }} experiments   the name of a document in
 *   `www/experiments/documents`, the names of those of its scenarios that are kept, all by default, and what is shown
 *   of its rows
 */
/** @typedef {keyof States} PageName */

/**
 * What an entry's page must show, once it is open:
 * - of the planner's page "solved", "exhausted" or "running" for the first planner at the iteration; "flawed" for a
 *   path that collides; "refused" where planning is refused, as the start or the goal is in collision;
 * - of Reach "free" or "in collision", the configuration shown;
 * - of Neighbours "found", or "drawn" where only the list is shown, of Trajectories, PRM-RL and Fleet "solved" or
 *   "exhausted", of Experiments "open".
 * @typedef {"solved" | "exhausted" | "running" | "flawed" | "refused" | "free" | "in collision" | "found" | "drawn" |
 *   "open"} Expect
 */

/**
 * Numbers that the page shows once an entry is open, each with as many digits as the text has; of a race a list, one
 * for each planner, or null where it shows none.
 * @typedef {object} Of
 * @property {number | (number | null)[]} iterations
 * @property {number | (number | null)[]} vertices
 * @property {number | (number | null)[]} edges
 * @property {number | (number | null)[]} motions    motions tested
 * @property {number | (number | null)[]} length     of the path
 * @property {number | (number | null)[]} waypoints  vertices of the path
 * @property {number | (number | null)[]} visited    vertices that the search has visited; of Neighbours configurations
 * @property {number} pieces                connected components of a roadmap without a path
 * @property {number} crossings             edges across 0 of any joint
 * @property {number} turn                  of joint 1 along the path, or of a body from A to B, radians
 * @property {number} end                   of joint 1 where a motion does not end at B, radians
 * @property {number} missed                of Neighbours the nearest that are not found
 * @property {number} apart                 metres between the ends of two curves
 * @property {number} solutions             of inverse kinematics
 * @property {number} accepted              trajectories
 * @property {number} reached               drives that reach the goal
 * @typedef {Partial<Of>} Shows
 */

/**
 * @template {PageName} P
 * @typedef {object} RunOn
 * @property {string} id
 * @property {string} title      at most 48 characters
 * @property {Topic} topic
 * @property {Robot} robot
 * @property {P} page
 * @property {States[P]} state
 * @property {string} [world]    a scenario in `worlds/`, without its extension
 * @property {Expect} expect
 * @property {Shows} [shows]     numbers of the page, for its texts
 * @property {string} see        what to see
 * @property {string} [try]      what to try
 */
/**
 * What an entry of a report also has.
 * @typedef {object} Reported
 * @property {string} name       its number or name in the report, such as "Fig. 8"; "" where it has none
 * @property {Kind} kind
 * @property {string} [report]   what the report says
 * @property {Holds} holds       whether what the report says or shows is right
 * @property {string} [why]      not, only in part, or unknown: then what our own world shows
 * @property {string} [chosen]   what is not in the report's text and was chosen here
 */
/** @template {PageName} P @typedef {RunOn<P> & Reported} EntryOn */
/** @typedef {{ [P in PageName]: RunOn<P> & Partial<Reported> }[PageName]} Entry */
/** @typedef {{ [P in PageName]: EntryOn<P> }[PageName]} ReportedEntry */

/**
 * @typedef {object} Row
 * @property {number} row        1 to 161
 * @property {Kind} kind
 * @property {string} name       its number or name in the report; "" where it has none
 * @property {string} shows      what it shows, does or says
 * @property {Verdict} verdict   whether Planarium has it
 * @property {string} where      where it is: pages, options, functions, commands; or why it is not there
 * @property {string[]} entries  ids
 * @property {Holds} holds       whether the report is right
 * @property {string} [why]      not, only in part, or unclear: why
 */

/**
 * @typedef {{ number: 1 | 2 | 3 | 4 | 5, about: string, rows: Row[], entries: ReportedEntry[] }} Report   `about`: what it is
 *   about, a sentence
 */

/** Whether a report holds, in words. @type {Record<Holds, string>} */
export const HOLDS = { yes: "holds", partly: "in part", no: "does not hold", unclear: "unclear" };
/** The pages, as the links to them are called. @type {Record<PageName, string>} */
export const PAGES = {
  planner: "Planners",
  reach: "Kinematics",
  neighbours: "Neighbours",
  trajectories: "Trajectories",
  fleet: "Fleets",
  "prm-rl": "Learned edges",
  experiments: "Experiments",
};
