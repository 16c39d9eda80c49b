/* The termination protocol: how robots that share nothing but two signals over a lossy broadcast come to a stop.
 *
 * A territory is scanned in one step: one scanned in part is known to nobody but the robot that walks it, so the others
 * see no difference. No copy is ever under way: one that arrives late is one that was said late, by a robot that died
 * late. README.md beside this file says what is proven of the model, and how.
 *
 * Settings:
 *   N          robots, and territories: 2, 3 or 4
 *   CLEAR_ALL  a find stops nobody; without it the first find ends the mission
 *   LATE       so many robots, the first ones, walk as slowly as they like, or never again; they still hear and say
 *   MISSED     part of one territory is out of robot 0's reach; the target may be there
 *   SHUT       part of one territory is behind a door, which is open or shut whenever somebody comes; so may the target be
 *   RESETS     power cuts at most, of any robot at any moment: it goes on with any part of what it knew, for its save is
 *              older than the cut, or with nothing, for it is torn
 *   MIXED      robot 0 plays another division: what it calls territory t the others call t + 1
 *   NO_DEATHS  every robot stays alive
 *   ENDS       a robot that stands has come to its end, and fate some time too: then there is a last state
 * Mutations, each a way to get it wrong:
 *   ONCE       a signal is said once, not again and again
 *   NO_RELAY   what was only heard is not passed on
 *   SILENT     a robot that has stopped says nothing more
 *   EARLY      a territory may be announced before it is scanned
 *   STALE      a robot drives to the target that it read when it set out, scans there, and then counts as visited
 *              whatever its seeker's target is by then
 *   GO_ON      the finder broadcasts FOUND and counts the place as visited, so that it goes on
 *   WAIT       a robot whose own territory is done waits to hear of the others
 *   BELIEVE    a signal counts whatever division it is of
 *   RECLEAR    after a power cut the places scanned are taken for cleared ones, which makes another division
 *   AHEAD      after a power cut the territory that the robot was in counts as scanned
 *   MUTE       what was known before a power cut is not said again
 *   WAVE       a place behind a shut door counts as scanned
 *   INSIST     a place behind a shut door is tried for ever
 */
#ifndef N
#define N 3
#endif
#ifndef LATE
#define LATE 0
#endif
#ifndef RESETS
#define RESETS 0
#endif
#if defined(MISSED) || defined(SHUT)
#define BARRED
#endif
#if defined(MIXED) || defined(RECLEAR)
#define DIVIDED_OTHERWISE
#endif

/* A signal is one bit; what a robot knows is a set of them. */
#define TERRITORY_DONE(territory) (1 << (territory))
#define FOUND                     (1 << N)
#define ALL_DONE                  (FOUND - 1)
#define NOWHERE                   N

#if N == 2
#define over_all(join, what, by) (what(0, by) join what(1, by))
#elif N == 3
#define over_all(join, what, by) (what(0, by) join what(1, by) join what(2, by))
#else
#define over_all(join, what, by) (what(0, by) join what(1, by) join what(2, by) join what(3, by))
#endif

byte target = NOWHERE; /* the territory that holds it, if there is a target */
byte known[N];         /* by each robot: FOUND, and TERRITORY_DONE of all in its `done`. The dead want no news: all */
bool alive[N] = true;
byte deaths;
#ifdef ONCE
byte said[N];
#endif
#ifdef NO_RELAY
byte own[N]; /* what a robot knows from its own scans */
#endif
#ifdef GO_ON
byte voiced[N]; /* what it says and does not heed */
#endif
#ifdef MUTE
byte muted[N];
#endif
#if RESETS > 0
byte resets;
#endif

/* The truth, which no robot reads. Territories are numbered as by robots that play the right division. */
byte scanned; /* territories scanned from end to end by one robot, by their TERRITORY_DONE */
bool found;   /* some robot has stood before the target */
bool lost;    /* in the last step a copy was lost that would have been news */

#ifdef DIVIDED_OTHERWISE
bool odd[N]; /* plays the other division */
#define shift(i) odd[i]
#else
#define shift(i) 0
#endif

#ifdef BARRED
byte barred;   /* the territory of which a part cannot always be scanned */
bool behind;   /* the target is in that part, if it is in that territory */
byte tries[N]; /* how often a robot found no way in: once, and once more on its last round */
#define tried(i)     tries[i]
#define is_barred(t) ((t) == barred)
#define is_behind    behind
#else
#define tried(i)     0
#define is_barred(t) false
#define is_behind    false
#endif
#ifdef MISSED
#define may_shut(i) ((i) == 0)
#define may_open(i) ((i) != 0)
#else
#define may_shut(i) true
#define may_open(i) true
#endif

