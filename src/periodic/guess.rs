//! First guesses: a run that has settled, and the period by its latest return.

use super::equations::{Guess, Period as Span, Problem};
use super::error::CycleError;
use super::{CycleSettings, Period, rows};

/// Number of times at which a run is searched for a return. A wave has a sample within `NEAR` of its
/// return if it has at least pi/(2 NEAR) = 79 in a period, so in runs of up to 250 periods.
const SAMPLES: usize = 20_001;
/// Distance from the end, relative to the range of each state, that a motion must leave before it
/// can return.
const AWAY: f64 = 0.2;
/// Distance up to which a nearest approach counts as a return at once.
const NEAR: f64 = 0.02;
/// Distance up to which the nearest of all approaches counts as a return.
const FAR: f64 = 0.2;
/// Change of the state in a period, over its scale, below which the machine is at rest.
const STILL: f64 = 1e-8;

/// Returns the guess at the end of the time to settle.
pub(super) fn settled(
    problem: &Problem<'_>,
    settings: &CycleSettings,
) -> Result<Guess, CycleError> {
    let value = problem.varied.map_or(0.0, |index| problem.run.parameter_values()[index]);
    let given = problem.period.of(problem.run.parameter_values());
    let (state, period, skipped) = if let Some(period) = given {
        let skipped = (settings.settle / period).ceil();
        let end = problem.origin + skipped * period;
        (state_at(problem, end)?, period, skipped)
    } else {
        let (state, period) = returning(problem, settings)?;
        (state, period, 0.0)
    };
    away_from_events(problem, Guess { nodes: vec![state], period, skipped, value })
}

/// Returns the state of the run at a time, or its start.
fn state_at(problem: &Problem<'_>, time: f64) -> Result<Vec<f64>, CycleError> {
    let run = problem.run.clone();
    if time <= problem.origin {
        return Ok(run.checked_start()?.0);
    }
    let settled = run.until(time).points(2).run()?;
    Ok(rows(&settled).pop().unwrap_or_default())
}

/// Moves the start to the middle of the longest time without events, so that none of them passes
/// the start on a branch.
pub(super) fn away_from_events(problem: &Problem<'_>, guess: Guess) -> Result<Guess, CycleError> {
    let share = share_without_events(problem, &guess)?;
    moved_by(problem, guess, share)
}

/// Returns the share of the period after which the middle of the longest time without events comes;
/// 0 without events.
pub(super) fn share_without_events(
    problem: &Problem<'_>,
    guess: &Guess,
) -> Result<f64, CycleError> {
    if problem.run.simulator().events() == 0 {
        return Ok(0.0);
    }
    let (start, period) = problem.span_of(guess);
    let run = problem.run_at(guess).shot_from(&guess.nodes[0]).from(start);
    let once = run.until(start + period).points(2).run()?;
    let shares = once.switches.iter().map(|switch| (switch.time - start) / period);
    let mut shares: Vec<f64> = shares.collect();
    let Some(first) = shares.first().copied() else { return Ok(0.0) };
    shares.push(first + 1.0);
    let gaps = shares.windows(2).map(|pair| (pair[1] - pair[0], 0.5 * (pair[0] + pair[1])));
    let longest = gaps.max_by(|a, b| a.0.total_cmp(&b.0));
    Ok(longest.map_or(0.0, |(_, middle)| middle.rem_euclid(1.0)))
}

/// Moves the start by a share of the period along the motion.
pub(super) fn moved_by(
    problem: &Problem<'_>,
    mut guess: Guess,
    share: f64,
) -> Result<Guess, CycleError> {
    if share != 0.0 {
        let (start, period) = problem.span_of(&guess);
        let run = problem.run_at(&guess).shot_from(&guess.nodes[0]).from(start);
        let moved = run.until(start + share * period).points(2).run()?;
        guess.nodes = vec![rows(&moved).pop().unwrap_or_default()];
        if problem.period != Span::Unknown {
            guess.skipped += share;
        }
    }
    if problem.segments > 1 {
        guess.nodes = nodes(problem, &guess)?;
    }
    Ok(guess)
}

/// Returns the states at the starts of all segments, along one period.
fn nodes(problem: &Problem<'_>, guess: &Guess) -> Result<Vec<Vec<f64>>, CycleError> {
    let (start, period) = problem.span_of(guess);
    let run = problem.run_at(guess).shot_from(&guess.nodes[0]);
    let run = run.from(start).until(start + period).points(problem.segments + 1).run()?;
    let mut nodes = rows(&run);
    nodes.truncate(problem.segments);
    Ok(nodes)
}

