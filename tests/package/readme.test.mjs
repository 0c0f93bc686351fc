/**
 * The examples and links of the README and of docs/: scripts run in the installed tarball, commands in a shell,
 * documents are parsed.
 */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { Fleet, Navigation, Scenario } from "planarium/full";
import { root } from "../../scripts/run.mjs";
import { targetFolder } from "../../scripts/setup.mjs";
import { anchorOf } from "../../scripts/site.mjs";
import { recordingContext } from "./canvas.mjs";
import { addFiles, emptyFolder, install } from "./packed.mjs";

const names = [
  "README.md",
  "CHANGELOG.md",
  ...readdirSync(join(root, "docs"), { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(".md") && !/^(\.vitepress|api)\//.test(name))
    .map((name) => `docs/${name}`),
];
const texts = new Map(names.map((name) => [name, readFileSync(join(root, name), "utf8")]));

/** A text of the repository. @param {string} name */
const textOf = (name) => texts.get(name) ?? assert.fail(`there is no ${name}`);

/** The code blocks of a text in one language. @param {string} name @param {string} language */
function blocks(name, language) {
  return Array.from(textOf(name).matchAll(new RegExp(`^\`\`\`${language}\n([^]*?)^\`\`\`$`, "gm")), ([, code]) => code);
}

/** The expected output of each JavaScript example. @type {Record<string, RegExp[]>} */
const PRINTED = {
  "README.md": [/^solved \d+ vertices, \d+ edges \d\.\d+\n$/, /^solved [1-9]\d* edges\n$/],
  "docs/start.md": [/^solved [1-9]\d* waypoints\n$/],
  "docs/fleet.md": [
    /^[1-9]\d* conflicts if all drive straight at once\n(?:\d+ iterations\n)*solved \d[\d.]* Float64Array\(18\) \[[^\]]*\]\ntrue\n$/,
  ],
  "docs/timing.md": [/^\d+\.\d{3} s, 0 rests on the way\n[1-9]\d* 3 3 3 true\ntrue true\n$/],
  "docs/worlds.md": [/^false \{ obstacle: 0 \} 1 0\.(?:39|4)\d*\n$/, /^t_s,x_m,y_m,vx_m_s,vy_m_s true\n$/],
  "docs/prm-rl.md": [/^solved \[[^]*forward: \d+[^]*\]\n(?:reached|collision|timeout) [\d.]+ [\d.]+\n2 [1-9]\d*\n$/],
  "docs/shortest.md": [/^1808\.0 m, 42 positions\n1808\.0\n890\.2\n$/],
  "docs/javascript.md": [
    /^\{[^]*free: true[^]*\}\nsolved\nsolved true\n$/,
    /^moving-ai 5 x 3 solved\n$/,
    /^solved \d+\nsolved true\n(?:running|solved) true\n$/,
    /^solved solved solved\n$/,
    /^solved \d+\n$/,
    /^(?:solved [1-9]\d* motions\n){2}0\.\d+\n$/,
    /^\d+\.\d\d % longer true \d+\n$/,
    /^2\.\d+ \d+\n$/,
    /^0\.\d{3} (?:gap|start|goal) 2\ntrue 0\.\d+ [1-9]\d*\n[1-9]\d* [1-9]\d* true 0\.\d+\n$/,
    /^solved proven true\nsolved solved\n$/,
    /^solved true\n$/,
    /^infeasible [1-9]\d* 0 [\d.e-]+\n$/,
    /^the forest found \d+ of 10; the tree visited \d+ of 20000, up to \d\.\d\d\n$/,
    /^reached true [1-4]\ntrue \[ [\d.]+, [-\d.e]+ \]\n$/,
    /^solved 500 \d+\nFloat64Array\(2\) \[ 0\.0996917333733128, 0\.007845909572784495 \]\n$/,
    /^(k = \d+: \d+ of 20 solved, 0\.\d\d to [01]\.\d\d\n){2}The length of prm \(k=16\) is smaller than that of prm \(k=2\) in .*\n$/,
  ],
};

/** What the examples for a browser need of one. */
const BROWSER = `${recordingContext}
globalThis.document = { body: {}, querySelector: () => ({ width: 500, height: 500, getContext: () => recordingContext().context }) };
globalThis.requestAnimationFrame = (frame) => setImmediate(frame);
`;

test("every JavaScript example runs in the installed package", () => {
  const folder = install({ "browser.mjs": BROWSER });
  for (const name of names) {
    const examples = blocks(name, "js");
    const expected = PRINTED[name] ?? [];
    assert.equal(examples.length, expected.length, `examples in ${name}`);
    examples.forEach((code, i) => {
      addFiles(folder, { "example.mjs": code });
      assert.match(
        execFileSync(process.execPath, ["--import", "./browser.mjs", "example.mjs"], { cwd: folder, encoding: "utf8" }),
        expected[i],
        `${name}, example ${i + 1}`,
      );
    });
  }
});

test("every shell example runs, and its paths are valid", () => {
  // To install is to build and to copy: the program that the native tests use is copied instead.
  const installation = /^cargo install --path \S+ --quiet\n/;
  execFileSync(
    "cargo",
    [
      "test",
      "--no-run",
      "--locked",
      "--quiet",
      "-p",
      "planarium",
      "-p",
      "planarium-cli",
      "--all-features",
      "--test",
      "all",
    ],
    { cwd: root, stdio: "inherit" },
  );
  const programs = emptyFolder();
  copyFileSync(join(targetFolder(), "debug", "planarium"), join(programs, "planarium"));
  const env = { ...process.env, PATH: `${programs}:${process.env.PATH}` };
  for (const name of ["README.md", "docs/start.md", "docs/command-line.md"]) {
    const examples = blocks(name, "sh");
    assert.match(examples[0], installation, name);
    const folder = emptyFolder();
    for (const example of examples) {
      const commands = example.replace(installation, "");
      const printed = execFileSync("sh", ["-ec", commands], {
        cwd: folder,
        env,
        encoding: "utf8",
        stdio: ["ignore", "pipe", "pipe"],
      });
      if (commands.includes("verify")) assert.match(printed, /"valid":true/, commands);
      for (const [, file] of commands.matchAll(/--out (\S+)/g)) {
        const text = readFileSync(join(folder, file), "utf8");
        if (file.endsWith(".geojson")) {
          assert.ok(JSON.parse(text).features.length > 0, file);
          continue;
        }
        if (!file.endsWith(".json")) {
          assert.match(text, /^# A path of Planarium: nav_msgs\/Path\n/, file);
          continue;
        }
        const { format, duration, status } = JSON.parse(text);
        if (format === "planarium-trajectory-1") assert.ok(duration > 0, file);
        else assert.equal(status, "solved", file);
      }
    }
  }
});

test("every JSON example is a scenario, a fleet, a navigation task, or an experiment, which a native test runs", () => {
  const examples = names
    .flatMap((name) => blocks(name, "json"))
    .filter((example) => JSON.parse(example).format !== "planarium-experiment-1");
  assert.ok(examples.length > 0);
  for (const example of examples) {
    const { format, queries, robots } = JSON.parse(example);
    if (format === "planarium-fleet-1") assert.equal(Fleet.parse(example).robotCount, robots.length);
    else if (format === "planarium-navigation-1")
      assert.equal(Navigation.parse(example).toJSON().queries.length, queries.length);
    else assert.ok(Scenario.parse(example).check(queries[0].start).free);
  }
});

test("no example is left out: code is JavaScript, Rust, JSON, shell, or one of the kinds that are not run", () => {
  // Those of docs/toolchains.md are built and run by `npm run compat`.
  const known = ["js", "rust", "json", "sh", "html", "python", "diff", "mermaid", "javascript", "jsonc", "text"];
  for (const [name, text] of texts) {
    const opened = text
      .split("\n")
      .filter((line) => line.startsWith("```"))
      .filter((_, i) => i % 2 === 0);
    for (const line of opened) assert.ok(known.includes(line.slice(3)), `${name}: ${line}`);
    const isDoctested = readFileSync(join(root, "src", "lib.rs"), "utf8").includes(`include_str!("../${name}")`);
    if (opened.includes("```rust")) assert.ok(isDoctested, `src/lib.rs includes ${name}`);
  }
});

/**
 * A fragment of a link of a page is a step of a lesson or a run of the planner's page, or an experiment.
 * @param {string} page @param {string} fragment @param {string} message
 */
async function assertOpens(page, fragment, message) {
  const [, lesson, step] = /^lesson=([\w-]+)\.(\d+)$/.exec(fragment) ?? [];
  if (page === "plan" && lesson) {
    const { LESSONS } = await import("../../www/planner/lessons/script.js");
    assert.ok(LESSONS.find(({ id }) => id === lesson)?.steps[Number(step) - 1], message);
    return;
  }
  const { decodeLink } = await import("../../www/planner/link/codec.js");
  const { decodeExperiment } = await import("../../www/experiments/link.js");
  const read = { plan: decodeLink, experiments: decodeExperiment }[page] ?? assert.fail(message);
  assert.equal((await read(fragment)).fault || "", "", message);
}

test("every link leads to a file, and to a heading in it; links of pages open", async () => {
  let count = 0;
  for (const [name, text] of texts) {
    for (const [, link] of text.matchAll(/\]\((?!https?:)([^)\s]+)\)/g)) {
      const [, path, anchor] = /^([^?#]*)(?:\?[^#]*)?(?:#(.*))?$/.exec(link) ?? assert.fail(link);
      const file = join(dirname(name), path === "" ? name.replace(/.*\//, "") : path);
      assert.ok(existsSync(join(root, file)), `${name} links to ${link}`);
      const headings = (texts.get(file) ?? "")
        .split("\n")
        .filter((line) => /^#+ /.test(line))
        .map((line) => anchorOf(line.replace(/^#+ /, "")));
      const page = /^www\/(.+)\.html$/.exec(file)?.[1];
      if (page && anchor !== undefined) await assertOpens(page, anchor, `${name} links to ${link}`);
      else if (anchor !== undefined) assert.ok(headings.includes(anchor), `${name} links to ${link}`);
      count++;
    }
  }
  assert.ok(count > 20, `${count} links`);
});

test("the plan of a class has nine steps of five minutes, each with a question, a page and an answer", async () => {
  const { classPlan, slides } = await import("../../scripts/front.mjs");
  const plan = classPlan();
  assert.deepEqual(
    plan.map(({ minute }) => minute),
    Array.from({ length: 9 }, (_, i) => 5 * i),
  );
  for (const { page, question, answer } of plan) {
    assert.match(page, /^(plan|experiments)\.html#1[\w-]+$/);
    assert.ok(/[?.]$/.test(question) && answer.endsWith("."), question);
  }
  assert.equal((await slides()).match(/<section class="slide"/g)?.length, plan.length);
});

test("the README is short, and its picture light", () => {
  const readme = textOf("README.md");
  assert.ok(readme.split("\n").length <= 181, "at most 180 lines");
  const pictures = Array.from(readme.matchAll(/!\[[^\]]+\]\(([^)]+)\)/g), ([, path]) => path);
  assert.equal(pictures.length, 1);
  assert.equal(readFileSync(join(root, pictures[0])).subarray(0, 6).toString("latin1"), "GIF89a");
  assert.ok(statSync(join(root, pictures[0])).size < 400_000);
});

test("the pictures of proofs show the numbers of the core", async () => {
  const { drawings } = await import("../../scripts/pictures.mjs");
  for (const [name, drawn] of Object.entries(drawings()))
    assert.equal(
      readFileSync(join(root, "docs", "images", name), "utf8"),
      drawn,
      `node scripts/pictures.mjs draws ${name}`,
    );
});

test("every command of npm that is mentioned is a script of the project", () => {
  const { scripts } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const mentioned = names
    .flatMap((name) => Array.from(textOf(name).matchAll(/`npm (?:run )?([\w:]+)`/g), ([, script]) => script))
    .filter((script) => !["install", "pack"].includes(script));
  assert.ok(mentioned.includes("start") && mentioned.includes("test"));
  for (const script of mentioned) assert.ok(script in scripts, script);
});
