/** Films of this page: the motion from A to B, and a run of inverse kinematics from its start to where it is now. */
import { filmOf, rowOf } from "../draw/export.js";
import { IkRun } from "./ik-run.js";

/** @import { Figure } from "../draw/figure.js" */
/** @import { Subject } from "../widgets/films.js" */
/** @import { Robot } from "./robot.js" */
/** @import { ReachSession } from "./session.js" */

/** Seconds of the motion from A to B, and iterations a second and seconds of a run. */
const MOTION = 4;
const RUN = { pace: 12, least: 3, most: 8 };

/** @param {ReachSession} session @param {Figure<any>[]} figures @returns {Subject[]} */
export function filmsOf(session, figures) {
  return [
    {
      id: "between",
      title: "From A to B",
      meaning: "The motion from A to B.",
      isOffered: () => session.mode !== "solve",
      lack: () => "",
      open: (width) => {
        const { robot, motion } = session;
        return filmOf(rowOf(figures), width, MOTION, (drawings, part) =>
          show(drawings, robot, motion.at(part), { mode: "between", motion, progress: part, tipGoal: null }),
        );
      },
    },
    {
      id: "solve",
      title: "Inverse kinematics",
      meaning: "The run from its start up to here.",
      isOffered: () => session.robot.isArm && session.mode !== "between",
      lack: () => (session.run?.run.iterations ? "" : "Choose Inverse kinematics and let it run first."),
      open: (width) => {
        const { robot, run } = session;
        if (!run) throw new Error("There is no run.");
        const { iterations } = run.run;
        let again = new IkRun(robot, run.problem);
        const seconds = Math.min(RUN.most, Math.max(RUN.least, iterations / RUN.pace));
        const film = filmOf(rowOf(figures), width, seconds, (drawings, part) => {
          requireSame(robot);
          const wanted = Math.round(part * iterations);
          if (wanted < again.run.iterations) {
            again.free();
            again = new IkRun(robot, run.problem);
          }
          again.step(wanted - again.run.iterations);
          const { index, q } = again.pose;
          show(drawings, robot, q, { run: again, chosen: index, tipGoal: null });
        });
        return { ...film, close: () => again.free() };
      },
    },
  ];

  /**
   * @param {Robot} robot
   * @throws {Error} `run-replaced`: the page has another robot by now, and the core has freed this one
   */
  function requireSame(robot) {
    if (session.robot !== robot)
      throw Object.assign(new Error("The robot changed during the export."), { code: "run-replaced" });
  }

  /**
   * Has drawings show another configuration, without the session.
   * @param {{ session: ReachSession }[]} drawings
   * @param {Robot} robot
   * @param {ArrayLike<number>} q
   * @param {Partial<ReachSession>} others
   */
  function show(drawings, robot, q, others) {
    requireSame(robot);
    const posed = Object.create(robot, { pose: { value: robot.poseAt(q) } });
    const shown = Object.create(
      session,
      Object.fromEntries(
        Object.entries({ ...others, robot: posed, refusal: null }).map(([name, value]) => [name, { value }]),
      ),
    );
    for (const drawing of drawings) drawing.session = shown;
  }
}
