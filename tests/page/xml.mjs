/** A strict reader of small XML documents for tests: what it reads is well-formed. */
import assert from "node:assert/strict";

/** @typedef {{ name: string, attributes: Record<string, string>, children: (Element | string)[] }} Element */

/** @param {string} text */
function plain(text) {
  assert.doesNotMatch(text, /[<>]|&(?!#\d+;|#x[0-9a-f]+;|amp;|lt;|gt;|quot;|apos;)/, "markup within text");
  // eslint-disable-next-line no-control-regex
  assert.doesNotMatch(
    text,
    // oxlint-disable-next-line no-control-regex -- XML forbids these characters
    /[\0-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]|[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/,
    "a character that XML cannot hold",
  );
  return text.replace(/&#(\d+);/g, (_, code) => String.fromCodePoint(Number(code)));
}

/** @param {string} text @returns {Element}  the root */
export function readXml(text) {
  /** @type {Element} */
  const top = { name: "", attributes: {}, children: [] };
  const open = [top];
  const token = /<(\/?)([A-Za-z][\w:-]*)((?:\s+[A-Za-z][\w:-]*="[^"<]*")*)\s*(\/?)>|([^<]+)/y;
  const ids = new Set();
  while (token.lastIndex < text.length) {
    const from = token.lastIndex;
    const match = token.exec(text);
    assert.ok(match, `no markup: ${text.slice(from, from + 60)}`);
    const [, closes, name, list, empty, words] = match;
    const within = open[open.length - 1];
    if (words !== undefined) {
      within.children.push(plain(words));
    } else if (closes) {
      assert.equal(within.name, name, "closed in order");
      assert.equal(list + empty, "");
      open.pop();
    } else {
      /** @type {Element} */
      const element = { name, attributes: {}, children: [] };
      for (const [, key, value] of list.matchAll(/\s+([\w:-]+)="([^"]*)"/g)) {
        assert.ok(!(key in element.attributes), `${key} twice`);
        element.attributes[key] = plain(value);
      }
      if (element.attributes.id) {
        assert.ok(!ids.has(element.attributes.id), "an id twice");
        ids.add(element.attributes.id);
      }
      within.children.push(element);
      if (!empty) open.push(element);
    }
  }
  assert.equal(open.length, 1, "all closed");
  const roots = top.children.filter((child) => typeof child !== "string" || child.trim() !== "");
  assert.equal(roots.length, 1, "one root");
  const [root] = roots;
  assert.ok(typeof root !== "string");
  for (const [, id] of text.matchAll(/url\(#([\w-]+)\)/g)) assert.ok(ids.has(id), `nothing is called ${id}`);
  return root;
}

/**
 * All elements of a name, at any depth, each with the attributes that it has from those around it.
 * @param {Element} root
 * @param {string} name
 * @returns {Element[]}
 */
export function allOf(root, name) {
  /** @type {Element[]} */
  const found = [];
  /** @param {Element} element @param {Record<string, string>} inherited */
  const walk = (element, inherited) => {
    const attributes = { ...inherited, ...element.attributes };
    if (element.name === name) found.push({ ...element, attributes });
    if (element.name === "clipPath" || element.name === "pattern") return;
    for (const child of element.children)
      if (typeof child !== "string") walk(child, element === root ? {} : attributes);
  };
  walk(root, {});
  return found;
}
