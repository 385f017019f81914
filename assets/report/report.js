// The report as a page: header, targets, view, table, viewer. Data and pictures are in #data.
const data = JSON.parse(document.getElementById('data').textContent);
const labelOf = id => (data.variants.find(v => v.id === id) || {label: id}).label;
const colourOf = id => COLOURS[data.variants.findIndex(v => v.id === id) % COLOURS.length];
const titleOf = point => point.label + (point.budget ? ` · ${point.budget}` : '');
const sceneName = scene => scene.split('/').pop().replace(/\.(glb|gltf)$/, '');
const at = (point, ...keys) => keys.reduce((node, key) => node === null || node === undefined ? null : node[key], point) ?? null;

const METRICS = [
  {id: 'rmse', name: 'RMSE', unit: 'display values, 0 to 1', of: p => at(p, 'error', 'rmse')},
  {id: 'flip', name: 'FLIP', unit: '0 to 1', of: p => at(p, 'error', 'flip')},
  {id: 'flip_gaze', name: 'FLIP around the gaze', unit: '0 to 1', of: p => at(p, 'error', 'flip_gaze')},
  {id: 'max', name: 'largest difference', unit: 'display values, 0 to 1', of: p => at(p, 'error', 'max')},
  {id: 'flicker', name: 'flicker along the path', unit: 'display values a frame, 0 to 2', of: p => at(p, 'path', 'flicker')},
  {id: 'path_rmse', name: 'RMSE along the path', unit: 'display values, 0 to 1', of: p => at(p, 'path', 'rmse')},
].filter(metric => data.points.some(p => metric.of(p) !== null) || metric.id === 'rmse');
const BYTES = 'storage + overhead';  // bytes.transparency; an oracle has storage alone
const TIMES = [
  {id: 'transparency', name: 'transparency, ms', of: p => at(p, 'ms', 'transparency', 'median')},
  {id: 'shading', name: 'shading, ms', of: p => at(p, 'ms', 'shading', 'median')},
  {id: 'total', name: 'whole frame, ms', of: p => at(p, 'ms', 'total', 'median')},
];
const BASES = new Map(data.studies.map(s => [s.id, s.base]));
// What a sweep varies, without what all its settings begin with: "r" of "lod.r".
const sweptName = [...new Set(data.variants.filter(v => v.sweep).map(v => v.sweep.split('.').pop()))].join(', ');

const DIMENSIONS = [
  {id: 'study', name: 'Study', of: p => p.study, show: v => (data.studies.find(s => s.id === v) || {title: v}).title},
  {id: 'scene', name: 'Scene', of: p => p.scene, show: sceneName, tabs: true},
  {id: 'light', name: 'Light', of: p => p.light, show: v => v},
  {id: 'size', name: 'Size', of: p => `${p.width}x${p.height}`, show: v => v},
  {id: 'seed', name: 'Seed', of: p => String(p.seed), show: v => v},
];
// Where something has a speed-up, it is one of whole frames.
const view = {metric: METRICS[0], time: TIMES[data.points.some(p => at(p, 'speedup') !== null) ? 2 : 0]};

function fillHeader() {
  document.getElementById('description').textContent = data.description;
  const count = status => data.points.filter(p => p.status === status).length;
  const facts = {
    Date: data.date, Commit: data.commit, Renderer: `${data.gl.renderer}, ${data.gl.version}`,
    Processor: `${data.machine.processor}, ${data.machine.cores} cores`, Times: data.gl.time_source,
    Rounds: `${[...new Set(data.studies.map(s => s.frames))].join(', ')} after ${data.warm_up_rounds} of warm-up`,
    Points: `${count('measured')} measured, ${count('oracle')} by oracles, ${count('refused')} refused`,
  };
  if (data.warnings.length > 0) facts.Gaze = data.warnings.join('; ');
  document.getElementById('provenance').append(...Object.entries(facts).map(([name, value]) =>
    element('div', {}, element('dt', {}, name), element('dd', {}, value))));
  document.querySelector('#experiment pre').textContent = data.experiment;
  if (data.skipped.length > 0) {
    document.getElementById('skipped').hidden = false;
    document.querySelector('#skipped ul').append(...data.skipped.map(s => element('li', {}, `${s.what}: ${s.reason}`)));
  }
}

