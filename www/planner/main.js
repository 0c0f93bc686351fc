/**
 * The planner's page: it makes the session, the controls and the features that are loaded on demand, and connects them.
 *
 * For tests, beside the attributes listed in app.js:
 * - `#counters` carries `data-status` ("loading", "failed", "none", "running", "solved", "exhausted"), `data-phase`,
 *   `data-iterations`, `data-vertices`, `data-edges` of the iteration shown, `data-settled` ("true" while nothing moves
 *   and everything is drawn), and once the newest iteration is shown and its result is known `data-fingerprint` and,
 *   once solved, `data-length`.
 * - `#play` carries `data-playing`; `body` carries `data-scene` (an id of scenes.js, or "file"), and `data-complete`
 *   once no scene needs the network any more.
 * - `#notice` is hidden, or carries `data-code` and `data-pointer` of the error it shows.
 * - `#readout` carries `data-vertex`, the vertex under the pointer or "-1" for a mere configuration, and `data-free`;
 *   neither while the pointer is on nothing.
 * - `#touching` carries `data-free` and names the parts in collision.
 * - `#editor`, while it is open, carries `data-tool`, `data-kind` and `data-title` of the selection, `data-undo`,
 *   `data-redo`, `data-changes`, `data-busy` ("true" during a gesture), `data-code` of the last refusal and
 *   `data-touching`, which names a start or goal in collision.
 * - `#certify` carries `data-on`, whether it is shown if a path exists, and then `data-verdict`, empty before it is
 *   decided.
 * - `#story` carries `data-tone`, "bad" where a path that was found collides.
 * - In a race each row of `#standings tbody` carries `data-status` and, at rest at the newest iteration,
 *   `data-fingerprint`.
 * - The work of each frame in which the graph grew is a `performance.measure` called "planarium-frame".
 */
import * as library from "planarium";
import { App } from "../app/app.js";
import { byId, reveal, write } from "../app/dom.js";
import { watchFiles } from "../app/drop.js";
import { LazyFeature } from "../app/lazy-feature.js";
import { keepState, takeState } from "../app/left.js";
import { watchKeys } from "../app/keys.js";
import { once } from "../app/once.js";
import { SIDE, makeGallery } from "../widgets/gallery.js";
import { watchAnnouncements } from "./announce.js";
import { offerCertificate } from "./certificate/controls.js";
import { Counters } from "./counters.js";
import { sourceOf } from "./experiment.js";
import { showLegend } from "./legend.js";
import { experimentOf } from "./link/experiment.js";
import { Page } from "./page.js";
import { Pose } from "./pose/controls.js";
import { showPseudocode } from "./pseudocode.js";
import { SCENES } from "./scenes/scenes.js";
import { Session, placed } from "./session.js";
import { loadRegions } from "./stage/pane.js";
import { Panel } from "./settings/panel.js";
import { Planners } from "./settings/planners.js";
import { Figures } from "./figures.js";
import { Transport } from "./timeline/transport.js";

/** @import { PlannerWorker } from "./worker/worker.js" */

/** Milliseconds after the first picture at which the other layers get their memory and the thumbnails are drawn. */
const THUMBNAILS = 250;
/** Milliseconds after the thumbnails at which the modules for other scenes and for prints are loaded. */
const MODULES = 3000;
/** The number of seeds that "New seed" chooses from: six digits can be said aloud. */
const SEEDS = 1_000_000;

const app = new App();
const { notice } = app;
const counters = new Counters();

