// Tables of the run, which follow it; what they said of the stored run comes back with it.

class Tables {
  constructor() {
    this.rows = [...document.querySelectorAll("tr[data-output]")].map((row) => ({ row, stored: row.innerHTML }));
    this.events = document.getElementById("run-events");
    this.storedEvents = this.events?.innerHTML;
    this.ofStored = document.querySelectorAll("[data-of-stored]");
  }

  show(run) {
    this.ofStored.forEach((note) => { note.hidden = !run; });
    for (const { row, stored } of this.rows) {
      row.innerHTML = stored;
      const values = run?.column(row.dataset.output)?.subarray(0, run.taken);
      if (values) this.fill(row, values, run.times);
    }
    if (!this.events) return;
    this.events.innerHTML = this.storedEvents;
    if (run) this.events.replaceChildren(tableOf(happened(run.switches)));
  }

  // First, last, least and greatest of an output.
  fill(row, values, times) {
    const cells = row.querySelectorAll(".number");
    if (!values.some(Number.isFinite)) {
      cells.forEach((cell) => { cell.textContent = "none"; });
      return;
    }
    const [low, high] = extent([values]);
    // As in the stored table, rounding is zero.
    const least = 1e-14 * Math.max(Math.abs(low), Math.abs(high));
    const rid = (value) => (Math.abs(value) < least ? 0 : value);
    [values[0], values[values.length - 1]].forEach((value, index) => {
      cells[index].textContent = shown(rid(value));
      // All its digits, where one points at it.
      cells[index].title = String(value);
    });
    [low, high].forEach((value, index) => {
      const at = document.createElement("div");
      at.className = "muted";
      at.textContent = `at ${shown(times[values.indexOf(value)], 4)} s`;
      cells[2 + index].replaceChildren(shown(rid(value)), at);
    });
  }
}

// How often each event happened, and when first and last.
function happened(switches) {
  const events = new Map();
  for (const { event, time } of switches) {
    const known = events.get(event);
    events.set(event, known ? { ...known, count: known.count + 1, last: time } : { count: 1, first: time, last: time });
  }
  return events;
}

function tableOf(events) {
  const scroll = document.createElement("div");
  scroll.className = "scroll";
  const table = scroll.appendChild(document.createElement("table"));
  const row = (cells, name) => {
    const tr = table.insertRow();
    cells.forEach((content, index) => {
      const cell = tr.appendChild(document.createElement(name));
      if (index > 0) cell.className = "number";
      cell.append(content);
    });
  };
  row(["Event", "Times", "First [s]", "Last [s]"], "th");
  for (const [event, { count, first, last }] of events) {
    const name = document.createElement("code");
    name.textContent = event;
    row([name, count, shown(first, 6), shown(last, 6)], "td");
  }
  if (events.size === 0) row(["no event happened", "", "", ""], "td");
  return scroll;
}
