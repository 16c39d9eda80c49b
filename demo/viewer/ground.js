"use strict";

/* ---- the map, and what changes seldom on it ---- */

const costOf = (sign) => (sign === "#" ? 0 : sign >= "2" && sign <= "9" ? Number(sign) : 1);
const view = { cell: 20, ratio: 1, ground: null, division: "", left: 0, top: 0, columns: 1, rows: 1 }; // the part shown, in cells

/* As `quarter draw` has it: the free cells and what lies next to them. Maps often have wide margins of nothing known. */
function crop({ columns, rows, rows_text }) {
  const isFree = (sign) => costOf(sign) > 0;
  const spans = rows_text.map((text) => [[...text].findIndex(isFree), [...text].findLastIndex(isFree)]);
  const used = spans.flatMap(([first], row) => (first < 0 ? [] : [row]));
  if (used.length === 0) return Object.assign(view, { left: 0, top: 0, columns, rows });
  const left = Math.max(0, Math.min(...used.map((row) => spans[row][0])) - 1);
  const right = Math.min(columns - 1, Math.max(...used.map((row) => spans[row][1])) + 1);
  const top = Math.max(0, used[0] - 1), bottom = Math.min(rows - 1, used.at(-1) + 1);
  return Object.assign(view, { left, top, columns: right - left + 1, rows: bottom - top + 1 });
}

function sizeMap(model) {
  const { columns, rows } = crop(model.data.map), canvas = $("map");
  const panel = getComputedStyle(canvas.parentElement);
  const width = Math.max(0, canvas.parentElement.clientWidth - parseFloat(panel.paddingLeft) - parseFloat(panel.paddingRight));
  // As wide as the panel, but the controls below should stay on the screen.
  const cell = Math.min(width / columns, Math.max(260, innerHeight - 390) / rows);
  view.cell = cell >= 8 ? Math.floor(cell) : cell;
  view.ratio = devicePixelRatio || 1;
  canvas.style.width = `${view.cell * columns}px`;
  canvas.style.height = `${view.cell * rows}px`;
  canvas.width = Math.round(view.cell * columns * view.ratio);
  canvas.height = Math.round(view.cell * rows * view.ratio);
  showScale(model.data.map);
}

/* Whole metres, or a round part of one, about a fifth of the map. A map without metres is measured in cells. */
function showScale({ cell_size, unit }) {
  const isMetric = unit !== "cells" && cell_size > 0, size = isMetric ? cell_size : 1;
  const width = view.cell * view.columns, most = Math.min(160, Math.max(50, width / 4));
  const power = 10 ** Math.floor(Math.log10((most * size) / view.cell));
  const length = [5, 2, 1].map((factor) => factor * power).find((step) => (step * view.cell) / size <= most) ?? power;
  const text = `${rounded(length, 6)} ${isMetric ? "m" : length === 1 ? "cell" : "cells"}`;
  $("scale").style.width = `${width}px`;
  $("scale").dataset.length = String(length);
  $("scale").firstChild.style.width = `${(length * view.cell) / size}px`;
  if ($("scale").lastChild.textContent !== text) $("scale").lastChild.textContent = text;
}

/* A context whose unit is a cell of the whole map, or with `unit` pixels to a cell, whatever part of it is shown. */
function fit(context, canvas, unit) {
  context.setTransform(canvas.width / (unit * view.columns), 0, 0, canvas.height / (unit * view.rows), 0, 0);
  context.translate(-unit * view.left, -unit * view.top);
}

/* As `quarter draw` has it: a free cell belongs to the robot that is to visit the place nearest to it by steps. */
function floodTerritories({ map, places }, owners) {
  const owner = map.rows_text.map((row) => new Array(row.length).fill(-1));
  const queue = [];
  const claim = (column, row, robot) => {
    if (owner[row]?.[column] !== -1 || costOf(map.rows_text[row][column]) === 0) return;
    owner[row][column] = robot;
    queue.push([column, row]);
  };
  places.forEach(({ x, y }, number) => {
    const { owner, left } = owners[number];
    if (owner >= 0 || left >= 0) claim(Math.floor(x), Math.floor(y), owner >= 0 ? owner : LEFT);
  });
  for (let head = 0; head < queue.length; head++) {
    const [column, row] = queue[head], robot = owner[row][column];
    claim(column, row - 1, robot), claim(column + 1, row, robot);
    claim(column, row + 1, robot), claim(column - 1, row, robot);
  }
  return owner;
}

