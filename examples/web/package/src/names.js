// The numbers of what is chosen by name.

export const STEPPERS = [
  "explicit-euler", "semi-implicit-euler", "implicit-euler", "implicit-euler-linearised", "velocity-verlet", "rk4",
  "blanes-moan-s6", "dop853", "dormand-prince-rkn8", "implicit-midpoint", "tr-bdf2", "auto",
];
export const COLLISIONS = ["reflect", "project", "time-of-impact"];
export const HOLDS = ["free", "pinned", "kinematic"];
