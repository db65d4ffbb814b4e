// The diagnosis of the gap: where the calibrated model misses, which effect it lacks, how far that goes.

function show_gap(parent) {
    const gap = campaign.gap;
    if (!gap) {
        parent.closest('section').remove();
        return;
    }
    if (gap.failure) {
        parent.append(element('p', {class: 'note'}, `Nothing can be diagnosed: ${gap.failure}.`));
        return;
    }
    const named = gap.which.named.length > 0 ? `: ${gap.which.named.map((name) => words_of(name)).join(', ')}` : '';
    const groups = gap.which.named_groups.map((group) => `: ${group.map((name) => words_of(name)).join(', ')}`).join('; ');
    parent.append(element('p', {}, element('b', {}, gap.which.verdict + named + groups),
        ` The largest deviation is ${number(gap.where.largest_sigmas, 3)} standard deviations of the floor; by chance, and counting `
        + `all that was tried, so much has p = ${number(gap.which.global_p, 2)}.`));
    const row = element('div', {class: 'columns', style: 'grid-template-columns: repeat(2, 1fr)'});
    parent.append(row);
    show_gap_cells(row, gap.where);
    show_gap_hypotheses(row, gap.which);
    if (gap.how_far && gap.how_far.effects.length > 0) show_closures(parent, gap.how_far);
    else parent.append(element('p', {class: 'note'}, 'How far an effect closes the gap is not known: '
        + ((gap.how_far && gap.how_far.failure) || 'no experiment was held out') + '.'));
    for (const one of gap.next.slice(0, 3))
        parent.append(element('p', {class: 'note'}, `Next: ${words_of(one.experiment)} tells the explanations apart by ${number(one.decides, 2)}, for ${number(one.cost, 2)} particle steps a run.`));
    show_signatures(parent, gap);
    const assumed = gap.assumed;
    parent.append(element('p', {class: 'note'}, `Assumed: form floor ${assumed.form_floor} of a response, form error `
        + `${assumed.form_error} of a signature; prior of none ${assumed.prior_none}, one effect ${assumed.prior_single}, two `
        + `${assumed.prior_pairs}, unknown ${assumed.prior_unknown}; named from ${assumed.named_from}.`));
    for (const note of gap.notes) parent.append(element('p', {class: 'note'}, note + '.'));
}

const short_cell = (name) => name.replace('.', ': ').replaceAll('_', ' ');

// A bar a cell, in standard deviations of what is left after the calibration was done again.
function show_gap_cells(parent, where) {
    const box = element('div');
    parent.append(box);
    const cells = where.cells.map((cell) => ({...cell, label: short_cell(cell.cell), shown: known(cell.sigmas) ? cell.sigmas : 0,
        colour: cell.finding === 'beyond the floor' ? colours.failed : known(cell.sigmas) ? colours.design : colours.line,
        tip: known(cell.sigmas) ? `off by ${signed(cell.residual)} ${printed_units(cell.units)}, floor ${number(cell.floor, 2)}` : cell.finding}));
    const reach = extent([0, -where.critical_sigmas, where.critical_sigmas, ...cells.map((cell) => cell.shown)]);
    plot(box, 'gap-cells', {
        width: 300, height: Math.max(80, 20 * cells.length),
        title: {text: 'Measured less simulated, in standard deviations'},
        data: [{name: 'cells', values: cells}, {name: 'limits', values: [{x: -where.critical_sigmas}, {x: where.critical_sigmas}]}],
        scales: [linear('x', 'width', reach), {name: 'y', type: 'band', range: 'height', domain: cells.map((cell) => cell.label), padding: 0.25}],
        axes: [axis('bottom', 'x', null, {format: '~g'}), axis('left', 'y', null, {grid: false, labelOverlap: false, labelLimit: 260})],
        marks: [
            mark('rule', 'limits', {x: {scale: 'x', field: 'x'}, y: {value: 0}, y2: {signal: 'height'}, stroke: {value: colours.soft}, strokeDash: {value: [4, 3]}}),
            mark('rect', 'cells', {y: {scale: 'y', field: 'label'}, height: {scale: 'y', band: 1}, x: {scale: 'x', field: 'shown'},
                x2: {scale: 'x', value: 0}, fill: {field: 'colour'}, tooltip: {signal: "datum.label + ': ' + datum.tip"}}),
        ],
    });
    legend(box, [['beyond the floor', colours.failed], ['within', colours.design], ['dashed: the largest by chance, 95 %', colours.soft]]);
    const hidden = where.cells.filter((cell) => !known(cell.sigmas));
    if (hidden.length > 0)
        box.append(element('p', {class: 'note'}, `Not testable, absorbed by recalibration: ${hidden.map((cell) => short_cell(cell.cell)).join(', ')}.`));
}

