// Puts the page together.

import { load } from "../hooke/index.js";
import { App } from "./app.js";
import { NOTHING_CHOSEN, fromShare } from "./choices.js";
import { findDesktop } from "./desktop.js";
import { unpack } from "./share.js";
import { DESKTOP } from "./steppers.js";
import { Stage } from "./draw/stage.js";
import { Panel } from "./ui/panel.js";
import { Picture } from "./ui/picture.js";
import { toast } from "./ui/toast.js";

async function begin() {
  const stage = new Stage(document.getElementById("stage"));
  const [hooke, desktop] = await Promise.all([load(), findDesktop()]);
  const shared = await unpack(location.hash).catch((error) => void toast(error.message, true));
  const chosen = fromShare(shared);
  if (desktop && !shared) Object.assign(chosen, { scene: desktop.name, text: desktop.text, meshes: desktop.meshes, a: DESKTOP });
  const app = new App(hooke, stage, desktop);
  new Panel(app);
  new Picture(app);
  await app.open(chosen).catch((error) => {
    toast(error.message, true);
    return app.open(NOTHING_CHOSEN);
  });
  // Other code on the page, tests among it, can look at what is shown.
  globalThis.hookePage = app;
  addEventListener("hashchange", async () => {
    const other = await unpack(location.hash).catch((error) => void toast(error.message, true));
    if (other) await app.open(fromShare(other)).catch((error) => toast(error.message, true));
  });
  app.run();
}

begin().catch((error) => {
  console.error(error);
  toast(`This page cannot begin: ${error.message}`, true);
});
