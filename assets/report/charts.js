'use strict';
// Charts of the report: log-log scatter and curves on uPlot's axes, and stacked bars.

// Okabe & Ito's colours for all kinds of sight, and darker or lighter ones where they run out.
const COLOURS = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#7a5195',
  '#8c564b', '#6b8e23', '#c2185b', '#607d8b', '#b8a000', '#00838f', '#a1887f'];

const cssColour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'on') for (const [event, call] of Object.entries(value)) node.addEventListener(event, call);
    else if (name === 'style') node.style.cssText = value;
    else node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

function svgElement(tag, attributes, text = '') {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.textContent = text;
  return node;
}

// 4 significant digits, without exponents where a reader would stumble over them.
function shown(number) {
  if (number === null || number === undefined) return '–';
  if (number === 0) return '0';
  const size = Math.abs(number);
  if (size >= 1e6) return (number / 1e6).toPrecision(4) + ' M';
  if (size >= 1000) return number.toFixed(0);
  if (size < 1e-4) return number.toExponential(2);
  return String(Number(number.toPrecision(size >= 1 ? 4 : 3)));
}

const mebi = bytes => bytes === null || bytes === undefined ? null : bytes / 1048576;
const percent = share => share === null || share === undefined ? '–' : (100 * share).toFixed(share < 0.0995 ? 2 : 1) + ' %';

const tip = {
  show(text, event) {
    const box = document.getElementById('tip');
    box.textContent = text;
    box.hidden = false;
    const at = event.clientX === undefined || (event.type === 'focus')
      ? event.target.getBoundingClientRect() : {right: event.clientX, bottom: event.clientY};
    const x = Math.min(at.right + 14, innerWidth - box.offsetWidth - 8);
    const y = Math.min(at.bottom + 14, innerHeight - box.offsetHeight - 8);
    box.style.left = Math.max(8, x) + 'px';
    box.style.top = Math.max(8, y) + 'px';
  },
  hide() { document.getElementById('tip').hidden = true; },
};

// The points that no other beats in both values, from left to right.
function paretoFront(points) {
  const sorted = [...points].sort((a, b) => a.x - b.x || a.y - b.y);
  const front = [];
  for (const point of sorted) {
    if (front.length === 0 || point.y < front[front.length - 1].y) front.push(point);
  }
  return front;
}

// Powers of ten around the values, with a margin, so that no point touches the frame.
function logRange(values) {
  const low = Math.log10(Math.min(...values));
  const high = Math.log10(Math.max(...values));
  const margin = Math.max(0.12, 0.1 * (high - low));
  return [10 ** (low - margin), 10 ** (high + margin)];
}

// Every digit of a power of ten in short ranges; 1, 2 and 5, or 1 alone, in long ones.
function logTicks(low, high) {
  const decades = Math.log10(high / low);
  const steps = decades > 2.5 ? [1] : decades > 0.9 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
  const ticks = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power) {
    for (const step of steps) {
      const tick = Number((step * 10 ** power).toPrecision(3));
      if (tick >= low && tick <= high) ticks.push(tick);
    }
  }
  return ticks;
}

// Where a label may stand: beside a point that stands alone; above or below one on a line.
const BESIDE = [[1, 0], [0.9, -0.6], [0.9, 0.6], [-1, 0], [-0.9, -0.6], [-0.9, 0.6], [0, -1], [0, 1]];
const ABOVE = [[0, -1.5], [0, 1.5], [0.8, -1.4], [-0.8, 1.4], ...BESIDE];

// Places labels beside their points where no other label, point or edge is in the way; the best of
// several directions and distances. A label that finds no place stays away: its point still speaks
// when it is pointed at.
function placeLabels(dots, width, height, directions) {
  const taken = dots.map(d => ({x0: d.px - 8, x1: d.px + 8, y0: d.py - 8, y1: d.py + 8}));
  const hits = box => box.x0 < 2 || box.x1 > width - 2 || box.y0 < 2 || box.y1 > height - 2 ||
    taken.some(t => box.x0 < t.x1 && box.x1 > t.x0 && box.y0 < t.y1 && box.y1 > t.y0);
  const placed = [];
  for (const dot of dots) {
    const w = dot.label.length * 6.3 + 4;
    search:
    for (const reach of [11, 24, 40, 60, 84]) {
      for (const [dx, dy] of directions) {
        const x = dot.px + dx * reach;
        const y = dot.py + dy * reach;
        const x0 = dx > 0 ? x : dx < 0 ? x - w : x - w / 2;
        const box = {x0, x1: x0 + w, y0: y - 8, y1: y + 8};
        if (hits(box)) continue;
        taken.push(box);
        placed.push({dot, x: x0 + 2, y: y + 4, from: reach > 11 ? {x, y} : null});
        break search;
      }
    }
  }
  return placed;
}

