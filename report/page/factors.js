// What the factors do to the responses, and how well the targets determine them.

const verdict_colours = [colours.band, colours.confirmation, colours.failed, colours.soft, colours.failed, colours.failed,
    colours.confirmation, colours.failed];

function show_determination(parent) {
    const optimum = campaign.optimum;
    if (!optimum || !optimum.interval || !optimum.interval.flat().some(known)) {
        const unsupported = optimum && optimum.interval;
        parent.append(element('p', {class: 'note'}, unsupported
            ? 'Not known: the surrogates come nearest to the targets where no run supports it.'
            : 'Not known yet: too few finished runs.'));
        if (unsupported) show_screening(parent);
        return;
    }
    const columns = element('div', {class: 'columns two'});
    const left = element('div'), right = element('div');
    columns.append(left, right);
    parent.append(columns);
    show_intervals(left, optimum);
    if (campaign.factors.length > 1 && optimum.correlation) show_correlations(right, optimum);
    show_findings(parent);
    show_screening(parent);
}

function show_intervals(parent, optimum) {
    const rows = campaign.factors.map((factor, index) => {
        const [lower, upper] = optimum.interval[index];
        return {label: words_of(factor.name), lower: place_in_range(factor, lower), upper: place_in_range(factor, upper),
                best: place_in_range(factor, optimum.point[index]),
                estimate: place_in_range(factor, optimum.estimate ? optimum.estimate[index] : null), colour: verdict_colours[optimum.verdict[index]],
                from: number(factor.lower), to: number(factor.upper),
                text: `${factor.path}: best run ${number(optimum.point[index])}, estimate `
                    + `${number(optimum.estimate ? optimum.estimate[index] : null)} (95 %: ${number(lower, 3)} to `
                    + `${number(upper, 3)})`};
    }).filter((row) => known(row.lower) && known(row.upper));
    const middle = (offset) => ({scale: 'y', field: 'label', band: 0.5, offset});
    const end = (field, align, x) => mark('text', 'rows', {x, y: middle(17), text: {field}, align: {value: align},
        fill: {value: colours.soft}, fontSize: {value: 11}});
    plot(parent, 'intervals', {
        width: 380, height: 52 * rows.length,
        title: {text: '95 % interval of each factor within its range'},
        data: [{name: 'rows', values: rows}, {name: 'estimates', values: rows.filter((row) => known(row.estimate))}],
        scales: [linear('x', 'width', [0, 1], {nice: false}),
                 {name: 'y', type: 'band', range: 'height', domain: rows.map((row) => row.label)}],
        axes: [{orient: 'left', scale: 'y', ticks: false, domain: false, labelFontSize: 12}],
        marks: [
            mark('rect', 'rows', {x: {value: 0}, x2: {signal: 'width'}, y: middle(-6), height: {value: 12},
                fill: {value: colours.track}, cornerRadius: {value: 3}}),
            mark('rect', 'rows', {x: {scale: 'x', field: 'lower'}, x2: {scale: 'x', field: 'upper'}, y: middle(-6),
                height: {value: 12}, fill: {field: 'colour'}, fillOpacity: {value: 0.55}, tooltip: {field: 'text'},
                cornerRadius: {value: 3}}),
            mark('symbol', 'estimates', {x: {scale: 'x', field: 'estimate'}, y: middle(0), size: {value: 110},
                shape: {value: 'diamond'}, stroke: {value: colours.soft}, strokeWidth: {value: 1.2},
                fill: {value: colours.paper}, tooltip: {field: 'text'}}),
            mark('symbol', 'rows', {x: {scale: 'x', field: 'best'}, y: middle(0), size: {value: 90},
                fill: {value: colours.best}, stroke: {value: colours.paper}, tooltip: {field: 'text'}}),
            end('from', 'left', {value: 0}), end('to', 'right', {signal: 'width'}),
        ],
    });
    parent.append(element('p', {class: 'note'}, 'Grey: the range given. Coloured: values with which the targets can still be met. '
        + 'Diamond: estimate. Red dot: best run, which may be a lucky one. Whether a factor is determined is told by the interval '
        + 'over its value, not by its share of the range.'));
}

