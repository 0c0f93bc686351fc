/** `npm start`: installs tools, builds, and serves the pages and their documentation on PORT (8080). */
import { join } from "node:path";
import { buildPackage } from "./build.mjs";
import { assemblePage } from "./page.mjs";
import { Problem, root, script } from "./run.mjs";
import { pagePolicy, requireFreePort, serve } from "./serve.mjs";
import { buildSite } from "./site.mjs";

await script(async () => {
  const port = wantedPort();
  // A port in use is reported before the build.
  await requireFreePort(port);
  await buildPackage();
  await assemblePage();
  const { url } = await serve({ root: join(root, "dist", "page"), port, policy: pagePolicy(), docs: join(root, "dist", "site") });
  console.log(`\nPlanarium is at ${url} (Ctrl+C stops it). Its documentation will be at ${url}docs/ in half a minute.`);
  await buildSite();
  console.log(`\nThe documentation is at ${url}docs/`);
});

/** @returns {number} */
function wantedPort() {
  const text = process.env.PORT ?? "8080";
  const port = Number(text);
  if (!/^\d+$/.test(text) || port > 65535) throw new Problem(`PORT must be an integer from 0 to 65535, not \`${text}\`.`);
  return port;
}
