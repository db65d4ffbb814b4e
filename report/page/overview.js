// All factors at once: where runs were made and failed, what the targets allow, which factor acts on what, how good the
// surrogates are, and how the values came about.

const most_pairs = 6;

// Factor space in pairs: finished and failed runs, sets that the targets allow, the best run.
function show_pairs(parent) {
    const factors = campaign.factors;
    const pairs = factors.flatMap((_, a) => factors.map((__, b) => [a, b])).filter(([a, b]) => a < b);
    if (pairs.length === 0 || calibrating_runs.length === 0) {
        parent.closest('section').remove();
        return;
    }
    const sets = campaign.optimum && campaign.optimum.sets || [];
    legend(parent, [['runs', colours.design], ['failed runs', colours.failed],
                    ...(sets.length > 0 ? [['sets that the targets allow', colours.band]] : []), ['best run', colours.best]]);
    const grid = element('div', {class: 'columns three'});
    parent.append(grid);
    for (const [a, b] of pairs.slice(0, most_pairs)) show_pair(grid, a, b, sets);
    if (pairs.length > most_pairs)
        parent.append(element('p', {class: 'note'}, `${most_pairs} of ${pairs.length} pairs are drawn.`));
}

function show_pair(parent, a, b, sets) {
    const scale = (factor, name, range) => factor.log ? {...logarithmic(name, range, [factor.lower, factor.upper]), nice: false}
        : linear(name, range, [factor.lower, factor.upper], {nice: false});
    const first = campaign.factors[a], second = campaign.factors[b];
    const one_of_each = [...new Map(calibrating_runs.map((run) => [run.factors.join() + run.outcome, run])).values()];
    const dots = drawn(one_of_each).map((run) => ({x: run.factors[a], y: run.factors[b],
        colour: run.outcome === 'failed' ? colours.failed : colours.design, shape: run.outcome === 'failed' ? 'cross' : 'circle',
        text: `run ${run.run}: ${run.status}`}));
    plot(parent, `pair-${first.name}-${second.name}`, {
        width: 260, height: 220, description: `${words_of(second.name)} over ${words_of(first.name)}`,
        data: [{name: 'dots', values: dots}, {name: 'sets', values: sets.map((set) => ({x: set[a], y: set[b]}))},
               {name: 'best', values: campaign.optimum ? [{x: campaign.optimum.point[a], y: campaign.optimum.point[b]}] : []}],
        scales: [scale(first, 'x', 'width'), scale(second, 'y', 'height')],
        axes: [axis('bottom', 'x', words_of(first.name), {format: '~g'}), axis('left', 'y', words_of(second.name), {format: '~g', minExtent: 34})],
        marks: [
            mark('symbol', 'sets', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'y'}, size: {value: 22}, fill: {value: colours.band},
                fillOpacity: {value: 0.25}}, {clip: true}),
            mark('symbol', 'dots', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'y'}, size: {value: 34}, shape: {field: 'shape'},
                fill: {field: 'colour'}, fillOpacity: {value: 0.8}, tooltip: {field: 'text'}}),
            mark('symbol', 'best', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'y'}, size: {value: 110}, fill: {value: colours.best},
                stroke: {value: colours.paper}}),
        ],
    });
}

// How far each response goes along each factor, the others at the optimum, in scales of its target.
function show_importance(parent) {
    const fit = campaign.surrogate;
    if (!fit) {
        parent.closest('section').remove();
        return;
    }
    const bars = all_targets.flatMap((target) => campaign.factors.map((factor, index) => {
        const [least, most] = range_of(fit.slices[target.index][index].filter(known));
        return {factor: words_of(factor.name), target: target.short, change: (most - least) / target.scale};
    })).filter((bar) => Number.isFinite(bar.change));
    const columns = element('div', {class: 'columns two'}), left = element('div'), right = element('div');
    columns.append(left, right);
    parent.append(columns);
    const names = campaign.factors.map((factor) => words_of(factor.name)), targets = [...new Set(bars.map((bar) => bar.target))];
    plot(left, 'importance', {
        width: 380, height: Math.min(30 * targets.length, 600), title: {text: 'Change of each response along a factor\'s range, in scales'},
        data: [{name: 'cells', values: bars}],
        scales: [{name: 'x', type: 'band', range: 'width', domain: names}, {name: 'y', type: 'band', range: 'height', domain: targets},
                 {name: 'strength', type: 'linear', range: [0, 0.75], domain: [0, Math.max(1, ...bars.map((bar) => bar.change))]}],
        axes: [{orient: 'top', scale: 'x', ticks: false, domain: false, labelLimit: 120},
               {orient: 'left', scale: 'y', ticks: false, domain: false, labelLimit: 190}],
        marks: [
            mark('rect', 'cells', {x: {scale: 'x', field: 'factor'}, y: {scale: 'y', field: 'target'}, width: {scale: 'x', band: 1},
                height: {scale: 'y', band: 1}, fill: {value: colours.accent}, fillOpacity: {scale: 'strength', field: 'change'}}),
            mark('text', 'cells', {x: {scale: 'x', field: 'factor', band: 0.5}, y: {scale: 'y', field: 'target', band: 0.5},
                text: {signal: "format(datum.change, '.2~r')"}, align: {value: 'center'}, baseline: {value: 'middle'},
                fill: {value: colours.ink}, fontSize: {value: 12}}),
        ],
    });
    show_quality(right, fit);
    show_left_out(parent, fit);
}

