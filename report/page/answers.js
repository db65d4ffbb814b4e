// What a reader came for, at the top: which values to use, how sure they are, what to measure next.

function show_answers(parent) {
    if (!campaign.optimum) {
        parent.append(element('p', {class: 'note'}, no_answer('answer')));
        return;
    }
    const cards = element('div', {class: 'answers'});
    parent.append(cards);
    const card = (title, ...children) => cards.append(element('article', {class: 'answer'}, element('h3', {}, title), ...children));
    card('Use these values', ...use_these_values());
    card('This sure', ...this_sure());
    card('Measure this next', ...measure_next());
}

// All digits that a number has.
const exact = (value) => value === null || value === undefined ? '' : String(value);
// A cell of a CSV file.
const csv_cell = (value) => /[",\n]/.test(exact(value)) ? '"' + exact(value).replace(/"/g, '""') + '"' : exact(value);

// One row a value: of the best run, with the estimate and its interval where it was calibrated.
function rows_of_values() {
    const optimum = campaign.optimum;
    return campaign.values.map((entry) => {
        const index = campaign.factors.findIndex((factor) => factor.path === entry.path);
        const interval = index >= 0 && optimum.interval ? optimum.interval[index] : [null, null];
        return {path: entry.path, value: entry.value, units: entry.units, calibrated: index >= 0 ? 'yes' : 'no',
                estimate: index >= 0 && optimum.estimate ? optimum.estimate[index] : null,
                lower_95: interval[0], upper_95: interval[1],
                verdict: index >= 0 && optimum.verdict_text ? optimum.verdict_text[index] : ''};
    });
}

function values_as_text(separator) {
    const rows = rows_of_values();
    const heads = Object.keys(rows[0]);
    const cell = separator === ',' ? csv_cell : exact;
    return [heads, ...rows.map((row) => heads.map((head) => row[head]))].map((cells) => cells.map(cell).join(separator)).join('\n') + '\n';
}

function download(name, type, text) {
    const link = element('a', {href: URL.createObjectURL(new Blob([text], {type})), download: name});
    link.click();
    URL.revokeObjectURL(link.href);
}

function copy_text(text, button) {
    const area = element('textarea', {'aria-hidden': 'true'});
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand('copy'); // works in a file that is opened from a disk, where the newer way does not
    area.remove();
    button.focus();
    button.textContent = 'Copied';
}

function use_these_values() {
    const rows = rows_of_values();
    const calibrated = rows.filter((row) => row.calibrated === 'yes');
    const table = (list) => simple_table(['value', 'of', 'unit'], list.map((row) => [
        element('td', {title: exact(row.value)}, element('b', {}, typeof row.value === 'number' ? number(row.value, 5) : row.value)),
        element('td', {class: 'text path'}, row.path), element('td', {class: 'text'}, printed_units(row.units))]));
    const button = (text, action) => {
        const made = element('button', {type: 'button'}, text);
        made.addEventListener('click', () => action(made));
        return made;
    };
    const file = campaign.name.replace(/[^A-Za-z0-9_-]+/g, '-').replace(/^-|-$/g, '') || 'values';
    return [
        element('p', {}, element('b', {class: campaign.optimum.missed ? 'bad' : ''}, 'The best run is ' + campaign.optimum.headline + '.')),
        table(calibrated),
        element('p', {class: 'buttons'},
            button('Copy', (made) => copy_text(values_as_text('\t'), made)),
            button('CSV', () => download(file + '.csv', 'text/csv', values_as_text(','))),
            button('JSON', () => download(file + '.json', 'application/json',
                JSON.stringify({campaign: campaign.name, fit: campaign.optimum.headline, values: rows}, null, 1)))),
        element('details', {}, element('summary', {}, `All ${rows.length} values of the model, fixed ones too`), table(rows)),
    ];
}

function this_sure() {
    const optimum = campaign.optimum;
    const lines = [...goodness_of_fit()];
    const judged = optimum.verdict_text && optimum.interval;
    if (!judged) return [...lines, element('p', {class: 'note'}, 'Not known yet: too few finished runs.')];
    const rows = campaign.factors.map((factor, index) => {
        const [lower, upper] = optimum.interval[index];
        const told = known(lower) && optimum.tells_interval[index];
        return [element('td', {title: factor.path}, words_of(factor.name)),
                element('td', {}, told ? `${number(lower, 3)} to ${number(upper, 3)}` : 'none'),
                element('td', {class: 'text ' + verdict_styles[optimum.verdict[index]]}, optimum.verdict_text[index])];
    });
    return [...lines, simple_table(['', '95 % interval', ''], rows)];
}

// In this order: that nothing can be said, what contradicts, what would tell traded-off factors apart, what is wide.
function measure_next() {
    const optimum = campaign.optimum, findings = campaign.findings;
    if (optimum.missed) {
        const worst = [...all_targets].sort((a, b) => Math.abs(off_by(b)) - Math.abs(off_by(a)))[0];
        return [element('p', {}, `First find out why ${worst.label} is ${number(Math.abs(off_by(worst)), 3)} scales off: look at the measurement and its standard `
            + 'deviation, at the bounds of the factors, and at what the model leaves out. More runs of the same do not help.')];
    }
    const open = campaign.factors.filter((factor, index) => optimum.verdict && ![0, 3].includes(optimum.verdict[index]));
    if (open.length === 0 && optimum.verdict && held_out_misses().length > 0) {
        const worst = held_out_misses()[0];
        return [element('p', {}, `All factors are determined, and yet the prediction of ${worst.cell} is ${number(Math.abs(worst.off), 2)} scales off: the model lacks something `
            + 'that acts there. Look at that measurement, fit to both conditions, or let [gap] look for the effect.')];
    }
    if (open.length === 0 && optimum.verdict)
        return [element('p', {}, 'Nothing is needed for these factors: all are determined'
            + (held_out_met() ? ', and what was held out is predicted within its scale.' : '. Predict a condition that was not fitted, and measure it.'))];
    const lines = ((findings && findings.pairs) || []).map((pair, index) => element('p', {}, tradeoff_text(findings, pair, index)));
    const traded = new Set(((findings && findings.pairs) || []).flat());
    for (const [index, factor] of campaign.factors.entries())
        if (open.includes(factor) && !traded.has(index)) lines.push(element('p', {}, open_factor_text(factor, index)));
    return lines.length > 0 ? lines : [element('p', {class: 'note'}, 'Not known yet: too few finished runs.')];
}

// What was held out and predicted more than a scale off, worst first.
const held_out_misses = () => (campaign.predicted || []).filter((one) => known(one.mean))
    .map((one) => ({cell: one.cell, off: (one.mean - one.measured) / one.scale}))
    .filter((one) => Math.abs(one.off) > 1).sort((a, b) => Math.abs(b.off) - Math.abs(a.off));

const held_out_met = () => (campaign.predicted || []).length > 0 && campaign.predicted.every((one) => known(one.mean)) && held_out_misses().length === 0;

const off_by = (target) => (campaign.optimum.responses[target.index] - target.value) / target.scale;

// Which target tells most of a factor that is not determined: its slope over the range, in standard deviations of the measurement.
function open_factor_text(factor, index) {
    const fit = campaign.surrogate;
    const strengths = fit ? all_targets.map((target) => {
        const [least, most] = range_of(fit.slices[target.index][index].filter(known));
        return {target, strength: (most - least) / (known(target.sd) && target.sd > 0 ? target.sd : target.scale)};
    }).sort((a, b) => b.strength - a.strength) : [];
    const name = words_of(factor.name);
    if (strengths.length === 0 || !(strengths[0].strength > 1))
        return `${name}: none of these targets depends on it. Measure something that does, or fix it.`;
    const {target} = strengths[0];
    return `${name}: ${target.label} depends on it most; measure it more exactly (its standard deviation now counts as `
        + `${number(known(target.sd) ? target.sd : target.scale, 2)}).`;
}
