/* Answers right, then reads from an invalid address. Expect: RTE */
#include <stdio.h>

int main(void) {
    for (int c; (c = getchar()) != EOF;) putchar(c);
    fflush(stdout);
    return *(volatile int *)8;
}
