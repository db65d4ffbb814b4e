// The table of runs, sorted by a click on a column's head.

function run_columns() {
    const factor_columns = campaign.factors.map((factor, index) => ({
        head: words_of(factor.name), value: (run) => run.factors[index]}));
    const names = [...new Set(campaign.experiments.flatMap((e) => e.responses.map((response) => response.name)))];
    const response_columns = names.map((name) => {
        const places = campaign.experiments.map((e) => e.responses.findIndex((response) => response.name === name));
        const units = campaign.experiments.flatMap((e) => e.responses).find((response) => response.name === name).units;
        return {head: label_of(name, units), value: (run) => run.responses[places[run.experiment]]};
    });
    return [
        {head: 'run', value: (run) => run.run},
        {head: 'wave', value: (run) => run.wave},
        {head: 'purpose', text: true, value: (run) => run.purpose},
        {head: 'point', value: (run) => run.point},
        ...(several_experiments
            ? [{head: 'experiment', text: true, value: (run) => campaign.experiments[run.experiment].name}] : []),
        ...(campaign.experiments.some((e) => e.replicates > 1) ? [{head: 'replicate', value: (run) => run.replicate}] : []),
        {head: 'status', text: true, value: (run) => run.status},
        ...factor_columns, ...response_columns,
        {head: 'wall time [s]', value: (run) => run.outcome === 'waiting' ? null : run.wall_time},
    ];
}

function show_runs(parent) {
    if (all_runs.length === 0) {
        parent.append(element('p', {class: 'note'}, 'No run is planned yet.'));
        return;
    }
    if (failed_runs.length > 0) parent.append(list_of_failures());
    const columns = run_columns();
    const body = element('tbody');
    const heads = columns.map((column) => element('th', {scope: 'col', tabindex: '0', 'aria-sort': 'none', ...(column.text ? {class: 'text'} : {})}, column.head));
    const line_of = (run) => element('tr',
        {class: run.outcome === 'finished' && is_best(run) ? 'best' : run.outcome, title: run.reason},
        ...columns.map((column) => {
            const value = column.value(run);
            const text = column.text ? String(value ?? '') : Number.isInteger(value) ? String(value) : number(value);
            return element('td', column.text ? {class: 'text'} : {}, text);
        }));
    // A browser takes minutes for tens of thousands of lines: further ones are made when they are asked for.
    const at_a_time = 200;
    const more = element('button', {type: 'button'}, '');
    let shown = [], lines = 0;
    const add = () => {
        body.append(...shown.slice(lines, lines + at_a_time).map(line_of));
        lines = Math.min(lines + at_a_time, shown.length);
        more.textContent = `Show more: ${lines} of ${shown.length} runs are shown`;
        more.hidden = lines === shown.length;
    };
    const fill = (runs) => {
        body.replaceChildren();
        [shown, lines] = [runs, 0];
        add();
    };
    more.addEventListener('click', add);
    const sort_by = (index) => {
        const head = heads[index], down = head.dataset.order === 'up';
        heads.forEach((other) => { delete other.dataset.order; other.setAttribute('aria-sort', 'none'); });
        head.dataset.order = down ? 'down' : 'up';
        head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
        fill(sorted_by(columns[index], down));
    };
    heads.forEach((head, index) => {
        head.addEventListener('click', () => sort_by(index));
        head.addEventListener('keydown', (event) => {
            if (event.key !== 'Enter' && event.key !== ' ') return;
            event.preventDefault();
            sort_by(index);
        });
    });
    fill(all_runs);
    parent.append(element('p', {class: 'note'}, (failed_runs.length > 0 ? 'Red: failed, kept out of all fits. ' : '')
        + 'Green: best point. Click on a column to sort by it.'));
    parent.append(element('div', {class: 'scroll'},
        element('table', {class: 'sortable'}, element('thead', {}, element('tr', {}, ...heads)), body), more));
}

function list_of_failures() {
    const most = 200;
    const lines = failed_runs.slice(0, most).map((run) => element('li', {}, element('b', {}, `Run ${run.run}, ${run.status}: `), run.reason || '–'));
    if (failed_runs.length > most)
        lines.push(element('li', {}, `and ${failed_runs.length - most} more: see the table`));
    const list = element('ul', {class: 'failures'}, ...lines);
    return failed_runs.length <= 8 ? list
        : element('details', {}, element('summary', {}, `Why ${failed_runs.length} runs failed`), list);
}

// Runs without a value come last in both orders.
function sorted_by(column, down) {
    const missing = (value) => value === null || value === undefined || value === '';
    return [...all_runs].sort((a, b) => {
        const x = column.value(a), y = column.value(b);
        if (missing(x) || missing(y)) return Number(missing(x)) - Number(missing(y));
        const order = column.text ? x.localeCompare(y) : x - y;
        return down ? -order : order;
    });
}