function fillTargets() {
  if (data.targets.length === 0) return;
  document.getElementById('targets').hidden = false;
  const count = state => data.targets.filter(t => t.state === state).length;
  document.getElementById('target-sum').textContent =
    `${count('met')} met, ${count('missed')} missed, ${count('n/a')} n/a, ${count('unmeasured')} not measured`;
  document.querySelector('#targets thead').append(element('tr', {},
    ...['Target', 'Where', 'Value', 'Limit', 'Result', 'Made of'].map(name => element('th', {}, name))));
  let before = null;
  for (const target of data.targets) {
    const name = element('td', {class: 'name'});
    if (before !== target.name) name.append(target.name);
    if (before !== target.name && target.papers) name.append(element('small', {}, `Papers: ${target.papers}`));
    before = target.name;
    const state = {met: 'met', missed: 'MISSED', unmeasured: 'NOT MEASURED', 'n/a': `n/a: ${target.reason}`}[target.state];
    document.querySelector('#targets tbody').append(element('tr', {class: target.state.replace('/', '')}, name,
      element('td', {}, target.where || '–'),
      element('td', {class: 'number'}, target.value === null ? '' : shown(target.value)),
      element('td', {class: 'number', style: 'white-space:nowrap'}, target.limit),
      element('td', {class: 'state'}, state), element('td', {}, target.note)));
  }
}

// The values of a dimension that exist beside the choices made before it.
function valuesOf(index) {
  const rest = data.points.filter(p => DIMENSIONS.slice(0, index).every(d => d.of(p) === view[d.id]));
  return [...new Set(rest.map(DIMENSIONS[index].of))];
}

const viewPoints = () => data.points.filter(p => DIMENSIONS.every(d => d.of(p) === view[d.id]));

function fillView() {
  const nav = document.getElementById('view');
  nav.replaceChildren();
  const selectOf = (name, options, chosen, change) => {
    const select = element('select', {'aria-label': name, on: {change: e => change(e.target.selectedIndex)}},
      ...options.map(o => element('option', {}, o)));
    select.selectedIndex = chosen;
    return element('label', {}, name, select);
  };
  DIMENSIONS.forEach((dimension, index) => {
    const values = valuesOf(index);
    if (!values.includes(view[dimension.id])) view[dimension.id] = values[0];
    if (values.length < 2 && !dimension.tabs) return;
    const choose = value => { view[dimension.id] = value; fillView(); };
    if (dimension.tabs && values.length <= 8) {
      nav.append(element('div', {class: 'tabs'}, dimension.name, element('div', {}, ...values.map(v =>
        element('button', {type: 'button', 'aria-pressed': String(v === view[dimension.id]), on: {click: () => choose(v)}},
          dimension.show(v))))));
    } else {
      nav.append(selectOf(dimension.name, values.map(dimension.show), values.indexOf(view[dimension.id]), i => choose(values[i])));
    }
  });
  nav.append(selectOf('Error', METRICS.map(m => m.name), METRICS.indexOf(view.metric), i => { view.metric = METRICS[i]; drawCharts(); }));
  nav.append(selectOf('Time', TIMES.map(t => t.name), TIMES.indexOf(view.time), i => { view.time = TIMES[i]; drawCharts(); }));
  drawCharts();
}