// Each location as simulated and as predicted from the others, a plot a response.
function show_left_out(parent, fit) {
    const rows = fit.left_out || [];
    const by_target = all_targets.map((target) => rows.filter(([number]) => number === target.index))
        .map((list) => list.filter(([, simulated, predicted]) => known(simulated) && known(predicted)));
    if (by_target.every((list) => list.length < 3)) return;
    parent.append(element('h3', {}, 'Predicted from the other points, against simulated'));
    const grid = element('div', {class: 'columns three'});
    parent.append(grid);
    all_targets.forEach((target, index) => {
        const list = by_target[index];
        if (list.length < 3) return;
        const domain = extent(list.flatMap(([, simulated, predicted]) => [simulated, predicted]));
        plot(grid, `left-out-${index}`, {
            width: 220, height: 200, description: `${target.short}: predicted from the other points over simulated`,
            data: [{name: 'dots', values: list.map(([, x, y]) => ({x, y}))},
                   {name: 'same', values: [{x: domain[0], y: domain[0]}, {x: domain[1], y: domain[1]}]}],
            scales: [linear('x', 'width', domain, {nice: false}), linear('y', 'height', domain, {nice: false})],
            axes: [axis('bottom', 'x', `${target.short}, simulated`, {format: '~g'}), axis('left', 'y', 'predicted', {format: '~g', minExtent: 34})],
            marks: [
                mark('line', 'same', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'y'}, stroke: {value: colours.axis}, strokeDash: {value: [4, 3]}}),
                mark('symbol', 'dots', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'y'}, size: {value: 34},
                    fill: {value: colours.design}, fillOpacity: {value: 0.8}}),
            ],
        });
    });
}

// In words how well each surrogate predicts runs that it was not fitted to.
function show_quality(parent, fit) {
    const word = (r2) => !known(r2) ? 'the same in all runs' : r2 <= 0 ? 'worse than the mean of all runs' : r2 < 0.5 ? 'poor'
        : r2 < 0.8 ? 'fair' : r2 < 0.95 ? 'good' : 'very good';
    const rows = all_targets.map((target) => {
        const r2 = fit.leave_one_out_r2[target.index];
        return [element('td', {}, target.short), element('td', {}, number(fit.leave_one_out_rmse[target.index], 2)),
                element('td', {}, number(r2, 3)), element('td', {class: 'text ' + (known(r2) && r2 < 0.5 ? 'bad' : '')}, word(r2))];
    });
    parent.append(element('h3', {}, 'How well surrogates predict runs left out'),
                  simple_table(['response', 'error', 'share of variance', 'prediction'], rows));
}

// Best run, estimate and interval of each factor after each wave.
function show_progress(parent) {
    const waves = campaign.progress || [];
    if (waves.length < 2) {
        parent.closest('section').remove();
        return;
    }
    const grid = element('div', {class: 'columns three'});
    parent.append(grid);
    campaign.factors.forEach((factor, index) => {
        const rows = waves.map((wave) => ({wave: wave.wave, best: wave.point[index], estimate: wave.estimate ? wave.estimate[index] : null,
            lower: wave.interval ? wave.interval[index][0] : null, upper: wave.interval ? wave.interval[index][1] : null}));
        plot(grid, `progress-${factor.name}`, {
            width: 260, height: 150, description: `${words_of(factor.name)} over waves`,
            data: [{name: 'best', values: rows}, {name: 'intervals', values: rows.filter((row) => known(row.lower))},
                   {name: 'estimates', values: rows.filter((row) => known(row.estimate))}],
            scales: [{name: 'x', type: 'point', range: 'width', domain: rows.map((row) => row.wave), padding: 0.5},
                     factor.log ? {...logarithmic('y', 'height', [factor.lower, factor.upper]), nice: false}
                         : linear('y', 'height', [factor.lower, factor.upper], {nice: false})],
            axes: [axis('bottom', 'x', 'wave', {grid: false}), axis('left', 'y', words_of(factor.name), {format: '~g', minExtent: 34})],
            marks: [
                mark('rule', 'intervals', {x: {scale: 'x', field: 'wave'}, y: {scale: 'y', field: 'lower'}, y2: {scale: 'y', field: 'upper'},
                    stroke: {value: colours.band}, strokeWidth: {value: 5}, strokeOpacity: {value: 0.4}}),
                mark('symbol', 'estimates', {x: {scale: 'x', field: 'wave'}, y: {scale: 'y', field: 'estimate'}, shape: {value: 'diamond'},
                    size: {value: 80}, stroke: {value: colours.soft}, fill: {value: colours.paper}}),
                mark('symbol', 'best', {x: {scale: 'x', field: 'wave'}, y: {scale: 'y', field: 'best'}, fill: {value: colours.best}, size: {value: 60}}),
            ],
        });
    });
    parent.append(element('p', {class: 'note'}, 'Red: best run. Diamond: estimate. Green: its 95 % interval.'));
}
