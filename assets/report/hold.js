'use strict';
// The page of `macula hold SCENE`: frame time, r and quality controls over the frames, as Yang 2008, Fig. 5.

const data = JSON.parse(document.getElementById('data').textContent);
const trace = data.trace;
const frames = trace.ms.map((_, i) => i);
const target = data.target_ms;
const HELD = '#0072b2';
const FIXED = '#d55e00';
const IDEAL = '#009e73';

const loadName = times => times === 1 ? 'once' : `${times} times over`;

function fillHeader() {
  document.getElementById('title').textContent = `${data.scene}: ${shown(target)} ms ${data.verdict}` +
    (data.verdict === 'not judged' ? '' : ` by ${data.law}`);
  document.getElementById('description').textContent =
    'Every frame of the camera path is drawn twice in turn: once with the resize factor r that the law chooses, ' +
    `and once with r = ${shown(data.fixed.r)}, which shows what the machine does by itself.`;
  const facts = [['commit', data.commit], ['size', `${data.width} × ${data.height}`], ['GL', data.gl.renderer],
    ['clock', data.time_source], ['frames', data.frames]];
  for (const warning of data.gaze_log?.warnings ?? []) facts.push(['gaze', warning]);
  const list = document.getElementById('provenance');
  for (const [name, value] of facts) {
    list.append(element('div', {}, element('dt', {}, name), element('dd', {}, String(value))));
  }
  const gate = data.gate;
  const word = data.verdict[0].toUpperCase() + data.verdict.slice(1);
  const why = data.reason ? data.reason : `${percent(gate.within)} of the frames lie within ±${percent(gate.tolerance)} of the target; to reach: ${percent(gate.share)}. ` +
      `The tolerance is 5 % plus the spread of the fixed r in this run, ${percent(data.fixed.spread)}, and 30 % at most. ` +
      'The first ten frames, and ten after each change of the load, are left out.';
  document.getElementById('verdict').append(
    element('span', {class: {held: 'met', 'held in part': 'missed', 'not held': 'missed'}[data.verdict] || ''}, word + ': '), why);
}

// Vertical marks where the load changes, on every chart; on the first with words.
function drawSteps(plot, named) {
  const context = plot.ctx;
  context.save();
  context.strokeStyle = context.fillStyle = cssColour('--soft');
  context.font = `${12 * devicePixelRatio}px system-ui, sans-serif`;
  context.lineWidth = devicePixelRatio;
  for (const step of data.steps) {
    const x = Math.round(plot.valToPos(step.frame, 'x', true));
    context.setLineDash([2, 3]);
    context.beginPath();
    context.moveTo(x, plot.bbox.top);
    context.lineTo(x, plot.bbox.top + plot.bbox.height);
    context.stroke();
    if (!named) continue;
    const text = `shaded ${loadName(step.times)}`;
    const right = x + 6 + context.measureText(text).width > plot.bbox.left + plot.bbox.width;
    context.textAlign = right ? 'right' : 'left';
    context.fillText(text, x + (right ? -5 : 5) * devicePixelRatio, plot.bbox.top + 13 * devicePixelRatio);
  }
  context.restore();
}

// The tolerance, and ±5 % darker in it, behind the times.
function drawBands(plot) {
  const context = plot.ctx;
  context.save();
  for (const [share, alpha] of [[data.gate.tolerance, '1f'], [0.05, '2e']]) {
    const inside = y => Math.min(Math.max(y, plot.bbox.top), plot.bbox.top + plot.bbox.height);
    const top = inside(plot.valToPos(target * (1 + share), 'y', true));
    const bottom = inside(plot.valToPos(target * (1 - share), 'y', true));
    context.fillStyle = IDEAL + alpha;
    context.fillRect(plot.bbox.left, top, plot.bbox.width, bottom - top);
  }
  context.restore();
}

function key(text, colour, style = 'solid') {
  const mark = style === 'area' ? element('span', {class: 'area', style: `background:${colour}`})
    : element('span', {class: 'line', style: `border-color:${colour};border-top-style:${style}`});
  return element('span', {}, mark, text);
}

// A chart over the frames. lines: {name, values, colour, width, dash, digits}
function chart(title, label, height, range, lines, keys, drawBehind = []) {
  const named = document.getElementById('charts').childElementCount === 0;
  const figure = element('figure', {}, element('figcaption', {}, title), element('div', {class: 'keys'}, ...keys));
  document.getElementById('charts').append(figure);
  const axis = (name, size) => ({
    label: name, size, labelSize: 18, font: '12px system-ui, sans-serif', labelFont: '12px system-ui, sans-serif',
    stroke: cssColour('--soft'), grid: {stroke: cssColour('--line'), width: 1},
    ticks: {stroke: cssColour('--line'), width: 1},
  });
  const width = () => Math.max(280, figure.clientWidth - 24);
  const plot = new uPlot({
    width: width(), height, cursor: {sync: {key: 'frames'}},
    legend: {live: true},
    scales: {x: {time: false}, y: {range: () => range}},
    axes: [axis('frame number', 34), axis(label, 56)],
    hooks: {drawClear: drawBehind, draw: [self => drawSteps(self, named)]},
    series: [{label: 'frame'}, ...lines.map(line => ({
      label: line.name, stroke: line.colour, width: line.width ?? 1.5, dash: line.dash, points: {show: false},
      paths: line.stepped ? uPlot.paths.stepped({align: 1}) : undefined,
      value: (_, v) => v === null ? '–' : v.toFixed(line.digits ?? 2) + (line.unit ?? '')}))],
  }, [frames, ...lines.map(line => line.values)], figure);
  addEventListener('resize', () => plot.setSize({width: width(), height}));
}