function numbersOf(point) {
  const lines = [titleOf(point)];
  const add = (name, value, unit = '') => { if (value !== null) lines.push(`${name} ${shown(value)}${unit}`); };
  add('transparency', at(point, 'ms', 'transparency', 'median'), ' ms');
  add('shading', at(point, 'ms', 'shading', 'median'), ' ms');
  add('frame', at(point, 'ms', 'total', 'median'), ' ms');
  add('speed-up', at(point, 'speedup'));
  if (at(point, 'shading', 'shaded_share') !== null) {
    lines.push(`pixels shaded ${percent(point.shading.shaded_share)}, holes ${percent(point.shading.holes_share)}`);
  }
  add(point.status === 'oracle' ? 'storage' : BYTES, mebi(at(point, 'bytes', 'transparency')), ' MiB');
  add('RMSE', at(point, 'error', 'rmse'));
  add('PSNR', at(point, 'error', 'psnr_db'), ' dB');
  add('FLIP', at(point, 'error', 'flip'));
  add('FLIP around the gaze', at(point, 'error', 'flip_gaze'));
  add('flicker', at(point, 'path', 'flicker'));
  add('RMSE along the path', at(point, 'path', 'rmse'));
  if (at(point, 'path', 'reason') !== null) lines.push(`path refused: ${point.path.reason}`);
  if (at(point, 'fragments', 'loss') !== null) lines.push(`fragments lost ${percent(point.fragments.loss)}`);
  if (at(point, 'k', 'mean') !== null) lines.push(`k ${point.k.min} to ${point.k.max}, mean ${shown(point.k.mean)}`);
  return lines;
}

function chartPoints(points, x) {
  const y = view.metric.of;
  return points.filter(p => x(p) !== null && y(p) !== null).map(p => ({
    key: p.key, x: x(p), y: y(p), label: titleOf(p), colour: colourOf(p.variant),
    text: numbersOf(p).join('\n'), open: () => openViewer(p),
  }));
}

// PSNR against speed-up, a line a sweep (Yang, Sander & Lawrence 2008, Fig. 3).
function drawSpeed(points) {
  const base = BASES.get(view.study);
  const shownPoints = points.filter(p => at(p, 'speedup') !== null && (at(p, 'error', 'psnr_db') !== null || at(p, 'error', 'rmse') === 0));
  const figure = document.getElementById('speed');
  figure.hidden = !base || !shownPoints.some(p => p.variant !== base);
  if (figure.hidden) return;
  const swept = shownPoints.some(p => at(p, 'sweep') !== null);
  figure.querySelector('figcaption').textContent = `PSNR against speed-up over ${labelOf(base)}`;
  figure.querySelector('.note').textContent = 'Upper right is better.'
    + (swept ? ` The number at a point is its ${sweptName}. Lines pass by what another point of the curve beats in both (small, faint).` : '')
    + ' Hollow points at the top equal the exact picture.';
  const series = data.variants.map(v => ({colour: colourOf(v.id), points: shownPoints.filter(p => p.variant === v.id).map(p => ({
    key: p.key, x: p.speedup, y: at(p, 'error', 'psnr_db'), ink: colourOf(v.id),
    label: at(p, 'sweep') === null ? titleOf(p) : String(p.sweep), text: numbersOf(p).join('\n'), open: () => openViewer(p),
  }))})).filter(s => s.points.length > 0);
  curves(document.getElementById('by-speed'), series, 'speed-up of whole frames, factor', 'PSNR, dB');
}

// A figure in which all points are alike says nothing.
function showWhereItVaries(id, points, of) {
  const varies = points.length < 2 || new Set(points.map(of)).size > 1;
  document.getElementById(id).closest('figure').hidden = !varies;
  return varies;
}

function drawCharts() {
  const points = viewPoints();
  const used = data.variants.filter(v => points.some(p => p.variant === v.id));
  document.getElementById('legend').replaceChildren(...used.map(v => element('span', {},
    element('i', {class: 'swatch', style: `background:${colourOf(v.id)}`}), v.label)));
  const place = id => document.getElementById(id);
  drawSpeed(points);
  place('by-time').previousElementSibling.textContent = `${view.metric.name} against time (${view.time.name})`;
  place('by-bytes').previousElementSibling.textContent = `${view.metric.name} against ${BYTES} of transparency`
    + (points.some(p => p.status === 'oracle') ? ' (oracles: storage alone)' : '');
  const yLabel = `${view.metric.name} (${view.metric.unit})`;
  const bytes = p => mebi(at(p, 'bytes', 'transparency'));
  const bytesVary = showWhereItVaries('by-bytes', points.filter(p => bytes(p) !== null), bytes);  // before widths are taken
  scatter(place('by-time'), chartPoints(points, view.time.of), view.time.name, yLabel);
  if (bytesVary) scatter(place('by-bytes'), chartPoints(points, bytes), `${BYTES}, MiB`, yLabel);
  const counted = points.filter(p => at(p, 'fragments', 'generated') > 0);
  const fates = p => [p.fragments.stored, p.fragments.merged, p.fragments.lost].join();
  if (showWhereItVaries('loss', counted.length > 0 ? counted : [{}, {}], p => p.fragments ? fates(p) : 0)) drawLoss(counted);
  drawPasses(points.filter(p => p.ms));
  fillMaps(points.filter(p => at(p, 'images', 'flip') !== null));
}

