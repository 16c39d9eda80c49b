/* A program on an AVR as simavr takes it: what it prints goes out by the first UART, and at its end it sleeps for
 * good. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <stdio.h>

static int send(char byte, FILE *stream) {
  (void)stream;
  while ((UCSR0A & (1u << UDRE0)) == 0) {}
  UDR0 = (uint8_t)byte;
  return 0;
}

static FILE uart = FDEV_SETUP_STREAM(send, NULL, _FDEV_SETUP_WRITE);

__attribute__((constructor)) static void begin(void) {
  UCSR0B = 1u << TXEN0;
  stdout = &uart;
}

__attribute__((destructor)) static void end(void) {
  cli();
  sleep_enable();
  sleep_cpu();
}
