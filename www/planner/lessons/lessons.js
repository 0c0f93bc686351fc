/**
 * Lessons: a few sentences each, one at a time above the stage, and what they speak of on it. Every step has an address,
 * `#lesson=ID.STEP`, counted from 1.
 */
import { LESSONS, stageAt } from "./script.js";
import { byId, make } from "../../app/dom.js";

/** @import { Page } from "../page.js" */
/** @import { Lesson } from "./script.js" */
/** @import { Plan, SceneEntry } from "../../domain/types.js" */

const ADDRESS = /^#?lesson=([\w-]+)(?:\.(\d{1,4}))?$/;

export class Lessons {
  /** @param {Page} page @param {SceneEntry[]} scenes @param {Lesson[]} [lessons] */
  constructor(page, scenes, lessons = LESSONS) {
    this.page = page;
    this.lessons = lessons;
    this.scenes = scenes;
    /** @type {Lesson | null} */
    this.lesson = null;
    this.at = 0;
    this.title = make("strong", {});
    this.count = make("span", { className: "hint" });
    this.text = make("p", {});
    this.back = button("Previous", () => this.go(this.at - 1));
    this.next = button("Next", () => this.go(this.at + 1));
    const leave = button("Leave", () => this.leave());
    this.back.id = "lesson-previous";
    this.next.id = "lesson-next";
    this.next.className = "primary";
    leave.className = "quiet";
    leave.id = "lesson-leave";
    const head = make("p", { className: "head" }, this.title, " ", this.count);
    const words = make("div", { role: "status" }, head, this.text);
    this.band = make("section", { id: "lesson", className: "lesson", ariaLabel: "Lesson", hidden: true },
      words, make("div", { className: "buttons" }, this.back, this.next, leave));
    byId("story", HTMLElement).before(this.band);
    const list = make("ul", {}, ...lessons.map((lesson) => make("li", {}, button(lesson.title, () => {
      this.begin(lesson);
      this.next.focus();
    }))));
    byId("lessons", HTMLElement).append(list);
  }

  /** Opens the step that an address names; where there is none, says so. @param {string} fragment */
  async obey(fragment) {
    const { page } = this;
    const [, id, step = "1"] = ADDRESS.exec(fragment) ?? [];
    const lesson = this.lessons.find((one) => one.id === id);
    if (lesson && lesson.steps[Number(step) - 1]) {
      this.lesson = lesson;
      await this.put(Number(step) - 1);
      return;
    }
    if (!page.facts) await page.openScene(this.scenes[0]);
    page.notice.show(lesson ? `The lesson "${lesson.title}" has ${lesson.steps.length} steps, and none of number ${step}.` : `There is no lesson "${id ?? fragment.slice(0, 64)}".`, "");
  }

  /** @param {Lesson} lesson */
  begin(lesson) {
    this.lesson = lesson;
    void this.put(0);
  }

  /** @param {number} step */
  go(step) {
    if (step >= (this.lesson?.steps.length ?? 0)) this.leave();
    else if (step >= 0) void this.put(step);
  }

  leave() {
    this.lesson = null;
    this.band.hidden = true;
    address("");
    byId("stage", HTMLElement).focus();
  }

  /** Shows a step, and puts what it speaks of on the stage. @param {number} step */
  async put(step) {
    const { lesson, page, scenes } = this;
    if (!lesson) return;
    this.at = step;
    this.title.textContent = lesson.title;
    this.count.textContent = `${step + 1} of ${lesson.steps.length}`;
    this.text.textContent = lesson.steps[step].text;
    this.back.disabled = step === 0;
    this.next.textContent = step + 1 === lesson.steps.length ? "Finish" : "Next";
    this.band.hidden = false;
    address(`#lesson=${lesson.id}.${step + 1}`);
    const { iteration } = lesson.steps[step];
    const { scene, algorithm, settings } = stageAt(lesson, step);
    try {
      const entry = scenes.find(({ id }) => id === scene);
      if (!entry) throw new Error(`There is no scene "${scene}".`);
      const plans = [page.panel.reads(algorithm, settings)];
      // Where it does not rest it runs to its end, at once before those who ask for less motion.
      const rest = iteration ?? (page.calm ? Infinity : undefined);
      const isThere = this.isThere(entry, plans);
      // Whoever goes on meanwhile wants another step: this one moves nothing any more.
      if (!isThere && !await page.openScene(entry, { plans, iteration: rest, play: rest === undefined })) return;
      // Beside an open editor a scene would wait.
      if (rest === undefined) page.act(({ timeline }) => timeline.play());
      else if (isThere) page.act(({ timeline }) => timeline.seek(rest));
    } catch (error) {
      if (!page.facts) await page.openScene(scenes[0]);
      page.notice.show("What this step speaks of cannot be shown.", error);
    }
  }

  /** Is this on the stage already, to be gone on with? @param {SceneEntry} entry @param {Plan[]} plans */
  isThere(entry, plans) {
    const { source, facts, asked, panel } = this.page;
    return this.page.entry === entry && (!source || !("generate" in source) || source.generate === entry.generate)
      && panel.query.value === (facts?.queries[0] ?? "") && JSON.stringify(asked) === JSON.stringify(plans);
  }
}

/** @param {string} text @param {() => void} onClick */
function button(text, onClick) {
  const made = make("button", { type: "button" }, text);
  made.addEventListener("click", onClick);
  return made;
}

/** What the address bar says, where it is open to this page. @param {string} fragment */
function address(fragment) {
  try {
    history.replaceState(null, "", fragment || location.pathname + location.search);
  } catch {
    // a frame whose address is not its own: the lesson goes on all the same
  }
}