function drawLoss(points) {
  const kinds = [['stored', 'var(--stored)'], ['merged', 'var(--merged)'], ['lost', 'var(--lost)']];
  bars(document.getElementById('loss'), kinds.map(([name, colour]) => ({name, colour})), points.map(p => ({
    name: titleOf(p), figure: `${percent(p.fragments.loss)} lost`,
    parts: kinds.map(([name, colour]) => ({value: p.fragments[name] / p.fragments.generated, colour,
      title: `${titleOf(p)}\n${name}: ${shown(p.fragments[name])} of ${shown(p.fragments.generated)}`})),
  })), 1);
}

function drawPasses(points) {
  const only = name => ({
    total: true, transparency: name.startsWith('oit.'), shading: name === 'lighting' || name.startsWith('lod.'),
  })[view.time.id];
  const names = [...new Set(points.flatMap(p => Object.keys(p.ms.passes)))].filter(only);
  const colour = name => COLOURS[names.indexOf(name) % COLOURS.length];
  const sum = p => names.reduce((total, name) => total + (at(p, 'ms', 'passes', name, 'median') || 0), 0);
  bars(document.getElementById('passes'), names.map(name => ({name, colour: colour(name)})), points.map(p => ({
    name: titleOf(p), figure: `${shown(view.time.of(p))} ms`,
    parts: names.map(name => ({value: at(p, 'ms', 'passes', name, 'median') || 0, colour: colour(name),
      title: `${titleOf(p)}\n${name}: ${shown(at(p, 'ms', 'passes', name, 'median'))} ms`})),
  })), Math.max(...points.map(sum), 1e-9));
  fillPassTimes(points, names);
}

// The bars' numbers; what no row has reached the clock's last digit in is left out.
function fillPassTimes(points, names) {
  const figure = document.getElementById('pass-times');
  const used = names.filter(name => points.some(p => at(p, 'ms', 'passes', name, 'median') > 0));
  figure.hidden = used.length === 0;
  figure.querySelector('figcaption').textContent = `Medians of the passes, ms (${view.time.name.replace(', ms', '')})`;
  const number = text => element('td', {class: 'number'}, text);
  figure.querySelector('thead').replaceChildren(element('tr', {}, element('th', {}, 'Variant'),
    ...['median of the sum', ...used].map(name => element('th', {class: 'number'}, name))));
  figure.querySelector('tbody').replaceChildren(...points.map(p => element('tr', {}, element('td', {}, titleOf(p)),
    number(shown(view.time.of(p))), ...used.map(name => number(shown(at(p, 'ms', 'passes', name, 'median')))))));
}

// Maps side by side, the exact picture first.
function fillMaps(points) {
  const figure = document.getElementById('maps');
  figure.hidden = points.length === 0;
  const tile = (file, text, open) => element('button', {type: 'button', on: {click: open}},
    element('img', {src: data.pictures[file], alt: text, loading: 'lazy'}), element('span', {}, text));
  figure.querySelector('.scale').replaceChildren(flipBar());
  figure.querySelector('.maps').replaceChildren(
    ...points.slice(0, 1).map(p => tile(p.images.reference, 'exact', () => openViewer(p))),
    ...points.map(p => tile(p.images.flip, `${titleOf(p)}: FLIP ${shown(at(p, 'error', 'flip'))}, RMSE ${shown(at(p, 'error', 'rmse'))}${at(p, 'difference_white') === 0 ? ' (no difference)' : ''}`,
      () => openViewer(p))));
}

