/* Every reader on every prefix of a valid file and on thousands of damaged ones: it reads, or says why not in one line.
 * Under a sanitizer this also shows that nothing is read or written where it should not be, and nothing leaks. */
#include "support/random.h"
#include "support/reader_scratch.h"

#define YAML                                                                                                           \
  "image: m.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\nmode: "    \
  "trinary\n"
#define MISSION                                                                                                        \
  "name: trial\nmap: m.yaml\ncell_size: 1.0\nrobot_radius: 0.1\nunknown: free\nrobots:\n  - {x: -0.5, y: 2.5}\n"       \
  "places: [{column: 1, row: 1, weight: 2e0}]\nplaces_csv: p.csv\nobjective: time\ngamma: 0.9\nrule: paper\n"
#define CSV "x,y,weight\r\n1.5, 3.5,\"3\"\r\n"
#define PGM "P5\n# made by hand\n6 6\n255\n"
#define PLAIN "P2\n# made by hand\n2 2 # small\n65535\n1 2\n# half\n65535 0\n"
#define DRAWING "; a drawing\nS.#~\n.19.\n"
#define MOVINGAI "type octile\nheight 2\nwidth 3\nmap\n.G@\nSTW\n"

typedef struct {
  const char *name;  /* of the file that is damaged */
  const char *input; /* what is read then */
  const char *text;
  size_t size;
} sample;

static char binary[sizeof PGM - 1 + 36];

static const sample samples[] = {
    {"d.txt", "d.txt", DRAWING, sizeof DRAWING - 1}, {"a.map", "a.yaml", MOVINGAI, sizeof MOVINGAI - 1},
    {"m.pgm", "m.mission", binary, sizeof binary},   {"q.pgm", "q.yaml", PLAIN, sizeof PLAIN - 1},
    {"m.yaml", "m.mission", YAML, sizeof YAML - 1},  {"m.mission", "m.mission", MISSION, sizeof MISSION - 1},
    {"p.csv", "m.mission", CSV, sizeof CSV - 1}};
#define SAMPLES (int)(sizeof samples / sizeof *samples)

void setUp(void) {
  memset(binary, 255, sizeof binary);
  memcpy(binary, PGM, sizeof PGM - 1);
  scratch_open();
  for (int i = 0; i < SAMPLES; i++) scratch_write_bytes(samples[i].name, samples[i].text, samples[i].size);
  scratch_write("a.yaml", "map: a.map\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 0}]\n");
  scratch_write("q.yaml",
                "image: q.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.1\n");
}

void tearDown(void) {
  scratch_close();
}

/* One line, or one for each of several places, every one of which names a file and the mend. */
static void expect_lines(const char *message) {
  for (const char *line = scratch_fault.text; line != NULL;) {
    const size_t length = strcspn(line, "\n");
    TEST_ASSERT_NOT_NULL_MESSAGE(memchr(line, ':', length), message);
    TEST_ASSERT_NOT_NULL_MESSAGE(memchr(line, ';', length), message);
    line = line[length] == '\n' ? line + length + 1 : NULL;
  }
}

/* Read, and hold what it says to the rules whichever way it goes. */
static bool read_damaged(const sample *sample, const char *message) {
  scratch_fault.text[0] = '\0';
  int result = input_read(&scratch_input, scratch_path(sample->input), &scratch_options, &scratch_fault);
  if (result != 0) {
    TEST_ASSERT_EQUAL_INT_MESSAGE(-1, result, message);
    TEST_ASSERT_NOT_NULL_MESSAGE(strchr(scratch_fault.text, ':'), message);
    TEST_ASSERT_NOT_NULL_MESSAGE(strchr(scratch_fault.text, ';'), scratch_fault.text);
    expect_lines(message);
    return false;
  }
  const qtr_mission *mission = &scratch_input.mission;
  int cells = mission->columns * mission->rows;
  TEST_ASSERT_TRUE_MESSAGE(cells >= 1 && cells <= QTR_MAX_CELLS && mission->places >= 1 && mission->seekers >= 1,
                           message);
  for (int i = 0; i < mission->places; i++) {
    TEST_ASSERT_TRUE_MESSAGE((int)mission->place[i] < cells && mission->cost[mission->place[i]] != 0, message);
    TEST_ASSERT_TRUE_MESSAGE(mission->weight[i] > 0.0, message);
  }
  for (int i = 0; i < mission->seekers; i++) {
    TEST_ASSERT_TRUE_MESSAGE((int)mission->start[i] < cells && mission->cost[mission->start[i]] != 0, message);
  }
  return true;
}

static void test_whole_files_read(void) {
  for (int i = 0; i < SAMPLES; i++) {
    bool reads = read_damaged(&samples[i], samples[i].name);
    if (strcmp(samples[i].input, "q.yaml") == 0) { /* a map alone: refused once it is read */
      scratch_expect_text("without robots and places");
    } else {
      TEST_ASSERT_TRUE_MESSAGE(reads, scratch_fault.text);
    }
  }
}

static void test_every_prefix_reads_or_says_why_not(void) {
  for (int i = 0; i < SAMPLES; i++) {
    for (size_t size = 0; size < samples[i].size; size++) {
      char message[80];
      snprintf(message, sizeof message, "%s cut to %zu bytes", samples[i].name, size);
      scratch_write_bytes(samples[i].name, samples[i].text, size);
      read_damaged(&samples[i], message);
    }
    scratch_write_bytes(samples[i].name, samples[i].text, samples[i].size);
  }
}

static void test_binary_images_need_every_byte(void) {
  for (size_t size = 0; size < sizeof binary; size++) {
    scratch_write_bytes("m.pgm", binary, size);
    TEST_ASSERT_FALSE(read_damaged(&samples[2], "m.pgm"));
    scratch_expect_text("m.pgm");
  }
}

/* One to four bytes changed, and now and then one left out or doubled. */
static size_t damage(char *to, const sample *sample, test_random *random) {
  static const char likely[] = "0123456789-.:,;#[]{}&*!|>'\"%@`\n\r\t \\ePSx";
  size_t size = sample->size;
  memcpy(to, sample->text, size);
  for (unsigned n = 1 + random_below(random, 4); n > 0; n--) {
    size_t at = random_below(random, (unsigned)size);
    bool any = random_chance(random, 50);
    to[at] = any ? (char)random_below(random, 256) : likely[random_below(random, sizeof likely - 1)];
  }
  size_t at = random_below(random, (unsigned)size);
  unsigned chance = random_below(random, 8);
  if (chance == 0) memmove(to + at, to + at + 1, --size - at);
  if (chance == 1) memmove(to + at + 1, to + at, size++ - at);
  return size;
}

static void test_random_damage_reads_or_says_why_not(void) {
  static char damaged[1024];
  for (int i = 0; i < SAMPLES; i++) {
    for (unsigned seed = 1; seed <= 1500; seed++) {
      test_random random = random_case(samples[i].name, seed);
      scratch_write_bytes(samples[i].name, damaged, damage(damaged, &samples[i], &random));
      read_damaged(&samples[i], case_note);
    }
    scratch_write_bytes(samples[i].name, samples[i].text, samples[i].size);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_whole_files_read);
  RUN_TEST(test_every_prefix_reads_or_says_why_not);
  RUN_TEST(test_binary_images_need_every_byte);
  RUN_TEST(test_random_damage_reads_or_says_why_not);
  return UNITY_END();
}
