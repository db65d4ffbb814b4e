// Measured curves and photographs beside the shown run: where along them the model is off.

function show_comparison(parent) {
    const shown = campaign.details.filter((details) => (details.curves || []).length > 0 || details.photograph);
    if (shown.length === 0) {
        parent.closest('section').remove();
        return;
    }
    for (const details of shown) {
        parent.append(element('p', {class: 'note'}, title_of_details(details)));
        for (const curve of details.curves) show_measured_curve(parent, details, curve);
        if (details.photograph) show_photograph(parent, details, details.photograph);
    }
}

// How far a target is met, in standard deviations of it (in scales where none is known): by the best run and as predicted.
function deviations_of(target) {
    const unit = known(target.sd) ? target.sd : target.scale;
    const optimum = campaign.optimum;
    const off = (values) => values && known(values[target.index]) ? (values[target.index] - target.value) / unit : null;
    return optimum ? {best: off(optimum.responses), estimate: off(optimum.estimate_responses),
                      sd: optimum.estimate_sd && known(optimum.estimate_sd[target.index]) ? optimum.estimate_sd[target.index] / unit : null} : {};
}

function show_measured_curve(parent, details, curve) {
    const row = element('div', {class: 'columns', style: 'grid-template-columns: repeat(2, 1fr)'});
    parent.append(row);
    const points = (given) => given.axis.map((x, i) => ({x, y: given.values[i]})).filter((p) => known(p.x) && known(p.y));
    const measured = points(curve.measured).map((p) => ({...p, low: p.y - curve.sd, high: p.y + curve.sd}));
    const [from, to] = range_of(measured.map((p) => p.x));
    const simulated = points(curve.simulated).filter((p) => p.x >= from && p.x <= to);
    const optimum = campaign.optimum;
    const bands = curve.windows.map((window) => ({...window, y: optimum && optimum.estimate_responses ? optimum.estimate_responses[window.target] : null,
        sd: optimum && optimum.estimate_sd ? optimum.estimate_sd[window.target] : null})).filter((band) => known(band.y))
        .map((band) => ({...band, low: band.y - 2 * (band.sd || 0), high: band.y + 2 * (band.sd || 0)}));
    const box = element('div');
    row.append(box);
    plot(box, `curve-${details.experiment}-${curve.name}`, {
        width: 430, height: 240,
        title: {text: label_of(curve.name, curve.units) + (curve.shift ? `, moved by ${number(curve.shift, 3)} ${curve.axis_units}` : '')},
        data: [{name: 'measured', values: measured}, {name: 'simulated', values: simulated}, {name: 'bands', values: bands},
               {name: 'borders', values: curve.windows.slice(1)}],
        scales: [linear('x', 'width', [from, to], {nice: false}),
                 linear('y', 'height', extent([...measured.flatMap((p) => [p.low, p.high]), ...simulated.map((p) => p.y)]))],
        axes: [axis('bottom', 'x', curve.axis_units ? `${curve.axis} [${curve.axis_units}]` : curve.axis, {grid: false}),
               axis('left', 'y', null, {format: '~g', minExtent: 34})],
        marks: [
            mark('rule', 'borders', {x: {scale: 'x', field: 'from'}, y: {value: 0}, y2: {signal: 'height'}, stroke: {value: colours.line}}),
            mark('area', 'measured', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'low'}, y2: {scale: 'y', field: 'high'},
                fill: {value: colours.best}, fillOpacity: {value: 0.15}}),
            mark('rect', 'bands', {x: {scale: 'x', field: 'from'}, x2: {scale: 'x', field: 'to'}, y: {scale: 'y', field: 'low'},
                y2: {scale: 'y', field: 'high'}, fill: {value: colours.accent}, fillOpacity: {value: 0.2}}),
            mark('line', 'measured', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'y'}, stroke: {value: colours.best}}),
            mark('line', 'simulated', {x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: 'y'}, stroke: {value: colours.accent},
                strokeWidth: {value: 1.6}}),
        ],
    });
    show_window_deviations(row, `windows-${details.experiment}-${curve.name}`,
        curve.windows.map((window) => ({...deviations_of(all_targets[window.target]), name: words_of(window.name)})));
    legend(parent, [['measured ± sd', colours.best], ['simulated; boxes: mean of each window as predicted at the estimate, ± 2 sd', colours.accent]]);
}

