"use strict";

/* ---- what came in: bytes from outside, so all of it is checked ---- */

function isMap(map) {
  return Boolean(map) && map.columns > 0 && map.rows > 0 && Array.isArray(map.rows_text) &&
    map.rows_text.length === map.rows &&
    map.rows_text.every((row) => typeof row === "string" && row.length === map.columns);
}
const isPoint = (point) => Array.isArray(point) && finite(point[0]) && finite(point[1]);
const isPoints = (list) => Array.isArray(list) && list.every(isPoint);
const isLooks = (looks) => looks == null || (Array.isArray(looks) && looks.length > 0 && looks.every(finite));
const isPlace = (place) => Boolean(place) && finite(place.x) && finite(place.y) && finite(place.likelihood) &&
  isLooks(place.looks);

/* What a robot and a place are called: by their names, or else by their numbers. */
const robotName = (data, robot) => String(data.robot_names?.[robot] ?? robot);
const placeName = (place, index) => String(place.name ?? place.number ?? index);

function isTrack(track, samples, names) {
  return Boolean(track) && names.every((name) =>
    Array.isArray(track[name]) && track[name].length === samples && track[name].every(finite));
}

function isTracks(tracks, robots, names) {
  const samples = tracks?.[0]?.x?.length;
  return Array.isArray(tracks) && tracks.length === robots && samples > 0 &&
    tracks.every((track) => isTrack(track, samples, names));
}

/* An index that may be left out; -1 and null say the same. */
const isIndex = (value, count) => value == null || (Number.isInteger(value) && value >= -1 && value < count);

function isEvent(event, data) {
  return Boolean(event) && finite(event.t) && typeof event.kind === "string" &&
    isIndex(event.robot, data.robots) && isIndex(event.place, data.places.length) &&
    (event.kind !== "shut" || (finite(event.x) && finite(event.y)));
}

const isEvents = (list, data) => Array.isArray(list) && list.every((event) => isEvent(event, data));

/* Seconds told in one of the simulator's own clock, by which robots move about as fast on any screen. */
const paceOf = (data) => (data.pace > 0 ? data.pace : 1);

/* Whether robots may miss what is there, or tire. */
const hasTerms = (data) => data.tires === true || data.places.some(({ looks }) => looks);

/* Looks that the plan has at all places. */
const looksOf = (data) => data.places.reduce((sum, { looks }) => sum + (looks?.length ?? 1), 0);

/* The first part that a page cannot be drawn without and that is not there; null: all is well. */
function damagedPart(data, live) {
  const recorded = [
    ["tick", () => data.tick > 0],
    ["duration", () => data.duration > 0],
    ["tracks", () => isTracks(data.tracks, data.robots, ["x", "y", "heading"])],
    ["ghost", () => isGhost(data.ghost, data)],
    ["said", () => data.said == null || isPoints(data.said)],
  ];
  const parts = [
    ["map", () => isMap(data.map)],
    ["robots", () => Number.isInteger(data.robots) && data.robots > 0],
    ["places", () => Array.isArray(data.places) && data.places.every(isPlace)],
    ["starts", () => isPoints(data.starts) && data.starts.length === data.robots],
    ["routes", () => Array.isArray(data.routes) && data.routes.every(isPoints)],
    ["plan", () => isPoints(data.plan)],
    ...(live ? [] : recorded),
    ["events", () => (live && !data.events) || isEvents(data.events, data)],
  ];
  return parts.find(([, isSound]) => !isSound())?.[0] ?? null;
}

/* One sentence on what is wrong with the data; null: nothing is. */
function problemOf(data, live) {
  if (data === null || typeof data !== "object") return "This page holds no replay: the host program puts one in.";
  if (data.format !== 1) return `This page reads replays of format 1, and this one is of format ${data.format}.`;
  const part = damagedPart(data, live);
  return part === null ? null : `This replay is damaged: its ${part} cannot be read.`;
}

/* ---- the model: the JSON, with tracks in cells and radians that a live run can add to ---- */

const byTime = (a, b) => a.t - b.t;
const hundredths = (list) => Array.from(list, (value) => value / 100);

function modelOf(data) {
  const samples = data.tracks ? data.tracks[0].x.length : 0;
  return {
    data,
    ghost: ghostOf(data),
    times: Array.from({ length: samples }, (_, k) => k * data.tick),
    tracks: Array.from({ length: data.robots }, (_, r) => ({
      x: hundredths(data.tracks?.[r].x ?? []),
      y: hundredths(data.tracks?.[r].y ?? []),
      heading: hundredths(data.tracks?.[r].heading ?? []),
    })),
    events: withTakeovers(data, data.events ?? []),
    duration: data.duration ?? 0,
    result: data.result ?? null,
  };
}

