// Pictures of results: the value next to the pointer, a picture as a file, of rows a slider. It is put into pages as it is.
(() => {
  const make = (tag, attributes, space = '1999/xhtml') => {
    const made = document.createElementNS(`http://www.w3.org/${space}`, tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    return made;
  };
  const boxOf = plot => ['x', 'y', 'width', 'height'].map(name => Number(plot.getAttribute(name)));
  const linesOf = plot => [...plot.querySelectorAll('[data-series] > path[fill=none]')].map(path => ({ name: path.parentElement.dataset.series,
    places: path.getAttribute('d').split(/[M ]/).filter(Boolean).map(place => place.split(',').map(Number)) }));
  // Of an axis "log|PX PX VALUE VALUE;...|LABEL" what a place is, by the range that is nearest, as exactly as a picture has it.
  function valueAt(axis, px) {
    const [kind, ranges] = axis.split('|'), away = ([from, to]) => Math.max(Math.min(from, to) - px, px - Math.max(from, to));
    const [from, to, low, high] = ranges.split(';').map(range => range.split(' ').map(Number)).reduce((best, each) => (away(each) < away(best) ? each : best)), part = (px - from) / (to - from);
    const digits = kind === 'log' ? { maximumSignificantDigits: 3 } : { maximumFractionDigits: Math.min(20, Math.max(0, Math.floor(1 - Math.log10(Math.abs((high - low) / (to - from)))))) };
    const value = kind === 'log' ? low * (high / low) ** part : low + part * (high - low);
    return (Math.abs(value) >= 1e15 ? value.toExponential(3).replace('+', '') : value.toLocaleString('en', digits)).replace(/^-(?=[0.]*$)/, '').replaceAll('-', '−');
  }
  const labelOf = axis => axis.split('|').slice(2).join('|');
  const worded = ({ dataset }, [x, y]) => [[dataset.x, x], [dataset.y, y]].map(([axis, px]) => `${labelOf(axis)}: ${valueAt(axis, px)}`).join('; ');

  function showNearest(svg, event, cross, readout) {
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse()), away = ({ at }) => Math.hypot(at[0] - x, at[1] - y);
    const plot = [...svg.querySelectorAll('[data-x]')].find(each => (([left, top, width, height]) => x >= left && x <= left + width && y >= top && y <= top + height)(boxOf(each)));
    const signs = [...(plot?.querySelectorAll('[data-series] > :not(path[fill=none]):has(title)') ?? [])].map(sign => (({ x, y, width, height }) => ({ at: [x + width / 2, y + height / 2], text: sign.textContent }))(sign.getBBox()));
    const nearest = [...signs, ...(plot ? linesOf(plot) : []).flatMap(({ name, places }) => places.map(at => ({ at, name })))].reduce((best, each) => (best && away(best) <= away(each) ? best : each), null);
    cross.setAttribute('d', nearest ? (([left, top, width, height]) => `M${nearest.at[0]},${top}v${height}M${left},${nearest.at[1]}h${width}`)(boxOf(plot)) : '');
    if (nearest) readout.textContent = nearest.text ?? `${nearest.name}; ${worded(plot, nearest.at)}`;
  }

  async function save(svg, kind) {
    const name = svg.getAttribute('aria-label').replace(/[^\w]+/g, '-').toLowerCase() || 'picture', [, , width, height] = boxOf(svg);
    let blob = new Blob([new XMLSerializer().serializeToString(svg)], { type: 'image/svg+xml' });
    if (kind === 'PNG') {
      const image = Object.assign(new Image(), { src: URL.createObjectURL(blob) }), canvas = make('canvas', { width: 2 * width, height: 2 * height }), context = canvas.getContext('2d');
      await image.decode();
      Object.assign(context, { fillStyle: 'white' }).fillRect(0, 0, canvas.width, canvas.height);
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      blob = await new Promise(done => canvas.toBlob(done));
    }
    make('a', { href: URL.createObjectURL(blob), download: `${name}.${kind.toLowerCase()}` }).click();
  }

  // A dot on each line that has a place a row, and what they are there.
  function addSlider(picture, svgs, readout) {
    const length = Number(picture.dataset.rows), slider = make('input', { type: 'range', class: 'time', min: 0, max: length - 1, value: 0, 'aria-label': 'Row' });
    slider.oninput = () => svgs.forEach(svg => {
      svg.querySelectorAll('.moment').forEach(dot => dot.remove());
      const lines = [...svg.querySelectorAll('[data-x]')].flatMap(plot => linesOf(plot).filter(({ places }) => places.length === length).map(({ name, places }) => ({ plot, name, at: places[slider.value] })));
      for (const { plot, at: [cx, cy] } of lines) plot.append(make('circle', { class: 'moment', cx, cy, r: 5 }, '2000/svg'));
      const isOverTime = ({ plot }) => labelOf(plot.dataset.x) === 'time, s', time = lines.filter(isOverTime).slice(0, 1).map(({ plot, at }) => `time, s: ${valueAt(plot.dataset.x, at[0])}`);
      readout.textContent = [...time, ...lines.map(line => `${line.name}: ${isOverTime(line) ? valueAt(line.plot.dataset.y, line.at[1]) : worded(line.plot, line.at)}`)].join('; ');
    });
    picture.append(slider);
    slider.oninput();
  }

  for (const picture of document.querySelectorAll('.picture')) {
    const svgs = [...picture.querySelectorAll(':scope > svg')], readout = make('output', { class: 'quiet' });
    for (const svg of svgs) {
      const cross = svg.appendChild(make('path', { class: 'cross', fill: 'none' }, '2000/svg'));
      svg.onpointermove = event => showNearest(svg, event, cross, readout);
    }
    if ('rows' in picture.dataset) addSlider(picture, svgs, readout);
    for (const kind of ['SVG', 'PNG']) picture.append(Object.assign(make('button', { type: 'button' }), { textContent: `Save ${kind}`, onclick: () => save(svgs.find(svg => svg.checkVisibility()), kind) }));
    picture.append(readout);
  }
})();
