"use strict";

/* ---- who has a place to search: its territory's robot; when that is lost, or its battery does not last, whoever comes
 * for what it left ---- */

const SCANS = new Set(["scanned", "looked", "missed", "found"]);
const LEFT = -2; // on the ground: it was a lost robot's, and nobody has come yet

/* Of each place: `owner` is to search it, -1 nobody; `left` is the lost robot that it was left by, -1 none. */
const ownersOf = (data) => data.places.map(({ territory }) =>
  ({ owner: validIndex(territory) ? territory : -1, left: -1, isScanned: false }));

const leftBy = (owners, robot) => owners.filter(({ left, isScanned }) => left === robot && !isScanned);

const LEAVES = new Set(["lost", "battery"]);

function leaveAll(owners, { robot }) {
  for (const place of owners)
    if (place.owner === robot && !place.isScanned) Object.assign(place, { owner: -1, left: robot });
}

const PASS_OWNER = {
  lost: leaveAll,
  battery: leaveAll,
  /* The first who comes has all that is left; who comes to help has what it searches itself. */
  takeover(owners, { robot, territory, helps }) {
    if (!helps) for (const place of leftBy(owners, territory)) place.owner = robot;
  },
  scanned(owners, { robot, place: number }) {
    const place = owners[number];
    if (!place || place.isScanned) return;
    place.isScanned = true;
    if (place.left >= 0 && validIndex(robot)) place.owner = robot;
  },
};

function passOwner(owners, event) {
  PASS_OWNER[SCANS.has(event.kind) ? "scanned" : event.kind]?.(owners, event);
}

/* Robots do not say where they go. Who searches a place that a lost robot left was on its way there since it had done
 * its last place, or since the loss. */
function takeoverBy(data, robot, left, since, owners, helps) {
  const who = robotName(data, robot), whose = robotName(data, left);
  const text = helps ? `robot ${who} helps with what robot ${whose} left` :
    `robot ${who} takes over what robot ${whose} left: ${many(leftBy(owners, left).length, "place")}`;
  return { t: since, kind: "takeover", robot, territory: left, helps, text };
}

/* By which lost robot the place was left that this event says another one scanned; -1: it is no such event. */
function leftOfScan(owners, { kind, robot, place }) {
  const left = SCANS.has(kind) && validIndex(robot) ? owners[place]?.left ?? -1 : -1;
  return left === robot ? -1 : left;
}

/* The events that say who takes over, made of those recorded, which are in the order of their times. */
function takeoversOf(data, events) {
  const owners = ownersOf(data), lostAt = [], busyUntil = [], came = [], made = [];
  for (const event of events) {
    const { robot } = event, left = leftOfScan(owners, event);
    if (left >= 0 && !came[left]?.has(robot)) {
      made.push(takeoverBy(data, robot, left, Math.max(lostAt[left], busyUntil[robot] ?? 0), owners, came[left] !== undefined));
      (came[left] ??= new Set()).add(robot);
      passOwner(owners, made.at(-1));
    }
    if (LEAVES.has(event.kind)) lostAt[robot] ??= event.t;
    if (SCANS.has(event.kind)) busyUntil[robot] = event.t;
    passOwner(owners, event);
  }
  return made;
}

/* With what follows from them, in the order of their times: of one moment a loss comes before who takes over. */
function withTakeovers(data, events) {
  const recorded = events.filter(({ kind }) => kind !== "takeover").sort(byTime);
  return [...recorded, ...takeoversOf(data, recorded)].sort(byTime);
}
