// Curves of the shown runs, over time and, profiles, over another axis; how the campaign used its time and ranks.

function show_series(parent) {
    const shown = campaign.details.filter((details) => details.series.length > 1 && details.series[0].values.length > 1);
    if (shown.length === 0) parent.append(element('p', {class: 'note'}, campaign.details.length > 0 ? 'This rig keeps no time series.' : 'No run has finished yet.'));
    for (const details of shown) {
        parent.append(element('p', {class: 'note'}, title_of_details(details)));
        const row = element('div', {class: 'columns', style: 'grid-template-columns: repeat(3, 1fr)'});
        parent.append(row);
        const [time, ...columns] = details.series;
        for (const column of columns)
            show_line(row, `series-${details.experiment}-${column.name}`, label_of(column.name, column.units), time, column);
        for (const profile of details.profiles) {
            const [along, value] = profile.columns;
            show_line(row, `profile-${details.experiment}-${profile.name}`, `${profile.name}: ${label_of(value.name, value.units)}`,
                along, value);
        }
    }
}

function title_of_details(details) {
    const experiment = several_experiments ? campaign.experiments[details.experiment].name + ', ' : '';
    return `${experiment}run ${details.run}, ` + (details.is_best ? 'at the best point' : 'the last one that finished');
}

function show_line(parent, id, title, time, column) {
    const points = time.values.map((t, i) => ({t, y: column.values[i]})).filter((point) => known(point.t) && known(point.y));
    if (points.length === 0) return;
    plot(parent, id, {
        width: 290, height: 160,
        title: {text: title},
        data: [{name: 'points', values: points}],
        scales: [linear('x', 'width', extent(points.map((p) => p.t), 0), {nice: false}),
                 linear('y', 'height', extent(points.map((p) => p.y)))],
        axes: [axis('bottom', 'x', label_of(time.name, time.units), {grid: false}),
               axis('left', 'y', null, {format: '~g', minExtent: 34})],
        marks: [mark('line', 'points', {x: {scale: 'x', field: 't'}, y: {scale: 'y', field: 'y'},
            stroke: {value: colours.accent}, strokeWidth: {value: 1.6}})],
    });
}

function show_timing(parent) {
    let offset = 0;
    const bars = [], borders = [];
    let capacity = 0, used = 0;
    for (const wave of campaign.waves) {
        const ran = wave.runs.filter((run) => run.group >= 0 && known(run.wall_time));
        for (const run of ran) {
            const failed = run.outcome !== 'finished';
            bars.push({group: run.group, start: offset + run.start_time, end: offset + run.start_time + run.wall_time,
                colour: failed ? colours.failed : purpose_colour(wave.purpose),
                text: `run ${run.run}: ${duration(run.wall_time)}, ${run.status}`});
        }
        const length = length_of(wave);
        offset += length;
        borders.push({time: offset});
        if (wave.time_of_groups > 0) {
            capacity += wave.time_of_groups;
            used += ran.reduce((sum, run) => sum + run.wall_time, 0);
        }
    }
    if (bars.length === 0) {
        parent.append(element('p', {class: 'note'}, 'No run has ended yet.'));
        return;
    }
    const unit = offset < 300 ? [1, 's'] : offset < 18000 ? [60, 'min'] : [3600, 'h'];
    for (const bar of bars) bar.start /= unit[0], bar.end /= unit[0];
    for (const border of borders) border.time /= unit[0];
    const groups = [...new Set(bars.map((bar) => bar.group))].sort((a, b) => a - b);
    const times = bars.map((bar) => bar.end - bar.start);
    const mean = times.reduce((sum, time) => sum + time, 0) / times.length;
    parent.append(element('p', {}, `${plural(bars.length, 'run')} in ${duration(offset)}, `
        + `${duration(mean * unit[0])} a run on average`
        + (capacity > 0 ? `; groups were busy ${number(100 * used / capacity, 3)} % of the time, gather and choice of points included.` : '.')));
    legend(parent, [...new Set(campaign.waves.map((wave) => wave.purpose))].map((purpose) => [purpose, purpose_colour(purpose)])
        .concat(failed_runs.length > 0 ? [['failed', colours.failed]] : []));
    plot(parent, 'timing', {
        width: 1000, height: Math.max(40, Math.min(26 * groups.length, 520)),
        data: [{name: 'bars', values: drawn(bars)}, {name: 'borders', values: borders}],
        scales: [linear('x', 'width', [0, offset / unit[0]], {nice: false}),
                 {name: 'y', type: 'band', range: 'height', domain: groups, padding: 0.12}],
        axes: [axis('bottom', 'x', `time in waves [${unit[1]}]`, {grid: false, tickCount: 10}),
               {orient: 'left', scale: 'y', title: 'group', ticks: false, domain: false, labelOverlap: true}],
        marks: [
            mark('rect', 'bars', {x: {scale: 'x', field: 'start'}, x2: {scale: 'x', field: 'end'}, y: {scale: 'y', field: 'group'},
                height: {scale: 'y', band: 1}, fill: {field: 'colour'}, fillOpacity: {value: 0.8}, stroke: {value: colours.paper},
                strokeWidth: {value: 0.6}, tooltip: {field: 'text'}}),
            mark('rule', 'borders', {x: {scale: 'x', field: 'time'}, y: {value: -4}, y2: {signal: 'height + 4'},
                stroke: {value: colours.soft}, strokeDash: {value: [3, 3]}}),
        ],
    });
    parent.append(element('p', {class: 'note'}, 'One bar a run, one row a group of ranks; dashed lines end the waves. Pauses between '
        + 'waves and between sessions are left out.'
        + note_of_drawn(bars, 'runs')));
}