function forCells(map, paint) {
  map.rows_text.forEach((text, row) => {
    for (let column = 0; column < text.length; column++) paint(column, row, costOf(text[column]));
  });
}

const isLost = (state, robot) => state.robots[robot]?.kind === "lost";

function drawTerritories(context, data, state) {
  const owner = floodTerritories(data, state.owners), tint = Number(style.tint);
  forCells(data.map, (column, row) => {
    const robot = owner[row][column];
    if (robot < 0 && robot !== LEFT) return;
    context.fillStyle = robot === LEFT ? style.left : colour(robot, tint);
    context.fillRect(column, row, 1, 1);
  });
  data.routes.forEach((route, robot) => {
    if (isLost(state, robot)) return;
    context.fillStyle = colour(robot, tint);
    const cells = new Set(route.map(([x, y]) => `${Math.floor(x)} ${Math.floor(y)}`));
    for (const cell of cells) context.fillRect(...cell.split(" ").map(Number), 1, 1);
  });
}

/* Hatched the more densely the slower the ground. Lines run through from cell to cell. */
function drawSlowGround(context, map) {
  context.strokeStyle = style.slow;
  forCells(map, (column, row, cost) => {
    if (cost < 2) return;
    context.save();
    context.beginPath();
    context.rect(column, row, 1, 1);
    context.clip();
    context.globalAlpha = 0.06 + 0.02 * cost;
    context.fillStyle = style.slow;
    context.fillRect(column, row, 1, 1);
    context.globalAlpha = 0.75;
    const lines = cost < 4 ? 2 : cost < 7 ? 3 : 4;
    context.lineWidth = Math.max(0.05, 0.6 / view.cell);
    context.beginPath();
    for (let k = 0; k < 2 * lines; k++) {
      context.moveTo(column, row + (k + 0.5) / lines);
      context.lineTo(column + 2, row + (k + 0.5) / lines - 2);
    }
    context.stroke();
    context.restore();
  });
}

function drawGrid(context, { columns, rows }) {
  if (view.cell < 10) return;
  context.strokeStyle = style.grid;
  context.lineWidth = 1 / view.cell;
  context.beginPath();
  for (let column = 1; column < columns; column++) context.moveTo(column, 0), context.lineTo(column, rows);
  for (let row = 1; row < rows; row++) context.moveTo(0, row), context.lineTo(columns, row);
  context.stroke();
}

/* Beside the cells' middles, each robot in a lane of its own, or routes along the same cells would hide one another. */
function drawRoutes(context, data, state) {
  data.routes.forEach((route, robot) => {
    const shift = ((robot + 0.5) / data.routes.length - 0.5) * 0.36;
    context.strokeStyle = colour(robot, isLost(state, robot) ? 0.25 : 0.6);
    context.lineWidth = Math.max(0.06, 1.2 / view.cell);
    context.lineJoin = "round";
    context.setLineDash([0.3, 0.2]);
    context.beginPath();
    route.forEach(([x, y], k) => context[k === 0 ? "moveTo" : "lineTo"](x + shift, y + shift));
    context.stroke();
  });
  context.setLineDash([]);
}

function drawStarts(context, data) {
  data.starts.forEach(([x, y], robot) => {
    context.strokeStyle = colour(robot);
    context.lineWidth = Math.max(0.06, 1.5 / view.cell);
    context.strokeRect(x - 0.36, y - 0.36, 0.72, 0.72);
  });
}

/* What the ground's colours hang on: who has which place, and who is lost. */
const divisionOf = (state) => JSON.stringify([
  state.owners.map(({ owner, left }) => (owner >= 0 ? owner : left >= 0 ? LEFT : -1)),
  state.robots.map(({ kind }) => kind === "lost")]);

/* What changes seldom, drawn when it does. In cells, so that nothing below needs to know pixels. */
function drawGround(model, state) {
  const canvas = $("map"), { data } = model;
  view.division = state.division;
  view.ground = document.createElement("canvas");
  view.ground.width = canvas.width;
  view.ground.height = canvas.height;
  const context = view.ground.getContext("2d");
  fit(context, canvas, 1);
  context.fillStyle = style.ground;
  context.fillRect(0, 0, data.map.columns, data.map.rows);
  drawTerritories(context, data, state);
  drawSlowGround(context, data.map);
  drawGrid(context, data.map);
  context.fillStyle = style.wall;
  forCells(data.map, (column, row, cost) => cost === 0 && context.fillRect(column, row, 1, 1));
  drawRoutes(context, data, state);
  drawStarts(context, data);
}
