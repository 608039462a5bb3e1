// Runs machines by the scripts of a live page, for the tests: lines of data from standard input, a
// line of JSON for each to standard output.
(async () => {
  const text = require("fs").readFileSync(0, "utf8");
  for (const line of text.split("\n").filter(Boolean)) {
    const known = { tracked: [], ...JSON.parse(line) };
    const machine = await Machine.of(known);
    const { from, until, points, times } = known.run;
    const parameters = known.parameters.map(({ value }) => value);
    const begin = performance.now();
    const run = new Run(machine, { parameters, from, until, points, times });
    const steps = run.steps();
    while (!steps.next().done);
    const { taken, switches, work, stopped } = run;
    const finite = (value) => (Number.isFinite(value) ? value : null);
    const outputs = run.outputs.map((values) => Array.from(values.subarray(0, taken), finite));
    const spent = performance.now() - begin;
    console.log(JSON.stringify({ times: Array.from(run.times.subarray(0, taken)), outputs, switches, work, spent,
      stopped: stopped ? `${stopped.time}: ${stopped.message}` : null }));
  }
})();
