/** A static server for one folder, for development and for tests. */
import { createServer } from "node:http";
import { Problem } from "./run.mjs";

/** Only requests from this machine are served. */
const HOST = "127.0.0.1";

/**
 * Serves a folder; files are read again for each request.
 * @param {{ root: string, port: number }} options  0 chooses a free port
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 * @throws {Problem} if the port is in use or not allowed
 */
export async function serve({ root, port }) {
  // Imported here, so that the port can be checked before the development tools are installed.
  const { default: sirv } = await import("sirv");
  const files = sirv(root, { dev: true });
  const server = createServer((request, response) => {
    files(request, response, () => {
      response.writeHead(404, { "content-type": "text/plain; charset=utf-8" }).end("Not found\n");
    });
  });
  await listen(server, port);
  const address = /** @type {import("node:net").AddressInfo} */ (server.address());
  return { url: `http://localhost:${address.port}/`, close: () => close(server) };
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

/**
 * @param {import("node:http").Server} server
 * @param {number} port
 * @returns {Promise<void>}
 */
function listen(server, port) {
  return new Promise((resolve, reject) => {
    server.once("error", (error) => reject(explain(error, port)));
    server.listen(port, HOST, resolve);
  });
}

/** @param {import("node:http").Server} server @returns {Promise<void>} */
function close(server) {
  return new Promise((resolve) => {
    server.close(() => resolve());
    server.closeAllConnections();
  });
}

/**
 * @param {NodeJS.ErrnoException} error
 * @param {number} port
 */
function explain(error, port) {
  if (error.code === "EADDRINUSE") return new Problem(`Port ${port} is in use. Choose another one: PORT=${(port % 65535) + 1} npm start`);
  if (error.code === "EACCES") return new Problem(`Port ${port} is not allowed. Choose a port above 1023: PORT=8080 npm start`);
  return error;
}
