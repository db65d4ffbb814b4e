// Particles seen from the front, drawn from their positions on a canvas.

const shades = {
    // Depth 0 (front) to 100 (back).
    depth: {legend: 'light in front, dark behind', of: (particles) => (i) => {
        const t = particles.depth[i] / 100;
        return `rgb(${Math.round(226 - 104 * t)},${Math.round(197 - 96 * t)},${Math.round(150 - 74 * t)})`;
    }},
    // Where the particle lay in the first picture, 0 (bottom) to 100 (top), in bands.
    layer: {legend: 'where each particle lay in the first picture', of: (particles) => {
        const bands = ['#8a4b2d', '#d2a56b', '#5d7f8f', '#dfd3bb', '#b5683c', '#7fa3a8', '#eadfca', '#6b4a3a'];
        return (i) => bands[Math.min(bands.length - 1, Math.floor(particles.layer[i] * bands.length / 100))];
    }},
};

// The convex outline of points, counter-clockwise (Andrew 1979).
function outline_of(points) {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]), hull = [];
    for (const pass of [sorted, [...sorted].reverse()]) {
        const first = hull.length;
        for (const p of pass) {
            while (hull.length >= first + 2) {
                const [a, b] = hull.slice(-2);
                if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
                hull.pop();
            }
            hull.push(p);
        }
        hull.pop();
    }
    return hull;
}

// A grain: a circle, or the outline of a polyhedron's corners [pixels], rounded by the radius.
function draw_grain(context, h, v, radius, corners, colour) {
    const edge = 'rgba(60, 42, 20, 0.55)', width = 0.8;
    context.beginPath();
    if (!corners) {
        context.lineWidth = width;
        context.strokeStyle = edge;
        context.arc(h, v, Math.max(radius, 0.7), 0, 2 * Math.PI);
    } else {
        for (const [x, y] of outline_of(corners)) context.lineTo(x, y);
        context.closePath();
        context.lineJoin = 'round';
        context.strokeStyle = '#9d8864';
        context.lineWidth = 2 * (radius + width);
        context.stroke();
        context.strokeStyle = colour;
        context.lineWidth = Math.max(2 * radius, 0.1);
    }
    context.fillStyle = colour;
    context.fill();
    context.stroke();
}

// Corners of a polyhedron as `place(h, v, into)` puts them; null: the grain is a sphere.
function corners_of(particles, i, place) {
    const flat = particles.corners && particles.corners[i];
    if (!flat) return null;
    const points = [];
    for (let k = 0; k < flat.length; k += 3) points.push(place(flat[k], flat[k + 1], flat[k + 2]));
    return points;
}

function draw_picture(canvas, picture, shade) {
    const pixels = 1100, margin = 8;
    const scale = (pixels - 2 * margin) / Math.max(picture.size[0], picture.size[1] * 0.75, 1);
    canvas.width = pixels;
    canvas.height = Math.ceil(picture.size[1] * scale + 2 * margin);
    const shift = (pixels - picture.size[0] * scale) / 2;
    const h = (value) => shift + value * scale, v = (value) => canvas.height - margin - value * scale;
    const context = canvas.getContext('2d');
    context.fillStyle = '#ffffff';
    context.fillRect(0, 0, canvas.width, canvas.height);

    const particles = picture.particles, colour = shade.of(particles);
    for (let i = 0; i < particles.h.length; ++i)
        draw_grain(context, h(particles.h[i]), v(particles.v[i]), particles.r[i] * scale,
                   corners_of(particles, i, (right, up) => [h(right), v(up)]), colour(i));
    context.strokeStyle = '#3c4754';
    context.lineWidth = 3;
    const edges = picture.walls.filter(([h0, v0, h1, v1]) => h0 === h1 || v0 === v1); // the others are panes in front
    for (const [h0, v0, h1, v1] of edges.concat(picture.lines)) {
        context.beginPath();
        context.moveTo(h(h0), v(v0));
        context.lineTo(h(h1), v(v1));
        context.stroke();
    }
    canvas.dataset.marks = particles.h.length + edges.length + picture.lines.length;
}

