//! The files of the web page, as they are in this program.

/// What a browser asks for by a path.
pub(super) struct File {
    pub(super) kind: &'static str,
    pub(super) bytes: &'static [u8],
    /// Whether the bytes are gzipped.
    pub(super) is_packed: bool,
}

const HTML: &str = "text/html; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";
const STYLE: &str = "text/css; charset=utf-8";
const PICTURE: &str = "image/svg+xml";
const TEXT: &str = "text/plain; charset=utf-8";
const WASM: &str = "application/wasm";

/// Paths, and where the file is that each has.
macro_rules! files {
    ($($kind:ident from $folder:literal as $prefix:literal: $($name:literal)+;)+) => {
        /// All of them but the modules, which have been compiled and packed.
        const PLAIN: &[(&str, &str, &[u8])] = &[
            $($((concat!($prefix, $name), $kind, include_bytes!(concat!("../../../", $folder, $name))),)+)+
        ];
    };
}

files! {
    HTML from "examples/web/page/" as "": "index.html";
    STYLE from "examples/web/page/" as "": "style.css";
    PICTURE from "examples/web/page/" as "": "icon.svg";
    SCRIPT from "examples/web/page/js/" as "js/":
        "app.js" "choices.js" "desktop.js" "history.js" "main.js" "scene.js" "share.js" "shipped.js" "side.js" "sides.js"
        "steppers.js" "tracks.js" "words.js" "draw/camera.js" "draw/extent.js" "draw/looks.js" "draw/matrices.js"
        "draw/program.js" "draw/shaders.js" "draw/shadows.js" "draw/side-buffers.js" "draw/stage.js" "draw/strain.js"
        "ui/canvas.js" "ui/editor.js" "ui/energy-chart.js" "ui/keys.js" "ui/limit-chart.js" "ui/panel.js" "ui/parts.js"
        "ui/picture.js" "ui/pointer.js" "ui/toast.js";
    SCRIPT from "examples/web/package/src/" as "hooke/":
        "error.js" "index.js" "load.js" "memory.js" "model.js" "names.js" "report.js" "world.js";
    TEXT from "scenes/" as "scenes/":
        "bouncing-balls.toml" "canopy.toml" "canopy.obj" "damped-pendulum.toml" "funnel.toml" "hanging-cloth.toml"
        "jelly-on-a-slope.toml" "slung-rope.toml" "stiff-rope.toml" "vertical-spring.toml" "whip.toml";
}

/// Built by `examples/web/page/build`, so that this program needs no compiler for the web.
const PACKED: &[(&str, &[u8])] = &[
    ("hooke/hooke.wasm", include_bytes!("built/hooke.wasm.gz")),
    ("hooke/hooke-simd.wasm", include_bytes!("built/hooke-simd.wasm.gz")),
    ("wasm/scene.wasm", include_bytes!("built/scene.wasm.gz")),
];

/// The file at a path without its leading slash; the page itself at the empty one.
pub(super) fn at(path: &str) -> Option<File> {
    let path = if path.is_empty() { "index.html" } else { path };
    let plain = PLAIN.iter().find(|(name, ..)| *name == path);
    let packed = || PACKED.iter().find(|(name, _)| *name == path);
    plain
        .map(|(_, kind, bytes)| File { kind, bytes, is_packed: false })
        .or_else(|| packed().map(|(_, bytes)| File { kind: WASM, bytes, is_packed: true }))
}
