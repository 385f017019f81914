'use strict';
// The page of `macula hold --plant`: gates, traces of every law on a case, all measures.

const data = JSON.parse(document.getElementById('data').textContent);
const laws = Object.keys(data.laws);

const GATES = [
  {key: 'settle_frames', head: 'settled after', text: v => v === null ? 'never' : `${v} frames`,
    met: (v, c) => v !== null && v <= 2 * c.dead_frames + 4},
  {key: 'over_share', head: 'over 1.02 T', text: percent, met: v => v <= 0.01},
  {key: 'used_pixels', head: 'pixels used', text: percent, met: v => v >= 0.93},
  {key: 'limit_cycle', head: 'limit cycle', text: v => v ? 'yes' : 'none', met: v => !v},
];
const OTHERS = [
  {key: 'sigma_ms', head: 'sigma', text: v => shown(v) + ' ms'},
  {key: 'p99_ms', head: 'p99', text: v => shown(v) + ' ms'},
  {key: 'longest_over', head: 'longest run over', text: v => `${v} frames`},
  {key: 'changes_per_s', head: 'changes a second', text: shown},
];

function row(law, plantCase, columns, gated) {
  const measures = data.laws[law][plantCase.name];
  const cells = columns.map(column => {
    const missed = gated && column.met && !column.met(measures[column.key], plantCase);
    return element('td', missed ? {class: 'missed', style: 'color:#c62828;font-weight:600'} : {},
      column.text(measures[column.key]));
  });
  return element('tr', {}, element('td', {}, law), element('td', {}, plantCase.title), ...cells);
}

function fillTable(table, cases, columns, gated) {
  table.querySelector('thead').append(element('tr', {},
    ...['law', 'case', ...columns.map(c => c.head)].map(h => element('th', {}, h))));
  for (const plantCase of cases) {
    for (const law of laws) table.querySelector('tbody').append(row(law, plantCase, columns, gated));
  }
}

// Two charts for each law under one another, as Yang 2008, Fig. 5: frame time with its target, r.
function drawTraces(plantCase) {
  const host = document.getElementById('traces');
  host.replaceChildren();
  document.getElementById('case-title').textContent = plantCase.title;
  const all = laws.map(law => data.traces[law][plantCase.name]);
  const frames = all[0].ms.map((_, i) => i);
  const mostMs = Math.min(Math.max(...all.flatMap(t => t.ms)), 4 * data.target_ms);
  const axis = (label, size) => ({
    label, size, labelSize: 18, font: '12px system-ui, sans-serif', labelFont: '12px system-ui, sans-serif',
    stroke: cssColour('--soft'), grid: {stroke: cssColour('--line'), width: 1},
    ticks: {stroke: cssColour('--line'), width: 1},
  });
  for (const [i, law] of laws.entries()) {
    const figures = [element('figure'), element('figure')];
    const pair = element('div', {class: 'pair'}, ...figures);
    host.append(element('h3', {}, law + (all[i].notice ? ` (${all[i].notice})` : '')), pair);
    const chart = (figure, label, values, range, extra) => {
      new uPlot({
        width: Math.max(300, figure.clientWidth - 24), height: 150, legend: {show: false},
        scales: {x: {time: false}, y: {range: () => range}},
        axes: [axis('frame number', 34), axis(label, 52)],
        series: [{}, {stroke: COLOURS[i % COLOURS.length], width: 1.2, points: {show: false}}, ...extra.map(() => (
          {stroke: cssColour('--soft'), width: 1, dash: [4, 4], points: {show: false}}))],
      }, [frames, values, ...extra], figure);
    };
    chart(figures[0], 'frame time, ms', all[i].ms, [0, mostMs], [frames.map(() => data.target_ms)]);
    chart(figures[1], 'r, factor per axis', all[i].r, [1, Math.max(...all.flatMap(t => t.r)) * 1.05], []);
  }
}

const provenance = document.getElementById('provenance');
for (const [name, value] of [['commit', data.commit], ['target T', shown(data.target_ms) + ' ms'], ['seeds', data.seeds]]) {
  provenance.append(element('div', {}, element('dt', {}, name), element('dd', {}, String(value))));
}
const deadTimes = data.cases.filter(c => c.name.startsWith('dead-'));
fillTable(document.getElementById('table'), deadTimes, GATES, true);
fillTable(document.getElementById('all'), data.cases, [...GATES, ...OTHERS], false);
const select = document.getElementById('case');
for (const c of data.cases) select.append(element('option', {value: c.name}, c.name));
if (data.cases.some(c => c.name === 'work-doubles')) select.value = 'work-doubles';
select.addEventListener('change', () => drawTraces(data.cases.find(c => c.name === select.value)));
drawTraces(data.cases.find(c => c.name === select.value));
