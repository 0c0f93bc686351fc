/** The worker of the page in one file: it has the commands of this page only. */
import { serve } from "../app/worker-server.js";
import * as experiments from "./commands.js";

serve({ experiments });
