/**
 * The lesson of this page: each step asks a question above the stage; Run lets the robot drive and shows the answer.
 * The counts in the answers are those of the drives.
 */
import { byId } from "../app/dom.js";
import { LessonBand } from "../widgets/lesson.js";
import { FIRST, countsOf, noSettings } from "./session.js";
import { leastOf } from "./words.js";

/** @import { App } from "../app/app.js" */
/** @import { Question } from "../widgets/lesson.js" */
/** @import { NavigationSession } from "./session.js" */

/**
 * A step; its text is shown after the run.
 * @typedef {Question & { ends: Parameters<NavigationSession["setEnds"]>[0], run: () => Promise<void>, text: () =>
 *   string }} Step
 */

/** The floor of the lesson, and a start with a near and a far goal. */
const FLOOR = FIRST;
const START = [3.22, 0.37, -2.4];
const NEAR = [3.9, 4];
const FAR = [18.35, 6.6];
const TRIALS = 20;
/** The least share of a step with edges that are less reliable. */
const CARELESS = 0.5;

export class Lesson {
  /** @param {App} app @param {NavigationSession} session @param {() => void} play  plays the drives from their start */
  constructor(app, session, play) {
    this.app = app;
    this.session = session;
    this.play = play;
    /** From 1; 0 without a lesson. */
    this.step = 0;
    this.band = new LessonBand("Step of the lesson", {
      run: () => void app.track(this.answer(), "This step could not be run."),
      move: (by) => void app.track(this.put(this.step + by)),
      leave: () => this.leave(),
    });
    byId("begin-lesson", HTMLButtonElement).addEventListener(
      "click",
      () => void app.track(this.put(1)).then(() => this.band.run.focus()),
    );
  }

  /** @returns {Step[]} */
  get steps() {
    const { session } = this;
    const reached = () => `${countsOf(session.run.drives).reached} of ${TRIALS}`;
    return [
      {
        question: "What does the policy know about the floor while it drives?",
        choices: [
          "The whole map",
          "The distances along its rays, and the direction of the goal",
          "A picture from above",
        ],
        answer: 1,
        ends: { start: START, goal: NEAR },
        run: () => this.turn(),
        text: () =>
          `It knows ${session.floor.robot.sensor?.rays ?? 16} noisy distances and the direction of the goal, nothing else. Drag the robot: the rays follow.`,
      },
      {
        question: "The goal is near, in the same room. In how many of 20 drives will the policy alone reach it?",
        choices: ["Nearly all", "About half", "Hardly any"],
        answer: 0,
        ends: { start: START, goal: NEAR },
        run: () => this.drive("policy"),
        text: () =>
          `The policy alone reached it in ${reached()} drives. It was trained on short routes. Drag the goal behind an obstacle.`,
      },
      {
        question: "Now the goal is several rooms away. In how many of 20 drives will the policy alone reach it?",
        choices: ["Nearly all", "About half", "Hardly any"],
        answer: 2,
        ends: { start: START, goal: FAR },
        run: () => this.drive("policy"),
        text: () =>
          `The policy alone reached it in ${reached()} drives: it drives towards the goal, and gets stuck in rooms with the door on another side. Its rays show what is near, not the route.`,
      },
      {
        question: `Two vertices become an edge if enough rollouts of the policy succeed. If half of them are enough (least share ${CARELESS}), does the robot reach the goal along the path?`,
        choices: ["Yes, every time", "Not always: the failures of many edges add up"],
        answer: 1,
        ends: { start: START, goal: FAR },
        run: async () => {
          session.given["prm-rl"] = { least_share: CARELESS, reliability: 0 };
          await this.drive("prm-rl");
        },
        text: () =>
          `The least reliable edge succeeded in ${leastOf(session)?.count ?? 0} of ${leastOf(session)?.of ?? 0} rollouts. The goal was reached in ${reached()} drives. Hover over the edges of the path, and raise the least share or the reliability.`,
      },
      {
        question:
          "Now the roadmap prefers edges that succeed more often. Straight edges that are proven free are driven twice: without the sensor, and by the policy. What do they lack most?",
        choices: ["A driver that uses the sensor", "Edges that are learned"],
        answer: 0,
        ends: { start: START, goal: FAR },
        run: async () => {
          session.given = noSettings();
          for (const way of /** @type {const} */ (["straight", "straight-policy", "prm-rl"])) await this.drive(way);
        },
        text: () => {
          const [blind, seeing] = [session.runs.straight, session.runs["straight-policy"]].map(
            ({ drives }) => countsOf(drives).reached,
          );
          return `PRM-RL reached the goal in ${reached()} drives; straight edges in ${blind} without the sensor, and in ${seeing} by the policy. The proof covers straight motions only, and noise pushes the robot off them; a driver that uses the sensor corrects most of that. Learned edges also leave out what the driver often fails to drive. Open Compare to test all methods on many goals.`;
        },
      },
    ];
  }

  /** Drives in a way, and shows the drives from their start. @param {NavigationSession["way"]} way */
  async drive(way) {
    const { session } = this;
    session.trials = TRIALS;
    session.setWay(way);
    await session.plan(false);
    if ((await session.drive()) && !this.app.reducedMotion) this.play();
    else session.setTime(Infinity);
  }

  /** Turns the robot once on the spot. */
  async turn() {
    const { session, app, step } = this;
    const { document } = session;
    const [x, y, theta] = session.start;
    const begin = performance.now();
    for (let part = 0; !app.reducedMotion && part < 1;) {
      await new Promise(requestAnimationFrame);
      if (this.step !== step || session.document !== document) return;
      part = Math.min(1, (performance.now() - begin) / 2500);
      session.setEnds({ start: [x, y, theta + 2 * Math.PI * part] });
    }
    session.setEnds({ start: [x, y, theta] });
  }

  /** Asks the question of a step, with its floor. @param {number} step  from 1 */
  async put(step) {
    const { session, steps } = this;
    this.step = step;
    session.setPart("plan");
    session.open(FLOOR, steps[step - 1].ends);
    if (session.origin !== "shipped") session.usePolicy(session.shipped, "shipped");
    session.setWay(step <= 3 ? "policy" : "prm-rl");
    this.band.ask("Learned edges", steps[step - 1], step - 1, steps.length);
  }

  /** Runs the step and shows its answer. */
  async answer() {
    const { step } = this;
    const { run, ends, text } = this.steps[step - 1];
    this.session.setPart("plan");
    this.session.open(FLOOR, ends);
    this.band.show("run");
    try {
      await run();
      if (this.step === step) this.band.show("answer", text());
    } catch (error) {
      if (this.step === step) this.band.show("question");
      throw error;
    }
  }

  leave() {
    this.step = 0;
    this.band.hide();
  }
}
