/** A static server for the pages and their documentation, for development and for tests. */
import { once } from "node:events";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { Problem, root as project } from "./run.mjs";

/** Only requests from this machine are served. */
const HOST = "127.0.0.1";

/**
 * Serves a folder, and the documentation at `/docs/`; files are read again for each request. A file with a compressed one beside it is
 * sent compressed to those who accept it.
 * @param {{ root: string, port: number, policy?: string, docs?: string }} options  two folders; port 0 chooses a free one; the policy is sent with every
 *   file of the first
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 * @throws {Problem} if the port is in use or not allowed
 */
export async function serve({ root, port, policy, docs }) {
  // Imported here, so that the port can be checked before the development tools are installed.
  const { default: sirv } = await import("sirv");
  const files = sirv(root, { dev: true, brotli: true, gzip: true, setHeaders: (response) => { if (policy) response.setHeader("content-security-policy", policy); } });
  const documentation = docs === undefined ? files : sirv(docs, { dev: true });
  const server = createServer((request, response) => {
    const inDocs = docs === undefined ? null : /^\/docs(\/.*)$/.exec(request.url ?? "");
    if (inDocs) request.url = inDocs[1];
    (inDocs ? documentation : files)(request, response, () => {
      response.writeHead(404, { "content-type": "text/plain; charset=utf-8" }).end("Not found\n");
    });
  });
  await listen(server, port);
  const address = /** @type {import("node:net").AddressInfo} */ (server.address());
  return { url: `http://localhost:${address.port}/`, close: () => close(server) };
}

/** The policy that the pages state in their HTML. As a header it holds in their workers too. */
export function pagePolicy() {
  const [, policy] = /Content-Security-Policy" content="([^"]*)"/.exec(readFileSync(join(project, "www", "app", "shell.html"), "utf8")) ?? [];
  return policy;
}

/**
 * Fails if `serve` would fail on this port.
 * @param {number} port
 * @throws {Problem}
 */
export async function requireFreePort(port) {
  const server = createServer();
  await listen(server, port);
  await close(server);
}

/** @param {import("node:http").Server} server @param {number} port */
async function listen(server, port) {
  await once(server.listen(port, HOST), "listening").catch((error) => { throw explain(error, port); });
}

/** @param {import("node:http").Server} server */
async function close(server) {
  const closed = once(server.close(), "close");
  server.closeAllConnections();
  await closed;
}

/** @param {NodeJS.ErrnoException} error @param {number} port */
function explain(error, port) {
  if (error.code === "EADDRINUSE") return new Problem(`Port ${port} is in use. Choose another one: PORT=${(port % 65535) + 1} npm start`);
  if (error.code === "EACCES") return new Problem(`Port ${port} is not allowed. Choose a port above 1023: PORT=8080 npm start`);
  return error;
}
