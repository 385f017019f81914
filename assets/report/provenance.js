// The foot of every report: by which command, program and inputs its numbers were made.

// "scene" and its value, a thing that was read or a number, or a list of either.
function provenanceRow(name, value) {
  const shortHash = hash => element('code', {title: `SHA-256 ${hash}`}, `${hash.slice(0, 12)}…`);
  const fileText = file => [file.path, ' ', file.sha256 ? shortHash(file.sha256) : '(missing)'];
  const text = input => {
    if (input === null || typeof input !== 'object') return [String(input)];
    const parts = [input.name];
    if (input.path && input.path !== input.name) parts.push(` (${input.path})`);
    if (input.sha256) parts.push(' ', shortHash(input.sha256));
    if (input.files.length > 0) parts.push(' with ', ...input.files.flatMap((f, i) => i ? [', ', ...fileText(f)] : fileText(f)));
    return parts;
  };
  const list = Array.isArray(value) ? value : [value];
  const parts = list.flatMap((input, i) => i ? ['; ', ...text(input)] : text(input));
  return element('div', {}, element('dt', {}, name), element('dd', {}, ...parts));
}

function fillProvenance() {
  const {command, version, commit, settings, ...inputs} = data.provenance;
  const list = element('dl', {class: 'made'}, element('div', {}, element('dt', {}, 'command'), element('dd', {}, element('code', {}, command))),
    provenanceRow('program', `Macula ${version}, commit ${commit}`));
  for (const [name, value] of Object.entries({...inputs, ...settings})) {
    if (value !== null && !(Array.isArray(value) && value.length === 0)) list.append(provenanceRow(name, value));
  }
  document.body.append(element('footer', {}, element('h2', {}, 'How this was made'), list,
    element('p', {class: 'note'}, 'Hashes are the first digits of each file’s SHA-256; results.json has all of them.')));
}
if (data.provenance) fillProvenance();