function idealOf(frame) {
  return data.parts.find(part => frame < part.end).ideal_r;
}

function drawCharts() {
  const sorted = [...trace.ms, ...trace.fixed_ms].sort((a, b) => a - b);
  // A hitch must not flatten everything else: the scale holds 99 of 100 frames, and the target.
  const most = Math.max(sorted[Math.floor(0.99 * (sorted.length - 1))], 1.25 * target) * 1.1;
  const beyond = sorted.filter(ms => ms > most).length;
  chart('Time of a frame' + (beyond ? ` (${beyond} beyond the scale, up to ${shown(sorted[sorted.length - 1])} ms)` : ''),
    'time of a frame, ms', 340, [0, most], [
      {name: `fixed r = ${shown(data.fixed.r)}`, values: trace.fixed_ms, colour: FIXED, width: 1, unit: ' ms'},
      {name: data.law, values: trace.ms, colour: HELD, unit: ' ms'},
      {name: 'target', values: frames.map(() => target), colour: cssColour('--ink'), width: 1, unit: ' ms'},
    ], [key(`r by ${data.law}`, HELD), key(`r fixed at ${shown(data.fixed.r)}`, FIXED),
      key(`target ${shown(target)} ms`, cssColour('--ink')), key('±5 %', IDEAL + '66', 'area'),
      key(`±${percent(data.gate.tolerance)}: the tolerance`, IDEAL + '2e', 'area')], [drawBands]);
  const ideal = frames.map(idealOf);
  chart('Resize factor', 'r, factor per axis', 230, [1, 1.06 * Math.max(1.1, data.fixed.r, ...trace.r, ...ideal)], [
    {name: 'ideal', values: ideal, colour: IDEAL, width: 1.2, dash: [6, 4], stepped: true},
    {name: 'fixed', values: frames.map(() => data.fixed.r), colour: FIXED, width: 1},
    {name: data.law, values: trace.r, colour: HELD, stepped: true},
  ], [key(`r by ${data.law}`, HELD), key('ideal of the load', IDEAL, 'dashed'), key('fixed', FIXED)]);
  const slopes = trace.fovea_slope;
  const shares = trace.layer_share;
  if (slopes.every(v => v === 1) && shares.every(v => v === 1)) {
    document.getElementById('charts').append(element('p', {class: 'note'},
      'The other quality controls (the fovea’s slope, the share of the layers) stayed at rest.'));
    return;
  }
  chart('Other quality controls', 'factor', 180, [0, 1.1 * Math.max(...slopes)], [
    {name: 'fovea’s slope', values: slopes, colour: '#7a5195', stepped: true},
    {name: 'share of the layers', values: shares, colour: '#8c564b', stepped: true},
  ], [key('fovea’s slope', '#7a5195'), key('share of the layers', '#8c564b')]);
}

function fillTables() {
  const held = data.held;
  const rows = [
    ['frames judged', held.judged_frames],
    [`within the tolerance, ±${percent(data.gate.tolerance)}`, percent(held.within_tolerance)],
    ['within ±5 %', percent(held.within_5)],
    [`fixed r within ±${percent(data.gate.tolerance)} of its own running median`, percent(data.fixed.within_tolerance)],
    ['over 1.02 T', percent(held.over_102_share)],
    ['over 1.1 T', percent(held.over_110_share)],
    ['longest run over 1.02 T', `${held.longest_over} frames`],
    ['median, p95, p99', [held.p50_ms, held.p95_ms, held.p99_ms].map(shown).join(', ') + ' ms'],
    ['reversals of r in 100 frames', shown(held.reversals_per_100)],
  ];
  const measures = document.querySelector('#measures tbody');
  for (const [name, value] of rows) {
    measures.append(element('tr', {}, element('td', {}, name), element('td', {class: 'number'}, String(value))));
  }
  const notices = document.querySelector('#notices tbody');
  for (const notice of data.notices) {
    notices.append(element('tr', {}, element('td', {class: 'number'}, `frame ${notice.frame}`),
      element('td', {}, notice.text || 'nothing any more')));
  }
  if (data.notices.length === 0) {
    notices.append(element('tr', {}, element('td', {}, 'Nothing: r alone was moved.')));
  }
  fill('parts', ['frames', 'shading', 'held', `within ±${percent(data.gate.tolerance)}`, 'ideal r', 'settled after',
    'pixels of the ideal'], data.parts.map(p => [`${p.begin} to ${p.end - 1}`, loadName(p.load),
    p.met === null ? 'not judged' : p.met ? 'held' : 'not held', p.judged_frames === 0 ? 'none judged' : percent(p.within),
    factor(p.ideal_r), p.settle_frames === null ? 'never' : p.settle_frames === 1 ? '1 frame' : `${p.settle_frames} frames`,
    p.used_pixels === null ? 'none judged' : percent(p.used_pixels)]));
  fill('loads', ['shading', 'full rate, first view', 'K', 'C', 'least', 'ideal r', 'what limits r'],
    data.loads.map(l => [loadName(l.times), ms(l.full_rate_ms), ms(l.work_ms), ms(l.rest_ms), ms(l.least_ms),
      factor(l.ideal_r), l.limit]));
}

const factor = r => r.toFixed(2);
const ms = value => shown(value) + ' ms';

function fill(id, heads, rows) {
  const table = document.getElementById(id);
  table.querySelector('thead').append(element('tr', {}, ...heads.map(h => element('th', {}, h))));
  for (const row of rows) {
    table.querySelector('tbody').append(element('tr', {}, ...row.map(cell => element('td', {}, cell))));
  }
}

fillHeader();
drawCharts();
fillTables();
