#include "cname.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* Sorted by where they come from. A name beside them that a library takes costs the user a confusing link error, so the
 * functions of the C library are here too, and what compilers define or reserve on top of the standards. */
static const char taken[] =
    /* C up to C23 */
    " auto break case char const constexpr continue default do double else enum extern false float for goto if inline"
    " int long nullptr register restrict return short signed sizeof static struct switch thread_local true typedef"
    " typeof typeof_unqual union unsigned void volatile while alignas alignof bool static_assert complex imaginary"
    " noreturn atomic"
    /* C++ up to C++26, with alternative tokens */
    " asm catch char8_t char16_t char32_t class concept consteval constinit const_cast contract_assert co_await"
    " co_return co_yield decltype delete dynamic_cast explicit export friend import module mutable namespace new"
    " noexcept operator private protected public reflexpr reinterpret_cast requires static_cast synchronized template"
    " this throw try typeid typename using virtual wchar_t atomic_cancel atomic_commit atomic_noexcept final override"
    " and and_eq bitand bitor compl not not_eq or or_eq xor xor_eq"
    /* compilers */
    " linux unix i386 sun mips vax arm near far huge interrupt fortran code data xdata idata pdata bit sbit sfr"
    /* the program's own, and namespaces */
    " main std posix"
    /* macros and objects */
    " errno assert offsetof stdin stdout stderr signal setjmp environ timezone daylight tzname NULL EOF NAN INFINITY I"
    /* <string.h>, <stdlib.h> */
    " memcpy memmove memset memcmp memchr memccpy strcpy strncpy strcat strncat strcmp strncmp strcoll strxfrm strchr"
    " strrchr strspn strcspn strpbrk strstr strtok strlen strerror strdup strndup index rindex abort abs atexit atof"
    " atoi atol atoll bsearch calloc div exit free getenv labs ldiv llabs lldiv malloc mblen mbtowc mbstowcs qsort"
    " quick_exit rand realloc srand random strtod strtof strtol strtold strtoll strtoul strtoull system wctomb"
    " wcstombs aligned_alloc alloca"
    /* <stdio.h>, <time.h>, <ctype.h>, <locale.h> */
    " remove rename tmpfile tmpnam fclose fflush fopen freopen setbuf setvbuf fprintf fscanf printf scanf snprintf"
    " sprintf sscanf vprintf vfprintf vsnprintf vsprintf fgetc fgets fputc fputs getc getchar gets putc putchar puts"
    " ungetc fread fwrite fgetpos fseek fsetpos ftell rewind clearerr feof ferror perror clock difftime mktime time"
    " asctime ctime gmtime localtime strftime isalnum isalpha isblank iscntrl isdigit isgraph islower isprint ispunct"
    " isspace isupper isxdigit tolower toupper isascii toascii localeconv setlocale raise longjmp"
    /* <math.h>, <complex.h> */
    " acos asin atan atan2 cos sin tan acosh asinh atanh cosh sinh tanh exp exp2 expm1 exp10 frexp ilogb ldexp log"
    " log10 log1p log2 logb modf scalbn scalbln cbrt fabs hypot pow pow10 sqrt erf erfc lgamma tgamma gamma ceil floor"
    " nearbyint rint lrint llrint round lround llround trunc fmod remainder remquo copysign nan nextafter nexttoward"
    " fdim fmax fmin fma j0 j1 jn y0 y1 yn significand drem scalb signbit isnan isinf isfinite isnormal finite conj"
    " creal cimag carg cproj cabs cexp clog cpow csqrt ccos csin ctan cacos casin catan ccosh csinh ctanh sincos"
    /* POSIX: what firmware on an operating system links */
    " read write open close pipe fork wait kill link unlink access dup sleep pause alarm select poll socket bind listen"
    " accept connect send recv shutdown stat mkdir chdir sync ";

static bool is_listed(const char *word, size_t length) {
  for (const char *at = taken; (at = strchr(at, ' ')) != NULL && at[1] != '\0';) {
    at++;
    if (strcspn(at, " ") == length && memcmp(at, word, length) == 0) return true;
  }
  return false;
}

static bool ends_in(const char *name, size_t length, const char *tail) {
  const size_t size = strlen(tail);
  return length > size && memcmp(name + length - size, tail, size) == 0;
}

/* In <math.h> every function comes with an f and an l behind it too. The ends are those of types and limits. */
static bool is_taken(const char *name, size_t length) {
  static const char *const ends[] = {"_t", "_MIN", "_MAX", "_C", "_WIDTH"};
  if (is_listed(name, length)) return true;
  if (length > 1 && (name[length - 1] == 'f' || name[length - 1] == 'l') && is_listed(name, length - 1)) return true;
  for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++)
    if (ends_in(name, length, ends[i])) return true;
  return false;
}

static bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static bool is_letter_or_digit(char c) {
  return is_letter(c) || (c >= '0' && c <= '9');
}

/* Two underscores in a row are C++'s own wherever they stand, and one at the start is C's. */
void cname_of_path(char name[CNAME_SIZE], const char *path) {
  static const char tail[] = "_policy";
  const char *slash = strrchr(path, '/');
  const char *from = slash != NULL ? slash + 1 : path;
  size_t length = 0;
  if (!is_letter(*from)) name[length++] = 'p';
  for (; *from != '\0' && *from != '.' && length + sizeof tail < CNAME_SIZE; from++) {
    if (is_letter_or_digit(*from))
      name[length++] = *from;
    else if (name[length - 1] != '_')
      name[length++] = '_';
  }
  if (name[length - 1] == '_') length--;
  name[length] = '\0';
  if (is_taken(name, length)) strcpy(name + length, tail);
}
