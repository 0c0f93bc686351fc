/** The worker of paths, which is started with the first of them. */
import { connect } from "../app/worker-client.js";

/** @import { ScenarioDocument } from "../domain/types.js" */
/** @import { PathWorker } from "./worker.js" */

/** @type {PathWorker | null} */
let remote = null;
/** The scene that the worker has. @type {ScenarioDocument | null} */
let held = null;

/** The worker; a lost one is replaced with the next call. @returns {PathWorker} */
export function pathWorker() {
  if (!remote) {
    const worker = new Worker("path-worker.js", { type: "module" });
    const core = /** @type {any} */ (undefined);
    remote = /** @type {PathWorker} */ (
      connect(worker, "paths", core, () => {
        worker.terminate();
        forgetScene();
        remote = null;
      })
    );
  }
  return remote;
}

/**
 * The worker with a scene: commands that follow are about it.
 * @param {ScenarioDocument} document
 */
export function workerWith(document) {
  const worker = pathWorker();
  if (held !== document) {
    held = document;
    // What follows a scene that is refused is refused as it was.
    worker.hold(document).catch(forgetScene);
  }
  return worker;
}

/** The worker has lost its scene, with an error of its core. */
export function forgetScene() {
  held = null;
}
