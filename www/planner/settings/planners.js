/** The planners: which of them serve a robot, their parameters, and what a planner runs with. */
import { robotName } from "../../domain/names.js";
import { changed } from "../../domain/option-names.js";
import { withSeed } from "../../widgets/field.js";

/** @import { ParameterInfo, Plan, PlannerInfo, Scenario, Settings } from "../../domain/types.js" */

/** Whether a planner or a parameter is for a robot. @param {object} info @param {string} robot */
export function fits(info, robot) {
  const { robots } = /** @type {{ robots?: readonly string[] | null }} */ (info);
  return !robots?.length || robots.includes(robot);
}

/** @param {Scenario["robot"]} robot */
export const withArticle = (robot) => `${robot === "arm" ? "an" : "a"} ${robotName(robot)}`;

export class Planners {
  /** @param {PlannerInfo[]} infos */
  constructor(infos) {
    this.infos = infos;
    /** @type {Map<string, PlannerInfo[]>} */
    this.served = new Map();
  }

  /** @param {string} algorithm */
  find(algorithm) {
    return this.infos.find(({ id }) => id === algorithm);
  }

  /** @param {string} algorithm */
  titleOf(algorithm) {
    return this.find(algorithm)?.title ?? algorithm;
  }

  /** The planners for a robot, in the same list each time. @param {string} robot @returns {PlannerInfo[]} */
  for(robot) {
    const served = this.served.get(robot) ?? this.infos.filter((info) => fits(info, robot));
    this.served.set(robot, served);
    return served;
  }

  /** @param {string} algorithm @param {string} robot */
  serves(algorithm, robot) {
    return this.for(robot).some(({ id }) => id === algorithm);
  }

  /** The robots that a planner is for, or that it is unknown. @param {string} algorithm */
  needs(algorithm) {
    const info = this.find(algorithm);
    return info
      ? `${info.title} needs ${info.robots.map(withArticle).join(" or ")}`
      : `There is no planner "${algorithm}"`;
  }

  /** The parameters of a planner and its seed; none of an unknown planner. @param {string} algorithm */
  parametersOf(algorithm) {
    const info = this.find(algorithm);
    return info ? withSeed(info.parameters) : [];
  }

  /**
   * What lanes run with: all parameters for the robot, defaults included. A lane without a seed has that of the first.
   * Settings that a lane's planner does not have are left out: they are kept for a planner that has them.
   * @param {Plan[]} lanes
   * @param {string} robot
   * @returns {Plan[]}
   */
  plansOf(lanes, robot) {
    const { seed = 0 } = lanes[0]?.settings ?? {};
    return lanes.map(({ algorithm, settings }) => {
      const table = this.parametersOf(algorithm).filter((info) => fits(info, robot));
      const given = /** @type {Settings} */ ({ seed, ...settings });
      const entries = table.map(({ name, default: value }) => /** @type {const} */ ([name, given[name] ?? value]));
      return { algorithm, settings: /** @type {Settings} */ (Object.fromEntries(entries.filter(isSet))) };
    });
  }

  /**
   * The settings of a plan that differ from the planner's defaults, sorted by name.
   * @param {Plan} plan
   * @returns {Plan}
   */
  shortened({ algorithm, settings }) {
    const usual = new Map(this.parametersOf(algorithm).map(({ name, default: value }) => [name, value]));
    return { algorithm, settings: changed(settings, (name) => usual.get(name)) };
  }
}

/** @param {readonly [string, ParameterInfo["default"] | undefined]} entry */
const isSet = ([, value]) => value !== null && value !== undefined;
