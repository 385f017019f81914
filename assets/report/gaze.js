'use strict';
// The page of `macula gaze study`: for each log, error against latency for each way to the point.

const data = JSON.parse(document.getElementById('data').textContent);
const ways = [...new Set(data.logs.flatMap(log => log.points.map(p => p.way)))];

// One line for each way; x is the latency, y a statistic of the error in degrees.
function lines(host, points, statistic) {
  const latencies = [...new Set(points.map(p => p.latency_ms))].sort((a, b) => a - b);
  const series = ways.map(way => latencies.map(ms => {
    const point = points.find(p => p.way === way && p.latency_ms === ms);
    return point ? point.error_deg[statistic] : null;
  }));
  const axis = (label, size) => ({
    label, size, labelSize: 22, font: '12px system-ui, sans-serif', labelFont: '13px system-ui, sans-serif',
    stroke: cssColour('--soft'), grid: {stroke: cssColour('--line'), width: 1},
    ticks: {stroke: cssColour('--line'), width: 1},
  });
  new uPlot({
    width: Math.max(300, host.clientWidth), height: 300,
    scales: {x: {time: false}, y: {range: (u, low, high) => [0, Math.max(high, 0.1) * 1.08]}},
    axes: [axis('latency, ms', 42), axis('error, degrees', 62)],
    series: [{label: 'ms'}, ...ways.map((way, i) => ({
      label: way, stroke: COLOURS[i], width: 2, dash: i % 2 ? [6, 4] : undefined,
      points: {show: true, size: 6}, value: (u, v) => v === null ? '–' : shown(v) + '°',
    }))],
  }, [latencies, ...series], host);
}

const provenance = document.getElementById('provenance');
for (const [name, value] of [['commit', data.commit], ['frames a second', data.fps]]) {
  provenance.append(element('div', {}, element('dt', {}, name), element('dd', {}, String(value))));
}

for (const log of data.logs) {
  const median = element('div', {class: 'chart'});
  const p95 = element('div', {class: 'chart'});
  document.getElementById('logs').append(element('section', {},
    element('h2', {}, `${log.log} (${log.format})`),
    element('p', {class: 'note'}, `Coordinates: ${log.coordinates}. Degrees on a display of ${log.display_statement}.`),
    ...log.warnings.map(warning => element('p', {class: 'note'}, `Warning: ${warning}.`)),
    element('div', {class: 'pair'},
      element('figure', {}, element('figcaption', {}, 'Median error'), median),
      element('figure', {}, element('figcaption', {}, '95th percentile'), p95))));
  lines(median, log.points, 'median');
  lines(p95, log.points, 'p95');
}

const headings = ['log', 'samples', 'median, as it is', 'median, predicted', '95th, as it is', '95th, predicted'];
document.querySelector('#table thead').append(element('tr', {}, ...headings.map(h => element('th', {}, h))));
for (const log of data.logs) {
  const {predicted, unpredicted} = log.landing_error_deg;
  const cells = [log.log, unpredicted.frames, ...['median', 'p95'].flatMap(s => [unpredicted[s], predicted[s]])
    .map(v => v === null ? '–' : shown(v) + '°')];
  document.querySelector('#table tbody').append(element('tr', {}, ...cells.map(c => element('td', {}, String(c)))));
}
