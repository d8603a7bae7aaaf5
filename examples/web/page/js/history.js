// The energy of a side over the last while.

/** As many are drawn at most. */
const ROWS = 500;

export class History {
  rows = [];

  constructor(span) {
    this.span = span;
  }

  /** At a time in s, of a ledger in J. */
  add(time, ledger) {
    if (Number.isNaN(ledger.total)) return;
    const last = this.rows.at(-1);
    if (last && time < last.time) this.rows = [];
    // In slow motion not every picture is a row.
    const isNear = this.rows.length > 1 && last.time - this.rows.at(-2).time < this.span / ROWS;
    if (last && (time === last.time || isNear)) this.rows.pop();
    this.rows.push({ time, ...ledger });
    const from = time - this.span;
    if (this.rows.length > 16 && this.rows[8].time < from) this.rows.splice(0, 8);
  }
}
