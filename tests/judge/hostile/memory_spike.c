/* Fills memory and ends at once. Expect: MLE */
#include <stdio.h>
#include <stdlib.h>

int main(void) {
    for (int c; (c = getchar()) != EOF;) putchar(c);
    volatile char *filler = malloc(600 << 20);
    for (int at = 0; at < 600 << 20; at += 4096) filler[at] = 1;
}
