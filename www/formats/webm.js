/**
 * WebM: the browser's video encoder (WebCodecs) compresses frames, and mediabunny writes them into the container.
 * Loaded with the first film, as the container's code is large.
 */
import { BufferTarget, EncodedPacket, EncodedVideoPacketSource, Output, WebMOutputFormat } from "mediabunny";

/** Pixels of a picture at most, at level 3.1 of VP9; larger ones need level 5. */
const LEVEL_3 = 983_040;
/** Bits a second for each pixel: drawings of lines need less, and get what they need. */
const BITS = 6;
/** Frames between two that can be decoded by themselves. */
const KEY_EVERY = 90;
/** Frames that wait for the encoder, at most. */
const MOST_WAITING = 4;

/**
 * @param {number} width   pixels, even
 * @param {number} height
 * @throws {Error} `no-encoder`: the browser has none for WebM
 */
export async function webmWriter(width, height) {
  const { config, name } = await chooseCodec(width, height);
  const target = new BufferTarget();
  const output = new Output({ format: new WebMOutputFormat(), target });
  const source = new EncodedVideoPacketSource(name);
  output.addVideoTrack(source);
  await output.start();
  /** Packets reach the container one after the other. @type {Promise<unknown>} */
  let written = Promise.resolve();
  /** @type {unknown} */
  let failure;
  const fail = (/** @type {unknown} */ error) => {
    failure ??= error;
  };
  const encoder = new VideoEncoder({
    output: (chunk, meta) => {
      written = written.then(() => source.add(EncodedPacket.fromEncodedChunk(chunk), meta)).catch(fail);
    },
    error: fail,
  });
  encoder.configure(config);
  let count = 0;
  let timestamp = 0;
  return {
    /** Adds the canvas as it is now. @param {OffscreenCanvasRenderingContext2D} context @param {number} seconds */
    async add({ canvas }, seconds) {
      while (encoder.encodeQueueSize > MOST_WAITING)
        await new Promise((resolve) => encoder.addEventListener("dequeue", resolve, { once: true }));
      if (failure) throw failure;
      const duration = Math.round(1e6 * seconds);
      const frame = new VideoFrame(canvas, { timestamp, duration });
      try {
        encoder.encode(frame, { keyFrame: count++ % KEY_EVERY === 0 });
      } finally {
        frame.close();
      }
      timestamp += duration;
    },
    async finish() {
      await encoder.flush();
      await written;
      if (failure) throw failure;
      await output.finalize();
      return new Blob([/** @type {ArrayBuffer} */ (target.buffer)], { type: "video/webm" });
    },
    close() {
      // The encoder loses the frames that wait for it if it is closed before them; they are few.
      if (encoder.state === "configured")
        void encoder
          .flush()
          .catch(fail)
          .then(() => encoder.state !== "closed" && encoder.close());
      if (output.state === "started") void output.cancel();
    },
  };
}

/** VP9 if the browser encodes it, else VP8. @param {number} width @param {number} height */
async function chooseCodec(width, height) {
  const level = width * height <= LEVEL_3 ? "31" : "50";
  for (const [codec, name] of /** @type {const} */ ([
    [`vp09.00.${level}.08`, "vp9"],
    ["vp8", "vp8"],
  ])) {
    const config = { codec, width, height, bitrate: BITS * width * height };
    if ((await VideoEncoder.isConfigSupported(config)).supported) return { config, name };
  }
  throw Object.assign(new Error("This browser can encode neither VP9 nor VP8."), { code: "no-encoder" });
}
