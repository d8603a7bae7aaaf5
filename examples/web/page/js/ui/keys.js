// The keyboard.

import { element } from "./parts.js";

const TURN = 0.09;

export class Keys {
  constructor(app, actions) {
    const step = (by) => app.choose({ timeStep: Number((app.sides.timeStep * by).toPrecision(3)) });
    const orbit = (yaw, pitch) => app.camera.orbit(yaw, pitch);
    this.keys = [
      [[" "], "play or pause", actions.play],
      [["."], "one step", actions.step],
      [["r"], "back to the start", actions.reset],
      [["["], "a shorter time step", () => step(1 / 1.25)],
      [["]"], "a longer one", () => step(1.25)],
      [["c"], "two steppers side by side, or one", () => app.choose({ b: app.chosen.b ? null : "implicit-euler" })],
      [["n"], "the next scene", () => actions.file(1)],
      [["p"], "the one before", () => actions.file(-1)],
      [["e"], "read or paste a scene", actions.edit],
      [["l"], "copy a link", actions.link],
      [["t"], "dark or light", actions.theme],
      [["h"], "the view from the start", () => app.camera.goHome()],
      [["+", "="], "nearer", () => app.camera.zoom(1 / 1.15)],
      [["-"], "farther", () => app.camera.zoom(1.15)],
      [["?"], "this list", () => document.getElementById("help").showModal()],
    ];
    const arrows = { ArrowLeft: [TURN, 0], ArrowRight: [-TURN, 0], ArrowUp: [0, TURN], ArrowDown: [0, -TURN] };
    addEventListener("keydown", (event) => {
      const isTyping = event.target.closest?.("dialog, input, select, textarea, summary, [contenteditable]");
      if (isTyping || event.ctrlKey || event.metaKey || event.altKey) return;
      const arrow = arrows[event.key];
      const found = this.keys.find(([names]) => names.includes(event.key.toLowerCase()));
      // A button that has the focus is pressed by the space bar as ever.
      if (event.key === " " && event.target.closest?.("button")) return;
      if (arrow) orbit(...arrow);
      else if (found) found[2]();
      else return;
      event.preventDefault();
    });
    document.getElementById("keys").addEventListener("click", () => document.getElementById("help").showModal());
    const names = (list) => list.map((key) => (key === " " ? "space" : key)).join(" or ");
    document.getElementById("key-list").append(
      ...this.keys.flatMap(([list, words]) => [element("dt", {}, names(list)), element("dd", {}, words)]),
      element("dt", {}, "arrows"), element("dd", {}, "turn the view"),
      element("dt", {}, "drag"), element("dd", {}, "a particle: pull and throw it; beside one: turn the view; right button or shift: move it"),
      element("dt", {}, "wheel, two fingers"), element("dd", {}, "nearer and farther"),
    );
  }
}
