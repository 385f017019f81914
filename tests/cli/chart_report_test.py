#!/usr/bin/env python3
"""The report page of macula chart in a browser without network."""
import json
import os
import re
import sys
import tempfile

from chart_cases import BROWSER, TINY, chart, opened, results

# What a reader does with the report, all of it.
USE = """<script>
for (const select of document.querySelectorAll('#view select')) {
  for (let i = select.options.length - 1; i >= 0; --i) {
    select.selectedIndex = i;
    select.dispatchEvent(new Event('change'));
  }
}
for (let i = 0; i < document.querySelectorAll('.tabs button').length; ++i) document.querySelectorAll('.tabs button')[i].click();
for (let i = 0; i < 2 * document.querySelectorAll('#table th').length; ++i) document.querySelectorAll('#table th')[i >> 1].click();
setTimeout(() => {  // charts draw after the present task
const viewer = document.getElementById('viewer');
let pictures = 0;
for (const opener of document.querySelectorAll('.dot, #table tbody tr')) {
  opener.dispatchEvent(new MouseEvent('mousemove', {clientX: 5, clientY: 5, bubbles: true}));
  opener.click();
  if (!viewer.open) continue;
  if ([...viewer.querySelectorAll('img')].every(i => i.src.startsWith('data:image/jpeg'))) ++pictures;
  viewer.querySelector('input').value = 30;
  viewer.querySelector('input').dispatchEvent(new Event('input'));
  viewer.close();
}
document.body.append(`used: ${pictures} pictures, divider at ${document.querySelector('.slider').style.getPropertyValue('--at')}`);
}, 300);
</script></body>"""

# Before all scripts: what charts write on their canvases.
RECORD = """<script>
const written = [];
const fillText = CanvasRenderingContext2D.prototype.fillText;
CanvasRenderingContext2D.prototype.fillText = function(text, ...at) { written.push(text); fillText.call(this, text, ...at); };
</script>"""

# What a reader without a mouse does, and where zeros stand.
KEYS = """<script>
setTimeout(() => {
  const facts = [];
  const lane = document.querySelector('#by-time .zero-lane');
  const edge = lane ? Number(lane.getAttribute('y')) : Infinity;
  for (const dot of document.querySelectorAll('#by-time .dot')) {
    facts.push((dot.classList.contains('exact') ? 'zero ' : 'other ') + (parseFloat(dot.style.top) > edge ? 'in' : 'out'));
  }
  facts.sort();
  const heading = name => [...document.querySelectorAll('#table th')].find(h => h.textContent === name);
  for (const times of [1, 2]) {
    const button = heading('RMSE').querySelector('button');
    button.focus();
    button.click();  // as Enter and the space bar do
    facts.push(`${heading('RMSE').getAttribute('aria-sort')} ${heading('RMSE').contains(document.activeElement)}`);
  }
  const viewer = document.getElementById('viewer');
  for (const key of ['Enter', ' ', 'x']) {
    const row = document.querySelector('#table tbody tr[tabindex="0"]');
    row.focus();
    row.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true}));
    facts.push(`${document.activeElement === row || viewer.open} ${viewer.open}`);
    viewer.close();
  }
  for (const row of document.querySelectorAll('#table tbody tr[tabindex="0"]')) {
    row.click();
    facts.push(viewer.querySelector('.pictures figcaption').textContent.split(':')[0] + '; '
      + (getComputedStyle(viewer.querySelector('.difference')).display === 'none') + '; ' + viewer.querySelector('.scale').textContent);
    viewer.close();
  }
  document.body.append(`written: ${JSON.stringify(written)}`, element('pre', {id: 'facts'}, facts.join('\\n')));
}, 300);
</script></body>"""


def check_report(folder):
    page = os.path.join(folder, "out", "report.html")
    with open(page, encoding="utf-8") as f:
        text = f.read()
    addresses = set(re.findall(r"""(?:src|href)=["']?(?!data:)([a-z]+:)?//[^"' >]+""", text))
    assert not addresses, f"the page asks the network: {addresses}"
    dom = opened(folder, page)
    foot = dom[dom.index("How this was made"):]
    assert "macula chart " in foot and "experiment.toml" in foot and "layers-16" in foot, foot[:2000]
    for chart_id, count in (("by-time", 3), ("by-bytes", 3)):
        at = dom.index(f'id="{chart_id}"')
        part = dom[at:dom.index("</figure>", at)]
        assert "<canvas" in part, f"{chart_id} is not drawn"
        assert part.count('class="dot') == count, f"{chart_id}: {part.count('class=')}"
        assert "<text" in part, f"{chart_id} has no labels"
    assert dom.count('class="bar-row"') == 6, "three rows in each of two bar charts"
    table = dom[dom.index('id="table"'):]
    made = results(folder)["points"]
    for point in made:
        assert f'<tr data-key="{point["key"]}"' in table, point["key"]
    assert "refused: " in table
    assert "MISSED" in dom and "1 met, 1 missed" in dom
    assert "nowhere.glb" in dom
    assert "<h1>Tiny &lt;/script&gt; &amp; &lt;b&gt;small&lt;/b&gt;</h1>" in dom
    used = page.replace("report.html", "used.html")
    with open(used, "w", encoding="utf-8") as f:
        f.write(text.replace("</body>", USE))
    # three points in two charts and three rows
    found = re.search(r"used: \d+ pictures, divider at [^<]*", opened(folder, used))
    assert found and found.group(0) == "used: 9 pictures, divider at 30%", found
    check_alone(folder, text, made)


def check_alone(folder, text, made):
    """The page in an empty folder, read without a mouse: lanes of zeros, units, sorting, no dead links."""
    alone = os.path.join(folder, "alone")
    os.makedirs(alone)
    page = os.path.join(alone, "report.html")
    with open(page, "w", encoding="utf-8") as f:
        f.write(text.replace("<head>", "<head>" + RECORD).replace("</body>", KEYS))
    dom = opened(folder, page)
    assert not re.search(r"<a [^>]*href=", dom[dom.index("</script>"):]), "a link to a file that is not there"
    written = json.loads(re.search(r"written: (\[.*?\])<", dom).group(1))
    assert "0" in written, "the lane of zeros has no label"
    for label in ("transparency, ms", "storage + overhead, MiB", "RMSE (display values, 0 to 1)"):
        assert label in written, (label, written)
    facts = re.search(r'<pre id="facts">(.*?)</pre>', dom, re.S).group(1).split("\n")
    assert facts[:8] == ["other out", "other out", "zero in", "ascending true", "descending true",
                         "true true", "true true", "true false"], facts
    exact = next(p for p in made if p["variant"] == "exact")
    assert exact["images"]["difference"] in dom and "Full size, in the folder of the results: " in dom
    assert sorted(fact.split(";")[0] for fact in facts[8:]) == [
        "Difference from the exact picture"] * 2 + ["No difference from the exact picture"], facts
    for fact in facts[8:]:
        _, hidden, scale = fact.split("; ")
        assert (hidden == "true") == fact.startswith("No") == (scale == ""), fact
        assert scale == "" or scale.endswith("and more, of 1 (99th percentile)"), fact


def main():
    if BROWSER is None:
        print("skipped: no chromium for the report (apt-get install chromium)")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        chart(folder, TINY)
        check_report(folder)
    print("chart report: all checks passed")


main()
