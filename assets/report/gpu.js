'use strict';
// The page of gpu-report.sh: what ran on a device, what the tests said, and the times.

const data = JSON.parse(document.getElementById('data').textContent);

const row = (cell, ...values) => element('tr', {}, ...values.map(v => element(cell, {}, v instanceof Node ? v : String(v))));

function table(headings, rows) {
  return element('div', {class: 'scroll'}, element('table', {},
    element('thead', {}, row('th', ...headings)), element('tbody', {}, ...rows.map(values => row('td', ...values)))));
}

const word = status => element('span', {class: status}, status);

// What GoogleTest wrote: counts, and the failed and the skipped ones by name.
function ofTests(result) {
  const tests = result.testsuites.flatMap(suite => suite.testsuite.map(test => ({...test, suite: suite.name})));
  const skipped = tests.filter(test => test.result === 'SKIPPED');
  const named = test => `${test.suite}.${test.name}`;
  const parts = [element('p', {}, `${result.tests - result.failures - skipped.length} of ${result.tests} passed, ` +
    `${result.failures} failed, ${skipped.length} skipped.`)];
  const failed = tests.filter(test => test.failures);
  if (failed.length > 0) {
    parts.push(table(['failed', 'why'],
      failed.map(test => [named(test), element('pre', {}, test.failures.map(f => f.failure).join('\n').slice(0, 2000))])));
  }
  if (skipped.length > 0) {
    parts.push(table(['skipped', 'why'],
      skipped.map(test => [named(test), (test.skipped ?? []).map(s => s.message ?? '').join(' ')])));
  }
  return parts;
}

// Medians as bars, one figure for each scene and size; what was refused below.
function ofChart(result) {
  const points = result.points.filter(p => p.status === 'measured');
  const places = [...new Set(points.map(p => `${p.scene}, ${p.width} × ${p.height}`))];
  const parts = places.map(place => {
    const here = points.filter(p => `${p.scene}, ${p.width} × ${p.height}` === place);
    const slowest = Math.max(...here.map(p => p.ms.total.median));
    const host = element('div', {class: 'bars'});
    bars(host, [{name: 'transparency', colour: cssColour('--stored')}, {name: 'all else', colour: cssColour('--merged')}],
      here.map(p => {
        const clear = Math.min(p.ms.transparency.median, p.ms.total.median);
        return {name: p.label, figure: `${shown(p.ms.total.median)} ms`, parts: [
          {value: clear, colour: cssColour('--stored'), title: `transparency: ${shown(p.ms.transparency.median)} ms`},
          {value: p.ms.total.median - clear, colour: cssColour('--merged'),
           title: `in all ${shown(p.ms.total.p5)} to ${shown(p.ms.total.p95)} ms`}]};
      }), slowest);
    return element('figure', {}, element('figcaption', {}, place), host);
  });
  const refused = result.points.filter(p => p.status === 'refused');
  if (refused.length > 0) {
    parts.push(element('details', {}, element('summary', {}, `${refused.length} points were refused`),
      table(['scene', 'variant', 'why'], refused.map(p => [p.scene, p.label, p.reason]))));
  }
  return [...parts, element('p', {class: 'note'}, 'Pictures and errors: chart/report.html.')];
}

function ofHold(result) {
  const held = result.held ?? {};
  return [element('p', {}, `${shown(result.target_ms)} ms: ${result.verdict}` + (result.reason ? ` (${result.reason})` : '') + '.'),
    table(['within 5 %', 'over by 2 % or more', 'median', '95th percentile', 'clock'],
      [[percent(held.within_5), percent(held.over_102_share), `${shown(held.p50_ms)} ms`, `${shown(held.p95_ms)} ms`, result.time_source]]),
    element('p', {class: 'note'}, 'Frame by frame: the report.html in its own folder.')];
}

const flat = (value, path = '') => value !== null && typeof value === 'object' && !Array.isArray(value)
  ? Object.entries(value).flatMap(([key, inner]) => flat(inner, path ? `${path}.${key}` : key))
  : [[path, Array.isArray(value) ? value.map(v => typeof v === 'number' ? shown(v) : JSON.stringify(v)).join(', ') : String(value)]];

function contents(section) {
  if (!section.result) return [];
  if (section.id.startsWith('gl-') || section.id.startsWith('stability-')) return ofTests(section.result);
  if (section.id === 'chart') return ofChart(section.result);
  if (section.id.startsWith('hold-')) return ofHold(section.result);
  return [table(['what', 'value'], flat(section.result))];
}

const device = data.sections.find(s => s.id === 'devices')?.result;
document.getElementById('title').textContent = `Macula on ${device?.renderer ?? 'a device that did not start'}`;
document.getElementById('description').textContent = device?.version ? `OpenGL ${device.version}` : '';
for (const [name, value] of [['program', data.version], ['length', data.length], ['processor', data.processor],
  ['kernel', data.kernel], ['driver', data.kernel_driver], ['date', data.date]]) {
  if (value) document.getElementById('provenance').append(element('div', {}, element('dt', {}, name), element('dd', {}, value)));
}
const count = status => data.sections.filter(s => s.status === status).length;
document.getElementById('verdict').append(word(data.verdict),
  `: ${count('passed')} sections passed, ${count('failed')} failed, ${count('skipped')} skipped` +
  (data.software ? '. A software rasteriser: its times are not those of a GPU.' : '.'));
document.querySelector('#sections thead').append(row('th', 'section', 'status', 'seconds', 'command'));
for (const section of data.sections) {
  document.querySelector('#sections tbody').append(row('td', element('a', {href: `#${section.id}`}, section.title),
    word(section.status), section.seconds, element('code', {}, section.command)));
  document.querySelector('main').append(element('section', {id: section.id}, element('h2', {}, section.title, ': ', word(section.status)),
    ...contents(section),
    section.status === 'skipped' ? element('p', {}, section.log)
      : element('details', section.status === 'failed' ? {open: ''} : {},
        element('summary', {}, 'What it printed'), element('pre', {}, section.log))));
}
