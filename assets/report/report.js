// The report as a page: header, targets, view, table, viewer. Data and pictures are in #data.
const data = JSON.parse(document.getElementById('data').textContent);
const labelOf = id => (data.variants.find(v => v.id === id) || {label: id}).label;
const colourOf = id => COLOURS[data.variants.findIndex(v => v.id === id) % COLOURS.length];
const titleOf = point => point.label + (point.budget ? ` · ${point.budget}` : '');
const sceneName = scene => scene.split('/').pop().replace(/\.(glb|gltf)$/, '');
const at = (point, ...keys) => keys.reduce((node, key) => node === null || node === undefined ? null : node[key], point) ?? null;

// The table of metrics, as far as points have them; how a value of each is shown.
const FORMATS = {bytes: value => `${shown(mebi(value))} MiB`, share: percent, ms: value => `${shown(value)} ms`,
  dB: value => `${shown(value)} dB`};
// Times first, then errors.
const rank = metric => metric.unit === 'ms' || metric.id === 'speedup' ? 0 : ['error', 'path'].includes(metric.path[0]) ? 1 : 2;
const TABLE = data.metrics.map(metric => ({...metric, of: p => at(p, ...metric.path),
  text: value => value === null ? '–' : (FORMATS[metric.unit] || shown)(value)})).sort((a, b) => rank(a) - rank(b));
const metricOf = id => TABLE.find(metric => metric.id === id);
const METRICS = TABLE.filter(metric => data.points.some(p => metric.of(p) !== null));
const withUnit = metric => `${metric.title}, ${metric.unit}`;
const TIMES = TABLE.filter(metric => metric.unit === 'ms');
// Choices of the vertical axis: lower is better there, as it is for times and bytes.
const FAULTS = TABLE.filter(metric => metric.id === 'rmse' || METRICS.includes(metric))
  .filter(metric => metric.better === 'lower' && !['ms', 'bytes'].includes(metric.unit));
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
const view = {metric: metricOf('rmse'), time: metricOf(data.points.some(p => at(p, 'speedup') !== null) ? 'ms.total' : 'ms.transparency')};

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
  const choose = (name, metrics, key) => nav.append(selectOf(name, metrics.map(m => m.title), metrics.indexOf(view[key]),
    i => { view[key] = metrics[i]; drawCharts(); }));
  choose('Error', FAULTS, 'metric');
  choose('Time', TIMES, 'time');
  drawCharts();
}

function numbersOf(point) {
  const lines = [titleOf(point)];
  for (const metric of METRICS) {
    const value = metric.of(point);
    if (value !== null) lines.push(`${metric.title} ${metric.text(value)}`);
  }
  if (at(point, 'path', 'reason') !== null) lines.push(`path refused: ${point.path.reason}`);
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
  const bytes = metricOf('bytes.transparency');
  place('by-time').previousElementSibling.textContent = `${view.metric.title} against time (${withUnit(view.time)})`;
  place('by-bytes').previousElementSibling.textContent = `${view.metric.title} against ${bytes.title} of transparency`
    + (points.some(p => p.status === 'oracle') ? ' (oracles: storage alone)' : '');
  const yLabel = view.metric.unit ? `${view.metric.title} (${view.metric.unit})` : view.metric.title;
  const inMebi = p => mebi(bytes.of(p));
  const bytesVary = showWhereItVaries('by-bytes', points.filter(p => bytes.of(p) !== null), bytes.of);  // before widths are taken
  scatter(place('by-time'), chartPoints(points, view.time.of), withUnit(view.time), yLabel);
  if (bytesVary) scatter(place('by-bytes'), chartPoints(points, inMebi), `${bytes.title}, MiB`, yLabel);
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
  const only = name => ({'ms.total': true, 'ms.transparency': name.startsWith('oit.'),
    'ms.shading': name === 'lighting' || name.startsWith('lod.')})[view.time.id];
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
  figure.querySelector('figcaption').textContent = `Medians of the passes, ms (${view.time.title})`;
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

const capital = text => text[0].toUpperCase() + text.slice(1);
const headingOf = metric => capital(metric.title) + ({ms: ' ms', dB: ' dB', bytes: ' MiB'}[metric.unit] || '');
// [heading, value, whether it is a number, whether it is wanted, how it is shown]
const COLUMNS = [
  ['Study', p => p.study, false, data.studies.length > 1], ['Scene', p => sceneName(p.scene)],
  ['Size', p => `${p.width}x${p.height}`], ['Light', p => p.light, false, new Set(data.points.map(p => p.light)).size > 1],
  ['Seed', p => p.seed, true, new Set(data.points.map(p => p.seed)).size > 1],
  ['Variant', p => labelOf(p.variant)], ['Budget', p => p.budget, false, data.points.some(p => p.budget)],
  [sweptName, p => at(p, 'sweep'), true],
  ...METRICS.map(metric => [headingOf(metric), metric.of, true, true,
    metric.unit === 'share' ? percent : metric.unit === 'bytes' ? value => shown(mebi(value)) : shown]),
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
