/**
 * The words that the page's modules share. Types only: nothing here exists at run time.
 *
 * Of the package:
 *
 * @typedef {import("planarium").Scenario} Scenario
 * @typedef {import("planarium").Planner} Planner
 * @typedef {import("planarium").Status} Status
 * @typedef {import("planarium").Stats} Stats
 * @typedef {import("planarium").Part} Part   one moving part, in world coordinates
 * @typedef {import("planarium").ScenarioDocument} ScenarioDocument
 * @typedef {import("planarium").ResultDocument} ResultDocument
 * @typedef {import("planarium").Obstacle} Obstacle
 * @typedef {import("planarium").Query} Query
 * @typedef {import("planarium").Target} Target   of an end effector
 * @typedef {import("planarium").Configuration} Configuration   one number a degree of freedom
 * @typedef {import("planarium").Check} Check   which part touches what
 * @typedef {import("planarium").Box} Box
 * @typedef {import("planarium").PlannerInfo} PlannerInfo
 * @typedef {Omit<import("planarium").ParameterInfo, "option">} ParameterInfo
 * @typedef {import("planarium").GeneratorId} GeneratorId
 * @typedef {import("planarium").GeneratorInfo} GeneratorInfo
 * @typedef {ParameterInfo} OptionInfo
 * @typedef {typeof import("planarium")} Library  the package, handed to the modules that need it
 *
 * What is asked for:
 *
 * @typedef {Record<string, number | string | boolean>} Settings  what a planner is started with, by parameter name
 *
 * @typedef {object} Plan   what one planner is asked
 * @property {string} algorithm
 * @property {Settings} settings
 *
 * @typedef {{ document: object | string } | { generate: { kind: GeneratorId, options: Record<string, number | string | boolean> } }} Source   where a scenario comes from
 *
 * @typedef {object} Programme   how a scenario is put on the stage
 * @property {Plan[]} plans      one, or up to four that race
 * @property {string} [query]
 * @property {number} [pace]     iterations a second; those of before where absent
 * @property {import("../planner/story.js").Story} story
 * @property {boolean} play
 * @property {number} [iteration]   to be shown at once
 *
 * @typedef {object} ViewOptions   what is to be seen
 * @property {[number, number]} axes   coordinates of the configuration square, across and up
 * @property {boolean} refused    do crosses and broken lines stay
 * @property {boolean} strobe     poses along the path
 * @property {number} poses       how many, 3 to 24
 * @property {boolean} raw        the path as it was found, beside the shortened one
 * @property {boolean} slice      obstacles of a square of more than two joints, the others held as the robot shows them
 *
 * @typedef {"workspace" | "cspace"} PaneKind
 *
 * @typedef {object} Look
 * @property {import("../app/palette.js").Palette} palette
 * @property {number} ratio   device pixels a CSS pixel
 * @property {boolean} calm   less motion is asked for
 * @property {number} bold    how much thicker lines and dots are than usual
 *
 * @typedef {object} Pointer
 * @property {string} pane
 * @property {"down" | "move" | "up" | "cancel" | "hover" | "leave"} type
 * @property {number} x   CSS pixels of the pane
 * @property {number} y
 * @property {boolean} shift
 * @property {boolean} touch   a finger
 *
 * @typedef {"select" | "disc" | "rectangle" | "polygon"} EditTool
 * @typedef {["turn", boolean] | ["use", EditTool] | ["select" | "pick", -1 | 1] | ["nudge", number, number, boolean] | ["set", number, number]
 *   | ["go", -1 | 1] | ["insert" | "remove" | "duplicate" | "retarget" | "enter" | "cancel" | "revert"]} EditOrder   a method of the worker's editor, and what it takes
 *
 * @typedef {["turn", boolean, boolean, number] | ["press", import("planarium").DriveKey, number] | ["setByKeys", boolean, number] | ["pause" | "anew", number]
 *   | ["replay", import("planarium").KeyPress[] | null, number, number] | ["roll", number, number, number] | ["record"]} DriveOrder   a method of the worker's driving; moments are milliseconds since the epoch
 *
 * What is told:
 *
 * @typedef {object} Coordinate   one number of a configuration
 * @property {string} name
 * @property {number} low
 * @property {number} high
 * @property {"rad" | "m"} unit
 * @property {boolean} isCircle
 *
 * @typedef {object} SceneFacts
 * @property {string} name
 * @property {string} title
 * @property {Scenario["robot"]} robot
 * @property {number} dimension
 * @property {string[]} queries
 * @property {string | undefined} query
 * @property {Coordinate[]} coordinates
 * @property {number[] | null} start
 * @property {number[] | null} goal
 * @property {ScenarioDocument} document
 *
 * @typedef {object} Fault
 * @property {string} message
 * @property {string} code      stable, or empty
 * @property {string} pointer   JSON pointer, or empty
 *
 * @typedef {object} LaneState
 * @property {string} algorithm
 * @property {Status | "none"} status   at the iteration that is shown
 * @property {string} phase
 * @property {number} iteration
 * @property {number} made         iterations that the log knows of
 * @property {number} vertices
 * @property {number} edges
 * @property {number} checks
 * @property {number} motions
 * @property {number} evaluations
 * @property {number} cost         of the best path so far, Infinity while there is none
 * @property {number | null} length   once solved and at rest
 * @property {string} unit         of lengths
 * @property {string} fingerprint  at rest at the newest iteration, else empty
 * @property {"roadmap" | "tree" | "trees"} kind
 * @property {boolean} isProven
 * @property {boolean} isMiss
 * @property {boolean} hasGuards
 * @property {boolean} isSearched   has the search been to some vertex
 * @property {boolean} isApart      is it a roadmap in pieces, without a path
 * @property {boolean} hasRejected  samples were refused by then
 * @property {boolean} hasRefused   motions were refused by then
 * @property {number} waiting       vertices that the search has reached and not expanded
 * @property {number | null} raw    length of the path as it was found, where it is shorter now
 * @property {number | null} segments
 * @property {{ nearest: number, seconds: number } | null} stats   known of the newest iteration only: questions to the index, time of planning
 * @property {string[]} marks      what the iteration did, in the words of the pseudo-code
 * @property {import("../planner/race/standings.js").Standing} standing   beside the others of a race
 *
 * @typedef {object} State   what the page is told of a frame
 * @property {{ now: number, head: number, isRace: boolean, unit: number, wanted: number }} clock   `unit`: time in a step; `wanted`: the time that will be shown
 * @property {boolean} playing
 * @property {boolean} growing
 * @property {boolean} travelling
 * @property {number} along
 * @property {boolean} settled
 * @property {ViewOptions} view
 * @property {string} sentence
 * @property {boolean} isBad
 * @property {boolean} inHand
 * @property {boolean} arrived
 * @property {number[] | null} pose
 * @property {{ text: string, free: boolean }} touching
 * @property {{ vertex: number, text: string, free: boolean } | null} hover   what is pointed at; vertex -1: a mere pose
 * @property {LaneState[]} lanes
 * @property {string[]} summary   of each lane, in words
 * @property {string} curves   differs where the curves do
 * @property {Fault & { lane: number } | null} refusal   which lane the core would not plan
 * @property {EditState | null} edit   while the editor is on
 * @property {boolean} isEdited        the scenario was edited since it was opened
 * @property {DriveReport | null} drive   while the reader drives
 *
 * @typedef {import("planarium").DriveState & { paused: boolean, byKeys: boolean, replaying: boolean, said: string, arrived: boolean,
 *   rollout: { seconds: number, blocked: import("planarium").Obstructed | null } | null }} DriveReport   how a drive stands; `byKeys`: time goes by with each key alone
 *
 * @typedef {object} Field   one number of what is selected
 * @property {string} name
 * @property {number} value
 * @property {string} unit
 * @property {number} low
 * @property {number} high
 *
 * @typedef {object} EditState
 * @property {EditTool} tool
 * @property {"" | "end" | "disc" | "polygon"} kind   of what is selected; an end is start or goal
 * @property {"" | "pose" | "target"} goal   of an arm, where that is selected: one pose, or any that reaches a point
 * @property {string} title      of what is selected
 * @property {number} parts      its vertices, or its joints and end effector
 * @property {number | null} part
 * @property {Field[]} fields
 * @property {string} said       what was done last
 * @property {string} reason     why the last change was refused, or empty
 * @property {string} code       of that refusal
 * @property {string} touching   start or goal in collision, in words
 * @property {number} undoable
 * @property {number} redoable
 * @property {boolean} isChanged
 * @property {boolean} isBusy    a gesture is under way
 * @property {number} changes    ends of gestures so far
 *
 * @typedef {object} SheetLayout   a sheet's place on the stage, CSS pixels from its corner
 * @property {string} id
 * @property {number} x
 * @property {number} y
 * @property {{ x: number, y: number, width: number, name: string, note: string }} caption
 *
 * @typedef {object} TakeRequest   a picture to be made of the stage
 * @property {"png" | "svg" | "gif"} kind
 * @property {{ width: number, height: number, sheets: SheetLayout[] }} layout
 * @property {string} title
 * @property {number} ratio    of a png: pixels a CSS pixel
 * @property {number} width    of a gif: pixels
 * @property {number} frames   of a gif, at least 2
 *
 * @typedef {object} LaneLog   what a run left behind
 * @property {readonly string[]} phases   names, as the history numbers them
 * @property {number} width               numbers a row of history
 * @property {Float64Array} history       a row an iteration, from before the first on
 * @property {number} dimension
 * @property {Float64Array} vertices      those that are shown, rows of `dimension`
 * @property {Float64Array | null} path   once solved, and shown
 * @property {ResultDocument} result      at the newest iteration
 *
 * @typedef {object} Curves   how each run went, in few points
 * @property {string} key       as in the state
 * @property {number} head      the latest time told
 * @property {boolean} isRace
 * @property {Float64Array[]} lanes   rows of time, vertices, cost (Infinity without a path)
 *
 * @typedef {object} Slider   an option of a scene's generator that the page offers beneath the gallery
 * @property {string} option
 * @property {string} title
 * @property {number} min
 * @property {number} max
 * @property {number} step
 * @property {string} unit
 * @property {string[]} [words]   what the numbers from 0 on stand for, of an option that takes words
 *
 * @typedef {object} SceneEntry   one of the page's own scenes
 * @property {string} id          file name in `scenes/`, without its ending
 * @property {string} title
 * @property {string} story       one sentence: what to watch for
 * @property {string} algorithm
 * @property {number} pace        iterations per second at which it is good to watch
 * @property {Settings} settings  parameters that differ from the planner's defaults
 * @property {{ kind: GeneratorId, options: Record<string, number | string | boolean> }} [generate]   made by the core, not read from a file
 * @property {Slider[]} [sliders]
 */
export {};
