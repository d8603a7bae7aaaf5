// The steppers by name, and what is known of them.

export const STEPPERS = [
  { name: "explicit-euler", title: "explicit Euler", kind: "explicit", order: 1 },
  { name: "semi-implicit-euler", title: "semi-implicit Euler", kind: "explicit", order: 1 },
  { name: "implicit-euler", title: "implicit Euler", kind: "implicit", order: 1, dampsByItself: true },
  { name: "implicit-euler-linearised", title: "implicit Euler, linearised", kind: "implicit", order: 1, dampsByItself: true },
  { name: "velocity-verlet", title: "velocity Verlet", kind: "explicit", order: 2 },
  { name: "implicit-midpoint", title: "implicit midpoint", kind: "implicit", order: 2 },
  { name: "tr-bdf2", title: "TR-BDF2", kind: "implicit", order: 2, dampsByItself: true },
  { name: "rk4", title: "Runge-Kutta 4", kind: "explicit", order: 4 },
  { name: "blanes-moan-s6", title: "Blanes-Moan S6", kind: "explicit", order: 4 },
  { name: "dop853", title: "DOP853", kind: "explicit", order: 8 },
  { name: "dormand-prince-rkn8", title: "Dormand-Prince RKN8", kind: "explicit", order: 8, undampedOnly: true },
  { name: "auto", title: "auto", kind: "auto" },
];

export const DESKTOP = "desktop";

export const stepperOf = (name) =>
  STEPPERS.find((stepper) => stepper.name === name) ?? { name, title: "the desktop's run", kind: "desktop" };