hidden byte word, other, there, next; /* scratch within a step */

#define knows(i, s) ((known[i] & (s)) != 0)

/* ---- what the seeker does: where it goes follows from what it knows, as in settle() of lib/robot/seeker.c ---- */

#define unknown(i)     (ALL_DONE & ~known[i])
#ifdef BARRED
#define here_barred(i) TERRITORY_DONE((barred + N - shift(i)) % N)
#define untried(i)     (unknown(i) & ~((tried(i) > 0) * here_barred(i)))
#ifdef INSIST
#define once_more(i)   unknown(i)
#else
#define once_more(i)   ((tried(i) < 2) * unknown(i))
#endif
#define to_walk(i)     (untried(i) | (untried(i) == 0) * once_more(i))
#else
#define to_walk(i)     unknown(i)
#endif
#define stopped(i)     (knows(i, FOUND) || to_walk(i) == 0)
#define walking(i)     (alive[i] && !stopped(i))

/* The own territory, then the others in any order: by the passes, or those of robots that it takes for lost first. */
#define has_own(i)     ((to_walk(i) & TERRITORY_DONE(i)) != 0)
#define may_walk(i, t) ((to_walk(i) & TERRITORY_DONE(t)) != 0 && ((t) == (i) || !has_own(i)))

inline choose(i, territory) {
  if
  :: may_walk(i, 0) -> territory = 0
  :: may_walk(i, 1) -> territory = 1
#if N > 2
  :: may_walk(i, 2) -> territory = 2
#endif
#if N > 3
  :: may_walk(i, 3) -> territory = 3
#endif
  fi
}

inline learn(i, what) {
#ifdef NO_RELAY
  own[i] = own[i] | (what);
#endif
  known[i] = known[i] | (what)
}

/* The target is before robot i, in its territory `here`. */
inline find(i, here) {
  found = true;
#if defined(CLEAR_ALL)
  learn(i, TERRITORY_DONE(here))
#elif defined(GO_ON)
  voiced[i] = voiced[i] | FOUND;
  learn(i, TERRITORY_DONE(here))
#else
  learn(i, FOUND)
#endif
}

/* Robot i comes to the end of a territory, or to the target in it, and takes the territory `here` for scanned. */
inline scan_whole(i, here) {
#if !defined(CLEAR_ALL) && !defined(GO_ON)
  scanned = scanned | ((there != target) * TERRITORY_DONE(there));
#else
  scanned = scanned | TERRITORY_DONE(there);
#endif
  if
  :: there == target -> find(i, here)
  :: else -> learn(i, TERRITORY_DONE(here))
  fi
}

#ifdef BARRED
/* It finds no way to a part of its territory `here`. */
inline scan_part(i, here) {
  if
#ifndef CLEAR_ALL
  :: there == target && !behind -> find(i, here)
#endif
  :: else ->
#ifdef WAVE
     learn(i, TERRITORY_DONE(here))
#else
     tries[i] = (tries[i] < 2 -> tries[i] + 1 : 2)
#endif
  fi
}
#endif

/* Robot i scans its territory `from`, and counts it as `here`. */
inline scan(i, from, here) {
  there = (from + shift(i)) % N;
#ifdef BARRED
  if
  :: is_barred(there) && may_shut(i) -> scan_part(i, here)
  :: !is_barred(there) || may_open(i) -> scan_whole(i, here)
  fi
#else
  scan_whole(i, here)
#endif
}

/* ---- a robot: it walks, and it says what it knows ---- */

#ifdef WAIT
#define on_the_way(i) !knows(i, TERRITORY_DONE(i))
#else
#define on_the_way(i) true
#endif

proctype walk(byte i) {
#ifdef STALE
  byte from;
  do
  :: atomic { walking(i) -> choose(i, from) }
     if
     :: atomic { walking(i) -> lost = false; choose(i, next); scan(i, from, next); from = 0 }
     :: !walking(i) -> break
     fi
  :: !walking(i) -> break
  od
#else
#ifndef ENDS
end:
#endif
  do
  :: atomic { walking(i) && on_the_way(i) -> lost = false; choose(i, next); scan(i, next, next) }
  :: atomic { walking(i) && i < LATE -> lost = false }
#ifdef EARLY
  :: atomic { walking(i) -> lost = false; choose(i, next); known[i] = known[i] | TERRITORY_DONE(next) }
#endif
#ifdef ENDS
  :: !walking(i) -> break
#endif
  od
#endif
}