const placed = (u, p) => ({...p, px: u.valToPos(p.x, 'x'), py: u.valToPos(p.y, 'y')});

const lineThrough = (dots, attributes) => svgElement('polyline',
  {...attributes, points: dots.map(p => `${p.px.toFixed(1)},${p.py.toFixed(1)}`).join(' ')});

function labelDots(u, svg, dots, directions) {
  for (const {dot, x, y, from} of placeLabels(dots, u.over.clientWidth, u.over.clientHeight, directions)) {
    if (from) svg.append(svgElement('line', {class: 'leader', x1: dot.px, y1: dot.py, x2: from.x, y2: from.y}));
    svg.append(svgElement('text', {x, y, ...(dot.ink ? {style: `fill:${dot.ink}`} : {})}, dot.label));
  }
}

// Puts lines and labels over the axes, and a button for each dot. classOf gives further classes.
function addDots(u, svg, dots, classOf) {
  u.over.querySelectorAll('svg, .dot').forEach(n => n.remove());
  u.over.append(svg);
  for (const dot of dots) {
    u.over.append(element('button', {
      class: `dot${classOf(dot)}`, 'aria-label': dot.text, 'data-key': dot.key,
      style: `left:${dot.px}px;top:${dot.py}px;--colour:${dot.colour}`,
      on: {mousemove: e => tip.show(dot.text, e), mouseleave: tip.hide, focus: e => tip.show(dot.text, e),
           blur: tip.hide, click: dot.open},
    }));
  }
}

// A logarithmic axis. Zero has no place on it: zeros stand in a lane of their own below a break.
// `zero` is where, null without zeros; `edge` is where the break is.
function logAxis(values, label) {
  const positive = values.filter(v => v > 0);
  const range = logRange(positive.length > 0 ? positive : [1]);
  const ticks = positive.length > 0 ? logTicks(...range) : [];
  if (positive.length === values.length) return {label, range, ticks, log: true, zero: null};
  const below = share => range[0] * (range[0] / range[1]) ** share;  // by a share of the axis
  const zero = below(0.1);
  return {label, range: [below(0.16), range[1]], ticks: [zero, ...ticks], log: true, zero, edge: below(0.03),
    tickText: v => v === zero ? '0' : shown(v)};
}

// The lanes of zeros: washed, and cut off from the axis by a zigzag.
function drawLanes(u, svg, x, y) {
  const width = u.over.clientWidth;
  const height = u.over.clientHeight;
  const lane = (box, points) => svg.append(svgElement('rect', {class: 'zero-lane', ...box}),
    svgElement('polyline', {class: 'break', points: points.join(' ')}));
  const zigzag = length => Array.from({length: Math.floor(length / 4) + 1}, (_, i) => [4 * i, i % 2 ? 2 : -2]);
  if (y.zero !== null) {
    const top = u.valToPos(y.edge, 'y');
    lane({x: 0, y: top, width, height: height - top}, zigzag(width).map(([along, off]) => `${along},${top + off}`));
  }
  if (x.zero !== null) {
    const right = u.valToPos(x.edge, 'x');
    lane({x: 0, y: 0, width: right, height}, zigzag(height).map(([along, off]) => `${right + off},${along}`));
  }
}

// A bar of colours with what its ends stand for. gradient: of CSS
function colourBar(gradient, low, high) {
  return element('div', {class: 'colour-bar'}, element('span', {}, low),
    element('i', {style: `background:${gradient}`}), element('span', {}, high));
}

// Eight of magma's colours, as engine/measure/error_maps.cpp has them.
const flipBar = () => colourBar('linear-gradient(to right,#000004,#1a1042,#4a1079,#792282,#aa337d,#d9466b,#f7725c,#feaa74,#fcfdbf)',
  'FLIP 0: nothing is seen', '1: the largest difference');

// uPlot's axes without its series. x, y: {label, range, ticks, log, tickText}; x is logarithmic.
function chartFrame(host, points, x, y, overlay, height = 400) {
  const axis = ({label, ticks, tickText = shown}, size) => ({
    label, size, labelSize: 22, font: '12px system-ui, sans-serif', labelFont: '13px system-ui, sans-serif',
    stroke: cssColour('--soft'), grid: {stroke: cssColour('--line'), width: 1},
    ticks: {stroke: cssColour('--line'), width: 1},
    splits: () => ticks,
    values: (u, splits) => splits.map(v => tickText(v)),
    filter: (u, splits) => splits,
  });
  const sorted = [...points].sort((a, b) => a.x - b.x);
  new uPlot({
    width: Math.max(300, host.clientWidth), height,
    legend: {show: false}, cursor: {show: false},
    scales: {x: {time: false, distr: 3, range: () => x.range}, y: {distr: y.log ? 3 : 1, range: () => y.range}},
    axes: [axis(x, 42), axis(y, 62)],
    series: [{}, {show: true, paths: () => null, points: {show: false}}],
    hooks: {draw: [overlay]},
  }, [sorted.map(p => p.x), sorted.map(p => p.y)], host);
}

