// Where the targets can be met, which factors trade off, and which act at all.

const surrogate_kinds = ['constant', 'linear', 'linear and squares', 'quadratic', 'radial basis functions', 'Gaussian process'];

function show_findings(parent) {
    const findings = campaign.findings;
    if (!findings) return;
    const where = findings.by_tolerance ? 'Every target with a tolerance is predicted within it'
        : targets_missed(campaign.optimum) ? 'Nothing meets the targets together; nearest to them, with the noise enlarged, it comes'
        : 'The targets allow, at 95 %, parameter sets';
    const parts = findings.part_shares || [];
    parent.append(element('p', {}, parts.length === 0 ? `${where} nowhere.`
        : `${where} in ${number(100 * findings.share, 2)} % of the range, `
          + (parts.length === 1 ? 'in one region.' : `in ${parts.length} separate regions.`)));
    if (parts.length > 0) parent.append(region_table(findings));
    (findings.pairs || []).forEach((pair, index) => parent.append(element('p', {}, tradeoff_text(findings, pair, index))));
}

function region_table(findings) {
    const heads = ['region', 'share', ...campaign.factors.map((factor) => words_of(factor.name))];
    const rows = findings.part_shares.slice(0, 6).map((share, part) => [
        element('td', {}, String(part + 1)),
        element('td', {}, number(100 * share, 2) + ' %'),
        ...campaign.factors.map((factor, index) => element('td', {},
            `${number(findings.part_lower[part][index], 3)} to ${number(findings.part_upper[part][index], 3)}`)),
    ]);
    return simple_table(heads, rows);
}

function tradeoff_text(findings, [first, second], index) {
    const names = [first, second].map((factor) => words_of(campaign.factors[factor].name));
    const [experiment, response] = findings.separated_by[index];
    const start = `${names[0]} and ${names[1]} trade off (correlation ${number(findings.correlation[index], 2)}): `;
    if (experiment < 0) return start + 'no response that is simulated would separate them.';
    const {name, units} = campaign.experiments[experiment].responses[response];
    const prefix = several_experiments ? campaign.experiments[experiment].name + ': ' : '';
    return `${start}measuring ${prefix}${words_of(name, units)} as well would take away `
        + `${number(100 * findings.variance_removed[index], 2)} % of that.`;
}

function show_screening(parent) {
    const screening = campaign.screening;
    if (!screening) return;
    const rows = campaign.factors.map((factor, index) => [
        element('td', {title: factor.path}, words_of(factor.name)),
        ...all_targets.map((target) => {
            const p = screening.p_values[target.index][index];
            return element('td', {}, `${signed(screening.effects[target.index][index], 3)} (p ${number(p, 2)})`);
        }),
        element('td', {class: 'text'}, screening.active[index] ? 'active'
            : known(screening.fixed_value[index]) ? `inactive, kept at ${number(screening.fixed_value[index])}` : 'inactive'),
    ]);
    const curved = all_targets.filter((target) => screening.curved && screening.curved[target.index])
        .map((target) => element('p', {class: 'bad'}, `${target.label} is off by ${signed(screening.curvature[target.index], 3)} `
            + `at the centre (p ${number(screening.curvature_p[target.index], 2)}): some factor acts by its square, which main `
            + 'effects do not show, so that all stay free.'));
    parent.append(element('h3', {}, 'Screening: effects from the lower to the upper bound'),
        simple_table(['factor', ...all_targets.map((target) => target.short), 'verdict'], rows),
        element('p', {class: 'note'}, `Tested against ${screening.from_replicates
            ? 'the scatter between packings' : 'what the main effects leave over'} with `
            + `${number(screening.error_degrees[0])} degrees of freedom.`), ...curved);
}