/* The samples before and after t, and how much of the way between them is done by then. */
function samplesAt(times, t) {
  const a = Math.max(0, countUntil(times, t) - 1), b = Math.min(a + 1, times.length - 1);
  return { a, b, part: b > a ? clamp((t - times[a]) / (times[b] - times[a]), 0, 1) : 0 };
}

/* Where a track is at t, between the samples by straight lines. */
function spotAt(times, track, t) {
  const { a, b, part } = samplesAt(times, t);
  const between = (list) => list[a] + (list[b] - list[a]) * part;
  return { x: between(track.x), y: between(track.y) };
}

/* Where robot r is at t: {x, y, heading}. */
function poseAt(model, r, t) {
  const { times } = model, track = model.tracks[r];
  if (times.length === 0) return { x: model.data.starts[r][0], y: model.data.starts[r][1], heading: 0 };
  const { a, b, part } = samplesAt(times, t);
  const turn = Math.atan2(Math.sin(track.heading[b] - track.heading[a]), Math.cos(track.heading[b] - track.heading[a]));
  return { ...spotAt(times, track, t), heading: track.heading[a] + turn * part };
}

const validIndex = (value) => Number.isInteger(value) && value >= 0;

/* A robot that acts again was not stopped, stuck or without power for good; a lost one stays lost. */
function passRobot(state, event) {
  const robot = state.robots[event.robot];
  if (!robot || robot.kind === "lost") return;
  const kind = event.kind === "home" ? "stopped" : event.kind;
  if (["stopped", "lost", "stuck", "reset"].includes(kind)) Object.assign(robot, { kind, since: event.t });
  else if (!FAULTS.has(event.kind)) robot.kind = "moving";
}

/* What the n-th look at a place counts; of records without looks the first counts all. */
const worthOf = ({ looks, likelihood }, n) => (looks ? looks[n - 1] ?? 0 : n === 1 ? likelihood : 0);

/* A place counts once for each look that it is worth, and one where a mine was found was scanned, whether or not an
 * event of its own says so. */
function passPlace(state, event, model) {
  if (!validIndex(event.place)) return;
  const place = state.places[event.place];
  const isFind = event.kind === "found";
  if (event.kind === "shut") place.shut = true;
  if (event.kind === "missed") place.missed = true;
  if (SCANS.has(event.kind)) passScan(state, place, event, model.data.places[event.place]);
  if (isFind && place.found === null) {
    place.found = event.t;
    state.finds++;
  }
}

function passScan(state, place, event, { looks, likelihood }) {
  const worth = worthOf({ looks, likelihood }, ++place.looks);
  if (place.at === null) {
    place.at = event.t;
    state.scanned++;
  }
  if (worth === 0 && place.looks > 1) return;
  state.likelihood += worth;
  state.curve.push([event.t, state.likelihood]);
}

/* What the events so far say; `passed` is how many there were. */
function stateAfter(model, passed) {
  const state = {
    passed, scanned: 0, faults: 0, likelihood: 0, curve: [], finds: 0, shut: [], owners: ownersOf(model.data),
    robots: Array.from({ length: model.data.robots }, () => ({ kind: "moving", since: 0 })),
    places: model.data.places.map(() => ({ at: null, found: null, shut: false, missed: false, looks: 0 })),
  };
  for (const event of model.events.slice(0, passed)) {
    if (FAULTS.has(event.kind)) state.faults++;
    if (event.kind === "shut") state.shut.push(event);
    passRobot(state, event);
    passPlace(state, event, model);
    passOwner(state.owners, event);
  }
  state.division = divisionOf(state);
  return state;
}

/* How many signals robots had sent one another by t; of an older record, and live, it is known at the end alone. */
function saidAt(model, t) {
  const { said } = model.data, isOver = t >= model.duration - EPSILON;
  if (isOver || !said) return isOver ? model.result?.messages?.terminate : null;
  const steps = countUntil(said, t, (step) => step[0]);
  return steps > 0 ? said[steps - 1][1] : 0;
}

/* As the host says once the run has ended; until then the first find seen. */
function foundAt(model) {
  if (model.result) return model.result.found_at;
  return model.events.find((event) => event.kind === "found")?.t ?? null;
}

function expectedAt(model, t) {
  const steps = countUntil(model.data.plan, t, (step) => step[0]);
  return steps > 0 ? model.data.plan[steps - 1][1] : 0;
}
