// A scene's text, to read, change and run.

import { HookeError } from "../../hooke/index.js";
import { SceneRefused } from "../scene.js";
import { toast } from "./toast.js";

const at = (id) => document.getElementById(id);

export class Editor {
  meshes = {};

  constructor(app) {
    this.app = app;
    at("run").addEventListener("click", (event) => {
      event.preventDefault();
      this.#run();
    });
    at("files").addEventListener("change", () => this.#take(at("files").files));
    for (const place of [at("editor"), at("picture")]) {
      place.addEventListener("dragover", (event) => event.preventDefault());
      place.addEventListener("drop", (event) => {
        event.preventDefault();
        if (!at("editor").open) this.open();
        this.#take(event.dataTransfer.files);
      });
    }
    at("text").addEventListener("keydown", (event) => {
      if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) this.#run();
    });
  }

  open() {
    const { app } = this;
    at("text").value = app.text;
    at("refusal").textContent = "";
    Object.assign(this, { name: app.chosen.scene, meshes: { ...app.meshes } });
    at("editor").showModal();
    this.#size();
  }

  /** How large the reader of scenes is that was fetched for this. */
  #size() {
    const [fetched] = performance.getEntriesByType("resource").filter(({ name }) => name.endsWith("/scene.wasm"));
    const bytes = fetched?.encodedBodySize;
    if (bytes) at("reader-size").textContent = `read by the desktop's own reader: ${Math.round(bytes / 1000)} kB fetched`;
  }

  async #take(files) {
    for (const file of files) {
      const text = await file.text();
      if (file.name.toLowerCase().endsWith(".obj")) this.meshes[file.name] = text;
      else {
        this.name = file.name;
        at("text").value = text;
      }
    }
    if (at("text").value) await this.#run();
  }

  async #run() {
    const text = at("text").value;
    const { app } = this;
    const looksLikeJson = text.trimStart().startsWith("{");
    const name = this.name.replace(/\.(toml|json)$/, "") + (looksLikeJson ? ".json" : ".toml");
    const isShipped = text === app.text;
    try {
      if (!isShipped) {
        const kept = { ...app.chosen, scene: name, text, meshes: this.meshes, timeStep: null };
        await app.open(kept.a === "desktop" ? { ...kept, a: null } : kept);
      }
      at("editor").close();
      app.play(true);
    } catch (error) {
      if (!(error instanceof SceneRefused || error instanceof HookeError)) throw error;
      at("refusal").textContent = error.printed ?? `in the page's single precision: ${error.message}`;
      at("refusal").scrollIntoView({ block: "nearest" });
      if (error.range) {
        at("text").focus();
        at("text").setSelectionRange(...error.range);
      } else toast(error.message, true);
    }
  }
}