// A scatter chart in `host`. points: {x, y, label, colour, text, open()}; both axes log, with lanes for zeros.
function scatter(host, points, xLabel, yLabel) {
  host.replaceChildren();
  if (points.length === 0) {
    host.append(element('p', {class: 'empty'}, 'Nothing to show here.'));
    return;
  }
  const x = logAxis(points.map(p => p.x), xLabel);
  const y = logAxis(points.map(p => p.y), yLabel);
  points = points.map(p => ({...p, zero: p.x === 0 || p.y === 0, x: p.x || x.zero, y: p.y || y.zero}));
  const front = paretoFront(points);
  const overlay = u => {
    const svg = svgElement('svg', {});
    drawLanes(u, svg, x, y);
    const dots = points.map(p => placed(u, p));
    if (front.length > 1) svg.append(lineThrough(front.map(p => placed(u, p)), {class: 'front'}));
    labelDots(u, svg, dots, BESIDE);
    addDots(u, svg, dots, dot => `${dot.zero ? ' exact' : ''}${front.some(p => p.key === dot.key) ? ' best' : ''}`);
  };
  chartFrame(host, points, x, y, overlay);
}

// The points of a curve that none of its others beats: faster and at least as good. As the targets
// have it; see engine/experiment/curve.h.
function envelope(points) {
  const kept = [];
  for (const point of [...points].sort((a, b) => b.x - a.x || b.y - a.y)) {
    if (kept.length === 0 || point.y > kept[kept.length - 1].y) kept.push(point);
  }
  return kept.reverse();
}

// Round numbers in a range, about `count` of them.
function roundTicks(low, high, count) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find(s => s * power >= rough);
  const ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high; ++i) ticks.push(Number((i * step).toPrecision(6)));
  return ticks;
}

// Curves of quality (higher is better) against a logarithmic speed-up. series: [{colour, points: [{x,
// y, ...as in scatter}]}], y null for an image that equals the exact one: it stands at the top.
function curves(host, series, xLabel, yLabel) {
  host.replaceChildren();
  const finite = series.flatMap(s => s.points.filter(p => p.y !== null).map(p => p.y));
  const low = Math.min(...finite, Infinity);
  const high = Math.max(...finite, -Infinity);
  if (finite.length === 0) {
    host.append(element('p', {class: 'empty'}, 'Every picture here equals the exact one.'));
    return;
  }
  const margin = Math.max(1, 0.12 * (high - low));
  const top = high + margin;  // where exact pictures stand
  const ys = [low - margin, top + margin];
  const all = series.map(s => s.points.map(p => ({...p, exact: p.y === null, y: p.y ?? top, colour: s.colour})));
  const points = all.flat();
  const xs = logRange([1, ...points.map(p => p.x)]);
  const best = all.map(envelope);
  const overlay = u => {
    const svg = svgElement('svg', {});
    for (const line of best) {
      const path = line.filter(p => !p.exact).map(p => placed(u, p));
      if (path.length > 1) svg.append(lineThrough(path, {class: 'curve', style: `stroke:${line[0].colour}`}));
    }
    const dots = points.map(p => placed(u, p));
    labelDots(u, svg, dots, ABOVE);
    addDots(u, svg, dots, dot => dot.exact ? ' exact' : best.flat().some(p => p.key === dot.key) ? '' : ' beaten');
  };
  chartFrame(host, points, {label: xLabel, range: xs, ticks: logTicks(...xs)},
    {label: yLabel, range: ys, tickText: v => v === top ? '∞' : shown(v),
     ticks: [...roundTicks(low - margin, high + margin / 2, 7), ...(points.some(p => p.exact) ? [top] : [])]}, overlay, 460);
}

// Rows of stacked bars. rows: {name, parts: [{value, colour, title}], figure, open()}; `whole` is
// the length of the track.
function bars(host, keys, rows, whole) {
  host.replaceChildren();
  if (rows.length === 0) {
    host.append(element('p', {class: 'note'}, 'Nothing to show here.'));
    return;
  }
  host.append(element('div', {class: 'bar-keys'}, ...keys.map(({name, colour}) => element('span', {},
    element('i', {class: 'swatch square', style: `background:${colour}`}), name))));
  for (const row of rows) {
    const spans = row.parts.filter(p => p.value > 0).map(part => element('span', {
      style: `width:${(100 * part.value / whole).toFixed(3)}%;background:${part.colour}`,
      on: {mousemove: e => tip.show(part.title, e), mouseleave: tip.hide},
    }));
    host.append(element('div', {class: 'bar-row'}, element('span', {class: 'name', title: row.name}, row.name),
      element('span', {class: 'track'}, ...spans), element('span', {class: 'figure'}, row.figure)));
  }
}
