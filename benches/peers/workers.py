"""Worker processes: one a peer and scene, all alive at once, asked in turn."""

import functools
import json
import os
import select
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).parent
MADE = HERE / "target"
SCENES = HERE.parent / "scenes"
NATIVE = Path(os.environ.get("CARGO_TARGET_DIR", MADE / "rust")) / "release" / "hooke-peers"
NATIVE_FAMILIES = {"hooke", "textbook", "ode_solvers", "diffsol", "rapier3d"}
CORE = "0"
"""All workers are pinned to this one."""
PATIENCE = 300
"""s, for compiling as for one answer."""
ONE_THREAD = {
    name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "NUMBA_NUM_THREADS", "RAYON_NUM_THREADS")
}


class Failed(Exception):
    """Why a peer has no figure."""


def scene_file(scene):
    return SCENES / f"{scene}.toml"


@functools.cache
def flat_file(scene):
    """The scene as columns of numbers, written anew in each run."""
    path = MADE / "flat" / f"{scene}.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "wb") as file:
        subprocess.run([NATIVE, scene_file(scene), "flat"], stdout=file, check=True)
    return path


@functools.cache
def items(scene):
    """How many springs it has, or particles where it has no springs."""
    flat = json.loads(flat_file(scene).read_text())
    return len(flat["stiffness"]) or len(flat["mass"])


class Worker:
    def __init__(self, peer, scene):
        self.peer = peer
        if peer.family in NATIVE_FAMILIES:
            command = [NATIVE, scene_file(scene), peer.name]
        elif peer.family == "cannon":
            command = ["node", HERE / "cannon.mjs", flat_file(scene)]
        else:
            command = [MADE / "venv" / "bin" / "python", HERE / "worker.py", flat_file(scene), peer.name]
        if shutil.which("taskset"):
            command = ["taskset", "-c", CORE, *command]
        self.complaints = open(MADE / "complaints.txt", "w+")
        caches = {
            "NUMBA_CACHE_DIR": MADE / "numba",
            "WARP_CACHE_PATH": MADE / "warp",
            "TI_OFFLINE_CACHE_FILE_PATH": MADE / "taichi",
        }
        self.process = subprocess.Popen(
            [str(part) for part in command],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self.complaints,
            text=True,
            cwd=MADE,
            env=os.environ | ONE_THREAD | {name: str(path) for name, path in caches.items()},
        )
        self.answer()

    def run(self, setting, duration, state=False):
        """{"cpu": s, "position": [...]}"""
        try:
            self.process.stdin.write(json.dumps({"setting": setting, "duration": duration, "state": state}) + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass
        answer = self.answer()
        if "error" in answer:
            raise Failed(answer["error"])
        return answer

    def answer(self):
        readable, _, _ = select.select([self.process.stdout], [], [], PATIENCE)
        line = self.process.stdout.readline() if readable else None
        if line:
            return json.loads(line)
        why = f"no answer within {PATIENCE} s" if line is None else self.last_complaint()
        self.stop()
        raise Failed(why)

    def last_complaint(self):
        self.process.wait()
        self.complaints.seek(0)
        lines = [line.strip() for line in self.complaints.read().splitlines() if line.strip()]
        return lines[-1] if lines else f"it ended with code {self.process.returncode}"

    def stop(self):
        self.process.kill()
        self.process.wait()
