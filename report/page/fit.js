// The best fit: factors, targets against simulated values, and how the campaign got there.

// Why there is nothing to tell of what the runs have given.
function no_answer(what) {
    if (!campaign.ended) return `No ${what} yet: no wave has been analysed.`;
    return finished_runs.length > 0 ? `No ${what}: too few runs have finished.`
        : `No ${what}: none of the ${all_runs.length} runs has finished; why stands under Runs.`;
}

function show_fit(parent) {
    const optimum = campaign.optimum;
    if (!optimum) {
        parent.append(element('p', {class: 'note'}, no_answer('best fit')));
        return;
    }
    const repeated = optimum.repetitions > 1 ? `, simulated ${optimum.repetitions} times with different packings` : '';
    parent.append(element('p', {},
        `Design point ${optimum.point_number}${repeated}: ${optimum.headline}; root mean square deviation `
        + `${number(Math.sqrt(optimum.mean_square_residual), 3)} scales (weighted mean square error ${number(optimum.wmse)}, of mixed units).`));
    const columns = element('div', {class: 'columns uneven'});
    const left = element('div'), right = element('div');
    columns.append(left, right);
    parent.append(columns);
    left.append(element('h3', {}, 'Factors'), ...goodness_of_fit(), factor_table(),
                element('p', {class: 'note'}, optimum.verdict_rule), element('h3', {}, 'Targets'), target_table(),
                ...targets_out_of_reach(), ...predicted_table());
    show_deviations(right);
}

// By the number of the verdict.
const verdict_styles = ['good', 'warn', 'bad', '', 'bad', 'bad', 'warn', 'bad'];

const targets_missed = (optimum) => optimum.missed;

// Whether the targets are met together: before anything that rests on it.
function goodness_of_fit() {
    const optimum = campaign.optimum;
    if (optimum.estimate && !optimum.estimate.some(known)) {
        return [element('p', {class: 'bad'}, 'Whether the targets can be met is not known: the surrogates come nearest to them '
            + 'where no run supports it.')];
    }
    if (!known(optimum.p_value)) return [];
    const missed = targets_missed(optimum);
    const lines = [element('p', {class: missed ? 'bad' : ''}, `The targets ${missed ? 'cannot' : 'can'} be met together: χ² `
        + `${optimum.least_misfit < 1e-6 ? 0 : number(optimum.least_misfit)} on ${number(optimum.degrees)} degrees of freedom, p ${number(optimum.p_value, 2)}.`)];
    if (optimum.noise_inflation > 1) {
        lines.push(element('p', {class: missed ? 'bad' : 'note'}, `All noise is taken to be ${number(optimum.noise_inflation, 3)} `
            + 'times as large as stated, so that this misfit counts as noise: intervals are wider by about as much.'));
    }
    return lines;
}

function spread_text(factor, spread) {
    if (!known(spread)) return '–';
    if (factor.log) return `factor ${number(1 + spread, 3)}`;
    return spread < 10 ? `± ${number(100 * spread, 2)} %` : '> 1000 %';
}

function factor_table() {
    const optimum = campaign.optimum;
    const rows = campaign.factors.map((factor, index) => {
        const interval = optimum.interval ? optimum.interval[index] : [null, null];
        const verdict = optimum.verdict_text ? optimum.verdict_text[index] : '–';
        const style = optimum.verdict ? verdict_styles[optimum.verdict[index]] : '';
        const side = optimum.on_bound && known(interval[0]) ? optimum.on_bound[index] : 0;
        const bound = side ? `; the estimate is on the ${side < 0 ? 'lower' : 'upper'} bound` : '';
        return [
            element('td', {title: factor.path}, words_of(factor.name)),
            element('td', {}, element('b', {}, number(optimum.point[index]))),
            element('td', {}, number(optimum.estimate ? optimum.estimate[index] : null)),
            element('td', {}, known(interval[0]) && optimum.tells_interval[index] ? `${number(interval[0], 3)} to ${number(interval[1], 3)}` : '–'),
            element('td', {}, spread_text(factor, optimum.spread ? optimum.spread[index] : null)),
            element('td', {}, `${number(factor.lower)} to ${number(factor.upper)}`),
            element('td', {class: 'text ' + style}, verdict + bound),
        ];
    });
    return simple_table(['factor', 'best run', 'estimate', '95 % interval', 'known to', 'range', 'verdict'], rows);
}

