/** The content of files that were picked or dropped, and what kind of file each is. */

/** @typedef {{ name: string, bytes: Uint8Array<ArrayBuffer> }} Content   of a file */

/** Size of a file at most, MB: of documents and arrays, and of worlds. */
const MOST = { small: 10, world: 64 };
/** Bytes that tell what a text is. */
const HEAD = 4096;

/** @param {File[]} files @returns {Promise<Content[]>} @throws {Error} one is too large, or cannot be read */
export function readFiles(files) {
  return Promise.all(
    files.map(async (file) => {
      const most = /\.(json|npy)$/i.test(file.name) ? MOST.small : MOST.world;
      if (file.size > most * 2 ** 20) {
        throw Object.assign(new Error(`The file is ${(file.size / 2 ** 20).toFixed(1)} MB; the limit is ${most} MB.`), {
          code: "too-large",
        });
      }
      return { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
    }),
  );
}

/** The names of files in a title. @param {{ name: string }[]} files */
export const namesOf = (files) => files.map(({ name }) => name).join(", ");

/** Whether a file is a NumPy array, by its name or its first byte. @param {string} name @param {Uint8Array} bytes */
export function isArray(name, bytes) {
  return /\.npy$/i.test(name) || bytes[0] === 0x93;
}

/**
 * Whether a file is a document in JSON, such as a scenario, an array, or part of a world: a map, a picture, a drawing.
 * @param {Content} file
 * @returns {"document" | "array" | "world"}
 */
export function kindOf({ name, bytes }) {
  if (isArray(name, bytes)) return "array";
  const head = new TextDecoder().decode(bytes.subarray(0, HEAD));
  const isGeo = /\.geojson$/i.test(name) || /"type"\s*:\s*"(Feature(Collection)?|GeometryCollection)"/.test(head);
  const isJson = /\.json$/i.test(name) || (/^\s*[{[]/.test(head) && !/\.ya?ml$/i.test(name));
  return isJson && !isGeo ? "document" : "world";
}