function show_gap_hypotheses(parent, which) {
    const box = element('div');
    parent.append(box);
    const shown = which.hypotheses.map((one) => ({label: one.effects.map((name) => words_of(name)).join(' and '), p: one.probability}))
        .sort((a, b) => b.p - a.p).filter((one, place) => place < 3 || one.p >= 0.02).slice(0, 12);
    plot(box, 'gap-hypotheses', {
        width: 300, height: Math.max(80, 20 * shown.length),
        title: {text: 'Probability of each explanation'},
        data: [{name: 'bars', values: shown}],
        scales: [linear('x', 'width', [0, 1], {nice: false}), {name: 'y', type: 'band', range: 'height', domain: shown.map((one) => one.label), padding: 0.25}],
        axes: [axis('bottom', 'x', null, {format: '~g'}), axis('left', 'y', null, {grid: false, labelOverlap: false, labelLimit: 260})],
        marks: [mark('rect', 'bars', {y: {scale: 'y', field: 'label'}, height: {scale: 'y', band: 1}, x: {scale: 'x', field: 'p'},
            x2: {scale: 'x', value: 0}, fill: {value: colours.accent}, tooltip: {signal: "datum.label + ': ' + format(datum.p, '.3f')"}})],
    });
    for (const group of which.groups.filter((one) => one.effects.length > 1))
        box.append(element('p', {class: 'note'}, `Cannot be told apart by these experiments: ${group.effects.map((name) => words_of(name)).join(', ')}.`));
    const acting = which.effects.filter((effect) => effect.probability >= 0.02).sort((a, b) => b.probability - a.probability);
    for (const effect of acting)
        box.append(element('p', {class: 'note'}, `${words_of(effect.effect)}: amplitude ${number(effect.amplitude, 3)} ± `
            + `${number(effect.amplitude_sd, 2)} (${effect.amplitude_meaning}); recalibration hides ${number(100 * effect.absorbed_share, 2)} %.`));
}