function target_table() {
    const optimum = campaign.optimum;
    const rows = all_targets.map((target) => {
        const simulated = optimum.responses[target.index];
        const met = known(target.tolerance) ? Math.abs(simulated - target.value) <= target.tolerance : null;
        return [
            element('td', {}, target.label),
            element('td', {}, number(target.value) + (known(target.sd) ? ' ± ' + number(target.sd, 2) : '')),
            element('td', {}, element('b', {}, number(simulated))),
            element('td', {}, signed(simulated - target.value)),
            element('td', {}, number(optimum.estimate_responses ? optimum.estimate_responses[target.index] : null)),
            element('td', {}, number(target.scale)),
            element('td', {class: 'text ' + (met === null ? '' : met ? 'good' : 'bad')},
                    met === null ? '–' : (met ? 'within ± ' : 'outside ± ') + number(target.tolerance)),
        ];
    });
    return simple_table(['response', 'measured', 'best run', 'difference', 'estimate', 'scale', 'tolerance'], rows);
}

// What is held out: measured, and simulated at the estimate with packings of their own.
function predicted_table() {
    const predicted = campaign.predicted || [];
    if (predicted.length === 0) return [];
    const rows = predicted.map((one) => {
        const off = known(one.mean) ? (one.mean - one.measured) / one.scale : null;
        return [
            element('td', {}, `${one.cell.slice(0, one.cell.indexOf('.'))}: ${label_of(one.cell.slice(one.cell.indexOf('.') + 1), one.units)}`),
            element('td', {}, number(one.measured)),
            element('td', {}, element('b', {}, known(one.mean) ? number(one.mean) : 'no run finished'), one.sd > 0 ? ` ± ${number(one.sd, 2)}` : ''),
            element('td', {}, known(off) ? signed(one.mean - one.measured) : '–'),
            element('td', {}, number(one.scale)),
            element('td', {}, known(off) ? signed(off) : '–'),
        ];
    });
    const packings = Math.max(...predicted.map((one) => one.simulated.length));
    return [element('h3', {}, 'Predicted, not fitted'),
        simple_table(['response', 'measured', 'predicted', 'difference', 'scale', 'in scales'], rows),
        element('p', {class: 'note'}, `Experiments that took no part in the calibration, simulated at the estimate ${packings} times each, with packings of their own, and the mean taken; ± is their scatter.`)];
}

// Warnings of targets that no run came past, and of responses that never change.
function targets_out_of_reach() {
    const distances = campaign.optimum.out_of_reach || [];
    const r2 = campaign.surrogate ? campaign.surrogate.leave_one_out_r2 : [];
    const same = all_targets.filter((target) => target.index < r2.length && !known(r2[target.index])).map((target) =>
        element('p', {class: 'bad'}, `${target.label} is the same in all runs: no factor acts on it.`));
    const informs = campaign.surrogate && campaign.surrogate.informs ? campaign.surrogate.informs : [];
    const unused = all_targets.filter((target) => informs[target.index] === 0).map((target) => element('p', {class: 'bad'},
        `The surrogate of ${target.label} predicts no better than the mean of all runs: it is not used for the intervals.`));
    const {locations, complete_locations} = campaign.surrogate || {};
    const subset = locations < complete_locations ? [element('p', {class: 'note'}, `The surrogates are fitted to ${locations} of `
        + `${complete_locations} locations, the best ones and others far apart; to all of them would take minutes.`)] : [];
    return same.concat(unused, subset, all_targets.filter((target) => distances[target.index]).map((target) => element('p', {class: 'bad'},
        `No point, in the mean of its runs, reached the target of ${target.label}: it is ${distances[target.index] > 0 ? 'above' : 'below'} all of `
        + `them by ${number(Math.abs(distances[target.index]), 3)}.`)));
}

