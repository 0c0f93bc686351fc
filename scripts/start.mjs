/**
 * `npm start`: installs tools, builds, and serves the pages and their documentation on PORT (8080). It also writes the
 * planner's page and that of experiments as one file each.
 */
import { join } from "node:path";
import { buildPackage } from "./build.mjs";
import { assembleOneFile, assemblePage } from "./page.mjs";
import { root, script } from "./run.mjs";
import { pagePolicy, requireFreePort, serve, wantedPort } from "./serve.mjs";
import { buildSite } from "./site.mjs";

await script(async () => {
  const port = wantedPort(8080);
  // A port in use is reported before the build.
  await requireFreePort(port);
  await buildPackage();
  await assemblePage();
  assembleOneFile();
  const { url } = await serve({
    root: join(root, "dist", "page"),
    port,
    policy: pagePolicy(),
    docs: join(root, "dist", "site"),
  });
  console.log(
    `\nPlanarium is at ${url} (Ctrl+C stops it). Its documentation will be at ${url}docs/ in half a minute; dist/planarium.html is the planner's page in one file, dist/planarium-experiments.html that of experiments.`,
  );
  await buildSite();
  console.log(`\nThe documentation is at ${url}docs/`);
});