/// Returns the state at the end of the run, and the time since the machine was there before.
fn returning(
    problem: &Problem<'_>,
    settings: &CycleSettings,
) -> Result<(Vec<f64>, f64), CycleError> {
    let scene = || problem.run.simulator().name().to_owned();
    let guess = match settings.period {
        Period::Unknown(guess) => guess,
        _ => None,
    };
    let (from, until) = (problem.origin, problem.origin + settings.settle);
    let state = state_at(problem, until)?;
    require_independent_of_time(problem, &state, settings.settle.max(guess.unwrap_or(0.0)))?;
    let value = problem.varied.map_or(0.0, |index| problem.run.parameter_values()[index]);
    let moving = |period: f64| {
        let guess = Guess { nodes: vec![state.clone()], period, skipped: 0.0, value };
        require_motion(problem, &guess, until)
    };
    if let Some(period) = guess {
        moving(period)?;
        return Ok((state, period));
    }
    if settings.settle == 0.0 {
        let what = "an unknown period needs a guess, or a time to settle, in which the motion \
                    returns";
        return Err(CycleError::BadSetting(what.to_owned()));
    }
    moving(settings.settle)?;
    let run = problem.run.clone().until(until).points(SAMPLES).run()?;
    let (times, rows) = (run.times.clone(), rows(&run));
    match latest_return(problem, &times, &rows) {
        Ok(period) => Ok((state, period)),
        Err(moves) => Err(CycleError::NoReturn { scene: scene(), from, until, moves }),
    }
}

/// Returns the time since the motion was last where it ends; else the state that differs most.
fn latest_return(problem: &Problem<'_>, times: &[f64], rows: &[Vec<f64>]) -> Result<f64, String> {
    let last = rows.len() - 1;
    let first = last / 2;
    let turning = (0..problem.advance.len()).find(|index| problem.advance[*index] != 0.0);
    if let Some(index) = turning {
        let advanced = |row: usize| (rows[last][index] - rows[row][index]) / problem.advance[index];
        let found = (0..last).rev().find(|row| advanced(*row) >= 1.0);
        let name = problem.run.simulator().state(index).name;
        return found
            .map(|row| times[last] - times[row])
            .ok_or_else(|| format!(": `{name}` does not advance by the turns asked for"));
    }
    let ranges: Vec<f64> = problem
        .free
        .iter()
        .zip(&problem.scales)
        .map(|(index, scale)| {
            let values = rows[first..].iter().map(|row| row[*index]);
            let (least, greatest) = values
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), value| {
                    (a.min(value), b.max(value))
                });
            (greatest - least).max(1e-6 * scale)
        })
        .collect();
    let distance = |row: usize| {
        let shares = problem.free.iter().zip(&ranges).enumerate().map(|(at, (index, range))| {
            ((rows[row][*index] - rows[last][*index]).abs() / range, at)
        });
        shares.fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a })
    };
    let Some(left) = (first..last).rev().find(|row| distance(*row).0 > AWAY) else {
        return Err(String::new());
    };
    let mut nearest = (f64::INFINITY, left);
    for row in (first + 1..left).rev() {
        let here = distance(row).0;
        let is_least = here <= distance(row - 1).0 && here <= distance(row + 1).0;
        if is_least && here < nearest.0 {
            nearest = (here, row);
            if here <= NEAR {
                break;
            }
        }
    }
    if nearest.0 <= FAR {
        return Ok(times[last] - times[nearest.1]);
    }
    let state = problem.free[distance(nearest.1).1];
    Err(format!(": `{}` differs most", problem.run.simulator().state(state).name))
}

/// Refuses an unknown period of a machine whose rate, guards or resets depend on time.
fn require_independent_of_time(
    problem: &Problem<'_>,
    state: &[f64],
    span: f64,
) -> Result<(), CycleError> {
    /// Shares of the span that have no simple ratio to the period of an excitation.
    const TIMES: [f64; 4] = [0.013_718, 0.170_931, 0.414_213, 0.832_179];
    let run = &problem.run;
    let (simulator, parameters) = (run.simulator(), run.parameter_values());
    let events = simulator.events();
    let resets: usize = (0..events).map(|index| simulator.event(index).sets.len()).sum();
    let values = |time: f64| {
        let [mut rate, mut guards, mut resets] =
            [state.len(), events, resets].map(|n| vec![0.0; n]);
        simulator.rate(time, state, parameters, &mut rate);
        if events > 0 {
            simulator.guards(time, state, parameters, &mut guards);
            simulator.resets(time, state, parameters, &mut resets);
        }
        [rate, guards, resets]
    };
    let now = values(problem.origin + span);
    let differs = |share: f64| {
        let then = values(problem.origin + share * span);
        then.iter().zip(&now).any(|(then, now)| {
            let size = now.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
            then.iter().zip(now).any(|(a, b)| (a - b).abs() > 1e-12 * size)
        })
    };
    if TIMES.into_iter().any(differs) {
        return Err(CycleError::NeedsPeriod { scene: run.simulator().name().to_owned() });
    }
    Ok(())
}

/// Refuses a machine at rest.
pub(super) fn require_motion(
    problem: &Problem<'_>,
    guess: &Guess,
    time: f64,
) -> Result<(), CycleError> {
    let moves = problem.scaled_rate(guess, time, &guess.nodes[0]).amax() * guess.period;
    if moves > STILL {
        return Ok(());
    }
    Err(CycleError::AtRest { scene: problem.run.simulator().name().to_owned(), time })
}
