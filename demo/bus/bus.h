/* The bus between world, robots and viewers: LCM behind a plain interface. bus.c is the only file that includes LCM.
 *
 * LCM drops silently: drain the queue every tick, and repeat what must arrive. On "memq://" everything stays in this
 * process, in the order in which it was sent, and nothing is ever lost unless bus_lose() asks for it.
 */
#ifndef QUARTER_DEMO_BUS_H
#define QUARTER_DEMO_BUS_H

#include <stdint.h>

#include "host/base/fault.h"
#include "messages.h"
#include "seal.h"

#define BUS_IN_PROCESS "memq://"

typedef struct bus bus;

/* What became of the messages so far. */
typedef struct {
  uint64_t sent[KINDS];
  uint64_t lost;     /* of termination signals, by bus_lose() */
  uint64_t ignored;  /* did not decode, were out of range, or are counted below */
  uint64_t unsealed; /* termination signals without this bus's seal */
} bus_counts;

/* Open the bus at an LCM URL; NULL: LCM_DEFAULT_URL, or LCM's own default with ttl=0. 0, or -1 with *why set. */
int bus_open(bus **b, const char *url, fault *why);
void bus_close(bus *b);

/* The same, sealed by the key in a file if `key` names one (seal_read()). */
int bus_open_sealed(bus **b, const char *url, const char *key, fault *why);

/* From now on seal all termination signals that are sent, and hear none that are not so sealed. */
void bus_seal(bus *b, const seal *s);

/* Write all that passes to an LCM log, at the world's times, until bus_end_log(). `path` must last until then. 0, or -1
 * with *why set. */
int bus_record(bus *b, const char *path, fault *why);

/* Some of it could not be written: bus_end_log() will say why, and it is better to end now than to play in vain. */
bool bus_log_failed(const bus *b);

/* End the log, if there is one: all of it is on the disk. 0, or -1 with *why set and the file, if it is one,
 * removed. */
int bus_end_log(bus *b, fault *why);

/* Lose this share of the termination signals on their way to each receiver, at random. */
void bus_lose(bus *b, double share, uint64_t seed);

void bus_send_pose(bus *b, const message_pose *m);
void bus_send_scan(bus *b, const message_scan *m);
void bus_send_command(bus *b, const message_command *m);
void bus_send_terminate(bus *b, const message_terminate *m);
void bus_send_status(bus *b, const message_status *m);

/* Call `hear` for every such message from now on; of a robot's channels, for the robot of that number alone. */
void bus_hear_pose(bus *b, int robot, void (*hear)(void *user, const message_pose *m), void *user);
void bus_hear_scan(bus *b, int robot, void (*hear)(void *user, const message_scan *m), void *user);
void bus_hear_command(bus *b, int robot, void (*hear)(void *user, const message_command *m), void *user);
void bus_hear_terminate(bus *b, void (*hear)(void *user, const message_terminate *m), void *user);
void bus_hear_status(bus *b, void (*hear)(void *user, const message_status *m), void *user);

/* Handle what waits, some thousand messages at most. Returns how many that were, or -1 if the bus is broken. */
int bus_drain(bus *b);

/* Wait up to `milliseconds` for a message and handle it. True if one came. */
bool bus_wait(bus *b, int milliseconds);

bus_counts bus_count(const bus *b);

#endif
