// What lies over the picture: the scene's name, labels of the sides, time; and hands, keys, links.

import { NOTHING_CHOSEN } from "../choices.js";
import { SHIPPED } from "../shipped.js";
import { stepperOf } from "../steppers.js";
import { short } from "../words.js";
import { Editor } from "./editor.js";
import { Keys } from "./keys.js";
import { element } from "./parts.js";
import { Pointer } from "./pointer.js";
import { toast } from "./toast.js";

const SPEEDS = [0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 4];
const ICONS = { play: "M8 5l11 7-11 7z", pause: "M7 5h4v14H7zM13 5h4v14h-4z" };
const at = (id) => document.getElementById(id);

export class Picture {
  constructor(app) {
    this.app = app;
    new Pointer(app);
    const editor = new Editor(app);
    this.theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
    this.#wear(this.theme);
    const actions = {
      play: () => app.play(!app.playing), step: () => app.step(), reset: () => app.reset(), link: () => this.#link(),
      theme: () => this.#wear(this.theme === "dark" ? "light" : "dark"), edit: () => editor.open(),
    };
    for (const [id, action] of Object.entries(actions)) at(id).addEventListener("click", action);
    new Keys(app, { ...actions, file: (by) => this.#another(by) });
    at("speed").append(...SPEEDS.map((speed) => element("option", { value: String(speed) }, speed === 1 ? "real time" : `× ${speed}`)));
    at("speed").addEventListener("change", () => app.choose({ speed: Number(at("speed").value) }));
    at("scene").addEventListener("change", () => this.#open(at("scene").value));
    app.addEventListener("scene", () => this.#list());
    app.addEventListener("built", () => this.#labels());
    app.addEventListener("play", () => this.#buttons());
    app.addEventListener("choice", () => this.#buttons());
    app.addEventListener("picture", () => this.#picture());
    app.stage.canvas.addEventListener("webglcontextlost", () => toast("The graphics card has been taken away: load the page again.", true));
    this.#buttons();
  }

  #list() {
    const { app } = this;
    const options = SHIPPED.map(({ file, title }) => element("option", { value: file }, title));
    if (app.scene && app.chosen.text !== null) options.unshift(element("option", { value: "" }, app.scene.name));
    at("scene").replaceChildren(...options);
    at("scene").value = app.chosen.text === null ? app.chosen.scene : "";
    if (app.scene) document.title = `${app.scene.name} · Hooke`;
  }

  async #open(file) {
    if (!file) return;
    const { a, b, speed } = this.app.chosen;
    await this.app.open({ ...NOTHING_CHOSEN, scene: file, a: a === "desktop" ? null : a, b, speed }).catch((error) => toast(error.message, true));
    this.app.play(true);
  }

  #another(by) {
    const now = SHIPPED.findIndex(({ file }) => file === this.app.chosen.scene);
    this.#open(SHIPPED[(now + by + SHIPPED.length) % SHIPPED.length].file);
  }

  async #link() {
    const link = await this.app.link();
    history.replaceState(null, "", link);
    try {
      await navigator.clipboard.writeText(link);
      toast("The link is copied: it carries the scene and everything chosen.");
    } catch {
      toast("The link is in the address bar: it carries the scene and everything chosen.");
    }
  }

  #wear(theme) {
    this.theme = theme;
    document.documentElement.dataset.theme = theme;
    this.app.stage.wear(theme);
  }

  #buttons() {
    const { app } = this;
    at("play").innerHTML = `<svg viewBox="0 0 24 24"><path class="solid" d="${app.playing ? ICONS.pause : ICONS.play}"/></svg>`;
    at("play").setAttribute("aria-label", app.playing ? "Pause" : "Play");
    at("speed").value = String(SPEEDS.includes(app.chosen.speed) ? app.chosen.speed : 1);
  }

  #labels() {
    this.labels = this.app.sides.list.map((_, i) => {
      const name = element("b", {});
      const news = element("span", { role: "status" });
      return { name, news, row: element("div", { className: i === 0 ? "label side-a" : "label side-b" }, name, news) };
    });
    at("labels").replaceChildren(...this.labels.map((label) => label.row));
    at("labels").className = `sides-${this.labels.length}`;
    this.#buttons();
  }

  #picture() {
    const { app } = this;
    const slow = app.playing && app.sides.slowness < 0.9 ? ` · ${short(app.sides.slowness)} of that speed` : "";
    at("clock").textContent = `${app.sides.time.toFixed(app.sides.time < 100 ? 2 : 1)} s${slow}`;
    at("labels").classList.toggle("stacked", app.stage.isStacked);
    at("strain").hidden = app.scene.springs === 0;
    const end = `stretched ${short(100 * app.stage.strain.end)} %`;
    if (at("strain-end").textContent !== end) at("strain-end").textContent = end;
    app.sides.list.forEach((side, i) => {
      const { name, news, row } = this.labels[i];
      const title = stepperOf(side.stepper).title;
      if (name.textContent !== title) name.textContent = title;
      const words = side.stopped ? side.stopped.words : "";
      if (news.textContent !== words) news.textContent = words;
      row.classList.toggle("stopped", Boolean(side.stopped?.exploded));
      if (side.stopped?.particle !== undefined && app.held === undefined) app.stage.marked = side.stopped.particle;
    });
  }
}
