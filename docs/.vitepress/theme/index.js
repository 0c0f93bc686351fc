/** The default theme in the colours of the pages, with the live stage of the planners' pages. */
import DefaultTheme from "vitepress/theme-without-fonts";
import { useData, withBase } from "vitepress";
import { defineComponent, h, ref, watch } from "vue";
import { codeWarning, qrCode } from "../../../www/app/qr-code.js";
import { dress } from "../../../www/app/theme.js";
import "./style.css";

/** A picture of a run, which the planner's page in a frame replaces once it is asked for. */
const LiveStage = defineComponent({
  props: { picture: String, address: String, title: String, width: Number, height: Number },
  setup({ picture = "", address = "", title = "", width = 0, height = 0 }) {
    const { isDark } = useData();
    const isLive = ref(false);
    const frame = ref(/** @type {HTMLIFrameElement | null} */ (null));
    const page = withBase("/../plan.html");

    /** Plays as soon as the page in the frame tells its state. @param {MessageEvent} message */
    function play({ source, data }) {
      if (source !== frame.value?.contentWindow || data?.planarium !== "state" || !data.state) return;
      removeEventListener("message", play);
      frame.value?.contentWindow?.postMessage({ planarium: "play" }, "*");
    }
    function start() {
      isLive.value = true;
      addEventListener("message", play);
    }
    /** The frame follows the theme of this page. */
    function follow() {
      const inside = frame.value?.contentDocument;
      if (inside) dress(inside, isDark.value ? "dark" : "light");
    }
    watch(isDark, follow);

    return () =>
      h("figure", { class: "stage" }, [
        isLive.value
          ? h("iframe", {
              ref: frame,
              src: `${page}?embed=1${address}`,
              title,
              onLoad: follow,
              onVnodeUnmounted: () => removeEventListener("message", play),
            })
          : h("button", { type: "button", class: "poster", "aria-label": `Run ${title}`, onClick: start }, [
              h("img", {
                src: withBase(picture),
                width,
                height,
                alt: `${title}, at the end of a run`,
                loading: "lazy",
              }),
              h("span", { class: "run" }, "Run it"),
            ]),
        h("figcaption", [`${title}. `, h("a", { href: `${page}${address}`, target: "_self" }, "Open it on the page")]),
      ]);
  },
});

/** On paper a page of the class `codes` has a code beside each task, which opens its run. They are drawn with the first print. */
function drawCodes() {
  for (const link of /** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll(".codes li > p > a"))) {
    const task = link.closest("li");
    if (!link.hash || task?.querySelector(".code")) continue;
    const code = qrCode(link.href, `QR code of the link to ${link.textContent}`);
    code.classList.add("code");
    task?.prepend(code);
  }
  const textContent = codeWarning(location);
  const heading = document.querySelector(".codes h1:not(:has(+ .code-warning))");
  if (textContent)
    heading?.after(Object.assign(document.createElement("p"), { className: "code-warning", textContent }));
}

export default {
  extends: DefaultTheme,
  /** @param {{ app: import("vue").App }} site */
  enhanceApp({ app }) {
    app.component("LiveStage", LiveStage);
    if (typeof window !== "undefined") addEventListener("beforeprint", drawCodes);
  },
};