function show_correlations(parent, optimum) {
    const names = campaign.factors.map((factor) => words_of(factor.name));
    const cells = optimum.correlation.flatMap((row, i) => row.map((value, j) => ({a: names[i], b: names[j], value}))
        .filter((cell, j) => j <= i && known(cell.value)));
    if (cells.length === 0) return;
    const side = Math.min(64, 360 / names.length);
    plot(parent, 'correlations', {
        width: side * names.length, height: side * names.length,
        title: {text: 'Correlation between factors'},
        data: [{name: 'cells', values: cells}],
        scales: [{name: 'x', type: 'band', range: 'width', domain: names}, {name: 'y', type: 'band', range: 'height', domain: names},
                 {name: 'colour', type: 'linear', domain: [-1, 0, 1], range: ['#3b76b8', '#b9c0c8', '#c65a45']}],
        axes: [{orient: 'bottom', scale: 'x', ticks: false, domain: false, labelAngle: -35,
                labelAlign: 'right'},
               {orient: 'left', scale: 'y', ticks: false, domain: false}],
        marks: [
            mark('rect', 'cells', {x: {scale: 'x', field: 'b'}, y: {scale: 'y', field: 'a'}, width: {scale: 'x', band: 1},
                height: {scale: 'y', band: 1}, fill: {scale: 'colour', field: 'value'}, stroke: {value: colours.line},
                tooltip: {signal: "datum.a + ', ' + datum.b + ': ' + format(datum.value, '.2f')"}}),
            mark('text', 'cells', {x: {scale: 'x', field: 'b', band: 0.5}, y: {scale: 'y', field: 'a', band: 0.5},
                text: {signal: "format(datum.value, '.2f')"}, align: {value: 'center'}, baseline: {value: 'middle'},
                fill: {signal: `abs(datum.value) > 0.7 ? 'white' : '#1d2733'`}, fontSize: {value: 12}}),
        ],
    });
    parent.append(element('p', {class: 'note'}, 'Over the parameter sets that meet the targets. Near ±1: only a combination of the '
        + 'two factors is known.'));
}

const fitted_runs = calibrating_runs.filter((run) => run.outcome === 'finished');

function show_responses(parent) {
    if (fitted_runs.length === 0) {
        parent.append(element('p', {class: 'note'}, 'No run has finished yet.'));
        return;
    }
    legend(parent, [...new Set(fitted_runs.map((run) => run.purpose))].map((purpose) => [purpose, purpose_colour(purpose)])
        .concat(campaign.optimum ? [['best point', colours.best]] : []));
    parent.append(element('p', {class: 'note'}, 'Dots are runs'
        + (campaign.surrogate ? ', darker the closer their other factors are to the optimum of the surrogates. Line: surrogate '
           + 'through that optimum, ± one standard deviation' : '') + '. Green: measured value and tolerance.'));
    for (const target of all_targets) show_response_row(parent, target);

    const others = campaign.experiments.flatMap((experiment, e) => experiment.responses.map((response, r) => ({
        experiment: e, response: r, index: -1,
        label: (several_experiments ? experiment.name + ': ' : '') + label_of(response.name, response.units)})))
        .filter((other) => !all_targets.some((target) => target.experiment === other.experiment
                                                       && target.response === other.response));
    if (others.length === 0) return;
    const folded = element('details', {}, element('summary', {}, 'Responses without a target'));
    parent.append(folded);
    for (const other of others) show_response_row(folded, other);
}

