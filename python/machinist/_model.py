"""Machines: loading from specs, model files or by name, and running."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _derive, _machinist
from ._cycle import Branch, Cycle, Sections, branch, cycle, sections
from ._fit import Fit, measured_runs
from ._held import Held
from ._linear import Modes, Response
from ._run import Run
from ._scatter import Scatter, scatter
from ._sensitivities import Sensitivities
from ._state_space import LinearPiece, StateSpace
from ._stepper import Stepper
from ._sweep import Sweep, sweep
from ._tables import Event, Parameter, Quantity, State, Table, html, text
from .errors import InputError, ModelFileError, StoppedError, UnknownNameError

if TYPE_CHECKING:
    import scipy.sparse

Array = NDArray[np.float64]
#: Some parameters by name, or all in order.
Parameters = Mapping[str, float] | ArrayLike

#: Machines loaded in this process, by source and field discretization.
_LOADED: dict[tuple[Any, ...], Model] = {}


def load(
    scene: str | os.PathLike[str],
    *,
    elements: int | None = None,
    order: int | None = None,
    keep_all: bool = False,
) -> Model:
    """Load a machine from a spec (`drive.toml`), a model file (`drive.model`) or by the name of a
    scene (`saw_gin`, or one of the machines that `machinist list` shows).

    A spec is derived in this process. Derived models are cached, as by the program `machinist`.

    :param elements: number of elements that discretize the fields of the scene, if any.
    :param order: order of these elements.
    :param keep_all: keep all parts of a spec, including those that no output needs.
    :raises UnknownNameError: no scene has this name.
    :raises SpecError: the spec is invalid; gives file, line and hint of each mistake.
    :raises ModelFileError: the file is damaged or has another version.
    """
    name = os.fspath(scene)
    if not isinstance(name, str):
        raise InputError(f"a scene is a name or a path, not {scene!r}")
    is_path = Path(name).suffix in {".toml", ".model"} or os.sep in name or "/" in name
    if not is_path:
        if not keep_all and name in _machinist.built_in_names():
            return _loaded(("built in", name), elements, order, (False, name))
        found = _derive.derived(name=name, keep_all=keep_all)
        if found is None:
            raise _unknown(name)
        return _loaded(("model", found), elements, order, (False, name))
    content, is_model = _derive.read(Path(name), _machinist.MODEL_MARK)
    if is_model or Path(name).suffix == ".model":
        try:
            return _loaded(("model", content), elements, order)
        except ModelFileError as error:
            raise ModelFileError(error.message, file=name, hint=_again(error)) from None
    derived = _derive.derived(file=Path(name), keep_all=keep_all)
    return _loaded(("model", derived), elements, order, (True, os.path.abspath(name)))


def _unknown(name: str) -> UnknownNameError:
    known = [*_machinist.built_in_names(), *_machinist.machine_names()]
    likely = _machinist.did_you_mean(name, known)
    hint = None if likely else (
        f"built in are {', '.join(known)}; names of files end in .toml or .model"
    )
    return UnknownNameError(f"there is no scene `{name}`{likely}", hint=hint)


def _again(error: ModelFileError) -> str:
    if "version" in error.message:
        return "program and package are to be of one version; `machinist compile` makes it again"
    return "`machinist compile` makes it again from its spec"


def _loaded(
    payload: tuple[str, Any],
    elements: int | None,
    order: int | None,
    spec: tuple[bool, str] | None = None,
) -> Model:
    """Machine of a payload, created once per process. `spec` is the spec it is from: whether it is
    a file, and its path or name."""
    key = (*payload, elements, order, spec)
    if key not in _LOADED:
        kind, content = payload
        if kind == "model":
            machine = _machinist.Machine.of_model(content, elements, order)
        else:
            found = _machinist.Machine.built_in(content, elements, order)
            if found is None:
                raise _unknown(content)
            machine = found
        _LOADED[key] = Model(machine, key)
    return _LOADED[key]


def _restored(key: tuple[Any, ...]) -> Model:
    return _loaded(key[:2], *key[2:])


class Model:
    """A machine ready to run, returned by :func:`load`. Picklable and thread-safe."""

    def __init__(self, machine: _machinist.Machine, key: tuple[Any, ...]) -> None:
        self._machine = machine
        self._key = key
        #: Spec with the distributions of parameters: whether it is a file, and its path or name.
        self._spec: tuple[bool, str] | None = key[4]

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (self._key,))

    @cached_property
    def _told(self) -> dict[str, Any]:
        return self._machine.describe()

    @property
    def name(self) -> str:
        """Name of the scene."""
        return self._told["name"]

    @property
    def title(self) -> str:
        """One-line description of the scene."""
        return self._told["title"]

    @property
    def running(self) -> str:
        """Execution mode: emitted code, JIT-compiled (by Cranelift) or interpreted."""
        return self._told["running"]

    @property
    def fingerprint(self) -> str:
        """SHA-256 of the model file; for a built-in scene, of its names and computed values."""
        return self._machine.fingerprint

    @property
    def defaults(self) -> dict[str, Any]:
        """Default run settings of the scene: start, until, points, rtol, method."""
        return dict(self._told["run"])

    @cached_property
    def parameters(self) -> Table[Parameter]:
        """Parameters with values, units, descriptions and the flag `tunable`."""
        rows = [
            Parameter(name, unit, doc, value, tunable)
            for (name, unit, doc), value, tunable in self._told["parameters"]
        ]
        return Table(self.name, "parameter", rows, ("name", "value", "unit", "tunable", "doc"))

    @cached_property
    def states(self) -> Table[State]:
        """Entries of the state y = [q, q', z]."""
        rows = [
            State(name, unit, doc, kind, scale)
            for (name, unit, doc), kind, scale in self._told["states"]
        ]
        return Table(self.name, "state", rows, ("name", "unit", "kind", "doc"))

    @cached_property
    def outputs(self) -> Table[Quantity]:
        """Outputs of the scene."""
        rows = [Quantity(*row) for row in self._told["outputs"]]
        return Table(self.name, "output", rows, ("name", "unit", "doc"))

    @cached_property
    def events(self) -> Table[Event]:
        """Events of the scene."""
        rows = [Event(name, "", doc) for name, doc in self._told["events"]]
        return Table(self.name, "event", rows, ("name", "doc"))

    @cached_property
    def constraints(self) -> Table[Quantity]:
        """Constraints on the coordinates."""
        rows = [Quantity(*row) for row in self._told["constraints"]]
        return Table(self.name, "constraint", rows, ("name", "unit", "doc"))

    def p(self, values: Mapping[str, float] | None = None) -> Array:
        """Vector of all parameters in order: scene values, replaced by `values` where given."""
        all_of_them = self._machine.defaults()
        for name, value in (values or {}).items():
            all_of_them[self.parameters.index(name)] = value
        return all_of_them

    def rate(
        self, t: float, y: ArrayLike, p: ArrayLike | None = None, out: Array | None = None
    ) -> Array:
        """Rate y' = f(t, y, p), with the signature of SciPy's `solve_ivp`.

        Comparisons of the spec are evaluated at every call; :meth:`held` holds them instead. It
        does not handle events: modes keep their values in `y`. Constraints hold at acceleration
        level only, so positions drift.

        :param p: all parameters in order, see :meth:`p`; default: the scene's values.
        :param out: array to fill and return instead of a new one.
        """
        return self._machine.rate(t, y, p, out)

    def jacobian(
        self, t: float, y: ArrayLike, p: ArrayLike | None = None, out: Array | None = None
    ) -> Array:
        """Exact dense Jacobian dy'/dy; for its pattern see :attr:`jacobian_sparsity`."""
        return self._machine.jacobian(t, y, p, out)

    def branches(self, t: float, y: ArrayLike, p: ArrayLike | None = None) -> Array:
        """Branch of each comparison and integer of the spec at a state, for :meth:`held`.

        It is -inf where a comparison's guard is below zero and inf elsewhere, or an integer.
        """
        return self._machine.branches(t, y, p)

    def held(self, branches: ArrayLike) -> Held:
        """The machine on these :meth:`branches`, with a smooth rate for solvers that find the ends
        of branches as events.

        :raises ShapeError: the number of branches is another.
        """
        held = Held(self._machine, np.array(branches, dtype=float))
        held.margins(0.0, np.zeros(self._machine.states))
        return held

    def outputs_at(
        self, t: float, y: ArrayLike, p: ArrayLike | None = None, out: Array | None = None
    ) -> Array:
        """Outputs at a given state, in the order of :attr:`outputs`."""
        return self._machine.outputs(t, y, p, out)

    @property
    def jacobian_sparsity(self) -> scipy.sparse.coo_array:
        """Sparsity pattern of dy'/dy for SciPy's solvers; requires SciPy."""
        import scipy.sparse

        rows, columns = self._machine.jacobian_pattern()
        shape = (self._machine.states,) * 2
        return scipy.sparse.coo_array((np.ones(len(rows)), (rows, columns)), shape=shape)

    def initial_state(self, p: ArrayLike | None = None) -> Array:
        """Initial state of the scene; contains guesses where constraints determine values."""
        return self._machine.initial_state(p)

    def discontinuities(self, p: ArrayLike | None = None) -> Array:
        """Times at which the rate is discontinuous [s]; restart the solver there."""
        return self._machine.discontinuities(p)

    def simulate(
        self,
        *,
        until: float | None = None,
        parameters: Parameters | None = None,
        initial: Mapping[str, float] | ArrayLike | None = None,
        start: float | None = None,
        points: int | None = None,
        times: ArrayLike | None = None,
        rtol: float | None = None,
        atol: ArrayLike | None = None,
        method: str | None = None,
        auto: str | None = None,
        max_steps: int | None = None,
        equilibrium: bool | None = None,
        energy_balance: bool = False,
        constant_energy: bool = False,
        error: bool = False,
        accuracy: float | None = None,
        sensitivities: Sequence[str] = (),
        time_limit: float | None = None,
        on_stop: Literal["raise", "keep"] = "raise",
    ) -> Run:
        """Simulate the machine. Omitted settings take the scene's values. Releases the GIL.

        :param until: end time [s]; `start` is the start time.
        :param parameters: some by name, or all in order; SI units.
        :param initial: initial values of states by name, or the complete state.
        :param points: number of equally spaced output times; `times` gives the times instead.
        :param rtol: relative step tolerance; `atol`: absolute tolerances in the states' units.
        :param method: integration method, see :func:`machinist.methods`.
        :param auto: choices of the method auto, such as "explicit=tsit5,implicit=radau".
        :param equilibrium: whether to start in the equilibrium near the initial state.
        :param energy_balance: integrate the power balance along with the run.
        :param constant_energy: project a conservative machine with constraints onto its energy
            after each step.
        :param error: repeat the run at a tighter tolerance to estimate `run.error`.
        :param accuracy: tighten `rtol` until the estimated error of every column is at most this
            fraction of its largest value; a note gives the reason if this fails.
        :param sensitivities: parameters, or states for their initial values, to differentiate by.
        :param time_limit: limit of the computing time [s].
        :param on_stop: if the run stops early, "raise" a :class:`StoppedError` that contains the
            partial run, or "keep" the partial run and set `run.stopped`.
        """
        if on_stop not in ("raise", "keep"):
            raise InputError(f"on_stop is `raise` or `keep`, not {on_stop!r}")
        settings = _given(
            until=until, parameters=parameters, initial=initial, start=start, points=points,
            times=times, rtol=rtol, atol=atol, method=method, auto=auto, max_steps=max_steps,
            equilibrium=equilibrium, time_limit=time_limit, accuracy=accuracy,
        )  # fmt: skip
        if energy_balance:
            settings["energy_balance"] = True
        if constant_energy:
            settings["constant_energy"] = True
        if error:
            settings["error"] = True
        if sensitivities:
            settings["sensitivities"] = _names(sensitivities)
        native, stopped = self._machine.simulate(settings)
        run = None if native is None else Run(native)
        if run is not None and (stopped is None or on_stop == "keep"):
            return run
        assert isinstance(stopped, StoppedError), "a run that is not there has stopped"
        stopped.run = run
        raise stopped

    def start(
        self,
        *,
        until: float | None = None,
        parameters: Parameters | None = None,
        initial: Mapping[str, float] | ArrayLike | None = None,
        start: float | None = None,
        rtol: float | None = None,
        atol: ArrayLike | None = None,
        method: str | None = None,
        auto: str | None = None,
        max_steps: int | None = None,
        equilibrium: bool | None = None,
        time_limit: float | None = None,
    ) -> Stepper:
        """Start a run that is advanced piece by piece: by a controller, a co-simulation, an
        environment for reinforcement learning, an estimator.

        Settings are those of :meth:`simulate`, with the same start. `max_steps` and `time_limit`
        are limits of each piece.

        :param until: time that the run is expected to end [s]; default: after the scene's duration.
            It sets the scale for what counts as a short time. The run may go on after it.
        :raises InputError: as by :meth:`simulate`.
        """
        settings = _given(
            until=until, parameters=parameters, initial=initial, start=start, rtol=rtol, atol=atol,
            method=method, auto=auto, max_steps=max_steps, equilibrium=equilibrium,
            time_limit=time_limit,
        )  # fmt: skip
        return Stepper(self, _machinist.Stepper(self._machine, settings))

    def restore(self, data: bytes) -> Stepper:
        """The run from the bytes of :meth:`Stepper.save`, in any process; it continues bit for bit.

        :raises InputError: the bytes are damaged, or of another machine or version.
        """
        return Stepper(self, _machinist.Stepper.restore(self._machine, data))

    def modes(
        self,
        *,
        at: str | float = "equilibrium",
        slopes: Sequence[str] = (),
        parameters: Parameters | None = None,
        initial: Mapping[str, float] | ArrayLike | None = None,
        **settings: Any,
    ) -> Modes:
        """Eigenmodes of the linearization: frequencies, damping, mode shapes.

        :param at: "equilibrium" (the one near the end of the run), "initial" or a time [s].
        :param slopes: parameters by which eigenvalues are differentiated.
        :param settings: settings of the run to the operating point, as for :meth:`simulate`.
        """
        place = _place(at)
        given = _given(parameters=parameters, initial=initial, **settings)
        told = _machinist.modes(self._machine, given, place, _names(slopes))
        return Modes(self.name, place, told)

    def response(
        self,
        input: str,
        output: str,
        *,
        frequencies: ArrayLike | None = None,
        points: int = 401,
        at: str | float = "equilibrium",
        parameters: Parameters | None = None,
        initial: Mapping[str, float] | ArrayLike | None = None,
        **settings: Any,
    ) -> Response:
        """Frequency response of an output or a state.

        :param input: a parameter, or a coordinate for a force on it.
        :param frequencies: angular frequencies [rad/s]; default: `points` frequencies around the
            machine's own.
        :param at: operating point; `at` and `settings` as for :meth:`modes`.
        """
        given = _given(parameters=parameters, initial=initial, **settings)
        told = _machinist.response(
            self._machine, given, _place(at), (input, output), frequencies, points
        )
        return Response(self.title, told)

    def linearize(
        self,
        inputs: str | Sequence[str],
        outputs: str | Sequence[str],
        *,
        sample: float | None = None,
        hold: Literal["zoh", "tustin"] = "zoh",
        at: str | float = "equilibrium",
        parameters: Parameters | None = None,
        initial: Mapping[str, float] | ArrayLike | None = None,
        **settings: Any,
    ) -> StateSpace:
        """State-space model x' = A x + B u, y = C x + D u in deviations from an operating point.

        :param inputs: parameters, or coordinates for a force on each.
        :param outputs: outputs or states.
        :param sample: period of samples [s]; `hold` is "zoh" (inputs constant between samples,
            exact) or "tustin".
        :param at: operating point; `at` and `settings` as for :meth:`modes`.
        """
        given = _given(parameters=parameters, initial=initial, **settings)
        sampling = None if sample is None else (float(sample), hold)
        signals = (_names(inputs), _names(outputs))
        place = _place(at)
        told = _machinist.state_space(self._machine, given, place, signals, sampling)
        return StateSpace(self.name, place, told)

    def linearize_along(
        self,
        inputs: str | Sequence[str],
        outputs: str | Sequence[str],
        times: ArrayLike,
        *,
        parameters: Parameters | None = None,
        initial: Mapping[str, float] | ArrayLike | None = None,
        **settings: Any,
    ) -> list[LinearPiece]:
        """Linear models A(t), B(t), C(t), D(t) about the motion of a run, at some times [s].

        A piece ends where a mode changes, as a brake closes: there the order of x may change.

        :param inputs: parameters, or coordinates for a force on each.
        :param outputs: outputs or states.
        """
        given = _given(parameters=parameters, initial=initial, **settings)
        signals = (_names(inputs), _names(outputs))
        told = _machinist.pieces_along(self._machine, given, signals, times)
        return [LinearPiece(piece) for piece in told]

    def cycle(self, period: str | float | None = None, **options: Any) -> Cycle:
        """Find a periodic motion with its Floquet multipliers, see :func:`machinist.cycle`."""
        return cycle(self, period, **options)

    def branch(self, over: str, start_value: float, end_value: float, **options: Any) -> Branch:
        """Follow a periodic motion over a parameter, see :func:`machinist.branch`."""
        return branch(self, over, start_value, end_value, **options)

    def sections(self, over: str, values: ArrayLike, **options: Any) -> Sections:
        """Keep values once in a period over a parameter, see :func:`machinist.sections`."""
        return sections(self, over, values, **options)

    def sensitivities(
        self,
        parameters: Sequence[str] = (),
        outputs: Sequence[str] = (),
        *,
        given: Parameters | None = None,
        **settings: Any,
    ) -> Sensitivities:
        """Relative sensitivities of outputs to parameters, from exact derivatives along the run and
        through events.

        :param parameters: default: all nonzero parameters; those without derivatives are left out
            and listed in `left_out`.
        :param outputs: outputs or states; default: all outputs.
        :param given: parameter values, some by name or all in order.
        :param settings: settings of the run, as for :meth:`simulate`.
        """
        outputs = _names(outputs) or list(self.outputs) or list(self.states)
        for name in outputs:
            if name not in self.states:
                self.outputs.index(name)
        values = self.p(given) if isinstance(given, Mapping) or given is None else given
        by_name = dict(zip(self.parameters, np.asarray(values, dtype=float).tolist()))
        left_out = {}
        by = _names(parameters)
        for name in by:
            self.parameters.index(name)
        if not by:
            by = [name for name, value in by_name.items() if value != 0]
            zero = "is 0, so that no change of it is relative"
            left_out = {name: zero for name, value in by_name.items() if value == 0}
        while True:
            try:
                run = self.simulate(parameters=given, sensitivities=by, **settings)
                break
            except InputError as error:
                name, why = error.undifferentiable or ("", "")
                if parameters or name not in by:
                    raise
                by.remove(name)
                left_out[name] = why
        return Sensitivities(run, {name: by_name[name] for name in by}, outputs, left_out)

    def fit(
        self,
        data: Any,
        parameters: Sequence[str] | Mapping[str, tuple[float, float] | None],
        *,
        map: Mapping[str, str] | None = None,
        outputs: Sequence[str] = (),
        sigma: Mapping[str, float] | None = None,
        loss: Literal["squares", "huber"] = "squares",
        starts: int = 1,
        steps: int = 100,
        given: Parameters | None = None,
        **settings: Any,
    ) -> Fit:
        """Fit parameters or initial values of states to measured runs by least squares with exact
        derivatives.

        :param data: a DataFrame with a column or index `t` or `time` and columns named `name` or
            `name [unit]` after outputs or states; or a mapping of columns by name; or a list of
            such runs. NaN marks missing values.
        :param parameters: names, or names with bounds `{"coupling.stiffness": (1e3, 1e5)}`.
        :param map: `{column: output}` for columns with other names.
        :param outputs: use only these columns.
        :param sigma: standard deviations of the measurements; default: from the residuals.
        :param loss: "huber" reduces the weight of outliers.
        :param starts: number of starting points, spread within the bounds.
        :param steps: maximum number of steps of a search.
        :param given: values of parameters that are not fitted.
        :param settings: settings of the runs, as for :meth:`simulate`.
        :raises AnalysisError: the simulation fails at every starting point.
        """
        if loss not in ("squares", "huber"):
            raise InputError(f"loss is `squares` or `huber`, not {loss!r}")
        bounds = parameters if isinstance(parameters, Mapping) else {
            name: None for name in _names(parameters)
        }
        if not bounds:
            raise InputError("there is nothing to be fitted")
        runs = measured_runs(self, data, map or {}, _names(outputs))
        measured = {name for _, columns in runs for name, _ in columns}
        for name, value in (sigma or {}).items():
            if name not in measured:
                hint = _machinist.did_you_mean(name, sorted(measured))
                raise UnknownNameError(f"sigma of `{name}`: that is not measured{hint}")
            if not value > 0:
                raise InputError(f"sigma of `{name}` is {value}, not above 0")
        set_by = _given(parameters=given, **settings)
        asked = [(name, None if b is None else (b[0], b[1])) for name, b in bounds.items()]
        told = _machinist.fit(
            self._machine, set_by, asked, runs, list((sigma or {}).items()), loss == "huber",
            starts, steps,
        )  # fmt: skip
        return Fit(self, told, runs, set_by)

    def sweep(self, space: Any, **options: Any) -> Sweep:
        """Run many variants of the machine, see :func:`machinist.sweep`."""
        return sweep(self, space, **options)

    def scatter(self, of: Sequence[str] | str = (), **options: Any) -> Scatter:
        """Run the machine with parameters drawn from distributions, see :func:`machinist.scatter`."""
        return scatter(self, of, **options)

    def __repr__(self) -> str:
        return "\n".join([self._line(), *text(_HEADING, self._rows())])

    def _line(self) -> str:
        return f"{self.name}: {self.title} ({self.running})"

    def _rows(self) -> list[list[str]]:
        counted: list[tuple[str, Mapping[str, Any]]] = [
            ("states", self.states), ("parameters", self.parameters), ("outputs", self.outputs),
            ("events", self.events), ("constraints", self.constraints),
        ]  # fmt: skip
        return [[what, str(len(names)), _some(names)] for what, names in counted if names]

    def _repr_html_(self) -> str:
        return html(self._line(), _HEADING, self._rows())


_HEADING = ("", "number", "names")


def _place(at: str | float) -> str:
    """Operating point in the engine's notation."""
    return at if isinstance(at, str) else f"t={at!r}"


def _some(names: Mapping[str, Any]) -> str:
    most = 6
    shown = ", ".join(list(names)[:most])
    return f"{shown}, ..." if len(names) > most else shown


def _given(**settings: Any) -> dict[str, Any]:
    """Settings that are not None."""
    return {name: value for name, value in settings.items() if value is not None}


def _names(names: Sequence[str] | str) -> list[str]:
    """List of names; accepts a single name."""
    return [names] if isinstance(names, str) else list(names)