// The particles of a picture seen from another side, turned about the vertical.
function draw_turned(canvas, picture, angle) {
    const {h, v, r, into} = picture.particles;
    const middle = picture.size[0] / 2, behind = range_of(into), inwards = (behind[0] + behind[1]) / 2;
    const from_axis = (right, up, inner) => Math.hypot(right - middle, inner - inwards);
    const reach = Math.max(...h.map((at, i) => Math.max(from_axis(at, 0, into[i]), ...(corners_of(picture.particles, i, from_axis) || [])) + r[i])) || 1;
    const pixels = 900, scale = (pixels - 16) / Math.max(2 * reach, picture.size[1]);
    canvas.width = pixels;
    canvas.height = Math.ceil(picture.size[1] * scale + 16);
    const context = canvas.getContext('2d'), cos = Math.cos(angle), sin = Math.sin(angle);
    context.fillStyle = '#ffffff';
    context.fillRect(0, 0, canvas.width, canvas.height);
    const depth = h.map((at, i) => (into[i] - inwards) * cos - (at - middle) * sin);
    const order = [...depth.keys()].sort((a, b) => depth[b] - depth[a]);
    const place = (right, up, inner) => [pixels / 2 + ((right - middle) * cos + (inner - inwards) * sin) * scale, canvas.height - 8 - up * scale];
    for (const i of order) {
        const t = (depth[i] + reach) / (2 * reach), [x, y] = place(h[i], v[i], into[i]);
        draw_grain(context, x, y, r[i] * scale, corners_of(picture.particles, i, place),
                   `rgb(${Math.round(226 - 104 * t)},${Math.round(197 - 96 * t)},${Math.round(150 - 74 * t)})`);
    }
    canvas.dataset.marks = order.length;
}

// The last picture of a run, to be turned by hand or by itself.
function show_turning(parent, details) {
    const picture = details.snapshots[details.snapshots.length - 1];
    if (!picture || picture.particles.into.length === 0 || picture.particles.into.length < 2) return;
    const canvas = element('canvas', {class: 'picture', 'data-plot': `turning-${details.experiment}`, role: 'img',
                                      'aria-label': 'Particles at the end, seen from a side that can be chosen'});
    const slider = element('input', {type: 'range', min: 0, max: 360, value: 30, 'aria-label': 'turned by degrees'});
    const button = element('button', {type: 'button'}, 'turn');
    const draw = () => draw_turned(canvas, picture, slider.value * Math.PI / 180);
    slider.addEventListener('input', draw);
    let turning = false;
    const step = () => {
        if (!turning) return;
        slider.value = (Number(slider.value) + 1) % 360;
        draw();
        requestAnimationFrame(step);
    };
    button.addEventListener('click', () => {
        turning = !turning;
        button.textContent = turning ? 'stop' : 'turn';
        step();
    });
    const folded = element('details', {class: 'turning'}, element('summary', {}, `From other sides: ${words_of(picture.name)}, particles alone`),
                           element('div', {class: 'controls'}, slider, ' ', reduced_motion.matches ? null : button), canvas);
    folded.addEventListener('toggle', draw);
    draw();
    parent.append(folded);
}

function show_failed_pictures(parent) {
    if (campaign.failed_pictures.length === 0) return;
    parent.append(element('h3', {}, 'How runs ended that failed'));
    const row = element('div', {class: 'columns three'});
    parent.append(row);
    for (const failed of campaign.failed_pictures) {
        const canvas = element('canvas', {class: 'picture', 'data-plot': `failed-${failed.run}`, role: 'img',
                                          'aria-label': `Run ${failed.run}, ${failed.status}`});
        draw_picture(canvas, failed.picture, shades.depth);
        row.append(element('figure', {}, canvas, element('figcaption', {}, `run ${failed.run} (${campaign.experiments[failed.experiment].name}), `
            + `${failed.status}: ${failed.reason}; ${words_of(failed.picture.name)}, ${number(failed.picture.time, 3)} s`)));
    }
}

function title_of_asked(asked) {
    return `run ${asked.run} (${campaign.experiments[asked.experiment].name}), ${asked.status}`
        + (asked.reason ? `: ${asked.reason}` : '');
}

function show_asked_pictures(parent) {
    for (const asked of campaign.asked_pictures) {
        parent.append(element('h3', {}, title_of_asked(asked)));
        const row = element('div', {class: 'columns three'});
        parent.append(row);
        for (const picture of asked.pictures) {
            const canvas = element('canvas', {class: 'picture', 'data-plot': `asked-${asked.run}-${picture.name}`, role: 'img',
                                              'aria-label': `Run ${asked.run}, ${words_of(picture.name)}`});
            draw_picture(canvas, picture, shades.depth);
            row.append(element('figure', {}, canvas, element('figcaption', {}, `${words_of(picture.name)}, ${number(picture.time, 3)} s`)));
        }
    }
}

