// The energy of a side over the last while.

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
    if (last && time === last.time) this.rows.pop();
    this.rows.push({ time, ...ledger });
    const from = time - this.span;
    if (this.rows.length > 16 && this.rows[8].time < from) this.rows.splice(0, 8);
  }
}