#if defined(ONCE)
#define to_say(i) (known[i] & ~said[i])
#elif defined(NO_RELAY)
#define to_say(i) own[i]
#elif defined(SILENT)
#define to_say(i) (known[i] * !stopped(i))
#elif defined(GO_ON)
#define to_say(i) (known[i] | voiced[i])
#elif defined(MUTE)
#define to_say(i) (known[i] & ~muted[i])
#else
#define to_say(i) known[i]
#endif

/* Of another division, and so ignored. */
#if defined(DIVIDED_OTHERWISE) && !defined(BELIEVE)
#define foreign(i, by) (odd[i] != odd[by])
#else
#define foreign(i, by) false
#endif

/* A copy of what its hearer knows, or does not believe, changes nothing, so only news is ever said. */
#define deaf_to(i, by)  (known[i] | foreign(i, by) * (FOUND | ALL_DONE))
#define is_news(i, s)   (alive[i] && (to_say(i) & ~over_all(&, deaf_to, i) & (s)) != 0)
#define has_news(i, by) ((~deaf_to(i, by) & word) != 0)

proctype say(byte i) {
end:
  do
  :: atomic {
       if
       :: is_news(i, FOUND) -> word = FOUND
       :: is_news(i, TERRITORY_DONE(0)) -> word = TERRITORY_DONE(0)
       :: is_news(i, TERRITORY_DONE(1)) -> word = TERRITORY_DONE(1)
#if N > 2
       :: is_news(i, TERRITORY_DONE(2)) -> word = TERRITORY_DONE(2)
#endif
#if N > 3
       :: is_news(i, TERRITORY_DONE(3)) -> word = TERRITORY_DONE(3)
#endif
       fi;
#ifdef ONCE
       said[i] = said[i] | word;
#endif
       lost = false;
       other = 0;
       do /* each copy is heard or lost, independently of all others */
       :: other < N && !has_news(other, i) -> other++
       :: other < N && has_news(other, i) -> known[other] = known[other] | word; other++
       :: other < N && has_news(other, i) -> lost = true; other++
       :: other == N -> break
       od
     }
  od
}

/* ---- the world ---- */

inline die(i) {
  alive[i] = false;
  known[i] = FOUND | ALL_DONE;
  deaths++;
  lost = false
}

#if RESETS > 0
/* Any part of what robot i knew is left to it. */
inline remember(i) {
  word = 0;
  other = 0;
  do
  :: other <= N && knows(i, 1 << other) -> word = word | (1 << other); other++
  :: other <= N -> other++
  :: other > N -> break
  od;
  known[i] = word
}

inline cut_power(i) {
#ifdef AHEAD
  next = NOWHERE;
  if
  :: walking(i) -> choose(i, next)
  :: else
  fi;
#endif
#ifdef RECLEAR
  known[i] = 0;
  odd[i] = true;
#else
  remember(i);
#endif
#ifdef AHEAD
  if
  :: next != NOWHERE -> known[i] = known[i] | TERRITORY_DONE(next)
  :: else
  fi;
#endif
#ifdef MUTE
  muted[i] = known[i];
#endif
#ifdef BARRED
  if
  :: tries[i] = 0
  :: tries[i] > 0 -> tries[i] = 1
  fi;
#endif
  resets++;
  lost = false
}
#endif

proctype fate() {
  do
#ifndef NO_DEATHS
  :: atomic {
       deaths < N - 1 ->
       if
       :: alive[0] -> die(0)
       :: alive[1] -> die(1)
#if N > 2
       :: alive[2] -> die(2)
#endif
#if N > 3
       :: alive[3] -> die(3)
#endif
       fi
     }
#endif
#if RESETS > 0
  :: atomic {
       resets < RESETS ->
       if
       :: alive[0] -> cut_power(0)
       :: alive[1] -> cut_power(1)
#if N > 2
       :: alive[2] -> cut_power(2)
#endif
#if N > 3
       :: alive[3] -> cut_power(3)
#endif
       fi
     }
#endif
#ifdef ENDS
  :: break
#else
  :: lost = false /* or fairness would kill N - 1 robots in every run */
#endif
  od
}

