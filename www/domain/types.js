/**
 * Types that the modules of the pages share.
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
 * @typedef {import("planarium").GeneratorInfo} GeneratorInfo
 * @typedef {typeof import("planarium")} Library
 *
 * @typedef {[number, number]} Point   x and y
 * @typedef {Record<string, number | string | boolean>} Settings  the values of options, by name
 *
 * @typedef {{ algorithm: string, settings: Settings }} Plan   a planner and its settings
 *
 * @typedef {{ document: object | string } | { generate: Generation }} Source   the origin of a scenario
 * @typedef {{ kind: import("planarium").GeneratorId, options: Settings }} Generation   by a generator of the core
 *
 * @typedef {object} ViewOptions   of the stage
 * @property {[number, number]} axes   coordinates of the configuration square, across and up
 * @property {boolean} refused    rejected samples and blocked motions stay visible
 * @property {boolean} strobe     configurations along the path
 * @property {number} poses       how many, 3 to 24
 * @property {boolean} raw        the path before shortcutting
 * @property {boolean} slice      the obstacles in the plane of the two axes, with the other coordinates as they are now
 * @property {boolean} optimum    the shortest path, where it is known
 * @property {boolean} widest     the widest disc that passes, and its bottleneck
 * @property {boolean} safest     the safest path
 * @property {boolean} routes     the route graph
 * @property {number} detour      how many times as long as over a dense roadmap ways over it may be
 * @property {boolean} regions    the Voronoi regions of a tree, where a pane shows all coordinates
 *
 * @typedef {"workspace" | "cspace"} PaneKind
 *
 * @typedef {object} Pointer
 * @property {string} pane
 * @property {"down" | "move" | "up" | "cancel" | "hover" | "leave"} type
 * @property {number} x   CSS pixels of the pane
 * @property {number} y
 * @property {boolean} shift
 * @property {boolean} touch   a finger
 *
 * @typedef {"select" | "disc" | "rectangle" | "polygon" | "wall"} EditTool
 * @typedef {object} Coordinate   one number of a configuration
 * @property {string} name
 * @property {number} low
 * @property {number} high
 * @property {"rad" | "m"} unit
 * @property {boolean} isCircle
 *
 * @typedef {import("planarium/full").ExperimentWorld | { scene: string, name?: string, queries?: string[] } |
 *   { scenario: string, name?: string, queries?: string[] }} LinkedWorld   a scene by its name, or a file of this site
 * @typedef {Omit<import("planarium/full").ExperimentDocument, "worlds"> & { worlds: LinkedWorld[] }} LinkedDocument   of
 *   an experiment, as a link has it
 *
 * @typedef {object} Slider   for an option of a scene's generator
 * @property {string} option
 * @property {string} title
 * @property {number} min
 * @property {number} max
 * @property {number} step
 * @property {string} unit
 * @property {string[]} [words]   the values of a choice, by number from 0
 *
 * @typedef {object} SceneEntry   a built-in scene
 * @property {string} id          file name in `scenes/`, without its extension
 * @property {string} title
 * @property {string} story       one sentence about the run
 * @property {string} algorithm
 * @property {number} pace        iterations a second
 * @property {Settings} settings  that differ from the planner's defaults
 * @property {Generation} [generate]   in place of a file
 * @property {Slider[]} [sliders]
 */
export {};
