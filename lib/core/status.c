#include "quarter/status.h"

/* In the order of the codes, from QTR_OK downwards. */
static const char *const texts[] = {"success",
                                    "built under other array sizes than the caller",
                                    "an argument is out of its range",
                                    "more cells, places, seekers or travel time than this build holds",
                                    "the output buffer is too small",
                                    "the table is cut short",
                                    "not a Quarter policy table",
                                    "a table format that this build does not read",
                                    "the table's checksum does not match its bytes",
                                    "the table holds an offset, index or value out of its range",
                                    "the table was written by a build that plays the game otherwise",
                                    "the mission has no seeker",
                                    "the mission has no place",
                                    "a start is off the map or on an obstacle",
                                    "a place is off the map, on an obstacle, or on another place's cell",
                                    "a weight is not a finite number above 0",
                                    "a place cannot be reached by any seeker",
                                    "the discount leaves next to nothing of even the nearest place",
                                    "the table's travel times contradict one another, or leave a place out of reach",
                                    "the table's value, bound and gap are no numbers, or contradict one another",
                                    "stopped before the work was done",
                                    "the save is torn, or of another robot or table",
                                    "a class of robots is out of its ranges",
                                    "a place's looks or detection are out of their ranges",
                                    "no seeker can search any place in the time that there is"};

uint32_t qtr_version(void) {
  return QTR_VERSION;
}

/* A code of a later version, or a count that was taken for one, is no index. */
const char *qtr_strerror(int status) {
  const int count = (int)(sizeof texts / sizeof(texts[0]));
  return ((status <= 0) && (status > -count)) ? texts[-status] : "unknown status";
}
