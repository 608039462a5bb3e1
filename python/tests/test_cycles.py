"""Periodic motions and branches, compared with closed forms and with runs."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import SPECS

import machinist

# Block on a hard spring, x'' + 0.1 x' + x + x^3 = 0.3 cos(w t).
DUFFING = """
[scene]
name = "duffing"
[units.block]
unit = "block"
[outputs]
x = "block.x"
[run]
until = 200.0
points = 2
rtol = 1e-11
method = "dop853"
[define.block.coordinates.x]
unit = "m"
velocity = "v"
[define.block.parameters]
damping = { value = 0.1, unit = "N s/m" }
force = { value = 0.3, unit = "N" }
frequency = { value = 0.6, unit = "rad/s" }
[define.block.energy]
kinetic = "1 [kg]*v^2/2"
potential = "1 [N/m]*x^2/2 + 1 [N/m^3]*x^4/4"
dissipation = "damping*v^2/2"
[[define.block.forces]]
coordinate = "x"
expression = "force*cos(frequency*t)"
"""

# Rotor with an eccentric mass, driven: phi'' = 2 - 0.2 phi' - 3 sin(phi).
ROTOR = """
[scene]
name = "eccentric"
[units.rotor]
unit = "rotor"
[initial]
"rotor.omega" = 10.0
[outputs]
speed = "rotor.omega"
angle = "rotor.phi"
[run]
until = 60.0
points = 2
rtol = 1e-11
method = "dop853"
[define.rotor.coordinates.phi]
unit = "rad"
velocity = "omega"
[define.rotor.parameters]
torque = { value = 2.0, unit = "N m" }
[define.rotor.energy]
kinetic = "1 [kg m^2]*omega^2/2"
potential = "-3 [N m]*cos(phi)"
dissipation = "0.2 [N m s/rad]*omega^2/2"
[[define.rotor.forces]]
coordinate = "phi"
expression = "torque"
"""


@pytest.fixture(scope="module")
def duffing(tmp_path_factory) -> machinist.Model:
    file = tmp_path_factory.mktemp("specs") / "duffing.toml"
    file.write_text(DUFFING)
    return machinist.load(file)


@pytest.fixture(scope="module")
def bouncing() -> machinist.Model:
    return machinist.load("bouncing_mass")


def test_a_bouncing_mass_doubles_its_period_where_the_closed_form_says(bouncing):
    branch = bouncing.branch(
        "amplitude", 1.7e-3, 3e-3, period="frequency", settle=2, points=101
    )
    assert branch.is_complete, branch.end
    flips = [point for point in branch.bifurcations if point.bifurcation == "flip"]
    # docs/book/src/cycles.md; tests/cycles.rs derives it from the impact map.
    assert [flip.value for flip in flips] == pytest.approx([2.66092371e-3], rel=1e-8)
    stable = [p.cycle.stability for p in branch if p.bifurcation is None]
    assert stable[0] == "stable" and stable[-1] == "unstable"
    assert branch.values[0] == 1.7e-3 and branch.values[-1] == 3e-3
    assert len(branch.amplitudes("height")) == len(branch)
    assert "flip" in repr(branch)


def test_branches_of_twice_the_period_begin_at_flips(bouncing):
    branch = bouncing.branch(
        "amplitude", 1.7e-3, 3.05e-3, period="frequency", settle=2, points=101, doublings=2
    )
    # docs/book/src/cycles.md; tests/cycles.rs has the flips of the impact map.
    flips = [
        [point.value for point in one if point.bifurcation == "flip"]
        for one in (branch, *branch.doubled)
    ]
    assert [len(one) for one in flips] == [1, 2, 1]
    first, second, _ = flips
    assert second[0] == first[0] == pytest.approx(2.66092371e-3, rel=1e-8)
    assert second[1] == pytest.approx(3.03600e-3, rel=1e-5)
    doubled = branch.doubled[0]
    assert doubled[-1].cycle.period == pytest.approx(2 * branch[0].cycle.period, rel=1e-12)
    assert branch.doubled[1].values[0] == second[1] and not doubled.doubled


def test_sections_repeat_as_often_as_the_period_has_doubled(bouncing):
    values = [2.5e-3, 2.6e-3, 2.8e-3, 2.9e-3, 3.05e-3]
    found = bouncing.sections(
        "amplitude", values, period="frequency", settle=60, returns=32, columns=["height"]
    )
    # The flips are at 2.66092371 and 3.03600 mm.
    assert found.repeats == [1, 1, 2, 2, 4] and found.reasons == [None] * 5
    heights = found["height"]
    assert heights.shape == (5, 32)
    cycle = bouncing.cycle(
        "frequency", settle=20, points=4001, parameters={"amplitude": 2.5e-3}
    )
    # The cycle begins away from impacts, the sections at multiples of the period.
    begun = np.ceil(cycle.start / cycle.period) * cycle.period
    height = np.interp(begun, cycle.motion.t, cycle["height"])
    np.testing.assert_allclose(heights[0], height, rtol=1e-5)
    np.testing.assert_allclose(heights[2][2:], heights[2][:-2], rtol=1e-6)
    assert abs(heights[2][1] - heights[2][0]) > 1e-5
    assert "32 periods" in repr(found)
    with pytest.raises(KeyError):
        found["heigth"]


def test_sections_that_cannot_be_are_errors(bouncing):
    with pytest.raises(machinist.InputError, match="at least 2"):
        bouncing.sections("amplitude", [2e-3], period="frequency", returns=1)
    with pytest.raises(machinist.UnknownNameError):
        bouncing.sections("amplitude", [2e-3], period="frequenzy")
    with pytest.raises(machinist.UnknownNameError):
        bouncing.sections("amplitude", [2e-3], period="frequency", columns=["heigth"])
    with pytest.raises(machinist.UnknownNameError):
        bouncing.sections("amplitud", [2e-3], period="frequency")
    stopped = bouncing.sections(
        "amplitude", [2e-3], period="frequency", settle=2, max_steps=3, returns=4
    )
    assert stopped.repeats == [None] and "steps" in stopped.reasons[0]
    assert stopped["height"].shape[0] == 1


def test_multipliers_have_the_product_of_the_impacts(bouncing):
    cycle = bouncing.cycle("frequency", settle=2, parameters={"amplitude": 1.8e-3})
    assert cycle.is_forced and cycle.stability == "stable"
    assert cycle.period == pytest.approx(0.1, rel=1e-12)
    # The determinant of the impact map is the square of the restitution.
    product = np.prod([multiplier.value for multiplier in cycle.multipliers])
    assert product == pytest.approx(0.8**2, abs=1e-8)
    assert set(cycle.multipliers[0].vector) == set(bouncing.states)
    run = bouncing.simulate(
        initial=cycle.state, start=cycle.start, until=cycle.start + cycle.period, points=2,
        parameters={"amplitude": 1.8e-3}, rtol=1e-11, equilibrium=False,
    )  # fmt: skip
    np.testing.assert_allclose(run.y[:, -1], cycle.state, atol=1e-8)
    assert cycle["height"].shape == cycle.motion.t.shape


def test_an_unknown_period_is_solved_for():
    sliding = machinist.load("stick_slip")
    cycle = sliding.cycle(parameters={"slider.stribeck_friction": 0.0}, settle=5.0)
    # Stick and slip in closed form (tests/cycles.rs).
    mass, stiffness, normal, most, least, belt = 1.0, 400.0, 10.0, 0.4, 0.25, 0.1
    omega = np.sqrt(stiffness / mass)
    excess = (most - least) * normal / stiffness
    period = 2 / omega * (np.pi - np.arctan(excess * omega / belt)) + 2 * excess / belt
    assert cycle.period == pytest.approx(period, rel=1e-9)
    phase = [one for one in cycle.multipliers if one.is_trivial]
    assert len(phase) == 1 and phase[0].value == pytest.approx(1, abs=1e-8)
    assert "solved for" in repr(cycle) and "<table" in cycle._repr_html_()


def test_a_branch_turns_at_the_folds_of_harmonic_balance(duffing):
    branch = duffing.branch("block.frequency", 0.6, 2.2, period="block.frequency", points=101)
    assert branch.is_complete, branch.end
    folds = [point for point in branch.bifurcations if point.bifurcation == "fold"]
    # Harmonic balance with 30 harmonics, tests/cycles/references.py.
    wanted = [1.779719524298572, 1.3242362007705655]
    assert [fold.value for fold in folds] == pytest.approx(wanted, rel=1e-8)
    assert folds[0].cycle.amplitude("x") == pytest.approx(1.7222520, abs=1e-3)
    assert "fold" in repr(branch) and branch.unit == "rad/s"


def test_an_unstable_motion_is_found_from_initial_values(duffing):
    # In 31 digits, tests/cycles/references.py.
    cycle = duffing.cycle(
        "block.frequency", settle=0, segments=5, parameters={"block.frequency": 1.6},
        initial={"block.x": -0.906, "block.v": 1.663},
    )  # fmt: skip
    assert cycle.stability == "unstable" and "unstable" in repr(cycle)
    np.testing.assert_allclose(cycle.state, [-0.9061090606439356, 1.6625994641288475], atol=1e-9)
    values = [one.value for one in cycle.multipliers]
    np.testing.assert_allclose(values, [1.6648033251796925, 0.4055925985028263], atol=1e-8)
    assert [one.crossing for one in cycle.multipliers] == ["fold", "fold"]


def test_van_der_pol_has_the_period_and_the_multiplier_of_the_reference():
    oscillator = machinist.load(SPECS / "classics" / "van_der_pol.toml")
    # In 31 digits, tests/cycles/references.py.
    wanted = [(0.1, 6.287111272288727, 0.5330692592096738), (10.0, 19.078369566939014, 0.0)]
    for damping, period, multiplier in wanted:
        cycle = oscillator.cycle(
            parameters={"oscillator.damping": damping}, settle=80.0, rtol=1e-11, method="dop853"
        )
        assert cycle.period == pytest.approx(period, rel=1e-9) and not cycle.is_forced
        (other,) = [one for one in cycle.multipliers if not one.is_trivial]
        assert abs(other.value - multiplier) < 1e-8


def test_a_rotor_repeats_after_a_turn(tmp_path):
    file = tmp_path / "rotor.toml"
    file.write_text(ROTOR)
    rotor = machinist.load(file)
    cycle = rotor.cycle(turns={"rotor.phi": 1})
    assert cycle["angle"][-1] - cycle["angle"][0] == pytest.approx(2 * np.pi, rel=1e-9)
    assert cycle["speed"][-1] == pytest.approx(cycle["speed"][0], rel=1e-9)
    # The divergence is constant, so the product of the multipliers is exp(-0.2 T) (Liouville).
    product = np.prod([one.value for one in cycle.multipliers])
    assert product == pytest.approx(np.exp(-0.2 * cycle.period), abs=1e-8)
    # Over a turn the drive's work is that of the damping: 2 * 2 pi = 0.2 times the integral of w^2.
    angle, speed = cycle["angle"], cycle["speed"]
    work = np.trapezoid(speed, angle)
    assert 0.2 * work == pytest.approx(2 * 2 * np.pi, rel=1e-4)


def test_searches_that_cannot_succeed_are_errors(bouncing, gin, duffing):
    with pytest.raises(machinist.InputError, match="period of the excitation"):
        bouncing.cycle(settle=2)
    with pytest.raises(machinist.UnknownNameError):
        bouncing.cycle("frequenzy")
    with pytest.raises(machinist.UnknownNameError, match="no state"):
        gin.cycle(0.1, turns={"motor.fi": 1})
    with pytest.raises(machinist.AnalysisError, match="no periodic motion near the start"):
        duffing.cycle("block.frequency", multiple=1, settle=0, parameters={"block.damping": -0.5})
    with pytest.raises(machinist.InputError, match="no setting `setle`"):
        duffing.cycle("block.frequency", setle=2)
    with pytest.raises(machinist.InputError, match="segments"):
        duffing.cycle("block.frequency", segments=0)
    with pytest.raises(machinist.InputError, match="has no length"):
        bouncing.branch("amplitude", 1e-3, 1e-3, period="frequency")
