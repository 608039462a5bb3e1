// The live page: what is moved is run again, in slices so that the page stays alive, and drawn
// into the figures as it comes.

// Milliseconds that a run computes before it lets the page breathe, and before it is stopped.
const SLICE = 12;
const LONGEST = 2000;

class LivePage {
  constructor(machine, root) {
    Object.assign(this, { machine, root, turn: 0 });
    const { known } = machine;
    const linked = document.querySelectorAll(`.chart[data-link="${known.name}"]`);
    const isOfOutputs = (chart) => chart.closest("figure").id.startsWith(`${known.name}-outputs-`);
    this.charts = [...linked].filter(isOfOutputs).map((chart) => new Chart(chart));
    this.state = document.getElementById("live-state");
    this.command = document.getElementById("live-command");
    this.sliders = [...root.querySelectorAll(".slider")].map((slider) => new Slider(slider, () => this.run()));
    document.getElementById("live-reset").addEventListener("click", () => {
      this.sliders.forEach((slider) => slider.reset());
      this.run();
    });
    root.hidden = false;
    this.tell("");
  }

  // Runs with what the sliders say; a later call takes over from an earlier one.
  async run() {
    const turn = ++this.turn;
    const { known } = this.machine;
    const moved = this.sliders.filter((slider) => slider.value !== slider.original);
    this.tellCommand(moved);
    if (moved.length === 0) {
      this.charts.forEach((chart) => chart.show(null));
      this.tell("");
      return;
    }
    const { from, until, points } = known.run;
    const wanted = { parameters: known.parameters.map(({ value }) => value), from, until, points };
    for (const { key, value } of moved) {
      if (key === "until") wanted.until = value;
      else wanted.parameters[Number(key)] = value;
    }
    if (!(wanted.until > from)) {
      this.tell(`A run from ${shown(from)} s cannot end at ${shown(wanted.until)} s.`, true);
      return;
    }
    const run = new Run(this.machine, wanted);
    const steps = run.steps();
    let spent = 0;
    for (let isDone = false; !isDone;) {
      const begin = performance.now();
      let now = begin;
      while (!isDone && now - begin < SLICE) {
        isDone = steps.next().done;
        now = performance.now();
      }
      spent += now - begin;
      if (!isDone && spent > LONGEST) {
        run.stopped = new Stopped(run.times[Math.max(0, run.taken - 1)], `longer than ${LONGEST / 1000} s of computing`);
        break;
      }
      if (!isDone) {
        await new Promise((resolve) => setTimeout(resolve));
        if (turn !== this.turn) return;
      }
    }
    this.charts.forEach((chart) => chart.show(run));
    this.tellRun(run, spent);
  }

  tellRun(run, spent) {
    const { work, stopped } = run;
    const count = (number, what) => `${number} ${what}${number === 1 ? "" : "s"}`;
    const counts = [count(work.steps, "step"), `${work.rejected} rejected`, count(work.rates, "rate")];
    if (work.jacobians) counts.push(count(work.jacobians, "Jacobian"));
    if (work.switches) counts.push(count(work.switches, "switch").replace("switchs", "switches"));
    const did = `${run.methods()}: ${counts.join(", ")}, ${shown(spent, 2)} ms.`;
    if (stopped) this.tell(`Stopped at ${shown(stopped.time, 4)} s: ${stopped.message}. ${did}`, true);
    else this.tell(did);
  }

  tell(text, isTrouble = false) {
    this.state.textContent = text;
    this.state.className = isTrouble ? "warning" : "muted";
  }

  // The same run outside of the page.
  tellCommand(moved) {
    const words = moved.map(({ key, value }) =>
      key === "until" ? `--until ${value}` : `--set ${this.machine.known.parameters[Number(key)].name}=${value}`);
    this.command.textContent = words.length ? `${this.machine.known.command} ${words.join(" ")}` : "";
  }
}

Machine.of(JSON.parse(document.getElementById("live-known").textContent)).then(
  (machine) => { new LivePage(machine, document.getElementById("live")); },
  (error) => {
    const said = document.createElement("p");
    said.className = "muted";
    said.textContent = `The machine cannot be run in this browser: ${error.message}`;
    document.getElementById("live").before(said);
  },
);