init {
  atomic {
    select(target : 0 .. N); /* N: NOWHERE */
#ifdef BARRED
    select(barred : 0 .. N - 1);
    if
    :: target == barred -> behind = true
    :: behind = false
    fi;
#endif
#ifdef MIXED
    odd[0] = true;
#endif
    run walk(0); run say(0);
    run walk(1); run say(1);
#if N > 2
    run walk(2); run say(2);
#endif
#if N > 3
    run walk(3); run say(3);
#endif
    run fate()
  }
}

/* ---- safety ---- */

#ifdef DIVIDED_OTHERWISE
#define turned(s) ((((s) << 1) | ((s) >> (N - 1))) & ALL_DONE)
#define means(i)  ((known[i] & FOUND) | odd[i] * turned(known[i] & ALL_DONE) | !odd[i] * (known[i] & ALL_DONE))
#else
#define means(i)  known[i] /* in truth */
#endif
#define ended(i)  (alive[i] && stopped(i))
#define truth     (scanned | found * FOUND)

#define knows_truly(i, by) (!alive[i] || (means(i) & ~truth) == 0)
ltl sound { [] over_all(&&, knows_truly, 0) }

#ifdef CLEAR_ALL
#define enough(set) ((set) == ALL_DONE)
#else
#define enough(set) (found || (set) == ALL_DONE)
#endif
#ifdef BARRED
#define barred_to(i) (may_shut(i) * TERRITORY_DONE(barred))
#else
#define barred_to(i) 0
#endif
#define ends_rightly(i, by)  (!ended(i) || enough(scanned))
#define ends_in_reach(i, by) (!ended(i) || enough(scanned | barred_to(i)))
#define ends_patient(i, by)  (!ended(i) || enough(scanned) || tried(i) == 2)
ltl ends { [] over_all(&&, ends_rightly, 0) }
ltl reach { [] over_all(&&, ends_in_reach, 0) }
ltl patient { [] over_all(&&, ends_patient, 0) }

/* Find-first, and there is a target: its territory is known done to nobody, and who stops knows FOUND. */
#define target_open(i, by) (!alive[i] || (means(i) & TERRITORY_DONE(target)) == 0)
#define ends_found(i, by)  (!ended(i) || knows(i, FOUND))
ltl target_kept { [] (target == NOWHERE || over_all(&&, target_open, 0)) }
ltl all_clear { [] (target == NOWHERE || over_all(&&, ends_found, 0)) }

/* ---- liveness, under weak fairness of each process ---- */

/* Who has stopped stays so; but a power cut may start it again. */
#if RESETS > 0
#define in_the_end <>[]
#else
#define in_the_end <>
#endif

/* Whatever is lost: if all who stay alive walk on, all who stay alive stop. */
#define at_rest(i, by) (!walking(i))
#define all_stopped    over_all(&&, at_rest, 0)
ltl walkers_stop { in_the_end all_stopped }

/* Whoever walks or not: if a robot that stays alive knows that it is over, and losses of news end some time, all stop.
 * News is heard finitely often, so losses without end are those that never let some repeated signal through. */
#define held(i, by) (alive[i] * known[i])
#define heads       over_all(|, held, 0)
#define over        ((heads & FOUND) != 0 || (heads & ALL_DONE) == ALL_DONE)
ltl told_stop { (<>[] (over && !lost)) -> in_the_end all_stopped }
ltl told_stop_all_lost { (<>[] over) -> in_the_end all_stopped }

/* Only the first LATE robots stand still: if another one stays alive, all stop. */
#define walker(i, by) (alive[i] && i >= LATE)
ltl late_stop { (<>[] (over_all(||, walker, 0) && !lost)) -> in_the_end all_stopped }

/* ---- what must be possible, or the above would say nothing: each is to be refuted ---- */

ltl never_told { !(<> (over && lost && !all_stopped) && <>[] (over && !lost)) }
ltl never_late { !(<> (lost && walking(0)) && <>[] (over_all(||, walker, 0) && !lost)) }
ltl never_stop { [] !(lost && deaths == 0 && <> (deaths == 0 && all_stopped)) }
ltl never_again { [] !(found && (heads & FOUND) == 0 && <> ((heads & FOUND) != 0)) }
#ifdef BARRED
#define had_tried(i, by) (tried(i) > 0)
ltl never_retried { [] !((scanned & TERRITORY_DONE(barred)) != 0 && over_all(&&, had_tried, 0)) }
#endif
