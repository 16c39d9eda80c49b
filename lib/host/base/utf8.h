/* Bytes that claim to be text. Names from files may hold anything. */
#ifndef QUARTER_HOST_UTF8_H
#define QUARTER_HOST_UTF8_H

/* What stands for a byte that is no character. */
#define UTF8_REPLACEMENT "\xEF\xBF\xBD"

/* Bytes of the UTF-8 character at `text`, 1..4; 0 if it is none: cut short, longer than need be, or half of a pair. */
int utf8_length(const char *text);

#endif
