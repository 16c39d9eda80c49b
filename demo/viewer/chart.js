"use strict";

/* ---- the chart ---- */

const chart = { left: 34, right: 10, top: 20, bottom: 24, width: 300, height: 190, time: 1, most: 1 };
const chartX = (t) => chart.left + (t / chart.time) * (chart.width - chart.left - chart.right);
const chartY = (p) => chart.height - chart.bottom - (p / chart.most) * (chart.height - chart.top - chart.bottom);

/* A staircase through [time, height] points, drawn on to `end`. */
function stairs(points, end) {
  let path = `M${chartX(0).toFixed(1)} ${chartY(0).toFixed(1)}`;
  for (const [t, p] of points) path += `H${chartX(t).toFixed(1)}V${chartY(p).toFixed(1)}`;
  return `${path}H${chartX(end).toFixed(1)}`;
}

/* 1, 2 or 5 of some power of ten, so that about five of them fill the range. */
function niceStep(range) {
  const power = 10 ** Math.floor(Math.log10(range / 5));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => range / step <= 6);
}

function chartText(text, x, y, attributes = {}) {
  const element = makeSvg("text", { x, y, ...attributes });
  element.textContent = text;
  return element;
}

function drawAxes(svg) {
  const step = niceStep(chart.time);
  svg.append(makeSvg("path", { class: "axis",
    d: [0, 0.5, 1].map((p) => `M${chart.left} ${chartY(p)}H${chart.width - chart.right}`).join("") }));
  for (const p of [0, 0.5, 1])
    svg.append(chartText(String(p), chart.left - 6, chartY(p) + 4, { "text-anchor": "end" }));
  for (let t = 0; t <= chart.time + EPSILON; t += step) {
    const isLast = t + step > chart.time + EPSILON;
    const text = rounded(t, 2) + (isLast ? " s" : "");
    const isAtEdge = chartX(t) + 4 * text.length > chart.width; // it would be cut
    svg.append(chartText(text, isAtEdge ? chart.width - 1 : chartX(t), chart.height - 6, { "text-anchor": isAtEdge ? "end" : "middle" }));
  }
}

function drawChart(model) {
  const svg = $("chart"), { plan, places } = model.data;
  chart.width = svg.clientWidth || 300;
  chart.time = Math.max(endOf(model) * (isOpen() ? 1.2 : 1), plan.at(-1)?.[0] ?? 0, 1); // room for a live run to grow
  chart.most = Math.max(1, plan.at(-1)?.[1] ?? 0, places.reduce((sum, place) => sum + place.likelihood, 0));
  svg.replaceChildren();
  drawAxes(svg);
  svg.append(makeSvg("path", { class: "plan", d: stairs(plan, chart.time) }));
  for (const name of ["ghost", "achieved", "now", "find"]) svg.append(makeSvg("path", { class: name, id: `chart-${name}` }));
  svg.append(chartText("", 0, chart.top - 7, { class: "find-text", id: "chart-found" }));
}

function showFind(model, now) {
  const found = foundAt(model), isPast = finite(found) && found <= now + EPSILON;
  $("chart-find").setAttribute("d", isPast ? `M${chartX(found)} ${chartY(0)}V${chart.top - 4}` : "");
  say("chart-found", isPast ? `found ${rounded(found, 2)} s` : "");
  if (!isPast) return;
  // Beside the line where there is room.
  const isLeft = chartX(found) > chart.width / 2;
  $("chart-found").setAttribute("x", chartX(found) + (isLeft ? -5 : 5));
  $("chart-found").setAttribute("text-anchor", isLeft ? "end" : "start");
}

function showGhostCurve(model, now) {
  const ghost = shownGhost(model), passed = ghost?.curve.slice(0, countUntil(ghost.curve, now, (step) => step[0])) ?? [];
  $("key-ghost").hidden = ghost === null;
  $("chart-ghost").setAttribute("d", ghost === null ? "" : stairs(passed, Math.min(now, ghost.duration)));
  sayNumber("ghost-now", passed.at(-1)?.[1] ?? 0, 3);
}

function showChart(model, state, now) {
  showGhostCurve(model, now);
  $("chart-achieved").setAttribute("d", stairs(state.curve, now));
  $("chart-now").setAttribute("d", `M${chartX(now)} ${chartY(0)}V${chart.top}`);
  showFind(model, now);
  sayNumber("expected-now", expectedAt(model, now), 3);
  sayNumber("achieved-now", state.likelihood, 3);
}