const COLUMNS = [
  ['Study', p => p.study, false, data.studies.length > 1], ['Scene', p => sceneName(p.scene)],
  ['Size', p => `${p.width}x${p.height}`], ['Light', p => p.light, false, new Set(data.points.map(p => p.light)).size > 1],
  ['Seed', p => p.seed, true, new Set(data.points.map(p => p.seed)).size > 1],
  ['Variant', p => labelOf(p.variant)], ['Budget', p => p.budget, false, data.points.some(p => p.budget)],
  [sweptName, p => at(p, 'sweep'), true], ['Speed-up', p => at(p, 'speedup'), true],
  ['Transparency ms', p => at(p, 'ms', 'transparency', 'median'), true],
  ['Shading ms', p => at(p, 'ms', 'shading', 'median'), true], ['Frame ms', p => at(p, 'ms', 'total', 'median'), true],
  ['RMSE', p => at(p, 'error', 'rmse'), true], ['PSNR dB', p => at(p, 'error', 'psnr_db'), true],
  ['Max', p => at(p, 'error', 'max'), true], ['FLIP', p => at(p, 'error', 'flip'), true],
  ['FLIP gaze', p => at(p, 'error', 'flip_gaze'), true],
  ['Flicker', p => at(p, 'path', 'flicker'), true], ['RMSE path', p => at(p, 'path', 'rmse'), true],
  ['Shaded', p => at(p, 'shading', 'shaded_share'), true, true, percent],
  ['Holes', p => at(p, 'shading', 'holes_share'), true, true, percent],
  ['Storage + overhead MiB', p => mebi(at(p, 'bytes', 'transparency')), true], ['Budget used', p => at(p, 'budget_used'), true, true, percent],
  ['Fragments', p => at(p, 'fragments', 'generated'), true], ['Stored', p => at(p, 'fragments', 'stored'), true],
  ['Merged', p => at(p, 'fragments', 'merged'), true], ['Lost', p => at(p, 'fragments', 'loss'), true, true, percent],
  ['k mean', p => at(p, 'k', 'mean'), true], ['k max', p => at(p, 'k', 'max'), true],
].filter(([, of, number, wanted]) => wanted !== false && (!number || data.points.some(p => of(p) !== null)));
const sorting = {column: -1, down: false};

function fillTable() {
  const head = COLUMNS.map(([name, , number], i) => element('th', {
    class: number ? 'number' : '', 'aria-sort': sorting.column !== i ? 'none' : sorting.down ? 'descending' : 'ascending',
    on: {click: () => {
      sorting.down = sorting.column === i && !sorting.down;
      sorting.column = i;
      fillTable();
      document.querySelectorAll('#table th button')[i].focus();  // the one that was pressed is gone
    }},
  }, element('button', {type: 'button'}, name)));
  document.querySelector('#table thead').replaceChildren(element('tr', {}, ...head));
  const rows = [...data.points];
  if (sorting.column >= 0) {
    const of = COLUMNS[sorting.column][1];
    const compare = (a, b) => a === b ? 0 : a === null ? 1 : b === null ? -1 : a < b ? -1 : 1;  // blanks last
    rows.sort((a, b) => of(a) === null || of(b) === null || !sorting.down ? compare(of(a), of(b)) : compare(of(b), of(a)));
  }
  document.querySelector('#table tbody').replaceChildren(...rows.map(point => {
    const texts = COLUMNS.filter(c => !c[2]).length;
    const cell = ([, of, number, , format]) => element('td', {class: number ? 'number' : ''},
      format ? format(of(point)) : number ? shown(of(point)) : of(point) ?? '–');
    const row = element('tr', {'data-key': point.key});
    if (point.status === 'refused') {
      row.append(...COLUMNS.filter(c => !c[2]).map(cell),
        element('td', {class: 'reason', colspan: COLUMNS.length - texts}, `refused: ${point.reason}`));
    } else {
      row.append(...COLUMNS.map(cell));
      row.addEventListener('click', () => openViewer(point));
      row.tabIndex = 0;
      row.addEventListener('keydown', event => {
        if (event.key !== 'Enter' && event.key !== ' ') return;
        event.preventDefault();  // the space bar scrolls
        openViewer(point);
      });
    }
    return row;
  }));
}

