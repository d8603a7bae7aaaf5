// Everything beside the picture: steppers, the time step and its limits, the scene's numbers, the energy.

import { DESKTOP, STEPPERS, stepperOf } from "../steppers.js";
import { counted, seconds, short } from "../words.js";
import { LAYERS, drawEnergy, energyScale, remainderWords } from "./energy-chart.js";
import { drawLimits, limitWords } from "./limit-chart.js";
import { element, slider } from "./parts.js";

/** How often what is told in words is told anew, in pictures. */
const EVERY = 6;

export class Panel {
  #pictures = 0;

  constructor(app) {
    this.app = app;
    this.#steppers();
    this.#sliders();
    const fill = (id, ...content) => document.getElementById(id).replaceChildren(...content);
    fill("energy-charts");
    app.addEventListener("scene", () => this.#scene());
    app.addEventListener("built", () => this.#built());
    app.addEventListener("choice", () => this.#show());
    app.addEventListener("picture", () => this.#picture());
  }

  #steppers() {
    const { app } = this;
    const options = () => STEPPERS.map(({ name, title }) => element("option", { value: name }, title));
    this.a = element("select", { id: "stepper-a", onchange: () => app.choose({ a: this.a.value }) }, ...options());
    if (app.desktop) this.a.prepend(element("option", { value: DESKTOP }, "the desktop's run, live"));
    this.b = element("select", { id: "stepper-b", onchange: () => app.choose({ b: this.b.value || null }) },
      element("option", { value: "" }, "nothing beside it"), ...options());
    this.form = element("select", { id: "collision", onchange: () => app.choose({ collision: this.form.value }) },
      ...[["reflect", "turn round (reflect)"], ["project", "put back (project)"], ["time-of-impact", "found in the step"]].map(
        ([value, title]) => element("option", { value }, title)));
    this.formRow = element("label", { className: "choice" }, element("span", {}, "at planes"), this.form);
    const trio = element("button", { id: "trio", type: "button", onclick: () => this.#next() }, "show me");
    trio.title = "explicit Euler explodes, implicit sags, semi-implicit swings";
    document.getElementById("steppers").append(
      element("label", { className: "choice side-a" }, element("span", {}, "stepper"), this.a),
      element("label", { className: "choice side-b" }, element("span", {}, "beside"), this.b),
      this.formRow,
      element("p", { className: "lesson" }, "The same scene by two steppers: ", trio, element("span", { id: "lesson" })),
    );
  }

  /** Pairs worth seeing, one after the other. */
  #next() {
    const lessons = [
      ["explicit-euler", "semi-implicit-euler", "explicit Euler makes energy and explodes; semi-implicit swings on."],
      ["semi-implicit-euler", "implicit-euler", "semi-implicit swings; implicit Euler damps by itself, and sags to rest."],
      ["implicit-euler", "implicit-midpoint", "both stable at any step; only the midpoint keeps the motion."],
    ];
    this.lesson = ((this.lesson ?? -1) + 1) % lessons.length;
    const [a, b, words] = lessons[this.lesson];
    document.getElementById("lesson").textContent = ` ${words}`;
    // Long enough for them to differ, short enough for semi-implicit Euler to be stable where the scene begins.
    this.app.reset();
    const limit = Math.min(0.02, this.app.sides.list[0].stableStep("semi-implicit-euler"));
    this.app.choose({ a, b, timeStep: Number((0.6 * limit).toPrecision(2)) });
    this.app.reset();
    this.app.play(true);
  }

  #sliders() {
    const { app } = this;
    const times = (value) => `× ${short(value)}`;
    const make = (key, about) => slider({ id: key, change: (value) => app.choose({ [key]: value }), usual: () => (key === "timeStep" || key === "restitution" ? null : 1), ...about });
    this.sliders = {
      timeStep: make("timeStep", { title: "time step", least: 1e-5, most: 0.1, scale: "logarithmic", words: seconds }),
      stiffness: make("stiffness", { title: "stiffness", least: 0.01, most: 100, scale: "logarithmic", words: times }),
      damping: make("damping", { title: "damping", least: 0.01, most: 100, scale: "logarithmic", zero: true, words: (v) => (v === 0 ? "none" : times(v)) }),
      restitution: make("restitution", { title: "restitution", least: 0, most: 1, words: (v) => (this.#differs() ? "as in the scene" : short(v)) }),
      gravity: make("gravity", { title: "gravity", least: -1, most: 3, words: () => this.#gravityWords() }),
    };
    document.getElementById("step-slider").append(this.sliders.timeStep.row);
    const { stiffness, damping, restitution, gravity } = this.sliders;
    document.getElementById("sliders").append(element("h2", {}, "The scene's numbers"), stiffness.row, damping.row, restitution.row, gravity.row);
  }

  /** Whether planes have restitutions of their own. */
  #differs() {
    const { chosen, scene } = this.app;
    return chosen.restitution === null && scene.planes.some((plane) => plane.restitution !== scene.planes[0].restitution);
  }

  #gravityWords() {
    const g = this.app.sides.choices?.gravity ?? [0, 0, 0];
    return `${short(Math.hypot(...g))} m/s²`;
  }

  #scene() {
    const { scene } = this.app;
    this.formRow.hidden = scene.planes.length === 0;
    this.#show();
  }

  #built() {
    const { sides } = this.app;
    this.charts = sides.list.map((_, i) => {
      const canvas = element("canvas", { className: "energy" });
      canvas.setAttribute("role", "img");
      canvas.setAttribute("aria-label", "Energy");
      const title = element("span", { className: i === 0 ? "tag side-a" : "tag side-b" });
      const words = element("span", { className: "remainder" });
      return { canvas, title, words, row: element("figure", {}, element("figcaption", {}, title, words), canvas) };
    });
    const legend = element("ul", { className: "legend" }, ...LAYERS.map(([key, words]) => element("li", { className: key }, words)),
      element("li", { className: "line" }, "what should be there"));
    document.getElementById("energy-charts").replaceChildren(...this.charts.map((chart) => chart.row), legend);
    this.limitWords = sides.list.map(() => element("p", {}));
    document.getElementById("limit-words").replaceChildren(...this.limitWords);
    this.#show();
  }

  #show() {
    const { app } = this;
    if (!app.scene || app.sides.list.length === 0) return;
    const [a, b] = app.names;
    this.a.value = a;
    this.b.value = b ?? "";
    this.form.value = app.sides.choices.collision;
    this.sliders.timeStep.show(app.sides.timeStep);
    for (const key of ["stiffness", "damping", "gravity"]) this.sliders[key].show(app.chosen[key]);
    const isLive = app.sides.list.every((side) => side.stepper === DESKTOP);
    const { scene } = app;
    const { timeStep, stiffness, damping, restitution, gravity } = this.sliders;
    [timeStep, gravity].forEach((slider) => slider.enable(!isLive));
    [stiffness, damping].forEach((slider) => slider.enable(!isLive && scene.springs > 0));
    restitution.enable(!isLive && scene.planes.length > 0);
    this.form.disabled = isLive;
    const own = app.scene.planes[0]?.restitution ?? 1;
    this.sliders.restitution.show(app.chosen.restitution ?? own);
    this.#pictures = 0;
  }

  #picture() {
    const { sides } = this.app;
    this.scale = energyScale(sides.histories, this.scale);
    this.charts.forEach((chart, i) => drawEnergy(chart.canvas, sides.histories[i], this.scale, sides.list[i].stopped?.exploded));
    if (this.#pictures++ % EVERY === 0) this.#words();
  }

  #words() {
    const { app, charts } = this;
    const { sides } = app;
    const limits = new Map(STEPPERS.map(({ name }) => [name, Math.max(0, ...[sides.list.at(-1).stableStep(name)])]));
    const names = sides.list.map((side) => side.stepper);
    drawLimits(document.getElementById("limit-chart"), { limits, names, timeStep: sides.timeStep });
    sides.list.forEach((side, i) => {
      const { words, state } = limitWords(side.stepper, side.stableStep(), sides.timeStep);
      this.limitWords[i].textContent = words;
      this.limitWords[i].className = `${state} ${i === 0 ? "side-a" : "side-b"}`;
      charts[i].title.textContent = stepperOf(side.stepper).title;
      const missing = remainderWords(sides.histories[i].rows.at(-1), this.scale.floor);
      charts[i].words.textContent = `made or lost by the stepper: ${missing}`;
      charts[i].canvas.setAttribute("aria-label", `Energy of ${stepperOf(side.stepper).title}; made or lost by the stepper itself: ${missing}`);
    });
    if (document.getElementById("more").open) this.#facts();
  }

  #facts() {
    const { scene, sides, hooke } = this.app;
    const facts = [
      ["scene", `${counted(scene.particles, "particle")}, ${counted(scene.springs, "spring")}, ${counted(scene.planes.length, "plane")}`],
      ["numbers", scene.precision === "f32" ? "single precision" : `single precision; the scene asks for ${scene.precision}, which the desktop has`],
      ["vectors", hooke.simd ? "128-bit SIMD" : "none: this browser has no SIMD"],
      ...sides.list.flatMap((side) => [
        [stepperOf(side.stepper).title, `${counted(side.steps, "step")}, digest ${side.digest()}`],
        ["computing", `${short(side.milliseconds ?? 0)} ms a picture`],
      ]),
    ];
    document.getElementById("facts").replaceChildren(
      element("dl", {}, ...facts.flatMap(([name, value]) => [element("dt", {}, name), element("dd", {}, value)])),
      element("p", {}, "Pause, and the digest is that of the desktop after as many steps of the same length: the same bits."),
    );
  }
}