// Moments of a run, one after another: chosen by hand, or played where nobody has asked for less motion.
function show_film(parent, film) {
    const last = film.pictures.length - 1, per_second = 8;
    const canvas = element('canvas', {class: 'picture film', 'data-plot': `film-${film.run}`, role: 'img',
                                      'aria-label': `Run ${film.run} as a film of ${plural(last + 1, 'moment')}`});
    const slider = element('input', {type: 'range', min: 0, max: last, value: last, 'aria-label': 'moment'});
    const clock = element('span', {class: 'note'}), button = element('button', {type: 'button'}, 'play');
    const draw = () => {
        const picture = film.pictures[slider.value];
        draw_picture(canvas, picture, shades.depth);
        clock.textContent = ` ${words_of(picture.name)}, ${picture.time.toFixed(2)} s`;
    };
    let timer = null;
    const stop = () => {
        clearInterval(timer);
        timer = null;
        button.textContent = 'play';
    };
    slider.addEventListener('input', () => { stop(); draw(); });
    button.addEventListener('click', () => {
        if (timer !== null) return stop();
        button.textContent = 'stop';
        if (Number(slider.value) === last) slider.value = 0;
        draw();
        timer = setInterval(() => {
            slider.value = Number(slider.value) + 1;
            draw();
            if (Number(slider.value) === last) stop();
        }, 1000 / per_second);
    });
    const hidden = Math.max(...film.pictures.map((picture) => picture.hidden));
    parent.append(element('h3', {}, `As a film: ${title_of_asked(film)}`),
                  element('div', {class: 'controls'}, reduced_motion.matches ? null : button, ' ', slider, clock), canvas,
                  hidden > 0 ? element('p', {class: 'note'}, `${plural(hidden, 'particle')} behind left out.`) : '');
    draw();
}

const reduced_motion = matchMedia('(prefers-reduced-motion: reduce)');

function show_pictures(parent) {
    show_pictures_of_shown_runs(parent);
    for (const film of campaign.films) show_film(parent, film);
    show_asked_pictures(parent);
    show_failed_pictures(parent);
    if (all_runs.length > 0 && campaign.file)
        parent.append(element('p', {class: 'note'}, 'Any other run: ',
                              element('code', {}, `demens report ${campaign.file} --picture-runs N --film`), '; as frames for ParaView: ',
                              element('code', {}, `demens replay ${campaign.file} --run N --frames FOLDER`)));
}

function show_pictures_of_shown_runs(parent) {
    if (campaign.details.length === 0) {
        parent.append(element('p', {class: 'note'}, 'No run has finished yet.'));
        return;
    }
    const drawings = [];
    const without = campaign.details.filter((details) => !details.absent && details.snapshots.length === 0);
    if (without.length > 0)
        parent.append(element('p', {class: 'note'}, `No pictures of ${without.map((details) => campaign.experiments[details.experiment].name).join(', ')}: the rig keeps none of its particles.`));
    for (const details of campaign.details.filter((one) => !without.includes(one))) {
        const head = element('p', {class: 'note'}, title_of_details(details));
        parent.append(head);
        if (details.absent) head.append(`: no picture, ${details.absent}`);
        const row = element('div', {class: 'columns', style:
            `grid-template-columns: repeat(${Math.min(Math.max(details.snapshots.length, 2), 3)}, 1fr)`});
        parent.append(row);
        for (const picture of details.snapshots) {
            const canvas = element('canvas', {class: 'picture', 'data-plot': `picture-${details.experiment}-${picture.name}`});
            const shown = plural(picture.particles.h.length, 'particle')
                + (picture.hidden > 0 ? ` (${picture.hidden} behind left out)` : '');
            row.append(element('figure', {}, canvas, element('figcaption', {},
                `${words_of(picture.name)}, ${number(picture.time, 3)} s, ${shown}`)));
            drawings.push([canvas, picture]);
        }
        show_turning(parent, details);
    }
    if (drawings.length === 0) return;
    const choice = element('select', {});
    const has_layers = drawings.every(([, picture]) => picture.particles.layer.length === picture.particles.h.length);
    for (const name of has_layers ? ['depth', 'layer'] : ['depth']) choice.append(element('option', {}, name));
    const explained = element('span');
    const redraw = () => {
        explained.textContent = ' (' + shades[choice.value].legend + ')';
        for (const [canvas, picture] of drawings) draw_picture(canvas, picture, shades[choice.value]);
    };
    choice.addEventListener('change', redraw);
    if (has_layers) parent.querySelector('h2').after(element('div', {class: 'controls'}, 'colour: ', choice, explained));
    redraw();
}
