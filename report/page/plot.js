// Plots are plain Vega specifications drawn as SVG. A finished plot says in data-marks how many marks it has.

const vega = (() => {
    const {transforms} = require('vega-dataflow');
    for (const name of ['transforms', 'view-transforms', 'encode']) Object.assign(transforms, require('vega-' + name));
    return {View: require('vega-view').View, parse: require('vega-parser').parse};
})();

const plot_style = {
    background: null,
    font: 'Helvetica Neue, Helvetica, Arial, Liberation Sans, sans-serif',
    axis: {
        labelColor: colours.soft, labelFontSize: 11, titleColor: colours.ink, titleFontSize: 12, titleFontWeight: 'normal',
        domainColor: colours.axis, tickColor: colours.axis, tickSize: 4, gridColor: colours.track, labelFlush: false, titlePadding: 7,
    },
    legend: {labelFontSize: 12, labelColor: colours.ink, symbolSize: 70},
    title: {fontSize: 12.5, fontWeight: 600, color: colours.ink, anchor: 'start', offset: 8},
};

const pending_plots = [];

function count_marks(container) {
    const shapes = '.role-mark:not(.mark-group) > ';
    return container.querySelectorAll(['path', 'line', 'text', 'rect'].map((tag) => shapes + tag).join(', ')).length;
}

// Ticks of a logarithmic axis as people write them: 1, 2, 5 and 10 times powers of ten, or these powers alone where there are many.
function log_ticks(least, most) {
    const first = Math.floor(Math.log10(least)), last = Math.ceil(Math.log10(most));
    const steps = Math.log10(most / least) < 2.5 ? [1, 2, 5] : [1], ticks = [];
    for (let power = first; power <= last; ++power)
        for (const step of steps) ticks.push(Number(`${step}e${power}`));
    return ticks.filter((tick) => tick >= least * (1 - 1e-9) && tick <= most * (1 + 1e-9));
}

function with_log_ticks(axis, scales) {
    const scale = (scales || []).find((one) => one.name === axis.scale);
    if (!scale || scale.type !== 'log') return axis;
    const [least, most] = scale.nice ? scale.domain.map((end, i) => 10 ** (i ? Math.ceil : Math.floor)(Math.log10(end))) : scale.domain;
    return {...axis, values: log_ticks(least, most)};
}

// Draws a specification into a new element of `parent`.
function plot(parent, name, specification) {
    const title = specification.description || (specification.title && specification.title.text)
        || (specification.axes || []).map((one) => one.title).filter(Boolean).join(' over ') || words_of(name);
    const container = element('div', {class: 'plot', 'data-plot': name, role: 'img', 'aria-label': 'Plot: ' + title});
    parent.append(container);
    // On a phone a plot is drawn narrower, not shrunk: its letters stay readable.
    const room = document.documentElement.clientWidth - 130;
    if (specification.width > room && room > 0) specification = {...specification, width: Math.max(160, room)};
    if (specification.axes)
        specification = {...specification, axes: specification.axes.map((one) => with_log_ticks(one, specification.scales))};
    const view = new vega.View(vega.parse({autosize: 'pad', padding: 4, ...specification}, plot_style),
                               {renderer: 'svg', container, hover: true});
    pending_plots.push(view.runAsync().then(() => {
        container.dataset.marks = count_marks(container);
    }).catch(report_error));
    return container;
}

// Shorthand for the pieces that most plots have.
const linear = (name, range, domain, more = {}) => ({name, type: 'linear', range, domain, nice: true, zero: false, ...more});
const logarithmic = (name, range, domain) => ({name, type: 'log', range, domain, nice: true});
// '~g' is numbers as people write them: 25,000 and not 2.5e+4.
const plain_labels = {labels: {update: {text: {
    signal: "abs(datum.value) >= 1e4 && abs(datum.value) < 1e7 ? format(datum.value, ',') : format(datum.value, '~g')"}}}};
function axis(orient, scale, title, {format, ...more} = {}) {
    const labels = format === '~g' ? {encode: plain_labels} : format ? {format} : {};
    return {orient, scale, title, grid: true, tickCount: 5, labelOverlap: true, ...labels, ...more};
}
const mark = (type, data, encode, more = {}) => ({type, from: data && {data}, encode: {update: encode}, ...more});

function extent(values, margin = 0.05) {
    const numbers = values.filter(known);
    if (numbers.length === 0) return [0, 1];
    const [lower, upper] = range_of(numbers);
    const room = margin * (upper - lower) || Math.abs(upper) * 0.05 || 0.5;
    return [lower - room, upper + room];
}

// A legend of coloured dots above plots, in HTML so that it can be shared.
function legend(parent, entries) {
    const line = element('p', {class: 'note'});
    for (const [text, colour] of entries)
        line.append(element('span', {style: `color:${colour}; font-size:15px`}, '● '), text + '   ');
    line.style.whiteSpace = 'pre-wrap';
    parent.append(line);
}