function simple_table(heads, rows) {
    const text = (column) => rows.length > 0 && rows[0][column].classList.contains('text') ? {class: 'text'} : {};
    return element('div', {class: 'wide'}, element('table', {},
        element('thead', {}, element('tr', {}, ...heads.map((head, column) => element('th', {scope: 'col', ...text(column)}, head)))),
        element('tbody', {}, ...rows.map((cells) => element('tr', {}, ...cells)))));
}

// Differences in units of each target's scale, so that all share one axis.
function show_deviations(parent) {
    const optimum = campaign.optimum;
    const best = all_targets.map((target) => ({
        label: target.label,
        mean: (optimum.responses[target.index] - target.value) / target.scale,
        predicted: optimum.predicted_responses
            ? (optimum.predicted_responses[target.index] - target.value) / target.scale : null,
        tolerance: known(target.tolerance) ? target.tolerance / target.scale : 0,
        sd: known(target.sd) ? target.sd / target.scale : 0,
        text: `${target.label}: measured ${number(target.value)}, simulated ${number(optimum.responses[target.index])}`,
    }));
    const single = finished_runs.filter(is_best).flatMap((run) => all_targets
        .filter((target) => target.experiment === run.experiment && known(run.responses[target.response]))
        .map((target) => ({label: target.label, text: `run ${run.run}: ${number(run.responses[target.response])}`,
                           deviation: (run.responses[target.response] - target.value) / target.scale})));
    const reach = Math.max(1, ...best.flatMap((row) => [Math.abs(row.mean), row.tolerance, row.sd]),
                           ...single.map((row) => Math.abs(row.deviation))) * 1.08;
    const middle = {scale: 'y', field: 'label', band: 0.5};
    plot(parent, 'deviations', {
        width: 240, height: 46 * best.length,
        title: {text: 'Simulated less measured, in scales'},
        data: [{name: 'best', values: best}, {name: 'single', values: single},
               {name: 'predicted', values: best.filter((row) => known(row.predicted) && Math.abs(row.predicted) <= reach)}],
        scales: [linear('x', 'width', [-reach, reach], {nice: false}),
                 {name: 'y', type: 'band', range: 'height', domain: best.map((row) => row.label), padding: 0.25}],
        axes: [axis('bottom', 'x', 'scales'), {orient: 'left', scale: 'y', ticks: false, domain: false, labelLimit: 190}],
        marks: [
            mark('rect', 'best', {x: {scale: 'x', signal: '-datum.tolerance'}, x2: {scale: 'x', field: 'tolerance'},
                y: {scale: 'y', field: 'label'}, height: {scale: 'y', band: 1}, fill: {value: colours.band},
                fillOpacity: {value: 0.13}, tooltip: {signal: "'tolerance ± ' + format(datum.tolerance, '.3') + ' scales'"}}),
            mark('rule', 'best', {x: {scale: 'x', signal: '-datum.sd'}, x2: {scale: 'x', field: 'sd'}, y: middle,
                stroke: {value: colours.band}, strokeWidth: {value: 5}, strokeOpacity: {value: 0.35}}),
            mark('rule', null, {x: {scale: 'x', value: 0}, y: {value: 0}, y2: {signal: 'height'}, stroke: {value: colours.band},
                strokeWidth: {value: 1.5}}),
            mark('symbol', 'single', {x: {scale: 'x', field: 'deviation'}, y: middle, size: {value: 26},
                fill: {value: colours.best}, fillOpacity: {value: 0.35}, tooltip: {field: 'text'}}),
            mark('symbol', 'predicted', {x: {scale: 'x', field: 'predicted'}, y: middle, size: {value: 110},
                shape: {value: 'diamond'}, stroke: {value: colours.soft}, strokeWidth: {value: 1.2}, fill: {value: 'transparent'},
                tooltip: {value: 'predicted at the optimum of the surrogates'}}),
            mark('symbol', 'best', {x: {scale: 'x', field: 'mean'}, y: middle, size: {value: 100}, fill: {value: colours.best},
                stroke: {value: colours.paper}, tooltip: {field: 'text'}}),
        ],
    });
    parent.append(element('p', {class: 'note'}, 'Dot: best point (mean of its runs; small dots: each run). Diamond: optimum of '
        + 'the surrogates. Shaded: tolerance. Thick line: standard deviation of the measurement, where given.'));
}

