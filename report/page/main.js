// The page, from top to bottom. The document `campaign` has: name, file, seed, ended, extensions, stop, factors, constraints,
// experiments, targets, warnings, live (while it is worked on), waves (with their runs), history, optimum, values, progress, surrogate,
// details (pictures, series), failed_pictures, asked_pictures and films (of runs that somebody asked for), gap, input.

function show_headline() {
    section('name').textContent = campaign.name;
    const rigs = [...new Set(campaign.experiments.map((experiment) => experiment.rig))].join(', ');
    section('subtitle').textContent = `Calibration of ${plural(campaign.factors.length, 'factor')} against `
        + `${plural(campaign.targets.length, 'target')} of ${plural(campaign.experiments.length, 'experiment')} (${rigs})`
        + (campaign.file ? `, from ${campaign.file}` : '') + `, seed ${campaign.seed}`;

    const tile = (value, what, more) => element('div', {class: 'tile'}, element('b', {}, value), element('span', {}, what),
                                                more ? element('small', {}, more) : null);
    const optimum = campaign.optimum;
    const limits = all_targets.filter((target) => known(target.tolerance));
    const met = optimum ? limits.filter((target) =>
        Math.abs(optimum.responses[target.index] - target.value) <= target.tolerance).length : 0;
    const waiting = all_runs.filter((run) => run.outcome === 'waiting').length;
    const spent = campaign.waves.reduce((sum, wave) => sum + length_of(wave), 0);
    const tiles = [
        tile(optimum ? number(optimum.largest, 2) : '–', optimum ? `${optimum.yardstick}s off at most, best run` : 'no best fit yet'),
        ...(limits.length > 0 && optimum ? [tile(`${met} of ${limits.length}`, 'targets within tolerance')] : []),
        tile(String(finished_runs.length), 'runs finished', waiting > 0 ? `${waiting} still to run` : null),
        tile(String(failed_runs.length), 'runs failed'),
        tile(String(campaign.waves.length), campaign.waves.length === 1 ? 'wave' : 'waves'),
        tile(duration(spent), 'wall time of the waves'),
    ];
    section('tiles').append(...tiles);
    for (const extension of campaign.extensions)
        section('ended').after(element('details', {class: 'note'},
            element('summary', {}, `Extended: from wave ${extension.first_wave} on the input is another.`),
            element('ul', {}, ...extension.changes.map((change) => element('li', {}, change)))));
    section('ended').append(element('b', {}, campaign.ended ? 'Ended: ' : 'Not ended yet. '),
                            campaign.ended || (campaign.live ? live_text(campaign.live) : 'The same command goes on with it.'));
    for (const warning of campaign.warnings)
        section('ended').after(element('p', {class: 'bad'}, `Warning: ${warning}.`));
    if (campaign.constraints.length > 0)
        section('ended').after(element('p', {class: 'note'}, `Kept throughout: ${campaign.constraints.join(', ')}.`));
}

function live_text(live) {
    return `${live.done} of ${plural(live.planned, 'run')} done, ${live.running} in progress`
        + (live.failed > 0 ? `, ${live.failed} failed` : '')
        + (known(live.time_left) ? `; this wave takes another ${duration(live.time_left)}` : '')
        + `. This page loads itself again every ${duration(live.reload_every)}.`;
}

function show_input(parent) {
    const fold = (title, text) => element('details', {}, element('summary', {}, title), element('pre', {}, text));
    parent.append(fold('As written by its author', campaign.input.text),
                  fold('Resolved: complete with every default', campaign.input.resolved));
}

const parts = {
    answers: show_answers, pairs: show_pairs, importance: show_importance, progress: show_progress,
    fit: show_fit, pictures: show_pictures, convergence: show_convergence, determination: show_determination,
    responses: show_responses, comparison: show_comparison, gap: show_gap, series: show_series, runs: show_runs, timing: show_timing, input: show_input,
};

document.body.dataset.errors = 0;
try {
    show_headline();
} catch (error) {
    report_error(error);
}
for (const [id, show] of Object.entries(parts)) {
    try {
        show(section(id));
    } catch (error) {
        report_error(error);
    }
}
Promise.all(pending_plots).then(() => { document.body.dataset.ready = 'yes'; });
if (campaign.live)
    setTimeout(() => location.reload(), 1000 * campaign.live.reload_every);
