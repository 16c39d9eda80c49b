"use strict";

/* ---- the ghost: the same mines searched without a plan, beside the planned search ---- */

const GHOST_TRAIL = 5; // seconds

const isScan = (scan, places) => Array.isArray(scan) && finite(scan[0]) && validIndex(scan[1]) && scan[1] < places;

/* Bytes from outside. A record that is older, or was told to leave it out, holds none. */
function isGhost(ghost, data) {
  if (ghost == null) return true;
  return ghost.tick > 0 && ghost.duration > 0 && (ghost.finished_at == null || finite(ghost.finished_at)) &&
    Array.isArray(ghost.scans) && ghost.scans.every((scan) => isScan(scan, data.places.length)) &&
    isTracks(ghost.tracks, data.robots, ["x", "y"]);
}

function ghostOf({ ghost, places }) {
  if (ghost == null) return null;
  let likelihood = 0;
  const looks = places.map(() => 0);
  return {
    times: Array.from(ghost.tracks[0].x, (_, k) => k * ghost.tick),
    tracks: ghost.tracks.map(({ x, y }) => ({ x: hundredths(x), y: hundredths(y) })),
    curve: ghost.scans.map(([t, place]) => [t, (likelihood += worthOf(places[place], ++looks[place]))]),
    firsts: ghost.scans.filter(([, place], k) => ghost.scans.findIndex(([, other]) => other === place) === k).map(([t]) => t),
    finishedAt: ghost.finished_at,
    duration: ghost.duration,
  };
}

/* The ghost, where there is one and it is wanted. */
const shownGhost = (model) => ($("show-ghost").checked ? model.ghost : null);

/* When there is nothing more to see. */
const endOf = (model) => Math.max(model.duration, shownGhost(model)?.duration ?? 0);

/* ---- on the map: pale, below all else that moves ---- */

function drawGhostTrail(context, { times, tracks }, robot, now) {
  const { x, y } = tracks[robot], at = spotAt(times, tracks[robot], now);
  context.globalAlpha = 0.5;
  context.lineWidth = Math.max(1.5, view.cell * 0.08);
  context.beginPath();
  const last = countUntil(times, now);
  for (let k = countUntil(times, now - GHOST_TRAIL * paceOf(player.model.data)); k < last; k++) context.lineTo(x[k] * view.cell, y[k] * view.cell);
  context.lineTo(at.x * view.cell, at.y * view.cell);
  context.stroke();
  return at;
}

function drawGhost(context, model, now) {
  const ghost = shownGhost(model), radius = robotRadius(model);
  if (ghost === null) return;
  context.save();
  context.strokeStyle = context.fillStyle = style.ghost;
  for (let robot = 0; robot < model.data.robots; robot++) {
    const at = drawGhostTrail(context, ghost, robot, now);
    circle(context, at.x * view.cell, at.y * view.cell, radius);
    context.globalAlpha = 0.45;
    context.fill();
    context.globalAlpha = 0.9;
    context.lineWidth = 1.5;
    context.setLineDash([3, 2]);
    context.stroke();
    context.setLineDash([]);
  }
  context.restore();
}

/* ---- the race: how far either is, and when it came to its end ---- */

/* The find ends the search; where none is to, the last place does. Below: null, it has not come to that. */
function finishOf(model, state, now) {
  const endsByFind = model.data.mode !== "clear" && model.data.mines?.length > 0, { curve } = state;
  const at = endsByFind ? foundAt(model) : curve.length === looksOf(model.data) ? curve.at(-1)?.[0] : null;
  return finite(at) && at <= now + EPSILON ? at : null;
}

function ghostFinish(ghost, now) {
  return finite(ghost?.finishedAt) && ghost.finishedAt <= now + EPSILON ? ghost.finishedAt : null;
}

function showLane(name, model, finish, now, scanned, isOver) {
  const lane = $(`lane-${name}`), part = (finish ?? now) / Math.max(endOf(model), EPSILON);
  lane.dataset.state = finish !== null ? "finished" : isOver ? "over" : "running";
  lane.style.setProperty("--part", `${100 * clamp(part, 0, 1)}%`);
  const text = finish !== null ? `${rounded(finish, 2)} s` : `${scanned} of ${model.data.places.length} places`;
  say(`race-${name}`, text);
  const exact = finish === null ? "" : String(finish);
  if ($(`race-${name}`).dataset.value !== exact) $(`race-${name}`).dataset.value = exact;
}

function showRace(model, state, now) {
  const ghost = shownGhost(model);
  $("race").hidden = ghost === null;
  if (ghost === null) return;
  const planned = Math.min(now, model.duration);
  showLane("plan", model, finishOf(model, state, now), planned, state.scanned, now >= model.duration - EPSILON);
  const scanned = countUntil(ghost.firsts, now);
  showLane("ghost", model, ghostFinish(ghost, now), Math.min(now, ghost.duration), scanned, now >= ghost.duration - EPSILON);
}

/* Both at their end: what the plan was worth. null: not yet. */
function verdictAt(model, state, now) {
  const plan = finishOf(model, state, now), ghost = ghostFinish(shownGhost(model), now);
  if (plan === null || ghost === null) return null;
  const what = model.data.mode === "clear" ? "All was searched" : state.finds > 0 ? "Found" : "All was searched";
  const times = ghost / plan, worth = times > 1.05 ? `: ${rounded(times, 1)} times as long` : "";
  return `${what} after ${rounded(plan, 2)} s, without a plan after ${rounded(ghost, 2)} s${worth}.`;
}

function wireGhost() {
  $("show-ghost").addEventListener("change", () => {
    const { model } = player;
    if (model === null) return;
    sayNumber("duration", endOf(model), 1);
    player.now = Math.min(player.now, endOf(model));
    drawChart(model);
    request();
  });
}
