// Small things that all parts of the page use.

const campaign = JSON.parse(document.getElementById('document').textContent);
// Runs come as rows under one list of keys.
for (const wave of campaign.waves)
    wave.runs = wave.runs.rows.map((row) => Object.fromEntries(wave.runs.keys.map((key, place) => [key, row[place]])));

// Those that follow the page into the dark are variables of its style.
const colours = {
    ink: 'var(--ink)', soft: 'var(--soft)', line: 'var(--line)', paper: 'var(--paper)', track: 'var(--track)', axis: 'var(--axis)',
    accent: '#3b7cc4', best: '#c2412d', band: '#3a9160', failed: '#d9534a',
    design: '#8b9db3', screening: '#a58fc2', search: '#3b7cc4', confirmation: '#c98a1b', signatures: '#6b9c8a', closure: '#2f7d4f',
};
const purpose_colour = (purpose) => colours[purpose] || colours.accent;

// What went wrong is kept where a test can read it, and shown.
const script_errors = [];
function report_error(error) {
    script_errors.push(String(error && error.message || error));
    document.body.dataset.errors = script_errors.length;
    let box = document.getElementById('errors');
    if (!box) {
        box = element('p', {id: 'errors'});
        document.body.prepend(box);
    }
    box.textContent = 'This page could not show everything: ' + script_errors.join('; ');
}
window.addEventListener('error', (event) => report_error(event.error || event.message));
window.addEventListener('unhandledrejection', (event) => report_error(event.reason));

// element('td', {class: 'text'}, 'a', child): an element with attributes and children.
function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    made.append(...children.filter((child) => child !== null && child !== undefined));
    return made;
}

const section = (id) => document.getElementById(id);
const known = (value) => typeof value === 'number' && Number.isFinite(value);

function number(value, digits = 4) {
    if (!known(value)) return '–';
    const rounded = Number(value.toPrecision(digits));
    const size = Math.abs(rounded);
    if (size !== 0 && (size < 1e-4 || size >= 1e7)) return rounded.toExponential();
    return String(rounded);
}

function signed(value, digits = 3) {
    return known(value) && value > 0 ? '+' + number(value, digits) : number(value, digits);
}

function duration(seconds) {
    if (!known(seconds)) return '–';
    if (seconds < 120) return number(seconds, 3) + ' s';
    if (seconds < 7200) return number(seconds / 60, 3) + ' min';
    return number(seconds / 3600, 3) + ' h';
}

const plural = (count, word) => count + ' ' + word + (count === 1 ? '' : 's');
const printed_units = (units) => ({deg: '°', '1': ''}[units] ?? units.replace('^2', '²').replace('^3', '³'));

// 'mass_flow_kg_s' with units 'kg/s' is 'mass flow' in words.
function words_of(name, units = '') {
    const suffix = '_' + units.replace(/\^/g, '').replace(/[^A-Za-z0-9]+/g, '_');
    const bare = suffix.length > 1 && name.endsWith(suffix) ? name.slice(0, -suffix.length) : name;
    return bare.replace(/_/g, ' ');
}

function label_of(name, units) {
    const printed = printed_units(units);
    return words_of(name, units) + (printed ? ' [' + printed + ']' : '');
}

// Everything about the target of that number: its experiment, response and a label.
function target_info(index) {
    const target = campaign.targets[index];
    const experiment = campaign.experiments[target.experiment];
    const response = experiment.responses[target.response];
    const prefix = campaign.experiments.length > 1 ? experiment.name + ': ' : '';
    return {...target, index, units: response.units, label: prefix + label_of(response.name, response.units),
            short: prefix + words_of(response.name, response.units)};
}

const all_targets = campaign.targets.map((_, index) => target_info(index));
const all_runs = campaign.waves.flatMap((wave) => wave.runs.map((run) => ({...run, purpose: wave.purpose})));
const finished_runs = all_runs.filter((run) => run.outcome === 'finished');
// Those that factors are fitted to; in the others effects act that the model lacks.
const calibrating_runs = all_runs.filter((run) => run.purpose !== 'signatures' && run.purpose !== 'closure');
const failed_runs = all_runs.filter((run) => run.outcome === 'failed');
const several_experiments = campaign.experiments.length > 1;

// Wall time of a wave [s]; of one under way, up to the last run that ended.
function length_of(wave) {
    return wave.wall_time || range_of([0, ...wave.runs.map((run) => run.start_time + run.wall_time).filter(known)])[1];
}

function same_point(a, b) {
    return Boolean(a && b) && a.length === b.length && a.every((value, index) => value === b[index]);
}
const is_best = (run) => campaign.optimum !== null && same_point(run.factors, campaign.optimum.point);

// Place of a value in a factor's range, 0 at its lower bound and 1 at its upper one.
function place_in_range(factor, value) {
    const scale = factor.log ? Math.log : (x) => x;
    return (scale(value) - scale(factor.lower)) / (scale(factor.upper) - scale(factor.lower));
}

// At most so many marks of a plot: a browser takes minutes to draw tens of thousands.
const most_drawn = 2000;

// Every n-th of a list that is longer, and those that `keep` asks for.
function drawn(list, keep = () => false) {
    const stride = list.length / most_drawn;
    let next = 0;
    return stride <= 1 ? list : list.filter((entry, index) => {
        const due = index >= next;
        if (due) next += stride;
        return due || keep(entry);
    });
}

// What to say beside a plot of a list that is thinned; empty where all of it is drawn.
function note_of_drawn(list, what) {
    return list.length <= most_drawn ? '' : ` ${most_drawn} of ${list.length} ${what}, evenly taken, are drawn.`;
}

// Least and greatest of numbers; Math.min(...) fails on some 100,000 of them.
function range_of(numbers) {
    return numbers.reduce(([least, most], value) => [Math.min(least, value), Math.max(most, value)], [Infinity, -Infinity]);
}
