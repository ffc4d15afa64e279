// Hovering names the setting; choosing one, in the chart, the table or by the slider, shows its pictures.
const report = JSON.parse(document.getElementById('report').textContent);
const pictures = JSON.parse(document.getElementById('pictures').textContent);
const points = [...document.querySelectorAll('.point')], rows = [...document.querySelectorAll('tbody tr')];
const slider = document.getElementById('slider'), tip = document.getElementById('tip');
const number = x => x === 0 ? '0' : Math.abs(x) >= 0.01 && Math.abs(x) < 1e4 ? +x.toPrecision(3) + '' : x.toExponential(1);
function choose(i) {
  slider.value = i;
  for (const all of [points, rows]) all.forEach(e => e.classList.toggle('chosen', +e.dataset.rung === i));
  document.getElementById('error').src = pictures.errors[i];
  document.getElementById('cost').src = pictures.costs[i];
  document.getElementById('name').textContent = report.settings[i].options;
}
function show(point) {
  const s = report.settings[+point.dataset.rung];
  tip.textContent = '';
  const name = document.createElement('b');
  name.textContent = s.setting;
  tip.append(name, ': ' + number(s.relative_time) + ' × the time, worst ' + number(s.error.worst_px) + ' px, ' +
             s.missed + ' missed, ' + s.false_surfaces + ' false');
  const stage = document.getElementById('stage').getBoundingClientRect(), box = point.getBoundingClientRect();
  tip.style.left = Math.max(0, Math.min(box.left - stage.left + 16, stage.width - tip.offsetWidth)) + 'px';
  tip.style.top = Math.max(0, box.top - stage.top - tip.offsetHeight - 6) + 'px';
  tip.style.visibility = 'visible';
}
for (const point of points) {
  point.addEventListener('mouseenter', () => show(point));
  point.addEventListener('focus', () => show(point));
  for (const end of ['mouseleave', 'blur']) point.addEventListener(end, () => { tip.style.visibility = 'hidden'; });
}
for (const e of [...points, ...rows]) e.addEventListener('click', () => choose(+e.dataset.rung));
slider.addEventListener('input', () => choose(+slider.value));
choose(Math.max(0, report.settings.findIndex(s => s.default)));
