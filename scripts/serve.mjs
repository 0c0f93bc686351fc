/** A static server for one folder: the page while it is worked on, and while it is tested. */
import { createServer } from "node:http";
import { Problem } from "./run.mjs";

/** Only this machine is served. */
const HOST = "127.0.0.1";

/**
 * Serves a folder; files are read afresh on each request.
 * @param {{ root: string, port: number }} options  port 0 takes any that is free
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 * @throws {Problem} at once when the port is taken or not allowed
 */
export async function serve({ root, port }) {
  // Imported here, so that the port can be looked at before the development tools are installed.
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
 * Fails at once where `serve` would.
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
  if (error.code === "EADDRINUSE") return new Problem(`Port ${port} is taken. Choose another one: PORT=${(port % 65535) + 1} npm start`);
  if (error.code === "EACCES") return new Problem(`Port ${port} is not allowed. Choose one above 1023: PORT=8080 npm start`);
  return error;
}
