/**
 * A 2d context that writes SVG in place of pixels: paths of lines, arcs and rectangles, dashes, clips, words, images,
 * and stripes in place of a pattern. Transforms turn and shift. As on a canvas, coordinates that are not finite are
 * ignored.
 *
 * @typedef {{ colour: string }} Stripes  diagonal lines to fill with
 */

const TURN = 2 * Math.PI;
/** From a line of the text to its baseline, in sizes of the font, in most fonts. @type {Record<string, number>} */
const DROP = { top: 0.78, middle: 0.28, bottom: -0.22 };
/** @type {Record<string, string>} */
const ANCHOR = { left: "start", center: "middle", right: "end" };

/** @param {number} value */
const round = (value) => Math.round(value * 100) / 100 || 0;

/** Text without what XML cannot hold. @param {string} text */
export const plainText = (text) => text.replace(/[^\t\n\r -\ufffd]/g, "").replace(/\p{Surrogate}/gu, "\ufffd");

/** Text for XML. @param {string} text */
const escaped = (text) => plainText(text).replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/**
 * The reference of an entry, which is added if it is new.
 * @param {string} name
 * @param {string[]} list
 * @param {string} entry
 */
function reference(name, list, entry) {
  if (!list.includes(entry)) list.push(entry);
  return `url(#${name}${list.indexOf(entry)})`;
}

export class SvgContext {
  // `save` stores the public fields.
  /** @type {string | Stripes} */
  fillStyle = "#000";
  strokeStyle = "#000";
  lineWidth = 1;
  lineCap = "butt";
  lineJoin = "miter";
  globalAlpha = 1;
  font = "10px sans-serif";
  textAlign = "start";
  textBaseline = "alphabetic";
  /** @type {readonly number[]} */
  dash = [];
  /** Cosine and sine of the turn, and the shift. */
  turn = [1, 0, 0, 0];
  /** The attribute of the current clip. */
  clipping = "";

  #width;
  #height;
  /** In pixels of the figure. */
  #path = "";
  /** Each is its path or its text. @type {{ clipping: string, style: string, path: string, text: string }[]} */
  #elements = [];
  /** @type {string[]} */
  #clips = [];
  /** @type {string[]} */
  #stripes = [];
  /** @type {object[]} */
  #saved = [];

  /** @param {number} width  pixels @param {number} height */
  constructor(width, height) {
    this.#width = width;
    this.#height = height;
  }

  save() {
    this.#saved.push({ ...this });
  }

  restore() {
    Object.assign(this, this.#saved.pop());
  }

  /** @param {number} x @param {number} y */
  translate(x, y) {
    const [a, b] = this.turn;
    this.turn = [a, b, ...this.#placed(x, y)];
  }

  /** @param {number} angle  radians */
  rotate(angle) {
    const [a, b, e, f] = this.turn;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    this.turn = [a * c - b * s, a * s + b * c, e, f];
  }

  /** @param {readonly number[]} dash */
  setLineDash(dash) {
    this.dash = [...dash];
  }

  beginPath() {
    this.#path = "";
  }

  closePath() {
    if (this.#path) this.#path += "Z";
  }

  /** @param {number} x @param {number} y */
  moveTo(x, y) {
    this.#go("M", x, y);
  }

  /** @param {number} x @param {number} y */
  lineTo(x, y) {
    this.#go(this.#path ? "L" : "M", x, y);
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  rect(x, y, width, height) {
    if (!Number.isFinite(x + y + width + height)) return;
    this.moveTo(x, y);
    for (const [px, py] of [
      [x + width, y],
      [x + width, y + height],
      [x, y + height],
    ])
      this.lineTo(px, py);
    this.closePath();
  }

  /**
   * @param {number} x
   * @param {number} y
   * @param {number} radius
   * @param {number} from  radians
   * @param {number} to
   * @param {boolean} [back]  the other way round
   */
  arc(x, y, radius, from, to, back = false) {
    const sign = back ? -1 : 1;
    let sweep = sign * (to - from);
    if (sweep < 0) sweep = (sweep % TURN) + TURN;
    sweep = sign * Math.min(sweep, TURN);
    const size = round(radius);
    this.lineTo(x + radius * Math.cos(from), y + radius * Math.sin(from));
    // In three pieces: the rounded ends of half a turn leave its shape uncertain, those of a whole turn coincide.
    for (const third of [1, 2, 3]) {
      const angle = from + (sweep * third) / 3;
      this.#go(`A${size} ${size} 0 0 ${back ? 0 : 1} `, x + radius * Math.cos(angle), y + radius * Math.sin(angle));
    }
  }

  clip() {
    const id = reference("clip", this.#clips, `${this.clipping}><path d="${this.#path}"/>`);
    this.clipping = ` clip-path="${id}"`;
  }

  stroke() {
    this.#put(this.#strokeStyle(), "", this.#path);
  }

  // Paths to fill stay apart: where one winds against another, one path of both would have a hole.
  fill() {
    this.#put(this.#fillStyle(), `<path d="${this.#path}"/>`);
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  strokeRect(x, y, width, height) {
    this.#aside("stroke", x, y, width, height);
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  fillRect(x, y, width, height) {
    this.#aside("fill", x, y, width, height);
  }

  /** Removes everything: only whole figures are cleared. */
  clearRect() {
    this.#elements = [];
  }

  /** @param {string} text @param {number} x @param {number} y */
  fillText(text, x, y) {
    this.#word(text, x, y, this.#fillStyle());
  }

  /** @param {string} text @param {number} x @param {number} y */
  strokeText(text, x, y) {
    this.#word(text, x, y, this.#strokeStyle());
  }

  /**
   * @param {{ toDataURL(): string }} image  such as a canvas
   * @param {number} x
   * @param {number} y
   * @param {number} width
   * @param {number} height
   */
  drawImage(image, x, y, width, height) {
    this.#put(
      ` opacity="${this.globalAlpha}"`,
      `<image${this.#place(x, y)} width="${width}" height="${height}" preserveAspectRatio="none" href="${escaped(image.toDataURL())}"/>`,
    );
  }

  /** @param {number} x @param {number} y */
  #placed(x, y) {
    const [a, b, e, f] = this.turn;
    return [a * x - b * y + e, b * x + a * y + f];
  }

  /** @param {string} command @param {number} x @param {number} y */
  #go(command, x, y) {
    if (Number.isFinite(x + y)) this.#path += command + this.#placed(x, y).map(round).join(" ");
  }

  /** The place of an element without a path, as attributes. @param {number} x @param {number} y */
  #place(x, y) {
    const [a, b] = this.turn;
    const [px, py] = this.#placed(x, y).map(round);
    return a === 1 && b === 0 ? ` x="${px}" y="${py}"` : ` transform="matrix(${a} ${b} ${-b} ${a} ${px} ${py})"`;
  }

  /**
   * Draws a rectangle and leaves the path as it was.
   * @param {"stroke" | "fill"} draw
   * @param {number} x
   * @param {number} y
   * @param {number} width
   * @param {number} height
   */
  #aside(draw, x, y, width, height) {
    const path = this.#path;
    this.#path = "";
    this.rect(x, y, width, height);
    this[draw]();
    this.#path = path;
  }

  /** @param {string} text @param {number} x @param {number} y @param {string} style */
  #word(text, x, y, style) {
    this.#put(
      `${style} style="font:${escaped(this.font)}" text-anchor="${ANCHOR[this.textAlign] ?? this.textAlign}"`,
      `<text${this.#place(x, y)} dy="${DROP[this.textBaseline] ?? 0}em">${escaped(text)}</text>`,
    );
  }

