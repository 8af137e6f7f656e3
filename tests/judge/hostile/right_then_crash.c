/* Answers right, then reads what it must not. Expect: RTE */
#include <stdio.h>

int main(void) {
    for (int c; (c = getchar()) != EOF;) putchar(c);
    fflush(stdout);
    return *(volatile int *)8;
}
