/* Loaded into another program, this takes over the user's locale before main, as a toolkit for windows
 * does; where that locale has no decimal comma, the program ends. */
#include <locale.h>
#include <stdlib.h>

__attribute__((constructor)) static void take_over(void) {
  if (setlocale(LC_ALL, "") == NULL || localeconv()->decimal_point[0] != ',') exit(77);
}
