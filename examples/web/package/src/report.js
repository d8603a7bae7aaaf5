// What steps tell, read from where the module has written it.

/** Bytes of a report and of a ledger. */
export const REPORT = 56;
export const LEDGER = 64;

export function readReport(buffer, address) {
  const view = new DataView(buffer, address, REPORT);
  const word = (place) => view.getUint32(16 + 4 * place, true);
  return {
    time: view.getFloat64(0, true),
    residual: view.getFloat64(8, true),
    steps: word(0),
    converged: word(1) === 1,
    iterations: word(2),
    linearIterations: word(3),
    factorisations: word(4),
    forceEvaluations: word(5),
    hits: word(6),
    capped: word(7),
    degenerateSprings: word(8),
  };
}

/** What steps and those after them tell. */
export function both(first, later) {
  if (first === undefined) return later;
  const sum = (key) => first[key] + later[key];
  return {
    time: later.time,
    residual: Math.max(first.residual, later.residual),
    steps: sum("steps"),
    converged: first.converged && later.converged,
    iterations: sum("iterations"),
    linearIterations: sum("linearIterations"),
    factorisations: sum("factorisations"),
    forceEvaluations: sum("forceEvaluations"),
    hits: sum("hits"),
    capped: sum("capped"),
    degenerateSprings: later.degenerateSprings,
  };
}

export function readLedger(buffer, address) {
  const view = new DataView(buffer, address, LEDGER);
  const energy = (place) => view.getFloat64(8 * place, true);
  const [kinetic, elastic, gravitational] = [energy(0), energy(1), energy(2)];
  return {
    kinetic,
    elastic,
    gravitational,
    total: kinetic + elastic + gravitational,
    lostToDamping: energy(3),
    lostInImpacts: energy(4),
    workOfPins: energy(5),
    openedWith: energy(6),
    remainder: energy(7),
  };
}