const isOpen = await app.open(
  "planner",
  async (/** @type {PlannerWorker} */ worker) => {
    const session = new Session(app, library, worker);
    const turn = byId("your-turn", HTMLButtonElement);
    const stage = byId("stage", HTMLElement);
    const readout = byId("readout", HTMLOutputElement);
    const hint = matchMedia("(hover: hover)").matches ? "Point at a vertex to see its details." : "";
    const seeds = new LazyFeature(notice, () => import("./over-seeds.js"));
    const panel = new Panel(() => library.randomSeed() % SEEDS, {
      lane: (lane) => page.change({ lanes: page.record.lanes.with(0, lane) }),
      query: (query) => page.change({ query }),
      own: () => page.useOwn(),
      // A page in one file has no others beside it.
      seeds: document.querySelector(".rooms") && (() => seeds.use(({ openOverSeeds }) => openOverSeeds(page))),
    });
    const page = new Page(app, session, panel, new Planners(session.catalogue.planners));
    const figures = new Figures(page);
    const pose = new Pose((at) => page.act(({ byHand }) => byHand.hold(Float64Array.from(at))));
    const gallery = makeGallery(SCENES, (entry) => {
      void app.track(page.open({ scene: entry.id }), `The scene "${entry.title}" could not be loaded.`);
    });
    const transport = new Transport(page);
    watchKeys([stage, transport.bar], {
      " ": () => page.act(({ timeline }) => timeline.toggle()),
      ".": () => page.act(({ timeline }) => timeline.step(1)),
      ",": () => page.act(({ timeline }) => timeline.step(-1)),
      e: () => page.act(({ timeline }) => timeline.finish()),
      r: () => page.act(() => session.reset()),
      n: () => panel.reseed(),
    });
    watchFiles((files) => void app.track(open().then((openFiles) => openFiles(files))));
    watchAnnouncements(page);
    const certifying = once(async () => new (await import("./certificate/certifying.js")).Certifying(session, worker));
    offerCertificate(page, certifying);
    showPseudocode(page);

    const open = once(async () => (await import("./open.js")).opener(page));
    const options = new LazyFeature(notice, async () =>
      (await import("./scenes/options.js")).showSceneOptions(page, library.generators()),
    ).inFold("make-fold");
    page.onOpen((_, entry) => {
      if (entry?.sliders) options.use();
    });
    const race = new LazyFeature(notice, async () => new (await import("./race/race.js")).Race(page, figures)).inFold(
      "race-fold",
    );
    page.loadRace = () => race.get();
    const asking = new LazyFeature(notice, async () => (await import("./ask.js")).watchAsking(page));
    let canAsk = false;
    new LazyFeature(notice, async () => (await import("./view.js")).watchView(page)).inFold("view-fold");
    new LazyFeature(notice, async () => (await import("./curves.js")).watchCurves(page)).inFold("curves-fold");
    new LazyFeature(notice, async () => {
      page.timing = await (await import("./timing/open.js")).openTiming(page);
    }).inFold("timing-fold");
    new LazyFeature(notice, async () => (await import("./room/open.js")).openRoom(page)).inFold("room-fold");
    const editing = async () => {
      session.repair ??= new (await import("./repair.js")).Repair(session);
      return new (await import("./editor/controls.js")).EditorControls(page);
    };
    new LazyFeature(notice, editing)
      .inFold("editor-fold")
      .byButton("edit", (editor) => editor.toggle())
      .byButton("new-scene", (editor) => editor.create());
    const drive = new LazyFeature(notice, async () => new (await import("./driving/controls.js")).DriveControls(page));
    page.loadDrive = () => drive.get();
    const print = new LazyFeature(notice, async () => (await import("./print.js")).watchPrint(page));
    const lessons = new LazyFeature(
      notice,
      async () => new (await import("./lessons/lessons.js")).Lessons(page),
    ).inFold("lessons-fold");
    new LazyFeature(notice, async () => {
      const [{ showExport }, { lineOf }] = await Promise.all([import("./export/export.js"), import("./print.js")]);
      showExport(page, () => lineOf(page));
    }).inFold("export-fold");
    const link = new LazyFeature(
      notice,
      async () => new (await import("./link/link.js")).Link(page, SCENES, library.generators(), app.projector),
    ).byButton("link", ({ share }) => share());
    if (window.parent !== window) (await import("./embed.js")).watchParent(page);
    addEventListener("hashchange", () => {
      if (location.hash) void app.track(openAddress());
    });

    page.arrange = () => {
      if (!page.race?.arrange() && page.facts) figures.arrange(page.facts);
    };
    page.onOpen((facts, entry) => {
      document.body.dataset.scene = entry?.id ?? "file";
      pose.build(facts);
      gallery.mark(entry?.id ?? null);
    });
    page.onState((state) => {
      counters.show(state.lanes[0], state.settled);
      if (!canAsk && (state.canAsk || (page.facts?.queries.length ?? 0) > 1)) {
        canAsk = true;
        asking.use();
      }
      showLegend(page, state);
      const { hover } = state;
      write(readout, hover ? hover.text : hint);
      if (hover) Object.assign(readout.dataset, { vertex: hover.vertex, free: hover.free });
      else for (const name of ["vertex", "free"]) delete readout.dataset[name];
      app.say(state.sentence, { isBad: state.isBad, isSilent: true });
      app.write({
        "your-turn": state.inHand ? "Watch again" : page.facts?.robot === "car" ? "Drive" : "Your turn",
        where: `${page.title} \u00b7 ${page.names.join(" against ")}`,
      });
      stage.classList.toggle("in-hand", state.inHand);
      pose.reflect(state);
      figures.showAxes(state, page.facts);
      figures.describe(state);
    });
    session.onDirty = () => counters.unsettle();
    turn.addEventListener("click", (event) => {
      if (page.facts?.robot === "car") {
        drive.use((controls) => controls.toggle());
        return;
      }
      if (event.detail === 0) {
        reveal(byId("pose", HTMLElement));
        pose.awaitsFocus = true;
      }
      page.act(({ byHand }) => byHand.change());
    });
    turn.disabled = false;

    app.onTheme(() => page.act(() => session.stage.setTheme(app.look)));
    app.setTheme();
    keepState(() => page.coming ?? (page.facts && experimentOf(page)));
    const left = takeState();
    // A lesson opens at its step.
    const isBack = left && !isLesson() && (await (await link.get()).openLeft(left));
    if (!isBack) await (location.hash ? openAddress() : page.open({ scene: SCENES[0].id }));
    app.onTheme(() => void app.track(drawThumbnails()));
    setTimeout(() => {
      session.stage.prepare();
      void app.track(drawThumbnails());
    }, THUMBNAILS);

    /** Whether the address is that of a step of a lesson. */
    function isLesson() {
      return location.hash.startsWith("#lesson=");
    }

    /** Opens the experiment or the step of a lesson in the address. */
    async function openAddress() {
      await (await (isLesson() ? lessons : link).get()).open(location.hash);
    }

    async function drawThumbnails() {
      for (const entry of SCENES)
        gallery.draw(entry.id, await worker.thumbnail(await sourceOf({ scene: entry.id }), SIDE, app.look));
      setTimeout(() => void loadModules(), MODULES);
    }

    /** Loads the modules that other scenes and prints need, for when there is no network. */
    async function loadModules() {
      try {
        const features = [options, asking, print, link].map((feature) => feature.get());
        await Promise.all([open(), placed(), certifying(), loadRegions(), ...features]);
        document.body.dataset.complete = "true";
      } catch {
        // There is no network any more: the next use tries again, and reports the error.
      }
    }
  },
  "worker.js",
);
if (!isOpen) counters.fail();
