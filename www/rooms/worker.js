/** The worker of the pages beside the planner's: it computes what takes longer than a frame. */
import { serve } from "../app/worker-server.js";
import * as experiments from "../experiments/commands.js";
import * as fleet from "../fleet/commands.js";
import * as neighbours from "../neighbours/commands.js";
import * as learned from "../prm-rl/commands.js";
import * as reach from "../reach/commands.js";
import * as trajectories from "../trajectories/commands.js";

serve({ experiments, fleet, neighbours, "prm-rl": learned, reach, trajectories });
