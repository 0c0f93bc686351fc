/** A static server for the pages and their documentation, for development and for tests. */
import { once } from "node:events";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { Problem, root as project } from "./run.mjs";

/** What is answered as long as there is no documentation. */
const NO_DOCS =
  "The documentation is not built yet. npm start builds it after the pages; npm run site builds it alone.\n";
/** Only requests from this machine are served. */
const HOST = "127.0.0.1";

/**
 * Serves a folder, and the documentation at `/docs/`; files are read again for each request. A file with a compressed
 * one beside it is sent compressed to those who accept it.
 * @param {{ root: string, port: number, policy?: string, docs?: string, reloads?: boolean }} options  two folders; port
 *   0 chooses a free one; the policy is sent with every file of the first; pages that reload load themselves again when
 *   asked to
 * @returns {Promise<{ url: string, close: () => Promise<void>, reload: () => void }>}
 * @throws {Problem} if the port is in use or not allowed
 */
export async function serve({ root, port, policy, docs, reloads = false }) {
  // Imported here, so that the port can be checked before the development tools are installed.
  const { default: sirv } = await import("sirv");
  const files = sirv(root, {
    dev: true,
    brotli: true,
    gzip: true,
    setHeaders: (response) => {
      if (policy) response.setHeader("content-security-policy", policy);
    },
  });
  const documentation = docs === undefined ? files : sirv(docs, { dev: true });
  /** Open pages. @type {Set<import("node:http").ServerResponse>} */
  const open = new Set();
  const server = createServer((request, response) => {
    if (reloads && answersReload(root, request, response, open)) return;
    const inDocs = docs === undefined ? null : /^\/docs(\/.*)$/.exec(request.url ?? "");
    if (inDocs) request.url = inDocs[1];
    (inDocs ? documentation : files)(request, response, () => {
      const text = inDocs && !existsSync(join(/** @type {string} */ (docs), "index.html")) ? NO_DOCS : "Not found\n";
      response.writeHead(404, { "content-type": "text/plain; charset=utf-8" }).end(text);
    });
  });
  await listen(server, port);
  const address = /** @type {import("node:net").AddressInfo} */ (server.address());
  return {
    url: `http://localhost:${address.port}/`,
    close: () => close(server),
    reload: () => open.forEach((page) => page.write("data:\n\n")),
  };
}

/** Loads a page again when the server says so, and once the server is back. */
const RELOAD =
  "let isFirst = true; const events = new EventSource('/reload'); events.onmessage = () => location.reload(); events.onopen = () => { if (!isFirst) location.reload(); isFirst = false; };";

/**
 * Answers what pages need to load themselves again: their HTML with one more script, that script, and the events.
 * Nothing is kept for use without a network.
 * @param {string} root
 * @param {import("node:http").IncomingMessage} request
 * @param {import("node:http").ServerResponse} response
 * @param {Set<import("node:http").ServerResponse>} open
 */
function answersReload(root, { url = "" }, response, open) {
  const path = new URL(url, "http://localhost").pathname.replace(/\/$/, "/index.html");
  const send = (/** @type {string} */ type, /** @type {string} */ text) =>
    void response.writeHead(200, { "content-type": type, "cache-control": "no-store" }).end(text);
  if (path === "/reload") {
    response.writeHead(200, { "content-type": "text/event-stream", "cache-control": "no-store" }).write(":\n\n");
    open.add(response);
    response.on("close", () => open.delete(response));
  } else if (path === "/reload.js") send("text/javascript", RELOAD);
  else if (path === "/offline.js") response.writeHead(404).end();
  else if (/^\/[\w-]+\.html$/.test(path) && existsSync(join(root, path)))
    send(
      "text/html; charset=utf-8",
      readFileSync(join(root, path), "utf8").replace(
        "</head>",
        '<script type="module" src="/reload.js"></script></head>',
      ),
    );
  else return false;
  return true;
}

/** The port that PORT names. @param {number} usual  without it */
export function wantedPort(usual) {
  const text = process.env.PORT ?? String(usual);
  const port = Number(text);
  if (!/^\d+$/.test(text) || port > 65535)
    throw new Problem(`PORT must be an integer from 0 to 65535, not \`${text}\`.`);
  return port;
}

/** The policy that the pages state in their HTML. As a header it holds in their workers too. */
export function pagePolicy() {
  const [, policy] =
    /Content-Security-Policy" content="([^"]*)"/.exec(
      readFileSync(join(project, "www", "app", "shell.html"), "utf8"),
    ) ?? [];
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
  await once(server.listen(port, HOST), "listening").catch((error) => {
    throw explain(error, port);
  });
}

/** @param {import("node:http").Server} server */
async function close(server) {
  const closed = once(server.close(), "close");
  server.closeAllConnections();
  await closed;
}

/** @param {NodeJS.ErrnoException} error @param {number} port */
function explain(error, port) {
  if (error.code === "EADDRINUSE")
    return new Problem(`Port ${port} is in use. Choose another one: PORT=${(port % 65535) + 1} npm start`);
  if (error.code === "EACCES")
    return new Problem(`Port ${port} is not allowed. Choose a port above 1023: PORT=8080 npm start`);
  return error;
}