  /** A colour, with its alpha as opacity. @param {string} name  fill or stroke @param {string} colour */
  #paint(name, colour) {
    const [, rgb, alpha = 1] = /^rgba\((.+),(.+)\)$/.exec(colour) ?? [];
    return ` ${name}="${rgb ? `rgb(${rgb})` : escaped(colour)}" ${name}-opacity="${Math.round(1e4 * this.globalAlpha * Number(alpha)) / 1e4}"`;
  }

  #fillStyle() {
    const style = this.fillStyle;
    if (typeof style === "string") return this.#paint("fill", style);
    return this.#paint(
      "fill",
      reference(
        "stripes",
        this.#stripes,
        ` width="5" height="5" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path d="M2.5 0V5" stroke="${escaped(style.colour)}" stroke-width="1.5"/>`,
      ),
    );
  }

  #strokeStyle() {
    return ` fill="none"${this.#paint("stroke", this.strokeStyle)} stroke-width="${round(this.lineWidth)}" stroke-linecap="${this.lineCap}" stroke-linejoin="${this.lineJoin}" stroke-dasharray="${this.dash.map(round).join(" ")}"`;
  }

  /**
   * Adds an element; a path continues the path before it if both have the same opaque style.
   * @param {string} style
   * @param {string} text
   * @param {string} [path]
   */
  #put(style, text, path = "") {
    // Defaults are left out.
    style = style.replace(/ [a-z-]+="(1|butt|miter|start)?"/g, "");
    const { clipping } = this;
    const last = this.#elements.at(-1);
    // Alpha may also be a part of the colour: after a slash, in eight digits, or by name.
    if (
      path &&
      last?.path &&
      last.style === style &&
      last.clipping === clipping &&
      !/opacity|\/|hsla|transparent|#(\w{4}|\w{8})"/.test(style)
    )
      last.path += path;
    else this.#elements.push({ clipping, style, path, text });
  }

  /** @param {{ background?: string, title?: string }} [options] @returns {string}  a file */
  toString({ background = "", title = "" } = {}) {
    const size = `width="${this.#width}" height="${this.#height}"`;
    const lines = [
      `<svg xmlns="http://www.w3.org/2000/svg" ${size} viewBox="0 0 ${this.#width} ${this.#height}" stroke-miterlimit="10">`,
      title && `<title>${escaped(title)}</title>`,
      ...this.#clips.map((clip, i) => `<clipPath id="clip${i}"${clip}</clipPath>`),
      ...this.#stripes.map((line, i) => `<pattern id="stripes${i}"${line}</pattern>`),
      background && `<rect ${size} fill="${escaped(background)}"/>`,
    ];
    let group = "";
    for (const { clipping, style, path, text } of this.#elements) {
      const wanted = clipping + style;
      if (wanted !== group) lines.push(group && "</g>", wanted && `<g${wanted}>`);
      group = wanted;
      lines.push(path ? `<path d="${path}"/>` : text);
    }
    return [...lines, group && "</g>", "</svg>", ""].filter(Boolean).join("\n");
  }
}