// Root mean square deviation of a design point from the targets, in scales; null where a target has no value.
function deviation_of_point(point) {
    const runs = calibrating_runs.filter((run) => run.point === point && run.outcome === 'finished');
    const squares = all_targets.map((target) => {
        const values = runs.filter((run) => run.experiment === target.experiment).map((run) => run.responses[target.response]).filter(known);
        const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
        return ((mean - target.value) / target.scale) ** 2;
    });
    const mean = squares.reduce((sum, square) => sum + square, 0) / squares.length;
    return known(mean) ? Math.sqrt(mean) : null;
}

function show_convergence(parent) {
    const last_run = new Map();
    for (const run of calibrating_runs) last_run.set(run.point, run);
    const points = (campaign.history.point_wmse || []).map((wmse, point) => ({point, off: known(wmse) ? deviation_of_point(point) : null, last: last_run.get(point)}))
        .filter((row) => known(row.off) && row.last)
        .map((row) => ({run: row.last.run + 1, off: row.off, purpose: row.last.purpose,
                        colour: purpose_colour(row.last.purpose),
                        text: `point ${row.point} (${row.last.purpose}): ${number(row.off)} scales`}));
    let least_so_far = Infinity;
    const best = points.filter((row) => row.off < least_so_far && (least_so_far = row.off) >= 0).map(({run, off}) => ({run, off}));
    if (best.length > 0) best.push({run: calibrating_runs.length, off: least_so_far});
    if (points.length === 0) {
        parent.append(element('p', {class: 'note'}, no_answer('convergence')));
        return;
    }
    const all = [...points, ...best].map((row) => row.off);
    const [least, most] = range_of(all);
    const positive = least > 0;
    const starts = campaign.waves.slice(1).filter((wave) => wave.runs.length > 0 && wave.runs[0].run < calibrating_runs.length)
        .map((wave) => ({run: wave.runs[0].run + 0.5}));
    legend(parent, [...new Set(points.map((row) => row.purpose))].map((purpose) => [purpose, purpose_colour(purpose)])
        .concat([['best so far', colours.best]]));
    plot(parent, 'convergence', {
        width: 1000, height: 280,
        data: [{name: 'points', values: drawn(points)}, {name: 'best', values: best}, {name: 'waves', values: starts}],
        scales: [linear('x', 'width', [0, calibrating_runs.length + 1], {nice: false}),
                 positive ? logarithmic('y', 'height', [least * 0.8, most * 1.25])
                          : linear('y', 'height', extent(all))],
        axes: [axis('bottom', 'x', 'runs', {grid: false, tickCount: 10, tickMinStep: 1, format: 'd'}),
               axis('left', 'y', 'root mean square deviation [scales]', {format: '~g', tickCount: 6})],
        marks: [
            mark('rule', 'waves', {x: {scale: 'x', field: 'run'}, y: {value: 0}, y2: {signal: 'height'},
                stroke: {value: colours.axis}, strokeDash: {value: [3, 3]}}),
            mark('symbol', 'points', {x: {scale: 'x', field: 'run'}, y: {scale: 'y', field: 'off'}, size: {value: 42},
                fill: {field: 'colour'}, fillOpacity: {value: 0.85}, tooltip: {field: 'text'}}),
            mark('line', 'best', {x: {scale: 'x', field: 'run'}, y: {scale: 'y', field: 'off'}, stroke: {value: colours.best},
                strokeWidth: {value: 2}, interpolate: {value: 'step-after'}}),
        ],
    });
    parent.append(element('p', {class: 'note'}, 'Each dot is a design point at the number of its last run; dashed lines part the '
        + 'waves. The line is the best point so far.'
        + note_of_drawn(points, 'points')));
}
