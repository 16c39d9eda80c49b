"use strict";

/* ---- what changes on the map: places, robots and their ways ---- */

/* Text with a rim, readable on any ground. Sizes and places in pixels. */
function label(context, text, x, y, size, ink, rim) {
  context.font = `600 ${size}px system-ui, Arial, "Liberation Sans", "DejaVu Sans", sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  if (rim) {
    context.lineWidth = 3;
    context.lineJoin = "round";
    context.strokeStyle = rim;
    context.strokeText(text, x, y);
  }
  context.fillStyle = ink;
  context.fillText(text, x, y + 0.5);
}

function star(context, x, y, radius) {
  context.beginPath();
  for (let k = 0; k < 16; k++) {
    const angle = (k * Math.PI) / 8, reach = k % 2 === 0 ? radius : radius * 0.55;
    context.lineTo(x + reach * Math.sin(angle), y - reach * Math.cos(angle));
  }
  context.closePath();
}

function circle(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
}

/* Areas go with likelihoods; the likeliest place fills its cell. */
function placeRadius(data, place) {
  const largest = Math.max(...data.places.map((other) => other.likelihood), 1e-9);
  const full = clamp(view.cell * 0.46, 6, 22);
  return Math.max(full * 0.4, full * Math.sqrt(Math.max(0, place.likelihood) / largest));
}

function drawSuspected(context, x, y, radius, ink) {
  circle(context, x, y, radius);
  context.globalAlpha = 0.55;
  context.fillStyle = style.ground;
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = ink;
  context.lineWidth = 2;
  context.stroke();
}

function drawClear(context, x, y, radius, ink) {
  circle(context, x, y, radius);
  context.fillStyle = ink;
  context.globalAlpha = 0.35;
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = style.ink;
  context.lineWidth = 2;
  context.beginPath();
  const size = Math.max(4, radius * 0.55);
  context.moveTo(x - size, y + size * 0.1);
  context.lineTo(x - size * 0.2, y + size * 0.8);
  context.lineTo(x + size, y - size * 0.8);
  context.stroke();
}

function drawMine(context, x, y, size, width, dashes) {
  star(context, x, y, size);
  context.fillStyle = style.mine;
  context.fill();
  context.strokeStyle = "#111";
  context.lineWidth = width;
  context.setLineDash(dashes);
  context.stroke();
  context.setLineDash([]);
}

function drawFound(context, x, y) {
  drawMine(context, x, y, clamp(view.cell * 0.75, 10, 26), 1.5, []);
}

function drawHiddenMine(context, x, y) {
  drawMine(context, x, y, clamp(view.cell * 0.36, 5, 12), 1, [2, 2]);
}

function drawPlace(context, model, state, number) {
  const place = model.data.places[number], seen = state.places[number];
  const x = place.x * view.cell, y = place.y * view.cell, radius = placeRadius(model.data, place);
  const { owner } = state.owners[number], ink = owner >= 0 ? colour(owner) : style.soft;
  if (seen.found !== null) drawFound(context, x, y);
  else if (seen.at !== null) drawClear(context, x, y, radius, ink);
  else drawSuspected(context, x, y, radius, ink);
  const isHidden = seen.found === null && model.data.mines?.includes(number);
  if (isHidden && $("hidden-mines").checked) drawHiddenMine(context, x, y);
}

const isOnMap = (x, y, across, down) =>
  x - across > view.cell * view.left && x + across < view.cell * (view.left + view.columns) &&
  y - down > view.cell * view.top && y + down < view.cell * (view.top + view.rows);

/* Beside a place, for text that reaches `half` further to both sides than a digit does: the first of its corners on the map that no
   robot is at, nor other text; where all are taken, the first on the map. */
function cornerOf(x, y, beside, robots, half = 0, others = []) {
  const corners = [[1, -1], [-1, -1], [1, 1], [-1, 1]].map(([right, down]) => [x + right * (beside + half), y + down * beside]);
  const inside = corners.filter(([left, top]) => isOnMap(left, top, half + 6, 6));
  const apart = (left, at) => Math.max(0, Math.abs(at - left) - half);
  const isFree = ([left, top]) =>
    robots.every((robot) => Math.hypot(apart(left, robot.x), robot.y - top) > robot.reach + 6) &&
    others.every((other) => apart(left, other.x) > other.half + 8 || Math.abs(other.y - top) > 11);
  return inside.find(isFree) ?? inside[0] ?? corners[0];
}

const MOST_LETTERS = 16; // of a name; on a map as narrow as a phone's fewer, the table below has it all

/* What a place is called, cut to what a map of that width has room for. */
function shortName(place, number) {
  const letters = [...placeName(place, number)], most = view.cell * view.columns < 500 ? MOST_LETTERS / 2 : MOST_LETTERS;
  return letters.length > most ? `${letters.slice(0, most - 1).join("").trimEnd()}…` : letters.join("");
}

/* Above the robots, or one that stands on a place would hide which it is. */
function drawNames(context, model, now) {
  // On a small screen the names of many places would hide the map.
  if (view.cell < 5 && model.data.places.length > 40) return;
  const reach = 1.7 * robotRadius(model), others = [];
  const robots = model.tracks.map((_, robot) => poseAt(model, robot, now))
    .map((pose) => ({ x: pose.x * view.cell, y: pose.y * view.cell, reach }));
  model.data.places.forEach((place, number) => {
    const text = shortName(place, number), half = 3 * (text.length - 1);
    const beside = Math.max(view.cell * 0.5, placeRadius(model.data, place) * 0.75) + 3;
    const [x, y] = cornerOf(place.x * view.cell, place.y * view.cell, beside, robots, half, others);
    others.push({ x, y, half });
    label(context, text, x, y, 11, style.ink, style.ground);
  });
}

/* All of the way so far, thin, to be held against the planned route. Two points a second show its shape. */
function drawPath(context, model, robot, now) {
  const last = countUntil(model.times, now), stride = Math.max(1, Math.round(last / (2 * Math.max(now, 1))));
  const { x, y } = model.tracks[robot];
  context.strokeStyle = colour(robot, 0.75);
  context.lineWidth = Math.max(1, view.cell * 0.05);
  context.beginPath();
  for (let k = 0; k < last; k += stride) context.lineTo(x[k] * view.cell, y[k] * view.cell);
  context.stroke();
}

/* Fading, in strokes of a second: one stroke a sample would cost more and look the same. */
function drawTrail(context, model, robot, now) {
  context.lineCap = "round";
  context.lineJoin = "round";
  context.lineWidth = Math.max(2, view.cell * 0.12);
  const second = paceOf(model.data);
  for (let age = TRAIL; age >= 1; age--) {
    const from = now - age * second, to = from + second;
    if (to < 0) continue;
    context.strokeStyle = colour(robot, 0.85 * (1 - (age - 1) / TRAIL));
    context.beginPath();
    const start = poseAt(model, robot, Math.max(0, from)), end = poseAt(model, robot, to);
    context.moveTo(start.x * view.cell, start.y * view.cell);
    const last = countUntil(model.times, to);
    for (let k = countUntil(model.times, from); k < last; k++)
      context.lineTo(model.tracks[robot].x[k] * view.cell, model.tracks[robot].y[k] * view.cell);
    context.lineTo(end.x * view.cell, end.y * view.cell);
    context.stroke();
  }
}

/* Towards +x: a disc with a nose; of a robot that has stopped, a square with one. */
function bodyPath(context, radius, hasStopped) {
  context.beginPath();
  context.moveTo(radius * (hasStopped ? 0.9 : 0.55), -radius * 0.9);
  context.lineTo(radius * 1.7, 0);
  context.lineTo(radius * (hasStopped ? 0.9 : 0.55), radius * 0.9);
  if (!hasStopped) context.arc(0, 0, radius, 0.9, 2 * Math.PI - 0.9);
  else context.lineTo(-radius * 0.9, radius * 0.9), context.lineTo(-radius * 0.9, -radius * 0.9);
  context.closePath();
}

function drawBody(context, radius, robot, kind) {
  const isGone = kind === "lost" || kind === "reset";
  bodyPath(context, radius, kind === "stopped");
  context.fillStyle = isGone ? style.ground : colour(robot);
  context.fill();
  context.strokeStyle = isGone ? colour(robot) : style.ground;
  context.lineWidth = isGone ? 2 : 1.5;
  context.stroke();
}

function drawLost(context, x, y, radius) {
  const reach = radius * 1.25;
  for (const [width, ink] of [[5.5, style.ground], [3, style.fault]]) {
    context.lineWidth = width;
    context.strokeStyle = ink;
    context.beginPath();
    context.moveTo(x - reach, y - reach), context.lineTo(x + reach, y + reach);
    context.moveTo(x + reach, y - reach), context.lineTo(x - reach, y + reach);
    context.stroke();
  }
}

/* A cell that is a wall from now on: barred, with what it holds still to be seen. */
function drawShut(context, { x, y }) {
  const left = (x - 0.5) * view.cell, top = (y - 0.5) * view.cell, side = view.cell;
  for (const [width, ink] of [[5, style.ground], [2.5, style.fault]]) {
    context.lineWidth = width;
    context.strokeStyle = ink;
    context.beginPath();
    context.rect(left, top, side, side);
    for (const part of [1 / 3, 2 / 3]) {
      context.moveTo(left + part * side, top);
      context.lineTo(left + part * side, top + side);
    }
    context.stroke();
  }
}

/* A robot that does nothing for a while, and the sign that says why. */
function drawHalted(context, x, y, radius, sign) {
  circle(context, x, y, radius * 1.7);
  context.strokeStyle = style.fault;
  context.lineWidth = 2.5;
  context.setLineDash([4, 3]);
  context.stroke();
  context.setLineDash([]);
  label(context, sign, x + radius * 1.4, y - radius * 1.4, 15, style.fault, style.ground);
}

/* Larger than the true robot where that would be too small to see. */
const robotRadius = (model) => Math.max(clamp(view.cell * 0.34, 6, 10), (model.data.robot_radius ?? 0) * view.cell);

/* A robot that had stopped may have to drive on; no event says so, but it is half a cell away then. */
function kindNow(model, state, robot, pose) {
  const { kind, since } = state.robots[robot];
  if (kind !== "stopped") return kind;
  const stop = poseAt(model, robot, since);
  return Math.hypot(stop.x - pose.x, stop.y - pose.y) > 0.5 ? "moving" : kind;
}

function drawRobot(context, model, state, robot, now) {
  const pose = poseAt(model, robot, now), radius = robotRadius(model), kind = kindNow(model, state, robot, pose);
  const x = pose.x * view.cell, y = pose.y * view.cell, isGone = kind === "lost";
  context.save();
  context.translate(x, y);
  context.rotate(-pose.heading); // counter-clockwise on the screen, where y points down
  drawBody(context, radius, robot, kind);
  context.restore();
  if (isGone) {
    drawLost(context, x, y, radius);
    label(context, String(robot), x - radius * 2.1, y, Math.round(radius * 1.35), colour(robot), style.ground);
  } else label(context, String(robot), x, y, Math.round(radius * 1.35), kind === "reset" ? colour(robot) : inkOn(robot));
  if (kind === "stuck") drawHalted(context, x, y, radius, "!");
  if (kind === "reset") drawHalted(context, x, y, radius, "off");
}

/* Where an event is to be seen: at its place, or where its robot is now; null: nowhere. */
function spotOf(model, event, now) {
  if (validIndex(event.place)) return model.data.places[event.place];
  if (event.kind === "shut") return event;
  return validIndex(event.robot) && SETBACKS.has(event.kind) ? poseAt(model, event.robot, now) : null;
}

/* A ring that widens for a moment where a place was scanned, a robot failed or a mine was found. */
function drawPulses(context, model, passed, now) {
  for (let k = passed - 1; k >= 0 && now - model.events[k].t < PULSE * paceOf(model.data); k--) {
    const event = model.events[k], isFault = SETBACKS.has(event.kind), isFind = event.kind === "found";
    const at = spotOf(model, event, now);
    if (at === null) continue;
    const part = stillMedia.matches ? 0.4 : (now - event.t) / (PULSE * paceOf(model.data));
    circle(context, at.x * view.cell, at.y * view.cell, (isFind ? 40 : 14) * part + view.cell * 0.5);
    context.globalAlpha = 1 - part;
    context.strokeStyle = isFault ? style.fault : style.ink;
    context.lineWidth = isFind || isFault ? 4 : 2;
    context.stroke();
    context.globalAlpha = 1;
  }
}

function drawMap(model, state, now) {
  const canvas = $("map"), context = canvas.getContext("2d");
  // Before the window has a size there is nothing to draw on; its first resize draws.
  if (canvas.width === 0 || canvas.height === 0) return;
  if (view.ground === null || view.division !== state.division) drawGround(model, state);
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.drawImage(view.ground, 0, 0);
  fit(context, canvas, view.cell);
  drawGhost(context, model, now);
  for (let robot = 0; robot < model.data.robots; robot++) {
    drawPath(context, model, robot, now);
    drawTrail(context, model, robot, now);
  }
  model.data.places.forEach((_, number) => drawPlace(context, model, state, number));
  for (const event of state.shut) drawShut(context, event);
  drawPulses(context, model, state.passed, now);
  for (let robot = 0; robot < model.data.robots; robot++) drawRobot(context, model, state, robot, now);
  drawNames(context, model, now);
}