// Closure of each effect on held-out experiments with its interval, and the best of its decoys.
function show_closures(parent, how_far) {
    const shown = how_far.effects.filter((effect) => known(effect.closure)).map((effect) => ({...effect, label: words_of(effect.effect)}));
    if (shown.length === 0) {
        parent.append(element('p', {class: 'note'}, 'On held-out experiments the calibrated model is at the noise floor: there is no gap to close.'));
        return;
    }
    const values = shown.flatMap((effect) => [effect.closure, effect.lower, effect.upper, effect.best_decoy]);
    const box = element('div');
    parent.append(box);
    const clamp = (value) => known(value) ? Math.max(-1, value) : value;
    plot(box, 'gap-closures', {
        width: 500, height: 30 * shown.length,
        title: {text: 'Share of the gap on held-out experiments that an effect closes'},
        data: [{name: 'bars', values: shown.map((effect) => ({...effect, closure: clamp(effect.closure), lower: clamp(effect.lower), upper: clamp(effect.upper)}))},
               {name: 'decoys', values: shown.filter((effect) => known(effect.best_decoy)).map((effect) => ({...effect, best_decoy: clamp(effect.best_decoy)}))}],
        scales: [linear('x', 'width', extent([0, 1, ...values.map(clamp)]), {nice: false}),
                 {name: 'y', type: 'band', range: 'height', domain: shown.map((effect) => effect.label), padding: 0.35}],
        axes: [axis('bottom', 'x', null, {format: '%'}), axis('left', 'y', null, {grid: false, labelOverlap: false, labelLimit: 260})],
        marks: [
            mark('rect', 'bars', {y: {scale: 'y', field: 'label'}, height: {scale: 'y', band: 1}, x: {scale: 'x', field: 'closure'}, x2: {scale: 'x', value: 0},
                fill: {value: colours.band}, fillOpacity: {value: 0.6}}),
            mark('rule', 'bars', {y: {scale: 'y', field: 'label', band: 0.5}, x: {scale: 'x', field: 'lower'}, x2: {scale: 'x', field: 'upper'}, stroke: {value: colours.ink}}),
            mark('symbol', 'decoys', {y: {scale: 'y', field: 'label', band: 0.5}, x: {scale: 'x', field: 'best_decoy'}, shape: {value: 'diamond'},
                size: {value: 60}, fill: {value: colours.best}, tooltip: {signal: "datum.best_decoy_name"}}),
        ],
    });
    legend(box, [['closes; line: 90 % interval', colours.band], ['the best of its decoys, which have the same freedom', colours.best]]);
    const best = shown.reduce((a, b) => a.closure >= b.closure ? a : b);
    const table = element('table', {}, element('tr', {}, ...['held-out cell', 'off by', `off with ${best.label}`, 'floor'].map((text) => element('th', {class: 'text'}, text))));
    for (const cell of best.cells)
        table.append(element('tr', {}, element('td', {class: 'text'}, short_cell(cell.cell)), element('td', {}, `${signed(cell.before)} ${printed_units(cell.units)}`),
                             element('td', {}, signed(cell.after)), element('td', {}, number(cell.floor, 2))));
    parent.append(table);
}

// What a typical amplitude of each effect changes in each cell.
function show_signatures(parent, gap) {
    const cells = gap.where.cells.map((cell) => short_cell(cell.cell));
    const effects = gap.which.effects.map((effect) => words_of(effect.effect));
    const values = gap.which.effects.flatMap((effect) => effect.signature_sigmas.map((sigmas, place) =>
        ({effect: words_of(effect.effect), cell: cells[place], sigmas, shown: Math.max(-5, Math.min(5, sigmas))})));
    if (values.length === 0) return;
    const box = element('div');
    parent.append(box);
    plot(box, 'gap-signatures', {
        width: Math.max(160, 30 * cells.length), height: 18 * effects.length,
        title: {text: 'Signatures: what a typical amplitude changes, over the floor (red up, blue down, full colour from 5)'},
        data: [{name: 'tiles', values}],
        scales: [{name: 'x', type: 'band', range: 'width', domain: cells}, {name: 'y', type: 'band', range: 'height', domain: effects},
                 {name: 'colour', type: 'linear', domain: [-5, 0, 5], range: ['#3b7cc4', '#b9c0c8', '#c2412d']}],
        axes: [axis('bottom', 'x', null, {grid: false, labelOverlap: false, labelAngle: -50, labelAlign: 'right', labelLimit: 200}),
               axis('left', 'y', null, {grid: false, labelOverlap: false, labelLimit: 200})],
        marks: [mark('rect', 'tiles', {x: {scale: 'x', field: 'cell'}, width: {scale: 'x', band: 1}, y: {scale: 'y', field: 'effect'}, height: {scale: 'y', band: 1},
            fill: {scale: 'colour', field: 'shown'}, stroke: {value: colours.line}, tooltip: {signal: "datum.effect + ', ' + datum.cell + ': ' + format(datum.sigmas, '.2f')"}})],
    });
}