function openViewer(point) {
  tip.hide();
  const viewer = document.getElementById('viewer');
  const images = point.images || {};
  const set = (selector, name) => {
    const picture = viewer.querySelector(selector);
    picture.hidden = !images[name];
    if (images[name]) picture.src = data.pictures[images[name]];
  };
  viewer.querySelector('h2').textContent = `${titleOf(point)}, ${sceneName(point.scene)} ${point.width}x${point.height}`;
  viewer.querySelector('.numbers').textContent = numbersOf(point).slice(1).join(' · ');
  set('.test', 'image');
  set('.reference', 'reference');
  const white = at(point, 'difference_white');
  set('.difference', 'difference');
  if (white === 0) viewer.querySelector('.difference').hidden = true;
  viewer.querySelector('.pictures figcaption').textContent = !images.difference ? 'No exact picture here'
    : white === 0 ? 'No difference from the exact picture'
    : `Difference from the exact picture: R, G and B each times ${shown(1 / white)}`;
  viewer.querySelector('.scale').replaceChildren(...(white > 0 ? [colourBar('linear-gradient(to right,#000,#fff)', '0',
    `${shown(white)} and more, of 1` + (data.difference_scale === null ? ' (99th percentile)' : ''))] : []));
  const flip = viewer.querySelector('.flip');
  flip.hidden = !images.flip;
  flip.replaceChildren(...(images.flip ? [element('img', {src: data.pictures[images.flip], alt: 'FLIP map'}),
    element('figcaption', {}, white === 0 ? 'FLIP: no difference' : 'FLIP'), flipBar()] : []));
  // No links: the page also travels alone.
  viewer.querySelector('.files').textContent = Object.keys(images).length === 0 ? '' : 'Full size, in the folder of the results: '
    + Object.entries(images).map(([role, file]) => `${file} (${role})`).join(', ');
  moveDivider(50);
  if (viewer.showModal && !viewer.open) viewer.showModal();
}

function moveDivider(share) {
  const at = Math.min(100, Math.max(0, share));
  document.querySelector('.slider').style.setProperty('--at', `${at}%`);
  document.querySelector('#viewer input').value = at;
}

function wireViewer() {
  const slider = document.querySelector('.slider');
  document.querySelector('#viewer input').addEventListener('input', e => moveDivider(Number(e.target.value)));
  const drag = event => {
    const box = slider.getBoundingClientRect();
    moveDivider(100 * (event.clientX - box.left) / box.width);
  };
  slider.addEventListener('dragstart', e => e.preventDefault());
  slider.addEventListener('pointerdown', e => { slider.setPointerCapture(e.pointerId); drag(e); });
  slider.addEventListener('pointermove', e => { if (e.buttons === 1) drag(e); });
  const viewer = document.getElementById('viewer');
  viewer.addEventListener('click', e => { if (e.target === viewer) viewer.close(); });  // the backdrop
}

// A report can be opened at one point: report.html#KEY.
function openFromAddress() {
  const point = data.points.find(p => p.key === location.hash.slice(1));
  if (!point) return;
  for (const dimension of DIMENSIONS) view[dimension.id] = dimension.of(point);
  fillView();
  if (point.images) openViewer(point);
  else document.querySelector(`[data-key="${point.key}"]`).scrollIntoView();  // refused
}

fillHeader();
fillTargets();
if (data.points.length > 0) fillView();
fillTable();
wireViewer();
openFromAddress();
addEventListener('hashchange', openFromAddress);
let resizing = 0;
addEventListener('resize', () => { clearTimeout(resizing); resizing = setTimeout(() => { if (data.points.length > 0) drawCharts(); }, 150); });
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { if (data.points.length > 0) drawCharts(); });