// A bar a window: deviation of the best run, with a tick for the estimate.
function show_window_deviations(parent, id, windows) {
    const box = element('div');
    parent.append(box);
    const known_windows = windows.filter((window) => known(window.best));
    if (known_windows.length === 0) return;
    plot(box, id, {
        width: 430, height: 240,
        title: {text: 'Simulated less measured, in standard deviations'},
        data: [{name: 'bars', values: known_windows}, {name: 'ticks', values: known_windows.filter((window) => known(window.estimate))}],
        scales: [{name: 'x', type: 'band', range: 'width', domain: known_windows.map((window) => window.name), padding: 0.25},
                 linear('y', 'height', extent([0, ...known_windows.flatMap((window) => [window.best, window.estimate])]))],
        axes: [axis('bottom', 'x', null, {grid: false, labelOverlap: false}), axis('left', 'y', null, {format: '~g', minExtent: 34})],
        marks: [
            mark('rect', 'bars', {x: {scale: 'x', field: 'name'}, width: {scale: 'x', band: 1}, y: {scale: 'y', field: 'best'},
                y2: {scale: 'y', value: 0}, fill: {signal: `abs(datum.best) > 2 ? '${colours.failed}' : '${colours.accent}'`},
                tooltip: {signal: "datum.name + ': ' + format(datum.best, '.2f') + ' sd'"}}),
            mark('symbol', 'ticks', {x: {scale: 'x', field: 'name', band: 0.5}, y: {scale: 'y', field: 'estimate'}, shape: {value: 'diamond'},
                size: {value: 60}, fill: {value: colours.ink}}),
        ],
    });
}

// What pixels are: light, bed in both, in the photograph alone, in the simulation alone.
const overlay_colours = ['#ffffff', '#b9a688', '#005adc', '#f08c00'];

function show_photograph(parent, details, photograph) {
    const row = element('div', {class: 'columns', style: 'grid-template-columns: repeat(2, 1fr)'});
    parent.append(row);
    const canvas = element('canvas', {class: 'picture', 'data-plot': `photograph-${details.experiment}`});
    row.append(element('figure', {}, canvas, element('figcaption', {},
        `Bed in both (brown), in the photograph alone (blue), in the simulation alone (orange): ${number(photograph.mismatch_mm2, 3)} mm² differ `
        + `within the circle`)));
    draw_overlay(canvas, photograph);
    show_window_deviations(row, `segments-${details.experiment}`, photograph.segments.map((segment) => (
        {...deviations_of(all_targets[segment.target]), name: number(segment.x, 3)})));
    parent.append(element('p', {class: 'note'}, 'Height of the surface over the place along the horizontal diameter [mm]. Bars: best run, red beyond 2 sd. '
        + 'Diamonds: as predicted at the estimate' + predicted_mismatch(photograph) + '.'));
}

// The mismatch follows from the predicted surface: it is not fitted, as it has a kink where the surface is met.
function predicted_mismatch(photograph) {
    const predicted = campaign.optimum && campaign.optimum.estimate_responses;
    if (!predicted) return '';
    const area = photograph.segments.reduce((sum, segment) => sum + photograph.segment_mm
        * Math.abs(predicted[segment.target] - all_targets[segment.target].value), 0);
    return `, from which ${number(area, 3)} mm² would differ in these segments`;
}

function draw_overlay(canvas, photograph) {
    canvas.width = photograph.columns;
    canvas.height = photograph.rows;
    const context = canvas.getContext('2d'), image = context.createImageData(canvas.width, canvas.height);
    const covered = (runs) => {
        const mask = new Uint8Array(canvas.width * canvas.height);
        let at = 0;
        runs.forEach((length, index) => { if (index % 2) mask.fill(1, at, at + length); at += length; });
        return mask;
    };
    const measured = covered(photograph.measured), simulated = covered(photograph.simulated);
    for (let k = 0; k < measured.length; ++k) {
        const hex = parseInt(overlay_colours[measured[k] ? (simulated[k] ? 1 : 2) : (simulated[k] ? 3 : 0)].slice(1), 16);
        image.data.set([hex >> 16, (hex >> 8) & 255, hex & 255, 255], 4 * k);
    }
    context.putImageData(image, 0, 0);
    const [x, y, radius] = photograph.circle;
    for (const [share, colour] of [[1, '#3c4754'], [photograph.inside, '#00963c']]) {
        context.beginPath();
        context.arc(x, y, share * radius, 0, 2 * Math.PI);
        context.strokeStyle = colour;
        context.stroke();
    }
    canvas.dataset.marks = measured.length;
}
