/** Pictures that only a browser decodes, as PGM: JPEG and WebP. */

/** @import { Content } from "../app/read-files.js" */

/** Pixels at most: what is announced is compared before memory is taken. */
const MOST = 67_108_864;

/** Whether the bytes begin a JPEG or a WebP. @param {Uint8Array} bytes */
function isPhoto(bytes) {
  const text = String.fromCharCode(...bytes.subarray(0, 12));
  return text.startsWith("\u00ff\u00d8\u00ff") || /^RIFF[^]{4}WEBP$/.test(text);
}

/**
 * The size that a JPEG announces, in its first frame header (ITU T.81, B.2.2); null if there is none.
 * @param {Uint8Array} bytes
 */
export function jpegSize(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  for (let at = 2; at + 9 <= bytes.length && bytes[at] === 0xff; at += 2 + view.getUint16(at + 2)) {
    const marker = bytes[at + 1];
    // Frame headers, without tables and extensions that lie between them.
    if (marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker))
      return { height: view.getUint16(at + 5), width: view.getUint16(at + 7) };
  }
  return null;
}

/**
 * A file as `readWorld` reads it; the name stays, since other files refer to it.
 * @param {Content} file
 * @returns {Promise<Content>}
 * @throws {Error} with `code` and `file`: it is damaged or too large
 */
export async function decoded({ name, bytes }) {
  if (!isPhoto(bytes)) return { name, bytes };
  const refuse = (/** @type {string} */ code, /** @type {string} */ message) =>
    Object.assign(new Error(message), { code, file: name });
  const check = (/** @type {{ width: number, height: number }} */ { width, height }) => {
    if (width * height > MOST)
      throw refuse("world-too-large", `the picture has ${width} x ${height} pixels, more than ${MOST}`);
  };
  const size = bytes[0] === 0xff ? jpegSize(bytes) : null;
  if (size) check(size);
  /** @type {ImageBitmap} */
  let image;
  try {
    image = await createImageBitmap(new Blob([bytes]), { colorSpaceConversion: "none" });
  } catch {
    throw refuse("invalid-file", "the picture is damaged: this browser cannot decode it");
  }
  const { width, height } = image;
  check(image);
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) throw refuse("unsupported-feature", "this browser gives no canvas for the picture");
  context.drawImage(image, 0, 0);
  image.close();
  const { data } = context.getImageData(0, 0, width, height);
  const header = new TextEncoder().encode(`P5\n${width} ${height}\n255\n`);
  const grey = new Uint8Array(header.length + width * height);
  grey.set(header);
  // The mean of the channels, as of every other picture.
  for (let i = 0, at = header.length; i < data.length; i += 4, at++)
    grey[at] = Math.round((data[i] + data[i + 1] + data[i + 2]) / 3);
  return { name, bytes: grey };
}
