// The scenes that come with the page: file, title, and the mesh files that it names.

export const SHIPPED = [
  { file: "hanging-cloth.toml", title: "hanging cloth", meshes: [] },
  { file: "stiff-rope.toml", title: "stiff rope", meshes: [] },
  { file: "slung-rope.toml", title: "slung rope", meshes: [] },
  { file: "jelly-on-a-slope.toml", title: "jelly on a slope", meshes: [] },
  { file: "canopy.toml", title: "canopy from a mesh", meshes: ["canopy.obj"] },
  { file: "whip.toml", title: "whip", meshes: [] },
  { file: "vertical-spring.toml", title: "mass on a spring", meshes: [] },
  { file: "damped-pendulum.toml", title: "damped pendulum", meshes: [] },
  { file: "bouncing-balls.toml", title: "bouncing balls", meshes: [] },
  { file: "funnel.toml", title: "a thousand balls in a funnel", meshes: [] },
];

/** The text of one of them, and of its meshes. */
export async function textOf(file) {
  const entry = SHIPPED.find((scene) => scene.file === file);
  if (!entry) throw new Error(`there is no scene ${file} here: the link is from another page`);
  const fetched = async (name) => {
    const response = await fetch(new URL(`../scenes/${name}`, import.meta.url));
    if (!response.ok) throw new Error(`${name} cannot be fetched: ${response.status} ${response.statusText}`);
    return response.text();
  };
  const meshes = {};
  for (const mesh of entry.meshes) meshes[mesh] = await fetched(mesh);
  return { text: await fetched(file), meshes };
}
