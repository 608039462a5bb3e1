// The live page: what is moved is run again, in slices so that the page stays alive, and drawn
// into the figures as it comes.

// Milliseconds that a run computes before it lets the page breathe, and before it is stopped.
const SLICE = 12;
const LONGEST = 2000;

class LivePage {
  constructor(machine, root) {
    Object.assign(this, { machine, root, turn: 0, pending: null });
    const { known } = machine;
    const linked = document.querySelectorAll(`.chart[data-link="${known.name}"]`);
    const isOfOutputs = (chart) => chart.closest("figure").id.startsWith(`${known.name}-outputs-`);
    this.charts = [...linked].filter(isOfOutputs).map((chart) => new Chart(chart));
    this.tables = new Tables();
    this.state = document.getElementById("live-state");
    this.command = document.getElementById("live-command");
    this.sliders = [...root.querySelectorAll(".slider")].map((slider) => new Slider(slider, () => this.run()));
    document.getElementById("live-reset").addEventListener("click", () => {
      this.sliders.forEach((slider) => slider.reset());
      this.run();
    });
    const motion = document.getElementById("live-motion");
    this.motion = motion && new Motion(this, motion);
    root.hidden = false;
    this.tell("");
    // Nobody waits for the first run then, which is slower than those after it.
    (globalThis.requestIdleCallback ?? setTimeout)(() => this.latest());
  }

  // Shows what the sliders say, or what is wrong with it.
  async run() {
    const wrong = this.sliders.find((slider) => !slider.isValid);
    if (wrong) {
      this.turn++;
      this.tell(`${wrong.name} takes a number.`, true);
      return;
    }
    try {
      await this.runMoved();
    } catch (error) {
      this.tell(`The run failed: ${error.message}`, true);
    }
  }

  // The stored run where nothing is moved.
  async runMoved() {
    const moved = this.sliders.filter((slider) => slider.value !== slider.original);
    this.tellCommand(moved);
    if (moved.length === 0) {
      this.turn++;
      this.show(null);
      this.tell("");
      // The motion follows, if it has begun.
      if (this.motion?.stored) this.motion.show(this.motion.stored);
      else if (this.motion?.run) await this.simulate();
      return;
    }
    const found = await this.simulate();
    if (!found) return;
    this.show(found.run);
    this.tellRun(found.run, found.spent);
  }

  show(run) {
    for (const shows of [...this.charts, this.tables]) shows.show(run);
    this.motion?.mark();
  }

  // The run that is under way, else one by the sliders.
  latest() {
    return this.pending ?? this.simulate();
  }

  simulate() {
    const pending = this.simulated().finally(() => {
      if (this.pending === pending) this.pending = null;
    });
    this.pending = pending;
    return pending;
  }

  // A run by the sliders, for the motion too; nothing if there can be none, or if a later one
  // has begun.
  async simulated() {
    const { known } = this.machine;
    const { from, until, points, times } = known.run;
    const parameters = known.parameters.map(({ value }) => value);
    const wanted = { parameters, from, until, points, times };
    for (const { key, value } of this.sliders) {
      if (key === "until") {
        // Times of the scene are for its own end.
        if (value !== until) wanted.times = undefined;
        wanted.until = value;
      }
      else wanted.parameters[Number(key)] = value;
    }
    if (!(wanted.until > from)) {
      this.tell(`A run from ${shown(from)} s cannot end at ${shown(wanted.until)} s.`, true);
      return null;
    }
    const turn = ++this.turn;
    const run = new Run(this.machine, wanted);
    const spent = await this.finish(run, () => turn === this.turn);
    if (spent === null) return null;
    // The drawing in space has the stored run.
    const isMoved = this.sliders.some((slider) => slider.value !== slider.original);
    if (run.taken > 1 && (isMoved || !this.motion?.stored)) this.motion?.show(run);
    return { run, spent };
  }

  // Takes the steps of a run, in slices; the milliseconds it took, nothing if it is no longer
  // wanted.
  async finish(run, isWanted) {
    const steps = run.steps();
    let spent = 0;
    for (;;) {
      const begin = performance.now();
      let [now, isDone] = [begin, false];
      while (!isDone && now - begin < SLICE) {
        isDone = steps.next().done;
        now = performance.now();
      }
      spent += now - begin;
      if (isDone) return spent;
      if (spent > LONGEST) {
        const reached = run.times[Math.max(0, run.taken - 1)];
        run.stopped = new Stopped(reached, `it takes longer than ${LONGEST / 1000} s to compute`);
        return spent;
      }
      await new Promise((resolve) => { setTimeout(resolve); });
      if (ending.signal.aborted || !isWanted()) return null;
    }
  }

  tellRun(run, spent) {
    const { work, stopped } = run;
    const count = (number, what) => `${number} ${what}${number === 1 ? "" : "s"}`;
    const counts = [count(work.steps, "step"), `${work.rejected} rejected`, count(work.rates, "rate")];
    if (work.jacobians) counts.push(count(work.jacobians, "Jacobian"));
    if (work.switches) counts.push(count(work.switches, "switch").replace("switchs", "switches"));
    const did = `${run.methods()}: ${counts.join(", ")}, ${shown(spent, 2)} ms.`;
    const isNone = (name) => run.column(name).subarray(0, run.taken).some((value) => !Number.isFinite(value));
    const none = this.machine.known.outputs.filter(isNone);
    if (none.length && !stopped) this.tell(`No number at some times: ${none.join(", ")}. ${did}`, true);
    else if (stopped) this.tell(`Stopped at ${shown(stopped.time, 4)} s: ${stopped.message}. ${did}`, true);
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

// A page that is served ends its machine before it starts the next one.
const ending = new AbortController();
document.addEventListener("machinist:live-ends", () => ending.abort(), { once: true });

// A machine that moves as in the stored run.
class StillPage {
  constructor(known) {
    this.machine = { known };
    this.charts = [];
    this.motion = new Motion(this, document.getElementById("live-motion"));
  }

  async latest() {}
}

const ofPage = JSON.parse(document.getElementById("live-known").textContent);
ofPage.tracked = [...new Set([...tracked(ofPage.moving), ...(ofPage.space?.entries ?? [])])];
if (!ofPage.module) new StillPage(ofPage);
else Machine.of(ofPage).then(
  (machine) => {
    if (!ending.signal.aborted) new LivePage(machine, document.getElementById("live"));
  },
  (error) => {
    if (ending.signal.aborted) return;
    const said = document.createElement("p");
    said.className = "muted";
    said.textContent = `The machine cannot be run in this browser: ${error.message}`;
    document.getElementById("live").before(said);
  },
);