function show_response_row(parent, target) {
    const fit = campaign.surrogate && target.index >= 0 ? campaign.surrogate : null;
    const quality = fit && known(fit.leave_one_out_rmse[target.index])
        ? `${surrogate_kinds[fit.kind[target.index]]}, error ${number(fit.leave_one_out_rmse[target.index], 2)} (leave one out)`
        : null;
    const spread = fit && known(fit.replicate_sd[target.index])
        ? `between repeated runs ± ${number(fit.replicate_sd[target.index], 2)}` : null;
    const remark = [quality, spread].filter(Boolean).join(', ');
    parent.append(element('h3', {}, target.label, remark ? element('span', {class: 'note', style: 'font-weight:normal'},
                                                                   '   ' + remark) : null));
    const across = Math.min(campaign.factors.length, 4);
    const row = element('div', {class: 'columns', style: `grid-template-columns: repeat(${Math.max(across, 3)}, 1fr)`});
    parent.append(row);
    const runs = fitted_runs.filter((run) => run.experiment === target.experiment && known(run.responses[target.response]));
    const thinned = note_of_drawn(runs, 'runs');
    if (thinned) row.before(element('p', {class: 'note'}, thinned));
    const values = runs.map((run) => run.responses[target.response]);
    const bounds = target.index >= 0
        ? [target.value - (target.tolerance || 0), target.value + (target.tolerance || 0)] : [];
    const domain = extent(values.concat(bounds));
    campaign.factors.forEach((factor, index) => {
        show_response(row, target, factor, index, drawn(runs, is_best), domain, across > 3 ? 200 : 290);
    });
}

// 1 on the surrogate's slice along factor `index`, towards 0.4 for runs whose other factors are far from it.
function closeness(run, index) {
    const centre = campaign.surrogate && campaign.optimum.predicted_point;
    if (!centre) return 0.8;
    let square = 0;
    campaign.factors.forEach((factor, other) => {
        if (other !== index) square += (place_in_range(factor, run.factors[other]) - place_in_range(factor, centre[other])) ** 2;
    });
    return 0.4 + 0.6 * Math.exp(-square / (2 * 0.2 ** 2));
}

function show_response(parent, target, factor, index, runs, domain, width) {
    const dots = runs.map((run) => ({x: run.factors[index], y: run.responses[target.response], best: is_best(run),
        opacity: is_best(run) ? 1 : closeness(run, index), colour: is_best(run) ? colours.best : purpose_colour(run.purpose),
        text: `run ${run.run}: ${number(run.responses[target.response])} at ${number(run.factors[index])}`}))
        .sort((a, b) => a.opacity - b.opacity);
    const fit = target.index >= 0 ? campaign.surrogate : null;
    const slice = fit ? fit.slice_values[index].map((x, i) => {
        const y = fit.slices[target.index][index][i], sd = fit.slice_sd[target.index][index][i] || 0;
        return {x, y, lower: y - sd, upper: y + sd};
    }).filter((point) => known(point.y)) : [];
    const band = target.index >= 0 ? [{value: target.value, lower: target.value - (target.tolerance || 0),
                                       upper: target.value + (target.tolerance || 0)}] : [];
    const x_domain = [factor.lower, factor.upper];
    const wall_to_wall = {x: {value: 0}, x2: {signal: 'width'}};
    plot(parent, `response-${target.experiment}-${target.response}-${factor.name}`, {
        width, height: 150,
        data: [{name: 'dots', values: dots}, {name: 'slice', values: slice}, {name: 'band', values: band}],
        scales: [factor.log ? {...logarithmic('x', 'width', x_domain), nice: false} : linear('x', 'width', x_domain, {nice: false}),
                 linear('y', 'height', domain)],
        axes: [axis('bottom', 'x', words_of(factor.name), {grid: false, format: '~g'}),
               axis('left', 'y', null, {format: '~g', minExtent: 34})],
        marks: [
            mark('rect', 'band', {...wall_to_wall, y: {scale: 'y', field: 'upper'}, y2: {scale: 'y', field: 'lower'},
                fill: {value: colours.band}, fillOpacity: {value: 0.13}}),
            mark('rule', 'band', {...wall_to_wall, y: {scale: 'y', field: 'value'}, stroke: {value: colours.band},
                strokeWidth: {value: 1.5}}),
            mark('area', 'slice', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'lower'}, y2: {scale: 'y', field: 'upper'},
                fill: {value: colours.soft}, fillOpacity: {value: 0.14}}, {clip: true}),
            mark('line', 'slice', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'y'}, stroke: {value: colours.soft},
                strokeWidth: {value: 1.6}}, {clip: true}),
            mark('symbol', 'dots', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'y'}, size: {signal: 'datum.best ? 70 : 34'},
                fill: {field: 'colour'}, fillOpacity: {field: 'opacity'}, tooltip: {field: 'text'}}),
        ],
    });
}
